"""Names that are one of a dialect with its words in another order, or without a letter."""

from collections.abc import Iterable


def is_spelled_so(name: str, known: Iterable[str]) -> bool:
    """Return whether a name of several words was meant for one that is known."""
    words = sorted(name.split("_"))
    return len(words) > 1 and any(
        sorted(each.split("_")) == words or _lacks_one(*sorted((each, name), key=len))
        for each in known
        if each[0] == name[0]
    )


def _lacks_one(short: str, long: str) -> bool:
    """Whether a name is another one without one of its letters; versions differ by a digit."""
    if len(long) - len(short) != 1:
        return False
    at = next((at for at, (one, other) in enumerate(zip(short, long, strict=False)) if one != other), len(short))
    return short[at:] == long[at + 1 :] and long[at].isalpha()
