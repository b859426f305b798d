"""A vehicle with many parameters and messages: checks that wait for something wait as long as that takes with these.

Each of these checks ran for a fixed time, or a fixed number of passes, and was red here though the firmware was right.
"""

import json
import shutil
from pathlib import Path

import pytest
from generated_suite import scripts_of
from in_process import build

BOAT = Path(__file__).resolve().parents[2] / "examples" / "boat"
PARAMETERS = 150
TABLES = 64
"""All are due at once, eight times as many as a pass sends."""
CHECKS = {
    "command": ("exceptions_have_failed", "refusals_have_failed"),
    "link": ("one_message_in_a_pass", "slow_line_takes_the_whole_list"),
    "parameter": ("list_is_complete", "change_is_announced_on_other_links"),
    "service": ("arming_by_command", "texts_in_chunks", "texts_reach_every_link"),
    "station": ("lists_of_parameters_go_side_by_side",),
}


@pytest.fixture(scope="module")
def tests(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The suite of the boat with many more parameters, and tables of a further stream."""
    folder = tmp_path_factory.mktemp("large") / "boat"
    shutil.copytree(BOAT, folder, ignore=shutil.ignore_patterns("generated"))
    kept = "type: uint8, default: 1, min: 0, max: 100, step: 1, requirement: FR-1.1"
    more = {
        "parameters.yaml": [f"LAB_P{number}: {{doc: P., {kept}}}" for number in range(PARAMETERS)],
        "streams.yaml": ["LAB: {doc: Measured in the laboratory., rate: 0.5 Hz, requirement: FR-1.1}"],
    }
    for name, lines in more.items():
        path = folder / "specs" / name
        path.write_text(path.read_text().rstrip("\n") + "".join(f"\n  {line}" for line in lines) + "\n")
    for number in range(TABLES):
        fields = f"time_boot_ms: {{clock: boot}}, name: {{constant: LAB{number}}}, value: {{constant: {number}}}"
        (folder / "specs" / "messages" / f"lab{number}.yaml").write_text(
            f"message: NAMED_VALUE_INT\nas: lab{number}\nrequirement: FR-1.1\nstream: LAB\nfields: {{{fields}}}\n"
        )
    build(folder)
    return folder / "generated" / "tests"


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_a_large_vehicle_has_the_time(tests: Path, interpreter: str) -> None:
    """Lists, texts and announcements come behind what is due, and as many parameters take as many passes."""
    asked = [f"{script} {name}" for script, names in CHECKS.items() for name in names]
    told = scripts_of(tests).run_under(interpreter, "checks_run.py", "9", *asked)  # a port of nobody's
    assert [json.loads(line) for line in told.splitlines()] == [[each, None] for each in asked]
