"""The time and memory of codegen, process against process: against mavgen.py and against Python itself."""

import itertools
import os
import re
import shutil
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from functools import partial
from pathlib import Path

import measure
import reviewing
from figure import Figure
from measure import Weighed
from reviewing import FirstRun

COMPARES = """codegen as a process of its own, from its start to its end, against mavgen.py of pymavlink (Python3, wire
protocol 2.0), which checks the XML against its schema unless it says "no validation". Every run writes into a folder of
its own that is new, except where it says otherwise, on a file system in memory: how long a disk takes to make a file
depends on what happened to it before. mavgen.py writes one file, codegen a dozen: "on disk" is shown as well.
Both run as pip installs them, compiled. codegen keeps what it finds out in a cache (CONTRIBUTING.md), which here is a
folder of its own: it is warm, as after any earlier run, except in the rows that say "first run".
"Processor time" is that of user and system, children included: the goals of codegen check and codegen diff are 0.5 s
and, for two releases, 0.4 s of a computer on which mavgen.py takes 0.17 s for common.xml.
Memory is the most that a process had at once. What one more message takes is measured with made-up dialects: 1
everywhere is a straight line."""

SIZES = (50, 100, 200, 400, 800)
QUICK_SIZES = (10, 20, 30)
DIALECTS = ("common", "all")
ROUNDS = 15
TARGETS = {"unchanged": 0.3, "edited": 1.5}  # builds of the rover, against mavgen
FIELDS = (
    '<field type="uint32_t" name="time_boot_ms" units="ms">Time since the start.</field>',
    '<field type="float[3]" name="position" units="m">Where it is.</field>',
    '<field type="int16_t" name="temperature" units="cdegC" invalid="INT16_MAX">How warm it is.</field>',
    '<field type="uint8_t" name="state" enum="STATE">What it does.</field>',
    '<field type="char[16]" name="name">What it is called.</field>',
    '<field type="uint64_t" name="serial">Which one it is.</field>',
)


def figures(quick: bool) -> list[Figure]:
    """Run everything, and compare."""
    rounds = 1 if quick else ROUNDS
    with measure.scratch(in_memory=True) as folder:
        os.environ["CODEGEN_CACHE"] = str(folder / "cache")
        _compile()
        fresh = _numbered(folder)
        mavgen = measure.once(rounds)(partial(_mavgen, fresh, "common"))
        first_run = nullcontext if quick else _first_run  # that of a codec shows that there are such
        return [
            *_codecs(fresh, mavgen, rounds, quick),
            *_codec_on_disk(rounds),
            *_rover(folder, fresh, mavgen, first_run, rounds),
            *reviewing.figures(folder, fresh, mavgen, first_run, rounds),
            *_starts(folder, rounds * 2),
            *_growth(folder, fresh, rounds, quick),
        ]


def _compile() -> None:
    """Compile codegen, as pip does with the packages that it installs: a checkout may never have been compiled."""
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    measure.said([sys.executable, "-m", "compileall", "-q", str(measure.ROOT / "codegen")])


@contextmanager
def _first_run(folder: Path) -> Iterator[None]:
    """Run without anything that an earlier run found out."""
    warm = os.environ["CODEGEN_CACHE"]
    os.environ["CODEGEN_CACHE"] = str(folder / "cold")
    try:
        yield
    finally:
        shutil.rmtree(folder / "cold", ignore_errors=True)
        os.environ["CODEGEN_CACHE"] = warm


def _numbered(folder: Path) -> Iterator[Path]:
    """Folders that are new."""
    for number in itertools.count():
        path = folder / f"out{number}"
        path.mkdir()
        yield path


def _codec(fresh: Iterator[Path], dialect: str, *, is_kept: bool = False) -> Weighed:
    out = next(fresh)
    command = [measure.tool("codegen"), "codec", "--dialect", dialect, "--messages", "all", "--out", str(out / "codec")]
    return _written(command, out, is_kept=is_kept)


def _first_codec(fresh: Iterator[Path], dialect: str) -> Weighed:
    with _first_run(next(fresh)):
        return _codec(fresh, dialect)


