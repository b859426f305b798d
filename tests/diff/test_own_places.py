"""No change stands in a file of corrections that comes with codegen: nobody who reads the report can edit that."""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.decode.dialect.files import decode_dialect_files
from codegen.decode.shipped_corrections import shipped_corrections
from codegen.diagnostics import Report
from codegen.diff.system.system import compare_dialects
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_path
from codegen.resolve.dialect.dialect import resolve_dialect

SPECS = Path(__file__).resolve().parents[1] / "projects" / "two_batteries" / "specs"
REFUSED = """
refuse:
  - {message: SMART_BATTERY_INFO, fields: cycle_count, reason: Our receivers show 65535.}
  - {message: RC_CHANNELS, fields: rssi, reason: Our receivers show 255 as it is.}
"""


def refused(folder: Path) -> None:
    """Put a project there without and one with refusals of packaged corrections."""
    shutil.copytree(SPECS, folder / "old" / "specs")
    shutil.copytree(SPECS, folder / "new" / "specs")
    corrections = folder / "new" / "specs" / "dialects" / "corrections.yaml"
    corrections.write_text(corrections.read_text() + REFUSED)


def test_a_refusal_that_goes_stands_at_the_table_or_where_the_dialect_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    refused(tmp_path)
    monkeypatch.chdir(tmp_path)
    main(["diff", "new", "old", "--all", "--allow-errors"])
    found = [line for line in capsys.readouterr().out.splitlines() if " field-sentinel-changed: " in line]
    table = (SPECS / "messages" / "smart_battery_info.yaml").read_text().splitlines()
    answer = next(number for number, line in enumerate(table, 1) if line.strip().startswith("cycle_count"))
    assert [(line.split(": ")[0], line.split(": ")[2]) for line in found] == [
        (f"old/specs/messages/smart_battery_info.yaml:{answer}:3", "SMART_BATTERY_INFO.cycle_count"),
        ("old/specs/codegen.yaml:2:10", "RC_CHANNELS.rssi"),
    ]


def test_where_both_stood_before_is_told_in_the_same_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    refused(tmp_path)
    monkeypatch.chdir(tmp_path)
    main(["diff", "old", "new", "--all", "--allow-errors"])
    shown = capsys.readouterr().out
    assert "old/specs/codegen.yaml:2:10: before" in shown
    assert "codegen/corrections/" not in shown


def test_between_dialects_alone_it_stands_at_the_field_of_the_xml() -> None:
    path = shipped_dialect_path("common", DISK)
    assert path is not None
    report = Report()
    read = decode_dialect_files(path, DISK, report)
    plain = resolve_dialect("common", read, (), report)
    corrected = resolve_dialect("common", read, (), report, shipped_corrections(read, DISK, report))
    changes = compare_dialects(plain, corrected).changes
    assert "RC_CHANNELS.rssi" in {change.subject for change in changes}
    assert {Path(change.place.file).suffix for change in changes} == {".xml"}
