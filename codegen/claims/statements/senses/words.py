"""The words of a text that say which way a number counts, and those that exclude others, such as MSL and above home."""

from collections.abc import Iterator, Mapping
from functools import cache

from codegen.frozen import dataclass
from codegen.pattern import pattern

_WAYS: Mapping[str, tuple[str, str]] = {
    "vertical": (
        r"up(?:wards?)?|above the origin|climb(?:s|ing)?|ascen(?:ds?|ding|t)|ris(?:es?|ing)",
        r"down(?:wards?)?|below the origin|descen(?:ds?|ding|t)|sink(?:s|ing)?|fall(?:s|ing)",
    ),
    "rotation": (r"clockwise|cw", r"(?:counter|anti)[- ]?clockwise|ccw"),
    "lateral": (r"right|starboard", r"left|port"),
    "latitude": (r"north(?:wards?)?", r"south(?:wards?)?"),
    "longitude": (r"east(?:wards?)?", r"west(?:wards?)?"),
    "flow": (r"out|discharg(?:es?|ing|ed)", r"into|charg(?:es?|ing|ed)"),
    "line": (
        r"releas(?:es?|ing|ed)|pa(?:ys?|id|ying) out|let(?:s|ting)? out",
        r"retract(?:s|ing|ed)?|wind(?:s|ing)?|reel(?:s|ed|ing)? in",
    ),
}
"""By axis the words for its one way, and for the other."""
_ONE_WAY = {axis: pattern(rf"(?:{first})") for axis, (first, _) in _WAYS.items()}
_WORDS = {axis: pattern(rf"(?<![a-z-])(?:{second}|{first})(?![a-z])") for axis, (first, second) in _WAYS.items()}
_ANY = "|".join(f"(?P<{axis}>{second}|{first})" for axis, (first, second) in _WAYS.items())
_WAY = rf"(?<![a-z-])(?:{_ANY})(?![a-z])"
_SIGN = r"(?P<sign>positive|negative|plus|minus|\+)"
_MOVES = r"yaw\w*|roll\w*|pitch\w*|mov\w*|turn\w*|rotat\w*|fly\w*|go\w*|point\w*"
_FORMS = (
    pattern(
        rf"{_SIGN}(?:[\s:=,(\"'*_`|-]|\b(?:values?|numbers?|is|are|means?|if|when|while|for|it|being|be|the|vehicle|to"
        rf"|orbits?|thrust|speeds?|towards?|direction|counts?|one|axis|as|line|{_MOVES})\b){{0,12}}{_WAY}",
        needs="positive|negative|plus|minus|+",
    ),
    pattern(
        rf"{_WAY}(?:[\s:=\"'*_`-]|\b(?:is|are|being|counts?|counted|gives?|has|as|with|means|values?|motion|movement"
        r"|speeds?|rotation|an?|the|be|taken|shall|must|direction|line|will)\b){0,8}"
        r"(?:(?P<sign>positive|negative|plus|minus)|(?<![\u2212-])(?P<number>[+\u2212-]\d+|1000?|\+))",
    ),
    pattern(
        rf"\b(?:counts?|counted|grows?|increas(?:es|ing)|increments?|increment direction is|measured|rotation) "
        rf"(?:to the )?{_WAY}",
    ),
)

_TELLING = (
    "positive",
    "negative",
    "plus",
    "minus",
    "+",
    "wise",
    "cw",
    "count",
    "grow",
    "increas",
    "increment",
    "measur",
)
"""Words one of which is in every text that tells of a way."""


@dataclass(frozen=True, slots=True)
class Sense:
    """A pole of one axis that a text names: in which words, and where in the text."""

    axis: str
    pole: str
    words: str
    start: int
    end: int


