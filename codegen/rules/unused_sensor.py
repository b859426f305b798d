"""Sensors that no quantity takes anything of."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.findings.fingerprint import fingerprint
from codegen.model.system import System

RULE = Rule(
    "unused-sensor",
    "No quantity has a sensor of board.yaml as its source: it is read for nobody, and takes its time on the bus. "
    "Mostly a quantity is missing, or names another sensor. A message of a sensor that code of yours asks by itself "
    "can be waived.",
    Severity.WARNING,
    remedy="write source: and its name at the quantity that it is for, or leave the sensor out",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every sensor of the project's own board file; what cannot be read of the state has been reported."""
    state = system.spec.state
    written = {key.split(".")[1] for key in state.places if key.startswith("components.")}
    if written - system.components.keys() or any(each.unread for each in state.components.values()):
        return
    quantities = (each for component in system.components.values() for each in component.quantities.values())
    used = {name for quantity in quantities for name, _, _ in quantity.derivation.gives}
    for name, spec in system.spec.board.sources.items():
        if name in used or name not in system.sources or not system.spec.is_own(spec.place.file):
            continue  # other programs may use what this one does not
        hint = f"write source: {name} at a quantity, or leave the sensor out"
        found = fingerprint(RULE.id, spec.place.file, f"{system.spec.program} {name}")
        message = f"no quantity has the sensor {name} as its source"
        yield Diagnostic(spec.place, RULE, message, hint, fingerprint=found)
