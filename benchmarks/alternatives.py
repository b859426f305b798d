# ruff: noqa: S603, T201  it starts what it is about, and prints what it found
"""Switch through the drafts of RFC 0018 that specs/codegen.yaml can list: each has to build, check and pass as it is.

Each is one line of that file, changed in a copy of this checkout. There run `codegen build`, `codegen check`, `codegen
trace` and a scenario of `codegen sim`, which have no finding, then the generated suites, and with ``--tests`` tests
written by hand, without those that are about another draft.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PYTHON = sys.executable
ALTERNATIVES = {
    "battery_rfc_0018": "battery_upstream",
    "battery_cell_faults_rfc_0018": "battery_cell_voltages_rfc_0018",
}
"""Each overlay with the one that it takes the place of."""
LEFT_OUT = ("build", ".venv", ".mypy_cache", ".pytest_cache", ".ruff_cache", "__pycache__")
SUITES = ("generated/tests", "generated/smart_battery/tests")


def switched(text: str, alternative: str) -> str:
    """codegen.yaml with one line changed: the alternative is listed in place of what it stands for."""
    listed = f"  - dialects/{ALTERNATIVES[alternative]}.xml\n"
    if text.count(listed) != 1:
        raise ValueError(f"{ALTERNATIVES[alternative]} is not listed once")
    return text.replace(listed, f"  - dialects/{alternative}.xml\n")


def steps(tests: list[str]) -> Iterator[tuple[str, list[str]]]:
    """Yield the commands to run in the copy, by name; the paths of ``tests`` last."""
    codegen = [PYTHON, "-m", "codegen"]
    yield "build", [*codegen, "build", "--force", "--clean"]
    yield "build --check", [*codegen, "build", "--check"]
    yield "check", [*codegen, "check"]
    yield "trace", [*codegen, "trace"]
    yield "sim", [*codegen, "sim", "nominal", "--speed", "max"]
    for path in (*SUITES, *tests):
        yield f"pytest {path}", [PYTHON, "-m", "pytest", "-n", "auto", "--dist", "worksteal", path]


def findings(alternative: str, tests: list[str]) -> Iterator[str]:
    """Yield the failures with an alternative, in a copy of the checkout; print each step."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "checkout"
        shutil.copytree(ROOT, folder, ignore=shutil.ignore_patterns(*LEFT_OUT))
        (folder / ".venv").symlink_to(Path(sys.prefix), target_is_directory=True)
        file = folder / "specs" / "codegen.yaml"
        file.write_text(switched(file.read_text(encoding="utf-8"), alternative), encoding="utf-8")
        environment = {**os.environ, "PYTHONPATH": str(folder)}
        for name, command in steps(tests):
            done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
            warned = re.findall(r"(?m)^\S+:\d+:\d+: (?:error|warning) .*$", done.stdout)
            left = re.findall(r"(?m)^.*specs/codegen.yaml does not list.*$", done.stdout)
            print(
                "\n".join([f"{alternative}: {name}: {'failed' if done.returncode or warned else 'passed'}", *left]),
                flush=True,
            )
            if done.returncode or warned:
                yield f"{alternative}: {name}\n{(done.stdout + done.stderr)[-4000:]}"


def main() -> int:
    """Switch through all of them, print what fails, and return the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--only", choices=ALTERNATIVES, help="one alternative")
    parser.add_argument(
        "--tests", nargs="*", default=[], metavar="PATH", help="tests by hand that run, too, such as tests"
    )
    arguments = parser.parse_args()
    chosen = [arguments.only] if arguments.only else list(ALTERNATIVES)
    failed = [finding for alternative in chosen for finding in findings(alternative, arguments.tests)]
    print("\n\n".join(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
