"""Lists go out as they were set, in arrays of the installed dialect, which pymavlink decodes; wrong ones are told.

The generated suite of the project has every type and each element; here are messages that vehicles send, by hand.
"""

import json
import math
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build
from pymavlink.dialects.v20 import common

from codegen.diagnostics import Report
from codegen.project.systems import read_systems

HERE = Path(__file__).resolve().parent
SPECS = HERE / "rows" / "specs"
BIN = Path(sys.executable).parent
SCRIPT = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks"]
import mock_time
mock_time.install()
import telemetry
from mavlink import Link
from state import SystemState

state = SystemState(log=lambda *words: None)
link = Link(None)
nav, frames = state.nav, []

def keep(frame):
    frames.append(None if frame is None else bytes(frame).hex())

def attitude():
    keep(telemetry.encode_attitude_quaternion_cov(link, state))

nav.attitude = (1, -0.5, 0.1, 1e-30)
attitude()
nav.covariance = [0.1 * at for at in range(9)]
attitude()
nav.covariance[8] = None
attitude()
nav.covariance[8], nav.covariance[0] = 1e30, -2.5
attitude()
mock_time.advance_us(500000)
attitude()
mock_time.advance_us(1000)
attitude()
nav.attitude = [1, None, 0, 0]
attitude()
nav.outputs = [at / 3 - 4 for at in range(32)]
nav.outputs[-1], nav.outputs[5] = None, float("nan")
keep(telemetry.encode_actuator_output_status(link, state))
refused = []
for change in (
    lambda: setattr(nav, "attitude", (1, 0, 0)),
    lambda: setattr(nav, "outputs", []),
    lambda: nav.outputs[32],
    lambda: nav.outputs.__setitem__(-33, 1),
    lambda: nav.attitude.__setitem__(0, 1),
):
    try:
        change()
        refused.append("")
    except (ValueError, IndexError, TypeError, AttributeError) as error:
        refused.append(type(error).__name__)
