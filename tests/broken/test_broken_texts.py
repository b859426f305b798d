"""Texts that cannot be kept or sent as the tables ask: each fault is reported at its place, with what would fit.

The cases are written as those of ``test_broken_tables``.
"""

import shutil
from pathlib import Path

import pytest
from test_broken_tables import Case, check_place, name_of

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
STATE = "state.yaml"
INFO = "messages/smart_battery_info.yaml"
LEFT = "      left:\n        doc: Charge"
NUMBER = "serial_number: unknown"
NAME = "device_name: {board: battery.name}"


def quantity(about: str, says: str) -> Case:
    return Case("bad-quantity", STATE, LEFT, f"      label: {{doc: d, {about}}}\n{LEFT}", says)


CASES = [
    quantity("text: §0", "text of label is 0, not 1 to 255 bytes"),
    quantity("text: §256", "text of label is 256, not 1 to 255 bytes"),
    quantity("text: 8, min: §1", "label is a text quantity and cannot have min"),
    quantity("text: 8, unit: §V", "label is a text quantity and cannot have unit"),
    quantity("text: 8, elements: §cells", "label is a text and cannot have elements"),
    quantity("text: 8, boolean: §true", "label is a text and cannot have boolean"),
    quantity("text: 8, initial: §12", "initial of label is not a text\n  hint: initial: '12'"),
    quantity("text: 8, initial: §Größe 12", "is 10 bytes long, and 8 are kept\n  hint: initial: 'Größe '"),
    quantity('text: 8, initial: §"a\\0b"', "initial of label has a NUL in it"),
    quantity("text: 8, initial: a, stale_after: §1 s", "label has an initial value"),
    Case("bad-source", INFO, NUMBER, "serial_number: {state: §battery.left}", "battery.left is a number"),
    Case("bad-source", INFO, NUMBER, "serial_number: {parameter: §BATT_CAPACITY}", "and parameters are numbers"),
    Case("bad-source", INFO, NUMBER, "serial_number: {parameter: §BATT_CAPACITY}", "bytes it keeps: text: 16"),
    Case("bad-constant", INFO, NUMBER, "serial_number: {constant: §12}", "is no text\n  hint: '12'"),
    Case("bad-constant", INFO, NAME, f"device_name: {{constant: §{'Ä' * 26}}}", "is 52 bytes long in UTF-8"),
    Case("bad-constant", INFO, NAME, 'device_name: {constant: §"a\\0b"}', "has a NUL in it, which ends a text"),
]


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        (
            "weight: {board: battery.weight}",
            "weight: {state: battery.label}",
            "error bad-source: battery.label is a text",
        ),
        ("on_change: battery.swaps", "on_change: battery.label", "error bad-announcement: battery.label is a text"),
        (NAME, "device_name: {state: battery.label, max: 3}", "error pointless-key: max says nothing"),
        (NAME, "device_name: {state: battery.label}", ""),
    ],
)
def test_where_a_text_of_the_state_does_not_fit(old, new, told, tmp_path, monkeypatch, capsys):
    """A number has no text, texts are not watched, and limits are for numbers. What fits is no finding."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    state, table = tmp_path / "specs" / STATE, tmp_path / "specs" / INFO
    assert LEFT in state.read_text()
    assert old in table.read_text()
    state.write_text(state.read_text().replace(LEFT, f"      label: {{doc: d, text: 8}}\n{LEFT}"))
    table.write_text(table.read_text().replace(old, new))
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == bool(told)
    assert told in capsys.readouterr().out
    assert not (tmp_path / "generated").exists()
