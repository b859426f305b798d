"""The derivation of quantities that only a received message sets."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import SET_TWICE, Surroundings
from codegen.frozen import dataclass
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.vehicle import Quantity

if TYPE_CHECKING:
    from codegen.model.system import System


@dataclass(frozen=True, slots=True)
class Received(Derivation):
    """Set by a field of the message of a table in ``receives/``."""

    table: str
    message: str
    field: str

    @property
    def is_received(self) -> bool:
        return True

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        yield DerivationFact("received from", self._source, "")

    def words(self, quantity: Quantity) -> str:
        return f"received from {self._source}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        for table in system.receptions:
            for taken in table.fields:
                if table.name == self.table and taken.quantity.path == quantity.path:
                    unknown = f", {taken.sentinel_words} sets it unknown" if taken.sentinel_words else ""
                    kept = f", {taken.unchanged_words} leaves it as it was" if taken.unchanged else ""
                    yield "taken", f"{taken.range_words or 'ASCII'} from {table.spec.sender.value}{unknown}{kept}"

    @property
    def _source(self) -> str:
        table = "" if self.table == self.message else f" ({self.table})"
        return f"{self.message}.{self.field}{table}"


def resolve_received(around: Surroundings) -> Received:
    """The field that sets it; a second one is a finding at the second."""
    table, key = around.received[0]
    for other, second in around.received[1:]:
        place = other.fields[second].at("state")
        related = [(table.fields[key].at("state"), "the first table is here")]
        message = f"{around.path} is set by {table.name}.{key} already"
        around.report.add(SET_TWICE, place, message, "give each table quantities of its own", related)
    if around.spec.restarts_with is not None:
        message = f"{around.name} is received from {table.receive}, so it cannot begin anew with a count"
        around.bad(
            "restarts_with", message, SET_TWICE, hint=f"leave it out, or do not take {around.name} from {table.receive}"
        )
    return Received(table.name, table.receive, key)
