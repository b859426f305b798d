"""Rule for sensors beyond the limits of messages: values go out as they are, and no setter would report a limit."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.answers.scaling import rounded
from codegen.model.quantities.reach import reaches
from codegen.model.spec.population import Rounding
from codegen.model.system import System

RULE = Rule(
    "source-beyond-limits",
    "A sensor gives numbers that lie beyond the limits of the quantity, or of a field that carries it, so they would "
    "be limited without a word. Say what is plausible, with min and max where the sensor is declared, widen the limits "
    "of the quantity, or give the field a 'min' or 'max' of its own in its table: that says that it is limited on "
    "purpose.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every quantity that sensors give, against the limits within which all messages carry it."""
    told = reaches(system)
    for component in system.components.values():
        for quantity in component.quantities.values():
            low, high = told[quantity.path]
            for name, output, factor in quantity.derivation.gives:
                ends = [rounded(end * factor, Rounding.NEAREST) for end in (output.low, output.high)]
                if low <= ends[0] <= ends[1] <= high:
                    continue
                unit = quantity.stored.name
                given = f"{name}.{output.name}".rstrip(".")
                yield Diagnostic(
                    quantity.spec.at("source"),
                    RULE,
                    f"{given} gives {quantity.path} {ends[0]} to {ends[1]} {unit}".rstrip(),
                    f"its limits, and those of the fields that carry it, leave {float(low):g} to {float(high):g}",
                    ((system.sources[name].polling.spec.place, f"{name} is declared here"),),
                )
