"""Facts that checks of commands compare with: the ends of parameters, the floats beside them, and what is no value."""

import math
import shutil
import struct
from pathlib import Path
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.project.systems import read_system
from codegen.targets.suite.facts.commands import command_facts

SPECS = Path(__file__).parent / "commanded" / "specs" / "codegen.yaml"
NAN, INFINITE = math.nan, math.inf


@pytest.fixture(scope="module")
def facts() -> dict[str, dict[str, Any]]:
    """What the suite has of each method."""
    system = read_system(str(SPECS), Report())
    assert system is not None
    assert system.program is not None
    found = [dict(each.entries) for each in command_facts(system.program)]
    names = {"NAN": NAN, "INFINITE": INFINITE}
    return {eval(each["method"]): {key: eval(text, names) for key, text in each.items()} for each in found}  # noqa: S307


def beside(value: float, step: int) -> float:
    """The float of 32 bits that lies so many behind a positive one."""
    (bits,) = struct.unpack("<i", struct.pack("<f", value))
    return struct.unpack("<f", struct.pack("<i", bits + step))[0]  # type: ignore[no-any-return]


def differing(tried: tuple[float, ...], good: tuple[float, ...]) -> tuple[int, float]:
    """The number of the one parameter that is not the good one, and its value."""
    ((number, value),) = [
        (number, value) for number, (value, own) in enumerate(zip(tried, good, strict=True), 1) if value != own
    ]
    return number, value


@pytest.mark.parametrize(
    ("method", "good", "arguments", "as_int"),
    [
        ("pump", (0, 10, 0, 0, 0, 0, 0), (0.0, 10.0), (0, 10, 0, 0, 0, 0, 0)),
        ("set_lights", (0, 0, -0.5, 0, 0, 0, 0), (-0.5, 0), (0, 0, -0.5, 0, 0, 0, 0)),
        (
            "go_to",
            (-1, 0, 0, 0, -90, -180, 0),
            (-(9 * 10**8), -180.0, -3.6, 0),
            (-1, 0, 0, 0, -9 * 10**8, -18 * 10**8, 0),
        ),
        ("turn", (0, 0, -1, 0, 0, 0, 0), (0.0, -1, 0), (0, 0, -1, 0, 0, 0, 0)),
        ("sound_horn", (0, 0, 0, 0, 0, 0, 0), (), (0, 0, 0, 0, 0, 0, 0)),
    ],
)
def test_what_is_accepted(facts: Any, method: str, good: Any, arguments: Any, as_int: Any) -> None:
    """The parameters, the arguments in the order of the method, and a position in 1e-7 degrees in COMMAND_INT."""
    assert facts[method]["good"] == (good, arguments)
    assert facts[method]["as_int"] == as_int


@pytest.mark.parametrize(
    ("method", "ends", "unknown"),
    [
        ("pump", {1: [0, 60], 2: [10, 100]}, {2: 50.0}),
        ("set_lights", {1: [0, 3], 3: [-0.5, beside(0.1, 0)]}, {}),
        ("go_to", {1: [-1, 10], 2: [0, 3], 5: [-90, 90], 6: [-180, 180]}, {1: 3.6}),
        ("turn", {1: [0, 360], 3: [-1, 1], 4: [0, 1]}, {3: 0}),
        ("lower", {1: [beside(0.01, 0), 2.5], 2: [0, 21]}, {2: 0}),
        ("take", {7: [beside(INFINITE, -1)]}, {}),
        ("sound_horn", {}, {}),
        ("look_after", {1: [0, 0xFFFFFF00], 2: [0, 63]}, {}),  # the highest 24 of 32 flags, as a float has them
    ],
)
def test_the_ends_and_what_is_left_to_the_method(facts: Any, method: str, ends: Any, unknown: Any) -> None:
    found: dict[int, list[float]] = {}
    good = facts[method]["good"][0]
    for number in range(1, 8):
        tried = sorted({params[number - 1] for params, _ in facts[method]["ends"]})
        if tried and (tried != [0] or number in ends):
            found[number] = tried
    assert found == ends
    left = [(differing(params, good)[0], arguments) for params, arguments in facts[method]["unknown"]]
    assert [number for number, _ in left] == list(unknown)
    assert all(unknown[number] in arguments for number, arguments in left)


