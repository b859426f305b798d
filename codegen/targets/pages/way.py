"""The way of a value from its sensor, or its row of a table, to the bytes of the payload, step by step."""

from collections.abc import Iterator

from codegen.frozen import dataclass
from codegen.model.answers.account import Origins
from codegen.model.answers.answer import Answer
from codegen.model.answers.step import Step
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Parameter, Quantity
from codegen.summaries.fields import FieldRow


def way_of(answer: Answer, row: FieldRow, system: System) -> tuple[Step, ...]:
    """The steps of an answer, the bytes last; ``row`` is what the table says about it."""
    return (*answer.way(_Origins(system)), _bytes(answer, row))


@dataclass(frozen=True, slots=True)
class _Origins(Origins):
    """The steps up to what the state or the parameters of a system keep."""

    system: System

    def steps(self, source: Quantity | Parameter) -> tuple[Step, ...]:
        """Return the steps from the sensor, or another source of the value, to where it is kept."""
        return (_parameter(source),) if isinstance(source, Parameter) else tuple(_quantity(source, self.system))


def _quantity(quantity: Quantity, system: System) -> Iterator[Step]:
    yield from quantity.derivation.way(quantity, system)
    unit = f", in {quantity.stored.name}" if quantity.stored.name else ""
    kept = f"kept as {quantity.attribute}{f', a {quantity.kept_in}' if quantity.length else unit}"
    lost = quantity.lost
    details = (kept, f"{quantity.start} at the start", *((f"unknown {lost}",) if lost else ()))
    criteria = _distinct(
        str(quantity.citation or ""),
        *((quantity.cited("stale_after" if quantity.ages else "invalid_after"),) if lost else ()),
    )
    yield Step("state", quantity.path, details, criteria)


def _parameter(parameter: Parameter) -> Step:
    low, default, high = (
        decimal(steps * parameter.step) for steps in (parameter.minimum, parameter.default, parameter.maximum)
    )
    unit = f" {parameter.unit.name}" if parameter.unit.name else ""
    text = " and ".join(parameter.siblings) or parameter.name
    return Step("parameter", text, (f"{default}{unit} by default, {low}..{high}{unit}",), _cited(parameter))


def _bytes(answer: Answer, row: FieldRow) -> Step:
    last = row.offset + row.size - 1
    where = f"byte {row.offset}" if row.size == 1 else f"bytes {row.offset} to {last}"
    size = answer.covers.field.type.size
    order = ("least significant byte first",) if size > 1 else ()
    return Step("wire", f"{row.type.removesuffix(' ext')}, {where}", order, ())


def _cited(thing: Quantity | Parameter) -> tuple[str, ...]:
    return _distinct(str(thing.citation or ""))


def _distinct(*names: str) -> tuple[str, ...]:
    return tuple(dict.fromkeys(name for name in names if name))
