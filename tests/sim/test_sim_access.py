"""Messages of a scenario, which nobody signs, arrive over a link that takes them; where there is none that is said."""

import shutil
import subprocess
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diagnostics import Report
from codegen.model.listening import bridged_link, deaf_links, spoken_cable
from codegen.project.systems import read_system
from codegen.sim.process import Runtime, find_interpreter

ROOT = Path(__file__).resolve().parents[2]
GUARDED = ROOT / "tests" / "projects" / "guarded" / "specs"
SCENARIO = "scenarios:\n  a:\n    doc: d\n    duration: 10 s\n    events:\n      - {at: 1 s, send: PING}\n"
ARMED = """scenarios:
  a:
    doc: d
    duration: 5 s
    code: false
    events:
      - {at: 3 s, send: COMMAND_LONG, fields: {command: MAV_CMD_COMPONENT_ARM_DISARM, param1: 1}}
    expect:
      - {state: vehicle.armed, is: true}
"""
SCRIPT = """
from sim_ground import Ground
class Port:
    received = 0
    home = ("127.0.0.1", 14550)
    ends = [home, None]
    def __init__(self, name):
        self.name = name
    def look(self, wait_ms):
        return ()
    def read(self):
        return None
ground = Ground([{"at_ms": 0, "id": 4, "crc_extra": 237, "payload": "00", "every_ms": None}], 0)
ground.speak_to(Port, ("signed",))
deaf, open_one = Port("signed"), Port("open")
ground.turn(0)
print(list(deaf.look(0)), deaf.read(), list(open_one.look(0)), len(open_one.read()), open_one.read())
"""


@pytest.mark.parametrize("runtime", Runtime)
def test_a_signed_port_hears_nothing_of_it(tmp_path: Path, runtime: Runtime) -> None:
    """It neither says that it has something nor reads it; the open one does both, once."""
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    mocks = str(ROOT / "templates" / "mocks")
    command = [find_interpreter(runtime), str(script)]
    path = {"PYTHONPATH": mocks, "MICROPYPATH": mocks}
    done = subprocess.run(command, env=path, capture_output=True, text=True, check=False)
    assert done.stdout == "[] None [True] 13 None\n", done.stderr


@pytest.mark.parametrize(
    ("links", "stations", "deaf", "bridge", "spoken"),
    [
        ("{wifi: signed, cable: open, radio: listed}", "[255, 254]", ("wifi",), "cable", "cable"),
        ("{wifi: signed, cable: signed, radio: listed}", "[255, 254]", ("wifi", "cable"), "radio", "radio"),
        ("{wifi: open, cable: signed, radio: listed}", "[254, 253]", ("cable", "radio"), "cable", None),
        ("{wifi: signed, cable: signed, radio: listed}", "[254, 253]", ("wifi", "cable", "radio"), "cable", None),
    ],
)
def test_which_links_are_deaf(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    links: str,
    stations: str,
    deaf: tuple[str, ...],
    bridge: str,
    spoken: str | None,
) -> None:
    """Those that are signed, or listed without that station; with no other one a scenario cannot send."""
    shutil.copytree(GUARDED, tmp_path / "specs")
    vehicle = tmp_path / "specs" / "vehicle.yaml"
    text = vehicle.read_text().replace("{wifi: signed, cable: open, radio: listed}", links)
    text = text.replace("  setup: [cable]\n", "  setup: [cable]\n" if "cable: open" in links else "")
    vehicle.write_text(text.replace("[255, 254]", stations))
    (tmp_path / "specs" / "scenarios.yaml").write_text(SCENARIO)
    system = read_system(str(tmp_path / "specs" / "codegen.yaml"), Report())
    assert system is not None
    assert (deaf_links(system), bridged_link(system), spoken_cable(system)) == (deaf, bridge, spoken)
    monkeypatch.chdir(tmp_path)
    main(["check"])
    told = "scenario-send: no link takes what a scenario sends, unsigned and as system 255"
    assert (told in capsys.readouterr().out) == (len(deaf) == 3)


@pytest.mark.parametrize("runtime", Runtime)
@pytest.mark.parametrize("cable", ["cable: open, radio: listed", "radio: listed, cable: signed"])
def test_what_is_sent_arrives_by_a_cable_where_the_network_takes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], runtime: Runtime, cable: str
) -> None:
    """A board with a signed Wi-Fi hears the scenario all the same: else what it expects says nothing."""
    shutil.copytree(GUARDED, tmp_path / "specs")
    vehicle = tmp_path / "specs" / "vehicle.yaml"
    text = vehicle.read_text().replace("cable: open, radio: listed", cable)
    vehicle.write_text(text if "cable: open" in cable else text.replace("  setup: [cable]\n", ""))
    (tmp_path / "specs" / "scenarios.yaml").write_text(ARMED)
    monkeypatch.chdir(tmp_path)
    assert main(["build"]) == 0, capsys.readouterr().out
    assert main(["sim", "a", "--speed", "max", "--runtime", runtime.value]) == 0, capsys.readouterr().out
    assert "3.0 s  armed" in capsys.readouterr().out
