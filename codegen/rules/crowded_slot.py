"""Slots of control in which more is due than there is time for."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.loop.budget import loop_budget
from codegen.model.system import System

RULE = Rule(
    "crowded-slot",
    "What is due together takes longer than a slot of control, before control() does anything and a message is sent: "
    "so slots are missed each time. It is predicted for boards of which it is known how fast they are, and "
    "`codegen explain loop` tells what takes how long. Lower the rate of control, or of what is due with it, or take "
    "fewer samples.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Tell of the longest slot of a program, if it is too long."""
    budget = loop_budget(system)
    if budget is None or system.program is None:
        return
    slot = max(budget.slots, key=lambda slot: slot.quiet.instructions)
    took = slot.quiet.likely_us
    if took is not None and took > budget.control_us:
        message = f"{slot.words} take {round(took)} us on the {system.board_name}, and control is due every "
        hint = "codegen explain loop tells what takes how long; a lower rate of control leaves more time"
        place = system.program.spec.control.at("rate")
        yield Diagnostic(place, RULE, f"{message}{budget.control_us} us", hint)
