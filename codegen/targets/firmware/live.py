"""Views of the fields that a builder writes on every build."""

import math
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from codegen.model.dialect import Kind
from codegen.model.spec import Rounding
from codegen.model.system import Binding, FlagsBinding, LiveBinding, Parameter, Quantity, SplitBinding
from codegen.targets.naming import number, parameter_attribute


@dataclass(frozen=True, slots=True)
class LiveView:
    """A field that is written on every build."""

    comment: str
    source: str
    code: str
    offset: int
    unknown: str | None
    unknown_comment: str
    before: tuple[str, str] | None
    scale: tuple[str, int, int] | None
    low: str
    high: str
    hole: str | None
    beside: str
    divisor: str | None


@dataclass(frozen=True, slots=True)
class SpillView:
    """An array field over which one value is spread on every build."""

    comment: str
    source: str
    code: str
    offset: int
    size: int
    cells: int
    stand_in: str | None
    low: int
    high: int
    before: tuple[str, str] | None
    scale: tuple[str, int, int] | None
    cell_high: int
    unused: int


@dataclass(frozen=True, slots=True)
class FlagByteView:
    """A byte of a bitmask some bits of which depend on the state."""

    comment: tuple[str, ...]
    offset: int
    expression: str


def live_views(binding: Binding) -> Iterator[LiveView | SpillView | FlagByteView]:
    """What is written on every build for one binding; nothing for what is known at build time."""
    if isinstance(binding, LiveBinding):
        yield _float_view(binding) if binding.covers.field.type.kind is Kind.FLOAT else _integer_view(binding)
    elif isinstance(binding, SplitBinding):
        yield _spill_view(binding)
    elif isinstance(binding, FlagsBinding):
        yield from _flag_bytes(binding)


def _comment(binding: LiveBinding | SplitBinding) -> str:
    covers, source = binding.covers, binding.source
    units = covers.field.definition.units
    kept = source.stored.name if isinstance(source, Quantity) else source.unit.name
    spread = f", spilling above {binding.cell_high}" if isinstance(binding, SplitBinding) else ""
    target = f"{covers.label} [{units}]" if units else covers.label
    origin = f"{source.path} [{kept}]" if kept and kept != units else source.path
    return f"{target}: {origin}{spread} ({covers.citation})"


def _source(source: Quantity | Parameter) -> str:
    if isinstance(source, Parameter):
        return f"state.parameters.{parameter_attribute(source.name)}"
    return f"{source.component}.{source.attribute}"


def _scale(factor: Fraction, rounding: Rounding) -> tuple[str, int, int] | None:
    return None if factor == 1 else (rounding.value, factor.numerator, factor.denominator)


def _before(factor: Fraction, low: Fraction, high: Fraction) -> tuple[str, str] | None:
    """Limits in stored steps, one step wider than the field, that keep the product of the scaling small."""
    if factor == 1:
        return None
    return str(math.floor(low / factor) - 1), str(math.ceil(high / factor) + 1)


def _stand_in(source: Quantity | Parameter) -> str | None:
    initial = source.initial if isinstance(source, Quantity) else None
    return None if initial is None else str(initial)


def _integer_view(binding: LiveBinding) -> LiveView:
    assert binding.unknown is None or isinstance(binding.unknown, int)
    unknown = _stand_in(binding.source) if binding.unknown is None else str(binding.unknown)
    return LiveView(
        comment=_comment(binding),
        source=_source(binding.source),
        code=f"<{binding.covers.field.type.code}",
        offset=binding.covers.offset,
        unknown=unknown,
        unknown_comment="unknown" if binding.unknown is not None else "until it is set",
        before=_before(binding.factor, binding.low, binding.high),
        scale=_scale(binding.factor, binding.rounding),
        low=str(binding.low),
        high=str(binding.high),
        hole=None if binding.hole is None else str(binding.hole),
        beside=str(binding.beside),
        divisor=None,
    )


def _float_view(binding: LiveBinding) -> LiveView:
    """A float field: everything up to the last division happens in stored steps."""
    factor = binding.factor
    unknown = _stand_in(binding.source) if binding.unknown is None else number(binding.unknown)
    if binding.unknown is None and isinstance(binding.source, Quantity) and binding.source.initial is not None:
        unknown = repr(float(binding.source.initial * factor))
    low, high = math.ceil(binding.low / factor), math.floor(binding.high / factor)
    hole = None if binding.hole is None else binding.hole / factor
    divided = f" * {factor.numerator}" if factor.numerator != 1 else ""
    return LiveView(
        comment=_comment(binding),
        source=_source(binding.source),
        code=f"<{binding.covers.field.type.code}",
        offset=binding.covers.offset,
        unknown=unknown,
        unknown_comment="unknown" if binding.unknown is not None else "until it is set",
        before=None,
        scale=None,
        low=str(low),
        high=str(high),
        hole=str(hole) if hole is not None and hole.denominator == 1 else None,
        beside="" if binding.beside is None else str(binding.beside / factor),
        divisor=f"{divided} / {factor.denominator}",
    )


def _spill_view(binding: SplitBinding) -> SpillView:
    low, high = Fraction(binding.low), Fraction(binding.high)
    return SpillView(
        comment=_comment(binding),
        source=_source(binding.source),
        code=f"<{binding.covers.field.type.code}",
        offset=binding.covers.offset,
        size=binding.covers.field.type.size,
        cells=binding.covers.count,
        stand_in=_stand_in(binding.source),
        low=binding.low,
        high=binding.high,
        before=_before(binding.factor, low, high),
        scale=_scale(binding.factor, binding.rounding),
        cell_high=binding.cell_high,
        unused=binding.unused,
    )


def _flag_bytes(binding: FlagsBinding) -> Iterator[FlagByteView]:
    covers = binding.covers
    size = covers.field.type.size
    terms: dict[int, list[str]] = {}
    words = []
    for name, value, quantity in binding.conditional:
        words.append(f"{name} if {quantity.path}")
        for index, byte in enumerate(struct.pack("<Q", value)[:size]):
            if byte:
                source = f"{quantity.component}.{quantity.attribute}"
                terms.setdefault(index, []).append(f"({byte:#04x} if {source} else 0)")
    comment = _flag_comment(f"{covers.label}:", words, f"({covers.citation})")
    for index in sorted(terms):
        always = struct.pack("<Q", binding.mask)[index]
        parts = [f"{always:#04x}"] * bool(always) + terms[index]
        expression = " | ".join(parts) if len(parts) > 1 else parts[0].strip("()")
        yield FlagByteView(comment, covers.offset + index, expression)
        comment = ()


def _flag_comment(label: str, words: list[str], citation: str) -> tuple[str, ...]:
    """One line, or, where that gets long, a line for each flag."""
    line = f"{label} {', '.join(words)} {citation}"
    return (line,) if len(line) < 100 else (f"{label} {citation}", *(f"  {word}" for word in words))
