"""Quantities that are kept more coarsely than a field could tell them, without a word in the table."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.answers.scaling import rounded
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.quantities.attainable import unrounded
from codegen.model.quantities.reach import Reach
from codegen.model.quantities.source_kind import Output
from codegen.model.reception import ReceivedField
from codegen.model.spec.driver import OutputSpec
from codegen.model.spec.population import Rounding
from codegen.model.system import System
from codegen.model.units.finer_unit import finer_unit
from codegen.model.units.unit import Unit, ratio
from codegen.model.vehicle import Component, Quantity, QuantityKind
from codegen.source import Place

RULE = Rule(
    "coarse-quantity",
    "A quantity is kept in whole units, since the table says no other 'stored' unit, and a field carries finer steps, "
    "or is received in steps between them, or the sensor of another instance gives finer ones: what lies between is "
    "rounded away. Write 'stored' to say how finely it is kept, even where whole units are meant. "
    "A quantity that goes out in float fields alone, and that nothing compares, is kept as a float. What a class of "
    "the project's gives (driver user) is no float: it is rounded to whole units of its output in board.yaml before it "
    "is kept, so that 'stored' has to stand there.",
    Severity.WARNING,
    remedy="write stored: with a finer unit, or with the unit itself if that is meant",
)
SINGLE_STEP = Rule(
    "single-step-quantity",
    "All values that a quantity can have are rounded to the same number: its steps (stored) are coarser than the range "
    "that its sensor, its converter or a received message gives. It would stand at that number for ever.",
    remedy="write stored: with a unit finer than the range",
)
Given = tuple[str, Output, Fraction, OutputSpec]
"""The name of a number that code gives in whole units, the number, its factor, and where it is declared."""


def check(system: System) -> Iterator[Diagnostic]:
    """Every field that carries a quantity which is kept in whole units, without 'stored'; sums are as such fields."""
    for message in system.messages:
        for answer in message.answers:
            yield from _in_field(answer, message.name, system)
    for table in system.receptions:
        for taken in table.fields:
            yield from _of_received(taken, table.wire.name)
    ends = unrounded(system)
    for component in system.components.values():
        for quantity in component.quantities.values():
            yield from _of_one_step(quantity, ends.get(quantity.path))
            yield from _of_coarser_output(quantity, system)
            yield from _of_finer_output(quantity)
        yield from _estimated(component)
        for basis in component.counted_on:
            for given in _in_whole_units(basis.quantity, system):
                for counted in basis.sums:
                    yield _rounded(given, f"{counted.path} is summed up of it", counted.spec.place, "here")


def _of_received(taken: ReceivedField, message: str) -> Iterator[Diagnostic]:
    """Yield the field of which each number is rounded to whole units, being so many of them and a part."""
    if _is_in_whole_units(taken.quantity) and (not taken.field.type.is_integer or taken.factor.denominator != 1):
        finer = f"{message}.{taken.label} comes as {taken.field.type.name} in {taken.field.unit_text or 'no unit'}"
        yield _kept_coarsely(taken.quantity, finer, taken.spec.place, f"{taken.label} sets it here")


def _of_one_step(quantity: Quantity, ends: Reach | None) -> Iterator[Diagnostic]:
    """Yield the quantity of which every value is kept as the same number."""
    if ends is None or quantity.storage.is_float or ends[0] == ends[1]:
        return
    low, high = (rounded(Fraction(end), Rounding.NEAREST) for end in ends)
    if low == high:
        unit, stored = quantity.unit.name, quantity.stored.name
        least, most = (f"{float(end / quantity.steps):.7g}" for end in ends)
        kept = f"it goes from {least} to {most} {unit}, and is kept in whole {stored}"
        text = f"{quantity.path} is always {low} {stored}: {kept}"
        finer = finer_unit(quantity.unit)
        hint = f"stored: {finer.name if finer else unit}" if unit else "leave out stored"
        yield Diagnostic(quantity.spec.at("stored"), SINGLE_STEP, text, hint)


def _of_coarser_output(quantity: Quantity, system: System) -> Iterator[Diagnostic]:
    """Yield the outputs that say coarser steps than their quantity: what lies between is never kept."""
    if quantity.kind is not QuantityKind.NUMBER or quantity.spec.stored is None:
        return
    for name, output, factor in dict.fromkeys(quantity.derivation.gives):
        declared = system.sources[name].declared(output) if system.sources[name].given_in else None
        if declared is not None and declared.stored is not None and factor > 1:
            given = f"{name}.{output.name}".rstrip(".")
            text = (
                f"{given} is rounded to whole {output.unit.name}, and {quantity.path} is kept in {quantity.stored.name}"
            )
            kept = ((quantity.spec.at("stored"), f"{quantity.path} is kept so here"),)
            hint = f"stored: {quantity.stored.name} at the output, or stored: {output.unit.name} at the quantity"
            yield Diagnostic(declared.at("stored"), RULE, text, hint, kept)


def _of_finer_output(quantity: Quantity) -> Iterator[Diagnostic]:
    """Yield the quantity of several instances that is kept as the sensor of the first gives it, where another is finer.

    With ``stored`` the table has said how finely, whatever a sensor gives.
    """
    gives = quantity.derivation.gives
    if quantity.kind is not QuantityKind.NUMBER or quantity.spec.stored is not None or not gives:
        return
    name, output, factor = min(gives, key=lambda given: given[2])
    if factor < 1:
        first, finest = (f"{name}.{output.name}".rstrip(".") for name, output in (gives[0][:2], (name, output)))
        yield Diagnostic(
            quantity.spec.at("source"),
            RULE,
            f"{quantity.path} is kept in {quantity.stored.name or 'steps'} as {first} gives it, and {finest} gives "
            f"{output.unit.name or 'finer ones'}",
            f"stored: {output.unit.name}" if output.unit.name else None,
        )


def _in_field(answer: Answer, message: str, system: System) -> Iterator[Diagnostic]:
    """Yield what is coarser than a field of a message tells it."""
    covers = answer.covers
    place, units, takes = covers.written.place, covers.field.definition.units, f"{covers.label} takes it here"
    finer = f"{message}.{covers.label} is a {covers.field.type.name}{f' in {units}' if units else ''}"
    for quantity in answer.carried:
        if _is_in_whole_units(quantity) and _carries_finer(answer, Fraction(1)):
            yield _kept_coarsely(quantity, finer, place, takes)
        for given in _in_whole_units(quantity, system):
            if _carries_finer(answer, given[2]):
                steps = (
                    wire_unit(covers.field) if covers.field.type.is_integer and covers.field.multiplier == 1 else None
                )
                yield _rounded(given, finer, place, takes, steps)


def _estimated(component: Component) -> Iterator[Diagnostic]:
    """Yield what is measured in whole units where a curve makes several steps of its estimate of each."""
    for estimate in component.quantities.values():
        curves = estimate.derivation.curves_by_instance
        measured = component.quantities.get(estimate.derivation.sources[0]) if curves else None
        if measured is None or measured.spec.stored is not None:
            continue
        pairs = [pair for curve in curves for pair in pairwise(curve)]
        if any(abs(second[1] - first[1]) > second[0] - first[0] for first, second in pairs):
            whole = f"whole {measured.stored.name}" if measured.stored.name else "whole numbers"
            finer = finer_unit(measured.unit)
            yield Diagnostic(
                measured.spec.place,
                RULE,
                f"{measured.path} is kept in {whole}, and {estimate.path} is estimated of it, in finer steps",
                f"stored: {finer.name if finer else measured.unit.name}" if measured.unit.name else None,
                ((estimate.spec.place, "the estimate is here"),),
            )


def _kept_coarsely(quantity: Quantity, finer: str, place: Place, use: str) -> Diagnostic:
    """Return the finding that a quantity is kept more coarsely than a field has it, which uses it at a place."""
    whole = f"whole {quantity.stored.name}" if quantity.stored.name else "whole numbers"
    hint = f"stored: {quantity.unit.name}, if whole units are meant" if quantity.unit.name else None
    return Diagnostic(
        quantity.spec.place, RULE, f"{quantity.path} is kept in {whole}, and {finer}", hint, ((place, use),)
    )


def _is_in_whole_units(quantity: Quantity) -> bool:
    """Return whether it is kept in whole units that no table has asked for."""
    if quantity.kind is not QuantityKind.NUMBER or quantity.spec.stored is not None or quantity.storage.is_float:
        return False
    # a sensor gives these steps: nothing lies between them, or its output is in whole units
    return not (quantity.derivation is not None and quantity.derivation.gives)


def _carries_finer(answer: Answer, step: Fraction) -> bool:
    """Return whether a field could tell apart what lies between two steps, each so many of the quantity's."""
    return not answer.covers.field.type.is_integer or any(scaling.factor * step > 1 for scaling in answer.scalings)


