"""The examples of the README and of docs/example.md do what these say, to the letter."""

import os
import re
import socket
import subprocess
import sys
from pathlib import Path

from pymavlink.dialects.v20 import common

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text()
SHOWN = README + (ROOT / "docs" / "example.md").read_text()
LONGEST = 120
BIN = Path(sys.executable).parent


def block(language: str, containing: str) -> str:
    """The fenced block of a language that holds some text."""
    blocks = re.findall(rf"```{language}\n(.*?)```", SHOWN, re.DOTALL)
    return next(text for text in blocks if containing in text)


def test_readme_is_short_and_its_links_lead_somewhere():
    """A newcomer reads it through; what it points at is there."""
    assert len(README.splitlines()) <= LONGEST
    for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", README):
        assert (ROOT / target).exists(), target


def test_example_prints_what_the_readme_shows(tmp_path):
    """The program runs under MicroPython, its output is the README's, and pymavlink decodes the frame."""
    script = tmp_path / "example.py"
    script.write_text(block("python", "MockBoard"))
    environment = {**os.environ, "MICROPYPATH": re.findall(r"(?m)^path=(.+)$", block("sh", "MICROPYPATH"))[0]}
    command = [str(BIN / "micropython"), str(script)]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout == block("text", "9549 mV")
    frame = bytes.fromhex(done.stdout.split()[-1])
    message = common.MAVLink(None).decode(bytearray(frame))
    assert message.voltages[:2] == [9549, 65535]


def test_commands_print_what_the_readme_shows():
    """Each `$ command` of a console block prints the lines below it."""
    environment = {**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}", "COLUMNS": "80"}
    shown = block("console", "$ codegen explain")
    commands = re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", shown, re.MULTILINE)
    assert commands
    for command, output in commands:
        bash = ["bash", "-c", command]
        done = subprocess.run(bash, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
        assert done.stdout == output, command


def test_finding_is_the_one_that_the_readme_shows(tmp_path):
    """The contradiction in the README is reported in these words."""
    lines = (ROOT / "specs/messages/battery_status.yaml").read_text()
    wrong = lines.replace("temperature: {state: battery.temperature,", "temperature: {constant: 0,")
    assert wrong != lines
    copy = tmp_path / "specs"
    subprocess.run(["cp", "-r", str(ROOT / "specs"), str(copy)], check=True)
    (copy / "messages/battery_status.yaml").write_text(wrong)
    done = subprocess.run([str(BIN / "codegen"), "check"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stdout.startswith(block("text", "sentinel-contradiction").rstrip("\n"))


WIRE = """
class Wire:
    def __init__(self):
        self.data = b""

    def write(self, data):
        self.data += bytes(data)
        return len(data)

    def read(self):
        return self.data


uart = Wire()
"""


def test_codec_examples_run(tmp_path):
    """The command of the README writes what it says; its example and that of docs/codec.md talk to themselves."""
    command, shown = re.search(r"\$ (codegen codec .*)\n(.*\n)", block("console", "$ codegen codec")).groups()
    environment = {**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}", "MICROPYPATH": "lib"}
    bash = ["bash", "-c", command]
    done = subprocess.run(bash, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, shown)
    page = (ROOT / "docs" / "codec.md").read_text()
    examples = [
        block("python", "messages.BatteryStatus().update"),
        re.findall(r"```python\n(.*?)```", page, re.DOTALL)[0],
    ]
    for example in examples:
        heartbeat = "link.send(messages.Heartbeat())\nfor message in link.feed(uart.read()):"
        text = WIRE + example.replace("for message in link.feed(uart.read()):", heartbeat)
        (tmp_path / "example.py").write_text(text)
        for interpreter in ("micropython", "python"):
            run = [str(BIN / interpreter), "example.py"]
            paths = {**environment, "PYTHONPATH": "lib", "PYTHONDONTWRITEBYTECODE": "1"}
            printed = subprocess.run(run, cwd=tmp_path, env=paths, capture_output=True, text=True, check=False)
            assert printed.returncode == 0, printed.stderr
            assert "1 BATTERY_STATUS" in printed.stdout or "system 1 is there" in printed.stdout


def simulate(*arguments):
    """Run `codegen sim` in the project, towards a port that nobody else has."""
    with socket.socket(type=socket.SOCK_DGRAM) as station:
        station.bind(("127.0.0.1", 0))
        out = f"udp:127.0.0.1:{station.getsockname()[1]}"
        command = [str(BIN / "codegen"), "sim", *arguments, "--out", out]
        return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)


def test_simulation_ends_as_the_readme_shows():
    """The scenario's result is the README's, whatever the version of MicroPython."""
    shown = block("text", "$ codegen sim")
    command, _, expected = shown.partition("\n")
    done = simulate(*command.split()[3:])
    version = re.compile(r"MicroPython [\d.]+")
    assert version.sub("MicroPython", done.stdout) == version.sub("MicroPython", expected)


def test_code_of_the_user_runs_in_the_simulation(tmp_path):
    """The class in docs/rover.md is taken for the vehicle, and its calls are made."""
    page = (ROOT / "docs" / "rover.md").read_text()
    example = re.search(r"```python\n(.*?)```", page, re.DOTALL)
    (tmp_path / "rover.py").write_text(example[1])
    done = simulate("low", "--speed", "max", "--code", str(tmp_path / "rover.py"))
    assert "stopping, the battery is low" in done.stdout
