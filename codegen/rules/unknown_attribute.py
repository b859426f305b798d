"""Attributes of the state that the user's code sets, and that its component does not have."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, did_you_mean
from codegen.model.system import System
from codegen.model.vehicle import Component

RULE = Rule(
    "unknown-attribute",
    "Code of the user's sets an attribute of a component that state.yaml does not declare. Python makes a new one of "
    "it, which nothing reads: what is sent stays unknown, or as it was. Set an attribute of a quantity, or keep what "
    "is the code's own in an object of its own.",
    remedy="set an attribute that a quantity of state.yaml has, or keep it in an object of your own",
)

_KEPT = frozenset({"words", "limited", "beyond", "number", "failures", "expires_ms"})
"""Attributes that components keep beside their quantities."""


def check(system: System) -> Iterator[Diagnostic]:
    """Each attribute that is set in a module of the program, or in one that it imports."""
    for stored in system.spec.state_stores:
        component = system.components.get(stored.component)
        if component is None or stored.attribute.startswith("_"):
            continue
        known = known_attributes(component)
        if stored.attribute not in known and stored.attribute not in _KEPT:
            message = f"state.{component.name} has no {stored.attribute}"
            yield Diagnostic(stored.place, RULE, message, did_you_mean(stored.attribute, known))


def known_attributes(component: Component) -> frozenset[str]:
    """Return the attributes that the quantities of a component have: by their names, and as they are kept."""
    quantities = component.quantities.values()
    return frozenset(name for each in quantities for name in (each.name, each.attribute))
