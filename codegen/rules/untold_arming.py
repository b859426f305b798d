"""A HEARTBEAT that does not tell whether the vehicle is armed."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.armed_flag import ARMED, FIELD, FLAG, HEARTBEAT, armed_flag
from codegen.model.system import System

RULE = Rule(
    "untold-arming",
    "The vehicle can be armed, and the flag MAV_MODE_FLAG_SAFETY_ARMED of its HEARTBEAT is the same whether it is or "
    "not. Ground stations know it from nothing else: one shows a vehicle whose motors may turn as disarmed, or the "
    "other way, and may report that arming has failed.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """The table of HEARTBEAT, where the program has something to arm."""
    if system.program is None or system.program.spec.arming is None:
        return
    flag = armed_flag(system.messages)
    if flag is None or flag[0] is not flag[1]:
        return
    place = next(message.population.place for message in system.messages if message.wire.name == HEARTBEAT)
    told = "armed" if flag[0] else "disarmed"
    written = f"{FLAG} if {ARMED}"
    yield Diagnostic(
        place, RULE, f"{HEARTBEAT} tells that the vehicle is {told}, always", f"{FIELD}: {{flags: [..., {written}]}}"
    )
