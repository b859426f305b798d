"""Programs that find no room in the memory of their board."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.findings.fingerprint import fingerprint
from codegen.memory.estimate import memory_estimate
from codegen.memory.words import advice, found_words
from codegen.model.system import System

RULE = Rule(
    "larger-than-memory",
    "The program does not find room in the heap that MicroPython has on the board: it would end with a MemoryError "
    "while it is imported. What it takes is estimated from what the specification has, and this is told where it is "
    "too much even if the estimate is off by a tenth; `codegen explain heap` has what takes how much. Leave out tables "
    "and fields that nobody reads, set machine_code: false, or choose a board with more memory. Modules that run in "
    "place, from a ROMFS or frozen into MicroPython, take about half: who installs them so waives this in "
    "waivers.yaml, with the reason. A module with PSRAM is a board of its own, with its `memory`.",
    remedy="codegen explain heap tells what takes how much",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Tell of a program that cannot be imported on its board."""
    estimate = memory_estimate(system)
    if estimate is not None and estimate.never_fits:
        place = system.spec.board.at("board")
        about = f"{system.board_name} {system.spec.program}"
        message = found_words(estimate, system.board_name)
        yield Diagnostic(place, RULE, message, advice(estimate), (), fingerprint(RULE.id, place.file, about))