def _in_whole_units(quantity: Quantity, system: System) -> Iterator[Given]:
    """The outputs that code gives as any numbers, and that are rounded to whole units: no table says how finely."""
    if quantity.kind is not QuantityKind.NUMBER:
        return
    for name, output, factor in dict.fromkeys(quantity.derivation.gives):
        source = system.sources[name]
        declared = source.declared(output) if source.given_in else None
        if declared is not None and declared.stored is None:
            yield f"{name}.{output.name}".rstrip("."), output, factor, declared


def _rounded(given: Given, finer: str, place: Place, takes: str, steps: Unit | None = None) -> Diagnostic:
    """The finding that what code gives is rounded to whole units, at the output, with what is finer.

    ``steps`` are those of the field, if it has some: then a number is rounded once.
    """
    name, output, _, declared = given
    whole = f"whole {output.unit.name}" if output.unit.name else "whole numbers"
    message = f"{name} is rounded to {whole} where it is read, and {finer}"
    return Diagnostic(declared.place, RULE, message, _hint(output.unit, declared, steps), ((place, takes),))


def _hint(unit: Unit, declared: OutputSpec, steps: Unit | None) -> str:
    if not unit.name:
        return "give the output a unit with steps, such as %, or let code of yours set the quantity"
    ends = [abs(end) for end in (declared.min, declared.max) if end is not None]
    finer = finer_unit(unit, max(ends) if len(ends) == 2 else None)
    if steps is not None and ratio(unit, steps) is not None:
        finer = steps
    meant = f"stored: {unit.name} if whole units are meant"
    return f"stored: {finer.name} at the output, or {meant}" if finer else f"a finer stored at the output, or {meant}"
