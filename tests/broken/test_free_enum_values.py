"""Numbers that a description leaves to anybody need no entry of the enum; others are not-an-enum-value."""

import re
import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.findings.text import finding_text
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "three_cameras" / "specs"
TABLE = """message: TUNNEL
requirement: FR-1.1
stream: VIDEO
fields:
  target_system: {constant: 0}
  target_component: {constant: 0}
  payload_type: {constant: %d}
  payload_length: {constant: 1}
  payload: {constant: 7}
"""


@pytest.mark.parametrize(("number", "is_right"), [(40000, True), (32768, True), (32767, False), (199, False)])
def test_codes_of_ones_own(number: int, is_right: bool, tmp_path: Path) -> None:
    """TUNNEL.payload_type: codes greater than 32767 are considered local experiments."""
    shutil.copytree(SPECS, tmp_path / "specs")
    (tmp_path / "specs" / "messages" / "tunnel.yaml").write_text(TABLE % number)
    report = Report()
    read_systems(str(tmp_path / "specs" / "codegen.yaml"), report)
    found = [finding_text(each) for each in report if re.search("tunnel", finding_text(each))]
    assert [text for text in found if "not-an-enum-value" not in text and "error" in text] == []
    assert bool([text for text in found if "error not-an-enum-value" in text]) != is_right
