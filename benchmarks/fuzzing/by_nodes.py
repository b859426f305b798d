"""Faults of YAML: values of other types, keys of other places, entries that are missing, doubled or thousands."""

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache

import yaml

from fuzzing.by_bytes import by_bytes
from fuzzing.hostile import AMOUNTS, EVERYTHING, NAMES, NODES, NUMBERS, PATHS
from fuzzing.samples import samples

_MANY = (150, 3000, 10_000)


@dataclass(frozen=True)
class Part:
    """A key, a value or an entry with both, from one character of a text to another."""

    kind: str
    start: int
    end: int
    is_flow: bool = False


@lru_cache(maxsize=400)
def parts_of(text: str) -> tuple[Part, ...]:
    """Return the parts of a text, in no order that means anything; none where it is no YAML."""
    try:
        root = yaml.compose(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    except (yaml.YAMLError, ValueError, RecursionError):
        return ()
    return () if root is None else tuple(_parts(root, text))


def _parts(root: yaml.Node, text: str) -> Iterator[Part]:
    waiting, seen = [root], set()
    while waiting:
        node = waiting.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        yield Part("value" if isinstance(node, yaml.ScalarNode) else "inner", *_span(node, text))
        if isinstance(node, yaml.SequenceNode):
            waiting += node.value
        elif isinstance(node, yaml.MappingNode):
            for key, value in node.value:
                waiting.append(value)
                yield Part("key", *_span(key, text))
                yield Part("entry", _span(key, text)[0], _span(value, text)[1], bool(node.flow_style))


def _span(node: yaml.Node, text: str) -> tuple[int, int]:
    start, end = node.start_mark.index, node.end_mark.index
    return start, start + len(text[start:end].rstrip())


@lru_cache(maxsize=1)
def _pool() -> dict[str, tuple[str, ...]]:
    """Return what all samples have as keys, values and entries."""
    found: dict[str, set[str]] = {"key": set(), "value": set(), "inner": set()}
    for sample in samples():
        for path, data in sample.files.items():
            if path.endswith(".yaml"):
                text = data.decode()
                for part in parts_of(text):
                    if part.kind in found and part.end - part.start < 400:
                        found[part.kind].add(text[part.start : part.end])
    return {kind: tuple(sorted(texts)) for kind, texts in found.items()}


def by_nodes(data: bytes, lot: random.Random) -> bytes:
    """Return the file with one fault."""
    text = data.decode("utf-8", "surrogateescape")
    parts = parts_of(text)
    if not parts:
        return by_bytes(data, lot)
    kinds = (
        _value,
        _value,
        _value,
        _foreign,
        _foreign,
        _key,
        _key,
        _entry,
        _entry,
        _exchanged,
        _many,
        _nested,
        _bomb,
        _scaled,
    )
    changed = lot.choice(kinds)(text, parts, lot)
    return changed.encode("utf-8", "surrogateescape")


_Parts = tuple[Part, ...]


def _drawn(parts: _Parts, lot: random.Random, *kinds: str) -> Part:
    return lot.choice([part for part in parts if part.kind in kinds] or list(parts))


def _put(text: str, part: Part, new: str) -> str:
    return text[: part.start] + new + text[part.end :]


def _value(text: str, parts: _Parts, lot: random.Random) -> str:
    """Put something hostile in place of a value."""
    part = _drawn(parts, lot, "value", "value", lot.choice(("value", "value", "inner")))
    return _put(text, part, lot.choice(lot.choice((NUMBERS, AMOUNTS, NAMES, PATHS, NODES, EVERYTHING))))


def _foreign(text: str, parts: _Parts, lot: random.Random) -> str:
    """Put what is right elsewhere in place of a value."""
    part = _drawn(parts, lot, "value", "inner")
    return _put(text, part, lot.choice(_pool()[lot.choice(("value", "value", "key", "inner"))]))


def _key(text: str, parts: _Parts, lot: random.Random) -> str:
    known = _pool()["key"]
    return _put(text, _drawn(parts, lot, "key"), lot.choice(known if lot.random() < 0.6 else EVERYTHING))


def _entry(text: str, parts: _Parts, lot: random.Random) -> str:
    """Leave an entry out, write it twice, or add one that belongs elsewhere."""
    part = _drawn(parts, lot, "entry")
    here = text[part.start : part.end]
    kind = lot.randrange(3)
    if kind == 0:
        return _put(text, part, "")
    if kind == 1:
        return _put(text, part, here + _apart(text, part) + here)
    return _put(text, part, f"{here}{_apart(text, part)}{lot.choice(_pool()['key'])}: {lot.choice(_pool()['value'])}")


def _apart(text: str, part: Part) -> str:
    """Return what stands between two entries."""
    if part.is_flow:
        return ", "
    return "\n" + " " * (part.start - (text.rfind("\n", 0, part.start) + 1))


def _exchanged(text: str, parts: _Parts, lot: random.Random) -> str:
    first, second = sorted(
        (_drawn(parts, lot, "value", "inner"), _drawn(parts, lot, "value", "inner")), key=lambda part: part.start
    )
    if first.end > second.start:
        return _put(text, first, "")
    between = text[first.end : second.start]
    swapped = text[second.start : second.end] + between + text[first.start : first.end]
    return text[: first.start] + swapped + text[second.end :]


def _many(text: str, parts: _Parts, lot: random.Random) -> str:
    """Write an entry thousands of times under other names."""
    part = _drawn(parts, lot, "entry")
    here = text[part.start : part.end]
    count = min(lot.choice(_MANY), 2_000_000 // max(1, len(here)))
    return _put(text, part, here + "".join(f"{_apart(text, part)}N{number}{here}" for number in range(count)))


def _nested(text: str, parts: _Parts, lot: random.Random) -> str:
    part = _drawn(parts, lot, "value", "inner")
    deep = lot.choice((1, 2, 40, 70, 5000))
    before, after = lot.choice((("[", "]"), ("{a: ", "}"), ("- ", ""), ("? ", "")))
    return _put(text, part, before * deep + text[part.start : part.end] + after * deep)


def _bomb(text: str, parts: _Parts, lot: random.Random) -> str:
    """Write a list of lists that would have a thousand million items, or one that has itself in it."""
    lines = ['a0: &a0 ["x", "x"]', *(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 10))]
    new = lot.choice(("\n".join(lines), "x: &x [*x]", "x: &x {y: *x}", "<<: &x {<<: *x}"))
    return f"{new}\n{text}" if lot.random() < 0.5 else _put(text, _drawn(parts, lot, "value"), "&x [*x, *x]")


def _scaled(text: str, parts: _Parts, lot: random.Random) -> str:
    """Make a number another one."""
    numbers = [
        part for part in parts if part.kind == "value" and text[part.start : part.end].strip("+-.0123456789") == ""
    ]
    if not numbers:
        return _value(text, parts, lot)
    part = lot.choice(numbers)
    here = text[part.start : part.end]
    return _put(
        text, part, lot.choice(("-" + here, here + "0" * lot.choice((1, 3, 9, 30, 400)), "0." + here, here + ".5", "0"))
    )


Fault = Callable[[bytes, random.Random], bytes]
