"""Texts of the state arrive as they were set, cut where nobody sees half a character; what is too long is told early.

The cuts are worked out by hand: Ä has 2 bytes in UTF-8, € has 3, the boat 4.
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build

HERE = Path(__file__).resolve().parent
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
found = []


def frames(name, port=None, lens=None):
    state.boat.name, state.boat.port, state.camera[1].lens = name, port, lens
    named = telemetry.encode_named(link, state)
    found.append([
        bytes(telemetry.encode_texts(link, state)).hex(),
        None if named is None else bytes(telemetry.encode_named(link, state)).hex(),
        bytes(telemetry.encode_camera(link, state, 1)).hex(),
        state.boat.name,
        state.boat.port,
    ])


for about in json.loads(open("texts.json", encoding="utf-8").read()):
    frames(*about)
state.boat.notice = "Ahoy there"
known = bytes(telemetry.encode_texts(link, state)).hex()
mock_time.advance_us(2001000)
found.append([known, bytes(telemetry.encode_texts(link, state)).hex()])
print(json.dumps(found))
"""
BOAT = "\N{SPEEDBOAT}"
SET = [
    ["Ärger", "Bern", "Tele"],
    [f"abcdefg{BOAT}", "Ä€Ä", f"a€{BOAT}"],
    [f"{BOAT * 3}xyz€", "aÄbc", "Ä€"],
    ["ab€", "€", f"{BOAT}b"],
    ["ab\0c", "", "a\0b"],
    ["", None, ""],
    [None, None, None],
    ["€" * 300, "0123456789", "0123456"],
]


@pytest.fixture(scope="module")
def texts(tmp_path_factory):
    """The folder in which the project is built."""
    folder = tmp_path_factory.mktemp("texts")
    subprocess.run(["cp", "-r", str(HERE / "texts" / "specs"), str(folder)], check=True)
    build(folder)
    (folder / "send.py").write_text(SCRIPT)
    (folder / "texts.json").write_text(json.dumps(SET, ensure_ascii=False), encoding="utf-8")
    return folder


@pytest.fixture(scope="module", params=["micropython", "micropython32", "python"])
def frames(request, texts):
    """Return each interpreter's frames in MAVLink 2, without their heads and checksums, and the texts that it keeps."""
    done = subprocess.run([str(BIN / request.param), "send.py"], cwd=texts, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def payload(frame, length):
    """The payload of a MAVLink 2 frame, with the zeros that were left out."""
    return bytes.fromhex(frame)[10:-2].ljust(length, b"\0")


def fields(frame):
    """The texts of TEXTS by their places, without the NULs behind them."""
    data = payload(frame, 142)
    ends = {"bytes": (2, 12), "whole": (14, 16), "wider": (30, 25), "short": (55, 8), "tiny": (63, 3)}
    ends |= {"letter": (66, 1), "port": (67, 7), "code": (74, 2), "fixed": (126, 10), "fixed_bytes": (136, 6)}
    return {name: data[at : at + size].rstrip(b"\0").decode() for name, (at, size) in ends.items()}


def test_a_text_is_cut_between_characters(frames):
    """Each field has as many whole characters as it holds."""
    first, second, third, fourth = (fields(row[0]) for row in frames[:4])
    assert {first[name] for name in ("bytes", "whole", "wider", "short")} == {"Ärger"}
    assert (first["tiny"], first["letter"], first["code"]) == ("Är", "", "Be")
    assert (first["fixed"], first["fixed_bytes"]) == (f"Ä€{BOAT}", "Ä€")
    # 7 letters and 4 bytes: 8 bytes would end in the first of these.
    assert (second["short"], second["whole"], second["letter"]) == ("abcdefg", f"abcdefg{BOAT}", "a")
    assert (second["port"], second["code"]) == ("Ä€Ä", "Ä")
    # 3 * 4 + 3 + 3 bytes: of 16, the last one would be the first third of a character.
    assert (third["whole"], third["wider"]) == (f"{BOAT * 3}xyz", f"{BOAT * 3}xyz")
    assert (third["bytes"], third["short"], third["tiny"]) == (BOAT * 3, BOAT * 2, "")
    assert (third["port"], third["code"]) == ("aÄbc", "a")
    assert (fourth["tiny"], fourth["port"], fourth["code"]) == ("ab", "€", "")
    assert frames[7][3:] == ["€" * 5, "0123456"]


def test_a_nul_ends_a_text(frames):
    """The bytes behind it would not be read."""
    assert fields(frames[4][0])["whole"] == "ab"
    assert frames[4][3] == "ab"


def test_empty_is_known_and_none_is_not(frames):
    """A field with a sentinel is empty for both; without one, the message is withheld while the text is unknown."""
    empty, unknown = frames[5], frames[6]
    assert (payload(empty[0], 142)[0], payload(unknown[0], 142)[0]) == (1, 0)  # the flag: whether there is a name
    assert fields(unknown[0])["whole"] == fields(empty[0])["whole"] == ""
    assert (empty[1] is None, unknown[1] is None) == (False, True)
    assert (empty[3], unknown[3]) == ("", None)
    assert unknown[4] == "Zürich"
    assert fields(unknown[0])["port"] == "Zürich"


def test_a_text_that_is_too_old_is_not_sent(frames):
    """Nothing of it is left in the message."""
    known, forgotten = (payload(frame, 142)[76:126] for frame in frames[-1])
    assert known == b"Ahoy there".ljust(50, b"\0")
    assert forgotten == bytes(50)


def test_the_receiver_tells_the_texts(texts, frames):
    """A text cut for the wire is read as the rest of it; not ASCII all the same."""
    code = """
import sys
sys.path[:0] = ["generated/receiver"]
from cameras import Cameras
cameras = Cameras()
for frame in sys.argv[1:]:
    cameras.feed(bytes.fromhex(frame))
[view] = cameras.views()
print(ascii([view.lens, view.model, view.info.maker]))
"""
    command = [sys.executable, "-c", code, frames[1][2]]
    done = subprocess.run(command, cwd=texts, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == ascii(["a€", None, "東京"])
