"""The time of one BATTERY_STATUS from values, or from the state of the vehicle, to the frame, and its allocations."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import measure
from figure import Figure, ratio
from measure import Result

COMPARES = """One BATTERY_STATUS frame: the generated codec and the generated rover against C made of mavgen's headers
(cc -O2), against struct.pack and a loop for the CRC in MicroPython, and under CPython against pymavlink. All make the
same frame. By hand, frames leave garbage behind: "nothing to collect" leaves out what that costs."""

PASSES = 10
SHORT, LONG = 1000, 20000  # frames in a pass of MicroPython, and of C


def figures(quick: bool) -> list[Figure]:
    """Let everybody make frames, and compare."""
    with measure.scratch() as folder:
        answers = contestants(folder, 1 if quick else PASSES, *((20, 20) if quick else (SHORT, LONG)))
        first = {name: answer() for name, answer in answers.items()}
        measure.agree({name: answer["shown"] for name, answer in first.items()})
        times = measure.best({name: partial(_ns, answer) for name, answer in answers.items()}, 1 if quick else 10)
    return described(times, first)


def contestants(folder: Path, passes: int, short: int, long: int) -> dict[str, Callable[[], Result]]:
    """Return all that make the frame, ready to run."""
    codec = measure.codec(folder / "codec", "BATTERY_STATUS")
    bytecode = measure.codec(folder / "bytecode", "BATTERY_STATUS", "--bytecode")
    rover = measure.rover(folder / "rover") / "firmware"
    slow_rover = measure.rover(folder / "slow_rover", machine_code=False) / "firmware"
    # The rover's own ids and reading are those that the others have to send.
    has = fields(measure.micropython("frame_state.py", rover, 1, 1)["shown"][0])
    many = (passes, short, *has)
    few = (passes, short // 2, *has)
    fresh = (passes, min(short, 50), *has)
    found: dict[str, Callable[[], Result]] = {
        "state": partial(measure.micropython, "frame_state.py", rover, passes, short),
        "values": partial(measure.micropython, "frame_values.py", codec, *many),
        "bytecode state": partial(measure.micropython, "frame_state.py", slow_rover, passes, short // 2),
        "bytecode values": partial(measure.micropython, "frame_values.py", bytecode, *few),
        "pack": partial(measure.micropython, "frame_pack.py", codec, "loop", "steady", *few),
        "fresh pack": partial(measure.micropython, "frame_pack.py", codec, "loop", "fresh", *fresh),
        "fresh pack, table": partial(measure.micropython, "frame_pack.py", codec, "table", "fresh", *fresh),
        "CPython": partial(measure.cpython, "frame_values.py", codec, *few),
        "pymavlink": partial(measure.cpython, "frame_pymavlink.py", None, "installed", *few),
        "pymavlink, plain": partial(measure.cpython, "frame_pymavlink.py", None, "plain", *few),
    }
    program = measure.c_program("frame", folder)
    if program is not None:
        found["C"] = partial(measure.c_answer, program, passes, long, *has)
    return found


def fields(frame: str) -> tuple[int, ...]:
    """Return the input of the contestants: sender, and values of the fields except for the charge, which counts."""
    from pymavlink.dialects.v20 import common  # noqa: PLC0415

    (message,) = common.MAVLink(None).parse_buffer(bytes.fromhex(frame))
    kinds = (message.id, message.battery_function, message.type)
    values = (message.temperature, message.voltages[0], message.current_battery, message.energy_consumed)
    return (message.get_srcSystem(), message.get_srcComponent(), *kinds, *values, message.battery_remaining)


def _ns(answer: Callable[[], Result]) -> float:
    return float(answer()["ns"])


def described(times: dict[str, float], answers: dict[str, Result]) -> list[Figure]:
    """The figures."""
    in_c = "C, mavgen's headers"
    values, state = "values to frame", "vehicle state to frame"
    pack = "struct.pack and CRC loop, by hand"
    rows: list[tuple[str, str, str, str, str, dict[str, float]]] = [
        ("values_over_c", values, "values", in_c, "C", {"most": 4}),
        ("state_over_c", state, "state", in_c, "C", {"most": 4}),
        ("bytecode_values_over_c", f"{values}, bytecode", "bytecode values", in_c, "C", {}),
        ("bytecode_state_over_c", f"{state}, bytecode", "bytecode state", in_c, "C", {}),
        ("pack_over_values", pack, "pack", values, "values", {"least": 30}),
        ("pack_over_state", pack, "pack", state, "state", {}),
        ("pack_over_bytecode_values", pack, "pack", f"{values}, bytecode", "bytecode values", {}),
        ("fresh_pack_over_values", f"{pack}, nothing to collect", "fresh pack", values, "values", {}),
        (
            "fresh_pack_table_over_values",
            "struct.pack and CRC table, by hand, nothing to collect",
            "fresh pack, table",
            values,
            "values",
            {},
        ),
        ("pymavlink_over_cpython", measure.pymavlink("pack"), "pymavlink", f"{values}, CPython", "CPython", {}),
        (
            "plain_pymavlink_over_cpython",
            "pymavlink's pack with its CRC in Python",
            "pymavlink, plain",
            f"{values}, CPython",
            "CPython",
            {},
        ),
    ]
    found = []
    for key, name, of, other_name, to, target in rows:
        note = "" if to in times else measure.NO_CC
        found.append(Figure(key, name, other_name, ratio(times[of], times.get(to)), note=note, **target))
    for key, name in (("values", values), ("state", state)):
        found.append(measure.allocated(f"{key}_allocated", name, answers[key], most=0))
        bytecode = answers[f"bytecode {key}"]
        found.append(measure.allocated(f"bytecode_{key}_allocated", f"{name}, bytecode", bytecode, most=0))
    found.append(measure.allocated("pack_allocated", pack, answers["pack"], most=None))
    return found


if __name__ == "__main__":
    measure.run(COMPARES, figures)
