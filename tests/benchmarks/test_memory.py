"""The estimate of the heap that a program takes is what the program has in use on a MicroPython of 32 bits.

As far as it may be off by its own words. Machine code is compared by the sizes of .mpy files.
"""

from dataclasses import replace
from pathlib import Path

import memory
import memory_projects
import pytest

from codegen.memory.estimate import ACCURACY, memory_estimate
from codegen.model.system import System

LARGE = memory_projects.Drawn(30, 20, 120, 5)
"""A project to which no cost was fitted, of some 250 KB."""


def system_of(name: str, folder: Path) -> System:
    """The first program of a project."""
    if name == LARGE.name:
        return memory_projects.draw(LARGE, folder / "large")
    return memory_projects.systems_of(dict(memory_projects.shipped())[name])[0]


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")  # the rover was measured with these
@pytest.mark.parametrize("name", ["rover", "boat", "received", LARGE.name])
def test_estimate_is_what_the_program_takes(name: str, tmp_path: Path) -> None:
    """Without machine code, which this MicroPython does not run, and what machine code adds to that."""
    system = system_of(name, tmp_path)
    project = replace(system.spec.project, machine_code=False)
    plain = memory_estimate(replace(system, spec=replace(system.spec, project=project)))
    assert plain is not None
    started = memory.started(system, tmp_path / "program")
    assert abs(plain.bytes - started) <= ACCURACY * started, (plain.bytes, started)
    whole = memory_estimate(system)
    assert whole is not None
    assert system.board is not None
    code = memory.machine_code(system)[system.board.spec.architecture]
    assert abs(whole.bytes - started - code) <= ACCURACY * (started + code), (whole.machine_code, code)
