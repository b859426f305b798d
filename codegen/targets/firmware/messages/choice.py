"""Statements that choose which of several instances of a component a single message is about."""

from codegen.model.code.payload_code import UNKNOWN, indented
from codegen.model.system import Representation
from codegen.targets.firmware.messages.payload import SpelledCode
from codegen.targets.firmware.readings.reading import expires, expiry, forgetting


def choosing(choice: Representation, code: SpelledCode) -> list[str]:
    """Find the instance, and where its words begin."""
    component = choice.component
    enabled = " enabled" if component.enabled else ""
    if choice.parameter is not None:
        said = f"that {choice.parameter.name} says, from 1 there, or else the first{enabled} one"
        lines = [f"place = {code.parameter(choice.parameter)} - 1"]
    else:
        assert choice.quantity is not None
        said = f"whose {choice.quantity.name} is lowest, or else the first{enabled} one"
        lines = _lowest(choice, code)
    return [
        f"# The {component.name} {said}.",
        *lines,
        f"if place < 0 or place >= {component.instances}:",
        "    place = 0",
        code.reach(component.name, "place"),
        *_enabled(choice, code),
    ]


def _enabled(choice: Representation, code: SpelledCode) -> list[str]:
    """Return what chooses the first instance that is enabled, or the first of all, in place of one that is not."""
    component = choice.component
    if component.enabled is None:
        return []
    is_off = f"not {code.is_set(component.enabled)}"
    first = ["place = 0", code.reach(component.name, "place")]
    others = [f"while place < {component.instances - 1} and {is_off}:", *indented(["place += 1", first[1]])]
    return [f"if {is_off}:", *indented([*first, *others, f"if {is_off}:", *indented(first)])]


def _lowest(choice: Representation, code: SpelledCode) -> list[str]:
    component, quantity = choice.component, choice.quantity
    assert quantity is not None
    turn = [code.reach(component.name, "place")]
    if expires(component):
        turn += expiry(component.readings[:1], code, code.now())
    if quantity.ages:
        turn += forgetting(quantity, code, code.now())
    turn.append(f"level = {code.read(quantity)}")
    if component.enabled is not None:
        turn += [f"if not {code.is_set(component.enabled)}:", f"    level = {UNKNOWN}"]
    turn += [f"if level != {UNKNOWN} and (lowest == {UNKNOWN} or level < lowest):"]
    turn += ["    chosen = place", "    lowest = level", "place += 1"]
    start = ["chosen = -1", f"lowest = {UNKNOWN}", "place = 0"]
    return [*start, f"while place < {component.instances}:", *indented(turn), "place = chosen"]
