"""The fields and the messages that a statement is about: those that stand beside it, above it, or in the headings."""

from collections.abc import Callable, Iterable

from codegen.claims.parts.sentence import NamedField
from codegen.claims.parts.span import Span, Topic
from codegen.claims.reading import Reading
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.once import once
from codegen.pattern import pattern

_FAR = 2000
"""The greatest distance back in a passage to the message of a statement, in characters."""


@dataclass(frozen=True, slots=True)
class About:
    """A field that a statement is about: the nearest message that has it, and others that it may be meant of."""

    message: WireMessage
    field: WireField
    others: tuple[WireField, ...]
    is_sure: bool

    @property
    def name(self) -> str:
        """``MESSAGE.field``."""
        return f"{self.message.name}.{self.field.name}"

    def is_wrong(self, fits: Callable[[WireField], bool]) -> bool:
        """Return whether something is true of none of the fields that may be meant."""
        return not fits(self.field) and not any(fits(other) for other in self.others)


_OF = pattern(r"\)?\s*(?:field )?(?:of|in|from|inside) (?:the |a |an )?(?P<message>M)\b")


def about(reading: Reading, span: Span, offset: int) -> About | None:
    """The field whose name stands at an offset; none of a message that the sentence only tells it apart from.

    A span is of one reading, and every check asks about its names.
    """
    known = _known(span)
    if offset not in known:
        known[offset] = _found(reading, span, offset)
    return known[offset]


@once
def _known(_: Span) -> dict[int, About | None]:
    """The findings at offsets of a span."""
    return {}


def _found(reading: Reading, span: Span, offset: int) -> About | None:
    found = _meant(reading, span, offset)
    if found is not None and _told_apart(span):
        low, high = span.bounds(offset)
        apart = [at for at in _told_apart(span) if low <= at < high]
        if any(str(span.sentence.term(at).value) == found.message.name for at in apart):
            return None
    return found


_TOLD_APART = pattern(
    r"\b(?:unlike|in contrast to|as opposed to|other than)(?: in)? (?:the )?(?:fields? |ones? |those |that )?"
    r"(?:of the same names? |with the same names? |so called )?(?:(?:in|of|from) (?:the )?)?M\b",
    needs="unlike|in contrast to|as opposed to|other than",
)


@once
def _told_apart(span: Span) -> tuple[int, ...]:
    """The messages that a text tells others apart from: "floats here, unlike those in NAME"."""
    return tuple(found.end() - 1 for found in _TOLD_APART.finditer(span.text))


def _meant(reading: Reading, span: Span, offset: int) -> About | None:
    """The field whose name stands at an offset, of the message that is meant."""
    value = span.sentence.term(offset).value
    assert isinstance(value, NamedField)
    if value.message is not None:
        return _about(value.name, [reading.messages[value.message]], [], is_sure=True)
    of = _OF.match(span.text, offset + 1)
    if of is not None:
        return _about(
            value.name, [reading.messages[str(span.sentence.term(of.start("message")).value)]], [], is_sure=True
        )
    low, high = span.bounds(offset)
    if _is_of_unknown(span, low, offset):
        return None
    before = [reading.messages[name] for at, name in span.named(low, high) if at < offset][::-1]
    after = [
        reading.messages[name]
        for at, name in span.named(low, high)
        if at > offset
        and not (_ITSELF.match(span.text, at) and pattern(r"[,;:] ?[a-z ]*$").search(span.text[offset + 1 : at]))
    ]
    if found := _about(value.name, before, [], is_sure=True):
        return found
    if span.text[offset] == "P" and not span.is_code and any(span.sentence.within(low, offset, "MC")):
        return None  # "in NAME the altitude is ..." is said of that message, however it calls it
    inside = [reading.messages[name] for at, name in span.named(max(low - _FAR, 0), low)][::-1]
    if after and not inside and (found := _about(value.name, [*after], [*span.topic.headings], is_sure=True)):
        return found
    if found := _about(value.name, inside, inside, is_sure=True):
        return found
    topic = _around(span, offset, is_named=bool(before or inside))
    near = [*topic.above, *topic.headings, *after] if not span.is_code else [*topic.above, *topic.headings]
    others = near if span.is_code else [*near, *topic.earlier]
    is_item = span.kind is PassageKind.ITEM and len(topic.above) == 1 and not span.is_code
    is_item = is_item and (not topic.headings or topic.above[0] in topic.headings)
    first = topic.above[:1] if span.is_code or is_item else ()
    if found := _about(value.name, [*first, *topic.headings[:1], *near], [] if first else others, is_sure=True):
        return found
    holders = sum(message.field(value.name) is not None for message in topic.document)
    is_only = holders == 1 and not span.is_code
    if span.is_code and "_" not in value.name and not topic.earlier and len(topic.document) > 1:
        return None  # a plain word, "id" or "load", is as likely a member of somebody's own type
    return _about(value.name, [*topic.earlier, *topic.document], topic.document, is_sure=is_only)


