"""Numbers in the reach of a message: its id, its CRC_EXTRA, its size."""

from collections.abc import Iterator, Sequence

from codegen.claims.parts.span import Span, head_of
from codegen.claims.reading import Reading
from codegen.claims.rules import CRC_EXTRA, MESSAGE_ID, SIZE
from codegen.claims.statements.subjects import subjects
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement, is_alike, piece, whole
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V2
from codegen.once import once
from codegen.pattern import pattern

_CRC = pattern(r"crc|seed|extra|checksum")
_CRC_BEFORE = pattern(r"(?:crc|seed|extra(?: byte)?|checksum)[^.;N]{0,24}$")
_ID_BEFORE = pattern(
    r"(?:\b(?:ids?|messages?|msg|packets?|no\.?|numbers?)|#|_id)\W{0,3}(?:(?:is|of|are)\W)?[\W_]{0,3}$"
)
_ID = pattern(r"\b(?:ids?|message|msg|number|no\.|subscrib\w*|request\w*|listen\w*)\b|_id\b")
_BESIDE = pattern(r"M[^\w.]{0,6}$|M`?,? (?:is|has|=|->|as) ?(?:the |id |number |no |# ?|message |:)*$")
_BESIDE_BEHIND = pattern(r"[^\w.]{0,8}M\b")
_BYTES = pattern(r"[ -]?(?:bytes?|octets?|b)\b(?! (?:of|per|a second|each|and|shorter|longer|more|less|later)\b|/| ?/)")
_SIZE_BEFORE = pattern(
    r"(?:\b(?:len|length|sizes?|payloads?|bytes|msg_?len|calcsize)\b|_len|_length|_size)[^.;N]{0,16}$"
)
_NO_ID = pattern(r"[ -]?(?:bytes?|octets?|hz|times|fields?|%|u\b|U|elements|samples|messages|per\b|/|\*|bits?\b|:\d)")
_WORD = pattern(r"[a-z0-9]+")
_OTHER = pattern(
    r"\b(?:component|system|param\w*|instance|sensor|camera|command|server|client|node|version|port|baud|channel|line"
    r"|page|section|ticket|issue|step|index|offset|type|mode|field)s?\b[^.;N]{0,12}$"
)
_ID_HEAD = pattern(r"#|(?:message |msg )?(?:ids?|no\.?|nr\.?|numbers?)|message|msg")
_PARTLY = pattern(
    r"\b(?:without|except|of which|header|frame|head|first|last|each|every|per|more|fewer|up to|about|rest)\b"
)
_ELSEWHERE = pattern(r"\b(?:component|system) ids?\b|\bown\b|\bprivate\b|\bused to\b|\bno longer\b")
"""Words of a sentence about other numbers than those of the dialect."""
_DENIED = pattern(r"\b(?:not|never|n't|was|were)(?: an?| the)?(?: message| id| number)* $")
"""Before a number that is not that of the message, or that was."""
_LEAD = 50
"""Characters before a number in which words say what it is."""


