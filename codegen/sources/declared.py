"""Numbers that a driver gives which is not codegen's: what they are is declared in YAML."""

from collections.abc import Iterable
from fractions import Fraction

from codegen.diagnostics import Report
from codegen.measure import UNCARRIED_CONVERSION, UNIT_MISMATCH, find_unit, obstacle, other_steps
from codegen.model.answers.scaling import rounded
from codegen.model.code.storage import SMALL_INT_MAX, Storage, storage_of
from codegen.model.quantities.source_kind import Output
from codegen.model.spec.driver import OutputSpec
from codegen.model.spec.population import Rounding
from codegen.model.units.unit import Unit, ratio, unit_named
from codegen.pattern import pattern
from codegen.sources.kind import BAD_SOURCE, Around

_NAME = pattern(r"[a-z][a-z0-9_]*")


STORAGES = (Storage.SMALL, Storage.INT32, Storage.UINT32)
"""The ways in which the driver of a project hands a number over: as such, or in two halves of 16 bits."""
_TURN = unit_named("rev")


def _lacks_limits(spec: OutputSpec, step: Unit) -> bool:
    """Return whether it is an angle of steps so small that all of them need limits to be kept: a longitude in degE7."""
    if spec.min is not None and spec.max is not None:
        return False
    whole = ratio(_TURN, step)
    return whole is not None and whole / 2 > SMALL_INT_MAX


def in_tuple(items: Iterable[str]) -> str:
    """A tuple of the generated Python."""
    written = tuple(items)
    return f"({written[0]},)" if len(written) == 1 else f"({', '.join(written)})"


def declared_output(name: str, spec: OutputSpec, around: Around) -> tuple[Output, Fraction] | None:
    """An output as it is declared, and how many of its steps make one of its units; None after a finding.

    A limit between two steps is the one that it is rounded to, as every number up to it is.
    """
    found = Report()
    unit = find_unit(spec.unit, spec.at("unit"), found)
    step = unit if spec.stored is None else find_unit(spec.stored, spec.at("stored"), found)
    steps = None if unit is None or step is None else ratio(unit, step)
    if name and not _NAME.fullmatch(name):
        found.add(
            BAD_SOURCE,
            spec.place,
            f"{name} cannot be the name of an output",
            hint="use lower-case letters, digits and _",
        )
    if unit is not None and step is not None and steps is None:
        why = obstacle(unit, step)
        message = f"{unit.name or 'a number'} cannot be rounded to {step.name}"
        rule = UNCARRIED_CONVERSION if why else UNIT_MISMATCH
        found.add(
            rule,
            spec.at("stored"),
            f"{message}: {why}" if why else message,
            hint=other_steps(unit, step),
        )
    if steps is not None:
        low = -SMALL_INT_MAX if spec.min is None else rounded(spec.min * steps, Rounding.NEAREST)
        high = SMALL_INT_MAX if spec.max is None else rounded(spec.max * steps, Rounding.NEAREST)
        if low > high:
            found.add(BAD_SOURCE, spec.at("max"), "max is below min", hint="swap them, or leave out one")
        elif storage_of(low, high) not in STORAGES:
            key, end = ("max", high) if high > -low else ("min", low)
            message = f"{key} is {end} steps of {step.name if step else ''}, more than the 32 bits of an output hold"
            found.add(BAD_SOURCE, spec.at(key), message, hint="narrow min and max, or take a coarser unit for stored")
        elif step is not None and _lacks_limits(spec, step):
            turn = f"a turn is {_TURN.scale / step.scale} steps of {step.name}, more than 30 bits hold"
            hint = f"min: -180, max: 180 of a longitude; min: -90, max: 90 of a latitude, in {spec.unit}"
            found.add(BAD_SOURCE, spec.place, f"{turn}, and no min and max say which of them can be", hint=hint)
    around.report.extend(found)
    if list(found) or step is None or steps is None:
        around.failed = True
        return None
    return Output(name, step, low, high, spec.doc or ""), steps
