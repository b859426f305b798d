"""What a dialect itself comes to say below a correction of the project is told: the corrected attribute hides it."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.cli import main

COMMANDED = Path(__file__).resolve().parents[1] / "projects" / "commanded" / "specs"
XML = """<mavlink>
<include>common.xml</include>
<enums>
<enum name="TANK_KIND"><entry name="TANK_FUEL" value="1"/><entry name="TANK_WATER" value="2"/></enum>
<enum name="MAV_CMD"><entry name="MAV_CMD_PUMP" value="44001">
<description>Pumps.</description><param index="1" label="Time" units="s">How long.</param></entry></enum>
</enums>
<messages>
<message id="44000" name="MY_TANK"><wip/><description>Tank.</description>
<field type="uint16_t" name="level" units="d%" invalid="0">Level</field>
<field type="uint8_t" name="kind" enum="TANK_KIND">Kind</field>
</message>
</messages>
</mavlink>"""
TABLE = """message: MY_TANK
requirement: FR-301.1
fields:
  level: {constant: 7}
  kind: {enum: TANK_WATER}
"""
COMMAND = """
  MAV_CMD_PUMP:
    doc: Pumps.
    method: drain
    requirement: FR-301.1
    params: {1: {name: time, unit: ms}}
"""
FIELD = "message: MY_TANK, field: level, set: {units: '%'}"
Compare = Callable[..., list[dict[str, object]]]


@pytest.fixture
def compared(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Compare:
    """Return the changes between two projects with one correction, of which the second has an edited dialect."""

    def compare(correction: str, old: str, new: str, other: str = "") -> list[dict[str, object]]:
        for side, text in (("old", XML), ("new", XML.replace(old, new))):
            specs = tmp_path / side / "specs"
            shutil.copytree(COMMANDED, specs)
            (specs / "dialects" / "mine.xml").write_text(text)
            said = (other if side == "new" else "") or correction
            correct = f"corrections:\n  - {{{said}, reason: it is so, source: its maker}}\n"
            (specs / "dialects" / "fix.yaml").write_text(correct)
            (specs / "messages" / "my_tank.yaml").write_text(TABLE)
            commands = specs / "commands.yaml"
            commands.write_text(commands.read_text().rstrip() + COMMAND)
            project = specs / "codegen.yaml"
            listed = "command_cancel.xml, dialects/mine.xml]\ncorrections: [dialects/fix.yaml]"
            project.write_text(project.read_text().replace("command_cancel.xml]", listed))
        assert XML.count(old) == 1
        main(["diff", str(tmp_path / "old" / "specs"), str(tmp_path / "new" / "specs"), "--format", "json"])
        told = json.loads(capsys.readouterr().out)
        assert told["errors"] == []
        return told["changes"]

    return compare


@pytest.mark.parametrize(
    ("correction", "old", "new", "subject", "was", "is_now"),
    [
        (FIELD, '"d%"', '"c%"', "MY_TANK.level", "units d%", "units c%"),
        (FIELD, ' units="d%"', "", "MY_TANK.level", "units d%", "units not stated"),
        ("message: MY_TANK, fields: le*, set: {invalid: UINT16_MAX}", '"0"', '"1"', "MY_TANK.level", "invalid 0",
         "invalid 1"),
        ("message: MY_TANK, set: {id: 44002}", "44000", "44003", "MY_TANK", "id 44000", "id 44003"),
        ("message: MY_TANK, set: {description: Water}", "Tank.", "Hold.", "MY_TANK", "description Tank.",
         "description Hold."),
        ("enum: TANK_KIND, entry: TANK_WATER, set: {value: 3}", 'value="2"', 'value="4"', "TANK_KIND.TANK_WATER",
         "value 2", "value 4"),
        ("enum: MAV_CMD, entry: MAV_CMD_PUMP, param: 1, set: {units: ms}", '"s"', '"min"', "MAV_CMD_PUMP.1",
         "units s", "units min"),
    ],
)  # fmt: skip
def test_what_a_correction_hides_needs_a_person(
    correction: str, old: str, new: str, subject: str, was: str, is_now: str, compared: Compare
) -> None:
    """It was made for what stood there: of fields, messages, entries and parameters, at the correction."""
    (change,) = compared(correction, old, new)
    told = {key: change[key] for key in ("rule", "weight", "subject", "old", "new")}
    assert told == {
        "rule": "corrected-attribute-changed", "weight": "person", "subject": subject, "old": was, "new": is_now,
    }  # fmt: skip
    assert str(change["file"]).endswith("fix.yaml")


def test_a_correction_that_says_something_else_is_another_change(compared: Compare) -> None:
    """Somebody has looked at it: what the attribute is now is compared as ever."""
    other = "message: MY_TANK, field: level, set: {units: cm}"
    (change,) = compared(FIELD, '"d%"', '"c%"', other)
    assert change["rule"] == "field-units-changed"


def test_what_changes_beside_the_corrected_attribute_is_told_as_itself(compared: Compare) -> None:
    """The correction is of the unit alone."""
    (change,) = compared(FIELD, ">Level<", ">Level of it<")
    assert change["rule"] == "description-changed"
