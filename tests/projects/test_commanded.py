"""Commands of commands.yaml and modes are done, and answered: by hand from FR-301, on three interpreters.

pymavlink makes the frames that go in and reads those that come out; the vehicle is the whole program of a project.
"""

import json
import math
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from pymavlink.generator.mavcrc import x25crc

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
NAN, INFINITE = math.nan, math.inf
PUMP, LIGHTS, HORN, UNKNOWN = 31010, 31011, 31012, 31013
GO, TURN, SET_MODE, HOME, SPEED, COUNT, LAND, FLAP = 192, 115, 176, 179, 178, 31014, 23, 187
ACCEPTED, REJECTED, DENIED, UNSUPPORTED, FAILED, IN_PROGRESS, CANCELLED = range(7)


def frame(message, link=0, system=255, component=190):
    return ["frame", link, message.pack(mavlink.MAVLink(None, srcSystem=system, srcComponent=component)).hex()]


def long(command, *params, to=(1, 1), confirmation=0, **station):
    values = [*params, *[0.0] * (7 - len(params))]
    return frame(mavlink.MAVLink_command_long_message(*to, command, confirmation, *values), **station)


def whole(command, *params, x=0, y=0, z=0.0, to=(1, 1), frame_of=6, **station):
    values = [*params, *[0.0] * (4 - len(params))]
    return frame(mavlink.MAVLink_command_int_message(*to, frame_of, command, 0, 0, *values, x, y, z), **station)


def cancel(command, to=(1, 1), link=0, system=255):
    """COMMAND_CANCEL (80), which pymavlink does not have: upstream's CRC_EXTRA is 14."""
    payload = struct.pack("<HBB", command, *to)
    data = bytes((len(payload), 0, 0, 0, system, 190, 80, 0, 0)) + payload
    checksum = x25crc(data)
    checksum.accumulate(b"\x0e")
    return ["frame", link, (b"\xfd" + data + struct.pack("<H", checksum.crc)).hex()]


def heartbeat(system=255, link=0, kind=mavlink.MAV_TYPE_GCS):
    return frame(mavlink.MAVLink_heartbeat_message(kind, 8, 0, 0, 4, 3), link, system)


def mode(number, flags=1, **where):
    return long(SET_MODE, flags, number, **where)


def set_mode(number, flags=1, system=1):
    return frame(mavlink.MAVLink_set_mode_message(system, flags, number))


def said(method, *answers):
    return ["says", method, list(answers)]


SECOND, ARM, GCS = ["run", 1000], ["arm"], heartbeat()
START = long(PUMP, 10.0, 20.0)
FLOAT_01 = 0.10000000149011612  # the float of 32 bits nearest to 0.1
ABOVE_01 = 0.10000000894069672  # and the next one

