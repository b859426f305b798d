# ruff: noqa: T201  what is printed is the answer
"""Runs workloads for benchmarks/cost.py, which counts their instructions under valgrind. To be imported first.

Each workload is a function that does something a number of times. It runs FEW times, then MANY times, so that the
difference is what MANY - FEW rounds take, and nothing of the start. Before the first run and after each of them the
environment is written to, which valgrind notices (--dump-before=setenv).

MicroPython remembers where it found names, in a small table by their numbers: two names that share a place there cost a
search each time, and one more name anywhere before them gives all others other numbers. The script's argument is how
many names to begin with, so that cost.py can try several such layouts and take what is no accident.

The clock stands still: under valgrind seconds pass where a board needs milliseconds, and quantities would grow old. Its
ticks are functions in C like those of the board, so that asking for the time takes what it takes anyway.
"""

import gc
import os
import sys

import still_clock

sys.modules["time"] = still_clock


class Names:
    """Has as many names as are asked for."""


for _number in range(int(sys.argv[1])):
    setattr(Names, f"name_{_number}", None)

FEW, MANY = 20, 120


def unheard(*_words):
    """Take what the firmware would print: what is printed here are the counts."""


def nothing(rounds):
    """Do nothing: what the loop itself takes."""
    for _ in range(rounds):
        pass


def count(**workloads):
    """Run the workloads; print the name of each, and after it the number that it returns, if any."""
    gc.collect()
    gc.disable()
    _run("nothing", nothing)
    for name in sorted(workloads):
        _run(name, workloads[name])


def _run(name, workload):
    print(name, workload(1) or "")
    _mark()
    workload(FEW)
    _mark()
    workload(MANY)
    _mark()


def _mark():
    os.putenv("MARK", "")
