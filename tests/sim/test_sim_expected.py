"""Expectations hold to the step: whole numbers of any size exactly, others to what is kept, or what a field carries."""

import struct
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.decode.scenario import decode_scenarios
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.scenario import Expectation
from codegen.model.system import System
from codegen.project.systems import read_system
from codegen.resolve.scenarios.scenario import resolve_scenarios
from codegen.sim.expected import unmet
from codegen.sim.sample import Reading
from codegen.sim.told import Telling

PROJECTS = Path(__file__).resolve().parents[1] / "projects"


@pytest.fixture(scope="module")
def system() -> System:
    """The system of wide_values."""
    found = read_system(str(PROJECTS / "wide_values" / "specs" / "codegen.yaml"), Report())
    assert found is not None
    return found


def expected(system: System, folder: Path, written: str) -> tuple[Expectation, ...]:
    """Return what a scenario expects that says so."""
    path, report = folder / "scenarios.yaml", Report()
    path.write_text(f"scenarios:\n  a:\n    doc: d\n    duration: 1 s\n    expect: [{{{written}}}]\n")
    spec = decode_scenarios(str(path), DISK, report)
    assert spec is not None
    scenarios = resolve_scenarios(spec, system, report)
    assert not list(report)
    return scenarios["a"].expected


def missed(found: tuple[Expectation, ...], *, state: Any = None, reading: Reading | None = None) -> list[str]:
    """Return what does not hold where the state has, or a message told, that."""
    program = SimpleNamespace(lines=[SimpleNamespace(label=each.label, unit="") for each in found])
    recording: Any = SimpleNamespace(
        at_ms=1000,
        program=program,
        scenario=SimpleNamespace(expected=found),
        state=lambda *_: state,
        reading=lambda *_: reading,
    )
    return unmet(recording)


FLOAT = struct.unpack("<f", struct.pack("<f", 12.6))[0]
STATES = (
    ("big, is: 18446744073709551615", 2**64 - 1, True),
    ("big, is: 18446744073709551614", 2**64 - 1, False),
    ("big, between: [9007199254740993, 9007199254740993]", 2**53 + 1, True),
    ("big, between: [9007199254740992, 9007199254740992]", 2**53 + 1, False),
    ("time, is: -9223372036854775807 us", -(2**63) + 1, True),
    ("time, is: -9223372036854775808 us", -(2**63) + 1, False),
    ("level, is: 100000", 100000, True),
    ("level, is: 100000", 99999, False),
    ("level, is: unknown", None, True),
    ("level, is: 0", None, False),
    ("lon, is: 179.9999999 deg", 1799999999 / 1e7, True),
    ("lon, is: 179.9999999 deg", 1799999998 / 1e7, False),
    ("lon, is: 179.9999999 deg", 1800000000 / 1e7, False),
    ("lon, between: [179.9999998 deg, 179.9999999 deg]", 1799999998 / 1e7, True),
    ("lon, between: [179.9999998 deg, 179.9999999 deg]", 1799999997 / 1e7, False),
    ("voltage, is: 12.6 V", 12600 / 1000, True),
    ("voltage, is: 12600.4 mV", 12600 / 1000, True),
    ("voltage, is: 12.6 V", 12601 / 1000, False),
    ("voltage, between: [12.6 V, 12.7 V]", 12.6, True),
    ("until, is: 1800 s", 0.5, True),
    ("until, is: 1800 s", 1801 / 3600, False),
    ("angle, is: 12.6 rad", FLOAT, True),
    ("angle, is: 12.6 rad", FLOAT + 4e-6, False),
    ("angle, between: [12.6 rad, 13 rad]", FLOAT - 4e-7, True),
    ("angle, is: 180 deg", struct.unpack("<f", struct.pack("<f", 3.141592653589793))[0], True),
    ("angle, is: 1 rad", float("nan"), False),
    ("distance, is: 0.1 m", 0.1, True),
    ("distance, is: 0.1 m", 0.1 + 1e-13, False),
)


@pytest.mark.parametrize(("written", "found", "holds"), STATES)
def test_the_state_is_right_to_the_step(written: str, found: Any, holds: bool, system: System, tmp_path: Path) -> None:
    """Of a whole number the next one is another one; a float is right to its last digits."""
    assert (missed(expected(system, tmp_path, f"state: meter.{written}"), state=found) == []) is holds


@pytest.mark.parametrize(
    ("written", "wire", "holds"),
    [
        ("big, is: 9007199254740993", {"big": 2**53 + 1}, True),
        ("big, is: 9007199254740992", {"big": 2**53 + 1}, False),
        ("time, is: -9223372036854775807 us", {"signed_big": -(2**63) + 1}, True),
        ("time, is: -9223372036854775806 us", {"signed_big": -(2**63) + 1}, False),
        ("lon, is: 179.9999999 deg", {"lon": 1799999999}, True),
        ("lon, is: 180 deg", {"lon": 1799999999}, False),
        ("angle, is: 12.6 rad", {"real": FLOAT}, True),
        ("angle, is: 12.6 rad", {"real": FLOAT + 4e-6}, False),
        ("distance, is: 0.1 m", {"long_real": 0.1}, True),
        ("distance, is: 0.1 m", {"long_real": 0.1 + 1e-13}, False),
    ],
)
def test_what_was_told_is_right_to_the_step_of_its_field(
    written: str, wire: Mapping[str, float], holds: bool, system: System, tmp_path: Path
) -> None:
    """A frame of MAVLink 2 whose payload is packed here, decoded as a simulation does it."""
    (table,) = system.tables("WIDE_VALUES")
    payload = bytearray(table.wire.length)
    ((name, number),) = wire.items()
    field = next(each for each in table.wire.fields if each.name == name)
    struct.pack_into(f"<{field.type.code}", payload, field.offset, number)
    head = bytes((0xFD, len(payload), 0, 0, 0, 1, 1)) + table.wire.id.to_bytes(3, "little")
    path = f"meter.{written.partition(',')[0]}"
    told = [each for each in Telling([table]).read(head + payload, {}) if each.path == path]
    reading = Reading(0, told[0].value, told[0].exact, told[0].precision)
    assert (missed(expected(system, tmp_path, f"told: meter.{written}"), reading=reading) == []) is holds


def test_what_was_found_is_told_to_its_last_digit(system: System, tmp_path: Path) -> None:
    """Where nine digits look like what was expected, too."""
    for written, found, said in (
        ("big, is: 9007199254740992", 2**53 + 1, "it is 9007199254740993."),
        ("lon, is: 179.9999999 deg", 1799999998 / 1e7, "it is 179.9999998."),
        ("angle, is: 1 rad", 1.5, "it is 1.5."),
        ("angle, is: 1 rad", float("nan"), "it is nan."),
    ):
        (line,) = missed(expected(system, tmp_path, f"state: meter.{written}"), state=found)
        assert line.endswith(f": {said}")
