"""SYS_STATUS, BATTERY_STATUS and BATTERY_STATUS_V2 tell the same of a pack, and nothing of the one before it."""

import importlib.util
import json
import math
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from whole_program import module_folders

pytestmark = pytest.mark.draft("battery_upstream")

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
GENERATED = ROOT / "generated"
BIN = Path(sys.executable).parent
MESSAGES = ("SYS_STATUS", "BATTERY_STATUS", "BATTERY_STATUS_V2")

Step = list[tuple[str, Any]]


@pytest.fixture(scope="module")
def wire() -> ModuleType:
    """pymavlink's module of the three messages."""
    path = next(path for folder in module_folders(GENERATED, "tests") for path in folder.glob("oracle.py"))
    specification = importlib.util.spec_from_file_location("picture_oracle", path)
    assert specification is not None
    assert specification.loader is not None
    oracle = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(oracle)
    about = {"shipped": "common", "files": ["specs/dialects/battery_upstream.xml"]}
    module: ModuleType = oracle.dialects(about, MESSAGES, ROOT)[0]
    return module


def printed(script: str, given: str, names: tuple[str, ...], interpreter: str = "python") -> str:
    """Return the output of a script beside this file, with generated folders on its path."""
    folders = [*map(str, module_folders(GENERATED, *names))]
    paths = {"PYTHONPATH": os.pathsep.join(folders), "MICROPYPATH": os.pathsep.join([".frozen", *folders])}
    command = [str(BIN / interpreter), str(HERE / script)]
    done = subprocess.run(
        command, input=given, env={**os.environ, **paths}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def frames_of(courses: list[list[Step]], monitor: int, interpreter: str = "python") -> list[list[list[str]]]:
    """Return the rover's frames after each step of each course, in hex: three messages a step."""
    given = "".join(json.dumps({"course": course, "monitor": monitor}) + "\n" for course in courses)
    lines = printed("picture_story.py", given, ("firmware", "mocks", "tests"), interpreter).splitlines()
    return [json.loads(line) for line in lines]


def told(wire: ModuleType, courses: list[list[Step]], monitor: int, interpreter: str = "python") -> list[list[Any]]:
    """The same as pymavlink decodes it."""
    link = wire.MAVLink(None)
    return [
        [[link.parse_buffer(bytes.fromhex(frame))[0] for frame in frames] for frames in steps]
        for steps in frames_of(courses, monitor, interpreter)
    ]


def millivolts(message: Any) -> int | None:
    """The voltage of a BATTERY_STATUS, as receivers add it up."""
    values = [value for value in message.voltages if value != 65535] + [each for each in message.voltages_ext if each]
    return sum(values) if values else None


SET: Step = [("cells", [4.1, 4.0, 4.1]), ("left", 1200), ("remaining", 36), ("temperature", 25)]
SWAP: list[Step] = [SET, [("voltage", 3200)], [("voltage", 0)], [], [("voltage", 3900)], []]


@pytest.mark.requirement("FR-00073.8", "FR-00068.3", "FR-00072.4")
@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_nothing_of_the_pack_before_is_told_of_another(wire: ModuleType, interpreter: str) -> None:
    """Cells, charge and temperature that code had set are unknown after a swap; the voltage is the new pack's."""
    (steps,) = told(wire, [SWAP], 3, interpreter)
    _, status, latest = steps[0]
    assert status.battery_remaining == 36
    assert latest.capacity_remaining == pytest.approx(1.2)
    basic, status, latest = steps[-1]
    assert basic.voltage_battery == millivolts(status) == round(latest.voltage * 1000) == 12414
    assert status.voltages[1] == 65535
    assert basic.battery_remaining == status.battery_remaining == -1
    assert status.temperature == latest.temperature == 32767
    assert math.isnan(latest.capacity_remaining)
    assert math.isnan(latest.state_of_charge)


@pytest.mark.requirement("FR-00073.11", "FR-00068.3", "FR-00072.4")
@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_a_gauge_that_is_silent_is_believed_for_five_seconds(wire: ModuleType, interpreter: str) -> None:
    """While the ADC goes on: the pack sags, and its charge from before is told no longer, nor its temperature."""
    gauge: Step = [("left", 1200), ("remaining", 36), ("temperature", 25)]
    sags = [[gauge, *[[]] * 49, [("voltage", 3300)], *[[]] * 5]]
    (steps,) = told(wire, sags, 3, interpreter)
    basic, status, latest = steps[49]
    assert basic.battery_remaining == status.battery_remaining == 36
    assert latest.capacity_remaining == pytest.approx(1.2)
    assert status.temperature == 2500
    basic, status, latest = steps[-1]
    assert basic.voltage_battery == millivolts(status) < 11000
    assert basic.battery_remaining == status.battery_remaining == -1
    assert math.isnan(latest.state_of_charge)
    assert math.isnan(latest.capacity_remaining)
    assert status.temperature == latest.temperature == 32767


STEPS = st.lists(
    st.one_of(
        st.tuples(st.just("voltage"), st.sampled_from([3770, 3900, 3000, 2500, 0, -1])),
        st.tuples(st.just("current"), st.sampled_from([1234, 900, -1])),
        st.tuples(
            st.just("cells"),
            st.sampled_from([[4.1, 4.0, 4.1], [3.3, 3.2, 3.4], [4.1, None, 4.0], [None, None, None]]),
        ),
        st.tuples(st.just("left"), st.sampled_from([1200, 3, None])),
        st.tuples(st.just("remaining"), st.sampled_from([36, 100, 0, None])),
        st.tuples(st.just("wait"), st.sampled_from([1, 4, 8, 25])),
    ),
    min_size=10,
    max_size=25,
)


def spread(events: list[tuple[str, Any]]) -> list[Step]:
    """The steps of a course: waiting is so many readings without an event."""
    return [step for event in events for step in ([[]] * event[1] if event[0] == "wait" else [[event]])]


def assert_one_picture(basic: Any, status: Any, latest: Any) -> None:
    """Voltage, current and charge are the same in all three within their resolution, or unknown in all."""
    voltage = None if math.isnan(latest.voltage) else round(latest.voltage * 1000)
    assert (None if basic.voltage_battery == 65535 else basic.voltage_battery) == voltage
    assert millivolts(status) == voltage
    current = -1 if math.isnan(latest.current) else round(latest.current * 100)
    assert basic.current_battery == status.current_battery == current
    share = -1 if math.isnan(latest.state_of_charge) else round(latest.state_of_charge)
    assert basic.battery_remaining == status.battery_remaining == share
    used = -1 if math.isnan(latest.capacity_consumed) else round(latest.capacity_consumed * 1000)
    assert status.current_consumed == used


@pytest.mark.requirement("FR-00068.3", "FR-00068.9", "FR-00072.4", "FR-00073.10", "FR-00076.7")
@pytest.mark.parametrize("monitor", [3, 4, 29])
@settings(max_examples=4, deadline=None, derandomize=True)
@given(courses=st.lists(STEPS, min_size=15, max_size=15))
def test_three_messages_tell_one_picture(wire: ModuleType, monitor: int, courses: list[Any]) -> None:
    """Whatever becomes of the sources: set, stale, failed, returned."""
    for steps in told(wire, [spread(course) for course in courses], monitor):
        for basic, status, latest in steps:
            assert_one_picture(basic, status, latest)


@pytest.mark.requirement("FR-00068.3", "FR-00076.7")
@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_cells_come_before_the_adc_while_they_are_fresh(wire: ModuleType, interpreter: str) -> None:
    """Also where the ADC has failed; two seconds after they were set the ADC counts, or the voltage is unknown."""
    cells: Step = [("cells", [4.1, 4.0, 4.1])]
    working, failed = told(wire, [[cells, *[[]] * 21], [[("voltage", -1), *cells], *[[]] * 31]], 3, interpreter)
    for steps, later in ((working, 12000), (failed, None)):
        assert [millivolts(steps[at][1]) for at in (0, 8, 19)] == [12200] * 3
        assert steps[19][1].voltages[:3] == [4100, 4000, 4100]
        assert millivolts(steps[-1][1]) == later
    for steps in (working, failed):
        for basic, status, latest in steps:
            assert_one_picture(basic, status, latest)


@pytest.mark.requirement("FR-00073.10")
@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_a_pack_of_another_system_is_what_code_says(wire: ModuleType, interpreter: str) -> None:
    """Its pin says nothing; a swap is noticed; five seconds after the last word of it nothing is known of it."""
    said: Step = [("voltage", 4000), ("current_ma", 2500), ("consumed", 100), *SET[1:]]
    swap: list[Step] = [[("voltage", 0)], [], [("voltage", 3900), ("current_ma", 1000)], []]
    (steps,) = told(wire, [[[], said, *[[]] * 49, [], *swap]], 29, interpreter)
    for messages in steps:
        assert_one_picture(*messages)
    assert millivolts(steps[0][1]) is None, "the converter reads it"
    for _, status, latest in (steps[1], steps[50]):
        assert (millivolts(status), status.current_battery, status.current_consumed) == (12000, 250, 100)
        assert latest.capacity_remaining == pytest.approx(1.2)
    for at in (51, -4, -3):
        _, status, latest = steps[at]
        assert millivolts(status) == (None if at == 51 else 0)
        assert (status.current_battery, status.current_consumed, status.battery_remaining) == (-1, -1, -1)
        assert status.temperature == 32767
        assert math.isnan(latest.capacity_remaining)
    assert (millivolts(steps[-1][1]), steps[-1][1].current_battery) == (11700, -1)


@pytest.mark.requirement("FR-00075.8", "FR-00073.8")
@pytest.mark.parametrize("message", [1, 2], ids=MESSAGES[1:])
def test_a_receiver_notices_another_pack_without_a_serial_number(message: int) -> None:
    """The charge that was drawn begins anew; what the old pack's cells were is forgotten, and it counts once."""
    drawn: list[Step] = [[("cells", [4.1, 4.0, 4.1])], *[[]] * 60]
    swap: list[Step] = [[("voltage", 0)], [], [("voltage", 3900)], *[[]] * 10]
    (steps,) = frames_of([[*drawn, *swap]], 4)
    given = "".join(frames[message] + "\n" for frames in steps)
    seen = json.loads(printed("picture_seen.py", given, ("receiver",)))
    assert [each[0] for each in seen] == [0] * 63 + [1] * 11
    assert seen[0][1] == ([4.1, 4.0, 4.1] if message == 1 else None)
    assert seen[-1][1] is None
    assert seen[-1][2] == pytest.approx(12.414)


@pytest.mark.requirement("FR-00075.1")
def test_charge_that_cannot_be_is_unknown(wire: ModuleType) -> None:
    """130 % and less than nothing are no charge; all and nothing are."""
    link = wire.MAVLink(None, srcSystem=1, srcComponent=1)
    given = ""
    for share, left in ((130.0, -1.0), (100.0, 0.0)):
        message = wire.MAVLink_battery_status_v2_message(0, 32767, 12.0, math.nan, math.nan, left, share, 0)
        given += message.pack(link).hex() + "\n"
    seen = json.loads(printed("picture_seen.py", given, ("receiver",)))
    assert [each[3:] for each in seen] == [[None, None], [100, 0]]
