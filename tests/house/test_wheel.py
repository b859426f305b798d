"""The wheel that users install works away from the checkout, and generates the same bytes there."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from generated_suite import suite_is_green

import codegen

ROOT = Path(__file__).parents[2]
LEFT_BY_RUNS = {".codegen", "__pycache__", ".pytest_cache", ".hypothesis", ".mypy_cache", ".ruff_cache"}


def tree(folder: Path) -> dict[str, bytes]:
    """The content of every file by its path, without what running the code leaves behind."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and not LEFT_BY_RUNS & set(path.parts))
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def run(*command: str, cwd: Path, **environment: str) -> str:
    """The stdout of a program, which has to succeed."""
    ran = subprocess.run(
        command, cwd=cwd, env={**os.environ, **environment}, capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0, f"{command}\n{ran.stdout}\n{ran.stderr}"
    return ran.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built from the source distribution, so that neither may lack a file."""
    folder = tmp_path_factory.mktemp("dist")
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", str(folder), str(ROOT), cwd=folder)
    (built,) = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder that the wheel is installed in; in PYTHONPATH it goes before the checkout."""
    folder = tmp_path_factory.mktemp("installed")
    options = ["--no-deps", "--no-index", "--no-compile", "--disable-pip-version-check", "--target", str(folder)]
    run(sys.executable, "-m", "pip", "install", *options, str(wheel), cwd=folder)
    return folder


@pytest.mark.parametrize(
    ("source", "packed"),
    [
        ("templates", "codegen/templates"),
        ("generated/schemas", "codegen/schema_files"),
        ("codegen/corrections", "codegen/corrections"),
        ("specs", "codegen/own_specs"),
    ],
)
def test_wheel_holds_every_template_schema_and_correction(
    wheel: Path, tmp_path: Path, source: str, packed: str
) -> None:
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path)
    expected = tree(ROOT / source)
    assert expected
    assert tree(tmp_path / packed) == expected


def test_wheel_holds_the_package_and_nothing_beside_it(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        tops = {name.split("/", 1)[0] for name in archive.namelist()}
        modules = {name for name in archive.namelist() if name.endswith(".py") and "/templates/" not in name}
    assert tops == {"codegen", f"mavlink_codegen-{codegen.__version__}.dist-info"}
    assert modules == {path.relative_to(ROOT).as_posix() for path in (ROOT / "codegen").rglob("*.py")}


def test_installed_command_is_the_one_of_the_wheel(installed: Path, tmp_path: Path) -> None:
    where = run(
        sys.executable, "-c", "import codegen; print(codegen.__file__)", cwd=tmp_path, PYTHONPATH=str(installed)
    )
    assert Path(where.strip()) == installed / "codegen" / "__init__.py"
    version = run(sys.executable, "-m", "codegen", "--version", cwd=tmp_path, PYTHONPATH=str(installed))
    assert version == f"codegen {codegen.__version__}\n"


def test_installed_command_generates_the_committed_bytes(installed: Path, tmp_path: Path) -> None:
    """No date, no path of this machine and no file of the checkout gets into the output of a new rover."""
    codegen_of_wheel = (sys.executable, "-m", "codegen")
    run(*codegen_of_wheel, "init", "pico-trail", "--from", "rover", cwd=tmp_path, PYTHONPATH=str(installed))
    rover = tmp_path / "pico-trail"
    assert tree(rover / "specs") == tree(ROOT / "specs")
    run(*codegen_of_wheel, "build", cwd=rover, PYTHONPATH=str(installed))
    generated, committed = tree(rover / "generated"), tree(ROOT / "generated")
    assert sorted(generated) == sorted(committed)
    assert [path for path in generated if generated[path] != committed[path]] == []


def test_installed_command_makes_codecs(installed: Path, tmp_path: Path) -> None:
    """The runtime, its templates and the page come with the wheel, the same bytes as from the checkout."""
    options = ["codec", "--dialect", "common", "--messages", "HEARTBEAT,BATTERY_STATUS", "--out"]
    run(sys.executable, "-m", "codegen", *options, "a", cwd=tmp_path, PYTHONPATH=str(installed))
    run(sys.executable, "-m", "codegen", *options, "b", cwd=tmp_path, PYTHONPATH=str(ROOT))
    assert tree(tmp_path / "a") == tree(tmp_path / "b")
    assert "messages.py" in tree(tmp_path / "a")


@pytest.mark.parametrize(
    ("kind", "sent"),
    [
        ("minimal", {"HEARTBEAT", "NAMED_VALUE_FLOAT"}),
        ("boat", {"HEARTBEAT", "GPS_RAW_INT", "ATTITUDE", "DISTANCE_SENSOR"}),
    ],
)
def test_new_projects_of_the_wheel_run(installed: Path, tmp_path: Path, kind: str, sent: set[str]) -> None:
    """In an empty folder and in three commands something of one's own is on the wire, and nothing is found wrong."""

    def codegen_of_wheel(*arguments: str, cwd: Path = tmp_path) -> str:
        return run(sys.executable, "-m", "codegen", *arguments, cwd=cwd, PYTHONPATH=str(installed))

    project = tmp_path / "mine"
    assert codegen_of_wheel("init", "mine", "--from", kind) == "  cd mine && codegen build && codegen sim\n"
    codegen_of_wheel("build", cwd=project)
    assert codegen_of_wheel("check", cwd=project) == ""
    shown = codegen_of_wheel("sim", "--speed", "max", "--duration", "5 s", "--out", "udp:127.0.0.1:9", cwd=project)
    assert {line.split()[0] for line in shown.splitlines() if " frames  " in line} >= sent
    if kind == "minimal":  # that of the boat runs from the checkout, which has the same bytes
        suite_is_green(project, "generated/tests", only="test_frames or test_behaviour or (link and micropython)")


def test_new_codec_of_the_wheel_is_made(installed: Path, tmp_path: Path) -> None:
    """Its dialect includes one that pymavlink ships; the command is the one that init says comes next."""
    environment = {"PYTHONPATH": str(installed)}
    shown = run(sys.executable, "-m", "codegen", "init", "--from", "codec", cwd=tmp_path, **environment)
    assert shown.startswith("  codegen codec --dialect dialects/mine.xml ")
    run(sys.executable, "-m", *shown.split(), cwd=tmp_path, **environment)
    script = "import messages; print(messages.TankLevel.NAME, messages.Heartbeat.CRC_EXTRA)"
    assert run(sys.executable, "-c", script, cwd=tmp_path / "lib") == "TANK_LEVEL 50\n"
