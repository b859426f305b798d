"""Numbers of parameters, quantities and channels: the last one that may be is taken, the next one is reported."""

import shutil
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.model.spec.command import CommandSpec
from codegen.project.systems import read_system
from codegen.resolve.commands.commands import resolve_commands
from codegen.source import Place

MINIMAL = Path(__file__).resolve().parents[1] / "projects" / "minimal" / "specs"
LARGEST = 2**30 - 1
INT8 = "type: int8, step: 1"
SWITCH = """\
parameters:
  A: {doc: d, type: int8, default: 4, min: 0, max: 4, step: 1, reboot: true}
  C: {doc: d, default: 1, min: 0, max: 2, step: 0.5}
  P: {doc: d, type: int8, default: 27, min: 26, max: 28, step: 1, reboot: true}
  Q: {doc: d, type: int8, default: 27, min: 25, max: 28, step: 1, reboot: true}
  R: {doc: d, type: int8, default: 27, min: 26, max: 29, step: 1, reboot: true}
"""


@pytest.fixture(scope="module")
def specs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small project, of which every case writes three files anew."""
    return Path(shutil.copytree(MINIMAL, tmp_path_factory.mktemp("limits") / "specs"))


def found(specs: Path, *, parameters: str = "parameters: {}\n", quantities: str = "", board: str = "") -> list[str]:
    """What is reported of the project with these, without its warnings."""
    (specs / "parameters.yaml").write_text(parameters)
    state = (MINIMAL / "state.yaml").read_text()
    (specs / "state.yaml").write_text(
        f"{state}  boat:\n    doc: d\n    quantities:\n      {quantities}\n" if quantities else state
    )
    (specs / "board.yaml").write_text(board or "board: odd\n")
    report = Report()
    read_system(str(specs / "codegen.yaml"), report)
    return [each.message for each in report if each.rule.severity.value == "error"]


@pytest.mark.parametrize(
    ("name", "keys", "said"),
    [
        ("A" * 16, "default: 1, min: 0, max: 2, step: 1", []),
        ("A" * 17, "default: 1, min: 0, max: 2, step: 1",
         [f"{'A' * 17} is not a parameter name: it has 17 characters, and 16 are the most"]),
        ("A", "default: 0, min: 0, max: 2, step: 1", []),
        ("A", "default: 2, min: 0, max: 2, step: 1", []),
        ("A", "default: 3, min: 0, max: 2, step: 1", ["default of A is not between its min and max"]),
        ("A", "default: -1, min: 0, max: 2, step: 1", ["default of A is not between its min and max"]),
        ("A", "default: 2, min: 2, max: 2, step: 1", []),
        ("A", "default: 2, min: 2, max: 1, step: 1", ["max of A is below its min"]),
        ("A", "default: 2, min: 0, max: 4, step: 0", ["the step of A is not above 0"]),
        ("A", "default: 2, min: 0, max: 4, step: -1", ["the step of A is not above 0"]),
        ("A", "default: 0.5, min: 0, max: 4, step: 0.5", []),
        ("A", "default: 1, min: 0, max: 4.5, step: 1", ["max of A is not a whole number of steps"]),
        ("A", f"default: 0, min: 0, max: {LARGEST}, step: 1", None),
        ("A", f"default: 0, min: 0, max: {LARGEST + 1}, step: 1",
         [f"max of A is {LARGEST + 1} steps, more than a small integer holds"]),
        ("A", f"default: 1, min: -128, max: 127, {INT8}", []),
        ("A", f"default: 1, min: -129, max: 127, {INT8}", None),
        ("A", f"default: 1, min: -128, max: 128, {INT8}", None),
        ("A", f"default: 1, min: 0, max: 2, {INT8}, values: {{0: a, 1: b, 2: c}}", []),
        ("A", f"default: 1, min: 0, max: 2, {INT8}, values: {{0: a, 2: c}}", None),
        ("A", f"default: 1, min: 0, max: 2, {INT8}, values: {{1: a, 3: c}}", None),
        ("A", "default: 1, min: 0, max: 2, step: 1, was: {B: 1}", []),
        ("A", "default: 1, min: 0, max: 2, step: 1, was: {B: 0}", ["A is not 0 times what B was"]),
        ("A", "default: 1, min: 0, max: 2, step: 1, was: {A: 1}", ["A is a parameter of today"]),
        ("A", "default: 1, min: 0, max: 2, step: 1, was: {b: 1}", ["b is not a parameter name"]),
    ],
)  # fmt: skip
def test_a_parameter(name: str, keys: str, said: list[str] | None, specs: Path) -> None:
    """None stands for a finding whose words are looked at elsewhere."""
    told = found(specs, parameters=f"parameters: {{{name}: {{doc: d, {keys}}}}}\n")
    assert told == said if said is not None else len(told) == 1, told


def test_a_family_of_a_component_that_is_one(specs: Path) -> None:
    """The board lists no instances of it, and so no defaults of theirs."""
    family = "parameters: {A: {doc: d, for_each: vehicle, default: 1, min: 0, max: 2, step: 1}}\n"
    assert found(specs, parameters=family) == []


@pytest.mark.parametrize(("number", "is_carried"), [(0, False), (1, True), (0xFFFF, True), (0x10000, False)])
def test_a_command_has_a_number_of_16_bits(number: int, is_carried: bool) -> None:
    """COMMAND_LONG carries no other, and 0 is no command."""
    entry = SimpleNamespace(name="MAV_CMD_OWN", value=number, parameters=())
    enum = SimpleNamespace(entries=(entry,), entry=lambda _: entry)
    command = CommandSpec(place=Place("commands.yaml"), doc="d", method="pump")
    dialect: Any = SimpleNamespace(enums={"MAV_CMD": enum})
    vehicle: Any = SimpleNamespace(modes={}, arming=None, actions=())
    commands: Any = SimpleNamespace(commands={"MAV_CMD_OWN": command})
    report = Report()
    made = resolve_commands(commands, vehicle, dialect, {}, report)
    assert [each.number for each in made] == [number] * is_carried
    said = f"no COMMAND_LONG carries MAV_CMD_OWN: its number is {number}"
    assert [each.message for each in report] == [said] * (not is_carried)


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ("unit: V, stored: mV, min: 0, max: 5, initial: 5", []),
        ("unit: V, stored: mV, min: 0, max: 5, initial: 0", []),
        ("unit: V, stored: mV, min: 0, max: 5, initial: 5.001", ["initial of q is not between its limits"]),
        ("unit: V, stored: mV, min: 1, max: 5, initial: 0.999", ["initial of q is not between its limits"]),
        ("unit: V, stored: mV, min: 5, max: 5", []),
        ("unit: V, stored: mV, min: 5, max: 4.999", ["max of q is below its min"]),
        ("unit: V, stored: mV, min: 0, max: 0.0001", None),
        ("boolean: true, initial: false", []),
        ("boolean: true", ["the boolean q needs initial: true or false"]),
        ("boolean: true, initial: 1", ["the boolean q needs initial: true or false"]),
        ("boolean: true, initial: true, min: 0", ["q is a boolean quantity and cannot have min"]),
        ("boolean: true, initial: true, enum: MAV_STATE", ["q cannot be both a boolean and an enum"]),
        ("enum: MAV_STATE, initial: MAV_STATE_BOOT", []),
        ("enum: MAV_STATE, initial: MAV_STATE_BOOTS", ["MAV_STATE has no entry MAV_STATE_BOOTS"]),
        ("enum: MAV_STATE, initial: 1", ["initial of q is not an entry of its enum"]),
        ("enum: MAV_STATES", ["the dialect has no enum MAV_STATES"]),
        ("initial: MAV_STATE_BOOT", ["initial of q is not a number"]),
        ("initial: true", ["initial of q is not a number"]),
        ("unit: V, stored: A", ["V cannot be kept in A"]),
        ("unit: V, stored: mV, per: cells", ["per says nothing without a limit, such as that of follows"]),
    ],
)  # fmt: skip
def test_a_quantity(keys: str, said: list[str] | None, specs: Path) -> None:
    told = found(specs, quantities=f"q: {{doc: d, {keys}}}")
    assert told == said if said is not None else len(told) == 1, told


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ("gpio: 26", []),
        ("gpio: 28, bits: 12, samples: 64", []),
        ("gpio: 27, bits: 8, samples: 1", []),
        ("gpio: 26, bits: 13", ["bits of v is 13, not 8 to 12"]),
        ("gpio: 26, bits: 7", ["bits of v is 7, not 8 to 12"]),
        ("gpio: 26, samples: 65", ["samples of v is 65, not 1 to 64"]),
        ("gpio: 26, samples: 0", ["samples of v is 0, not 1 to 64"]),
        ("gpio: 26, reference: 0 V", ["the reference of v is not above 0 V"]),
        ("gpio: 26, reference: 1 mV", []),
        ("gpio: 22", ["gpio of v is 22, not 26 to 28"]),
        ("gpio: 25", ["gpio of v is 25, not 26 to 28: the Raspberry Pi Pico 2 needs it for the LED"]),
        ("gpio: 26, when: {A: 4}", []),
        ("gpio: 26, when: {A: 5}", ["A is never 5, so v is never read"]),
        ("gpio: 26, when: {A: 4, B: 1}", ["when of v has one parameter, not 2"]),
        ("gpio: 26, when: {B: 1}", ["there is no parameter B"]),
        ("pin: P", []),
        ("pin: Q", ["Q takes other numbers than those of inputs of the Raspberry Pi Pico 2, 26 to 28"]),
        ("pin: R", ["R takes other numbers than those of inputs of the Raspberry Pi Pico 2, 26 to 28"]),
        ("gpio: 26, when: {C: 2}", ["C is looked at when the board starts"]),
        ("pin: A", ["A takes other numbers than those of inputs of the Raspberry Pi Pico 2, 26 to 28"]),
    ],
)
def test_a_channel(keys: str, said: list[str], specs: Path) -> None:
    assert found(specs, parameters=SWITCH, board=f"board: pico_2\nadc: {{v: {{{keys}}}}}\n") == said


def test_a_channel_needs_a_board_with_a_converter(specs: Path) -> None:
    """A board that is named but not known has been reported, and its channels are not, too."""
    said = [
        found(specs, board=f"{board}adc: {{v: {{gpio: 26}}}}\n") for board in ("", "board: odd\n", "board: unheard\n")
    ]
    assert said[0] == ["the pin of v is on no known board"]
    assert len(said[1]) == len(said[2]) == 1
    assert "has no converter for v" in said[1][0]
    assert "unheard" in said[2][0]
