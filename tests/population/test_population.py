"""Populated fields carry the values set: messages with fields of every kind on three interpreters; faults show.

`make conformance` proves all messages of the dialect; here are those in which every kind of field occurs.
"""

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import population.building
import pytest
from population.chosen import chosen, traits
from population.comparing import Outcome, prove
from population.expected import nearest
from population.fields import Message, read_messages
from population.whole import KNOWN, LARGEST, batches, included, unlisted
from pymavlink.dialects.v20 import ardupilotmega

from codegen.answers.limits import Bounds
from codegen.model.code.statements import scaled
from codegen.model.spec.population import Rounding

PARTS = 2


@pytest.fixture(scope="module")
def messages() -> dict[str, Message]:
    """All messages of the dialect, as pymavlink has them."""
    return read_messages(LARGEST, ardupilotmega)


@pytest.fixture(scope="module")
def few(messages: dict[str, Message]) -> list[Message]:
    """Messages that have every kind of field."""
    return chosen(messages)


@pytest.mark.parametrize("part", range(PARTS))
def test_every_kind_of_field_carries_what_was_set(few: list[Message], tmp_path: Path, part: int) -> None:
    """Machine code, plain Python and words of 32 bits send the same, and it is right to the last bit."""
    outcome = prove(LARGEST, ardupilotmega, few[part::PARTS], tmp_path, rounds=1)
    assert not outcome.differences
    assert outcome.refused.keys() <= KNOWN.keys(), outcome.refused
    assert outcome.proven
    assert all(outcome.frames[name] for name in outcome.values)
    assert sum(outcome.withheld.values())


def test_the_choice_has_every_kind_of_field(messages: dict[str, Message], few: list[Message]) -> None:
    """Nothing that occurs in the dialect is left to the whole proof alone; that has every message once."""
    assert len(few) < len(messages) / 4
    every = {trait for message in messages.values() for trait in traits(message)}
    assert {trait for message in few for trait in traits(message)} == every
    assert sorted(message.id for batch in batches(messages.values()) for message in batch) == sorted(
        ardupilotmega.mavlink_map
    )
    assert len(included(messages)) > 200


def test_a_refusal_that_is_not_known_is_a_difference() -> None:
    """So is one that is known and no longer there: the list has to stay true."""
    assert unlisted(Outcome(refused={"SOME.field": "no-sentinel"}))
    assert not unlisted(Outcome(refused=dict(KNOWN)))


def test_the_nearest_float_is_found_without_floats() -> None:
    """Halves go to the even one; a double in between would round twice."""
    step = Fraction(1, 1 << 23)
    assert nearest(1 + step / 2, "f") == 1.0
    assert nearest(1 + 3 * step / 2, "f") == float(1 + 2 * step)
    assert nearest(1 + step / 2 + Fraction(1, 1 << 80), "f") == float(1 + step)
    assert nearest(Fraction(1, 1 << 150), "f") == 0.0
    assert nearest(Fraction(3, 1 << 151), "f") == 2.0**-149
    assert nearest(-(Fraction(10) ** 39), "f") == -3.4028234663852886e38


def text(file: str, old: str, new: str) -> Callable[[pytest.MonkeyPatch], None]:
    """A fault in a file of the firmware."""
    render = population.building.render_firmware

    def broken(system: Any) -> dict[str, str]:
        files = render(system)
        assert old in files[f"firmware/{file}"]
        files[f"firmware/{file}"] = files[f"firmware/{file}"].replace(old, new)
        return files

    return lambda patch: patch.setattr("population.building.render_firmware", broken)


def code(target: str, instead: Any) -> Callable[[pytest.MonkeyPatch], None]:
    """A fault in the generator."""
    return lambda patch: patch.setattr(target, instead)


def without_multiplier(patch: pytest.MonkeyPatch) -> None:
    from codegen.model.dialect import wire_unit  # noqa: PLC0415 - only this fault needs it

    def wrong(field: Any) -> Any:
        return wire_unit.Unit.parse(field.definition.units) if field.definition.units else wire_unit.NUMBER

    patch.setattr("codegen.answers.fitting.wire_unit", wrong)
    patch.setattr("codegen.resolve.quantities.kept.wire_unit", wrong)


def one_less(bounds: Bounds) -> tuple[Fraction, Fraction]:
    assert bounds.low is not None
    assert bounds.high is not None
    return Fraction(-(-bounds.low // 1)), Fraction(bounds.high // 1 - 1)


def rounded_down(factor: Fraction, _: Rounding) -> list[str]:
    return scaled(factor, Rounding.DOWN)


SOME = (
    "GPS_RAW_INT",
    "RANGEFINDER",
    "EXTENDED_SYS_STATE",
    "SYSTEM_TIME",
    "SCALED_IMU3",
    "CAMERA_FOV_STATUS",
    "HIGH_LATENCY2",
)

FAULTS: dict[str, Callable[[pytest.MonkeyPatch], None]] = {
    "a multiplier": without_multiplier,
    "a limit of a type": code("codegen.answers.limits.Bounds.whole", one_less),
    "a limit of the dialect": code("codegen.answers.source.dialect_bounds", lambda _: Bounds(None, None)),
    "a value that is the sentinel": code("codegen.answers.live.kept_apart", lambda *_: None),
    "an entry that is the sentinel": code("codegen.answers.live.kept_apart", lambda _, sentinel: sentinel),
    "a rounding": code("codegen.answers.filling.scaled", rounded_down),
    "a sentinel": text("telemetry_plain.py", "65535 if value", "65534 if value"),
    "what is withheld": text("telemetry_plain.py", "        return None\n", "        pass\n"),
    "what is too old": text("telemetry_plain.py", " & 0x3FFFFFFF < 0x1FFFFFFF:", " & 0x3FFFFFFF >= 0x1FFFFFFF:"),
    "the rounding of a float": text("floats_plain.py", "(value + 1 + ((value >> 2) & 1))", "value"),
    "the highest half": text("wide.py", "        value >>= 16\n", "        value >>= 15\n"),
    "a clock that is set": text("clock_plain.py", "        tick(self.words, 0)\n        set", "        set"),
    "CRC_EXTRA": text("messages.py", "CRC_EXTRA = ", "CRC_EXTRA = 1 + "),
}


def prove_some(messages: dict[str, Message], folder: Path) -> Outcome:
    return prove(LARGEST, ardupilotmega, [messages[name] for name in SOME], folder, rounds=3, forms=["plain Python"])


def test_without_a_fault_nothing_differs(messages: dict[str, Message], tmp_path: Path) -> None:
    """Else the faults below would show nothing."""
    assert not prove_some(messages, tmp_path).differences


@pytest.mark.parametrize("fault", FAULTS)
def test_the_proof_finds_faults(
    messages: dict[str, Message], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fault: str
) -> None:
    """A proof that nothing could fail would prove nothing."""
    FAULTS[fault](monkeypatch)
    assert prove_some(messages, tmp_path).differences
