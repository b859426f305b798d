"""The processor time of `codegen check` and `codegen diff`, against that of mavgen.py.

The goals are 0.5 s of processor time for a project and 0.4 s for two releases of a dialect, of a computer on which
mavgen.py takes 0.17 s for common.xml: here they are multiples of that.
"""

import itertools
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from functools import partial
from pathlib import Path

import measure
from figure import Figure
from measure import Weighed

MAVGEN_S = 0.17
PROJECT_S, RELEASES_S = 0.5, 0.4
GOALS_S = {
    "check": PROJECT_S,
    "check_edited": PROJECT_S,
    "check_table": PROJECT_S,
    "diff": PROJECT_S,
    "diff_releases": RELEASES_S,
}
MEASURES = {
    "check": "codegen check of the rover, nothing changed",
    "check_edited": "codegen check of the rover, one document changed",
    "check_table": "codegen check of the rover, one table of the specification changed",
    "check_first": "codegen check of the rover: first run",
    "diff": "codegen diff of the rover, two revisions",
    "diff_first": "codegen diff of the rover, two revisions: first run",
    "diff_releases": "codegen diff of two releases of common.xml",
    "diff_releases_first": "codegen diff of two releases of common.xml: first run",
}
PARAMETERS = "specs/parameters.yaml"
DOCUMENT = "specs/requirements/FR-00068-battery-status-telemetry.md"

FirstRun = Callable[[Path], AbstractContextManager[None]]


def figures(
    folder: Path, fresh: Iterator[Path], mavgen: Callable[[], Weighed], first_run: FirstRun, rounds: int
) -> list[Figure]:
    """Return the processor time of each command over that of ``mavgen``; ``first_run`` is a cache that is empty."""
    project = _project(folder / "reviewed")
    check = [measure.tool("codegen"), "check"]
    diff = [measure.tool("codegen"), "diff", "--fail-on", "never", "--allow-errors"]
    revisions, releases = [*diff, "HEAD~1", "HEAD"], [*diff, f"{_older_release()}:common", "pymavlink:common"]

    checked, compared, released = (
        measure.once(rounds)(partial(measure.weighed, command, project)) for command in (check, revisions, releases)
    )

    def first(run: Callable[[], Weighed]) -> Weighed:
        with first_run(next(fresh)):
            return run()

    def edited() -> Weighed:
        with (project / DOCUMENT).open("a", encoding="utf-8") as file:
            file.write("\nMore is said here.\n")
        return measure.weighed(check, project)

    steps = itertools.count(1)

    def table() -> Weighed:
        path = project / PARAMETERS
        text = path.read_text(encoding="utf-8")
        if "doc: " not in text:
            raise SystemExit(f"{PARAMETERS} describes nothing")
        path.write_text(text.replace("doc: ", f"doc: Step {next(steps)}. ", 1), encoding="utf-8")
        found = measure.weighed(check, project)
        path.write_text(text, encoding="utf-8")
        return found

    contestants: dict[str, Callable[[], Weighed]] = {
        "check": checked,
        "check_edited": edited,
        "check_table": table,
        "check_first": lambda: first(checked),
        "diff": compared,
        "diff_first": lambda: first(compared),
        "diff_releases": released,
        "diff_releases_first": lambda: first(released),
        "mavgen": mavgen,
    }
    if rounds > 1:
        for command in (check, revisions, releases):  # what is measured below has been run before
            measure.weighed(command, project)
    times = measure.best({name: _processor(run) for name, run in contestants.items()}, rounds)
    return [
        Figure(
            f"{key}_over_mavgen",
            title,
            "mavgen.py on common.xml, processor time",
            times[key] / times["mavgen"],
            most=round(GOALS_S[key] / MAVGEN_S, 1) if key in GOALS_S else None,
        )
        for key, title in MEASURES.items()
    ]


def _processor(run: Callable[[], Weighed]) -> Callable[[], float]:
    return lambda: run().processor


def _project(folder: Path) -> Path:
    """Make a repository of the rover with its documents and tests, and in a second commit another number and text."""
    measure.rover_specs(folder)
    shutil.copytree(measure.ROOT / "tests", folder / "tests", ignore=shutil.ignore_patterns("__pycache__"))
    _git(folder, "init", "--quiet")
    _commit(folder)
    for name, old, new in (
        ("specs/board.yaml", "doc: A second", "doc: Another"),
        (DOCUMENT, "| BATTERY_STATUS telemetry", "| BATTERY_STATUS"),
    ):
        text = (folder / name).read_text(encoding="utf-8")
        if old not in text:
            raise SystemExit(f"{name} has no {old!r} to change")
        (folder / name).write_text(text.replace(old, new, 1), encoding="utf-8")
    _commit(folder)
    return folder


def _commit(folder: Path) -> None:
    _git(folder, "add", "--all")
    _git(folder, "-c", "user.name=benchmark", "-c", "user.email=benchmark@localhost", "commit", "--quiet", "-m", "step")


def _git(folder: Path, *arguments: str) -> None:
    subprocess.run(["git", "-C", str(folder), *arguments], check=True)  # noqa: S603, S607


def _older_release() -> Path:
    """Return the path of the older pymavlink that `codegen diff` is tested with."""
    found = sorted((Path(sys.prefix) / "releases").glob("pymavlink-*.whl"))
    if not found:
        raise SystemExit("the older pymavlink is missing: make .venv/.releases fetches it")
    return found[0]
