"""The command line of codegen sim: what can be wrong with it, and what it prints."""

import errno
import os
import pty
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from codegen.cli import main


def test_the_scenarios_are_listed(run: Any) -> None:
    code, out, err = run("--list")
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert re.match(r"nominal +A good pack", lines[0])
    assert {"nominal", "low", "two_batteries", "smart_battery", "swap"} <= {line.split()[0] for line in lines}


@pytest.mark.parametrize(
    ("argv", "says"),
    [
        (["lwo"], "there is no scenario 'lwo'; did you mean low?"),
        (["low", "--speed", "0"], "--speed: '0'"),
        (["low", "--speed", "nan"], "--speed"),
        (["low", "--speed", "fast"], "or max"),
        (["low", "--duration", "soon"], "--duration: 'soon'"),
        (["low", "--duration", "-5 s"], "--duration"),
        (["low", "--duration", "5 V"], "--duration"),
        (["low", "--out", "127.0.0.1:14550"], "write udp:HOST:PORT"),
        (["low", "--out", "udp:127.0.0.1"], "write udp:HOST:PORT"),
        (["low", "--out", "udp:127.0.0.1:0"], "not a port"),
        (["low", "--out", "udp:127.0.0.1:70000"], "not a port"),
        (["low", "--out", "udp:127.0.0.1:1_0"], "not a port"),
        (["low", "--out", "udp:[::1]:14550"], "IPv4"),
        (["low", "--out", "udp:no.such.host.invalid:14550"], "not known"),
        (["low", "--link", "field"], "--link: 'field' is not NAME=HOST:PORT"),
        (["low", "--link", "field=70000"], "--link"),
        (["low", "--link", "field=no.such.host.invalid:5760"], "not known"),
        (["low", "--link", "wifi=5760"], "--link: there is no link 'wifi' over TCP; there is none"),
        (["low", "--code", "absent.py"], "--code: there is no file absent.py"),
        (["low", "--flash", "specs/state.yaml"], "--flash"),
        (["low", "--report", "absent/r.html"], "--report"),
        (["low", "--record", "absent/r.csv"], "--record: "),
        (["low", "--record", "r.txt"], "--record: r.txt ends neither"),
        (["low", "--report", "specs"], "--report: specs is a folder"),
        (["low", "--report", "r.png"], "--report: r.png ends neither with .html nor with .svg"),
        (["specs/scenarios.yaml"], "specs/scenarios.yaml:NAME"),
        (["specs/scenarios.yaml:lwo"], "did you mean low?"),
    ],
)
def test_wrong_usage_is_one_line_and_ends_with_2(run: Any, argv: list[str], says: str) -> None:
    code, out, err = run(*argv)
    assert (code, out, len(err.splitlines())) == (2, "", 1), err
    assert err.startswith("codegen sim: ")
    assert says in err


def test_without_firmware_it_says_what_to_do(project: Path, run: Any) -> None:
    shutil.rmtree(project / "generated")
    code, out, err = run("low")
    assert (code, out) == (2, "")
    assert err == "codegen sim: there is no firmware in generated: run codegen build first\n"


