"""Pages are rendered once for all tests."""

import os
import shutil
import sys
from pathlib import Path

import pytest
from rendered import PROJECTS, Program, programs_of

NODE = Path(sys.executable).with_name("node")
if NODE.exists():  # installed where the system has none; playwright's own needs a library that a bare system lacks
    os.environ.setdefault("PLAYWRIGHT_NODEJS_PATH", str(NODE))


@pytest.fixture(scope="session")
def projects() -> dict[str, list[Program]]:
    """The programs by project."""
    return {name: programs_of(folder) for name, folder in PROJECTS.items()}


@pytest.fixture(scope="session")
def shipped(projects: dict[str, list[Program]]) -> list[Program]:
    """The rover and its smart battery."""
    return projects["shipped"]


@pytest.fixture(scope="session")
def every(projects: dict[str, list[Program]]) -> list[Program]:
    """Every program of every project."""
    return [program for programs in projects.values() for program in programs]


@pytest.fixture(scope="session")
def longest(tmp_path_factory: pytest.TempPathFactory) -> Program:
    """A project with payloads of 254 and 255 bytes: one of zeros alone, one of every value that a byte has."""
    specs = tmp_path_factory.mktemp("longest") / "specs"
    shutil.copytree(PROJECTS["minimal"], specs)
    project = specs / "codegen.yaml"
    project.write_text(project.read_text().replace("dialect: minimal", "dialect: common"))
    data = {f"data[{index}]": index or 250 for index in range(249)}
    for name, values in {
        "FILE_TRANSFER_PROTOCOL": {"target_network": 0, "payload": 0},
        "LOGGING_DATA": {"sequence": 65535, "length": 249, "first_message_offset": 1, **data},
    }.items():
        answers = {"target_system": 0, "target_component": 0, **values}
        rows = "".join(f"  {field}: {{constant: {value}}}\n" for field, value in answers.items())
        table = f"message: {name}\nrequirement: FR-1\nstream: only\nfields:\n{rows}"
        (specs / "messages" / f"{name.lower()}.yaml").write_text(table)
    (program,) = programs_of(specs)
    return program
