"""Words in one spelling, and which of them exclude each other: what names and texts are compared by."""

from functools import cache

from codegen.pattern import pattern

_DOUBLED = pattern(r"([a-z])(?=\1)")
_VOWELS = pattern(r"(?<=.)[aeiou]")

_EXCLUDING: tuple[tuple[str, ...], ...] = (
    ("up", "down"), ("left", "right"), ("on", "off"), ("open", "close"), ("lock", "unlock"), ("arm", "disarm"),
    ("high", "low"), ("highest", "lowest"), ("max", "min"), ("maximum", "minimum"), ("largest", "smallest"),
    ("first", "last"), ("north", "south"), ("east", "west"), ("front", "rear"), ("front", "back"),
    ("forward", "backward", "reverse"), ("start", "stop"), ("begin", "end"), ("positive", "negative"),
    ("true", "false"), ("local", "global"), ("absolute", "relative"), ("ascend", "descend"), ("inner", "outer"),
    ("success", "fail"), ("before", "after"), ("above", "below"), ("inclusive", "exclusive"), ("inside", "outside"),
    ("grab", "release"), ("raise", "lower"), ("increase", "decrease"), ("internal", "external"),
    ("horizontal", "vertical"), ("latitude", "longitude", "altitude"), ("pitch", "roll", "yaw"),
    ("enable", "disable"), ("valid", "invalid"), ("active", "inactive"), ("healthy", "unhealthy"),
    ("available", "unavailable"), ("allow", "forbid"), ("accept", "reject"), ("upper", "lower"),
    ("gyro", "accelerometer", "magnetometer"), ("input", "output"), ("master", "slave"), ("import", "export"),
    ("read", "write"), ("run", "stop"), ("epoch", "boot"), ("sea", "home", "terrain", "ellipsoid"),
    ("vehicle", "gimbal", "camera"), ("north", "nose"), ("true", "magnetic"), ("ground", "air"), ("remote", "local"),
    ("old", "new"), ("minute", "second", "hour"), ("total", "remaining"), ("charge", "discharge"), ("x", "y", "z", "w"),
    ("ned", "enu", "frd", "flu", "fru"), ("coming", "going"), ("incoming", "outgoing"), ("toward", "away"),
    ("position", "velocity", "acceleration"), ("source", "target", "sender", "receiver"), ("body", "world"),
    ("more", "less"), ("larger", "smaller"), ("load", "save"), ("pressure", "temperature", "humidity"),
    ("voltage", "current", "power"), ("clockwise", "counterclockwise"), ("row", "column"),
)  # fmt: skip
"""Words that exclude each other: where one takes the place of another, the meaning does."""

_SPELLINGS = {
    "manoeuver": "maneuver", "manoeuvre": "maneuver", "metre": "meter", "centre": "center", "colour": "color",
    "bad": "fail", "failure": "fail", "failed": "fail", "error": "fail", "good": "ok", "okay": "ok",
    "sec": "second", "secs": "second", "max": "maximum", "min": "minimum", "mag": "magnetometer",
    "accel": "accelerometer", "mtr": "meter", "cal": "calibration", "alt": "altitude", "temp": "temperature",
    "pos": "position", "lat": "latitude", "lon": "longitude", "vel": "velocity", "cfg": "config", "bat": "battery",
    "batt": "battery", "cam": "camera", "ctrl": "control", "num": "number", "msg": "message", "cmd": "command",
    "param": "parameter", "drone": "vehicle", "uav": "vehicle", "aircraft": "vehicle", "location": "position",
    "cable": "line", "else": "otherwise", "replacement": "alternative", "shorter": "shortest", "identifier": "id",
    "go": "fly", "goes": "fly", "gone": "fly",
     "every": "all", "fine": "ok", "shut": "close", "rows": "row", "succeed": "success",
    "successful": "success", "successfully": "success",
    "dist": "distance", "acc": "accuracy", "est": "estimate", "calib": "calibration",
}  # fmt: skip

