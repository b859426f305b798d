"""Making, sending and receiving frames allocates nothing on a board, in machine code and in plain Python."""

import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pymavlink_oracle as oracle
import pytest
from firmware_runs import CODEC, FIRMWARE, MOCKS, Exercise, tool

ROUNDS = 600
SENT = ROUNDS + 1 + ROUNDS  # with the heap locked; once before it counts; counted


def live_names(description: dict[str, Any]) -> list[str]:
    """All fields that can be live."""
    return [name for name, (code, _, _) in oracle.layout(description).items() if code in "BHIbhi"]


def pieces() -> list[str]:
    """Return possible pieces: frames whole and cut, several at once, of unknown messages, damaged ones, garbage."""
    known = oracle.raw_frame(0, bytes(range(1, 10)), extra=50)
    known_1 = oracle.raw_frame_1(0, bytes(range(1, 10)), extra=50)
    unknown = oracle.raw_frame(70000, bytes(range(200)), extra=3)
    signed = oracle.raw_frame(1, b"\x11" * 31, extra=124, flags=1, tail=b"\xfd" * 13)
    damaged = oracle.raw_frame(0, bytes(range(1, 10)), extra=51)
    flags = oracle.raw_frame(0, bytes(range(1, 10)), extra=50, flags=2)
    stream = known + known_1 + unknown + b"\xfd\xfe\x00" * 20 + signed + damaged + flags + bytes(300) + known * 100
    cut = [stream[at : at + 7] for at in range(0, len(stream), 7)]
    return [piece.hex() for piece in [stream, *cut]]


@pytest.fixture(params=["viper", "plain"])
def folders(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[Path, ...]:
    """Return the folders to import from; for the plain form without the other, as on a port without machine code."""
    if request.param == "viper":
        return CODEC, FIRMWARE, MOCKS
    shutil.copytree(CODEC, tmp_path / "codec", ignore=shutil.ignore_patterns("frames_viper.py", "__pycache__"))
    return tmp_path / "codec", FIRMWARE, MOCKS


def test_nothing_is_allocated(folders: tuple[Path, ...]) -> None:
    """Every truncated length, live values over all 32 bits, both versions; then whatever may arrive.

    The heap is locked from the first frame on. And all that was ever allocated is counted, for a function with many
    variables takes memory where there is some and says nothing.
    """
    descriptions = [oracle.describe(name) for name in oracle.NAMES]
    live = [live_names(description) for description in descriptions]
    # A byte array has an element for each place: too many would leave no room for short frames.
    live = [names[:12] for names in live]
    arguments = {"classes": descriptions, "live": live, "rounds": ROUNDS, "pieces": pieces()}
    answer = Exercise("micropython")("allocation", folders, **arguments)
    assert answer["is_plain"] == [folders[0] != CODEC] * 3
    assert answer["control"] > 0
    versions = [(version, name) for name in oracle.NAMES for version in (1, 2) if version == 2 or is_low(name)]
    assert [(version, name) for version, name, *_ in answer["sent"]] == versions
    for version, name, lengths, counted in answer["sent"]:
        description = oracle.describe(name)
        if version == 1:
            assert lengths == [8 + description["BASE_LENGTH"]]
        else:
            assert lengths[-1] == 12 + description["LENGTH"]
        assert counted == [SENT % 256, 0, SENT, SENT, 0], (version, name)
    assert answer["taken"] == [2 * (2 + 1 + 100), 0]


def is_low(name: str) -> bool:
    return oracle.BY_NAME[name].id <= 255


def test_every_truncated_length_is_sent_without_allocation(folders: tuple[Path, ...]) -> None:
    """Without live values the random payloads end where the test wants them to: no length is left out."""
    descriptions = [oracle.describe(name) for name in oracle.NAMES]
    live: list[list[str]] = [[] for _ in descriptions]
    arguments = {"classes": descriptions, "live": live, "rounds": ROUNDS, "pieces": pieces()}
    answer = Exercise("micropython")("allocation", folders, **arguments)
    for version, name, lengths, counted in answer["sent"]:
        length = oracle.describe(name)["LENGTH"]
        if version == 2:
            assert lengths == list(range(12 + 1, 12 + length + 1))
        assert counted == [SENT % 256, 0, SENT, SENT, 0], (version, name)


@pytest.mark.parametrize(
    ("module", "allowed"),
    [
        ("frames_plain", set()),
        ("sender", {"__init__", "<listcomp>"}),
        ("receiver", {"__init__", "<dictcomp>"}),
    ],
)
def test_functions_are_small_enough_for_the_stack(module: str, allowed: set[str]) -> None:
    """MicroPython keeps the variables of a function on its stack up to 11 words, and puts those of others on the heap.

    This names the function that is too large, which the count above cannot. What a link does once may be larger.
    """
    command = [tool("micropython"), "-v", "-v", str(CODEC / f"{module}.py")]
    environment = {"MICROPYPATH": str(CODEC)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    blocks = re.findall(r"File \S+/(\w+)\.py, code block '([^']+)'.*?\(N_STATE (\d+)\)", done.stdout, re.DOTALL)
    found = {function: int(words) for file, function, words in blocks if file == module and function != "<module>"}
    assert len(found) > 5
    assert {function for function, words in found.items() if words > 11} - allowed == set()
