"""References of the numbers in two texts: axes, references of heights, clocks, signs, and single numbers.

Most of two texts may be alike, and still one word decide what each number means: ``true unless`` for ``true if``,
``positive forward`` for ``positive north``.
"""

import re
from collections.abc import Mapping
from functools import cache

_REFERENCES: Mapping[str, tuple[tuple[str, str], ...]] = {
    "axes": (
        ("earth", r"\bnorth|\beast(?:wards?)?\b|\bned\b|\benu\b"),
        (
            "body",
            r"\bforwards?\b|\bfrd\b|\bflu\b|\bbody\b|\bnose\b|\bstarboard\b"
            r"|\bfrom the (?:present |current |vehicle'?s? )*heading",
        ),
        ("ned", r"\bned\b"),
        ("enu", r"\benu\b"),
        ("frd", r"\bfrd\b"),
        ("flu", r"\bflu\b"),
    ),
    "height": (
        ("sea", r"\ba?msl\b|sea[- ]level|\bgeoid"),
        ("ellipsoid", r"ellipsoid|\bwgs ?84\b|\bhae\b"),
        ("home", r"above home|(?:relative|with respect) to (?:the )?home|above (?:the )?take-?off"),
        ("terrain", r"above (?:the )?(?:terrain|ground)|\bagl\b"),
        ("target", r"above (?:the )?target"),
    ),
    "pressure": (("qnh", r"\bqnh\b"), ("qne", r"\bqne\b"), ("qfe", r"\bqfe\b")),
    "clock": (
        ("utc", r"\butc\b|\bgmt\b|unix|epoch"),
        (
            "boot",
            r"since (?:the )?(?:system |vehicle )?(?:was )?(?:boot|start|power)|boot time"
            r"|from (?:the )?(?:system |vehicle )?boot",
        ),
        ("arming", r"(?:since|from) (?:the )?(?:vehicle )?(?:was )?(?:last )?arm"),
        ("take-off", r"(?:since|from) (?:the )?take-?off"),
        ("the last message", r"(?:since|from) (?:the )?(?:previous|last) (?:message|report)"),
        ("local time", r"local time"),
        ("gps time", r"\bgps (?:time|week)"),
    ),
    "airspeed": (
        ("indicated", r"\bindicated\b|\bias\b"),
        ("true", r"\btrue (?:air ?)?speed|\btas\b"),
        ("calibrated", r"\bcalibrated (?:air ?)?speed|\bcas\b"),
        ("equivalent", r"\bequivalent (?:air ?)?speed|\beas\b"),
    ),
    "statistic": (
        ("a mean", r"\baverag|\bmean (?:value|of|over)|\bmean\b(?= \w+ over)"),
        ("a peak", r"\bpeak|\bhighest|\bhottest|\bcoldest|\bmaximum (?:value|seen)"),
        ("a moment", r"\binstantaneous|\bmomentary"),
    ),
    "origin": (
        ("what was asked for", r"\bcommanded|\brequested|\bdesired|\bas set by"),
        ("what was measured", r"\bmeasured|\bread back|\bactual\b|\bfeedback|\bencoder"),
    ),
    "amount": (
        ("what is left", r"\bremaining|\bfree\b|\bunused\b"),
        ("what is used", r"\bin use\b|\bconsumed|\boccupied|\balready used"),
    ),
    "signal": (("raw values", r"\braw\b|\bunfiltered"), ("filtered values", r"(?<!un)\bfiltered|\bsmoothed")),
    "speed": (("the shaft", r"\bshaft|\bmechanical"), ("the field", r"\belectrical (?:rotation|speed|rpm)|\berpm\b")),
    "first number": (("0", r"\bzero[- ]based|\b0-based"), ("1", r"\bone[- ]based|\b1-based")),
    "observer": (
        ("behind", r"\bobserver behind|\bseen from behind|\bviewed from behind"),
        ("in front", r"\bobserver in front|\bseen from (?:the )?front|\bviewed from (?:the )?front"),
        ("above", r"\bseen from above|\bviewed from above"),
        ("below", r"\bseen from below|\bviewed from below"),
    ),
}  # fmt: skip
"""References that numbers are measured from, by kind: the name of each, and the words for it."""

STATED_LATE = frozenset({"height", "pressure", "airspeed", "first number", "statistic"})
"""Of what a text that says nothing leaves open which of several it is, so that vehicles differ."""

_DENIED = re.compile(r"\((?:and )?not [^)]*\)|\bnot relative to (?:the )?\w+")
_NEGATION = re.compile(r"\b(?:not|no|never|unless|except|without|cannot)\b|n't\b")
_NUMBER = re.compile(r"(?<![\w.])-?(?:0x[0-9a-f]+|\d+(?:\.\d+)?)(?![\w.]*\d)")
_LIMITS = frozenset(str(2**bits - 1) for bits in (7, 8, 15, 16, 31, 32, 63, 64))
_UNKNOWN = re.compile(
    r"\bnot (?:available|known|used|provided|set|supported|measured|applicable|equal)\b|\b(?:do not|don't) use\b"
)


def references(text: str) -> dict[str, frozenset[str]]:
    """Return what a text measures from, by the kind of it; ``not relative to north`` is no mention of north."""
    return _mentioned(_DENIED.sub(" ", text.lower()))


def denied_references(text: str) -> dict[str, frozenset[str]]:
    """Return what a text says that it does not measure from."""
    return _mentioned(" ".join(found[0] for found in _DENIED.finditer(text.lower())))


def _mentioned(text: str) -> dict[str, frozenset[str]]:
    if not text or not _any_of(None).search(text):
        return {}
    return {
        kind: frozenset(name for name, words in names if re.search(words, text))
        for kind, names in _REFERENCES.items()
        if _any_of(kind).search(text)
    }


@cache
def _any_of(kind: str | None) -> re.Pattern[str]:
    """Return what finds any words of a kind, or of all kinds: most texts have none, and are looked at once.

    All of them begin where a word does, which is asked first: with each of them it takes three times as long.
    """
    kinds = _REFERENCES if kind is None else (kind,)
    found = (words.removeprefix(r"\b") for each in kinds for _, words in _REFERENCES[each])
    return re.compile(rf"\b(?:{'|'.join(found)})")


def numbers(text: str) -> frozenset[str]:
    """Return the numbers of a text in one spelling, without the limits of types: those are its value for unknown."""
    return frozenset(_spelt(number[0]) for number in _NUMBER.finditer(text.lower())) - _LIMITS


def _spelt(number: str) -> str:
    if "x" in number:
        return str(int(number, 16))
    return number.rstrip("0").rstrip(".") if "." in number else str(int(number))


def negations(text: str) -> int:
    """Return how often a text denies something, without what it says of values that are unknown or not allowed."""
    return len(_NEGATION.findall(_UNKNOWN.sub(" ", text.lower())))
