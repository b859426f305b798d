"""A ground station's SYSTEM_TIME sets the time since 1970 of a vehicle that sends it; nothing else that arrives does.

pymavlink makes the frames that go in and reads those that come out; the vehicle is the whole program of a project.
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build
from pymavlink.dialects.v20 import common

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
NOW_US = 1790000000123456
SCRIPT = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
from program_bench import Port, Craft, mock_time, run, run_passes

results = []
for frames in json.loads(open("frames.json").read()):
    rover = Craft(ports=[Port(), Port()])
    rover.state.clock.unix_us = None
    told = []
    for link, frame in frames:
        if frame == "code":
            rover.state.clock.unix_us = link
            continue
        if frame == "second":
            run(rover, 1000000)
            continue
        rover.connections[link].port.arrives(bytes.fromhex(frame))
        run_passes(rover, 4)
        told.append(rover.state.clock.unix_us)
    run(rover, 3000000)
    sent = [frame.hex() for frame in rover.port.frames if frame[7] == 2]
    results.append([[None if each is None else str(each) for each in told], sent[-1:], rover.connections[0].faults])
print(json.dumps(results))
"""


def frame(message, system=255, component=190):
    return message.pack(common.MAVLink(None, srcSystem=system, srcComponent=component)).hex()


def heartbeat(system=255, kind=common.MAV_TYPE_GCS):
    return [0, frame(common.MAVLink_heartbeat_message(kind, 8, 0, 0, 4, 3), system)]


def time(time_us, system=255, link=0, component=190):
    return [link, frame(common.MAVLink_system_time_message(time_us, 5), system, component)]


SECOND = [0, "second"]
GCS, LATER = heartbeat(), NOW_US + 10**15
CASES = {
    "set": [GCS, time(NOW_US)],
    "another component of the station": [GCS, time(NOW_US, component=1)],
    "nobody is heard": [time(NOW_US)],
    "no ground station": [heartbeat(7, common.MAV_TYPE_QUADROTOR), time(NOW_US, 7)],
    "not that one": [GCS, time(NOW_US, 7)],
    "not on that link": [GCS, time(NOW_US, link=1)],
    "own frames": [GCS, heartbeat(77), time(NOW_US, 77, component=1)],
    "does not know": [GCS, time(0), time(1577836799000000), time(2**64 - 1), time(4102444800000000)],
    "begins with 2020": [GCS, time(1577836800000001)],
    "the first one counts": [GCS, heartbeat(254), time(NOW_US), time(LATER), time(NOW_US - 10**9, 254)],
    "what code set stays": [[LATER, "code"], GCS, time(NOW_US)],
    "code may ask again": [GCS, time(NOW_US), [None, "code"], time(LATER)],
    "after a silence": [GCS, *[SECOND] * 20, time(NOW_US)],
    "after a while": [GCS, SECOND, SECOND, time(NOW_US)],
}


@pytest.fixture(scope="module")
def rover(tmp_path_factory):
    """The folder in which the radio rover is built."""
    folder = tmp_path_factory.mktemp("rover")
    subprocess.run(["cp", "-r", str(HERE / "radio_rover" / "specs"), str(folder)], check=True)
    build(folder)
    (folder / "send.py").write_text(SCRIPT)
    (folder / "frames.json").write_text(json.dumps(list(CASES.values())))
    return folder


@pytest.fixture(scope="module", params=["micropython", "micropython32", "python"])
def results(request, rover):
    """By case what the clock was after each frame, and the last SYSTEM_TIME that the vehicle sent."""
    done = subprocess.run([str(BIN / request.param), "send.py"], cwd=rover, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert {faults for _, _, faults in json.loads(done.stdout)} == {0}
    return {name: (told, sent) for name, (told, sent, _) in zip(CASES, json.loads(done.stdout), strict=True)}


def last(told):
    return None if told[-1] is None else int(told[-1])


@pytest.mark.parametrize("case", ["set", "another component of the station", "after a while"])
def test_a_ground_station_sets_the_clock(results, case):
    """The clock goes on from the message: 4 passes of 20 ms at most until it is looked at."""
    told, sent = results[case]
    assert told[-2] is None
    assert 0 <= last(told) - NOW_US <= 100000
    message = common.MAVLink(None).parse_buffer(bytearray(bytes.fromhex(sent[0])))[0]
    assert NOW_US + 1000000 < message.time_unix_usec < NOW_US + 4000000


@pytest.mark.parametrize(
    "case",
    [
        "nobody is heard",
        "no ground station",
        "not that one",
        "not on that link",
        "own frames",
        "does not know",
        "after a silence",
    ],
)
def test_nothing_else_does(results, case):
    """The message stays withheld."""
    told, sent = results[case]
    assert set(told) == {None}
    assert sent == []


def test_what_is_known_is_left_alone(results):
    """Of two times that differ the first counts, and code goes before all that arrives."""
    assert abs(last(results["begins with 2020"][0]) - 1577836800000001) <= 100000
    assert abs(last(results["the first one counts"][0]) - NOW_US) <= 400000
    assert abs(last(results["what code set stays"][0]) - LATER) <= 200000
    assert abs(last(results["code may ask again"][0]) - LATER) <= 100000
