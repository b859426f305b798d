"""How alike two names or two texts are: a respelling, a better text, or words for something else."""

import re
from collections.abc import Collection, Iterable
from enum import StrEnum
from functools import cache

_PARTS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
_WORD = re.compile(r"[a-z]+|\d+(?:\.\d+)?")
_SIGNED = re.compile(r"[a-z]+|-?\d+")
_CLAUSE = re.compile(r"[,;.()/]|\band\b|\bor\b|\belse\b|\botherwise\b")
_VOWELS = re.compile(r"(?<=.)[aeiou]")

_PLACEHOLDERS = frozenset({"empty", "reserved", "unused", "none", "undefined", "unset", "spare", "n/a", "tbd"})


def _words(text: str) -> list[str]:
    return text.split()


_IDLE = frozenset(
    _words(
        "a an and are as at be by for from if in into is it its of on or that the this to was were where which with "
        "will can may must should set use used using value values parameter param future"
    )
)
_FILLING = frozenset({"0", "nan", "zero", "send", "all", "remaining", "params", "parameters", "ignored", "yet"})
_GENERAL = frozenset(_words("mav type mode status state flag id comp kind option enum instance index number"))
_TURNING = frozenset({"counter", "anti", "not", "clockwis", "no"})
_NEGATING = frozenset({"not", "no", "non", "un", "dis", "in", "never"})

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
    ("voltage", "current", "power"),
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
    "cable": "line", "dist": "distance", "acc": "accuracy", "est": "estimate", "calib": "calibration",
}  # fmt: skip

_SPELT_OTHERWISE = ("manoeuver", "manoeuvre", "metre", "centre", "colour")
"""Words of these that are the beginning of longer ones."""


class Likeness(StrEnum):
    """How alike two wordings are.

    UNSAID: at least one says nothing. NEAR: most words of one are in the other. VAGUE: some are. OPPOSITE: a word is
    replaced by one that excludes it; DISPUTED: so it is, but much else is another, too.
    """

    SAME = "same"
    NEAR = "near"
    VAGUE = "vague"
    UNSAID = "unsaid"
    OTHER = "other"
    DISPUTED = "disputed"
    OPPOSITE = "opposite"


def name_likeness(old: str, new: str, whole: str = "") -> Likeness:
    """How alike two names are, whatever prefix they have; ``whole`` is the name of the enum that they belong to.

    Letters of another case, prefixes, abbreviations, plurals and the order of words are no difference. NEAR is a name
    that says less or more than the other, or differs by a letter.
    """
    around = {*_names(whole), *_GENERAL}
    before, after = _without(_names(old), around), _without(_names(new), around)
    texts = [("".join(side), "".join(part)) for side, part in ((before, _names(old)), (after, _names(new)))]
    if sorted(before) == sorted(after) or any(one == other for one, other in zip(*texts, strict=True)):
        return Likeness.SAME
    if _is_opposed(*_unmatched(_names(old), _names(new)), is_text=True):
        return Likeness.OPPOSITE  # though a word of it may be one of the prefix, too
    gone, come = _unmatched(before, after)
    if _is_opposed(gone, come):
        return Likeness.OPPOSITE
    if not gone and not come:
        return Likeness.NEAR  # by abbreviations, which may be other words: auto, autotune
    if not gone or not come:
        return Likeness.NEAR if len(before) != len(gone) or len(after) != len(come) else Likeness.OTHER
    if any(word.isdigit() for word in (*gone, *come)):
        return Likeness.OTHER
    if len(gone) == len(come) == 1 and _is_slip(gone[0], come[0]):
        return Likeness.NEAR
    if set(_names(old)) <= _GENERAL or set(_names(new)) <= _GENERAL:
        return Likeness.VAGUE
    shared = [word for word in before if word not in gone and len(word) > 3]
    return Likeness.VAGUE if shared else Likeness.OTHER


