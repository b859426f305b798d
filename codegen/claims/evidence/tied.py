"""Ties of a value to a name: in its cell, behind it with a few linking words between, or as a clause of its item."""

from codegen.claims.parts.sentence import NamedField
from codegen.claims.parts.span import Span
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_LINKS = frozenset((
    "is", "are", "has", "have", "a", "an", "the", "its", "of", "in", "as", "with", "be", "must", "it", "called",
    "which",
    "type", "unit", "units", "value", "values", "field", "fields", "array", "element", "elements", "entries", "both",
    "all", "each", "id", "ids", "message", "messages", "msg", "number", "no", "crc", "extra", "seed", "payload",
    "length", "size", "len", "min", "max", "bytes", "byte", "bits", "bit", "frame", "base", "name", "mavlink", "v",
    "without",
    "extensions", "extension", "long", "command", "means", "sent", "encoded", "given", "measured", "expressed", "comes",
    "first", "second", "third", "last", "on", "wire", "at", "offset", "order", "if", "when", "unknown", "invalid",
    "not", "known", "available", "provided", "for", "enum", "pub", "const", "static", "define", "raw", "holds",
    "from", "to", "u", "x", "ext", "note", "numeric", "room", "thing", "param", "parameter", "minimal", "form",
    "and", "minlength", "maxlength", "crcextra", "msg_id", "float", "floats", "characters", "chars",
))  # fmt: skip
"""Words that may stand between a name and what is said of it."""
_BESIDE_MOST = 70
"""Characters of the short text between a name and its value."""


_NEAR = 1000
"""The distance from a value within which names are looked for, in characters of the short text."""
_LEAD = 200
"""The greatest length of a text that does nothing but lead to a name, in characters."""


def near(at: int) -> tuple[int, int]:
    """Return the bounds between which names count for a value."""
    return max(at - _NEAR, 0), at + _NEAR


def around(span: Span, at: int) -> tuple[int, int]:
    """Return the bounds of what a value is judged in: its cell, or its sentence."""
    if span.kind is PassageKind.ROW:
        low = span.text.rfind("|", 0, at) + 1
        high = span.text.find("|", at)
        return low, high if high >= 0 else len(span.text)
    return span.bounds(at)


def is_clause(span: Span, name: int, at: int) -> bool:
    """Return whether a value is a clause of its own behind the name of its field, "`alt`: above home, float in mm"."""
    if at < name or any(span.sentence.within(name + 1, at, "MCEV")):
        return False
    fields = [offset for offset, _ in span.sentence.within(name + 1, at, "FP")]
    if fields and not _GROUP.match(span.text, name, fields[-1] + 1):
        return False
    low = max((each.end() for each in _MARK.finditer(span.text, name + 1, at)), default=None)
    high = _MARK.search(span.text + ",", at + 1)
    return low is not None and high is not None and closed(span.text[low : high.start()])


_MARK = pattern(r"[,;:|()]|\s[-\u2013\u2014]\s|\.(?=\s|$)")
_GROUP = pattern(r"[FP](?: ?[,/&] ?[FP]| and [FP])*")


def message_of(value: object) -> str | None:
    """Return the message that a term names, alone or with a field."""
    return value.message if isinstance(value, NamedField) else value if isinstance(value, str) else None


def is_alone(span: Span, offset: int) -> bool:
    """Return whether a name is all of its cell, but for what stands behind it in parentheses."""
    low = span.text.rfind("|", 0, offset) + 1
    high = span.text.find("|", offset)
    written = span.text[low : high if high >= 0 else len(span.text)]
    return _ALONE.fullmatch(written) is not None


_ALONE = pattern(r"\s*[MFPVN][^A-Za-z|]*(?:[,/&]\s*[MFP]\s*)*(?:\([^)]*\))?\s*")


def is_beside(span: Span, name: int, at: int, message: str = "") -> bool:
    """Return whether nothing stands between a name and a value but links, and values."""
    low, high = sorted((name, at))
    gap = span.text[low + 1 : high]
    if high - low > _BESIDE_MOST or (at < name and not _BEFORE.fullmatch(gap)):
        return False
    if "|" in gap:
        return False
    others = span.sentence.within(low + 1, high, "MCEVFP")
    is_listed = all(term.letter in "FP" or str(term.value) == message or term.value is None for _, term in others)
    if message and pattern(r"\band\b(?! [FP])").search(gap):
        return False  # what follows may be the next field's
    return is_listed and closed(gap) and not _RATIO.match(span.text, high + 1)


_BEFORE = pattern(r"[ =:,|#/*();\u2013-]{0,60}(?:is|means|for|command|value|the|are|enum|=|\s)*[ (]*")
_RATIO = pattern(r"/\w| ?/ ?N")


def closed(gap: str) -> bool:
    """Return whether all words between two places are links; capitals are terms."""
    if len(gap) > _LEAD:
        return False
    return all(word in _LINKS or word[0].isupper() for word in pattern(r"[A-Za-z]+").findall(gap))