def of_messages(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield what numbers of a part may say of a message."""
    for at, _ in span.sentence.within(0, len(span.text), "N"):
        value = whole(span, at)
        if value is None or value < 1:
            continue
        low, high = piece(span, at)
        yield from _of_number(reading, span, at, value, (low, high))


def _of_number(reading: Reading, span: Span, at: int, value: int, bounds: tuple[int, int]) -> Iterator[Statement]:
    low, high = bounds
    text = span.source_text(max(low, at - _LEAD), at).lower()
    marked, behind = span.text[max(low, at - _LEAD) : at], span.text[at + 1 : min(high, at + 20)]
    head = head_of(span, at).lower() if span.kind is PassageKind.ROW else ""
    is_beside = _BESIDE.search(marked) is not None
    is_before = _BESIDE_BEHIND.match(behind) is not None
    if _ELSEWHERE.search(span.text, low, high) or _DENIED.search(text):
        return
    roles = []
    if (_CRC.search(text) or _CRC.search(head)) and not _BYTES.match(behind):
        roles.append("crc")
    elif _BYTES.match(behind) or _SIZE_BEFORE.search(text) or "byte" in head or "size" in head or "length" in head:
        roles.append("size")
    elif not _NO_ID.match(behind) and (is_beside or is_before or _ID_BEFORE.search(text) or _ID_HEAD.fullmatch(head)):
        roles.append("id")
    for role in roles:
        message, others, how = _message(reading, span, at, low, high)
        if message is None:
            continue
        yield from _compared(
            reading,
            span,
            at,
            value,
            bounds,
            role,
            message,
            others,
            how,
            traits(
                beside=is_beside,
                beside_behind=is_before,
                parenthesis="(" in marked[-2:] or "(" in behind[:3],
                cue_before=(_ID_BEFORE if role == "id" else _CRC_BEFORE if role == "crc" else _SIZE_BEFORE).search(
                    text
                ),
                cue=(_ID if role == "id" else _CRC if role == "crc" else _BYTES).search(text),
                cue_of_column=bool(head),
                bytes_behind=_BYTES.match(behind),
                of_something_else=_OTHER.search(text),
                partly=role == "size" and _PARTLY.search(span.text, low, high),
                total=role == "size" and ("payload" in text or "message" in text),
                equals_sign=marked.rstrip().endswith("="),
                great=value > 99,
            ),
        )


def _message(
    reading: Reading, span: Span, at: int, low: int, high: int
) -> tuple[WireMessage | None, Sequence[WireMessage], tuple[str, ...]]:
    """Return the message that a number may be said of, others that may be meant, and how they are tied to it."""
    own = [(offset, name) for offset, name in span.named(low, high)]
    before = [name for offset, name in own if offset < at]
    behind = [name for offset, name in own if offset > at]
    numbers = sum(1 for _ in span.sentence.within(low, high, "N"))
    found = traits(
        several_messages=len({name for _, name in own}) > 1,
        several_numbers=numbers > 1,
        as_many_numbers=numbers == len(own) > 1,
    )
    if before or behind:
        name = before[-1] if before else behind[0]
        offset = next(each for each, said in reversed(own) if said == name and (each < at) == bool(before))
        between = span.text[offset:at]
        rest = [reading.messages[each] for each in dict.fromkeys(n for _, n in own) if each != name]
        return (
            reading.messages[name],
            rest,
            (
                *found,
                "named before" if before else "named behind",
                *traits(
                    number_between="N" in between,
                    name_between=any(letter in between for letter in "FCEV"),
                    far=abs(len(between)) > 40,
                ),
            ),
        )
    if span.is_code and not span.is_comment and (called := _called(reading, span, low, high)) is not None:
        return called, (), (*found, "by its words")
    messages, is_sure = subjects(reading, span, at)
    return (messages[0] if messages else None), messages[1:], (*found, "not named", *traits(sure=is_sure))


@once
def _own_words(reading: Reading) -> dict[str, WireMessage]:
    """The words of names of messages that only one of those has which a document names."""
    names = dict.fromkeys(name for _, name in reading.sightings)
    found: dict[str, list[str]] = {}
    for name in names:
        for word in name.lower().split("_"):
            found.setdefault(word, []).append(name)
    return {word: reading.messages[those[0]] for word, those in found.items() if len(those) == 1}


def _called(reading: Reading, span: Span, low: int, high: int) -> WireMessage | None:
    """Return the message that the name of a constant is of: PID_CRC_EXTRA, of PID_TUNING."""
    words = _own_words(reading)
    found = {words[word].name for word in _WORD.findall(span.source_text(low, high).lower()) if word in words}
    return reading.messages[found.pop()] if len(found) == 1 else None


def _true(message: WireMessage, role: str) -> tuple[int, ...]:
    if role == "id":
        return (message.id,)
    if role == "crc":
        return (message.crc_extra,)
    sizes = (message.base_length, message.length)
    return (*sizes, *(size + more for size in sizes for more in (8, HEAD_V2, HEAD_V2 + 13)))


_RULES = {"id": MESSAGE_ID, "crc": CRC_EXTRA, "size": SIZE}
_SHOWN = {"id": "the id", "crc": "the CRC_EXTRA", "size": "a payload of"}


def _compared(
    reading: Reading,
    span: Span,
    at: int,
    value: int,
    bounds: tuple[int, int],
    role: str,
    message: WireMessage,
    others: Sequence[WireMessage],
    how: tuple[str, ...],
    found: tuple[str, ...],
) -> Iterator[Statement]:
    if message.id < 0:
        return
    true = _true(message, role)
    if role != "size" and value not in true and value in (*_true(message, "size"), message.id, message.crc_extra):
        return  # another number of it
    is_right = value in true
    properties = {message.id, message.crc_extra, *_true(message, "size")}
    named = [reading.messages[name] for name in dict.fromkeys(name for _, name in reading.sightings)]
    more = traits(
        alike=any(is_alike(value, each) for each in true[: 2 if role == "size" else 1]),
        of_another_here=any(value in _true(other, role) for other in others),
        of_another_of_the_document=any(value in _true(other, role) for other in named if other is not message),
        something_else_of_it=value in properties,
        size_of_fields=role == "size" and _is_partial(message, value),
        close=any(abs(value - each) <= max(each // 4, 2) for each in true[:2]),
        id_of_a_message=role == "id" and value in _ids(reading),
        less_than_a_field=role == "size" and value < max(field.size for field in message.fields),
    )
    shown = f"{true[0]} bytes" if role == "size" else true[0]
    if role == "size" and message.length != message.base_length:
        shown = f"{true[0]} bytes, {message.length} with extensions"
    text = f"{message.name} has {_SHOWN[role]} {shown}, not {value}"
    yield Statement(role, _RULES[role], span, at, *bounds, message.name, "", is_right, text, "", (*how, *found, *more))


@once
def _ids(reading: Reading) -> frozenset[int]:
    return frozenset(message.id for message in reading.reference.dialect.messages.values())


def _is_partial(message: WireMessage, value: int) -> bool:
    """Return whether a number of bytes is that of a field, or of the first ones on the wire."""
    sizes, total = set(), 0
    for field in message.fields:
        sizes.add(field.size)
        total += field.size
        sizes.add(total)
    return value in sizes
