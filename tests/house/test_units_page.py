"""docs/units.md lists the symbols that the generator knows, with their prefixes."""

from pathlib import Path

from stated_units import STATED

from codegen.model.units.unit import Unit, symbols, unit_named
from codegen.model.units.unit_table import BASES, ONLY_WITH_PREFIX, PREFIXES, SYMBOLS, ZEROS

PAGE = Path(__file__).resolve().parents[2] / "docs" / "units.md"


def test_every_symbol_has_its_row():
    """In the order of the table that the generator reads, and no other rows."""
    text = PAGE.read_text(encoding="utf-8")
    assert [line for line in text.splitlines() if line.startswith("| `")] == [row(name) for name in SYMBOLS]
    assert sorted(PREFIXES) == sorted({prefix for prefix, _ in symbols().values()})


def test_every_unit_of_a_dialect_follows_from_the_rows():
    """By a symbol, a prefix, an operator or a scale, all of which the page explains."""
    assert [name for name in STATED if Unit.parse(name) is None] == []


def row(name: str) -> str:
    """Symbol, what it measures, what it is, prefixes."""
    amount, of, prefixes = SYMBOLS[name]
    is_base = name in BASES
    what = "" if is_base else f"{of} + {ZEROS[name]}" if name in ZEROS else f"{amount} {of}"
    shown = " ".join(f"`{prefix}{name}`" for prefix in prefixes.split())
    first = next(iter(prefixes.split())) if name in ONLY_WITH_PREFIX else ""
    spelled = f"{name}, only with a prefix" if name in ONLY_WITH_PREFIX else name
    symbol = f"`{name}`{spelled.removeprefix(name)}"
    return f"| {symbol} | {unit_named(first + name).kind} | {what} | {shown} |"
