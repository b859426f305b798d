"""The frame around the commands: usage, finding the project, and every way that a run can end."""

import json
import os
import pty
import re
import subprocess
import sys
from argparse import ArgumentParser
from pathlib import Path
from typing import Any

import pytest

from codegen import __version__
from codegen.cli.parser import _columns, parser_for
from codegen.cli.usage import COMMANDS, HELP

HEAVY = (
    "yaml",
    "lxml",
    "jinja2",
    "markdown_it",
    "pymavlink",
    "dataclasses",
    "codegen.project.systems",
    "codegen.diagnostics",
)

STAGED = """
import sys, types
from codegen.diagnostics import Rule
from codegen.source import Place

def read_systems(project_file, report):
    for line in range(20_000):
        report.add(Rule(f"broken-{line % 200}", ""), Place(project_file, line + 1), "it is wrong \\u00b5 \\udcff")

nothing = dict.fromkeys(("check_scenarios", "read_trace_lock"), lambda *_: None)
for part in ("project.systems", "commands.drift", "commands.trace"):
    sys.modules[f"codegen.{part}"] = types.SimpleNamespace(read_systems=read_systems, **nothing)
from codegen.cli import main
sys.exit(main(sys.argv[1:]))
"""
"""codegen with a specification that has more findings than a pipe holds."""


def staged(*argv: str, **options: Any) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run([sys.executable, "-c", STAGED, *argv], check=False, timeout=60, **options)


@pytest.mark.parametrize("argv", [["--version"], ["--help"], ["build", "--help"], ["import", "--help"], ["nonsense"]])
def test_help_and_version_import_nothing_heavy(argv: list[str]) -> None:
    """They answer at once; the heavy libraries would take a tenth of a second and more."""
    program = (
        "import sys\nfrom codegen.cli import main\nmain(sys.argv[1:])\n"
        f"print('imported:', *[name for name in {HEAVY!r} if name in sys.modules])"
    )
    ran = subprocess.run([sys.executable, "-c", program, *argv], capture_output=True, text=True, check=False)
    assert ran.stdout.splitlines()[-1] == "imported:"


def test_version(run: Any) -> None:
    assert run("--version") == (0, f"codegen {__version__}\n", "")


@pytest.mark.parametrize("argv", [["--version"], ["--help"], [], ["completion", "bash"], ["codec", "--help"]])
def test_a_full_disk_is_no_internal_error(argv: list[str]) -> None:
    """The command begins in different ways for what has to answer at once; each of them says what the system says."""
    with Path("/dev/full").open("w") as full:
        ran = subprocess.run([sys.executable, "-m", "codegen", *argv], stdout=full, stderr=subprocess.PIPE, check=False)
    assert (ran.returncode, b"Traceback" in ran.stderr) == (2, False)
    assert b"No space left on device" in ran.stderr


@pytest.mark.parametrize("argv", [["nonsense"], ["build", "--nonsense"], ["check", "--format", "xml"], ["explain"]])
def test_wrong_usage_ends_with_2(run: Any, argv: list[str]) -> None:
    code, out, err = run(*argv)
    assert (code, out) == (2, "")
    assert err.startswith("usage: codegen")


def test_alone_it_says_how_one_begins(run: Any) -> None:
    code, out, err = run()
    assert (code, err) == (0, "")
    named = re.findall(r"(?m)^  codegen (\w+)", out)
    assert len(named) == 5
    assert set(named) <= set(COMMANDS)


