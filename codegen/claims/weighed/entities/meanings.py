"""Numbers beside words for entries of enums, whichever field of the message has them, or none that is named."""

from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.rules import ENTRY_VALUE
from codegen.claims.statements.meaning import meaning
from codegen.claims.weighed.clauses import clause
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.parameter_places import commands_near, commands_of, enums_of_parameters
from codegen.claims.weighed.entities.statement import Statement, piece, whole
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import EnumDefinition, WireMessage
from codegen.once import once
from codegen.pattern import pattern

_NO_VALUE = pattern(
    r"(?:\b(?:than|above|below|over|under|least|most|about|until|version|param|except|but|not|first|every|after|id"
    r"|message) |[<>\u2264\u2265+*/x-] ?|\.\.|\[)$"
)
_NO_VALUE_BEHIND = pattern(r" ?(?:U|[*/x+]|hz|bytes?|times|fields?|messages?|elements|samples|bits?|%|\.\.|to N)")
_BIT = pattern(r"\bbits? (?:number |no\.? )?$")
_BITS = 32
_SAID = "PUVTCF"
_WORD = pattern(r"[a-z]+")
_MOST_ENTRIES = 60
_NEAR = 3
"""Messages around a part whose enums are looked at."""
_DECLARED = pattern(r"^\W*(?:#define |(?:pub |export |static |const(?:expr)? |final |let |var |val |int |uint8_t )*)")


@dataclass(frozen=True, slots=True)
class _Scope:
    """An enum that may be meant, by the field that has it, and how it is tied to the part."""

    enum: EnumDefinition
    message: str
    field: str
    traits: tuple[str, ...]