def _mavgen(fresh: Iterator[Path], dialect: str, *options: str, is_kept: bool = False) -> Weighed:
    out = next(fresh)
    command = [measure.tool("mavgen.py"), "--lang", "Python3", "--wire-protocol", "2.0", *options]
    return _written([*command, "-o", str(out / f"{dialect}.py"), measure.dialect(dialect)], out, is_kept=is_kept)


def _written(command: list[str], out: Path, *, is_kept: bool) -> Weighed:
    found = measure.weighed(command, out)
    if not any(out.iterdir()):
        raise SystemExit(f"{command[0]} wrote nothing")
    if not is_kept:
        shutil.rmtree(out)
    return found


def _best(contestants: dict[str, Callable[[], Weighed]], rounds: int) -> tuple[dict[str, float], dict[str, int]]:
    """The shortest time and the smallest peak of memory of each."""
    memory: dict[str, int] = {}

    def seconds(name: str) -> float:
        found = contestants[name]()
        memory[name] = min(found.memory, memory.get(name, found.memory))
        return found.seconds

    return measure.best({name: partial(seconds, name) for name in contestants}, rounds), memory


def _codecs(fresh: Iterator[Path], mavgen: Callable[[], Weighed], rounds: int, quick: bool) -> list[Figure]:
    """All messages of a dialect, by both."""
    found = []
    for dialect in DIALECTS[: 1 if quick else None]:
        contestants = {
            "codegen": partial(_codec, fresh, dialect),
            "first codegen": partial(_first_codec, fresh, dialect),
            "mavgen": mavgen if dialect == "common" else partial(_mavgen, fresh, dialect),
            "hasty mavgen": partial(_mavgen, fresh, dialect, "--no-validate"),
        }
        times, memory = _best(contestants, rounds)
        what = f"codegen codec, all messages of {dialect}.xml"
        for key, other, title in (
            ("mavgen", "mavgen", "mavgen.py"),
            ("hasty", "hasty mavgen", "mavgen.py, no validation"),
        ):
            most = 0.9 if (dialect, key) == ("common", "mavgen") else None
            time = times["codegen"] / times[other]
            found.append(Figure(f"codec_{dialect}_over_{key}", what, title, time, most=most))
            first = times["first codegen"] / times[other]
            found.append(Figure(f"codec_{dialect}_first_over_{key}", f"{what}: first run", title, first))
            peak = memory["codegen"] / memory[other]
            found.append(Figure(f"codec_{dialect}_memory_over_{key}", f"{what}: memory", title, peak))
    return found


def _codec_on_disk(rounds: int) -> list[Figure]:
    """The same on disk. Nothing is deleted meanwhile: ext4 for one makes files slowly after it has deleted many."""
    with measure.scratch() as folder:
        fresh = _numbered(folder)
        contestants = {
            "codegen": partial(_codec, fresh, "common", is_kept=True),
            "mavgen": partial(_mavgen, fresh, "common", is_kept=True),
        }
        times, _ = _best(contestants, rounds)
    what = "codegen codec, all messages of common.xml: on disk"
    return [Figure("codec_common_on_disk_over_mavgen", what, "mavgen.py", times["codegen"] / times["mavgen"], most=0.9)]


def _rover(
    folder: Path, fresh: Iterator[Path], mavgen: Callable[[], Weighed], first_run: FirstRun, rounds: int
) -> list[Figure]:
    """The rover from nothing, without a change, and after a change of one number."""
    first = measure.rover_specs(folder / "rover")
    build = [measure.tool("codegen"), "build"]
    measure.said(build, cwd=first)

    @measure.once(rounds)
    def cold() -> Weighed:
        path = measure.rover_specs(next(fresh))
        found = measure.weighed(build, path)
        shutil.rmtree(path)
        return found

    def first_build() -> Weighed:
        with first_run(next(fresh)):
            return cold()

    def first_edit() -> Weighed:
        with first_run(next(fresh)):
            return edited()

    def unchanged() -> Weighed:
        return _expect(measure.weighed(build, first), written=False)

    @measure.once(rounds)
    def edited() -> Weighed:
        _edit(first / "specs" / "parameters.yaml")
        return _expect(measure.weighed(build, first), written=True)

    contestants = {
        "first": first_build,
        "cold": cold,
        "unchanged": unchanged,
        "edited": edited,
        "edited_first": first_edit,
        "mavgen": mavgen,
    }
    times, _ = _best(contestants, rounds)
    what = {
        "first": "codegen build of the rover, nothing there yet: first run",
        "cold": "codegen build of the rover, nothing there yet",
        "unchanged": "codegen build of the rover, nothing to do",
        "edited": "codegen build of the rover, one number changed",
        "edited_first": "codegen build of the rover, one number changed: first run",
    }
    return [
        Figure(
            f"build_{key}_over_mavgen",
            title,
            "mavgen.py on common.xml",
            times[key] / times["mavgen"],
            most=TARGETS.get(key),
        )
        for key, title in what.items()
    ]


