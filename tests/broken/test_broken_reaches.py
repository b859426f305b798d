"""Quantities that the ADC or a message is too small for: a warning with its place and a number that is enough."""

import pytest
from test_broken_generations import changed

from codegen.cli import main

pytestmark = pytest.mark.usefixtures("without_output")

SECOND = "      defaults: {BATT2_MONITOR: 0, BATT2_VOLT_PIN: 27}\n"
MULTIPLIER = "    default: 3.95\n"

CASES = {
    "cells 4": (
        [("board.yaml", "    cells: 3\n", "    cells: 4\n")],
        "specs/board.yaml:47:12: warning reach-beyond-adc: battery 1 and 2 reach 16.8 V, and the ADC shows 13.035 V",
        "BATT_VOLT_MULT of at least 5.091, 5.2528 for the warning above 17.333 V",
    ),
    "cells 4 of the second": (
        [("board.yaml", SECOND, f"{SECOND}      facts: {{cells: 4}}\n")],
        "warning reach-beyond-adc: battery 2 reaches 16.8 V",
        "BATT2_VOLT_MULT of at least 5.091",
    ),
    "facts beat the curve": (
        [("board.yaml", "charging_maximum_voltage: 4.2 V", "charging_maximum_voltage: 4.35 V")],
        "battery 1 and 2 reach 13.05 V",
        "BATT_VOLT_MULT of at least 3.9546",
    ),
    "beyond the parameter": (
        [("board.yaml", "    cells: 3\n", "    cells: 15\n")],
        "battery 1 and 2 reach 63 V",
        "its max in parameters.yaml is 10, raise it, too",
    ),
    "more cells than elements": (
        [("board.yaml", "    cells: 3\n", "    cells: 15\n")],
        "specs/board.yaml:47:12: warning values-beyond-message: battery 1 has 15 cells, and BATTERY_STATUS has room for 14",
        "battery.voltage is sent instead",
    ),
}


def check(folder, monkeypatch, capsys, changes):
    """Return the exit code and the output of the command for a changed copy of the shipped specification.

    A check would read all documents, too, which is most of its time.
    """
    changed(folder, *changes)
    monkeypatch.chdir(folder)
    code = main(["build"])
    return code, capsys.readouterr().out


@pytest.mark.parametrize("name", CASES)
def test_is_warned_about(name, tmp_path, monkeypatch, capsys):
    """The finding stands at the cells, names the battery, and says what is enough; it does not stop the build."""
    changes, *parts = CASES[name]
    code, out = check(tmp_path, monkeypatch, capsys, changes)
    assert code == 0, out
    for part in parts:
        assert part in out, out


@pytest.mark.parametrize("cells", [1, 2, 3])
def test_packs_that_fit(cells, tmp_path, monkeypatch, capsys):
    """Nothing is said of packs that the ADC shows whole."""
    changes = [] if cells == 3 else [("board.yaml", "    cells: 3\n", f"    cells: {cells}\n")]
    _, out = check(tmp_path, monkeypatch, capsys, changes)
    for rule in ("reach-beyond-adc", "unreachable-threshold", "values-beyond-message"):
        assert rule not in out, out


def test_as_many_cells_as_elements(tmp_path, monkeypatch, capsys):
    """Fourteen cells fill both arrays of BATTERY_STATUS; they are too many for the ADC only."""
    _, out = check(tmp_path, monkeypatch, capsys, [("board.yaml", "    cells: 3\n", "    cells: 14\n")])
    assert "reach-beyond-adc" in out, out
    assert "values-beyond-message" not in out, out


def test_the_multiplier_that_the_hint_names_is_enough(tmp_path, monkeypatch, capsys):
    """With it neither the pack nor the warning is beyond the ADC; one step less is too little for the warning."""
    cells = ("board.yaml", "    cells: 3\n", "    cells: 4\n")
    for default, rules in (
        ("5.2528", []),
        ("5.2527", ["unreachable-threshold"]),
        ("5.091", ["unreachable-threshold"]),
        ("5.0909", ["reach-beyond-adc"]),
    ):
        folder = tmp_path / default
        folder.mkdir()
        changes = [cells, ("parameters.yaml", MULTIPLIER, f"    default: {default}\n")]
        _, out = check(folder, monkeypatch, capsys, changes)
        found = [rule for rule in ("reach-beyond-adc", "unreachable-threshold") if rule in out]
        assert found == rules, (default, out)


def test_a_warning_per_needs_cells(tmp_path, monkeypatch, capsys):
    """A pack without a number of cells is an error at the key, as for every limit per cell."""
    changes = [("board.yaml", "    cells: 3\n", "")]
    code, out = check(tmp_path, monkeypatch, capsys, changes)
    assert code == 1
    assert (
        "specs/state.yaml:34:14: error bad-following: board.yaml does not state the fact cells of battery 1" in out
    ), out


def test_per_is_for_facts(tmp_path, monkeypatch, capsys):
    """Only a fact of the board can be multiplied with the cells, and only a number or an amount."""
    file, old = "messages/battery_info.yaml", "weight: {board: battery.weight}"
    for index, (new, rule) in enumerate(
        (
            ("weight: {constant: 250 g, per: cells}", "error pointless-key: per says nothing without board"),
            ("weight: {board: battery.chemistry, per: cells}", "error unknown-fact: battery.chemistry of"),
        )
    ):
        folder = tmp_path / str(index)
        folder.mkdir()
        code, out = check(folder, monkeypatch, capsys, [(file, old, new)])
        assert code == 1
        assert rule in out, out
