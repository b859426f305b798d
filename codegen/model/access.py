"""The access to commands, resolved: who may command the vehicle over which link."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.spec.access import AccessSpec
from codegen.model.vehicle import Cited


@dataclass(frozen=True, slots=True)
class Access(Cited):
    """The access, with the names of the links of each kind; the number of a signed one tells it from the others."""

    signed: Mapping[str, int]
    listed: tuple[str, ...]
    spec: AccessSpec

    def hears(self, link: str, station: int) -> bool:
        """Return whether a link takes what a station does not sign."""
        return link not in self.signed and (link not in self.listed or station in self.spec.stations)
