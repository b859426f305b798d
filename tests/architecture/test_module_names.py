"""The names that a module of the user cannot have are those of all modules that any firmware or simulation has."""

from pathlib import Path

from codegen.sources.module_names import FIRMWARE, MICROPYTHON, SIMULATION, taken_by

ROOT = Path(__file__).resolve().parents[2]
RENDERED = {"dialect", "failsafes"}
"""Modules of firmware that no template of their own makes."""
NO_MODULES = {"message_class", "__init__"}
"""Templates of parts of modules."""


def stems(*folders: Path) -> set[str]:
    """The names of the modules that the templates of some folders make."""
    return {path.name.partition(".")[0] for folder in folders for path in folder.rglob("*.py*")} - {"__pycache__"}


def test_every_module_of_firmware_is_listed() -> None:
    """A new template takes a name from its users, who are told before a board is."""
    sensors = [path for path in (ROOT / "codegen" / "sources").rglob("firmware") if path.is_dir()]
    made = stems(ROOT / "templates" / "firmware", ROOT / "templates" / "codec", *sensors) - NO_MODULES
    assert made - FIRMWARE == set()
    assert FIRMWARE - made - RENDERED == set()


def test_every_module_of_the_simulation_is_listed() -> None:
    """Mocks lie on the path beside the user's code."""
    assert stems(ROOT / "templates" / "mocks") - SIMULATION - MICROPYTHON == set()


def test_whose_a_name_is() -> None:
    """A module in a folder is called as the folder is."""
    assert taken_by("station") == "the firmware"
    assert taken_by("machine.pins") == "MicroPython"
    assert taken_by("sim") == "the simulation"
    assert taken_by("sonar.near") is None