def _around(span: Span, offset: int, *, is_named: bool) -> Topic:
    """The surroundings of a name; an everyday word is a field of the messages at hand only, or of none."""
    topic = span.topic
    if span.text[offset] != "P" or span.is_code:
        return topic
    if is_named:
        return Topic((), (), (), ())
    return Topic(topic.above, topic.headings, topic.earlier, ()) if topic.above or topic.headings else topic


def _is_of_unknown(span: Span, low: int, offset: int) -> bool:
    """Return whether the nearest name before a field is of no known message: "PUMP_STATE, in which `id` ..."."""
    if span.is_code:
        return False
    names = [(at, term.letter) for at, term in span.sentence.within(low, offset, "MC")]
    return bool(names) and names[-1][1] == "C" and _IN_IT.match(span.text, names[-1][0] + 1, offset) is not None


_ITSELF = pattern(r"M (?:has|is|uses|carries|wants|sends|keeps|counts|knows|does)\b")
"""A message that a clause of its own is about: "only 16 bits here, NAME has 32"."""
_IN_IT = pattern(r"[^.;]{0,24}\b(?:has|have|with|in which|where|whose|carries|holds|contains|its|also)\b[^.;]{0,60}$")


def _about(name: str, messages: Iterable[WireMessage], others: Iterable[WireMessage], *, is_sure: bool) -> About | None:
    for message in messages:
        field = message.field(name)
        if field is not None:
            rest = tuple(found for other in others if (found := other.field(name)) is not None)
            return About(message, field, rest, is_sure)
    return None


_THAT = pattern(r"\b(?:that|this|it|the other|the (?:old|new|first|second) one)\b")


_OF_UNKNOWN = pattern(
    r"(?:\b(?:in|on|of|from|inside|with)(?: an?| the)? C\b|(?:^|(?<=[.!?;]) )(?:an? |the )?C\b)(?![^;]*M)"
)
"""A name in capitals that is no message, where a message stands."""


def subjects(reading: Reading, span: Span, offset: int) -> tuple[tuple[WireMessage, ...], bool]:
    """The messages that a statement without a name may be about, the likeliest first, and whether that is sure."""
    low, high = span.bounds(offset)
    own = [reading.messages[name] for at, name in span.named(low, high)]
    before = [reading.messages[name] for at, name in span.named(low, offset)][::-1]
    if own and (before or not _THAT.search(span.text, low, offset)):
        return _each((*before, *own)), True
    inside = [reading.messages[name] for _, name in span.named(max(low - _FAR, 0), low)][::-1]
    if not own and not span.is_code and _OF_UNKNOWN.search(span.text, low, offset):
        return (), False  # "in RALLY_SPOT the altitude is ..." is said of that, whatever it is
    if inside:
        return _each(inside), True
    topic = span.topic
    if span.is_code and topic.above:
        return topic.above[:1], True
    near = _each((*topic.above, *topic.headings, *topic.earlier))
    if near:
        return near, len(near) == 1 or len(topic.headings) == 1
    return (topic.document, True) if len(topic.document) == 1 else ((), False)


def _each(messages: Iterable[WireMessage]) -> tuple[WireMessage, ...]:
    return tuple({message.name: message for message in messages}.values())