def text_likeness(old: str, new: str) -> Likeness:
    """How alike two texts are, by their words without those that carry nothing."""
    if is_unsaid(old) or is_unsaid(new):
        return Likeness.UNSAID
    before, after = words_of(old), words_of(new)
    if _are_exchanged(old, new):
        return Likeness.OPPOSITE
    if before == after:
        return Likeness.DISPUTED if _is_reordered(old, new) else Likeness.SAME
    gone, come = _unmatched(sorted(before - after), sorted(after - before))
    common = min(len(before) - len(gone), len(after) - len(come))
    least = min(len(before), len(after))
    if not least:
        return Likeness.UNSAID
    share = common / least
    if _is_opposed(gone, come, is_text=True):
        return Likeness.OPPOSITE if share >= 0.5 or least <= 3 else Likeness.DISPUTED
    if share >= 0.6 and not any(word.isdigit() for word in gone):
        return Likeness.NEAR
    return Likeness.VAGUE if share >= 0.3 else Likeness.OTHER


def is_replaced(names: tuple[str, str], texts: tuple[str, str]) -> bool:
    """Whether both name and text have one word in place of another, and it is the same one in both."""
    of_names = _unmatched(*(_names(name) for name in names))
    of_texts = _unmatched(*(sorted(words_of(text)) for text in texts))
    return all(not set(one).isdisjoint(other) for one, other in zip(of_names, of_texts, strict=True))


def other_word(old: str, new: str) -> tuple[str, str] | None:
    """The one word in which two texts differ, where the second has another word in its place and not a respelling."""
    before, after = (
        [word for word in _WORD.findall(text.lower().replace("re-", "re")) if word not in _IDLE] for text in (old, new)
    )
    if len(before) != len(after):
        return None
    differing = [pair for pair in zip(before, after, strict=True) if _stem(pair[0]) != _stem(pair[1])]
    if len(differing) != 1 or any(word.isdigit() for word in differing[0]):
        return None
    one, other = (_stem(word) for word in differing[0])
    is_respelt = _is_short_for(one, other) or _is_slip(one, other) or _is_shortened(one, other)
    return None if is_respelt else differing[0]


def _are_exchanged(old: str, new: str) -> bool:
    """Whether both texts tell of the same things and numbers, but put others of them together.

    ``positive is clockwise, negative is counter-clockwise`` and the reverse have the same words.
    """
    sides = [[_telling(clause) for clause in _CLAUSE.split(text.lower())] for text in (old, new)]
    before, after = ([clause for clause in side if len(clause) > 1] for side in sides)
    if len(before) < 2 or len(before) != len(after):
        return False
    same_words = sorted(word for clause in before for word in clause) == sorted(
        word for clause in after for word in clause
    )
    return same_words and sorted(map(sorted, before)) != sorted(map(sorted, after))


def _is_reordered(old: str, new: str) -> bool:
    """Whether texts of the same words list things of one kind in another order: ``w, x, y, z`` and ``x, y, z, w``."""
    sides = [[_stem(word) for word in _WORD.findall(text.lower())] for text in (old, new)]
    for group in _stemmed():
        before, after = ([word for word in side if word in group] for side in sides)
        if len(set(before)) > 2 and before != after and sorted(before) == sorted(after):
            return True
    return False


def _telling(clause: str) -> tuple[str, ...]:
    """The numbers of a clause, and its words that exclude others."""
    words = (_stem(word) for word in _SIGNED.findall(clause))
    return tuple(word for word in words if word.lstrip("-").isdigit() or word in _TURNING or _excluding(word))


def is_unsaid(text: str) -> bool:
    """Whether a text says nothing: there is none, or it says that the thing is empty or reserved."""
    words = _WORD.findall(text.lower())
    return not words or (words[0] in _PLACEHOLDERS and all(word in _PLACEHOLDERS | _IDLE | _FILLING for word in words))


def says_reserved(name: str) -> bool:
    """Whether a name says that the number means nothing (yet)."""
    return not {"reserved", "unused", "spare", "empty"}.isdisjoint(_plain(name))


def says_private(name: str, text: str) -> bool:
    """Whether a number is for anybody's own use."""
    found = {*_plain(name), *_WORD.findall(text.lower())}
    return not {"user", "private", "custom", "privately"}.isdisjoint(found)


def names_of(text: str, names: Iterable[str]) -> bool:
    """Whether a text has any of some names as they are written."""
    return any(re.search(rf"(?<!\w){re.escape(name)}(?!\w)", text) for name in names)


def words_of(text: str) -> set[str]:
    """The words of a text that carry something, in one spelling."""
    return {_stem(word) for word in _WORD.findall(text.lower()) if word not in _IDLE}


