"""Received messages set quantities as the tables of a project say: frames by pymavlink, expected values by hand.

The whole program of tests/projects/received receives them, on three interpreters.
"""

import json
import math
import shutil
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import run_suite, suite_is_green
from in_process import build
from pymavlink.dialects.v10 import common as v1
from pymavlink.dialects.v20 import common

SPECS = Path(__file__).resolve().parent / "received" / "specs"
BIN = Path(sys.executable).parent
HERE, OTHER = 42, 43
PATHS = (
    "rc.rudder", "rc.throttle_us", "rc.extra", "stick.ahead", "stick.buttons", "stick.pressed", "fix.time",
    "fix.lat_dege7", "fix.lon_dege7", "fix.alt", "fix.hdop", "fix.yaw", "fix.north_mm_s", "fix.down_km_h",
    "second.satellites", "wheels.left",
    "wheels.right", "wheels.count", "tune.notes", "tune.program",
)  # fmt: skip
SCRIPT = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
from program_bench import Port, Craft, mock_time, run, run_passes

results = {}
paths, cases = json.loads(open("frames.json").read())
for name in cases:
    rover = Craft(ports=[Port(), Port()])
    state, calls, said = rover.state, [], []
    for path in paths:  # a vehicle of the bench knows some value of everything
        owner, _, quantity = path.partition(".")
        setattr(getattr(state, owner), quantity, None)
    for connection in rover.connections:
        for reception in connection.receptions.values():
            reception._log = lambda *words: said.append(" ".join(str(each) for each in words))
        reception = connection.receptions["RC_CHANNELS_OVERRIDE"]
        assert reception.called == rover.received_rc_channels_override
        reception.called = lambda: calls.append(rover.state.rc.rudder)
    for link, frame in cases[name]:
        if link == "ms":
            mock_time.advance_us(1000 * frame)
            continue
        rover.connections[link].port.arrives(bytes.fromhex(frame))
        run_passes(rover, 4)
    found = {}
    for path in paths:
        owner, _, quantity = path.partition(".")
        value = getattr(getattr(state, owner), quantity)
        if value is not None and value is not False:
            found[path] = value if isinstance(value, float) or value is True else str(value)
    counts = {}
    for connection in rover.connections:
        for table, reception in connection.receptions.items():
            if reception.taken:
                counts[table] = [counts.get(table, [0])[0] + reception.taken, reception.refused]
    results[name] = [found, counts, calls, said, sum([connection.faults for connection in rover.connections])]
