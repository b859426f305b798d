"""Words that say that a name is a field of a message: "`x` of NAME", "NAME has an `x`", `x` in a list of its fields."""

from codegen.claims.known_names import Names
from codegen.load.prose import Passage
from codegen.model.dialect.dialect import WireMessage
from codegen.pattern import pattern

_NAME = pattern(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)*")
_NO_NAME = pattern(r"u?int\d*(?:_t)?|float|double|char|bool|true|false|null|none|nan|self|this")
_HAS = pattern(
    r"(?P<message>[A-Z][A-Z0-9_]{3,60})`?(?: also| only| still| itself| too)?"
    r"(?:['\u2019]s| has| carries| contains| holds| reports| provides| calls (?:it|this|that|the field))"
    r"(?: (?:an?|the|its|only|also|both|no|field|extension|array))* $"
)
_OF = pattern(
    r"`?(?: field| value| array| member)? (?:of|from) (?:the )?(?:message )?`?(?P<message>[A-Z][A-Z0-9_]{3,60})\b"
)
_JOIN = pattern(r"[` ]*(?:,|and|or|/|, and)[` ]*(?:the |an? )?")
_OWN = pattern(r"\b(?:our|ours|own|my|we add|extra)\b")
_FEWEST = 2
"""Fields of the message in the same list."""


def owner_of(text: str, low: int, high: int, names: Names) -> WireMessage | None:
    """Return the message that the words directly around a name say it is a field of."""
    name = text[low:high]
    if _NAME.fullmatch(name) is None or _NO_NAME.fullmatch(name):
        return None
    found = _OF.match(text, high) or _HAS.search(text, max(low - 100, 0), low)
    return names.messages.get(found["message"]) if found is not None else None


def is_among_fields(passage: Passage, low: int, high: int, message: WireMessage) -> bool:
    """Return whether a name stands in a list with fields of a message, and shares a word with one of them."""
    index = passage.codes.index((low, high))
    own = 0
    for step in (-1, 1):
        at = index
        while 0 <= at + step < len(passage.codes):
            first, second = sorted((passage.codes[at], passage.codes[at + step]))
            if not _JOIN.fullmatch(passage.text[first[1] : second[0]]):
                break
            at += step
            own += message.field(passage.text[slice(*passage.codes[at])]) is not None
    words = {word for word in passage.text[low:high].split("_") if len(word) > _FEWEST}
    return own >= _FEWEST and any(words & set(field.name.split("_")) for field in message.fields)


def is_joined_to_fields(passage: Passage, low: int, high: int, message: WireMessage) -> bool:
    """Return whether "and", "or" or a comma joins a name to a field of a message in a sentence with more of them."""
    index = passage.codes.index((low, high))
    start, end = passage.sentence(low, high)
    if _OWN.search(passage.text, start, end):
        return False
    own = {at for at in passage.codes if start <= at[0] and at[1] <= end and message.field(passage.text[slice(*at)])}
    if (
        len(own) <= _FEWEST
        or _NAME.fullmatch(passage.text[low:high]) is None
        or _NO_NAME.fullmatch(passage.text[low:high])
    ):
        return False
    beside = [at for at in (index - 1, index + 1) if 0 <= at < len(passage.codes) and passage.codes[at] in own]
    return any(
        _JOIN.fullmatch(passage.text[min(high, passage.codes[at][1]) : max(low, passage.codes[at][0])]) for at in beside
    )


def names_field_of(passage: Passage, low: int, high: int, message: WireMessage) -> bool:
    """Return whether a sentence names a field of a message, in a code span or behind a dot."""
    spans = {passage.text[start:end].partition("[")[0] for start, end in passage.codes if low <= start and end <= high}
    spans |= {found[1] for found in _BEHIND_DOT.finditer(passage.text, low, high)}
    return any(message.field(name.rpartition(".")[2]) is not None for name in spans)


_BEHIND_DOT = pattern(r"[A-Z0-9]\.([a-z]\w+)")