CIRCLE = """
  MAV_CMD_SET_GUIDED_SUBMODE_CIRCLE:
    doc: Goes round a place.
    method: circle
    requirement: FR-301.2
    params: {5: {name: lat}, 6: {name: lon, unit: degE7}}
"""


def test_a_position_that_the_dialect_states_in_steps_is_in_degrees_in_a_float(tmp_path: Path) -> None:
    """Of COMMAND_INT alone degE7 is true: 54.3 of COMMAND_LONG are no 54.3 steps of 1e-7 degrees."""
    shutil.copytree(SPECS.parent, tmp_path / "specs")
    with (tmp_path / "specs" / "commands.yaml").open("a") as file:
        file.write(CIRCLE.removeprefix("\n"))
    system = read_system(str(tmp_path / "specs" / "codegen.yaml"), Report())
    assert system is not None
    assert system.program is not None
    found = [dict(each.entries) for each in command_facts(system.program)]
    circle = next(each for each in found if each["method"] == '"circle"')
    good = (0, 0, 0, 0, -90, -180, 0), (-90.0, -18 * 10**8)
    assert eval(circle["good"]) == good  # noqa: S307
    assert eval(circle["as_int"])[4:6] == (-9 * 10**8, -18 * 10**8)  # noqa: S307


NOT_FINITE = [INFINITE, -INFINITE]


@pytest.mark.parametrize(
    ("method", "beyond"),
    [
        (
            "pump",
            {1: [-beside(1e-6, 0), beside(60, 1), NAN, *NOT_FINITE], 2: [beside(10, -1), beside(100, 1), *NOT_FINITE]},
        ),
        (
            "set_lights",
            {
                3: [-beside(0.5, 1), beside(0.1, 1), NAN, *NOT_FINITE],
                1: [-beside(1e-6, 0), -1, beside(3, 1), 4, NAN, *NOT_FINITE, 0.5],
            },
        ),
        (
            "turn",
            {
                1: [-beside(1e-6, 0), beside(360, 1), NAN, *NOT_FINITE],
                3: [-beside(1, 1), -2, beside(1, 1), 2, *NOT_FINITE, -0.5],
                4: [NAN, *NOT_FINITE, 2, 0.5],
            },
        ),
        ("lower", {1: [beside(0.01, -1), beside(2.5, 1), NAN, *NOT_FINITE], 2: [*NOT_FINITE, 22, 0.5]}),
        ("take", {7: [NAN, *NOT_FINITE]}),
        ("sound_horn", {}),
    ],
)
def test_what_is_denied(facts: Any, method: str, beyond: Any) -> None:
    """The floats and whole numbers next beyond each end, what is no number, an entry that there is not, and a half."""
    found: dict[int, list[float]] = {}
    good = facts[method]["good"][0]
    for params in facts[method]["beyond"]:
        number, value = differing(params, good)
        found.setdefault(number, []).append(value)
    assert repr(found) == repr({number: [float(value) for value in values] for number, values in beyond.items()})


def test_who_may_and_when(facts: Any) -> None:
    assert {method: each["armed"] for method, each in facts.items() if each["armed"] is not None} == {
        "go_to": True,
        "turn": False,
    }
    assert [method for method, each in facts.items() if each["stations"]] == ["go_to"]
    assert [method for method, each in facts.items() if each["long"]] == ["pump"]
    assert all(each["unwritten"] for each in facts.values())
    assert (facts["pump"]["number"], facts["set_lights"]["title"]) == (31010, "Set lights")
