"""The common part of answers that take a number and scale it: their words, their bytes, their cases."""

import math
from collections.abc import Iterator
from fractions import Fraction

from codegen.model.answers.account import Aspect, ReadBack, StateCase, Trait
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known
from codegen.model.answers.scaling import Scaling
from codegen.model.answers.step import Step
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.spec.population import Rounding
from codegen.model.units.affine import AffineMap
from codegen.model.units.unit import NUMBER, conversion, decimal, map_words, shortly
from codegen.model.vehicle import Parameter, Quantity, QuantityKind

_ROUNDING = {
    Rounding.NEAREST: "to nearest",
    Rounding.DOWN: "down",
    Rounding.UP: "up",
    Rounding.TOWARD_ZERO: "toward zero",
}

LONGEST = 24
"""So many characters a limit may take as a decimal number; the largest of 64 bits takes 20."""


def unit_kept(source: Quantity | Parameter) -> str:
    """The name of the unit that a source is kept in; a parameter in its own, though in steps."""
    return source.stored.name if isinstance(source, Quantity) else source.unit.name


def conversion_words(covers: Elements, source: Quantity | Parameter, scaling: Scaling) -> str:
    """``mV * 0.1 = cV, to nearest``, or ``kept in mV``."""
    kept = unit_kept(source)
    if scaling.factor == 1:
        return f"kept in {kept}" if kept else ""
    factor = _factor_words(covers, source, scaling)
    return f"{kept} {factor} = {covers.field.unit_text}, {_ROUNDING[scaling.rounding]}"


def _factor_words(covers: Elements, source: Quantity | Parameter, scaling: Scaling) -> str:
    """``* 0.1``, ``* 1/180 * pi``: the firmware has a fraction in place of pi, which rounds alike."""
    kept, step = (source.unit, source.step) if isinstance(source, Parameter) else (source.stored, Fraction(1))
    way = conversion(kept, wire_unit(covers.field) or NUMBER)
    if way is None or not way.pi:
        return f"* {decimal(scaling.factor)}"
    return map_words(AffineMap(step * way.factor, way.pi))


def limit_words(scaling: Scaling, arrow: str = "->") -> str:
    """``0..65534``, and what a value becomes that would read as unknown."""
    text = f"{_shown(scaling.low)}..{_shown(scaling.high)}"
    if scaling.hole is not None and scaling.beside is not None:
        text += f", {_shown(scaling.hole)} {arrow} {_shown(scaling.beside)}"
    return text


def _shown(value: Fraction) -> str:
    """A limit as a decimal number; a float that takes very many digits as Python writes it, which is exact, too."""
    text = shortly(value)
    return text if len(text) <= LONGEST or Fraction(float(value)) != value else repr(float(value))


def fitting(
    covers: Elements,
    scaling: Scaling,
    conversion: str,
    unknown: int | float | None,
    element_high: int | None = None,
) -> Iterator[Step]:
    """The steps of unit, limits and what stands for unknown; ``element_high`` is what one holds before it spills.

    Source: the dialect's units, limits and sentinels.
    """
    unit = covers.field.unit_text
    if scaling.factor != 1:
        yield Step("unit", conversion, (), ())
    details = []
    if scaling.hole is not None and scaling.beside is not None:
        details.append(f"{_shown(scaling.hole)} would read as unknown and becomes {_shown(scaling.beside)}")
    if element_high is not None:
        details.append(f"what is above {element_high} spills into the next element")
    limits = f"{_shown(scaling.low)}..{_shown(scaling.high)}"
    yield Step("limits", f"{limits} {unit}".strip(), tuple(details), (str(covers.citation),))
    if unknown is not None:
        shown = "NaN" if math.isnan(unknown) else f"{unknown}"
        sentinel = covers.sentinel
        written = f", the dialect's {sentinel}" if sentinel and sentinel != shown else ""
        yield Step("unknown", f"{shown}{written}", ("goes out while the value is not known",), ())


def conversion_trait(covers: Elements, source: Quantity | Parameter, scaling: Scaling) -> Trait:
    """Unit, factor and rounding."""
    unit = covers.field.unit_text
    factor = "" if scaling.factor == 1 else f" {_factor_words(covers, source, scaling)}"
    rounding = "" if scaling.rounding is Rounding.NEAREST else f", rounded {scaling.rounding.value.replace('_', ' ')}"
    text = f"{unit_kept(source) or 'value'}{factor}{f' = {unit}' if unit else ''}{rounding}"
    return Trait("conversion", text, Aspect.CONVERSION)


def limit_cases(scaling: Scaling, path: str) -> Iterator[StateCase]:
    """The ends of the range, beyond both, unknown and zero, of what is stored under a path."""
    low, high = scaling.steps
    for name, value in (
        ("minimum", low),
        ("maximum", high),
        ("below-minimum", max(low - 1, -SMALL_INT_MAX)),
        ("above-maximum", min(high + 1, SMALL_INT_MAX)),
        ("far-below", -SMALL_INT_MAX),
        ("far-above", SMALL_INT_MAX),
        ("unknown", None),
        ("zero", 0),
    ):
        yield StateCase(name, {path: value})


def sentinel_cases(covers: Elements, scaling: Scaling, path: str) -> Iterator[StateCase]:
    """The stored value that would become the sentinel, and -1, which people take for one."""
    sentinel = covers.field.sentinel.values[covers.first] if covers.field.sentinel else None
    if isinstance(sentinel, int):
        yield StateCase("sentinel", {path: scaling.to_stored(sentinel)})
    yield StateCase("minus-one", {path: -1})


def parameter_cases(parameter: Parameter) -> Iterator[StateCase]:
    """A parameter at the ends of what it can be set to, in steps: its default may leave bytes 0 that it fills."""
    steps = sorted(parameter.choices) or (parameter.minimum, parameter.maximum)
    yield StateCase("least", {parameter.path: steps[0]})
    yield StateCase("most", {parameter.path: steps[-1]})


def property_cases(quantity: Quantity, plain: Known) -> Iterator[StateCase]:
    """The same field set through the property for people: None, NaN, the infinities and a plain number."""
    if quantity.attribute == quantity.name or quantity.kind is not QuantityKind.NUMBER:
        return
    stored = plain[quantity.path]
    assert isinstance(stored, int)
    settings: tuple[tuple[str, float | str | None, int | None], ...] = (
        ("nan", "nan", None),
        ("none", None, None),
        ("infinity", "inf", None),
        ("minus-infinity", "-inf", None),
        ("in-its-unit", float(stored / quantity.steps), stored),
    )
    for name, value, becomes in settings:
        yield StateCase(name, {quantity.path: becomes}, written=(quantity, value))


def to_unit(source: Quantity, scaling: Scaling) -> Fraction:
    """Return what a number on the wire is multiplied with to get the unit of the
    quantity: ``steps`` stored make one unit.
    """
    return 1 / (scaling.factor * source.steps)


def read_back(covers: Elements, source: Quantity, scaling: Scaling) -> ReadBack:
    """All in the unit of the quantity; ``within`` is one unit of the wire, or what a float of the wire resolves."""
    factor = to_unit(source, scaling)
    assert not isinstance(source.initial, str)
    within = factor if covers.field.type.is_integer else 1 / source.steps / 2
    return ReadBack(
        source,
        {
            "stored": source.attribute,
            "steps": float(source.steps) if source.kind is QuantityKind.NUMBER else 1,
            "low": float(scaling.low * factor),
            "high": float(scaling.high * factor),
            "within": float(within),
            "stands_in": None if source.initial is None else float(source.initial / source.steps),
        },
    )
