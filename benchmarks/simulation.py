"""The speed of codegen sim at full speed, on one core."""

import os
from functools import partial

import measure
from figure import Figure

COMPARES = """The rover of this repository at 400 Hz, in its scenario "nominal", as fast as it can: simulated time over
the processor time, user and system, of everything that codegen sim starts, itself included. The firmware leaves
nothing out: every pass of control and of the links runs, readings are taken and frames are made, and each goes to a
socket. The goal is a day in 10 minutes of one core, 144 times as fast. Of all figures here this one alone depends on
the computer: another one has another speed."""

SECONDS, QUICK_SECONDS = 1200, 20
ROUNDS = 3
GOAL = 86400 / 600


def figures(quick: bool) -> list[Figure]:
    """Let both interpreters run the rover."""
    seconds, rounds = (QUICK_SECONDS, 1) if quick else (SECONDS, ROUNDS)
    runtimes = ("micropython", "cpython")
    taken = measure.best({name: partial(_processor_s, name, seconds) for name in runtimes}, rounds)
    targets = {"micropython": None if quick else GOAL}
    names = {"micropython": "MicroPython, as usual", "cpython": "CPython (--runtime cpython)"}
    return [
        Figure(
            f"rover_{name}",
            f"simulated time of the rover, {names[name]}",
            "processor time of one core",
            seconds / taken[name],
            least=targets.get(name),
        )
        for name in runtimes
    ]


def _processor_s(runtime: str, seconds: int) -> float:
    """The seconds of processor time that a simulation takes."""
    before = os.times()
    command = [measure.tool("codegen"), "sim", "nominal", "--speed", "max", "--duration", f"{seconds} s", "--quiet"]
    measure.said([*command, "--runtime", runtime, "--out", "udp:127.0.0.1:9"], cwd=measure.ROOT)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


if __name__ == "__main__":
    measure.run(COMPARES, figures)
