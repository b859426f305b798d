"""The names that a document may mean, and which of them a name is like that is none."""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from difflib import get_close_matches
from functools import lru_cache, partial

from codegen.claims.enum_names import all_names, entries_by_start
from codegen.claims.parts.worded_units import worded_unit
from codegen.claims.reading import Reading
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.pattern import pattern

UPPER = pattern(
    r"(?<![\w.\-/])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+(?![\w\-/*]|\.[a-z]|\s*\((?!(?:id:? |ID |message |msg )?#?\d))"
)
"""Names in capitals of several words, that are no paths, calls or patterns."""
SHORT = 3
FAMILY = 5
"""Names that begin alike: then what they begin with is their family, and no misspelling of one of them."""
_ALIKE = 0.72
_SAME = 0.8


@dataclass(frozen=True, slots=True)
class Names:
    """All names that a document may mean: ``messages`` by name, ``known`` names of anything else in the dialects.

    ``fields`` has those of all messages that the document names: what one of them has is no misspelling. Nor is a new
    name of a message with a successor (``followed``), whose field it may be. ``entries`` are by the beginning that all
    of an enum share.
    """

    messages: Mapping[str, WireMessage]
    known: Collection[str]
    fields: Collection[str]
    followed: Collection[str]
    entries: Mapping[str, Sequence[str]]


def names_of(reading: Reading) -> Names:
    named = dict.fromkeys(name for _, name in reading.sightings)
    return Names(
        messages=reading.messages,
        known=all_names(reading.enums).union(each.name for each in reading.reference.listed),
        fields={field.name for name in named for field in reading.messages[name].fields},
        followed=set(_followed(reading)),
        entries=entries_by_start(reading.enums),
    )


def _followed(reading: Reading) -> Iterator[str]:
    """The messages that a document names a successor of which the dialect lacks: ``NAME_V2``; entries are none."""
    known = all_names(reading.enums)
    for passage in reading.prose.passages:
        for found in UPPER.finditer(passage.text):
            words = found[0].split("_") if found[0] not in reading.messages and found[0] not in known else []
            yield from (name for end in range(1, len(words)) if (name := "_".join(words[:end])) in reading.messages)


def near_message(name: str, names: Names) -> str | None:
    """The message that a name was meant for; None for what may be a message of its own."""
    return _nearness(names.messages)(name)


@once
def _nearness(messages: Mapping[str, WireMessage]) -> Callable[[str], str | None]:
    """Return what finds that message, once for each name: a document repeats its names."""
    return lru_cache(maxsize=1024)(partial(_near, tuple(messages)))


def _near(messages: Sequence[str], name: str) -> str | None:
    joined = name.replace("_", "")
    if "_" not in name:
        same = (known for known in messages if "_" in known and known.replace("_", "") == joined)
        alone = [known for known in messages if "_" not in known and len(known) > SHORT]
        return next(same, None) or next(iter(get_close_matches(name, alone, cutoff=_SAME)), None)
    *front, last = name.split("_")
    turned = [known for known in messages if sorted(known.split("_")) == sorted(name.split("_"))]
    if len(turned) == 1:
        return turned[0]
    kin = []
    for known in messages:
        *own_front, own_last = known.split("_")
        if known.replace("_", "") == joined:
            return known
        shorter, longer = sorted((last, own_last), key=len)
        if own_front == front and len(shorter) > 2 and longer.startswith(shorter):
            return known
        first, own_first = name.partition("_")[0], known.partition("_")[0]
        if first == own_first or (
            min(len(own_first), len(first)) > 2 and (own_first.startswith(first) or first.startswith(own_first))
        ):
            kin.append(known)
    begun = [known for known in kin if known.startswith(f"{name}_")]
    if len(begun) >= FAMILY:
        return None
    if begun:
        return begun[0]
    others = [known for known in kin if not name.startswith(f"{known}_")]  # or it is a successor
    return next(iter(get_close_matches(name, others, cutoff=_SAME)), None)


def is_unknown(name: str, names: Names) -> bool:
    return name not in names.messages and name not in names.known and not entry_start(name, names)


def entry_start(name: str, names: Names) -> str:
    """The beginning of the names of an enum's entries that a name has; the longest; empty for none."""
    words = name.split("_")
    starts = ("_".join(words[:end]) + "_" for end in range(len(words) - 1, 0, -1))
    return next((start for start in starts if start in names.entries), "")


def is_successor(name: str, names: Names) -> bool:
    """Return whether a name may be a new message: it extends the name of a known one, or is the stem of several."""
    words = name.split("_")
    return any("_".join(words[:end]) in names.messages for end in range(1, len(words))) or any(
        known.startswith(f"{name}_") for known in names.messages
    )


_SAME_WORDS = {
    word: words[0]
    for words in (
        ("lon", "lng", "long", "longitude"), ("lat", "latitude"), ("alt", "altitude", "height"), ("hdg", "heading"),
        ("temp", "temperature"), ("vel", "velocity", "speed"), ("curr", "current"), ("volt", "voltage"),
        ("press", "pressure", "baro"), ("dist", "distance"), ("acc", "accel", "acceleration"), ("sat", "satellites"),
        ("sys", "system"), ("comp", "component"), ("msg", "message"), ("seq", "sequence"), ("pos", "position"),
        ("batt", "battery"), ("cap", "capacity"), ("dir", "direction"), ("max", "maximum"), ("min", "minimum"),
    )
    for word in words
}  # fmt: skip
"""Words of names that stand for the same, each with the first of its group."""


def _plain_words(name: str) -> list[str]:
    return [_SAME_WORDS.get(word, word) for word in name.split("_")]


def same_field(name: str, message: WireMessage) -> list[str]:
    """The field that a name means in other words: `lon` for `lng`, or with a word of its message, `target_type`."""
    words = _plain_words(name)
    own = {word.lower() for word in message.name.split("_")}
    return [
        field.name
        for field in message.fields
        if _plain_words(field.name) == words or (words[0] in own and _plain_words(field.name) == words[1:])
    ][:1]


def near_fields(name: str, message: WireMessage) -> list[str]:
    """The field that a name is like, letter by letter or in all its words."""
    own = [field.name for field in message.fields]
    if same := same_field(name, message):
        return same
    near = get_close_matches(name, own, n=1, cutoff=_ALIKE)
    words = set(name.split("_"))
    return near or [each for each in own if len(words) > 1 and words == set(each.split("_"))][:1]


def is_of_field(name: str, fields: Collection[str]) -> bool:
    """Return whether a name is that of a field, or that of a variable that has the field in a unit: ``heading_deg``."""
    stem, _, unit = name.rpartition("_")
    return name in fields or (stem in fields and worded_unit(unit) is not None)
