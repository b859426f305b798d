"""A table that takes a number for a value to which the dialect's words give another meaning is told so; others are not.

The cases change tests/projects/received.
"""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main

SPECS = Path(__file__).resolve().parents[1] / "projects" / "received" / "specs"
REFUSED = """corrections: []
refuse: [{message: RC_CHANNELS_OVERRIDE, fields: chan1_raw, reason: To see what is said then.}]
"""
TABLE = """receive: PARAM_MAP_RC
requirement: FR-1.10
fields:
  param_index: {state: stick.index%s}
"""


@pytest.fixture
def checked(tmp_path, monkeypatch, capsys):
    """Check the project with a table for PARAM_MAP_RC, whose index has -1, the sentinel, and -2; return the warnings."""
    shutil.copytree(SPECS, tmp_path / "specs")
    monkeypatch.chdir(tmp_path)
    state = tmp_path / "specs" / "state.yaml"
    state.write_text(state.read_text().replace("      ahead: {", "      index: {doc: d}\n      ahead: {"))

    def check(keys=None):
        if keys is not None:
            (tmp_path / "specs" / "receives" / "map.yaml").write_text(TABLE % keys)
        else:
            text = state.read_text()
            state.write_text(text.replace("      index: {doc: d}\n", ""))
        assert main(["check"]) in (0, 1)
        return [
            line for line in capsys.readouterr().out.splitlines() if "untreated-value" in line or "write un" in line
        ]

    return check


@pytest.mark.parametrize("keys", [", unknown: [-2]", ", unchanged: [-2]", ", unknown: []", ", min: -1"])
def test_a_table_that_says_what_becomes_of_it_is_right(checked, keys):
    """By a list, an empty one, or limits."""
    assert checked(keys) == []


def test_a_number_that_is_taken_for_a_value_is_told(checked):
    """At its line, with the words and what to write; the sentinel is unknown and no finding."""
    line, hint = checked("")
    assert line.startswith(
        "specs/receives/map.yaml:4:3: warning untreated-value: PARAM_MAP_RC.param_index has a number"
    )
    assert "'-2 to disable any existing map for this rc_channel_index', and it is taken as a value" in line
    assert "write unknown: [-2]" in hint


def test_what_comes_with_codegen_is_right(checked):
    """RC_CHANNELS_OVERRIDE, GPS_INPUT and the other tables of the project."""
    assert checked() == []


def test_a_sentinel_that_is_to_be_ignored_is_told(checked, tmp_path):
    """Where the correction is refused, 65535 is the sentinel, and the dialect's words say that it changes nothing."""
    project = tmp_path / "specs" / "codegen.yaml"
    project.write_text(project.read_text() + "corrections: [refused.yaml]\n")
    (tmp_path / "specs" / "refused.yaml").write_text(REFUSED)
    found = " ".join(checked())
    assert "chan1_raw has a number with a meaning of its own, 'UINT16_MAX means to ignore this field'" in found
    assert "it is taken as unknown" in found
    assert "write unchanged: [UINT16_MAX]" in found
    assert "'0 means to release this channel back to the RC radio', and it is taken as a value" in found


LEVER = """receive: GIMBAL_MANAGER_SET_PITCHYAW
requirement: FR-1.10
fields:
  pitch: {state: stick.index%s}
"""


@pytest.mark.usefixtures("checked")
@pytest.mark.parametrize("keys", ["", ", unchanged: [NaN]", ", unchanged: []", ", unknown: [NaN]"])
def test_nan_that_is_to_be_ignored_is_told(tmp_path, capsys, keys):
    """It is the sentinel and makes the quantity unknown, while the words say that nothing changes; unless it is listed."""
    state = tmp_path / "specs" / "state.yaml"
    state.write_text(state.read_text().replace("index: {doc: d}", "index: {doc: d, unit: rad}"))
    (tmp_path / "specs" / "receives" / "lever.yaml").write_text(LEVER % keys)
    main(["check"])
    out = capsys.readouterr().out
    said = (
        "GIMBAL_MANAGER_SET_PITCHYAW.pitch has a number with a meaning of its own, 'NaN to be ignored', and it is taken"
    )
    assert (f"{said} as unknown" in out) == (not keys)
    assert ("write unchanged: [NaN], or unchanged: [] where" in out) == (not keys)
    assert " error " not in out


MASKED = """receive: SET_POSITION_TARGET_LOCAL_NED
requirement: FR-1.10
%sfields:
  x: {state: stick.index}
"""


@pytest.mark.usefixtures("checked")
@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("where: {type_mask: 3576, coordinate_frame: 1}\n", ""),
        ("where: {coordinate_frame: 1}\n", "  type_mask: {state: stick.bits}\n"),
    ],
    ids=["where", "taken"],
)
def test_a_table_that_looks_at_the_mask_is_right(tmp_path, capsys, before, after):
    """It takes only what has those bits, or gives them to code."""
    state = tmp_path / "specs" / "state.yaml"
    text = state.read_text().replace(
        "      index: {doc: d}\n", "      index: {doc: d, unit: m, stored: mm}\n      bits: {doc: d}\n"
    )
    state.write_text(text)
    (tmp_path / "specs" / "receives" / "target.yaml").write_text(MASKED % before + after)
    main(["check"])
    out = capsys.readouterr().out
    assert "target.yaml" not in out


@pytest.mark.usefixtures("checked")
def test_a_mask_that_nobody_looks_at_is_told(tmp_path, capsys):
    """What the sender says is to be ignored would be taken for a value."""
    state = tmp_path / "specs" / "state.yaml"
    state.write_text(
        state.read_text().replace("      index: {doc: d}\n", "      index: {doc: d, unit: m, stored: mm}\n")
    )
    (tmp_path / "specs" / "receives" / "target.yaml").write_text(MASKED % "")
    main(["check"])
    out = capsys.readouterr().out
    assert (
        "warning untreated-mask: SET_POSITION_TARGET_LOCAL_NED.type_mask says with POSITION_TARGET_TYPEMASK_X_IGNORE"
        in out
    )
    assert "hint: write the bit of each field: unless: {type_mask: ...}, or take it: type_mask: {state: ...}, or" in out
    assert "or write where: {type_mask: 0}" in out