_SYNONYMS: tuple[tuple[str, ...], ...] = (
    ("height", "altitude"), ("actual", "current", "present"), ("free", "available"), ("picture", "image", "photo"),
    ("documentation", "description"), ("deprecated", "superseded", "obsolete"), ("start", "begin"),
    ("end", "finish", "complete"), ("large", "big"), ("allow", "permit"), ("maximum", "highest", "largest"),
    ("minimum", "lowest", "smallest"), ("show", "display"), ("select", "choose"),
    ("unknown", "unavailable", "undefined"), ("wrong", "incorrect"), ("measurement", "data", "reading", "sample"),
    ("size", "magnitude"), ("custom", "user"), ("fly", "flight", "flying"), ("mean", "average"), ("execute", "perform"),
    ("transmit", "send"), ("bitmap", "bitmask", "mask"), ("erase", "delete"), ("connect", "attach"),
    ("reach", "arrive"),
    ("receive", "get"), ("interval", "period"), ("quantity", "amount"), ("amount", "number"), ("frequency", "rate"),
    ("stop", "halt"), ("retry", "repeat"), ("waypoint", "item"), ("location", "place", "position"), ("now", "current"),
    ("missing", "absent"), ("present", "fitted"), ("specify", "indicate"), ("denote", "indicate"), ("tell", "indicate"),
    ("represent", "indicate"), ("state", "status"), ("obtain", "get"), ("try", "attempt"), ("blow", "come"),
    ("exclude", "without", "omit", "skip"), ("active", "running", "run", "runs"), ("fully", "completely", "entirely"),
    ("share", "fraction", "proportion"),
    ("deploy", "extend"), ("lost", "down"),
)  # fmt: skip
"""Words that mean the same, though each may mean something else, too."""

_LEAST_LETTERS = 5
"""Of a word in which one letter is doubled for another one, more than which it has."""
_SPELT_OTHERWISE = ("manoeuver", "manoeuvre", "metre", "centre", "colour")
"""Words of these that are the beginning of longer ones."""


@cache
def stem(word: str) -> str:
    """A word in one spelling, without the ending of a plural or a past."""
    if word.lstrip("-").isdigit():
        return str(int(word))
    for ending in ("ing", "ed", "es", "s"):
        if word.endswith(ending) and len(word) - len(ending) > 3 and not word.endswith(("eed", "ss", "us")):
            word = word.removesuffix(ending)
            break
    word = _SPELLINGS.get(word, word)
    for written in _SPELT_OTHERWISE:
        if word.startswith(written):
            return _SPELLINGS[written] + word[len(written) :]
    return word.removesuffix("e") if len(word) > 4 else word


def is_short_for(one: str, other: str) -> bool:
    """``temp`` and ``temperature``, ``nmbr`` and ``number``."""
    short, long = sorted((one, other), key=len)
    if short.isdigit() or long.isdigit() or len(short) < 3 or short[0] != long[0] or excluding(short) & {long}:
        return False
    is_without_vowels = len(short) < 5 and _VOWELS.sub("", short) == short
    return long.startswith(short) or (is_without_vowels and _VOWELS.sub("", long).startswith(short))


def is_slip(one: str, other: str) -> bool:
    """Return whether two words differ by a letter, as a typing error makes it."""
    if min(len(one), len(other)) < 3 or abs(len(one) - len(other)) > 1:
        return False
    short, long = sorted((one, other), key=len)
    if _DOUBLED.sub("", one) == _DOUBLED.sub("", other) and min(len(one), len(other)) > _LEAST_LETTERS:
        return True
    if len(short) == len(long):
        differing = [index for index in range(len(short)) if short[index] != long[index]]
        if len(differing) == 2 and differing[1] == differing[0] + 1:
            return sorted(short) == sorted(long)
        return len(differing) == 1 and len(short) > 4
    return any(long[:index] + long[index + 1 :] == short for index in range(len(long)))


def is_shortened(one: str, other: str) -> bool:
    """Return whether letters are missing within a long word: ``permant``."""
    short, long = sorted((one, other), key=len)
    rest = iter(long)
    is_near = len(short) > 5 and len(long) - len(short) <= 2 and short[0] == long[0]
    return is_near and all(letter in rest for letter in short)


def is_respelt(one: str, other: str) -> bool:
    """Return whether two words are one in another spelling, shortened, with a slip of the pen, or mean the same."""
    is_spelling = is_short_for(one, other) or is_slip(one, other) or is_shortened(one, other)
    return is_spelling or any(one in group and other in group for group in _synonyms())


@cache
def _synonyms() -> tuple[frozenset[str], ...]:
    return tuple(frozenset(map(stem, group)) for group in _SYNONYMS)


def is_negated(word: str, other: str) -> bool:
    """Return whether the other word is the opposite of one: ``unhealthy`` of ``healthy``."""
    return other in {f"{prefix}{word}" for prefix in ("un", "dis", "in", "non", "ab", "de")}


def excluding(word: str) -> frozenset[str]:
    """The words that exclude a word, all in one spelling."""
    return _excluded().get(word, frozenset())


@cache
def _excluded() -> dict[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    for group in exclusive_groups():
        for word in group:
            found[word] = found.get(word, frozenset()) | (group - {word})
    return found


@cache
def exclusive_groups() -> tuple[frozenset[str], ...]:
    """The words that exclude each other, in one spelling."""
    return tuple(frozenset(map(stem, group)) for group in _EXCLUDING)