told = [list(nav.attitude), nav.outputs[31], nav.outputs[5], nav.outputs[-2] == nav.outputs[30], len(nav.attitude)]
print(json.dumps([frames, refused, told]))
"""


@pytest.fixture(scope="module")
def rows(tmp_path_factory):
    """The folder in which the project is built."""
    folder = tmp_path_factory.mktemp("rows")
    shutil.copytree(SPECS, folder / "specs")
    build(folder)
    (folder / "send.py").write_text(SCRIPT)
    return folder


def single(value):
    """The nearest float of 32 bits."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_lists_arrive_as_they_were_set(rows, interpreter):
    """Floats to the bit; what is unknown as a whole, withheld, forgotten, or refused."""
    done = subprocess.run([str(BIN / interpreter), "send.py"], cwd=rows, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    frames, refused, told = json.loads(done.stdout)
    parser = common.MAVLink(None)
    messages = [frame and parser.parse_buffer(bytearray(bytes.fromhex(frame)))[0] for frame in frames]
    without, every, partly, other, fresh, old, unknown, outputs = messages
    assert without.q == [1, -0.5, single(0.1), single(1e-30)]
    # The dialect: "If unknown, assign NaN value to first element in the array."
    for message in (without, partly):
        assert math.isnan(message.covariance[0])
        assert message.covariance[1:] == [0] * 8
    assert every.covariance == [single(0.1 * at) for at in range(9)]
    assert other.covariance == [-2.5, *(single(0.1 * at) for at in range(1, 8)), single(1e30)]
    assert fresh.q == without.q
    assert old is None  # half a second and one millisecond after it was set
    assert unknown is None  # the quaternion has no number for an unknown element
    # The dialect says in words: "Zero values indicate unused channels." A real 0 is the smallest normal float.
    expected = [single(at / 3 - 4) for at in range(32)]
    expected[5] = expected[31] = 0
    expected[12] = 2.0**-126
    assert outputs.actuator == expected
    assert refused[:4] == ["ValueError", "ValueError", "IndexError", "IndexError"]
    assert refused[4] in ("TypeError", "AttributeError")  # as the list that ages has no such method
    assert told == [[1, None, 0, 0], None, None, True, 4]


ATTITUDE = "messages/attitude_quaternion_cov.yaml"
WRONG = [
    ("state.yaml", "elements: 4, stale", "elements: 5, stale", "unequal-length", f"{ATTITUDE}:7", "elements: 4"),
    (ATTITUDE, "covariance: {", "covariance[0..7]: {", "unequal-length", f"{ATTITUDE}:11", "elements: 8"),
    ("state.yaml", "elements: 32", "elements: 0", "bad-elements", "state.yaml:7", None),
    ("state.yaml", "elements: 32", "elements: 2.5", "bad-elements", "state.yaml:7", None),
    ("state.yaml", "elements: 32", "elements: 256", "bad-elements", "state.yaml:7", None),
    ("state.yaml", "elements: 32", "elements: 32, boolean: true", "bad-elements", "state.yaml:7", None),
    ("state.yaml", "unit: m, elements: 4", "unit: V, elements: 4", "unit-mismatch", "messages/odd_rows.yaml:7", None),
    (ATTITUDE, "send: while_known\n", "", "no-sentinel", f"{ATTITUDE}:6", "send: while_known"),
    (ATTITUDE, "{state: nav.attitude}", "{each: nav.attitude}", "bad-each", f"{ATTITUDE}:7", None),
]


@pytest.mark.parametrize(
    ("file", "old", "new", "rule", "place", "hint"), WRONG, ids=[f"{each[3]}-{each[2]}" for each in WRONG]
)
def test_what_does_not_fit_is_told_at_its_place(file, old, new, rule, place, hint, tmp_path):
    """Lengths, numbers of elements, units, and elements that nothing says to be unknown."""
    shutil.copytree(SPECS, tmp_path / "specs")
    changed = tmp_path / "specs" / file
    text = changed.read_text()
    assert text.count(old) == 1
    changed.write_text(text.replace(old, new))
    report = Report()
    read_systems(str(tmp_path / "specs" / "codegen.yaml"), report)
    found = [(one.rule.id, f"{one.place.file}:{one.place.line}", one.message, one.hint or "") for one in report]
    assert any(one[0] == rule and one[1].endswith(place) and (hint is None or hint in one[3]) for one in found), found


def test_initial_stands_in_for_each_value(tmp_path):
    """As for a single one: of a list with an initial value nothing is withheld, each element has it until it is set."""
    shutil.copytree(SPECS, tmp_path / "specs")
    state = tmp_path / "specs" / "state.yaml"
    state.write_text(state.read_text().replace("elements: 4, stale_after: 500 ms", "elements: 4, initial: 0.25"))
    table = tmp_path / "specs" / ATTITUDE
    table.write_text(table.read_text().replace("send: while_known\n", ""))
    build(tmp_path)
    script = (
        SCRIPT.partition("nav.attitude = ")[0]
        + "attitude()\nnav.attitude[1] = 2\nattitude()\nprint(json.dumps(frames))"
    )
    (tmp_path / "send.py").write_text(script)
    done = subprocess.run([str(BIN / "micropython"), "send.py"], cwd=tmp_path, capture_output=True, check=True)
    parser = common.MAVLink(None)
    found = [parser.parse_buffer(bytearray(bytes.fromhex(frame)))[0].q for frame in json.loads(done.stdout)]
    assert found == [[0.25] * 4, [0.25, 2, 0.25, 0.25]]


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_initial_is_read_of_each_value(tmp_path, interpreter):
    """Of lists that are kept in one word for each value, in several, and as floats: as of a single value."""
    shutil.copytree(SPECS, tmp_path / "specs")
    state = tmp_path / "specs" / "state.yaml"
    text = state.read_text()
    initial = {"reals": "0.25", "voltages": "12.5", "counts": "30000", "bigs": "5", "doubles": "-0.1"}
    for name, value in initial.items():
        text = re.sub(f"({name}: .*elements: [0-9]+)", rf"\1, initial: {value}", text)
    state.write_text(text)
    build(tmp_path)
    names = ("data", "voltages", "counts", "bigs", "reals", "doubles")
    script = SCRIPT.partition("link = ")[0] + (
        "meter = state.meter\n"
        f"print(json.dumps([list(getattr(meter, name)) for name in {names}]))\n"
        "meter.data[3] = None\nprint(json.dumps([meter.data[2], meter.data[3]]))\n"
    )
    (tmp_path / "read.py").write_text(script)
    done = subprocess.run(
        [str(BIN / interpreter), "read.py"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    found, after = map(json.loads, done.stdout.splitlines())
    assert found == [[7] * 20, [12.5] * 3, [30000] * 4, [5] * 2, [0.25] * 4, [-0.1] * 3]
    assert after == [7, None]
