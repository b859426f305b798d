"""A boolean that a parameter switches, and with it the component."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import Kept, Surroundings
from codegen.frozen import dataclass
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.spec.derivation import EnabledBySpec
from codegen.model.vehicle import Parameter, Quantity

if TYPE_CHECKING:
    from codegen.model.system import System


@dataclass(frozen=True, slots=True)
class EnabledBy(Derivation):
    """True while ``parameter`` is not 0; while it is false the component is neither measured nor reported."""

    parameter: Parameter

    @property
    def switch(self) -> Parameter | None:
        return self.parameter

    def uses(self, quantity: Quantity) -> Iterator[tuple[Parameter, str]]:
        yield self.parameter, f"whether {quantity.component} is measured and reported ({quantity.path})"

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        yield DerivationFact("enabled by", self.parameter.name, "enabled_by")

    def words(self, quantity: Quantity) -> str:
        return f"while {self.parameter.name} is not 0"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"true while {self.parameter.name} is not 0"


def resolve_enabled_by(written: EnabledBySpec, kept: Kept, around: Surroundings) -> EnabledBy | None:
    """The parameter that switches; None after a finding."""
    parameter = around.parameter("enabled_by", written.enabled_by)
    if parameter is not None and not parameter.spec.reboot:
        message = f"{parameter.name} is looked at when the board starts"
        around.bad("enabled_by", message, hint=f"{parameter.name}: reboot: true")
    return None if parameter is None else EnabledBy(parameter)
