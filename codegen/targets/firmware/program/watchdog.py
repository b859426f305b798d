"""View of watchdog.py, which resets a main loop that stands still."""

from codegen.frozen import dataclass
from codegen.model.program import Program

LOOKS = 4
"""The number of times within its timeout that the watchdog is fed."""


@dataclass(frozen=True, slots=True)
class WatchdogView:
    """The module: ``caused`` is true after a reset by the watchdog, ``causes`` a dict of the others in words.

    ``late_us`` is how late a job may be, ``hold`` are the statements that keep the watchdog from resetting a prompt.
    """

    timeout_ms: int
    citation: str
    look_ms: int
    late_us: int
    caused: str
    causes: str
    hold: tuple[str, ...]
    can_halt: bool


def watchdog_view(program: Program) -> WatchdogView | None:
    """The view of the module; None where the program has no watchdog."""
    watchdog = program.watchdog
    if watchdog is None:
        return None
    look_ms = watchdog.timeout_ms // LOOKS
    board = watchdog.board
    causes = ", ".join(f'{number}: "{words}"' for number, words in board.causes.items())
    return WatchdogView(
        timeout_ms=watchdog.timeout_ms,
        citation=str(watchdog.citation or ""),
        look_ms=look_ms,
        late_us=watchdog.timeout_ms * 1000,
        caused=board.spec.caused,
        causes=f"{{{causes}}}",
        hold=tuple(each.replace("{period}", str(look_ms)) for each in board.spec.hold),
        can_halt=program.spec.arming is not None,
    )
