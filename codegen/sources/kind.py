"""The registration of a kind of sensor, and the surroundings that it may ask while one is resolved."""

import dataclasses
import os
from collections.abc import Callable, Iterable
from difflib import get_close_matches
from typing import Any, NamedTuple

from codegen.diagnostics import Report, Rule, shortened_list
from codegen.model.board_model import BoardModel, no_such_pin
from codegen.model.quantities.source_kind import Polling, Source
from codegen.model.spec.driver import DriverModule
from codegen.model.spec.source import SourceSpec
from codegen.model.spec.spec import Spec
from codegen.source import Place

BAD_SOURCE = Rule(
    "bad-source-driver",
    "A sensor cannot be built: its name is a lower-case identifier, it is asked at most 1000 times a second, and the "
    "board has the pins, the UART or the I2C bus that its driver needs.",
    remedy="make the sensor fit its board: pins, UART or I2C bus, and at most 1000 Hz",
)


NO_DRIVER_CLASS = Rule(
    "no-driver-class",
    "The module of a sensor neither defines nor imports nor assigns the class that the sensor names. The board would "
    "find that out when it asks the sensor for the first time.",
)
BROKEN_DRIVER_MODULE = Rule(
    "broken-driver-module",
    "The module with the class of a sensor is no Python, so that no board can import it.",
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
        hint: str | None,
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
                self.bad(
                    "driver", f"{what} is on no known board: say which, such as board: pico_2_w", hint="board: pico_2_w"
                )
        return self.board

    def within(self, key: str, value: int, low: int, high: int) -> int:
        """A whole number, which has to lie between two others."""
        if not low <= value <= high:
            self.bad(key, f"{key} is {value}, not {low} to {high}", hint=f"{key}: {min(max(value, low), high)}")
        return value

    def pin(self, key: str, gpio: int, choices: frozenset[int], what: str, board: BoardModel) -> int:
        """A GPIO number, which has to be one of ``choices`` that the board does not need for itself."""
        if gpio not in choices & board.free:
            self.bad(key, *no_such_pin(what, gpio, choices, board, key.rpartition(".")[2]))
        return gpio


def check_class(name: str, module: DriverModule | None, place: Place, around: Around) -> None:
    """Report a class that the module of a driver does not have, as far as the project has the module."""
    if module is None:
        return
    at = Place(module.path, *(() if module.fault is None else (module.fault[0],)))
    file = os.path.basename(module.path)
    if module.fault is not None:
        around.report.add(
            BROKEN_DRIVER_MODULE,
            at,
            f"{file} is no Python: {module.fault[1]}",
            f"python -m py_compile {file} says more",
        )
    elif module.names is not None and name not in module.names:
        near = get_close_matches(name, module.classes, n=1)
        has = f"; it has {shortened_list(module.classes)}" if module.classes else ""
        hint = f"did you mean {near[0]}?" if near else f"write class {name} in {file}{has}"
        around.report.add(NO_DRIVER_CLASS, place, f"{file} has no class {name}", hint, [(at, "the module is here")])
    else:
        return
    around.failed = True


class KindOfSource(NamedTuple):
    """A kind of sensor: the word for it, the class of its keys, how it is resolved, and how often it is asked."""

    name: str
    spec: type[SourceSpec]
    resolve: Callable[[Any, Polling, Around], Source | None]
    rate: str
