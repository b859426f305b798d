"""The expressions by which a failsafe knows whether it watches: its own switch, that of its component, and arming."""

from collections.abc import Iterable

from codegen.targets.firmware.failsafes.arguments import Settled
from codegen.targets.firmware.failsafes.condition import guarded
from codegen.targets.firmware.words import Layout


def armed_constant(found: Settled, layout: Layout) -> tuple[str, ...]:
    """Return the constant of whether the vehicle is armed, where one of the failsafes rests while it is not."""
    if found.is_same("is_always"):
        return ()
    return (f"_ARMED = const({layout.blocks['vehicle'].offsets['armed']})  # among the words of the vehicle",)


def when_off(found: Settled) -> str:
    """Return the condition under which the component that is watched is switched off; nothing where none can be."""
    place = found("switch_at")
    return guarded(found.only_some("switch_at"), place, f"not self._words[{place}]") if found.has("switch_at") else ""


def when_off_to_arm(found: Settled) -> str:
    """Return the condition under which it is off to whoever arms: its component, or itself."""
    off, disabled = when_off(found), when_disabled(found)
    if off and disabled:
        return f"({off}) or {disabled}"
    return off or bare(disabled)


def when_disabled(found: Settled) -> str:
    """Return the condition under which its own switch is off; nothing where none has one."""
    if not found.has("enabled_by"):
        return ""
    off = f"getattr(self._parameters, {found('enabled_by')}) == 0"
    return f"({found('enabled_by')} is not None and {off})" if found.only_some("enabled_by") else off


def bare(condition: str) -> str:
    """Return a condition without the parentheses around it."""
    return condition[1:-1] if condition.startswith("(") else condition


def watching_lines(found: Settled) -> Iterable[str]:
    """The body of the method that says so, where it is more than one thing."""
    disabled = when_disabled(found)
    if disabled:
        yield f"if {bare(disabled)}:"
        yield "    return False"
    armed = "self._vehicle_words[_ARMED]"
    yield (
        f"return self._is_always or {armed}"
        if found.has("is_always") and not found.is_same("is_always")
        else ("return True" if found.is_same("is_always") else f"return {armed}")
    )


def while_watching(found: Settled) -> str:
    """The condition under which times run; nothing where they always do."""
    armed = "self._vehicle_words[_ARMED]"
    if found.has("is_always"):
        armed = "" if found.is_same("is_always") else f"(self._is_always or {armed})"
    disabled = when_disabled(found)
    enabled = f"not {disabled}" if disabled.startswith("(") else disabled.replace("== 0", "!= 0")
    return " and ".join(filter(None, (armed, enabled)))


def flags(watching: str, *, has_silence: bool) -> str:
    """Return the expression that tells watch() whether times run, and whether nobody is heard."""
    timed = f"1 if {watching} else 0" if watching else "1"
    if not has_silence:
        return timed
    silent = "2 if self._is_silent else 0"
    return f"({timed}) | ({silent})" if watching else "3 if self._is_silent else 1"
