"""The derivation of quantities that only code of the vehicle sets."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from codegen.frozen import dataclass
from codegen.model.answers.step import Step
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.vehicle import Quantity, QuantityKind

if TYPE_CHECKING:
    from codegen.model.system import System

WORDS = "set by the vehicle"


@dataclass(frozen=True, slots=True)
class SetByCode(Derivation):
    """A quantity that starts anew with each return that the quantity ``anew_with`` of its component counts, if any."""

    anew_with: str | None

    @property
    def is_set_by_code(self) -> bool:
        return True

    @property
    def restarts_with(self) -> str | None:
        return self.anew_with

    def simulated(
        self, quantity: Quantity, instance: int, system: "System", parameters: Mapping[str, float]
    ) -> SimulatedInput:
        return set_by_code(quantity, instance)

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        if self.anew_with is not None:
            yield DerivationFact("restarts with", self.anew_with, "restarts_with")

    def words(self, quantity: Quantity) -> str:
        return WORDS if self.anew_with is None else f"{WORDS}; anew with {quantity.component}.{self.anew_with}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        if self.anew_with is not None:
            yield "follows", f"begins anew when {self.anew_with} counts up"

    def way(self, quantity: Quantity, system: "System") -> Iterator[Step]:
        is_number = quantity.kind is QuantityKind.NUMBER and self.anew_with is None
        details = ("no ADC channel measures it",) if is_number else ()
        yield Step("source", self.words(quantity), details, quantity.criteria())


def set_by_code(quantity: Quantity, instance: int) -> SimulatedInput:
    """Return how true values of what code sets reach an instance in a simulation.

    A float is set in the unit of the quantity, whatever unit it is kept in: the attribute that is called so converts.
    """
    is_float = quantity.storage.is_float
    return SimulatedInput(
        "state",
        {
            "component": quantity.component,
            "instance": instance,
            "attribute": quantity.name if is_float else quantity.attribute,
            "steps": int(quantity.steps) if quantity.steps.denominator == 1 else float(quantity.steps),
            "is_whole": quantity.kind is QuantityKind.NUMBER and not is_float,
        },
        {"fail": "nothing sets it", "stuck": "it is set to what it was"},
    )
