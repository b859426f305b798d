"""A boolean that is true while another quantity is known."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import UNKNOWN_QUANTITY, Kept, Surroundings
from codegen.frozen import dataclass
from codegen.model.answers.known import Known, Stored
from codegen.model.code.payload_code import UNKNOWN
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.spec.derivation import WhileKnownSpec
from codegen.model.vehicle import Quantity

if TYPE_CHECKING:
    from codegen.model.system import System


@dataclass(frozen=True, slots=True)
class WhileKnown(Derivation):
    """True while ``quantity`` of the same component is known."""

    quantity: str

    @property
    def follows(self) -> str | None:
        return self.quantity

    def holds(self, limit: str, floor: str) -> str:
        return f"value != {UNKNOWN}"

    def attribute(self, place: str, own: str, own_floor: str) -> str:
        return f"known({place})"

    def value(self, quantity: Quantity, known: Known, instance: int) -> Stored:
        return int(known[quantity.decided_by] is not None)

    def deciding(self, instance: int, plain: "Stored") -> Mapping[str, "Stored"]:
        return {"set": plain, "clear": None}

    @property
    def sources(self) -> tuple[str, ...]:
        return (self.quantity,)

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        yield DerivationFact("true while known:", self.quantity, "while_known")

    def words(self, quantity: Quantity) -> str:
        return f"while {quantity.decided_by} is known"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"true while {self.quantity} is known"


def resolve_while_known(written: WhileKnownSpec, kept: Kept, around: Surroundings) -> WhileKnown:
    """Return what the boolean follows."""
    name = written.while_known
    if name not in around.others:
        around.no_quantity("while_known", name, UNKNOWN_QUANTITY)
    elif around.others[name].boolean:
        around.bad(
            "while_known",
            f"{around.name} follows {name}, a boolean, which is never unknown",
            hint="name a quantity that can be unknown: one without initial that is no boolean",
        )
    return WhileKnown(name)