_POLES: Mapping[str, Mapping[str, str]] = {
    "level": {
        "sea level": r"\ba?msl\b|\bsea[- ]level\b|\bgeoid\b|\begm ?96\b",
        "ellipsoid": r"\bwgs[- ]?84\b|\bellipsoid\w*|\bhae\b",
        "home": r"\b(?:above|over|relative to|from|to|of) (?:the )?(?:home|take-?off|launch)\b|\bhome altitude\b",
        "ground": r"\b(?:above|over) (?:the )?(?:ground|terrain)\b|\bagl\b",
    },
    "first": {
        "zero": r"\b(?:zero|0)[- ]based\b|\b(?:start|begin|count)\w* (?:at|from|with) (?:zero|0)\b"
        r"|\bfirst (?:[a-z]+ )?(?:is|has|gets) (?:number )?(?:zero|0)\b|\b(?:zero|0)(?: is)? for (?:the )?first\b",
        "one": r"\b(?:one|1)[- ]based\b|\b(?:start|begin|count)\w* (?:at|from|with) (?:one|1)\b"
        r"|\bfirst (?:[a-z]+ )?(?:is|has|gets) (?:number )?(?:one|1)\b|\b(?:one|1)(?: is)? for (?:the )?first\b",
    },
    "quaternion": {
        "w, x, y, z": r"\bw ?,? ?x ?,? ?y ?,? ?z\b|\b(?:scalar|real part|w)[- ](?:comes |is )?first\b",
        "x, y, z, w": r"\bx ?,? ?y ?,? ?z ?,? ?w\b|\b(?:scalar|real part|w)[- ](?:comes |is )?last\b",
    },
    "wind": {
        "from": r"\b(?:com\w+|blow\w*) from\b|\bfrom (?:which|where)\b|\bone (?:that )?it comes from\b",
        "to": r"\b(?:blow\w*|go\w*|flow\w*|mov\w*) (?:to|towards?|into)\b|\bto(?:wards)? (?:which|where)\b",
    },
    "amount": {
        "remaining": r"\bremaining\b|\bfree (?:space|memory|room|slots?|capacity|buffers?)\b|\bleft over\b",
        "used": r"\bin use\b|\boccupied\b|\bconsumed\b|\bused(?! (?:for|by|to|as|in|with|when|if|only|here|on|at))\b",
    },
    "north": {"true": r"\btrue north\b", "magnetic": r"\bmagnetic north\b"},
    "airspeed": {
        "indicated": r"\bindicated airspeed\b|\bias\b",
        "true": r"\btrue airspeed\b|\btas\b",
    },
    "share": {
        "per one": r"\bper[- ](?!second|minute|hour|unit|day)[a-z]+\b",
        "whole": r"\bwhole\b|\bentire\b|\btotal\b|\bsum of all\b",
    },
}
"""By axis what excludes each other, by its name, with the words that say it."""
_SAID = {
    axis: pattern("|".join(f"(?P<p{number}>{words})" for number, words in enumerate(poles.values())))
    for axis, poles in _POLES.items()
}
_NEEDED: Mapping[str, tuple[str, ...]] = {
    "level": (
        "msl",
        "sea",
        "geoid",
        "egm",
        "wgs",
        "ellips",
        "hae",
        "home",
        "off",
        "launch",
        "ground",
        "terrain",
        "agl",
    ),
    "first": ("first", "based", "start", "begin", "count"),
    "quaternion": ("w", "scalar", "real"),
    "wind": ("from", "to"),
    "amount": ("remaining", "free", "left", "use", "occupied", "consumed"),
    "north": ("north",),
    "airspeed": ("airspeed", "ias", "tas"),
    "share": ("per", "whole", "entire", "total", "sum"),
}
"""By axis what a text in which it is spoken of has one of."""


def signs(text: str) -> Iterator[Sense]:
    """Yield which way numbers count, as a text in small letters says it; "+" is where the first way is positive."""
    for form in _FORMS if any(word in text for word in _TELLING) else ():
        for found in form.finditer(text):
            axis = next(axis for axis in _WAYS if found[axis])
            given = found.groupdict()
            sign = given.get("sign") or given.get("number") or "+"
            is_first = _ONE_WAY[axis].fullmatch(found[axis]) is not None
            is_positive = sign in ("positive", "plus") or sign[0] in "+1"
            yield Sense(axis, "+" if is_first == is_positive else "-", found[0].strip(" :=,(|*`"), *found.span())


_LOOSE = pattern(
    rf"(?P<sign>positive|negative)(?:[^\w.;|]+(?!(?:positive|negative)\b)\w+){{0,7}}?[^\w.;|]+{_WAY}"
    rf"|{_WAY.replace('(?P<', '(?P<z_')}(?:[^\w.;|]+\w+){{0,3}}?[^\w.;|]+(?P<then>positive|negative)",
    needs="positive|negative",
)


def loose_signs(text: str) -> Iterator[Sense]:
    """Yield the ways that stand near "positive" or "negative" in a text in small letters, with any words between."""
    for found in _LOOSE.finditer(text):
        given = found.groupdict()
        axis = next(axis for axis in _WAYS if given[axis] or given[f"z_{axis}"])
        word = given[axis] or given[f"z_{axis}"]
        is_first = _ONE_WAY[axis].fullmatch(word) is not None
        is_positive = (given["sign"] or given["then"]) == "positive"
        yield Sense(axis, "+" if is_first == is_positive else "-", found[0].strip(" :=,(|*`"), *found.span())


def has_other_way(sense: Sense, text: str) -> bool:
    """Return whether a text tells of the other way of an axis too: "north/east/down, shown with up positive"."""
    if sense.axis not in _WAYS:
        return False
    found = [each[0] for each in _WORDS[sense.axis].finditer(text)]
    return len({_ONE_WAY[sense.axis].fullmatch(word) is not None for word in found}) > 1


def levels(text: str) -> Iterator[Sense]:
    """Yield what a text in small letters says of levels, first numbers, orders and shares."""
    for axis, poles in _POLES.items():
        if any(word in text for word in _NEEDED[axis]):
            for found in _SAID[axis].finditer(text):
                pole = next(name for number, name in enumerate(poles) if found[f"p{number}"])
                yield Sense(axis, pole, found[0], *found.span())


@cache
def told(description: str) -> Mapping[str, Sense]:
    """Return what the description of a field says, by axis; nothing of an axis of which it says both."""
    text = description.lower()
    found: dict[str, list[Sense]] = {}
    for sense in (*signs(text), *levels(text)):
        found.setdefault(sense.axis, []).append(sense)
    known = {axis: each[0] for axis, each in found.items() if len({sense.pole for sense in each}) == 1}
    return {axis: sense for axis, sense in known.items() if sense.pole not in _SAID_OF_MUCH}


_SAID_OF_MUCH = ("whole", "used")
"""Words that descriptions use for much else."""
