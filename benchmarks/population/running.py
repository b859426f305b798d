"""Runs the firmware of a project on three interpreters with all cases."""
# ruff: noqa: S603 - it starts the interpreters of this environment

import json
import os
import shutil
import struct
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from population.answer import Answer
from population.cases import Case
from population.settings import STORED, Setting

BIN = Path(sys.executable).parent
DRIVER = Path(__file__).with_name("driver.py")
FORMS = {"machine code": "micropython", "plain Python": "micropython", "32 bits": "micropython32"}
"""Each form of the firmware with its interpreter; only the first has the modules of machine code."""


def write_cases(folder: Path, tables: Mapping[str, Sequence[Answer]], cases: Mapping[str, Sequence[Case]]) -> None:
    """Write what driver.py reads."""
    plan: list[Any] = []
    data = bytearray()
    for name, answers in tables.items():
        plan.append([name.lower(), [_target(name, each) for each in answers], len(cases[name])])
        for case in cases[name]:
            data += struct.pack("<II", case.before_us, case.age_us)
            for setting in case.settings:
                data += _packed(setting)
    (folder / "plan.json").write_text(json.dumps(plan))
    (folder / "values.bin").write_bytes(data)


def _target(message: str, found: Answer) -> list[Any]:
    """The component, the attribute for people, the one for what is kept, and the booleans of flags."""
    if found.kind == "clock":
        return ["clock", "", f"{found.name}_us", [], 0]
    left = found.listed - found.at if found.listed else 0  # of the list, with this one
    return [message.lower(), found.name, found.attribute, [each for each in found.flags if each[0]], left]


def _packed(setting: Setting) -> bytes:
    """Return a setting for driver.py: kind and, times 8, which of both attributes; then the value."""
    if not setting.how:
        return b"\0"
    stored, value = 8 if setting.how == STORED else 0, setting.value
    if value is None:
        return bytes([1 | stored])
    if isinstance(value, str):
        return struct.pack("<BH", 5, len(value.encode())) + value.encode()
    if isinstance(value, float):
        return struct.pack("<Bd", 2 | stored, value)
    is_signed = value < 1 << 63
    return struct.pack("<Bq" if is_signed else "<BQ", (3 if is_signed else 4) | stored, value)


def run(folder: Path, form: str) -> list[str]:
    """Return the frames that the firmware sends, case by case."""
    firmware = folder / "generated" / "firmware"
    if form != "machine code":
        plain = folder / "plain"
        shutil.copytree(firmware, plain, ignore=shutil.ignore_patterns("*_viper.py"), dirs_exist_ok=True)
        firmware = plain
    command = [str(BIN / FORMS[form]), "-X", "heapsize=64m", str(DRIVER)]
    done = subprocess.run(
        [*command, str(folder / "plan.json"), str(folder / "values.bin")],
        env=os.environ | {"MICROPYPATH": f"{firmware}:{folder / 'generated' / 'mocks'}"},
        capture_output=True,
        text=True,
        check=False,
        timeout=900,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    return done.stdout.split("\n")[:-1]
