"""The names that tables use, looked up among what has been resolved."""

from collections.abc import Mapping

from codegen.answers.scope import Scope
from codegen.diagnostics import did_you_mean
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import EnumDefinition
from codegen.model.spec.spec import Spec
from codegen.model.vehicle import Parameter, Quantity
from codegen.resolve.instances import known_facts
from codegen.resolve.quantities.kept import UNKNOWN_ENTRY
from codegen.resolve.quantities.state import find_quantity
from codegen.resolve.vehicle import find_parameter
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class ResolvedScope(Scope):
    """The scope of a table in a specification the vehicle of which is resolved."""

    spec: Spec
    parameters: Mapping[str, Parameter]

    def quantity(self, path: str, place: Place) -> Quantity | None:
        """The quantity that is written as ``component.quantity``."""
        return find_quantity(path, self.components, self.spec.state, place, self.report)

    def parameter(self, name: str, place: Place) -> Parameter | None:
        """The parameter of a name."""
        return find_parameter(name, place, self.spec.parameters, self.parameters, self.report)

    def enum(self, name: str) -> EnumDefinition | None:
        """The enum that a field of the dialect names; None where there is none, which the dialect has a finding for."""
        return self.dialect.enums.get(name)

    def entry(self, enum: EnumDefinition, name: str, place: Place) -> int | None:
        """The value of an entry of an enum."""
        entry = enum.entry(name)
        if entry is not None:
            return entry.value
        owner = next((other.name for other in self.dialect.enums.values() if other.entry(name)), None)
        hint = f"{name} belongs to {owner}" if owner else did_you_mean(name, [entry.name for entry in enum.entries])
        self.report.add(UNKNOWN_ENTRY, place, f"{enum.name} has no entry {name}", hint)
        return None

    def is_unread(self, component: str) -> bool:
        """Return whether a component is written in a way that could not be read, which has been reported."""
        return component not in self.components and self.spec.state.has_written(component)

    def facts(self) -> list[str]:
        """Every fact that board.yaml states."""
        return known_facts(self.spec, self.components)
