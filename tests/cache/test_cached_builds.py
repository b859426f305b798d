"""A build that knows what an earlier one found out writes what a build that knows nothing writes."""

import os
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from codegen.tool import digest as tool

ROOT = Path(__file__).resolve().parents[2]


def run(folder: Path, cache: Path | str, *command: str, package: Path = ROOT) -> str:
    """Return the output of a command, which has to succeed, with the codegen of a checkout."""
    surroundings = {**os.environ, "CODEGEN_CACHE": str(cache), "PYTHONPATH": str(package)}
    if package != ROOT:  # its modules change, with their times and sizes as they were
        surroundings["PYTHONDONTWRITEBYTECODE"] = "1"
    done = subprocess.run(
        [sys.executable, "-m", "codegen", *command], cwd=folder, env=surroundings, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


def texts(folder: Path) -> dict[str, bytes]:
    """The generated files."""
    files = (path for path in folder.rglob("*") if path.is_file() and ".codegen" not in path.parts)
    return {str(path): path.read_bytes() for path in files}


EDITS = {
    "specs/parameters.yaml": ("default: 3300\n", "default: 3400\n"),
    "specs/state.yaml": ("  battery:\n", "  # no less\n  battery:\n"),
    "specs/streams.yaml": ("\nstreams:\n", "\n# shifted\nstreams:\n"),
    "specs/board.yaml": ("doc: A second", "doc: Another"),
    "specs/vehicle.yaml": ("doc: Stop and", "doc: Halt and"),
    "specs/scenarios.yaml": ("doc: A good", "doc: A very good"),
    "specs/messages/battery_status.yaml": ("message: BATTERY_STATUS", "# shifted\nmessage: BATTERY_STATUS"),
    "specs/requirements/FR-00068-battery-status-telemetry.md": ("| BATTERY_STATUS telemetry", "| BATTERY_STATUS"),
    "specs/dialects/battery_upstream.xml": ("FLAGS_CELL_BALANCING", "FLAGS_BALANCING"),
    "specs/dialects/upstream.xml": ("<messages>", "<!-- shifted -->\n<messages>"),
    "specs/dialects/corrections_rfc_0018.yaml": ("reason: The draft", "reason: Again, the draft"),
    "specs/smart_battery/parameters.yaml": ("doc: ", "doc: Again, "),
    "specs/smart_battery/messages/heartbeat.yaml": ("message: HEARTBEAT", "# shifted\nmessage: HEARTBEAT"),
}
"""One edit of each kind of file: what is replaced, once, and by what."""


@pytest.fixture(scope="module")
def kept(first_build: tuple[Path, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What a build of the project below keeps."""
    cache = tmp_path_factory.mktemp("kept") / "cache"
    run(first_build[0], cache, "build", "--check")
    return cache


@pytest.fixture
def cache(kept: Path, tmp_path: Path) -> Path:
    """A copy of it."""
    return Path(shutil.copytree(kept, tmp_path / "cache"))


def test_after_an_edit_of_any_file_the_output_is_that_of_a_build_that_knows_nothing(
    built: Path, cache: Path, tmp_path: Path
) -> None:
    """Also where files come and go: the table of a program's base is meant where the program's own is gone."""
    before = texts(built / "generated")
    own = built / "specs" / "smart_battery" / "messages"
    for path, (old, new) in EDITS.items():  # all at once: none may be missed
        file = built / path
        text = file.read_text()
        assert old in text, path
        file.write_text(text.replace(old, new, 1))
    run(built, cache, "build")
    edited = texts(built / "generated")
    shutil.move(own / "battery_info.yaml", tmp_path)
    run(built, cache, "build", "--clean")
    run(built, "off", "build", "--check")
    assert edited != texts(built / "generated")
    for path, (old, new) in EDITS.items():
        file = built / path
        file.write_text(file.read_text().replace(new, old, 1))
    shutil.move(tmp_path / "battery_info.yaml", own)
    run(built, cache, "build", "--clean")
    assert texts(built / "generated") == before


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A codegen of its own that a test can change, older than its first run."""
    folder = tmp_path / "package"
    for name in ("codegen", "templates"):
        shutil.copytree(ROOT / name, folder / name)
    for path in CHANGES:
        for compiled in (folder / path).parent.glob(f"__pycache__/{Path(path).stem}.*"):
            compiled.unlink()
    time.sleep(tool.SETTLED_NS / 1e9 + 0.1)  # files that have just been written are read anew at each run
    return folder


CHANGES = {
    "codegen/targets/origin.py": ("do not edit", "do NOT edit"),
    "templates/firmware/parameters.py.j2": (" the ", " THE "),
    "templates/firmware/conversion.py": (" the ", " THE "),
}
"""A change of codegen's code, of a template, of a file that is copied: what is replaced, and by what."""


def test_another_codegen_has_another_output(tmp_path: Path, package: Path) -> None:
    """Whatever its files' times and sizes say; and of changes that are taken back nothing is left."""
    cache, begun = tmp_path / "cache", tmp_path / "begun"
    begun.mkdir()
    run(begun, cache, "init", package=package)
    run(begun, cache, "build", package=package)
    before = last = texts(begun / "generated")
    for path, (old, new) in CHANGES.items():
        file = package / path
        described = file.stat()
        file.write_text(file.read_text().replace(old, new, 1))
        os.utime(file, ns=(described.st_atime_ns, described.st_mtime_ns))
        run(begun, cache, "build", package=package)
        changed = texts(begun / "generated")
        assert {file for file in last if last[file] != changed[file]}, path
        last = changed
    run(begun, "off", "build", "--check", package=package)
    for path in CHANGES:
        shutil.copy(ROOT / path, package / path)
    run(begun, cache, "build", package=package)
    assert texts(begun / "generated") == before


def test_damage_is_repaired(built: Path, cache: Path) -> None:
    for path in cache.iterdir():
        content = path.read_bytes()
        path.write_bytes(content[:32] + bytes(len(content) - 32))
    for _ in range(2):
        run(built, cache, "build", "--check")
        assert not [path for path in cache.iterdir() if path.read_bytes()[32:64] == bytes(32)]


def test_several_runs_at_once_share_it(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    folders = [tmp_path / name for name in ("one", "another", "third")]
    for folder in folders:
        shutil.copytree(ROOT / "tests" / "projects" / "minimal" / "specs", folder / "specs")
    with ThreadPoolExecutor(len(folders)) as runs:
        list(runs.map(lambda folder: run(folder, cache, "build"), folders))
    assert all(len(path.name) == 64 for path in cache.iterdir())  # nothing unfinished
    first, *others = ({path.name: path.read_bytes() for path in folder.rglob("*.py")} for folder in folders)
    assert first
    assert others == [first, first]


def test_a_codec_is_the_same_with_it(tmp_path: Path) -> None:
    dialect = tmp_path / "own.xml"
    shutil.copy(ROOT / "specs" / "dialects" / "protocol_version.xml", dialect)
    command = ("codec", "--dialect", str(dialect), "--messages", "all", "--out")
    for text in ("", "An edit. "):
        dialect.write_text(dialect.read_text().replace("<description>", f"<description>{text}"))
        for number in range(2):
            run(tmp_path, tmp_path / "cache", *command, str(tmp_path / f"kept{number}"))
        run(tmp_path, "off", *command, str(tmp_path / "anew"))
        assert texts_below(tmp_path / "kept0") == texts_below(tmp_path / "kept1") == texts_below(tmp_path / "anew")


def texts_below(folder: Path) -> dict[str, bytes]:
    """The generated files by their names."""
    return {path.name: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
