"""The watchdog of a board: what its file states, and what that resolves to."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, described
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class BoardWatchdogSpec(Written):
    """The watchdog of a board, machine.WDT of its MicroPython."""

    shortest: Amount = described("Shortest timeout that it takes.", default="1 ms")
    longest: Amount | None = described("Longest timeout that it takes. Without it any.", default=None)
    caused: str = described(
        "The Python expression that is true where the watchdog has reset the board; machine is imported.",
        default="machine.reset_cause() == machine.WDT_RESET",
    )
    causes: Mapping[str, str] = described(
        "What else machine.reset_cause() tells, by its number, in words: {1: power on}.", default_factory=dict
    )
    restart: int = described("What machine.reset_cause() tells after machine.reset().")
    hold: tuple[str, ...] = described(
        "Python statements by which it does not reset the board while somebody is at the prompt, nor before the next "
        "start of the program: what stops it, or has a timer feed it; {period} stands for a quarter of its time in ms."
    )


@dataclass(frozen=True, slots=True)
class BoardWatchdog:
    """The watchdog of a board: timeouts in ms, ``longest_ms`` None for any; the causes of resets, by their numbers."""

    shortest_ms: int
    longest_ms: int | None
    causes: Mapping[int, str]
    spec: BoardWatchdogSpec
