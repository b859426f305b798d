"""The registration of a kind of sensor, and the surroundings that it may ask while one is resolved."""

import dataclasses
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from codegen.diagnostics import Report, Rule
from codegen.model.board_model import BoardModel, shown_pins
from codegen.model.quantities.source_kind import Polling, Source
from codegen.model.spec.source import SourceSpec
from codegen.model.spec.spec import Spec
from codegen.source import Place

BAD_SOURCE = Rule(
    "bad-source-driver",
    "A sensor cannot be built: its name is a lower-case identifier, it is asked at most 1000 times a second, and the "
    "board has the pins, the UART or the I2C bus that its driver needs.",
)


@dataclasses.dataclass(slots=True)
class Around:
    """A sensor as written, with what the specification says elsewhere. ``board`` is what is known about the board.

    ``failed`` once something was found in the sensor itself. ``prefix`` stands before the keys of what it is connected
    to.
    """

    spec: SourceSpec
    board: BoardModel | None
    whole: Spec
    report: Report
    failed: bool = False
    prefix: str = ""

    def bad(
        self,
        key: str,
        message: str,
        hint: str | None = None,
        rule: Rule = BAD_SOURCE,
        related: Iterable[tuple[Place, str]] = (),
    ) -> None:
        """Report something at a key of the sensor."""
        self.report.add(rule, self.spec.at(f"{self.prefix}{key}"), message, hint, related)
        self.failed = True

    def known_board(self, what: str) -> BoardModel | None:
        """The board, for ``what`` is connected to it; None after a finding, here or where the board is named."""
        if self.board is None:
            self.failed = True
            if self.whole.board.board is None:
                self.bad("driver", f"{what} is on no known board: say which, such as board: pico_2_w")
        return self.board

    def within(self, key: str, value: int, low: int, high: int) -> int:
        """A whole number, which has to lie between two others."""
        if not low <= value <= high:
            self.bad(key, f"{key} is {value}, not {low} to {high}")
        return value

    def pin(self, key: str, gpio: int, choices: frozenset[int], what: str, board: BoardModel) -> int:
        """A GPIO number, which has to be one of ``choices`` that the board does not need for itself."""
        if gpio not in choices & board.free:
            taken = f": the {board.name} needs it for {board.taken[gpio]}" if gpio in board.taken else ""
            self.bad(key, f"{what} is GPIO {shown_pins(choices & board.free)} on the {board.name}, not {gpio}{taken}")
        return gpio


class KindOfSource(NamedTuple):
    """A kind of sensor: the word for it, the class of its keys, how it is resolved, and how often it is asked."""

    name: str
    spec: type[SourceSpec]
    resolve: Callable[[Any, Polling, Around], Source | None]
    rate: str
