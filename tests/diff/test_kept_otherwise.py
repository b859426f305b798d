"""What is measured, kept and stored: the same reading or number that is something else now is no harmless news."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.diff.change import Change, Weight
from codegen.diff.report.review import review
from codegen.diff.system.carrying import fields_by_source
from codegen.diff.system.system import compare_systems
from codegen.model.system import System
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]
ROVER, PROJECTS = ROOT / "specs", ROOT / "tests" / "projects"


def systems(folder: Path) -> tuple[System, ...]:
    """The systems of a project, which has nothing that is reported."""
    report = Report()
    found = read_systems(str(folder / "codegen.yaml"), report)
    assert not report.has_errors, list(report)
    return found


def compared(tmp_path: Path, project: str, *edits: tuple[str, str, str], back: bool = False) -> list[Change]:
    """The findings of edits ``(file, old, new)`` of a copy of a project, what follows from another one left out."""
    folder = tmp_path / project
    specs = Path(shutil.copytree(PROJECTS / project, folder, dirs_exist_ok=True)) / "specs"
    before = systems(specs)
    for file, old, new in edits:
        text = (specs / file).read_text()
        assert text.count(old) >= 1, f"{old!r} is not in {file}"
        (specs / file).write_text(text.replace(old, new, 1))
    sides = (systems(specs), before) if back else (before, systems(specs))
    return [group.first for group in review("", "", compare_systems(*sides)).groups]


CONNECTED = "whether what is connected was changed with it"
ORDER = "whether its driver gives the numbers in this order and these units"
NUMBERS = "whether it still gives the same numbers"
LESS = "whether values beyond its limits, which are narrower now, are meant"
BOARD, STATE, PARAMETERS = "board.yaml", "state.yaml", "parameters.yaml"

QUESTIONS = {
    "shunt": ("sensors", BOARD, "shunt: 2 mOhm", "shunt: 1 mOhm", CONNECTED),
    "address": ("sensors", BOARD, "address: 0x41", "address: 0x44", CONNECTED),
    "key of a driver": ("sensors", BOARD, "offset: 2.5", "offset: 3.5", CONNECTED),
    "unit of a class": (
        "sensors",
        BOARD,
        "unit: m, stored: mm, min: 0.2, max: 40",
        "unit: dm, stored: mm, min: 2, max: 400",
        ORDER,
    ),
    "pin": ("sensors", BOARD, "gpio: 15", "gpio: 16", CONNECTED),
    "order": (
        "sensors",
        BOARD,
        "      roll: {unit: deg, stored: cdeg, min: -180, max: 180}\n"
        "      pitch: {unit: deg, stored: cdeg, min: -90, max: 90}\n",
        "      pitch: {unit: deg, stored: cdeg, min: -90, max: 90}\n"
        "      roll: {unit: deg, stored: cdeg, min: -180, max: 180}\n",
        ORDER,
    ),
    "range of a sensor": ("sensors", BOARD, "min: 0.2, max: 40", "min: 0.5, max: 40", LESS),
    "other output": ("sensors", STATE, "source: imu.roll", "source: imu.pitch", NUMBERS),
    "range": ("slow_readings", STATE, "min: 0, max: 9000", "min: 0, max: 8000", LESS),
    "initial": (
        "sensors",
        STATE,
        "source: solar.voltage, stale_after: 1 s",
        "source: solar.voltage, initial: 1",
        "whether 1 V is what is told and acted on while nothing is known",
    ),
    "other initial": (
        "sensors",
        STATE,
        "initial: MAV_STATE_ACTIVE",
        "initial: MAV_STATE_BOOT",
        "whether 1 is what is told and acted on while nothing is known",
    ),
    "multiplier": ("slow_readings", BOARD, "multiplier: 100 degC/V", "multiplier: 90 degC/V", NUMBERS),
    "offset": ("slow_readings", BOARD, "offset: 0.5 V", "offset: 0.4 V", NUMBERS),
    "range of a parameter": (
        "sensors",
        PARAMETERS,
        "min: 0, max: 100000",
        "min: 0, max: 50000",
        "whether values are stored that become the default now",
    ),
    "value of a parameter gone": (
        "power_monitor",
        PARAMETERS,
        "values: {0: None, 3: Voltage, 4: Both}",
        "values: {0: None, 4: Both}",
        "whether 3, Voltage, is stored or set by anybody",
    ),
    "value of a parameter": (
        "power_monitor",
        PARAMETERS,
        "values: {0: None, 3: Voltage, 4: Both}",
        "values: {0: None, 3: Temperature, 4: Both}",
        "whether 3, Temperature, is what was Voltage",
    ),
}


@pytest.mark.parametrize("name", QUESTIONS)
def test_another_number_for_the_same_is_a_question(name: str, tmp_path: Path) -> None:
    """The gravest finding is the question, and no finding says less of the same."""
    project, *edit, doubt = QUESTIONS[name]
    found = compared(tmp_path, project, (edit[0], edit[1], edit[2]))
    assert found[0].weight is Weight.PERSON
    assert doubt in found[0].doubt.split(", and ")


HARMLESS = {
    "average": ("sensors", BOARD, "average: 8", "average: 16"),
    "wider": ("sensors", BOARD, "min: 0.2, max: 40", "min: 0.1, max: 50"),
    "one more output": (
        "sensors",
        BOARD,
        "      pitch: {unit: deg, stored: cdeg, min: -90, max: 90}\n",
        "      pitch: {unit: deg, stored: cdeg, min: -90, max: 90}\n"
        "      yaw: {unit: deg, stored: cdeg, min: 0, max: 360}\n",
    ),
    "kept more precisely": ("sensors", STATE, "unit: m, stored: cm", "unit: m, stored: mm"),
    "doc": ("sensors", STATE, "doc: What is below.", "doc: What lies below."),
    "same offset": ("slow_readings", BOARD, "offset: 0.5 V", "offset: 500 mV"),
    "same multiplier": ("slow_readings", BOARD, "multiplier: 2 m/V", "multiplier: 200 cm/V"),
    "wider parameter": ("sensors", PARAMETERS, "min: 0, max: 100000", "min: 0, max: 200000"),
    "one more value": ("power_monitor", PARAMETERS, "{0: None, 3: Voltage,", "{0: None, 2: Current, 3: Voltage,"),
    "respelt value": ("power_monitor", PARAMETERS, "3: Voltage,", "3: Voltage alone,"),
}  # fmt: skip


@pytest.mark.parametrize("name", HARMLESS)
def test_the_same_number_for_the_same_asks_nothing(name: str, tmp_path: Path) -> None:
    """Whatever it is read or kept with, and what comes beside it."""
    found = compared(tmp_path, HARMLESS[name][0], HARMLESS[name][1:])
    assert all(change.weight.is_harmless for change in found), found


def test_values_of_a_parameter_that_change_places_are_silent(tmp_path: Path) -> None:
    """What is stored stays, and means something else."""
    swap = (PARAMETERS, "3: Voltage, 4: Both", "3: Both, 4: Voltage")
    (change,) = compared(tmp_path, "power_monitor", swap)
    assert change.weight is Weight.SILENT
    assert "3 was Voltage and is Both, which was another number" in change.effect


def test_the_unit_that_code_uses_is_asked_for(tmp_path: Path) -> None:
    """The attribute keeps its name, and code its number."""
    found = compared(tmp_path, "sensors", (STATE, "unit: m, stored: cm", "unit: cm, stored: cm"))
    assert found[0].doubt == "whether code that sets or reads depth does so in cm"
    assert [change.rule.id for change in found if change.doubt] == ["quantity-unit-changed"]


def test_the_number_of_the_first_shifts_all(tmp_path: Path) -> None:
    """Which camera is number 2 is another one, whichever way it goes."""
    edit = (STATE, "    first_number: CAM_FIRST\n", "")
    for back in (False, True):
        found = compared(tmp_path, "three_cameras", edit, back=back)
        shifted = [change for change in found if change.rule.id == "component-instances-changed"]
        assert [change.doubt for change in shifted] == ["whether receivers know the instances by other numbers"]


@pytest.fixture(scope="module")
def rover() -> System:
    return systems(ROVER)[0]


def test_an_inverted_boolean_is_a_silent_break(rover: System) -> None:
    """Where a flag tells it; where nothing does, code may still act on it."""
    component, quantity = next(
        (each, one)
        for each in rover.components.values()
        for one in each.quantities.values()
        if hasattr(one.derivation, "is_below") and not one.derivation.own_floors and one.path in fields_by_source(rover)
    )

    def inverted(system: System) -> System:
        derivation = replace(quantity.derivation, is_below=not quantity.derivation.is_below)
        quantities = {**component.quantities, quantity.name: replace(quantity, derivation=derivation)}
        changed = replace(component, quantities=quantities)
        return replace(system, components={**system.components, component.name: changed})

    for system, weight in ((rover, Weight.SILENT), (replace(rover, messages=()), Weight.PERSON)):
        changes = compare_systems((system,), (inverted(system),)).changes
        (found,) = [each for each in changes if each.rule.id == "quantity-source-changed"]
        assert (found.weight, found.effect) == (weight, "it is true where it was false")


def test_fewer_values_and_shorter_texts_are_asked_about(rover: System) -> None:
    """Of a list that has fewer nothing is told of the others; what is longer than a text is cut."""
    quantities = [one for each in rover.components.values() for one in each.quantities.values()]
    row = next(each for each in quantities if each.elements)
    text = replace(quantities[0], kind=QuantityKind.TEXT, spec=replace(quantities[0].spec, text=8))
    cases = (
        (row, replace(row, elements=tuple(count - 1 for count in row.elements or ())), "whether nothing is to be told"),
        (text, replace(text, spec=replace(text.spec, text=4)), "whether texts of more than 4 bytes are to be cut"),
    )
    for old, new, doubt in cases:
        sides = [with_quantity(rover, each) for each in (old, new)]
        there, back = (compare_systems((one,), (other,)).changes for one, other in (sides, sides[::-1]))
        assert [each for each in there if each.doubt.startswith(doubt)]
        assert not [each for each in back if each.doubt.startswith(doubt)]


def test_a_text_with_the_end_of_a_line_and_a_number_without_unit_can_be_read(rover: System) -> None:
    """An end of a line is no blank, and "kept as load in" says nothing."""
    quantities = [one for each in rover.components.values() for one in each.quantities.values()]
    text = replace(quantities[0], kind=QuantityKind.TEXT, initial="on\n", spec=replace(quantities[0].spec, text=8))
    sides = (with_quantity(rover, each) for each in (text, replace(text, initial="on ")))
    (changed,) = compare_systems(*((each,) for each in sides)).changes
    assert [changed.old, changed.new] == ['initially "on\\n"', 'initially "on "']
    plain = next(each for each in quantities if not each.stored.name and each.kind is QuantityKind.NUMBER)
    sides = (with_quantity(rover, each) for each in (plain, replace(plain, stored=unit_named("m"))))
    told = [(each.old, each.new) for each in compare_systems(*((each,) for each in sides)).changes]
    assert (f"kept as {plain.attribute}", f"kept as {plain.attribute} in m") in told


def with_quantity(system: System, quantity: Quantity) -> System:
    """The system with another quantity in the place of one."""
    component = system.components[quantity.component]
    changed = replace(component, quantities={**component.quantities, quantity.name: quantity})
    return replace(system, components={**system.components, component.name: changed})