# By case the steps, the acknowledgements (command, result, progress), the texts, and what the methods were given.
CASES = {
    # FR-301.2 and 3: ends, beyond them, NaN, infinity
    "the ends": (
        [long(PUMP, 0.0, 10.0), SECOND, long(PUMP, 60.0, 100.0)],
        [(PUMP, 5, 0), (PUMP, 0, 0)] * 2,
        [],
        [["pump", "0.0", "10.0"], ["progress"], ["pump", "60.0", "100.0"], ["progress"]],
    ),
    "NaN is 50 %": ([long(PUMP, 1.5, NAN)], [(PUMP, 5, 0)], [], [["pump", "1.5", "50.0"]]),
    # What leaves things as they are is None, before any limit; -2, with a meaning of its own, is denied by a limit.
    "no change": (
        [long(SPEED, 0, -1.0, -1.0), long(SPEED, 1, NAN, NAN), long(SPEED, 1, 10.0, -2.0), long(SPEED, 1, 5.0, 40.0)],
        [(SPEED, 0, 0)] * 4,
        [],
        [
            ["speed", "0", "None", "None"],
            ["speed", "1", "None", "None"],
            ["speed", "1", "36.0", "None"],
            ["speed", "1", "18.0", "40.0"],
        ],
    ),
    "no other change": (
        [long(SPEED, 0, -2.0, 0), long(SPEED, 0, -0.5, 0)],
        [(SPEED, 2, 0)] * 2,
        ["Change speed: speed must be 0 to 40 km/h"],
        [],
    ),
    # COMMAND_LONG has no whole numbers that large: what is meant is the end, never one more.
    "the largest whole numbers": (
        [
            long(COUNT, 2147483647.0, 2147483648.0, 0, 0, 16777220.0),
            long(COUNT, -2147483648.0, 2147483648.0, 0, 0, 16777216.0),
            whole(COUNT, 2147483647.0, 2147483648.0, x=16777219),
            whole(COUNT, 0.0, 2147483648.0, x=16777220),
        ],
        [(COUNT, 0, 0)] * 3 + [(COUNT, 2, 0)],
        ["Count: beside must be whole, at most 16777219"],
        [
            ["count", "2147483647", "2147483648", "16777219", "0"],
            ["count", "-2147483648", "2147483648", "16777216", "0"],
            ["count", "2147483647", "2147483648", "16777219", "0"],
        ],
    ),
    # MAV_CMD: INT32_MAX stands for NaN in parameters that are whole numbers, positions or not.
    "what stands for NaN in a whole parameter": (
        [whole(COUNT, 0.0, 2147483648.0, y=0x7FFFFFFE), whole(COUNT, 0.0, 2147483648.0, y=0x7FFFFFFF)],
        [(COUNT, 0, 0), (COUNT, 2, 0)],
        ["Count: wide must be whole, at least -2147483648"],
        [["count", "0", "2147483648", "0", "2147483646"]],
    ),
    "NaN is denied": ([long(PUMP, NAN, 50.0)], [(PUMP, 2, 0)], ["Pump: duration must be 0 to 60 s"], []),
    "beyond": (
        [long(PUMP, *values) for values in ((60.00001, 50.0), (-1e-30, 50.0), (INFINITE, 50.0), (-INFINITE, 50.0))],
        [(PUMP, 2, 0)] * 4,
        ["Pump: duration must be 0 to 60 s"],
        [],
    ),
    "beyond the second": ([long(PUMP, 0.0, 9.5)], [(PUMP, 2, 0)], ["Pump: power must be 10 to 100 %"], []),
    "the order of the arguments": (
        [long(LIGHTS, 3.0, 77.0, -0.5)],
        [(LIGHTS, 0, 0)],
        [],
        [["lights", "-0.5", "3"]],
    ),
    "the float nearest to 0.1": (
        [long(LIGHTS, 1.0, 0.0, FLOAT_01), long(LIGHTS, 1.0, 0.0, ABOVE_01)],
        [(LIGHTS, 0, 0), (LIGHTS, 2, 0)],
        ["Set lights: level must be -0.5 to 0.1"],
        [["lights", "0.1", "1"]],
    ),
    "not whole": ([long(LIGHTS, 1.5)], [(LIGHTS, 2, 0)], ["Set lights: lamps must be whole, 0 to 3"], []),
    "huge and not counted": ([long(LIGHTS, 3e38)], [(LIGHTS, 2, 0)], ["Set lights: lamps must be whole, 0 to 3"], []),
    "what no entry names is ignored": (
        [long(LIGHTS, 1.0, NAN, 0.0, INFINITE, NAN, -1.0, 5e30)],
        [(LIGHTS, 0, 0)],
        [],
        [["lights", "0.0", "1"]],
    ),
    "COMMAND_INT": ([whole(LIGHTS, 2.0, 0.0, -0.25, x=5, y=-7)], [(LIGHTS, 0, 0)], [], [["lights", "-0.25", "2"]]),
    # 2 pi are 6.2831853 rad; a turn is for the disarmed boat, -1 is an entry of no enum
    "deg to rad": (
        [long(TURN, 180.0, 0.0, -1.0, 1.0), long(TURN, 360.0, 0.0, NAN, 0.0)],
        [(TURN, 0, 0)] * 2,
        [],
        [["turn", "3.1415927", "-1", "1"], ["turn", "6.2831853", "0", "0"]],
    ),
    "limits of the dialect": (
        [long(TURN, 360.5), SECOND, SECOND, long(TURN, 0.0, 0.0, 2.0), long(TURN, 0.0, 0.0, 1.0, 2.0)],
        [(TURN, 2, 0)] * 3,
        [
            "Turn: angle must be 0 to 6.28319 rad",
            "Turn: direction must be whole, -1 to 1",
            "Turn: relative must be 0 or 1",
        ],
        [],
    ),
    # 0.57 m as a float of 32 bits are 56.99999928 cm
    "whole centimetres": (
        [long(186, 0.57), long(186, 0.01, 3.0), long(186, 2.5, NAN), long(186, 0.0)],
        [(186, 0, 0), (186, 0, 0), (186, 0, 0), (186, 2, 0)],
        ["Lower: depth must be whole, 1 to 250 cm"],
        [["lower", "57", "0"], ["lower", "1", "3"], ["lower", "250", "0"]],
    ),
    # FR-301.8 and 7
    "a position": (
        [GCS, ARM, whole(GO, NAN, 1.0, x=-353632621, y=1491652374), whole(GO, 10.0, x=900000000, y=-1800000000)],
        [(GO, 0, 0)] * 2,
        [],
        [["go", "-353632621", "149.1652374", "3.6", "1"], ["go", "900000000", "-180.0", "36.0", "0"]],
    ),
    "a position as floats": (
        [GCS, ARM, long(GO, -1.0, 3.0, 0.0, 0.0, 54.5, -10.125)],
        [(GO, 0, 0)],
        [],
        [["go", "545000000", "-10.125", "-3.6", "3"]],
    ),
    "beyond the globe": (
        [
            GCS,
            ARM,
            whole(GO, x=900000001),
            whole(GO, y=-1800000001),
            whole(GO, x=0x7FFFFFFF),
            long(GO, 0, 0, 0, 0, NAN),
        ],
        [(GO, 2, 0)] * 4,
        ["Go to: lat must be -90 to 90 deg", "Go to: lon must be -180 to 180 deg", "Go to: lat must be -90 to 90 deg"],
        [],
    ),
    "local positions": (
        [GCS, ARM, whole(GO, frame_of=1), whole(GO, frame_of=0), long(GO, 10.0)],
        [(GO, 2, 0), (GO, 0, 0), (GO, 0, 0)],
        ["Go to: positions have to be global"],
        [["go", "0", "0.0", "0.0", "0"], ["go", "0", "0.0", "36.0", "0"]],
    ),
    # COMMAND_INT.x and y are, in the words of the dialect, 1e4 of a metre in local frames
    "a local position": (
        [whole(LAND, x=12345, y=-30000, frame_of=1), long(LAND, 0, 0, 0, 0, 1.5, 2.25)],
        [(LAND, 0, 0)] * 2,
        [],
        [["land", "-3.0", "123"], ["land", "2.25", "150"]],
    ),
    "no other frame for a local position": (
        [whole(LAND, frame_of=6), whole(LAND, y=5000001, frame_of=1), whole(LAND, y=5000000, frame_of=1)],
        [(LAND, 2, 0)] * 2 + [(LAND, 0, 0)],
        ["Land: the frame must be MAV_FRAME_LOCAL_NED", "Land: north must be -500 to 500 m"],
        [["land", "500.0", "0"]],
    ),
    "what is multiplied, and no position": (
        [
            whole(FLAP, x=5000000),
            whole(FLAP, x=-10000000, frame_of=1),
            whole(FLAP, x=0x7FFFFFFF),
            long(FLAP, 0, 0, 0, 0, 0.5),
            whole(FLAP, x=10000001),
        ],
        [(FLAP, 0, 0)] * 4 + [(FLAP, 2, 0)],
        ["Move flap: flap must be -1 to 1"],
        [["flap", "0.5"], ["flap", "-1.0"], ["flap", "None"], ["flap", "0.5"]],
    ),
    # MAV_FRAME_GLOBAL (0) and its _INT (5) count from the sea, LOCAL_NED (1) downwards; those above home are 3 and 6
    "an altitude counts from one level": (
        [whole(HOME, z=10.0, frame_of=each) for each in (0, 5, 1, 10, 11, 3, 6)] + [long(HOME, 0, 0, 0, 0, 0, 0, 2.5)],
        [(HOME, 2, 0)] * 5 + [(HOME, 0, 0)] * 3,
        ["Set home: the frame must be MAV_FRAME_GLOBAL_RELATIVE_ALT_INT"],
        [["home", "0", "0", "1000.0"]] * 2 + [["home", "0", "0", "250.0"]],
    ),
    "options that there are not": (
        [GCS, ARM, long(GO, 0, 4.0), SECOND],
        [(GO, 2, 0)],
        ["Go to: options must be flags of MAV_DO_REPOSITION_FLAGS"],
        [],
    ),
    "only armed": ([GCS, whole(GO)], [(GO, 1, 0)], ["Go to: arm first"], []),
    "only disarmed": ([ARM, long(TURN)], [(TURN, 1, 0)], ["Turn: disarm first"], []),
    "what is never right is denied all the same": (
        [ARM, long(TURN, 400.0)],
        [(TURN, 2, 0)],
        ["Turn: angle must be 0 to 6.28319 rad"],
        [],
    ),
    "nobody is heard": ([ARM, whole(GO)], [(GO, 2, 0)], ["Go to: only for ground stations that are heard"], []),
    "not heard on that link": (
        [ARM, heartbeat(link=1), whole(GO)],
        [(GO, 2, 0)],
        ["Go to: only for ground stations that are heard"],
        [],
    ),
    "no ground station": (
        [ARM, heartbeat(kind=mavlink.MAV_TYPE_ONBOARD_CONTROLLER), whole(GO)],
        [(GO, 2, 0)],
        ["Go to: only for ground stations that are heard"],
        [],
    ),
    # FR-301.2: to whom
    "to others": ([long(PUMP, 1.0, 50.0, to=to) for to in ((2, 1), (1, 2), (0, 2))], [], [], []),
    "to all": (
        [long(LIGHTS, to=to) for to in ((0, 0), (0, 1), (1, 0))],
        [(LIGHTS, 0, 0)] * 3,
        [],
        [["lights", "0.0", "0"]] * 3,
    ),
    "not known": ([long(UNKNOWN)], [(UNKNOWN, 3, 0)], [], []),
    # FR-301.4
    "accepted by True": ([said("lights", True), long(LIGHTS)], [(LIGHTS, 0, 0)], [], [["lights", "0.0", "0"]]),
    "refused": ([said("lights", False), long(LIGHTS)], [(LIGHTS, 4, 0)], [], [["lights", "0.0", "0"]]),
    "refused with a text": (
        [said("lights", "lamp is broken"), long(LIGHTS)],
        [(LIGHTS, 4, 0)],
        ["Set lights: lamp is broken"],
        [["lights", "0.0", "0"]],
    ),
    "an exception": (
        [said("lights", "raise"), long(LIGHTS), long(LIGHTS)],
        [(LIGHTS, 4, 0), (LIGHTS, 0, 0)],
        ["Set lights: ValueError: no water"],
        [["lights", "0.0", "0"]] * 2,
    ),
    "an answer that is none": (
        [said("lights", 5), long(LIGHTS)],
        [(LIGHTS, 4, 0)],
        ["Set lights: TypeError: returned 5"],
        [["lights", "0.0", "0"]],
    ),
    "not written": (
        [long(HORN), said("lights", "not written"), long(LIGHTS)],
        [(HORN, 3, 0), (LIGHTS, 3, 0)],
        [],
        [["lights", "0.0", "0"]],
    ),
    "the same refusal is told once in a second": (
        [said("lights", *["no"] * 4), *[long(LIGHTS)] * 3, SECOND, long(LIGHTS)],
        [(LIGHTS, 4, 0)] * 4,
        ["Set lights: no"] * 2,
        [["lights", "0.0", "0"]] * 4,
    ),
    "a pump that does not start": (
        [said("pump", "no water"), START],
        [(PUMP, 4, 0)],
        ["Pump: no water"],
        [["pump", "10.0", "20.0"]],
    ),
    # FR-301.5: asked each 100 ms, told each second
    "progress": (
        [said("progress", *range(0, 75, 5), True), START, ["run", 3000]],
        [(PUMP, 5, 0), (PUMP, 5, 45), (PUMP, 0, 0)],
        [],
        [["pump", "10.0", "20.0"], *[["progress"]] * 16],
    ),
    "progress beyond its ends": (
        [said("progress", *[-5] * 10, *[250.0] * 10, False), START, ["run", 4000]],
        [(PUMP, 5, 0), (PUMP, 5, 0), (PUMP, 5, 100), (PUMP, 4, 0)],
        [],
        [["pump", "10.0", "20.0"], *[["progress"]] * 21],
    ),
    "it fails with a text": (
        [said("progress", 5, "it is blocked"), START, SECOND],
        [(PUMP, 5, 0), (PUMP, 4, 0)],
        ["Pump: it is blocked"],
        [["pump", "10.0", "20.0"], *[["progress"]] * 2],
    ),
    "it fails by an exception": (
        [said("progress", 5, "raise"), START, SECOND],
        [(PUMP, 5, 0), (PUMP, 4, 0)],
        ["Pump: ValueError: no water"],
        [["pump", "10.0", "20.0"], *[["progress"]] * 2],
    ),
    "it ends with nonsense": (
        [said("progress", "not written"), START, SECOND],
        [(PUMP, 5, 0), (PUMP, 4, 0)],
        None,
        [["pump", "10.0", "20.0"], ["progress"]],
    ),
    "asked once more": (
        [
            said("progress", 7, 7, 7, 8, 8, 8, 8, 8, 8, 8),
            START,
            ["run", 200],
            long(PUMP, 10.0, 20.0, confirmation=1),
            whole(PUMP, 10.0, 20.0),
        ],
        [(PUMP, 5, 0), (PUMP, 5, 7), (PUMP, 5, 7)],
        [],
        None,
    ),
    "asked anew": (
        [said("progress", *[7] * 9), START, START, long(PUMP, 10.0, 20.0, confirmation=1, system=254)],
        [(PUMP, 5, 0), (PUMP, 1, 0), (PUMP, 1, 0)],
        ["Pump: is going on already"],
        None,
    ),
    "again after its end": (
        [START, SECOND, START, SECOND],
        [(PUMP, 5, 0), (PUMP, 0, 0)] * 2,
        [],
        [["pump", "10.0", "20.0"], ["progress"]] * 2,
    ),
    "others are done meanwhile": (
        [said("progress", *[7] * 9), START, long(LIGHTS)],
        [(PUMP, 5, 0), (LIGHTS, 0, 0)],
        [],
        None,
    ),
    # FR-301.6
    "cancelled": (
        [said("progress", *[7] * 9), START, cancel(PUMP), SECOND],
        [(PUMP, 5, 0), (PUMP, 6, 0)],
        [],
        [["pump", "10.0", "20.0"], ["cancel"]],
    ),
    "cancelled by somebody else": (
        [said("progress", *[7] * 9), START, cancel(PUMP, to=(0, 0), link=1, system=9)],
        [(PUMP, 5, 0), (PUMP, 6, 0)],
        [],
        [["pump", "10.0", "20.0"], ["cancel"]],
    ),
    "nothing to cancel": ([cancel(PUMP), cancel(LIGHTS), cancel(65535)], [], [], []),
    "cancelled elsewhere": (
        [said("progress", *[7] * 9), START, cancel(PUMP, to=(2, 1)), cancel(PUMP, to=(1, 9))],
        [(PUMP, 5, 0)],
        [],
        None,
    ),
    "cannot be cancelled": (
        [said("progress", *[7] * 9), said("cancel", False), START, cancel(PUMP)],
        [(PUMP, 5, 0), (PUMP, 5, 0)],
        ["Pump: cannot be cancelled"],
        [["pump", "10.0", "20.0"], ["cancel"]],
    ),
    "cancelling fails": (
        [said("progress", *[7] * 9), said("cancel", "raise"), START, cancel(PUMP), SECOND],
        [(PUMP, 5, 0), (PUMP, 4, 0)],
        ["Pump: ValueError: no water"],
        [["pump", "10.0", "20.0"], ["cancel"]],
    ),
    # FR-301.9
    "modes": ([mode(15), mode(0)], [(SET_MODE, 0, 0)] * 2, ["Mode GUIDED", "Mode MANUAL"], []),
    "the same mode": ([mode(4)], [(SET_MODE, 0, 0)], [], []),
    "no such mode": ([mode(1)], [(SET_MODE, 2, 0)], ["Mode: there is no mode 1"], []),
    "no mode at all": (
        [mode(0.5), mode(NAN), mode(INFINITE), mode(-1.0), mode(15, 0), mode(15, 128)],
        [(SET_MODE, 2, 0)] * 6,
        ["Mode: only custom modes, by whole numbers"] * 6,
        [],
    ),
    "the vehicle refuses": (
        [["says", "check_mode", "no position"], mode(15), set_mode(11)],
        [(SET_MODE, 4, 0)],
        ["Mode: no position"] * 2,
        [],
    ),
    "SET_MODE": (
        [set_mode(11), set_mode(15, system=2), set_mode(0, system=0), set_mode(7), set_mode(15, 0)],
        [],
        ["Mode RTL", "Mode MANUAL", "Mode: there is no mode 7", "Mode: only custom modes, by whole numbers"],
        [],
    ),
    "code changes it": (
        [["set_mode", 15], ["says", "check_mode", "no"], ["set_mode", 4]],
        [],
        ["Mode GUIDED"],
        [["None"], ["Mode: no"]],
    ),
}

