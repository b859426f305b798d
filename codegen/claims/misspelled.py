"""Names that are one of a dialect with its words in another order, without a letter, or beside its id."""

from collections.abc import Callable, Iterable, Mapping
from difflib import get_close_matches
from functools import lru_cache, partial

from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.pattern import pattern


def is_spelled_so(name: str, known: Iterable[str]) -> bool:
    """Return whether a name of several words was meant for one that is known."""
    words = sorted(name.split("_"))
    return len(words) > 1 and any(
        sorted(each.split("_")) == words or _lacks_one(*sorted((each, name), key=len))
        for each in known
        if each[0] == name[0]
    )


def _lacks_one(short: str, long: str) -> bool:
    """Return whether the short name is the long one without one letter; versions differ by a digit, which is none."""
    if len(long) - len(short) != 1:
        return False
    at = next((at for at, (one, other) in enumerate(zip(short, long, strict=False)) if one != other), len(short))
    return short[at:] == long[at + 1 :] and long[at].isalpha()


def numbered_message(
    text: str, start: int, end: int, messages: Mapping[str, WireMessage], below: int | None = None
) -> str | None:
    """The message whose id stands beside a name that is like its own, or ``below`` it."""
    behind, before = _ID_BEHIND.match(text, end), _ID_BEFORE.search(text, 0, start)
    ids = {int(each["id"]) for each in (behind, before) if each is not None} | ({below} if below is not None else set())
    if not ids:
        return None
    name = text[start:end]
    alike = [known for known, message in messages.items() if message.id in ids and _is_alike(name, known)]
    return alike[0] if len(alike) == 1 else None


def _is_alike(name: str, known: str) -> bool:
    """Return whether a name shares its first word or half of all words with a known one, or is spelled nearly so."""
    words, own = name.split("_"), known.split("_")
    shared = len(set(words) & set(own))
    return len(words) > 1 and (
        words[0] == own[0] or 2 * shared >= len(own) or bool(get_close_matches(name, [known], n=1, cutoff=_CLOSE))
    )


_CLOSE = 0.7
_ID_BEHIND = pattern(
    r"`? ?(?:\(|\|| is | has the id |, )(?:id |ID |#)?\s*(?P<id>\d{1,5})(?=[).,;| ]|$)(?! ?(?:Hz|bytes|B\b))"
)
_ID_BEFORE = pattern(r"(?:^\s*\||[(#]) ?(?P<id>\d{1,5}) ?[|:,)]? ?`?$")


def shortened_message(name: str, messages: Mapping[str, WireMessage]) -> str | None:
    """Return the only message whose name is this one with other underscores, or with words more in its middle."""
    return _lengthening(messages)(name)


@once
def _lengthening(messages: Mapping[str, WireMessage]) -> Callable[[str], str | None]:
    """Return what finds that message, once for each name: a document repeats its names."""
    return lru_cache(maxsize=1024)(partial(_lengthened, tuple(messages)))


def _lengthened(known: Iterable[str], name: str) -> str | None:
    words = name.split("_")
    joined = "".join(words)
    found = [
        each
        for each in known
        if each.replace("_", "") == joined or (len(words) >= _LONG and _is_within(words, each.split("_")))
    ]
    return found[0] if len(words) > 1 and len(found) == 1 else None


def _is_within(words: list[str], own: list[str]) -> bool:
    """Return whether words occur in a name in the same order, its first and its last word among them."""
    rest = iter(own)
    return words[0] == own[0] and words[-1] == own[-1] and all(word in rest for word in words)


_LONG = 3
"""Words of a name that is hardly that of anything else."""