def test_without_micropython_it_says_what_to_do(project: Path, run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.executable", str(project / "python"))
    monkeypatch.setenv("PATH", str(project))
    code, out, err = run("low")
    assert (code, out) == (2, "")
    assert "micropython is not installed" in err


def test_a_broken_scenario_file_is_reported_with_all_its_places(project: Path, run: Any) -> None:
    (project / "own.yaml").write_text(
        "scenarios:\n  own:\n    doc: d\n    duration: 4 V\n    courses: {battery.voltage: {value: 12}}\n"
        "  other:\n    doc: d\n    duration: 4 s\n    courses: {battery.voltage: {value: 12 V}}\n"
        "    events: [{at: 5 s, arm: true}]\n"
    )
    code, out, _ = run("own.yaml")
    assert code == 1
    places = [line.split(": ")[:2] for line in out.splitlines() if line.startswith("own.yaml")]
    assert places == [
        ["own.yaml:4:15", "error unit-mismatch"],
        ["own.yaml:5:40", "error bad-amount"],
        ["own.yaml:10:19", "error scenario-time"],
    ]


def test_faults_of_other_scenarios_do_not_stop_the_one_that_is_named(project: Path, run: Any) -> None:
    """Without a name, and for the one that has them, they do."""
    good = "    doc: d\n    duration: 1 s\n    courses: {battery.voltage: {value: 12 V}}\n"
    (project / "own.yaml").write_text(f"scenarios:\n  a:\n{good.replace('12 V', '12 A')}  b:\n{good}")
    code, out, err = run("own.yaml:b")
    assert code == 0, out + err
    assert "b: 1.0 s" in out
    assert "codegen sim: warning: own.yaml has faults in other scenarios\n" in err
    for given in ("own.yaml", "own.yaml:a", "own.yaml:c"):
        code, out, _ = run(given)
        assert (code, "own.yaml:5:40: error unit-mismatch" in out) == (1, True), given


@pytest.mark.parametrize("content", [None, b"\xff\xfe\x00", b"scenarios: [", b"\x00", b"- 1\n"])
def test_an_unreadable_scenario_file_is_a_finding(project: Path, run: Any, content: bytes | None) -> None:
    if content is not None:
        (project / "own.yaml").write_bytes(content)
    code, out, err = run("own.yaml")
    assert code in (1, 2)
    assert out.startswith("own.yaml:1:")
    assert "Traceback" not in out + err


def test_a_file_with_several_scenarios_and_a_name(run: Any) -> None:
    code, out, err = run("specs/scenarios.yaml:low", "--duration", "1")
    assert code == 0, err
    assert "low: 1.0 s" in out


def test_a_firmware_that_a_build_would_change_is_warned_of(project: Path, run: Any) -> None:
    with (project / "generated" / "firmware" / "board.py").open("a") as file:
        file.write("# edited\n")
    code, _, err = run("low", "--duration", "1")
    assert code == 0
    assert re.search(r"^codegen sim: warning: codegen build would change .*\bboard\.py", err, re.MULTILINE)


def test_quiet_prints_only_the_result(run: Any) -> None:
    code, out, err = run("low", "--duration", "6", "--quiet")
    assert code == 0
    assert out.startswith("low: 6.0 s under MicroPython")
    assert "armed" not in out
    assert all("warning" in line for line in err.splitlines())


def test_what_came_of_it_is_told_where_no_file_can_be_written(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A simulation may take hours, and the disk be full at the end: each file that lacks is named."""

    def full(_path: str, _text: str) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("codegen.sim.report.write_whole", full)
    code, out, err = run("low", "--duration", "1", "--quiet", "--report", "r.html", "--record", "r.json")
    assert code == 2
    assert "low: 1.0 s" in out
    assert "r.html shows it" not in out
    assert "codegen sim: error: r.html cannot be written: No space left on device" in err
    assert Path("r.json").exists()
    monkeypatch.setattr("codegen.sim.data.write_whole", full)
    assert "r.json cannot be written" in run("low", "--duration", "1", "--quiet", "--record", "r.json")[2]


@pytest.mark.usefixtures("project")
def test_a_status_line_changes_on_a_terminal(station: Any) -> None:
    """And is gone when the result is printed."""
    reading, writing = pty.openpty()
    command = [sys.executable, "-m", "codegen", "sim", "low", "--duration", "1", "--out", station.address]
    running = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=writing, env={**os.environ, "TERM": "xterm"})
    os.close(writing)
    shown = b""
    try:
        while data := os.read(reading, 4096):
            shown += data
    except OSError:
        pass  # the end of a terminal
    os.close(reading)
    assert running.wait(30) == 0
    assert running.stdout is not None
    running.stdout.close()
    assert shown.count(b"\r\x1b[Klow ") >= 3
    assert re.search(rb"battery\.voltage 11\.\d\d V, told 11\.\d\d V  disarmed, standby", shown)
    assert shown.endswith(b"\r\x1b[K")


def test_help_says_what_there_is(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sim", "--help"]) == 0
    out = capsys.readouterr().out
    options = "--runtime --out --speed --duration --report --flash --code --record --list --quiet"
    assert [option for option in options.split() if option not in out] == []