@pytest.mark.parametrize(
    ("argv", "said"),
    [
        (["bild"], "codegen: error: argument COMMAND: there is no bild (did you mean build?)\n"),
        (["--debug", "chek"], "there is no chek (did you mean check?)\n"),
        (
            ["build", "--chekc"],
            "codegen build: error: unrecognized arguments: --chekc (did you mean --check or --help?)\n",
        ),
        (["check", "--formt=json"], "unrecognized arguments: --formt=json (did you mean --format?)\n"),
        (["build", "--zzz"], "unrecognized arguments: --zzz\n"),
        (["build", "--mpy", "armv7"], "there is no armv7 (did you mean armv7m or armv6m?)\n"),
        (["init", "--from", "zzz"], "there is no zzz (known: minimal, rover, boat, codec)\n"),
    ],
)
def test_wrong_words_are_told_with_what_may_have_been_meant(run: Any, argv: list[str], said: str) -> None:
    code, out, err = run(*argv)
    assert (code, out) == (2, "")
    assert err.endswith(said)


def test_explain_tells_its_topics(run: Any) -> None:
    told = " ".join(run("explain", "--help")[1].split())
    for topic in ("message", "field", "component", "quantity", "parameter", "stream", "requirement", "rule"):
        assert topic in told


def test_help_names_every_command(run: Any) -> None:
    code, out, _ = run("--help")
    assert code == 0
    listed = out.partition("  COMMAND\n")[2]
    assert tuple(re.findall(r"(?m)^ {4}([a-z]+) {2,}[a-z]", listed)) == COMMANDS
    assert run("-h") == run("--debug", "--help") == (code, out, "")


