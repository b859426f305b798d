"""The time to receive twenty BATTERY_STATUS frames that arrive at once, and its allocations."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import measure
from figure import Figure, ratio
from measure import Result

COMPARES = """Receiving 20 BATTERY_STATUS frames: the generated codec against C made of mavgen's headers (cc -O2, one
call for each byte, decode), against a state machine in MicroPython's bytecode, and under CPython against pymavlink. All
find the same values. The ratios are of frames in a second: above 1 is faster."""

FRAMES = 20


def figures(quick: bool) -> list[Figure]:
    """Let everybody receive the same frames, and compare."""
    with measure.scratch() as folder:
        answers = contestants(folder, 1 if quick else 10, 1 if quick else 50)
        first = {name: answer() for name, answer in answers.items()}
        measure.agree({name: answer["shown"] for name, answer in first.items()})
        if len(first["objects"]["shown"]) != FRAMES:
            raise SystemExit("not every frame was received")
        times = measure.best({name: partial(_ns, answer) for name, answer in answers.items()}, 1 if quick else 10)
    return described(times, first)


def contestants(folder: Path, passes: int, count: int) -> dict[str, Callable[[], Result]]:
    """Return all that receive, ready to run."""
    codec = measure.codec(folder / "codec", "BATTERY_STATUS")
    bytecode = measure.codec(folder / "bytecode", "BATTERY_STATUS", "--bytecode")
    frames = folder / "frames"
    frames.write_bytes(written_frames())
    many = (frames, passes, count)
    few = (frames, passes, max(1, count // 10))
    found: dict[str, Callable[[], Result]] = {
        "objects": partial(measure.micropython, "parse_codec.py", codec, "objects", *many),
        "classes": partial(measure.micropython, "parse_codec.py", codec, "classes", *many),
        "bytecode": partial(measure.micropython, "parse_codec.py", bytecode, "objects", *few),
        "machine": partial(measure.micropython, "parse_machine.py", codec, *few),
        "CPython": partial(measure.cpython, "parse_codec.py", codec, "objects", *few),
        "pymavlink": partial(measure.cpython, "parse_pymavlink.py", None, "installed", *few),
        "pymavlink, plain": partial(measure.cpython, "parse_pymavlink.py", None, "plain", *few),
    }
    program = measure.c_program("parse", folder)
    if program is not None:
        found["C"] = partial(measure.c_answer, program, frames, passes, 20 * count)
    return found


def written_frames() -> bytes:
    """The frames, made by pymavlink: values that differ, and nothing in the extensions, as of the rover."""
    from pymavlink.dialects.v20 import common  # noqa: PLC0415

    link = common.MAVLink(None, srcSystem=1, srcComponent=1)
    data = b""
    for number in range(FRAMES):
        voltages = [9549 + number, *[65535] * 9]
        message = link.battery_status_encode(
            0, 1, 1, 2345 - 200 * number, voltages, 1520 - 100 * number, 1234 + number, -number, 67
        )
        data += bytes(message.pack(link))
        link.seq = (link.seq + 1) & 0xFF
    return data


def _ns(answer: Callable[[], Result]) -> float:
    return float(answer()["ns"])


def described(times: dict[str, float], answers: dict[str, Result]) -> list[Figure]:
    """The figures."""
    objects = "receiving into an object"
    faster = [
        ("objects_over_c", objects, "objects", "C, mavgen's headers", "C", 0.2),
        ("classes_over_c", "receiving new objects", "classes", "C, mavgen's headers", "C", None),
        ("bytecode_over_c", f"{objects}, bytecode", "bytecode", "C, mavgen's headers", "C", None),
        ("objects_over_machine", objects, "objects", "state machine, by hand", "machine", None),
        ("bytecode_over_machine", f"{objects}, bytecode", "bytecode", "state machine, by hand", "machine", None),
        (
            "cpython_over_pymavlink",
            f"{objects}, CPython",
            "CPython",
            measure.pymavlink("parse_buffer"),
            "pymavlink",
            None,
        ),
        (
            "cpython_over_plain_pymavlink",
            f"{objects}, CPython",
            "CPython",
            "pymavlink's parse_buffer with its CRC in Python",
            "pymavlink, plain",
            None,
        ),
    ]
    found = []
    for key, name, mine, other_name, other, least in faster:
        speed = ratio(times.get(other), times[mine])
        note = "" if other in times else measure.NO_CC
        found.append(Figure(key, name, other_name, speed, least=least, note=note))
    for key, name, mine, most in (
        ("objects_allocated", objects, "objects", 0),
        ("bytecode_allocated", f"{objects}, bytecode", "bytecode", 0),
        ("classes_allocated", "receiving new objects", "classes", None),
        ("machine_allocated", "state machine, by hand", "machine", None),
    ):
        found.append(measure.allocated(key, name, answers[mine], most, FRAMES))
    return found


if __name__ == "__main__":
    measure.run(COMPARES, figures)
