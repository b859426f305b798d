"""The function that makes the texts of a failsafe: what can be unknown where it is shown is looked at first."""

from types import SimpleNamespace
from typing import Any

import pytest

from codegen.model.failsafe import Clause, FailsafeText, Sense, Shown
from codegen.targets.firmware.failsafes.text import ZERO, shows, text_lines

VOLTAGE: Any = SimpleNamespace(name="voltage", initial=None)
CURRENT: Any = SimpleNamespace(name="current", initial=None)
COUNT: Any = SimpleNamespace(name="count", initial=0)


def text(*parts: str | Shown | Clause) -> FailsafeText:
    return FailsafeText("".join(map(str, parts)), parts)


def level(name: str, said: FailsafeText, *senses: Sense) -> Any:
    return SimpleNamespace(name=name, text=said, conditions=tuple(SimpleNamespace(sense=each) for each in senses))


def failsafe(*levels: Any, over: FailsafeText | None = None, latch: bool = True) -> Any:
    return SimpleNamespace(levels=levels, over=over, quantity=VOLTAGE, recovers=not latch)


def volts(unknown: str = "?") -> Shown:
    return Shown(VOLTAGE, 2, unknown)


LOW = text("{name} is low: ", volts(), " V")
FORMATTED = ['return f"{title} is low: {battery.voltage:.2f} V"']
LOOKED_AT = ['voltage = _shown(battery.voltage, 2, "?")', 'return f"{title} is low: {voltage} V"']
AMPS = text("at ", Shown(CURRENT, 0, "no"), " A")


@pytest.mark.parametrize(
    ("found", "lines", "has_unknown"),
    [
        (failsafe(level("low", LOW, Sense.BELOW)), FORMATTED, False),
        (failsafe(level("low", LOW, Sense.BELOW, Sense.BELOW)), LOOKED_AT, True),
        (failsafe(level("low", LOW, Sense.UNKNOWN)), LOOKED_AT, True),
        (failsafe(level("low", LOW, Sense.BELOW), level("worse", LOW, Sense.BELOW)), FORMATTED, False),
        (failsafe(level("low", LOW, Sense.BELOW), level("worse", LOW, Sense.UNKNOWN)), LOOKED_AT, True),
        (failsafe(level("low", LOW, Sense.UNKNOWN), level("worse", LOW, Sense.BELOW)), LOOKED_AT, True),
        (failsafe(level("low", AMPS, Sense.BELOW)),
         ['current = _shown(battery.current, 0, "no")', 'return f"at {current} A"'], True),
        (failsafe(level("low", text(Shown(COUNT, 0, "no")), Sense.UNKNOWN)), ['return f"{battery.count:.0f}"'], False),
        (failsafe(level("low", text(Shown(CURRENT, 1, ZERO)), Sense.BELOW)),
         ["current = battery.current or 0", 'return f"{current:.1f}"'], False),
        (failsafe(level("low", text("is low"), Sense.BELOW)), ['return "is low"'], False),
        (failsafe(level("low", text(""), Sense.BELOW)), ['return ""'], False),
    ],
)  # fmt: skip
def test_a_text_shows_what_was_compared_as_it_is(found: Any, lines: list[str], has_unknown: bool) -> None:
    """With one condition that compares it, it is known; of several another one may have led to the level."""
    assert list(text_lines(found, "battery")) == lines
    assert shows(found) is has_unknown


def test_levels_have_their_own_texts_and_the_end_has_one() -> None:
    """At the end nothing was compared."""
    levels = level("low", LOW, Sense.BELOW), level("worse", text("gone"), Sense.UNKNOWN)
    found = failsafe(*levels, over=text("{name} is well: ", volts()))
    assert list(text_lines(found, "battery")) == [
        "if level is None:",
        '    voltage = _shown(battery.voltage, 2, "?")',
        '    return f"{title} is well: {voltage}"',
        'if level == "low":',
        '    return f"{title} is low: {battery.voltage:.2f} V"',
        'return "gone"',
    ]
    assert shows(found)
    assert not shows(failsafe(*levels))
    assert shows(failsafe(level("low", LOW, Sense.BELOW), level("worse", text("gone", volts()), Sense.UNKNOWN)))


def test_what_it_falls_back_to_may_be_unknown_by_then() -> None:
    """A worse level that another quantity has led to is over while the one that is watched is unknown."""
    levels = level("low", LOW, Sense.BELOW), level("worse", text("bad"), Sense.BELOW, Sense.ABOVE)
    looked_at = [f"    {line}" for line in LOOKED_AT]
    assert list(text_lines(failsafe(*levels, latch=False), "battery")) == [
        'if level == "low":',
        *looked_at,
        'return "bad"',
    ]
    assert shows(failsafe(*levels, latch=False))
    assert not shows(failsafe(*levels))


def test_a_clause_is_left_out_while_a_quantity_in_it_is_unknown() -> None:
    """One that is known for certain is shown without a question."""
    certain = Clause(("{name} has ", volts(), " V"))
    doubtful = Clause((" at ", Shown(CURRENT, 1, ""), " A"))
    found = failsafe(level("low", text("Oh: ", certain, doubtful, "."), Sense.BELOW))
    assert list(text_lines(found, "battery")) == [
        'said = "Oh: "',
        'said += f"{title} has {battery.voltage:.2f} V"',
        "if battery.current is not None:",
        '    said += f" at {battery.current:.1f} A"',
        'return said + "."',
    ]
    found = failsafe(level("low", text(Clause((volts(), Shown(CURRENT, 1, "")))), Sense.UNKNOWN))
    assert list(text_lines(found, "battery")) == [
        'said = ""',
        "if battery.voltage is not None and battery.current is not None:",
        '    said += f"{battery.voltage:.2f}{battery.current:.1f}"',
        "return said",
    ]
