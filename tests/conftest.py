"""Settings of the whole suite, and a project that is built once for many tests."""

import gc
import os
import pickle
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import uuid
from collections.abc import Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings
from hypothesis.internal.conjecture import providers
from hypothesis.internal.entropy import deterministic_PRNG

from codegen.tool.cache import cache_folder

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "benchmarks"))  # where a generated program is put together

# Thousands of small projects are written and removed: in memory, where there is plenty, no disk is waited for.
IN_MEMORY, PLENTY = Path("/dev/shm"), 8_000_000_000  # noqa: S108  where Linux keeps a file system in memory
if "TMPDIR" not in os.environ and os.access(IN_MEMORY, os.W_OK) and shutil.disk_usage(IN_MEMORY).free > PLENTY:
    os.environ["TMPDIR"] = tempfile.tempdir = str(IN_MEMORY)

# Commands that tests start share a cache that is new with each run: what an earlier run kept is no evidence. This
# process has none, since tests exchange parts of codegen here. Tests of the cache have folders of their own.
os.environ["CODEGEN_CACHE"] = "off"
assert cache_folder() is None  # which is asked once
CACHE = Path(tempfile.gettempdir()) / f"codegen-tests-{os.environ.setdefault('CODEGEN_TEST_RUN', uuid.uuid4().hex)}"
os.environ["CODEGEN_CACHE"] = str(CACHE)

# No timed assertions: a busy machine is no fault of the code, and a failure must be the same for everybody.
settings.register_profile("codegen", deadline=None, derandomize=True, database=None)
settings.load_profile("codegen")

# Hypothesis tries numbers that stand in the modules which happen to be imported: other ones in a run of all tests than
# in that of a single one, where a failure could not be seen again. All of these would be filtered for each new range.
providers._get_local_constants = lambda: providers._local_constants  # of which there are none

# The first time that Hypothesis draws it looks for cycles, and for who refers to its generator: seconds in a process
# that has run tests for a while, and nothing as long as there is little to look through.
with deterministic_PRNG():
    pass

# Nearly nothing here dies in a cycle, as in codegen itself, which looks for none either: the end of the run does once.
gc.disable()

# What a shell runs in the background ignores Ctrl-C, and so would every program that a test starts and interrupts.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """One more than there are processors: what waits for a ground station in real time leaves its own to another.

    Each process imports all tests and keeps what they read for itself: with two more they take a tenth longer.
    """
    asked = os.environ.get("PYTEST_XDIST_AUTO_NUM_WORKERS")
    processors = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return int(asked) if asked else processors + 1


def pytest_collection_finish(session: pytest.Session) -> None:
    """Freeze the objects that were imported and collected: they stay, so no later look for cycles goes through them.

    All workers of xdist have the same: one of them looks for cycles before.
    """
    if getattr(session.config, "workerinput", {"workerid": "gw0"})["workerid"] == "gw0":
        gc.collect()
    gc.freeze()


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Let the process that began the run take the cache away, and each process look for cycles once.

    pytest tells of what is found there. It looks again when it ends, and so does the interpreter: for nothing.
    """
    gc.collect()
    gc.freeze()
    if not hasattr(session.config, "workerinput"):
        shutil.rmtree(CACHE, ignore_errors=True)


@pytest.fixture(scope="session", autouse=True)
def read_once() -> Iterator[None]:
    """A file that is as it was is decoded once in this process, as with a cache: few tests exchange what decodes.

    The tests of the cache take this away again.
    """
    known: dict[str, Any] = {}
    with pytest.MonkeyPatch.context() as patch:
        for name in ("kept", "kept_object"):
            patch.setattr(f"codegen.decode.decoded.{name}", known.get)
        for name in ("keep", "keep_object"):
            patch.setattr(f"codegen.decode.decoded.{name}", known.__setitem__)
        yield


