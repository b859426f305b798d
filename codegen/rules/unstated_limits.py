"""Numbers of drivers of the project that have no limits, where a field carries more than is kept without them."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.code.storage import SMALL_INT_MAX, Storage
from codegen.model.quantities.source_kind import Output
from codegen.model.system import System
from codegen.model.units.unit import NUMBER, ratio, unit_named
from codegen.model.vehicle import QuantityKind

RULE = Rule(
    "unstated-limits",
    "A count, flags or a time from a driver of the project has no min and max, and a field carries all of its 32 bits "
    f"or more. Without limits it is kept in a small integer, and unknown beyond {SMALL_INT_MAX}: microseconds after 18 "
    "minutes. With limits it is kept as it comes, in up to 32 bits. Say what can be, even where less is meant.",
    Severity.WARNING,
)
_COUNTED = (NUMBER, unit_named("s"))


def check(system: System) -> Iterator[Diagnostic]:
    """Every integer field that carries such a number in its own steps."""
    for message in system.messages:
        for answer in message.answers:
            for quantity, scaling in zip(answer.carried, answer.scalings, strict=False):
                if quantity.kind is not QuantityKind.NUMBER or not answer.covers.field.type.is_integer:
                    continue
                for name, output, factor in dict.fromkeys(quantity.derivation.gives):
                    if scaling.factor * factor == 1 and _is_counted(output):
                        yield from _unstated(name, output, answer, message.name, system)


def _is_counted(output: Output) -> bool:
    return any(ratio(output.unit, unit) is not None for unit in _COUNTED)


def _unstated(source: str, output: Output, answer: Answer, message: str, system: System) -> Iterator[Diagnostic]:
    field = answer.covers.field
    declared = system.sources[source].declared(output)
    if declared is None or (declared.min is not None and declared.max is not None):
        return
    if field.type.maximum <= SMALL_INT_MAX:
        return
    storage = Storage.INT32 if field.type.minimum < 0 else Storage.UINT32
    low, high = max(field.type.minimum, storage.limits[0]), min(field.type.maximum, storage.limits[1])
    if field.sentinel is not None and high in field.sentinel.values:
        high -= 1
    unit = output.unit if declared.unit is None else unit_named(declared.unit)
    factor = ratio(output.unit, unit) or Fraction(1)
    name = f"{source}.{output.name}".rstrip(".")
    covers = answer.covers
    yield Diagnostic(
        declared.place,
        RULE,
        f"{name} has no min and max, and is unknown beyond {SMALL_INT_MAX}: {message}.{covers.label} carries more",
        f"min: {float(low * factor):.10g}, max: {float(high * factor):.10g} at the output, or what can be",
        ((covers.written.place, f"{covers.label} takes it here"),),
    )
