"""Courses of the voltage of packs at the rover's ADC inputs, and programs that find them."""

from functools import cache
from pathlib import Path
from typing import Any

from codegen.diagnostics import Report
from codegen.model.program_folders import ProgramFolders
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.scenario import Course, Point, Scenario
from codegen.model.system import System
from codegen.project.systems import read_system
from codegen.sim.guards import guards
from codegen.sim.line import lines_of, watched
from codegen.sim.program import SimulatedProgram
from codegen.sim.told import Telling, Told

ROOT = Path(__file__).resolve().parents[2]
VOLTAGE, SECOND = "battery.voltage", "battery[1].voltage"
FULL = 3.3 * 3.95
"""The voltage of a pack at full scale of the ADC."""


@cache
def rover() -> System:
    """The shipped system, which is read when a test begins, and not while tests are collected."""
    found = read_system(str(ROOT / "specs" / "codegen.yaml"), Report())
    assert found is not None
    return found


def pack(*points: tuple[int, float | None], label: str = VOLTAGE, gpio: int = 26, noise: float = 0.0) -> Course:
    """The voltage of a pack over time: pairs of ms and V."""
    through = SimulatedInput("adc", {"gpio": gpio, "zero": 0.0, "full": FULL}, {"fail": "ADC readings fail"})
    return Course(label, tuple(Point(*point) for point in points), through, noise)


def steady(volts: float, **rest: Any) -> Course:
    """A pack whose voltage stays."""
    return pack((0, volts), **rest)


def program(played: Scenario, folder: str = "", key: str | None = None, **rest: Any) -> SimulatedProgram:
    """A program with the rover's messages, quantities and failsafe; ``folder`` has its firmware and mocks."""
    values: dict[str, Any] = {
        "name": "own",
        "files": ("parameters.0", "parameters.1"),
        "events": played.events if key is None else (),
        "module": "rover",
        "messages": {wire.id: wire.name for wire in rover().wires},
        "telling": Telling(rover().messages),
        "lines": lines_of(rover(), played, key),
        "watched": watched(rover(), ()),
        "guards": guards(rover()),
    }
    return SimulatedProgram(
        key=key, folders=ProgramFolders(folder), stretches=played.stretches(key),
        **values | rest,
    )  # fmt: skip


def volts(value: float | None, instance: int = 0) -> Told:
    """Return the record that a voltage was told."""
    return Told(VOLTAGE, instance, value)
