"""Numbers beside words that the description of a field has for entries of its enum: "downward-facing: ROTATION_90"."""

from collections.abc import Iterator, Mapping

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import ENTRY_VALUE
from codegen.claims.weighed.clauses import clause
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement, piece, whole
from codegen.model.dialect.dialect import EnumDefinition, EnumEntry, WireField
from codegen.once import once
from codegen.pattern import pattern

_TOLD = pattern(r"\b(?P<word>[a-z]{2,})(?:-[a-z]+)?: (?P<entry>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+)\b")
_WORD = pattern(r"[a-z]+")
_NO_VALUE = pattern(r" ?(?:[-+*/%U]|\.\.|to N|hz\b|bytes?\b|times\b|elements\b|Q)")
_NO_VALUE_BEFORE = pattern(
    r"(?:[<>*/+#\[-]|\.\.|N to|\b(?:param|bit|version|id|message|than|above|below|over|under|least|most|about"
    r"|every)) ?$"
)
_FEW, _ENDING = 2, pattern(r"(?:(?<!\bfor)wards?|s)$")
_ELSE = pattern(r"\b(?:up|down) to\b")


def described_entries(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield what such words say of the numbers of a part."""
    known = _fields(reading)
    numbers = [at for at, _ in span.sentence.within(0, len(span.text), "N")] if known else []
    for at in numbers:
        value = whole(span, at)
        low, high = piece(span, at)
        if (
            value is None
            or _NO_VALUE.match(span.text, at + 1)
            or _NO_VALUE_BEFORE.search(span.text, max(low, at - 10), at)
        ):
            continue
        start, end = clause(span.text, at, low, high)
        last = max((each + 1 for each in numbers if start <= each < at), default=start)
        following = min((each for each in numbers if at < each < end), default=end)
        fields = {getattr(term.value, "name", "") for _, term in span.sentence.within(low, high, "FP")}
        for (message, name), words in known.items():
            behind, before = _meant(span.text[at + 1 : following], words), _meant(span.text[last:at], words)
            meant = behind if len(behind) == 1 else before
            if len(meant) != 1 or (len(before) > _FEW and not behind):
                continue
            entry, field = meant[0], reading.messages[message].field(name)
            if (
                field is None
                or not (name in fields or name in span.text[low:high])
                or value not in _values(reading, field)
            ):
                continue
            text = f"{message}.{name}: {entry.name} is {entry.value}, not {span.sentence.term(at).written}"
            found = traits(
                by_description=True,
                words_behind=meant is behind,
                field_named=name in fields,
                value_of_another=any(value == each.value for each in words.values()),
                several=len(numbers) > 1,
            )
            is_right = value == entry.value
            yield Statement(
                "meaning", ENTRY_VALUE, span, at, low, high, message, name, is_right, text, f"{name} described", found
            )
            break


def _meant(text: str, words: Mapping[str, EnumEntry]) -> list[EnumEntry]:
    """Return the entries that the words of a text are those of, each once."""
    found = (words[stem] for word in _WORD.findall(_ELSE.sub("", text)) if (stem := _ENDING.sub("", word)) in words)
    return list({entry.name: entry for entry in found}.values())


@once
def _fields(reading: Reading) -> Mapping[tuple[str, str], Mapping[str, EnumEntry]]:
    """By message and field of a document the words of descriptions, each with its entry."""
    found = {}
    for name in dict.fromkeys(name for _, name in reading.sightings):
        for field in reading.messages[name].fields:
            enum = reading.enums.get(field.definition.enum or "")
            words = _told(field, enum) if enum is not None else {}
            if len(words) >= _FEW:
                found[name, field.name] = words
    return found


def _told(field: WireField, enum: EnumDefinition) -> Mapping[str, EnumEntry]:
    found = {}
    for each in _TOLD.finditer(field.definition.description):
        entry = next((entry for entry in enum.entries if entry.name.endswith(each["entry"])), None)
        if entry is not None:
            found[_ENDING.sub("", each["word"])] = entry
    return found


def _values(reading: Reading, field: WireField) -> frozenset[int]:
    enum = reading.enums.get(field.definition.enum or "")
    return frozenset(entry.value for entry in enum.entries) if enum is not None else frozenset()
