"""Failsafes of vehicles that have no other ones: the generated suite makes each condition hold, and is green."""

import shutil
from pathlib import Path

import pytest
from generated_suite import suite_is_green
from in_process import build

HERE = Path(__file__).resolve().parent

STATE = """
  tank:
    doc: A tank.
    requirement: FR-301.1
    quantities:
      level: {doc: How full it is., min: 0, max: 100}
"""
FAILSAFE = """
failsafes:
  tank:
    watches: tank.level
    levels: {bad: {§}}
    after: 1 s
    when: always
    arming: false
    requirement: FR-301.1
"""
LEVELS = {
    "one-sense-with-hysteresis": "below: 10, after: 1 s}}\n    latch: false\n    hysteresis: 2 #",
    "above-or-unknown": "above: 90, or: [{unknown: true, after: 2 s}]",
    "below-or-unknown": "below: 10, or: [{unknown: true, after: 2 s}]",
}


@pytest.mark.parametrize("kind", LEVELS)
def test_a_failsafe_alone_does_what_it_says(kind: str, tmp_path: Path) -> None:
    """With a hysteresis where all conditions have one sense, and waiting for unknown beside another condition."""
    specs = shutil.copytree(HERE / "commanded" / "specs", tmp_path / "specs")
    for name, text in (("state", STATE), ("vehicle", FAILSAFE.replace("§", LEVELS[kind]))):
        with (specs / f"{name}.yaml").open("a") as file:
            file.write(text)
    build(tmp_path)
    suite_is_green(tmp_path, "generated/tests/test_program.py", only="micropython-watched")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", ""),  # the text that all failsafes without one have has a blank in any case
        (', text: "{name} {value:.1}degC"', "unknown degC"),
        (', text: "{name} {value or nothing:.1}%"', "nothing %"),
        (', text: "{name} {value or 0:.1}degC"', ""),
        (', text: "{name} {value:.1} degC"', ""),
    ],
)
def test_a_unit_behind_the_word_for_unknown_has_a_blank(text: str, said: str, tmp_path: Path) -> None:
    """A number stands right before its unit, 9.5degC, and a word does not."""
    specs = shutil.copytree(HERE / "commanded" / "specs", tmp_path / "specs")
    level = LEVELS["above-or-unknown"].replace("90", "90 degC") + text
    state = STATE.replace("full it is.,", "warm it is., unit: degC,")
    for name, added in (("state", state), ("vehicle", FAILSAFE.replace("§", level))):
        with (specs / f"{name}.yaml").open("a") as file:
            file.write(added)
    build(tmp_path)
    firmware = (tmp_path / "generated" / "firmware" / "failsafe.py").read_text()
    word = said.partition(" ")[0]
    assert not said or f'"{word} ")' in firmware, firmware
    assert "unknowndegC" not in firmware
    assert said or ' ")' not in firmware.partition("def _tank_text")[2]
    suite_is_green(tmp_path, "generated/tests/test_program.py", only="micropython-watched")
