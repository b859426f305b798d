"""The watchdog of a program, resolved: what vehicle.yaml asks for, and what the board has."""

from codegen.frozen import dataclass
from codegen.model.board_watchdog import BoardWatchdog
from codegen.model.vehicle import Cited


@dataclass(frozen=True, slots=True)
class Watchdog(Cited):
    """The watchdog of a program: it resets the ``board`` after ``timeout_ms`` without being fed."""

    timeout_ms: int
    board: BoardWatchdog