def _expect(found: Weighed, *, written: bool) -> Weighed:
    is_written = re.search(r"\d+ files? written", found.said) is not None
    is_unchanged = re.search(r"up to date: \d+ files?", found.said) is not None
    if is_written is not written or is_unchanged is written:
        raise SystemExit(f"codegen build did not do what was to be measured: {found.said}")
    return found


def _edit(path: Path) -> None:
    """Add 1 to the first whole number that is a maximum: to a number that no run has seen before."""
    text = path.read_text(encoding="utf-8")
    changed = re.sub(r"(?m)^( +max: )(\d+)$", lambda found: f"{found[1]}{int(found[2]) + 1}", text, count=1)
    if changed == text:
        raise SystemExit(f"{path.name} has no number to change")
    path.write_text(changed, encoding="utf-8")


def _starts(folder: Path, rounds: int) -> list[Figure]:
    """Return the cost of a command that does nothing."""
    commands = {
        "version": [measure.tool("codegen"), "--version"],
        "help": [measure.tool("codegen"), "--help"],
        "python": [sys.executable, "-c", "pass"],
    }
    times, _ = _best({name: partial(measure.weighed, command, folder) for name, command in commands.items()}, rounds)
    return [
        Figure(
            "version_over_python", "codegen --version", "python -c pass", times["version"] / times["python"], most=3
        ),
        Figure("help_over_python", "codegen --help", "python -c pass", times["help"] / times["python"], most=2),
    ]


def _growth(folder: Path, fresh: Iterator[Path], rounds: int, quick: bool) -> list[Figure]:
    """Dialects of more and more messages: what one more message takes, against what it takes in small ones."""
    sizes = QUICK_SIZES if quick else SIZES
    for size in sizes:
        (folder / f"d{size}.xml").write_text(synthetic(size), encoding="utf-8")
    contestants = {str(size): partial(_codec, fresh, str(folder / f"d{size}.xml")) for size in sizes}
    times, _ = _best(contestants, rounds)
    slopes = {
        (few, many): (times[str(many)] - times[str(few)]) / (many - few) for few, many in itertools.pairwise(sizes)
    }
    middle = sizes[len(sizes) // 2]
    first = (times[str(middle)] - times[str(sizes[0])]) / (middle - sizes[0])
    found = []
    for (few, many), slope in slopes.items():
        what = f"codegen codec, one more message between {few} and {many}"
        found.append(Figure(f"slope_{few}_{many}", what, f"one more between {sizes[0]} and {middle}", slope / first))
        found.append(Figure(f"time_{few}_{many}", what, "a time of this computer, no claim", slope * 1e3, "ms"))
    return found


def synthetic(size: int) -> str:
    """A dialect with so many messages of six fields."""
    messages = "".join(
        f'<message id="{20000 + number}" name="SYNTHETIC_{number}"><description>Number {number}.</description>'
        + "".join(FIELDS)
        + "</message>\n"
        for number in range(size)
    )
    entries = "".join(f'<entry value="{value}" name="STATE_{value}"><description/></entry>' for value in range(4))
    enums = f'<enums><enum name="STATE">{entries}</enum></enums>'
    return f'<?xml version="1.0"?>\n<mavlink>{enums}\n<messages>\n{messages}</messages></mavlink>\n'


if __name__ == "__main__":
    measure.run(COMPARES, figures)