# What HEARTBEAT says then: custom_mode and base_mode.
CUSTOM, GUIDED, STEERED, SAFETY_ARMED = 1, 8, 64, 128
HEARTBEATS = {
    "the ends": (4, CUSTOM),
    "modes": (0, CUSTOM | STEERED),
    "no such mode": (4, CUSTOM),
    "the vehicle refuses": (4, CUSTOM),
    "SET_MODE": (0, CUSTOM | STEERED),
    "code changes it": (15, CUSTOM | GUIDED),
    "only disarmed": (4, CUSTOM | SAFETY_ARMED),
}


@pytest.fixture(scope="module")
def boat(tmp_path_factory):
    """The folder in which the boat is built."""
    folder = tmp_path_factory.mktemp("commanded")
    subprocess.run(["cp", "-r", *map(str, (HERE / "commanded").iterdir()), str(folder)], check=True)
    build(folder)
    orders = [(name, [*steps, SECOND] if name in HEARTBEATS else steps) for name, (steps, *_) in CASES.items()]
    (folder / "orders.json").write_text("".join(f"{json.dumps(order)}\n" for order in orders))
    return folder


@pytest.fixture(scope="module", params=["micropython", "micropython32", "python"])
def results(request, boat):
    """Return the boat's results in each case."""
    done = subprocess.run(
        [str(BIN / request.param), "orders.py"], cwd=boat, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return dict(json.loads(line) for line in done.stdout.splitlines())


def received(frames):
    parser = mavlink.MAVLink(None)
    return [parser.parse_buffer(bytearray(bytes.fromhex(each)))[0] for each in frames]


def whole_texts(messages):
    """The texts, long ones put together of their chunks."""
    texts = []
    for each in messages:
        if each.get_type() == "STATUSTEXT":
            if each.chunk_seq:
                texts[-1] += each.text
            else:
                texts.append(each.text)
    return texts


def alike(given, expected):
    """Return whether arguments are the expected ones, floats to seven digits, and whole where they have to be."""
    name, *values = given
    if not all(isinstance(value, list) for value in values):
        return given == expected
    if name != expected[0] or len(values) != len(expected) - 1:
        return False
    return all(
        text == want
        if "None" in (text, want)
        else ("." in want) == (kind == "float") and math.isclose(float(text), float(want), rel_tol=1e-7)
        for (text, kind), want in zip(values, expected[1:], strict=True)
    )


@pytest.mark.parametrize("case", CASES)
def test_an_order_is_carried_out_and_answered(results, case):
    _, acks, texts, given = CASES[case]
    found = results[case]
    messages = received(found["frames"][0])
    answers = [each for each in messages if each.get_type() == "COMMAND_ACK"]
    assert [(each.command, each.result, each.progress) for each in answers] == acks
    assert {each.target_component for each in answers} <= {190}
    assert found["faults"] == [0, 0]
    if texts is not None:
        assert [text for text in whole_texts(messages) if text != "Armed"] == texts
    if given is not None:
        wanted = found["given"]
        assert len(wanted) == len(given), wanted
        assert all(map(alike, wanted, given)), wanted


@pytest.mark.parametrize("case", HEARTBEATS)
def test_the_heartbeat_tells_the_mode(results, case):
    last = [each for each in received(results[case]["frames"][0]) if each.get_type() == "HEARTBEAT"][-1]
    assert (last.custom_mode, last.base_mode) == HEARTBEATS[case]


def test_who_asked_is_answered_and_nobody_else(results):
    """Each acknowledgement goes out on the link that the command came from, to the system that sent it."""
    assert all(
        each.get_type() != "COMMAND_ACK" for each in received(results["cancelled by somebody else"]["frames"][1])
    )
    answers = [each for each in received(results["asked anew"]["frames"][0]) if each.get_type() == "COMMAND_ACK"]
    assert [each.target_system for each in answers] == [255, 255, 254]
