"""Numbers that no float is are those that a document names: the largest one of 64 bits is the sentinel that it is."""

from pathlib import Path

import pytest

from codegen.cli import main

DIALECT = (
    '<mavlink><messages><message id="54001" name="LAB_COUNT"><description>Counts.</description>'
    '<field type="uint64_t" name="total" invalid="UINT64_MAX">All of them.</field>'
    '<field type="int64_t" name="change" invalid="INT64_MAX">The last.</field></message></messages></mavlink>'
)
RIGHT = """# LAB_COUNT (54001)

LAB_COUNT.total is UINT64_MAX if unknown. LAB_COUNT.change is 9223372036854775807 if unknown.

| Field | Type | Unknown |
| --- | --- | --- |
| total | uint64_t | UINT64_MAX |
| change | int64_t | INT64_MAX |
"""


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("", "", None),
        ("total is UINT64_MAX", "total is 0", "LAB_COUNT.total is unknown when it is UINT64_MAX, not 0"),
    ],
)
def test_the_largest_number_is_the_sentinel(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], old: str, new: str, says: str | None
) -> None:
    """As it is named, and as it is written out; another one is told."""
    (tmp_path / "lab.xml").write_text(DIALECT)
    document = tmp_path / "lab.md"
    document.write_text(RIGHT.replace(old, new))
    main(["check", "--dialect", str(tmp_path / "lab.xml"), str(document)])
    out = capsys.readouterr().out
    assert (says in out) if says else ("claim" not in out), out


def test_a_number_that_means_unknown_is_none_for_an_amount(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A row has the sentinel of the field and an amount beside it: neither is the other one."""
    document = tmp_path / "status.md"
    head = "# SYS_STATUS (1)\n\n| Field | Unit | Unknown | Value |\n| --- | --- | --- | --- |\n"
    document.write_text(head + "| current_battery | cA | -1 | 1.5 A |\n")
    main(["check", "--dialect", "common", str(document)])
    assert "claim-scaling" not in capsys.readouterr().out
    document.write_text(head + "| current_battery | cA | -1 | 1.5 A = 1500 |\n")
    main(["check", "--dialect", "common", str(document)])
    assert "1.5 A is 150 in SYS_STATUS.current_battery (cA), not 1500" in capsys.readouterr().out