@pytest.fixture(scope="session", autouse=True)
def compiled_once() -> Iterator[None]:
    """The firmware of a project is compiled once for an architecture, in whichever process of this run.

    The tests of the cache take this away again.
    """

    folder = CACHE / "compiled"

    def kept_object(name: str) -> Any:
        with suppress(FileNotFoundError):
            return pickle.loads((folder / name).read_bytes())  # noqa: S301  this run wrote it
        return None

    def keep_object(name: str, value: object) -> None:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        unfinished = folder / f"{name}.{os.getpid()}"
        unfinished.write_bytes(pickle.dumps(value))
        unfinished.rename(folder / name)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("codegen.emit.mpy.kept_object", kept_object)
        patch.setattr("codegen.emit.mpy.keep_object", keep_object)
        yield


OTHER_DRAFTS = pytest.StashKey[int]()
"""The number of tests about drafts that specs/codegen.yaml does not list."""


def pytest_configure(config: pytest.Config) -> None:
    """Make the markers known."""
    config.addinivalue_line("markers", "draft(*overlays): what the test expects holds while specs/ list these overlays")
    config.addinivalue_line("markers", "long: begins first where several processes share the tests")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what is about a draft that is not in use; with the shipped choice that is nothing."""
    listed = set(re.findall(r"(?m)^  - dialects/(\w+)\.xml$", (ROOT / "specs" / "codegen.yaml").read_text()))
    others = [
        item for item in items if not {name for mark in item.iter_markers("draft") for name in mark.args} <= listed
    ]
    config.stash[OTHER_DRAFTS] = len(others)
    if hasattr(config, "workeroutput"):
        config.workeroutput["other_drafts"] = len(others)
    if others:
        config.hook.pytest_deselected(items=others)
        items[:] = [item for item in items if item not in set(others)]
    if hasattr(config, "workerinput"):
        items[:] = long_first(items, config.workerinput["workercount"])


def long_first(items: list[pytest.Item], workers: int) -> list[pytest.Item]:
    """Let each worker of xdist begin with its share of the long tests, so that none is left when the others are done.

    A worker gets as many tests in a row as another at first, and then some of those that another one has not begun.
    Tests that wait for the same run are of one worker.
    """
    long = [item for item in items if item.get_closest_marker("long") or item.get_closest_marker("days")]
    chosen = set(long)
    runs: dict[object, list[pytest.Item]] = {}
    for item in long:
        runs.setdefault(_run_of(item), []).append(item)
    shares: list[list[pytest.Item]] = [[] for _ in range(workers)]
    for run in runs.values():
        min(shares, key=len).extend(run)
    others = iter([item for item in items if item not in chosen])
    shared: list[pytest.Item] = []
    for worker, share in enumerate(shares):
        shared += share
        shared += islice(others, max(0, len(items) * (worker + 1) // workers - len(shared)))
    return [*shared, *others]


def _run_of(item: pytest.Item) -> object:
    """Return the key of a shared run: one has all long checks of a file, on an interpreter if that is told."""
    if item.get_closest_marker("days") is None:
        return item
    assert isinstance(item, pytest.Function)
    params = item.callspec.params if hasattr(item, "callspec") else {}
    return item.path, params["check"][0] if "check" in params else params.get("interpreter")


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """Take over what a worker of xdist left out; each of them collects everything."""
    node.config.stash[OTHER_DRAFTS] = getattr(node, "workeroutput", {}).get("other_drafts", 0)


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    """Say how many tests were left out."""
    if number := config.stash.get(OTHER_DRAFTS, 0):
        terminalreporter.write_line(f"{number} tests are about drafts that specs/codegen.yaml does not list: not run")


@pytest.fixture(scope="session")
def first_build(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The folder of the project below, and a copy of it as the build left it."""
    folder = tmp_path_factory.mktemp("built") / "project"
    shutil.copytree(ROOT / "specs", folder / "specs")
    for path in (folder / "specs").rglob("*"):
        os.utime(path, (1, 1))  # long before the build
    subprocess.run([sys.executable, "-m", "codegen", "build"], cwd=folder, check=True, capture_output=True)
    return folder, Path(shutil.copytree(folder, folder.with_name("as_built")))


@pytest.fixture
def built(first_build: tuple[Path, Path]) -> Path:
    """The shipped specification, older than what was built from it: files and times are those of one build."""
    folder, as_built = first_build
    shutil.rmtree(folder)
    shutil.copytree(as_built, folder)
    return folder
