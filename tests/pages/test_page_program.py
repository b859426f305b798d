"""The page on what comes in has what the tables of a project say, and is there only where something comes in."""

import re
import shutil
from html import unescape
from pathlib import Path

import pytest
from rendered import unbroken

from codegen.cli import main

PROJECTS = Path(__file__).resolve().parents[1] / "projects"


def rows(page: str, table: str) -> list[list[str]]:
    """The cells of a table, with the names of its columns first."""
    section = page.split(f'<section id="{table}">')[1].split("</section>", maxsplit=1)[0]
    found = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row) for row in section.split("<tr>")[1:]]
    return [[unescape(cell) for cell in row] for row in found]


def built(name: str, folder: Path) -> str:
    """The page of a project."""
    specs = Path(shutil.copytree(PROJECTS / name / "specs", folder / "specs"))
    assert main(["build", "--project", str(specs / "codegen.yaml")]) == 0
    return unbroken((folder / "generated" / "docs" / "program.html").read_text())


def test_received_messages_are_shown_field_by_field(tmp_path: Path) -> None:
    """The page has what each sets, which numbers are taken, what makes it unknown, and when it is too old."""
    page = built("received", tmp_path)
    assert rows(page, "received-rc_channels_override") == [
        ["Field", "Unit", "Sets", "Taken", "Sets it unknown", "Leaves it", "Too old", "Criterion"],
        ["chan1_raw", "us", "rc.rudder", "1..65534 us", "0", "65535", "after 500 ms", "FR-1.3"],
        ["chan2_raw", "us", "rc.throttle", "1000..2000 us", "0", "65535", "never", "FR-1.4"],
        ["chan9_raw", "us", "rc.extra", "1..65533 us", "65534", "0, 65535, MAVLink 1", "never", "FR-1.3"],
    ]
    assert "From a system of which a ground station is heard on that link" in page
    assert "Only with gps_id 1." in page


def test_failsafes_actions_and_sensors_are_shown(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    """With the priority of the actions, and what each sensor gives."""
    page = built("watched_boat", tmp_path)
    assert ["sounder.depth", "1 shallow", "below SHALLOW, 1.5 m by default", "1000 ms", "stop", "FR-201.2"] in rows(
        page, "failsafes"
    )
    assert "the first in this order: stop, slow." in page
    assert ["stop", "2", "yes", "Stop the screw."] in [[*row[:2], *row[-2:]] for row in rows(page, "actions")]
    sensors = rows(built("sensors", tmp_path_factory.mktemp("sensors")), "sensors")
    assert ["sonar", "10 Hz", "2000 us", "FR-9.2"] in [[row[0], *row[-3:]] for row in sensors]


def test_a_project_in_which_nothing_comes_in_has_no_such_page(tmp_path: Path) -> None:
    """Nor a link to it."""
    specs = Path(shutil.copytree(PROJECTS / "minimal" / "specs", tmp_path / "specs"))
    assert main(["build", "--project", str(specs / "codegen.yaml")]) == 0
    docs = tmp_path / "generated" / "docs"
    assert not (docs / "program.html").exists()
    assert "program.html" not in (docs / "index.html").read_text()


def test_the_budget_of_the_main_loop_is_shown(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    """With what is left of each slot; in instructions only, where nobody knows how fast the board is."""
    page = built("named_tables", tmp_path)
    head, *slots = rows(page, "loop")
    assert head == ["Slot", "A second", "Likely us", "At most us", "Left to control()"]
    assert [row[0] for row in slots][:2] == ["links", "and all messages due"]
    assert all(int(row[2]) < int(row[3]) < 20000 for row in slots)
    assert ["pack", "pack is read, every 200 ms"] in rows(page, "loop-jobs")
    assert rows(page, "loop-longest")[0] == ["Part", "Takes", "Share"]
    slow = Path(shutil.copytree(PROJECTS / "named_tables" / "specs", tmp_path_factory.mktemp("slow") / "specs"))
    board = slow / "board.yaml"
    board.write_text(board.read_text().replace("board: pico_2", "board: pico"))
    assert main(["build", "--project", str(slow / "codegen.yaml")]) == 0
    page = (slow.parent / "generated" / "docs" / "program.html").read_text()
    assert rows(page, "loop")[0] == ["Slot", "A second", "Instructions"]
    assert "No times: nobody has measured how many cycles the RP2040 takes" in page
