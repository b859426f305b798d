"""Outputs of drivers of the project's own that need 32 bits: a longitude in degE7, microseconds, an encoder.

Each of its values goes out as it is, what lies beyond its limits is unknown, and no value in between is.
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import run_suite
from in_process import build, codegen

BIN = Path(sys.executable).parent
LIMITS = "min: -180, max: 180"
FILES = {
    "specs/codegen.yaml": "project: e\ndialect: minimal\noverlays: [e.xml]\n",
    "specs/parameters.yaml": "parameters: {}\n",
    "specs/streams.yaml": "streams:\n  only: {doc: d., rate: 1 Hz}\n",
    "specs/requirements/FR-1.md": "# FR-1 | T\n\n## Metadata\n\n- Status: Draft\n\n## Acceptance Criteria\n\n1. a.\n",
    "specs/e.xml": '<mavlink><messages><message id="54440" name="E"><description>d</description>'
    '<field type="int32_t" name="own" units="degE7" invalid="INT32_MAX">d</field>'
    '<field type="int32_t" name="lat" units="degE7" invalid="INT32_MAX">d</field>'
    '<field type="uint32_t" name="stamp" units="us" invalid="UINT32_MAX">d</field>'
    '<field type="int32_t" name="user" units="degE7" invalid="INT32_MAX">d</field>'
    '<field type="int32_t" name="exact" units="degE7" invalid="INT32_MAX">d</field>'
    "</message></messages></mavlink>",
    "specs/messages/e.yaml": "message: E\nrequirement: FR-1.1\nstream: only\nfields:\n"
    + "".join(f"  {name}: {{state: m.{name}}}\n" for name in ("own", "lat", "stamp", "user", "exact")),
    "specs/state.yaml": "components:\n  m:\n    doc: d\n    quantities:\n"
    + "".join(
        f"      {name}: {{doc: d, unit: {unit}, source: {source}, stale_after: 1 s}}\n"
        for name, unit, source in (
            ("own", "deg", "rx.lon"),
            ("lat", "deg", "rx.lat"),
            ("stamp", "us", "rx.stamp"),
            ("user", "deg", "eye.lon"),
            ("exact", "deg", "eye.exact"),
        )
    ),
    "specs/board.yaml": "board: pico_2\nsources:\n  rx: {driver: ubx, uart: 1, tx: 8, rx: 9}\n"
    "  eye: {driver: user, class: eye.Eye, outputs: {alt: {unit: m, stored: mm}, "
    f"lon: {{unit: deg, stored: degE7, {LIMITS}}}, "
    "exact: {unit: degE7, min: -1800000000, max: 1800000000}}}\n",
    "specs/drivers/ubx.yaml": "doc: A receiver.\nclass: Ubx\nbus: uart\noutputs:\n"
    f"  lon: {{unit: deg, stored: degE7, {LIMITS}}}\n"
    "  lat: {unit: deg, stored: degE7, min: -90, max: 90}\n"
    "  stamp: {unit: us, min: 0, max: 4294967290}\n",
    "specs/drivers/ubx.py": """\
from array import array

from polling import UNKNOWN

COUNT = 5
GIVES = [None, None, None]


class Ubx:
    def __init__(self, opened):
        self.values = array("i", [UNKNOWN] * COUNT)

    def begin(self):
        pass

    def poll(self, _now_ms):
        for place, number in zip((0, 2, 3), GIVES):
            if number is None:
                self.values[place] = UNKNOWN
            elif place == 2 or isinstance(number, list):  # a whole number where halves belong
                self.values[place] = number if place == 2 else number[0]
            else:
                self.values[place] = number & 0xFFFF
                self.values[place + 1] = number >> 16
        return True
""",
    "eye.py": "GIVES = [None, None, None]\n\n\nclass Eye:\n    def read(self):\n        return GIVES\n",
    "drive.py": """\
import json
import struct
import sys

sys.path[:0] = ["generated/firmware", "generated/mocks", "."]

import mock_time

mock_time.install()

import eye
import mavlink
import telemetry
import ubx
from sources import Sources
from state import SystemState

state = SystemState()
sources = Sources(state)
link = mavlink.Link(None)
found = []
for own, lat, stamp, user, exact in json.loads(sys.stdin.read()):
    ubx.GIVES[:] = [own, lat, stamp]
    eye.GIVES[:] = [None, user, exact]
    sources.rx.turn()
    sources.eye.turn()
    frame = bytes(telemetry.encode_e(link, state))
    found.append(struct.unpack("<iiIii", frame[10:-2] + bytes(20 - len(frame[10:-2]))))
