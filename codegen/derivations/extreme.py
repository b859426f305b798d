"""The lowest or the highest value of a list: of cells in series one that is empty is hidden by the sum of all."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.spec.derivation import HighestSpec, LowestSpec
from codegen.model.units.unit import Unit, ratio
from codegen.model.vehicle import Quantity

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_EXTREME = Rule(
    "bad-extreme",
    "lowest_of and highest_of name a list of the same component whose values a fact counts and readings forget: "
    "elements names a fact, and stale_after stands there. What comes of it is kept in the unit of the list.",
    remedy="name a list of this component that a fact counts, with stale_after",
)


@dataclass(frozen=True, slots=True)
class Extreme(Derivation):
    """The lowest value of the list that is known, or the highest, found with each reading; unknown while none is."""

    listed: str
    is_lowest: bool

    @property
    def extreme_of(self) -> str | None:
        return self.listed

    @property
    def is_of_lowest(self) -> bool:
        return self.is_lowest

    @property
    def sources(self) -> tuple[str, ...]:
        return (self.listed,)

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        yield DerivationFact(f"{self._which} of", self.listed, f"{self._which}_of")

    def words(self, quantity: Quantity) -> str:
        return f"the {self._which} of {quantity.component}.{self.listed}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"the {self._which} of {self.listed} that are known, found with each reading"

    @property
    def _which(self) -> str:
        return "lowest" if self.is_lowest else "highest"


def resolve_extreme(written: LowestSpec | HighestSpec, kept: Kept, around: Surroundings) -> Extreme | None:
    """The list; None after a finding."""
    name, key = (written.lowest_of if isinstance(written, LowestSpec) else written.highest_of), written.KEY
    listed = around.others.get(name)
    if listed is None:
        around.no_quantity(key, name, BAD_EXTREME)
        return None
    if not isinstance(listed.elements, str) or listed.stale_after is None:
        around.bad(key, f"{name} is no list that a fact counts and readings forget", BAD_EXTREME, "stale_after: 2 s")
        return None
    unit = Unit.parse(listed.stored or listed.unit or "")
    if unit is None or ratio(unit, kept.stored) != 1:
        around.bad(
            key,
            f"{name} is kept in {listed.stored or listed.unit}, not {kept.stored.name}",
            BAD_EXTREME,
            hint=f"stored: {listed.stored or listed.unit}",
        )
        return None
    return Extreme(name, isinstance(written, LowestSpec))