print(json.dumps(results))
"""


def frame(message, system=255, component=190, link=0, dialect=common):
    """A step: the frame of a message on a link."""
    return [link, message.pack(dialect.MAVLink(None, srcSystem=system, srcComponent=component)).hex()]


def station(mode=0, system=255, kind=common.MAV_TYPE_GCS, link=0):
    return frame(common.MAVLink_heartbeat_message(kind, 8, 0, mode, 4, 3), system, link=link)


def override(first, second, ninth=0, target=(HERE, 1), **of):
    channels = [first, second, *[65535] * 6, ninth, *[0] * 9]
    return frame(common.MAVLink_rc_channels_override_message(*target, *channels), **of)


def old_override(first, second, **of):
    message = v1.MAVLink_rc_channels_override_message(HERE, 1, first, second, *[65535] * 6)
    return frame(message, dialect=v1, **of)


def joystick(x, buttons=0, buttons2=0, target=HERE, dialect=common):
    if dialect is v1:
        return frame(v1.MAVLink_manual_control_message(target, x, 0, 0, 0, buttons), dialect=v1)
    return frame(common.MAVLink_manual_control_message(target, x, 0, 0, 0, buttons, buttons2))


def fix(
    number=0,
    time=0,
    lat=0,
    lon=0,
    alt=0.0,
    hdop=65535.0,
    yaw=0,
    satellites=0,
    north=0.0,
    down=0.0,
    system=HERE,
    component=9,
):
    message = common.MAVLink_gps_input_message(
        time, number, 0, 0, 0, 3, lat, lon, alt, hdop, 0, north, 0, down, 0, 0, 0, satellites, yaw
    )
    return frame(message, system, component)


def wheels(left, right, count=2):
    return frame(common.MAVLink_wheel_distance_message(0, count, [left, *[0.0] * 14, right]))


def tune(text, target=(HERE, 1)):
    return frame(common.MAVLink_play_tune_message(*target, text.encode("latin-1"), b""))


def bits(size, pattern):
    """The float of a pattern, which pymavlink packs again to the bit."""
    return struct.unpack("<f" if size == 4 else "<d", pattern.to_bytes(size, "little"))[0]


GCS = station()
SECOND = 0x3FF0000000000001  # the double after 1
# By name: what arrives; what is known then; messages taken and numbers refused, by table; rudders told of by a call.
CASES = {
    "nothing": ([], {}, {}, []),
    "of nobody that is heard": ([override(1500, 1500)], {}, {}, []),
    "of no ground station": ([station(system=7, kind=2), override(1500, 1500, system=7)], {}, {}, []),
    "on the other link": ([GCS, override(1500, 1500, link=1)], {}, {"HEARTBEAT": [1, {}]}, []),
    "taken": (
        [GCS, override(1100, 1999, 1234)],
        {"rc.rudder": "1100", "rc.throttle_us": "1999", "rc.extra": "1234"},
        {"HEARTBEAT": [1, {}], "RC_CHANNELS_OVERRIDE": [1, {}]},
        [1100],
    ),
    "for everybody": (
        [GCS, override(1, 1000, 0, (0, 0)), override(2, 2000, 0, (HERE, 0)), override(3, 1500, 0, (0, 1))],
        {"rc.rudder": "3", "rc.throttle_us": "1500"},
        {"RC_CHANNELS_OVERRIDE": [3, {}]},
        [1, 2, 3],
    ),
    "for others": (
        [GCS, override(1, 1000, 0, (OTHER, 1)), override(2, 2000, 0, (HERE, 2)), override(3, 1500, 0, (OTHER, 0))],
        {},
        {},
        [],
    ),
    # What is not plausible leaves the other channels alone; 0 gives a channel back to the radio.
    "not plausible": (
        [GCS, override(1500, 1600), override(0, 999), override(1, 2001), override(1, 20)],
        {"rc.rudder": "1", "rc.throttle_us": "1600"},
        {"RC_CHANNELS_OVERRIDE": [4, {"chan2_raw": 3}]},
        [1500, None, 1, 1],
    ),
    # 65535 leaves a channel as it was; 0 does so for the ninth, and 65534 gives that back, as 0 does the others.
    "left as they were": (
        [GCS, override(1500, 1600, 1700), override(65535, 65535, 0), override(65535, 65535, 65535)],
        {"rc.rudder": "1500", "rc.throttle_us": "1600", "rc.extra": "1700"},
        {"RC_CHANNELS_OVERRIDE": [3, {}]},
        [1500, 1500, 1500],
    ),
    "left alone from the start": (
        [GCS, override(65535, 65535, 0), override(65535, 65535, 65535)],
        {},
        {},
        [None, None],
    ),
    "one after the other": (
        [GCS, override(1500, 65535, 0), override(65535, 1600, 65535), override(65535, 65535, 1700)],
        {"rc.rudder": "1500", "rc.throttle_us": "1600", "rc.extra": "1700"},
        {"RC_CHANNELS_OVERRIDE": [3, {}]},
        [1500, 1500, 1500],
    ),
    "given back": (
        [GCS, override(1500, 1600, 1700), override(0, 0, 65534)],
        {},
        {"RC_CHANNELS_OVERRIDE": [2, {}]},
        [1500, None],
    ),
    "left, and too old": (
        [GCS, override(1500, 1600), ["ms", 400], override(65535, 1601), ["ms", 101]],
        {"rc.throttle_us": "1601"},
        {},
        [1500, 1500],
    ),
    "ninth channel at its end": (
        [GCS, override(65534, 1600, 65533)],
        {"rc.rudder": "65534", "rc.throttle_us": "1600", "rc.extra": "65533"},
        {},
        [65534],
    ),
    "MAVLink 1": (
        [GCS, override(1500, 1600, 1700), old_override(1501, 1601)],
        {"rc.rudder": "1501", "rc.throttle_us": "1601", "rc.extra": "1700"},  # as a frame that was truncated
        {"RC_CHANNELS_OVERRIDE": [2, {}]},
        [1500, 1501],
    ),
    "half a second": (
        [GCS, override(1500, 1600), ["ms", 400]],
        {"rc.rudder": "1500", "rc.throttle_us": "1600"},
        {},
        [1500],
    ),
    "more than half a second": ([GCS, override(1500, 1600), ["ms", 501]], {"rc.throttle_us": "1600"}, {}, [1500]),
    "again": (
        [GCS, override(1500, 1600), ["ms", 400], override(1500, 1600), ["ms", 400]],
        {"rc.rudder": "1500", "rc.throttle_us": "1600"},
        {},
        [1500, 1500],
    ),
    "stick": (
        [joystick(-1000, 65535, 4)],
        {"stick.ahead": "-1000", "stick.buttons": "65535", "stick.pressed": True},
        {},
        [],
    ),
    "stick of another": ([joystick(5, target=OTHER)], {}, {}, []),
    "stick beyond": (
        [joystick(7), joystick(1001), joystick(-1001), joystick(-32768)],
        {"stick.ahead": "7", "stick.buttons": "0"},
        {"MANUAL_CONTROL": [4, {"x": 3}]},
        [],
    ),
    "no stick": ([joystick(7, 3), joystick(32767, 3)], {"stick.buttons": "3"}, {}, []),
    # MAVLink 1 has no second buttons: what was pressed stays so.
    "pressed": (
        [joystick(0, 0, 1), joystick(9, 8, dialect=v1)],
        {"stick.ahead": "9", "stick.buttons": "8", "stick.pressed": True},
        {},
        [],
    ),
    "released": ([joystick(0, 0, 1), joystick(0)], {"stick.ahead": "0", "stick.buttons": "0"}, {}, []),
    "fix": (
        [fix(time=2**64 - 2, lat=-353632621, lon=1396900000, alt=12.5, hdop=1.25, yaw=35950)],
        {
            "fix.time": str(2**64 - 2),
            "fix.lat_dege7": "-353632621",
            "fix.lon_dege7": "1396900000",
            "fix.alt": 12.5,
            "fix.hdop": 1.25,
            "fix.yaw": "360",
        },
        {"fix": [1, {}]},
        [],
    ),
    # 0.0125 m/s are 12.5 mm/s, of which the float lies above; 2.638889 m/s are 9.5 km/h, of which it lies below.
    "speeds": (
        [fix(north=0.0125, down=-2.6388888)],
        {
            "fix.time": "0",
            "fix.lat_dege7": "0",
            "fix.lon_dege7": "0",
            "fix.alt": 0.0,
            "fix.north_mm_s": "13",
            "fix.down_km_h": "-9",
        },
        {"fix": [1, {}]},
        [],
    ),
    "fast": (
        [fix(north=-500.0, down=1000.0), fix(north=500.0001, down=-1000.001), fix(north=3e38, down=-3e38)],
        {
            "fix.time": "0",
            "fix.lat_dege7": "0",
            "fix.lon_dege7": "0",
            "fix.alt": 0.0,
            "fix.north_mm_s": "-500000",
            "fix.down_km_h": "3600",
        },
        {"fix": [3, {"vn": 2, "vd": 2}]},
        [],
    ),
    "no speeds": (
        [fix(north=5.0, down=5.0), fix(north=math.nan, down=math.inf)],
        {
            "fix.time": "0",
            "fix.lat_dege7": "0",
            "fix.lon_dege7": "0",
            "fix.alt": 0.0,
            "fix.north_mm_s": None,
            "fix.down_km_h": "18",  # its table says that NaN leaves it
        },
        {"fix": [2, {}]},
        [],
    ),
    # Numbers of the tables' own: 99.99 as the float that is nearest to it, of 32 bits and of 64.
    "numbers that say something": (
        [fix(alt=5.0, hdop=2.0, yaw=100), fix(alt=-1000.0, hdop=99.99, yaw=65535), wheels(2.5, 3.5), wheels(0.1, 7.0)],
        {
            "fix.time": "0",
            "fix.lat_dege7": "0",
            "fix.lon_dege7": "0",
            "fix.hdop": 2.0,
            "wheels.left": 2.5,
            "wheels.right": 7.0,
            "wheels.count": "2",
        },
        {"fix": [2, {}], "WHEEL_DISTANCE": [2, {}]},
        [],
    ),
    "fix of another system": ([fix(time=5, system=OTHER)], {}, {}, []),
    "own fix": ([fix(time=5, component=1)], {}, {}, []),
    "ends of the earth": (
        [fix(lat=900000000, lon=-1800000000, alt=-500.0, yaw=149)],
        {
            "fix.time": "0",
            "fix.lat_dege7": "900000000",
            "fix.lon_dege7": "-1800000000",
            "fix.alt": -500.0,
            "fix.yaw": "1",
        },
        {"fix": [1, {}]},
        [],
    ),
    "beyond the earth": (
        [
            fix(0, 1, 1, -1, 8848.0, bits(4, 1)),
            fix(time=2, lat=900000001, lon=1800000001, alt=8848.001),
            fix(time=3, lat=-900000001, lon=-1800000001, alt=-500.001),
            fix(time=4, lat=-(2**31), lon=2**31 - 1, alt=3.4e38, hdop=-0.0),
        ],
        {"fix.time": "4", "fix.lat_dege7": "1", "fix.lon_dege7": "-1", "fix.alt": 8848.0, "fix.hdop": -0.0},
        {"fix": [4, {"lat": 3, "lon": 3, "alt": 3}]},
        [],
    ),
    "nobody knows": (
        [fix(time=1, alt=5.0, hdop=2.0), fix(time=2, alt=math.nan, hdop=65535.0)],
        {"fix.time": "2", "fix.lat_dege7": "0", "fix.lon_dege7": "0"},
        {"fix": [2, {}]},
        [],
    ),
    "infinite": (
        [fix(alt=5.0, hdop=2.0), fix(alt=-math.inf, hdop=math.inf)],
        {"fix.time": "0", "fix.lat_dege7": "0", "fix.lon_dege7": "0"},
        {"fix": [2, {}]},
        [],
    ),
    "two seconds": (
        [fix(alt=5.0), ["ms", 1900]],
        {"fix.time": "0", "fix.lat_dege7": "0", "fix.lon_dege7": "0", "fix.alt": 5.0},
        {},
        [],
    ),
    "more than two": (
        [fix(alt=5.0), ["ms", 2001]],
        {"fix.time": "0", "fix.lat_dege7": "0", "fix.lon_dege7": "0"},
        {},
        [],
    ),
    "the second receiver": (
        [fix(1, satellites=255, system=OTHER), fix(2, satellites=3), fix(1, satellites=17)],
        {"second.satellites": "17"},
        {"second_receiver": [2, {}]},
        [],
    ),
    "wheels": (
        [wheels(bits(8, SECOND), -1000.0)],
        {"wheels.left": bits(8, SECOND), "wheels.right": -1000.0, "wheels.count": "2"},
        {"WHEEL_DISTANCE": [1, {}]},
        [],
    ),
    "wheels beyond": (
        [wheels(1e308, 1000.0, 16), wheels(-1e308, 1000.0000000000001, 17), wheels(5e-324, -1e300, 255)],
        {"wheels.left": 5e-324, "wheels.right": 1000.0, "wheels.count": "16"},
        {"WHEEL_DISTANCE": [3, {"distance[15]": 2, "count": 2}]},
        [],
    ),
    "no wheels": (
        [wheels(1.0, 1.0), wheels(math.nan, math.inf)],
        {"wheels.count": "2"},
        {"WHEEL_DISTANCE": [2, {}]},
        [],
    ),
    "tune": ([tune("MFT200L16<cdefgab>cdefgab")], {"tune.notes": "MFT200L16<cdefgab>cdefgab"}, {}, []),
    "a tune as long as there is room": ([tune("x" * 31)], {"tune.notes": "x" * 30}, {}, []),
    "a shorter one": ([tune("x" * 30), tune("c")], {"tune.notes": "c"}, {}, []),
    "no notes": ([tune("x" * 30), tune("")], {"tune.notes": ""}, {}, []),
    "no ASCII": ([tune("abc"), tune("abd\xe9f")], {"tune.notes": "abc"}, {"PLAY_TUNE": [2, {"tune": 1}]}, []),
    "for another": ([tune("abc", (OTHER, 0))], {}, {}, []),
    # The services take HEARTBEAT, too, and hear the ground station first.
    "mode": (
        [station(100000), station(100001), station(2**32 - 1)],
        {"tune.program": "100000"},
        {"HEARTBEAT": [3, {"custom_mode": 1}]},
        [],
    ),
    "mode of another vehicle": ([station(5, 7, 2)], {}, {}, []),
}


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The folder in which the project is built, with what arrives."""
    folder = tmp_path_factory.mktemp("received")
    shutil.copytree(SPECS, folder / "specs")
    build(folder)
    (folder / "receive.py").write_text(SCRIPT)
    steps = {name: case[0] for name, case in CASES.items()}
    (folder / "frames.json").write_text(json.dumps([PATHS, steps]))
    return folder


