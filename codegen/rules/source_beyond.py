"""Rule for sensors beyond the limits of messages: values go out as they are, and no setter would report a limit."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.answers.scaling import rounded
from codegen.model.quantities.reach import FieldReach, field_reaches
from codegen.model.spec.population import Rounding
from codegen.model.system import System
from codegen.model.units.unit import decimal

RULE = Rule(
    "source-beyond-limits",
    "A sensor gives numbers that lie beyond the limits of the quantity, or of a field that carries it, so they would "
    "be limited without a word. Say what is plausible, with min and max where the sensor is declared, widen the limits "
    "of the quantity, or give the field a 'min' or 'max' of its own in its table: that says that it is limited on "
    "purpose.",
)

End = int | Fraction | None


def check(system: System) -> Iterator[Diagnostic]:
    """Every quantity that sensors give, against the limits within which all messages carry it."""
    fields: dict[str, list[FieldReach]] = {}
    for quantity, field in field_reaches(system):
        fields.setdefault(quantity.path, []).append(field)
    for component in system.components.values():
        for quantity in component.quantities.values():
            for name, output, factor in quantity.derivation.gives:
                low, high = (rounded(end * factor, Rounding.NEAREST) for end in (output.low, output.high))
                given = f"{name}.{output.name}".rstrip(".")
                narrow = [
                    field for field in fields.get(quantity.path, ()) if _is_narrower(field.low, field.high, low, high)
                ]
                narrower = [(field.name, field.low, field.high) for field in narrow]
                if _is_narrower(quantity.minimum, quantity.maximum, low, high):
                    narrower.insert(0, (f"the limits of {quantity.path}", quantity.minimum, quantity.maximum))
                if narrower:
                    unit = quantity.stored.name
                    related = [(system.sources[name].polling.spec.place, f"{name} is declared here")]
                    related += [
                        (field.answer.covers.written.place, f"{field.name} is limited here") for field in narrow
                    ]
                    left = "; ".join(_left(*each, unit) for each in narrower)
                    yield Diagnostic(
                        quantity.spec.at("source"),
                        RULE,
                        f"{given} gives {quantity.path} {f'{low} to {high} {unit}'.rstrip()}, and {left}",
                        f"{_remedy(quantity.path, narrow)}, or narrow min and max of {given}",
                        tuple(related),
                    )


def _remedy(path: str, narrow: list[FieldReach]) -> str:
    if not narrow:
        return f"widen min and max of {path}"
    return f"write min and max at {' and '.join(field.name for field in narrow)}: limited on purpose"


def _is_narrower(low: End, high: End, smallest: int, largest: int) -> bool:
    return (low is not None and smallest < low) or (high is not None and largest > high)


def _left(name: str, low: End, high: End, unit: str) -> str:
    """Words for what some limits leave: ``HIGH_LATENCY2.altitude leaves -32768000 to 32767000 mm``."""
    verb = "leave" if name.startswith("the limits") else "leaves"
    ends = ["any number" if end is None else decimal(Fraction(end)) for end in (low, high)]
    return f"{name} {verb} {' to '.join(ends)} {unit}".rstrip()