print(json.dumps(found))
""",
}
UNKNOWN, UNKNOWN_US = 2**31 - 1, 2**32 - 1


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the project is built."""
    folder = tmp_path_factory.mktemp("wide")
    for name, text in FILES.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    build(folder)
    return folder


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_each_number_within_the_limits_goes_out_as_it_is(folder: Path, interpreter: str) -> None:
    """Adelaide, both sides of the date line, where the halves turn, and 2 ** 30, which stands for unknown elsewhere."""
    angles = [1396900000, -1396900000, 1800000000, -1800000000, 1073741823, 1073741824, -1073741824, -1073741825]
    angles += [0, 1, -1, 65535, 65536, -65536, -65537, 0x5555AAAA, -0x5555AAAA]
    beyond = [1800000001, -1800000001, 2147483647, -2147483648, 1800065536, None]
    stamps = [0, 1, 65535, 65536, 2**30, 2**31, 2**32 - 6, 4294901760]
    late = [2**32 - 5, 2**32 - 1, None]
    rows = [(angle, 900000000, 5, angle / 1e7, angle) for angle in angles]
    rows += [(angle, -900000001, 5, None if angle is None else angle / 1e7, angle) for angle in beyond]
    rows += [(7, 7, stamp, float("nan"), None) for stamp in stamps + late]
    rows += [([1396900000], 7, 5, 0, 0)]
    expected = [[angle, 900000000, 5, angle, angle] for angle in angles]
    expected += [[UNKNOWN, UNKNOWN, 5, UNKNOWN, UNKNOWN] for _ in beyond]
    expected += [[7, 7, stamp, UNKNOWN, UNKNOWN] for stamp in stamps]
    expected += [[7, 7, UNKNOWN_US, UNKNOWN, UNKNOWN] for _ in late]
    expected += [[UNKNOWN, 7, 5, 0, 0]]
    given = json.dumps(rows).replace("NaN", "null")
    command = [str(BIN / interpreter), "drive.py"]
    done = subprocess.run(command, cwd=folder, input=given, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == expected


def test_its_suite_checks_them(folder: Path) -> None:
    """With halves at both ends and beyond them."""
    done = run_suite(folder, "generated/tests")
    assert done.returncode == 0, done.stdout[-3000:]
    facts = (folder / "generated" / "tests" / "source_facts.py").read_text()
    assert "(1800000001, None)" in facts
    assert "(-1800000001, None)" in facts


def test_what_is_said_of_them_is_so(folder: Path) -> None:
    told = codegen(folder, "explain", "m.own").stdout
    assert "-1800000000 to 1800000000 degE7" in told
    assert "what its sensor gives beyond what is plausible is unknown" in told
    assert "counted" not in told


@pytest.mark.parametrize(
    ("file", "old", "new", "said"),
    [
        (
            "ubx.yaml",
            f"stored: degE7, {LIMITS}",
            "stored: degE7",
            "bad-source-driver: a turn is 3600000000 steps of degE7",
        ),
        (
            "ubx.yaml",
            f"stored: degE7, {LIMITS}",
            "stored: degE7, min: -180",
            "hint: min: -180, max: 180 of a longitude",
        ),
        (
            "board.yaml",
            f"stored: degE7, {LIMITS}",
            "stored: degE7",
            "bad-source-driver: a turn is 3600000000 steps of degE7",
        ),
        (
            "ubx.yaml",
            "max: 4294967290",
            "max: 4294967296",
            "max is 4294967296 steps of us, more than the 32 bits of an",
        ),
        (
            "ubx.yaml",
            "min: 0, max: 4294967290",
            "min: -1, max: 2147483648",
            "narrow min and max, or take a coarser unit",
        ),
        ("ubx.yaml", ", max: 4294967290", "", "warning unstated-limits: rx.stamp has no min and max"),
        ("ubx.yaml", ", max: 4294967290", "", "hint: min: 0, max: 4294967294 at the output"),
    ],
)
def test_without_limits_these_are_asked_for(folder: Path, file: str, old: str, new: str, said: str) -> None:
    path = next((folder / "specs").rglob(file))
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    told = codegen(folder, "check").stdout
    path.write_text(text)
    assert said in told
    assert (": error " in told) == ("unstated" not in told), told
