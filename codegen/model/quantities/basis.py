"""A measured quantity as the basis of counted ones: of sums over time, and of the remainders that these leave."""

from typing import TYPE_CHECKING

from codegen.frozen import dataclass

if TYPE_CHECKING:
    from codegen.model.vehicle import Component, Quantity


@dataclass(frozen=True, slots=True)
class Basis:
    """A quantity of a component that is measured, so that others can be counted of its values."""

    component: "Component"
    quantity: "Quantity"

    def word(self, word: str) -> str:
        """The name of a word that it needs beside its own: ``current_since_ms``."""
        return f"{self.quantity.name}_{word}"

    @property
    def sums(self) -> tuple["Quantity", ...]:
        """The quantities that are sums of it over time."""
        found = ((each, each.derivation.sums) for each in self.component.quantities.values())
        return tuple(each for each, one in found if one and one.of == self.quantity.name)

    @property
    def given(self) -> tuple["Quantity", ...]:
        """The quantities that come of its values: what an ADC measures, its trend, its estimate, what sums leave."""
        quantities = self.component.quantities.values()
        return tuple(
            each
            for each in quantities
            if each.derivation.comes_of_readings and self.quantity.name in (each.name, *each.derivation.sources[:1])
        )

    @property
    def is_estimated_from(self) -> bool:
        """Return whether a quantity follows it by a curve."""
        return any(each.derivation.curves_by_instance for each in self.given)