@cache
def _names(name: str) -> tuple[str, ...]:
    return tuple(_stem(part.lower()) for part in _PARTS.findall(name))


def _plain(name: str) -> set[str]:
    return {part.lower() for part in _PARTS.findall(name)}


def _without(words: Iterable[str], around: Collection[str]) -> list[str]:
    words = list(words)
    return [word for word in words if word not in around] or words[-1:]


@cache
def _stem(word: str) -> str:
    """A word in one spelling, without the ending of a plural or a past."""
    if word.lstrip("-").isdigit():
        return str(int(word))
    for ending in ("ing", "ed", "es", "s"):
        if word.endswith(ending) and len(word) - len(ending) > 3 and not word.endswith(("eed", "ss", "us")):
            word = word.removesuffix(ending)
            break
    if word in _SPELLINGS:
        return _SPELLINGS[word]
    for written in _SPELT_OTHERWISE:
        if word.startswith(written):
            return _SPELLINGS[written] + word[len(written) :]
    return word.removesuffix("e") if len(word) > 4 else word


def _unmatched(before: Iterable[str], after: Iterable[str]) -> tuple[list[str], list[str]]:
    """What each side has that the other does not have in any spelling."""
    gone, come = [], list(after)
    for word in before:
        match = next((other for other in come if other == word), None) or next(
            (other for other in come if _is_short_for(word, other)), None
        )
        if match is None:
            gone.append(word)
        else:
            come.remove(match)
    return gone, come


def _is_short_for(one: str, other: str) -> bool:
    """``temp`` and ``temperature``, ``cfg`` and ``config``."""
    short, long = sorted((one, other), key=len)
    if short.isdigit() or long.isdigit() or len(short) < 3 or short[0] != long[0] or _excluding(short) & {long}:
        return False
    return long.startswith(short) or (len(short) < 5 and _VOWELS.sub("", long).startswith(_VOWELS.sub("", short)))


def _is_slip(one: str, other: str) -> bool:
    """Whether two words differ by a letter, as a typing error makes it."""
    if min(len(one), len(other)) < 3 or abs(len(one) - len(other)) > 1:
        return False
    short, long = sorted((one, other), key=len)
    if len(short) == len(long):
        differing = [index for index in range(len(short)) if short[index] != long[index]]
        if len(differing) == 2 and differing[1] == differing[0] + 1:
            return sorted(short) == sorted(long)
        return len(differing) == 1 and len(short) > 4
    return any(long[:index] + long[index + 1 :] == short for index in range(len(long)))


def _is_shortened(one: str, other: str) -> bool:
    """Whether letters are missing within a long word: ``permant``."""
    short, long = sorted((one, other), key=len)
    rest = iter(long)
    is_near = len(short) > 5 and len(long) - len(short) <= 2 and short[0] == long[0]
    return is_near and all(letter in rest for letter in short)


def _is_opposed(gone: Collection[str], come: Collection[str], *, is_text: bool = False) -> bool:
    if any(not _excluding(word).isdisjoint(come) for word in gone):
        return True
    if is_text:
        return False
    for one, other in ((gone, come), (come, gone)):
        if not one and not _NEGATING.isdisjoint(other):
            return True
    return any(_is_negated(word, other) or _is_negated(other, word) for word in gone for other in come)


def _is_negated(word: str, other: str) -> bool:
    return other in {f"{prefix}{word}" for prefix in ("un", "dis", "in", "non", "ab", "de")}


@cache
def _excluding(word: str) -> frozenset[str]:
    return frozenset(other for group in _stemmed() if word in group for other in group if other != word)


@cache
def _stemmed() -> tuple[frozenset[str], ...]:
    return tuple(frozenset(map(_stem, group)) for group in _EXCLUDING)


_LONGEST = 20
_STATED = re.compile(r"(?<![\w.])(-?\d+)\s*(?:[:=]|means\b|is\b)\s*([A-Za-z][^,;.:=()\[\]\n\d]*)")


def stated_values(text: str) -> dict[int, str]:
    """What a text says of single numbers: ``0: forward, 1: reverse``."""
    found: dict[int, str] = {}
    for one in _STATED.finditer(text):
        number, words = one[1], one[2].strip()
        if len(number) < _LONGEST:
            found[int(number)] = f"{found[int(number)]}, {words}" if int(number) in found else words
    return found
