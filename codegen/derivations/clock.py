"""Time that the firmware counts: since it started, and since 1970 once something has said when that is."""

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.frozen import dataclass
from codegen.model.answers.step import Step
from codegen.model.code.clock import BOOT, CLOCK, UNIX
from codegen.model.code.storage import Storage
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.quantities.trust import Trust
from codegen.model.spec.state import ComponentSpec, QuantitySpec
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Component, Instance, Quantity, QuantityKind
from codegen.source import Place

if TYPE_CHECKING:
    from codegen.model.system import System

_DOCS = {
    BOOT: "Time since the start.",
    UNIX: "Time since 1970, UTC. Unknown until code sets it; from then on it is counted.",
}


@dataclass(frozen=True, slots=True)
class Clock(Derivation):
    """Counted by the ticks of the board, in whole microseconds of 64 bits."""

    @property
    def counts_time(self) -> bool:
        return True

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        yield DerivationFact("counted", "by the ticks of the board", "")

    def words(self, quantity: Quantity) -> str:
        return "counted by the ticks of the board" + ("" if quantity.initial is not None else ", once it is set")

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "counted", "by ticks_us, whose turns ticks_ms counts: right while a message is built every 12 days"

    def way(self, quantity: Quantity, system: "System") -> Iterator[Step]:
        yield Step("source", self.words(quantity), (), ())


def clock_component(place: Place) -> Component:
    """The component; ``place`` is where what is said about it points to."""
    specs = {name: QuantitySpec(place=place, doc=doc, unit="us") for name, doc in _DOCS.items()}
    return Component(
        name=CLOCK,
        parts=(Instance(0, "", {}),),
        first_number=None,
        period_ms=None,
        quantities={name: _counted(name, spec) for name, spec in specs.items()},
        returns=None,
        spec=ComponentSpec(place=place, doc="The clock of the firmware.", quantities=specs),
        citation=None,
        aspects={},
    )


def _counted(name: str, spec: QuantitySpec) -> Quantity:
    low, high = Storage.UINT64.limits
    return Quantity(
        component=CLOCK,
        name=name,
        attribute=f"{name}_us",
        kind=QuantityKind.NUMBER,
        unit=unit_named("us"),
        stored=unit_named("us"),
        steps=Fraction(1),
        storage=Storage.UINT64,
        minimum=low,
        maximum=high,
        initial=0 if name == BOOT else None,
        enum=None,
        elements=None,
        derivation=Clock(),
        trust=Trust(None, None),
        spec=spec,
        citation=None,
        aspects={},
    )
