"""Finds the unit that was probably meant by a spelling that is none."""

import re
from collections.abc import Iterable, Iterator
from difflib import get_close_matches

from codegen.model.units.unit import Unit, symbols
from codegen.model.units.unit_table import PREFIX_WORDS, SCALED, SHOWN, WORDS

_OPERATORS = re.compile(r"([*/]|\^-?\d)")
_POWER = re.compile(r"([A-Za-z])([2-9])(?![0-9])")
_EXAMPLES = "V, mA, degC, m/s, degE7"
_LONGEST = 60


def nearest_unit(written: str) -> str:
    """A hint with the nearest units: the dialects' spelling of a word, other capitals, a letter more or less."""
    text = written.strip()[:_LONGEST]
    for plain, spelled in ((" ", ""), ("**", "^"), ("\u00b2", "^2"), ("\u00b3", "^3"), ("\u00b5", "u")):
        text = text.replace(plain, spelled)
    found = list(dict.fromkeys(_candidates(text)))[:3]
    return f"did you mean {' or '.join(found)}?" if found else f"units are spelled as in the dialects: {_EXAMPLES}"


def worded_unit(written: str) -> Unit | None:
    """The unit of a symbol or of a word for one, millimetres; None for what is neither, or could be two."""
    text = written.strip()[:_LONGEST].replace("\u00b5", "u").replace("\u00b2", "^2").replace("\u00b3", "^3")
    found = Unit.parse(text) or Unit.parse(_POWER.sub(r"\1^\2", text))
    if found is not None or not text:
        return found
    folded = text.casefold()
    for word, prefix in PREFIX_WORDS.items():
        if folded.startswith(word):
            for name in _worded(folded.removeprefix(word)):
                if prefix + name in symbols():
                    return Unit.parse(prefix + name)
    names = list(dict.fromkeys(_worded(folded)))
    if len(names) == 1:
        return Unit.parse(names[0])
    per = re.fullmatch(r"(\w+|\u00b0)(?:\s+per\s+|/)(\w+)", folded)
    parts = [worded_unit(part) for part in per.groups()] if per else []
    return Unit.parse("/".join(part.name for part in parts if part)) if parts and all(parts) else None


def _candidates(text: str) -> Iterator[str]:
    names = [*symbols(), *SHOWN, *SCALED]
    powers = _POWER.sub(r"\1^\2", text)  # m/s2
    yield from (spelling for spelling in (text, powers) if Unit.parse(spelling))
    yield from _same(text, names)
    yield from _by_parts(powers)
    yield from _near(text, names)


def _same(text: str, names: Iterable[str]) -> Iterator[str]:
    """Yield what a word means, and what differs from the text in capitals only."""
    folded = text.casefold()
    yield from _worded(folded)
    for word, prefix in PREFIX_WORDS.items():
        if folded.startswith(word):
            yield from (prefix + name for name in _worded(folded.removeprefix(word)) if prefix + name in symbols())
    yield from (name for name in names if name.casefold() == folded)


def _worded(folded: str) -> Iterator[str]:
    """The symbol for a word, also for several of it."""
    yield from (WORDS[word] for word in (folded, folded.removesuffix("s")) if word in WORDS)


def _near(text: str, names: Iterable[str]) -> Iterator[str]:
    """Yield what is spelled almost so, or is a word that is."""
    yield from (WORDS.get(name, name) for name in get_close_matches(text, [*names, *WORDS], n=3, cutoff=0.6))


def _by_parts(text: str) -> Iterator[str]:
    """A compound with the nearest symbol in place of each part that is not known."""
    parts = _OPERATORS.split(text)
    if len(parts) == 1:
        return
    meant = "".join(
        part if not part or _OPERATORS.fullmatch(part) or Unit.parse(part) else _meant(part) for part in parts
    )
    if Unit.parse(meant):
        yield meant


def _meant(part: str) -> str:
    """The symbol nearest to a part; the part itself where none is near."""
    return next(iter([*_same(part, symbols()), *_near(part, symbols())]), part)
