"""Claims about a draft that is not in use: a passage that names its overlay is held to that overlay, and no other one is."""

import re
import shutil
from pathlib import Path

import pytest

from codegen.cli import main

SPECS = Path(__file__).resolve().parents[2] / "specs"
UPSTREAM, DRAFT = "dialects/battery_upstream.xml", "dialects/battery_rfc_0018.xml"
CELLS, FAULTS = "dialects/battery_cell_voltages_rfc_0018.xml", "dialects/battery_cell_faults_rfc_0018.xml"

RIGHT = f"""
With `{UPSTREAM}`, BATTERY_STATUS_V2 (ID 369) has 27 bytes of payload and CRC_EXTRA 145.

With `{DRAFT}`, BATTERY_STATUS_V2 (ID 369) has 24 bytes of payload and CRC_EXTRA 151.

- {CELLS}: BATTERY_CELL_VOLTAGES (ID 54371), 28 bytes of payload.
- {FAULTS}: BATTERY_CELL_VOLTAGES (ID 54372), 10 bytes of payload.

| What | Value |
| --- | --- |
| `{UPSTREAM}`: MAV_BATTERY_STATUS_FLAGS_EXTENDED (2147483648), BATTERY_STATUS_V2 | 27 bytes |
| `{DRAFT}`: BATTERY_STATUS_V2 | 24 bytes |
"""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The shipped specification, of which tests choose the overlays."""
    return Path(shutil.copytree(SPECS, tmp_path_factory.mktemp("drafts") / "specs"))


def found(project: Path, status: str, cells: str, text: str, capsys: pytest.CaptureFixture[str]) -> list[str]:
    """What is said about a document while the project lists these two overlays: rules and what is right."""
    file = project / "codegen.yaml"
    listed = re.sub(f"{UPSTREAM}|{DRAFT}", status, (SPECS / "codegen.yaml").read_text())
    file.write_text(re.sub(f"{CELLS}|{FAULTS}", cells, listed))
    document = project.parent / "notes.md"
    document.write_text(text)
    main(["check", str(document), "--project", str(project)])
    return re.findall(r"(?m)^notes\.md:\S+ error (.*)$|^\S*/notes\.md:\S+ error (.*)$", capsys.readouterr().out)


CHOICES = pytest.mark.parametrize(("status", "cells"), [(UPSTREAM, CELLS), (DRAFT, CELLS), (UPSTREAM, FAULTS)])


@CHOICES
def test_each_draft_has_figures_of_its_own(
    status: str, cells: str, project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Whichever is listed, what a document says of each is right at once."""
    assert found(project, status, cells, RIGHT, capsys) == []


@CHOICES
@pytest.mark.parametrize(
    ("old", "new", "times"),
    [
        ("27 bytes", "24 bytes", 2),
        ("24 bytes", "27 bytes", 2),
        ("CRC_EXTRA 145", "CRC_EXTRA 151", 1),
        ("CRC_EXTRA 151", "CRC_EXTRA 145", 1),
        ("54372", "54371", 1),
        ("54371", "54372", 1),
        ("10 bytes", "28 bytes", 1),
        ("(2147483648)", "(4294967295)", 1),
        (UPSTREAM, DRAFT, 3),
    ],
)
def test_each_draft_is_judged_whichever_is_in_use(
    old: str, new: str, times: int, status: str, cells: str, project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The name of an overlay silences nothing: the figures of the other one are wrong beside it."""
    assert len(found(project, status, cells, RIGHT.replace(old, new), capsys)) >= times


@pytest.mark.parametrize(
    "text",
    [
        "BATTERY_STATUS_V2 has 24 bytes of payload.",
        "`dialects/no_such_overlay.xml`: BATTERY_STATUS_V2 has 24 bytes of payload.",
        "`dialects/upstream.xml`: BATTERY_STATUS_V2 has 24 bytes of payload.",
        f"`my/{DRAFT}`: BATTERY_STATUS_V2 has 24 bytes of payload.",
        f"`{UPSTREAM}` or `{DRAFT}`: BATTERY_STATUS_V2 has 24 bytes of payload.",
        f"`{DRAFT}` is another draft.\n\nBATTERY_STATUS_V2 has 24 bytes of payload.",
        f"`{DRAFT}`: HEARTBEAT has 24 bytes of payload.",
    ],
)
def test_all_else_is_held_to_what_is_in_use(text: str, project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A name that is no overlay, several of them, one in another paragraph, or a message that no overlay adds."""
    assert len(found(project, UPSTREAM, CELLS, f"{text}\n", capsys)) == 1
