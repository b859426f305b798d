"""The watchdog: ``watchdog`` of vehicle.yaml, and whether the board can do it."""

from collections.abc import Mapping

from codegen.diagnostics import Report, Rule
from codegen.measure import read_time
from codegen.model.board_model import BoardModel
from codegen.model.spec.program import VehicleSpec
from codegen.model.spec.spec import Requirement, Spec
from codegen.model.units.unit import unit_named
from codegen.model.watchdog import Watchdog
from codegen.resolve.citation import cite_aspects, cite_optional

SHORTEST_MS = 1000
"""Erasing a sector of flash, while which nothing runs, takes up to 400 ms. Source: W25Q16JV datasheet, tSE."""

BAD_WATCHDOG = Rule(
    "bad-watchdog",
    "A watchdog resets the board when the main loop stands still for its timeout. The board has to have one that takes "
    f"such a time, and less than {SHORTEST_MS} ms would also be used up by flash that is erased where parameters are "
    "saved. What boards can do is stated under watchdog in codegen/boards/ (docs/boards.md).",
)


def resolve_watchdog(
    spec: Spec, vehicle: VehicleSpec, model: BoardModel | None, index: Mapping[str, Requirement], report: Report
) -> Watchdog | None:
    """The watchdog; None, where it is not stated, or with findings where the board cannot do it."""
    written = vehicle.watchdog
    if written is None:
        return None
    citation = cite_optional(written.requirement, written.at("requirement"), index, report)
    aspects = cite_aspects(written, index, report)
    place = written.at("timeout")
    timeout_ms = read_time(written.timeout, unit_named("ms"), place, report)
    if timeout_ms is None:
        return None
    if model is None:
        if spec.board.board is None:  # else what is wrong with the board has been reported
            message = "nothing is known of the watchdog of this board"
            report.add(BAD_WATCHDOG, place, message, "say in board.yaml which it is, such as board: pico_2_w")
        return None
    board = model.watchdog
    if board is None:
        hint = "leave watchdog out, or state under watchdog of the board's file what it can do"
        report.add(BAD_WATCHDOG, place, f"{model.name} has no watchdog", hint)
        return None
    low = max(SHORTEST_MS, board.shortest_ms)
    if timeout_ms < low:
        message = f"{written.timeout} is less than a main loop may stand still where flash is erased"
        if board.shortest_ms > SHORTEST_MS:
            message = f"the watchdog of {model.name} takes {low} ms and more, not {written.timeout}"
        report.add(BAD_WATCHDOG, place, message, f"timeout: {low} ms or more")
        return None
    if board.longest_ms is not None and timeout_ms > board.longest_ms:
        message = f"the watchdog of {model.name} takes {board.longest_ms} ms at most, not {written.timeout}"
        report.add(BAD_WATCHDOG, place, message, f"timeout: {board.longest_ms} ms or less")
        return None
    return Watchdog(citation, aspects, timeout_ms, board)
