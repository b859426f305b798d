"""Names that are one of a dialect with its words in another order, without a letter, or beside its id."""

import re
from collections.abc import Iterable, Mapping

from codegen.model.dialect.dialect import WireMessage


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


def numbered_message(text: str, start: int, end: int, messages: Mapping[str, WireMessage]) -> str | None:
    """The message whose id stands beside a name that begins as its own does."""
    behind, before = _ID_BEHIND.match(text, end), _ID_BEFORE.search(text, 0, start)
    ids = {int(each["id"]) for each in (behind, before) if each is not None}
    words = text[start:end].split("_")
    alike = [
        known
        for known, message in messages.items()
        if message.id in ids and len(words) > 1 and known.split("_")[: len(words) - 1] == words[:-1]
    ]
    return alike[0] if len(alike) == 1 else None


_ID_BEHIND = re.compile(
    r"`? ?(?:\(|\|| is | has the id |, )(?:id |ID |#)?\s*(?P<id>\d{1,5})(?=[).,;| ]|$)(?! ?(?:Hz|bytes|B\b))"
)
_ID_BEFORE = re.compile(r"(?:^\s*\||[(#]) ?(?P<id>\d{1,5}) ?[|:,)]? ?`?$")