def meant(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield what the words beside numbers of a part would say of entries."""
    numbers = [at for at, _ in span.sentence.within(0, len(span.text), "N")]
    scopes: list[_Scope] | None = None
    known = _words_of_entries(reading) if numbers else frozenset()
    for at in numbers:
        value = whole(span, at)
        if value is None or value < 0 or _NO_VALUE_BEHIND.match(span.text, at + 1):
            continue
        low, high = piece(span, at)
        before = span.text[max(low, at - 14) : at]
        if _NO_VALUE.search(before):
            continue
        if scopes is None and known.isdisjoint(_WORD.findall(_words(span, low, high).lower())):
            continue
        scopes = list(_scopes(reading, span, low, high)) if scopes is None else scopes
        is_bit = _BIT.search(before) is not None and value < _BITS
        entries = {str(term.value) for _, term in span.sentence.within(low, high, "V")}
        if any(entry.value == value and entry.name in entries for scope in scopes for entry in scope.enum.entries):
            continue  # its own entry is named beside it
        yield from _of_number(span, at, value, (low, high), is_bit, scopes, numbers)


def _scopes(reading: Reading, span: Span, low: int, high: int) -> Iterator[_Scope]:
    """Yield the enums that may be meant: those named, those of fields, those of messages around."""
    named = [str(term.value) for _, term in span.sentence.within(low, high, "E")]
    done: set[object] = set()
    for name in named:
        if name in reading.enums and name not in done:
            done.add(name)
            message, field = _holder(reading).get(name, ("", ""))
            yield _Scope(reading.enums[name], message or name, field or name, ("enum named",))
    own = [name for _, name in span.named(0, len(span.text))]
    topic = span.topic
    above, headings = ([each.name for each in those] for those in (topic.above[:1], topic.headings))
    near = [*own, *(each.name for those in (topic.above, topic.headings, topic.document) for each in those[:_NEAR])]
    only = len(topic.document) == 1
    for name in dict.fromkeys(near):
        for field, called in _enums_of(reading.messages[name]):
            enum = reading.enums.get(called)
            if enum is None or len(enum.entries) > _MOST_ENTRIES or (name, field) in done:
                continue
            done.add((name, field))
            yield _Scope(
                enum,
                name,
                field,
                traits(
                    message_named=name in own,
                    message_above=name in above,
                    message_of_heading=name in headings,
                    only_message_of_document=only,
                ),
            )
    for name in commands_near(reading, span)[:_NEAR]:
        for field, called in enums_of_parameters(commands_of(reading)[name]):
            enum = reading.enums.get(called)
            if enum is not None and called != _TRUTH and (name, field) not in done:
                done.add((name, field))
                yield _Scope(enum, name, field, ("of a command", *traits(alone=not own)))


_TRUTH = "MAV_BOOL"
"""An enum whose words are those of any text: true, false."""


@once
def _enums_of(message: WireMessage) -> tuple[tuple[str, str], ...]:
    return tuple((field.name, field.definition.enum) for field in message.fields if field.definition.enum)


@once
def _holder(reading: Reading) -> dict[str, tuple[str, str]]:
    """By enum the first field of a message of the document that has it."""
    found: dict[str, tuple[str, str]] = {}
    for name in dict.fromkeys(name for _, name in reading.sightings):
        for field, enum in _enums_of(reading.messages[name]):
            found.setdefault(enum, (name, field))
    return found


@once
def _words_of_entries(reading: Reading) -> frozenset[str]:
    """The words of all entries that a document may mean: of the enums of messages that it names, and of those named."""
    names = {enum for name in {name for _, name in reading.sightings} for _, enum in _enums_of(reading.messages[name])}
    commands = commands_of(reading)
    for span in spans(reading):
        named = [(term.letter, str(term.value)) for _, term in span.sentence.within(0, len(span.text), "EV")]
        names |= {name for letter, name in named if letter == "E"}
        called = [commands[name] for letter, name in named if letter == "V" and name in commands]
        names |= {enum for command in called for _, enum in enums_of_parameters(command)} - {_TRUTH}
    found = (_vocabulary(reading.enums[name]) for name in names if name in reading.enums)
    return frozenset().union(*found)


@once
def _vocabulary(enum: EnumDefinition) -> frozenset[str]:
    return frozenset(word for entry in enum.entries for word in _WORD.findall(entry.name.lower()) if len(word) > 2)


def _of_number(
    span: Span, at: int, value: int, bounds: tuple[int, int], is_bit: bool, scopes: list[_Scope], numbers: list[int]
) -> Iterator[Statement]:
    low, high = bounds
    start, end = clause(span.text, at, low, high)
    last = max((each + 1 for each in numbers if start <= each < at), default=start)
    following = min((each for each in numbers if at < each < end), default=end)
    nearest = {"words behind": (at + 1, following), "words before": (last, at), "words around": (last, following)}
    sides = {side: _words(span, *each) for side, each in nearest.items()}
    is_constant = span.is_code and not span.is_comment
    of_side = {side: frozenset(_WORD.findall(words.lower())) for side, words in sides.items()}
    content = of_side["words around"]
    named = {term.value for _, term in span.sentence.within(low, high, "FP")}
    fields = {getattr(each, "name", "") for each in named}
    of_named = [scope for scope in scopes if scope.field in fields]
    told: set[str] = set()
    for scope in of_named or scopes:
        if scope.enum.name in told or not content & _vocabulary(scope.enum) - set(scope.field.split("_")):
            continue
        told.add(scope.enum.name)
        known = meaning(scope.enum)
        own_words = _vocabulary(scope.enum)
        for side, words in sides.items():
            if own_words.isdisjoint(of_side[side]):
                continue
            shifted = 1 << value if is_bit else value
            if known.is_named(shifted, words):
                yield Statement(
                    "meaning", ENTRY_VALUE, span, at, low, high, scope.message, scope.field, True, group=scope.enum.name
                )
                break
            if is_bit and known.is_named(value, words):
                break
            entry = known.meant_otherwise(shifted, words, is_name=is_constant) or known.marked_otherwise(shifted, words)
            if entry is None:
                continue
            if _is_flags(scope.enum) and value & entry.value and value != entry.value:
                break
            text = f"{scope.message}.{scope.field}: {entry.name} is {entry.value}, not {span.sentence.term(at).written}"
            found = traits(
                by_its_name=known.meant_otherwise(shifted, words, is_name=is_constant) is not None,
                sure_name=known.is_sure(entry, words),
                bit=is_bit,
                flags=_is_flags(scope.enum),
                value_of_another=any(each.value == shifted for each in scope.enum.entries),
                field_named=scope.field in fields,
                another_field_named=fields - {scope.field, ""},
                several=len(numbers) > 1,
                one_word=len(_WORD.findall(words)) == 1,
                constant=is_constant,
                great=value > 3,
                link=span.text[at + 1 : at + 3].strip()[:1] in "=:(-"
                if side == "words behind"
                else span.text[at - 2 : at].strip()[-1:] in ("=", ":", "("),
                entry_named=any(span.sentence.within(low, high, "V")),
            )
            yield Statement(
                "meaning",
                ENTRY_VALUE,
                span,
                at,
                low,
                high,
                scope.message,
                scope.field,
                False,
                text,
                scope.enum.name,
                (side, *scope.traits, *found),
            )
            break


@once
def _is_flags(enum: EnumDefinition) -> bool:
    values = [entry.value for entry in enum.entries if entry.value]
    return len(values) > 2 and max(values) > 4 and all(not each & (each - 1) for each in values)


def _words(span: Span, low: int, high: int) -> str:
    terms, text = span.sentence.terms, span.text
    found = "".join(
        text[at] if at not in terms else f" {terms[at].written} " if terms[at].letter in _SAID else " "
        for at in range(low, high)
    )
    return found.replace("_", " ")
