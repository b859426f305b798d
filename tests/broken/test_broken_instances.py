"""Lists of instances and families of parameters that cannot be: each fault is reported where it was made.

The cases are written as those of ``test_broken_tables``, and change the shipped specification with its two batteries.
"""

import pytest
from test_broken_tables import BATTERY, Case, changed_copy, check_place, name_of

from codegen.cli import main

FIRST = "    - {prefix: BATT_, doc"
SECOND = "    - prefix: BATT2_\n      doc"
FAMILY = "  BATT_CAPACITY:\n"
EACH = FAMILY + "    doc: Charge of the full pack.\n    for_each: battery\n"
LAST = "  SR0_EXT_STAT:\n"
CASES = [
    # the list
    Case("bad-instances", "board.yaml", "instances:\n  battery:", "instances:\n  batery: §[]\n  battery:", "batery"),
    Case("bad-instances", "board.yaml", "prefix: BATT2_", "prefix: §BATT_", "prefix", is_alone=False),
    Case("bad-instances", "board.yaml", "prefix: BATT2_", "prefix: §batt2_", "batt2_", is_alone=False),
    Case("bad-instances", "board.yaml", SECOND, "    - §doc", "no prefix", is_alone=False),
    # as its parameters are called: BATT_VOLT_PIN
    Case("bad-instances", "board.yaml", SECOND, "    - §doc", "hint: prefix: BATT2_", is_alone=False),
    Case("bad-instances", "board.yaml", FIRST, "    - §{doc", "hint: prefix: BATT_\n", is_alone=False),
    Case(
        "bad-instances",
        "state.yaml",
        "  battery:\n    doc: One",
        "  batteri:\n    doc: One",
        "no component battery",
        at="board.yaml:64:5",
        is_alone=False,
    ),
    # defaults
    Case("bad-instances", "board.yaml", "BATT2_VOLT_PIN: 27", "BATT2_VOLT_PN: §27", "BATT2_VOLT_PIN", is_alone=False),
    Case("bad-instances", "board.yaml", "BATT2_VOLT_PIN: 27", "SR0_EXTRA1: §27", "SR0_EXTRA1", is_alone=False),
    Case("bad-parameter", "board.yaml", "BATT2_VOLT_PIN: 27", "BATT2_VOLT_PIN: §29", "BATT2_VOLT_PIN"),
    Case("bad-parameter", "board.yaml", "BATT2_VOLT_PIN: 27", "BATT2_VOLT_PIN: §26.5", "BATT2_VOLT_PIN"),
    # facts and cells
    Case("bad-parameter-family", "board.yaml", "    cells: 3\n", "", "cells", is_alone=False),
    Case("bad-parameter-family", "board.yaml", "    cells: 3\n", "    cells: 2.5\n", "cells", is_alone=False),
    # earlier names
    Case("bad-parameter", "parameters.yaml", LAST, LAST + "    was: {SYSID_THISMAV: §1}\n", "a parameter of today"),
    Case("bad-parameter", "parameters.yaml", LAST, LAST + "    was: {rate: §1}\n", "rate is not a parameter name"),
    Case("bad-parameter", "parameters.yaml", LAST, LAST + "    was: {SR_EXT: §0}\n", "not 0 times"),
    # families
    Case(
        "bad-parameter-family",
        "parameters.yaml",
        FAMILY,
        "  §PACK_CAPACITY:\n",
        "hint: prefix: PACK_ of the first battery, or call it BATT_CAPACITY",
        is_alone=False,
    ),
    Case("bad-parameter-family", "parameters.yaml", FAMILY, "  §CAPACITY:\n", "BATT_", is_alone=False),
    Case("bad-parameter-family", "parameters.yaml", EACH, EACH.replace("battery", "§bat"), "battery", is_alone=False),
    Case("bad-parameter-family", "parameters.yaml", LAST, f"{LAST}    per: §cells\n", "no component"),
    Case("bad-parameter", "parameters.yaml", FAMILY, "  §BATT_CAPACITY_ALL:\n", "BATT_CAPACITY_ALL", is_alone=False),
    Case(
        "bad-parameter",
        "parameters.yaml",
        FAMILY,
        "  §BATT_CAPACITY_AL:\n",
        "BATT2_CAPACITY_AL is not a parameter name: it has 17",
        is_alone=False,
    ),
    # pins
    Case("shared-pin", "board.yaml", SECOND, SECOND.replace("prefix", "§prefix"), "GPIO 26"),
]


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    if case.rule == "shared-pin":
        both_on(tmp_path)
    check_place(case, tmp_path, monkeypatch, capsys)


def both_on(folder) -> None:
    """Switch both batteries on by default, at the same pin."""
    changed_copy(Case("", "board.yaml", "      defaults: {BATT2_MONITOR: 0, BATT2_VOLT_PIN: 27}\n", ""), folder)


@pytest.mark.usefixtures("without_output")
def test_a_pin_of_its_own_or_a_monitor_that_is_off(tmp_path, monkeypatch, capsys):
    """Either of the two defaults is enough: pins may be the same while one of the batteries is off."""
    for defaults in ("{BATT2_MONITOR: 0}", "{BATT2_VOLT_PIN: 27}"):
        folder = tmp_path / defaults.partition(":")[0][1:]
        folder.mkdir()
        changed_copy(Case("", "board.yaml", "{BATT2_MONITOR: 0, BATT2_VOLT_PIN: 27}", defaults), folder)
        monkeypatch.chdir(folder)
        assert main(["build"]) == 0, capsys.readouterr().out


def test_two_instances_with_one_id(tmp_path, monkeypatch, capsys):
    """Two batteries that receivers could not tell apart are an error."""
    changed_copy(Case("same-instance", BATTERY, "id: {state: battery.instance", "id: {constant: 0"), tmp_path)
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    assert " error same-instance: " in capsys.readouterr().out


SECOND_OFF = "      defaults: {BATT2_MONITOR: 0, BATT2_VOLT_PIN: 27}\n"
MORE = "    - {{prefix: BATT{0}_, doc: More., defaults: {{BATT{0}_VOLT_PIN: {1}}}}}\n"


@pytest.mark.usefixtures("without_output")
def test_the_hint_names_a_pin_that_is_free(tmp_path, monkeypatch, capsys):
    """A third on GPIO 26 gets the pin that nobody has, not that of the second, which is off; what it says is enough."""
    folders = iter("abcd")

    def out(*pins: int) -> tuple[int, str]:
        folder = tmp_path / next(folders)
        folder.mkdir()
        more = "".join(MORE.format(number, pin) for number, pin in enumerate(pins, 3))
        changed_copy(Case("", "board.yaml", SECOND_OFF, SECOND_OFF + more), folder)
        monkeypatch.chdir(folder)
        return main(["build"]), capsys.readouterr().out

    code, found = out(26)
    assert (
        code,
        found.count("shared-pin"),
        "hint: BATT3_VOLT_PIN: 27, as long as battery 2 is switched off\n" in found,
    ) == (1, 1, True), found
    code, found = out(28)
    assert code == 0, found
    code, found = out(28, 26)
    assert "hint: BATT4_VOLT_PIN: 27, as long as battery 2 is switched off\n" in found, found
    assert "no other pin of the Raspberry Pi Pico 2 W that could take its place is free" in out(28, 27, 26)[1]
