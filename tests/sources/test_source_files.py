"""The files that kinds of sensors bring along: each in its folder, and machine code only where the project has it."""

from dataclasses import replace
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.model.code.clock import CLOCK
from codegen.model.system import System
from codegen.project.systems import read_system
from codegen.targets.source_files import mock_paths, source_files

SPECS = Path(__file__).resolve().parents[1] / "projects" / "sensors" / "specs" / "codegen.yaml"
DRIVERS = {"ina219", "ina226", "nmea", "nmea_plain", "pulse", "registers", "satellite_clock", "sentences_plain"}
IN_MACHINE_CODE = {"nmea_viper", "sentences_viper"}
OWN = {"compass", "user_source"}


@pytest.fixture(scope="module")
def sensors() -> System:
    system = read_system(str(SPECS), Report())
    assert system is not None
    return system


def brought(system: System, folder: str) -> set[str]:
    """The names of the modules that come into a folder."""
    return {path.removeprefix(f"{folder}/").removesuffix(".py") for path in source_files(system, folder)}


def test_each_folder_has_its_own(sensors: System) -> None:
    """The project's own drivers are firmware; what stands in for hardware, and tests, are not."""
    assert brought(sensors, "firmware") == DRIVERS | IN_MACHINE_CODE | OWN
    assert brought(sensors, "mocks") == {"mock_i2c", "mock_pulse", "sim_monitor", "sim_nmea"}
    assert brought(sensors, "tests") == {"nmea_driver", "nmea_lines", "monitor_device", "nmea_device", "pulse_device"}
    assert len(mock_paths(sensors)) == len(set(mock_paths(sensors))) == 4


def test_a_project_without_machine_code_has_the_plain_modules(sensors: System) -> None:
    spec = replace(sensors.spec, project=replace(sensors.spec.project, machine_code=False))
    assert brought(replace(sensors, spec=spec), "firmware") == DRIVERS | OWN


def test_a_project_without_a_clock_needs_none_of_satellites(sensors: System) -> None:
    components = {name: component for name, component in sensors.components.items() if name != CLOCK}
    found = brought(replace(sensors, components=components), "firmware")
    assert found == (DRIVERS - {"satellite_clock"}) | IN_MACHINE_CODE | OWN