def test_help_names_every_option(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is written out: what argparse would say of the options has to be there."""
    monkeypatch.setenv("COLUMNS", "80")
    _columns.cache_clear()
    said = ArgumentParser.format_help(parser_for(["build"]))
    _columns.cache_clear()
    usage, options = said.split("\n\n")[:2]
    assert HELP.startswith(f"{usage}\n\n")
    assert f"\n\n{options}\n\n" in HELP


def test_nearest_project_upwards_is_used(pipeline: Any, run: Any, project: Path, monkeypatch: Any) -> None:
    inner = project / "other" / "deep" / "er"
    inner.mkdir(parents=True)
    monkeypatch.chdir(inner)
    run("check")
    (project / "other" / "codegen.yaml").write_text("")
    run("check")
    (project / "other" / "specs").mkdir()
    (project / "other" / "specs" / "codegen.yaml").write_text("")
    run("check")
    names = ["specs/codegen.yaml", "other/codegen.yaml", "other/specs/codegen.yaml"]
    assert pipeline.projects == [str(project / name) for name in names]


@pytest.mark.parametrize("argv", [["--project", "x.yaml", "check"], ["check", "--project", "x.yaml"]])
def test_project_option_stands_before_or_after_the_command(
    pipeline: Any, run: Any, project: Path, argv: list[str]
) -> None:
    run(*argv)
    assert pipeline.projects == [str(project / "x.yaml")]


@pytest.mark.parametrize("command", ["build", "check", "trace", "sim", "deploy", "bench", "watch"])
def test_no_project_ends_with_2_and_says_what_is_missing_in_the_form_of_findings(
    pipeline: Any, run: Any, project: Path, command: str
) -> None:
    (project / "specs" / "codegen.yaml").unlink()
    code, out, err = run(command)
    assert (code, err, pipeline.projects) == (2, "1 error\n", [])
    assert out.startswith(
        "specs/codegen.yaml:1:1: error file-not-found: there is no specs/codegen.yaml or codegen.yaml"
    )
    assert "--project" in out
    assert "codegen init" in out


@pytest.mark.parametrize("command", ["check", "trace"])
def test_no_project_is_told_in_the_format_that_is_asked_for(run: Any, project: Path, command: str) -> None:
    (project / "specs" / "codegen.yaml").unlink()
    code, out, err = run(command, "--format", "json")
    assert (code, err) == (2, "")
    assert [each["rule"] for each in json.loads(out)["findings"]] == ["file-not-found"]


@pytest.mark.parametrize("folder", [".", "specs", "../{name}"])
def test_project_may_be_a_folder(pipeline: Any, run: Any, project: Path, folder: str) -> None:
    run("check", "--project", folder.format(name=project.name))
    assert pipeline.projects == [str(project / "specs/codegen.yaml")]


def test_internal_error_is_one_line_and_ends_with_3(pipeline: Any, run: Any) -> None:
    pipeline.fault = ValueError("a fault\nof two lines")
    code, out, err = run("check")
    assert (code, out, len(err.splitlines())) == (3, "", 1)
    assert "internal error (ValueError: a fault of two lines)" in err
    assert "report" in err


def test_traceback_only_when_asked_for(pipeline: Any, run: Any, monkeypatch: Any) -> None:
    pipeline.fault = ValueError("a fault")
    assert "Traceback" in run("check", "--debug")[2]
    assert "Traceback" in run("--debug", "check")[2]
    monkeypatch.setenv("CODEGEN_DEBUG", "1")
    assert "Traceback" in run("check")[2]
    monkeypatch.setenv("CODEGEN_DEBUG", "0")
    assert "Traceback" not in run("check")[2]


def test_interrupt_is_quiet(pipeline: Any, run: Any) -> None:
    pipeline.fault = KeyboardInterrupt()
    assert run("build") == (130, "", "")


@pytest.mark.parametrize(("argument", "reader"), [("check", "head -n 1"), ("--help", "sleep 0")])
def test_reader_that_goes_away_ends_the_run_quietly(project: Path, argument: str, reader: str) -> None:
    """``codegen check | head -1``: the rest has no reader, which is no reason to complain."""
    program = f'set -o pipefail; (sleep 0.3; exec "$0" -c "$1" {argument}) | {reader}'
    ran = subprocess.run(
        ["bash", "-c", program, sys.executable, STAGED],
        cwd=project,
        env={**os.environ, "PYTHONUNBUFFERED": ""},
        capture_output=True,
        check=False,
        timeout=60,
    )
    assert ran.stdout.count(b"\n") == reader.startswith("head")
    assert ran.stderr == b""
    assert ran.returncode == 141


@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_full_disk_behind_stdout_is_no_internal_error(project: Path, unbuffered: str) -> None:
    environment = {**os.environ, "PYTHONUNBUFFERED": unbuffered}
    with open("/dev/full", "wb") as full:
        ran = staged("check", cwd=project, env=environment, stdout=full, stderr=subprocess.PIPE)
    assert ran.returncode == 2
    assert ran.stderr == b"codegen: the system refuses to go on: [Errno 28] No space left on device\n"


def test_closed_stdout_is_no_internal_error(project: Path) -> None:
    ran = staged("check", cwd=project, preexec_fn=lambda: os.close(1), stderr=subprocess.PIPE)
    assert ran.returncode == 1
    assert ran.stderr == b"20000 errors\n"


def test_characters_that_the_terminal_lacks_are_escaped(project: Path) -> None:
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    ran = staged("check", cwd=project, env=environment, capture_output=True)
    assert ran.returncode == 1
    assert rb"it is wrong \xb5 \udcff" in ran.stdout


@pytest.mark.parametrize(
    ("extra", "coloured"),
    [({"TERM": "xterm"}, True), ({"TERM": "xterm", "NO_COLOR": "1"}, False), ({"TERM": "dumb"}, False)],
)
def test_colours_only_on_a_terminal_that_wants_them(project: Path, extra: dict[str, str], coloured: bool) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "NO_COLOR"} | extra
    few = STAGED.replace("20_000", "2")
    command = [sys.executable, "-c", few, "check"]
    terminal, end = pty.openpty()
    try:
        subprocess.run(command, cwd=project, env=environment, stdout=end, stderr=subprocess.DEVNULL, check=False)
        shown = os.read(terminal, 4096)
    finally:
        os.close(end)
        os.close(terminal)
    assert (b"\x1b[1;31merror\x1b[0m" in shown) is coloured
    piped = subprocess.run(command, cwd=project, env=environment, capture_output=True, check=False)
    assert b"\x1b" not in piped.stdout
