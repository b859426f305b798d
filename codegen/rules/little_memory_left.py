"""Programs that leave too little of the memory of their board for running."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.findings.fingerprint import fingerprint
from codegen.memory.estimate import memory_estimate
from codegen.memory.words import advice, found_words, share_words
from codegen.model.system import System

RULE = Rule(
    "little-memory-left",
    f"Once it has started the program takes more than {share_words()} of the heap that MicroPython has on the board. "
    "What it does then takes up to a quarter more: frames, texts, modules that are loaded when somebody asks for them; "
    "your own code comes on top. It is an estimate from what the specification has, and `codegen explain heap` has "
    "what takes how much. Leave out tables and fields that nobody reads, set machine_code: false, choose a board with "
    "more memory, or let modules run in place, from a ROMFS or frozen into MicroPython. Who has seen it run there "
    "waives this in waivers.yaml.",
    Severity.WARNING,
    remedy="codegen explain heap tells what takes how much",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Tell of a program that may find room on its board, and too little of it."""
    estimate = memory_estimate(system)
    if estimate is not None and estimate.leaves_too_little and not estimate.never_fits:
        place = system.spec.board.at("board")
        about = f"{system.board_name} {system.spec.program}"
        message = f"{found_words(estimate, system.board_name)}: more than {share_words()} of it"
        yield Diagnostic(place, RULE, message, advice(estimate), (), fingerprint(RULE.id, place.file, about))