@pytest.fixture(scope="module", params=["micropython", "micropython32", "python"])
def found(request, built):
    """Return the result of each case."""
    command = [str(BIN / request.param), "receive.py"]
    done = subprocess.run(command, cwd=built, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_what_arrives_sets_what_the_tables_say(found):
    """Ends and what lies beyond, unknown, NaN, others' messages, MAVLink 1, silence; nothing raises."""
    for name, (_, known, counts, calls) in CASES.items():
        values, counted, called, _, faults = found[name]
        heard = {"tune.program": "0"} if CASES[name][0][:1] == [GCS] else {}
        heard |= {"fix.north_mm_s": "0", "fix.down_km_h": "0"} if "fix.time" in known else {}
        wanted = {path: value for path, value in (heard | known).items() if value is not None}
        assert values == wanted, name
        for table, count in counts.items():
            assert counted[table] == count, (name, table)
        assert called == calls, name
        assert faults == 0, name


def test_what_is_not_plausible_is_told_once_in_ten_seconds(found):
    """With what came, in one text, however many there are."""
    assert found["not plausible"][3] == ["warning: RC_CHANNELS_OVERRIDE.chan2_raw not plausible: 999"]
    assert found["wheels beyond"][3] == ["warning: WHEEL_DISTANCE.count not plausible: 17"]
    assert found["no ASCII"][3][0].startswith("warning: PLAY_TUNE.tune not plausible: ")
    assert found["taken"][3] == []


STEADY = """
import sys
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
import gc, json, micropython
from program_bench import Craft, run_passes
if sys.argv[1] == "plain":
    sys.modules["receiving_viper"] = None

rover = Craft()
connection = rover.connections[0]
frames = [bytes.fromhex(frame) for frame in json.load(open("steady.json"))]
link, handle = connection.link, connection.services.handle
link._state[16] = 0  # without the limit of a pass

def take(message):  # as a pass of the main loop does
    handle(message)
    table = connection.tables[message.ID]
    found = message._take(0)
    if found > 0:
        table.tell()
    if found and table.called is not None:
        table.called()

def receive(rounds):
    for _ in range(rounds):
        for frame in frames:
            link.put(frame)
            take(link.receive())

receive(2)
frames.pop(0)  # a HEARTBEAT is for the services, too, which name the ground station anew

def allocated(rounds):
    before = micropython.mem_total()
    receive(rounds)
    return micropython.mem_total() - before

gc.collect()
found = [allocated(20), allocated(200)]
print(json.dumps([found, sorted([reception.taken for reception in connection.receptions.values()])]))
"""


@pytest.mark.parametrize(
    ("interpreter", "plain"), [("micropython", "no"), ("micropython", "plain"), ("micropython32", "plain")]
)
def test_taking_a_message_allocates_nothing(built, interpreter, plain):
    """In machine code and in plain Python, with words of 32 bits: numbers of more than 30 bits, floats, texts."""
    steps = [
        GCS,
        override(1500, 1600, 1700),
        joystick(-7, 3, 1),
        fix(time=2**63, lat=-1, lon=-(2**30) - 5, alt=1.5, north=-1.5, down=9.75),
    ]
    steps += [fix(1, satellites=9), wheels(1.5, -2.5), tune("cdefgab")]
    (built / "steady.json").write_text(json.dumps([hexadecimal for _, hexadecimal in steps]))
    (built / "steady.py").write_text(STEADY)
    command = [str(BIN / interpreter), "steady.py", plain]
    done = subprocess.run(command, cwd=built, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    allocated, taken = json.loads(done.stdout)
    assert taken == [0, 0, 2] + [222] * 6  # of two tables nothing comes
    assert allocated[0] == allocated[1]  # the loop itself takes some


# A change of a generated function, and what its suite says about it.
BITES = {
    "value > 2000": ("value > 2001", "chan2_raw-above"),
    "if value == 65535:  # left as it was": ("if value == 65534:", "chan1_raw-unchanged-65535"),
    "elif value == 0:  # there is none": ("elif value == 1:", "chan1_raw-unknown-0"),
    "0x7F80 == 0x7F80": ("0x7F80 == 0x7F00", "alt-nan"),
    "wire[60] != 0": ("wire[60] != 1", "fix-other-gps_id"),
    "now_ms - 1073741324": ("now_ms - 1073741323", "chan1_raw-too-old"),
    "(value + 50) // 100": ("(value + 49) // 100", "yaw-half"),
    "if counts[2]:  # MAVLink 1": ("if counts[2] > 1:  # MAVLink 1", "MAVLink-1"),
    "0xC47A and (wire[20] | wire[21] << 8) == 0x0": ("0xC47A and wire[20] == 0x0", "alt-beside--1000.0-12"),
    "(wire[0] | wire[1] << 8)\n    return counts[0]": (
        "(wire[0] | wire[1] << 8)\n    return counts[1]",
        "custom_mode-lowest",  # what is plausible is not told
    ),
}


# What leaves the rudder, and the time until which it is believed; and what is counted where the height is not taken.
LEAVES = "if value == 65535:  # left as it was\n        "
REFUSES = "        counts[19] = counts[19] + 1 & 0x3FFFFFFF\n"
RENEWS = "words[_RC_RUDDER_US_EXPIRES_MS] = now_ms - 1073741324 & 0x3FFFFFFF"


def test_the_generated_suite_is_green_and_bites(built):
    """It passes; a wrong limit, special value, condition, age, rounding or extension is noticed where it is."""
    suite_is_green(built, "generated/tests/test_receives.py")
    plain = built / "generated" / "firmware" / "receiving_plain.py"
    text = plain.read_text()
    broken = text
    for old, (new, _) in BITES.items():
        assert old in text, old
        broken = broken.replace(old, new, 1)
    failed = _failed(built, plain, broken)
    for _, noticed in BITES.values():
        assert noticed in failed, (noticed, failed)
    assert LEAVES + "pass" in text
    failed = _failed(built, plain, text.replace(LEAVES + "pass", LEAVES + RENEWS, 1))
    assert "chan1_raw-left-65535" in failed
    assert REFUSES in text
    renewed = f"{REFUSES}        words[_FIX_ALT_EXPIRES_MS] = now_ms - 1073739824 & 0x3FFFFFFF\n"
    failed = _failed(built, plain, text.replace(REFUSES, renewed, 1))
    assert "alt-refused-and-old" in failed
    plain.write_text(text)


def _failed(built, plain, text):
    """The checks that fail with another text of the functions."""
    plain.write_text(text)
    done = run_suite(built, "generated/tests/test_receives.py", options=("-k", "cpython", "--tb=no"))
    return "\n".join(line for line in done.stdout.splitlines() if line.startswith("FAILED"))


ANSWERING = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
import messages
from program_bench import Port, Craft, run_passes

rover = Craft(ports=[Port(), Port()])
assert rover.reception is None
seen = []

def answer():  # what received_...() of a user's code may do
    reception = rover.reception
    connection, sender = reception.connection, reception.message
    seen.append([rover.connections.index(connection), sender.ID, sender.source_system, sender.source_component])
    ack = messages.CommandAck(unknown=False).update(
        command=sender.ID, target_system=sender.source_system, target_component=sender.source_component
    )
    connection.deliver(connection.send, ack)

for connection in rover.connections:
    for reception in connection.receptions.values():
        reception.called = answer
sent = []
for link, frame in json.loads(open("answering.json").read()):
    for connection in rover.connections:
        connection.port.frames = []
    rover.connections[link].port.arrives(bytes.fromhex(frame))
    run_passes(rover, 4)
    found = [[bytes(each) for each in connection.port.frames] for connection in rover.connections]
    sent.append([[list(each[10:-2]) for each in frames if each[7] == 77] for frames in found])
print(json.dumps([seen, sent, [connection.faults for connection in rover.connections]]))
"""


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_code_can_answer_who_has_sent(built, interpreter):
    """What is called knows the message with its sender, and the connection: answers go out there, to nobody else."""
    (built / "answering.py").write_text(ANSWERING)
    steps = [
        station(system=200, link=1),
        override(1500, 1500, system=200, component=7, link=1),
        station(system=201),
        override(1400, 1500, system=201, component=8),
        frame(common.MAVLink_play_tune_message(HERE, 1, b"abc"), system=202, component=9, link=1),
    ]
    (built / "answering.json").write_text(json.dumps(steps))
    done = subprocess.run(
        [str(BIN / interpreter), "answering.py"], cwd=built, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    seen, sent, faults = json.loads(done.stdout)
    assert {tuple(each) for each in seen} >= {(1, 70, 200, 7), (0, 70, 201, 8), (1, 258, 202, 9)}
    assert faults == [0, 0]
    told = [
        [link, ack[0] | ack[1] << 8, *ack[8:10]] for links in sent for link, acks in enumerate(links) for ack in acks
    ]
    assert sorted(told) == sorted(seen)
