"""`codegen codec`: what it writes, whom it serves, and what it says to those who ask for what is not there."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diagnostics import Report
from codegen.emit.mpy import BYTECODE, compiled

Run = Callable[..., tuple[int, str, str]]

DIALECT = """<mavlink>
  <include>parts/base.xml</include>
  <messages>
    <message id="70000" name="PAYLOAD_RACK">
      <description>What hangs below | the vehicle</description>
      <field type="char[6]" name="label" invalid="[0]">Name of it</field>
      <field type="uint16_t[4]" name="weights" units="g" invalid="[UINT16_MAX]">Weight of each slot</field>
      <field type="float" name="angle" units="rad" invalid="NaN">Tilt</field>
      <field type="uint8_t" name="state" enum="RACK_STATE">State</field>
      <extensions/>
      <field type="int32_t" name="wire" units="mm">Length of the wire</field>
    </message>
    <message id="70001" name="MESSAGE">
      <description>Named like the base class</description>
      <field type="uint8_t" name="get">Named like a method</field>
    </message>
  </messages>
</mavlink>
"""
BASE = """<mavlink>
  <version>7</version>
  <enums>
    <enum name="RACK_STATE"><entry value="0" name="RACK_STATE_OPEN"/><entry value="1" name="RACK_STATE_SHUT"/></enum>
    <enum name="UNUSED"><entry value="0" name="UNUSED_ENTRY"/></enum>
  </enums>
  <messages>
    <message id="0" name="HEARTBEAT">
      <description>Alive</description>
      <field type="uint8_t" name="beat">Beat</field>
      <field type="uint8_t_mavlink_version" name="mavlink_version">Version of the dialect</field>
    </message>
  </messages>
</mavlink>
"""

SCRIPT = """
import messages
from enums import RACK_STATE_SHUT
from mavlink import Link

class Wire:
    def __init__(self): self.data = bytearray()
    def write(self, data):
        self.data += data
        return len(data)

wire = Wire()
link = Link(wire, 7, 8, messages=messages.ALL)
rack = messages.PayloadRack()
assert rack.label == "" and rack.weights == (None,) * 4 and rack.angle is None and rack.state == 0
rack.update(label="hook", weights=[1, None, 3, 4], state=RACK_STATE_SHUT)
assert messages.Heartbeat().mavlink_version == 7 and messages.Heartbeat(unknown=False).mavlink_version == 0
rack.set("wire", -5)
assert rack.get("wire") == -5
print(rack)
link.send(rack)
other = messages.Message_()
other.set("get", 9)
link.send(other)
for message in link.feed(wire.data):
    print(message.NAME, message.source_system, message.source_component, message.source_sequence, message.names())
    print([message.raw(name) for name in message.names() if name != "angle"])
"""
PRINTED = """PAYLOAD_RACK(angle=None, weights=(1, None, 3, 4), label='hook', state=1, wire=-5)
PAYLOAD_RACK 7 8 0 ['angle', 'weights', 'label', 'state', 'wire']
[(1, 65535, 3, 4), 'hook', 1, -5]
MESSAGE 7 8 1 ['get']
[9]
"""


@pytest.fixture
def dialect(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A dialect of a user's own, which includes another file of theirs."""
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "base.xml").write_text(BASE)
    (tmp_path / "rack.xml").write_text(DIALECT)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    def command(*arguments: str) -> tuple[int, str, str]:
        code = main(["codec", *arguments])
        return code, *capsys.readouterr()

    return command


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
@pytest.mark.parametrize("options", [[], ["--bytecode"]], ids=["machine-code", "bytecode"])
def test_a_dialect_of_ones_own_works(dialect: Path, run: Run, interpreter: str, options: list[str]) -> None:
    """Includes, sentinels of each form, names that collide, enums: sent and received on both interpreters."""
    assert run("--dialect", "rack.xml", "--messages", "all", "--out", "lib", *options)[0] == 0
    assert ("frames_viper.py" in files(dialect / "lib")) == (not options)
    (dialect / "script.py").write_text(SCRIPT)
    path = str(dialect / "lib")
    program = str(Path(sys.executable).parent / interpreter)
    environment = os.environ | {"PYTHONPATH": path, "MICROPYPATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run([program, "script.py"], env=environment, capture_output=True, text=True, check=False)
    assert (done.stdout, done.returncode) == (PRINTED, 0), done.stderr


def test_only_chosen_messages_are_there(dialect: Path, run: Run) -> None:
    """A board pays for nothing else: one class, the enum that it refers to; names in any case and order."""
    assert run("--dialect", "rack.xml", "--messages", "payload_rack", "--out", "lib")[0] == 0
    enums = (dialect / "lib" / "enums.py").read_text()
    assert "RACK_STATE_SHUT = 1" in enums
    assert "UNUSED_ENTRY" not in enums
    text = (dialect / "lib" / "messages.py").read_text()
    assert text.count("\nclass ") == 1
    assert text.endswith("ALL = (PayloadRack,)\n")


def test_enums_can_be_chosen(dialect: Path, run: Run) -> None:
    """By their names, or none; one that is not there is a finding."""
    arguments = ("--dialect", "rack.xml", "--messages", "HEARTBEAT")
    assert run(*arguments, "--out", "a", "--enums", "unused")[0] == 0
    assert "UNUSED_ENTRY = 0" in (dialect / "a" / "enums.py").read_text()
    assert run(*arguments, "--out", "b", "--enums", "none")[0] == 0
    assert " = " not in (dialect / "b" / "enums.py").read_text()
    code, out, _ = run(*arguments, "--out", "c", "--enums", "RACK_STAT")
    assert code == 1
    assert "codec-enum" in out
    assert "did you mean RACK_STATE?" in out


def test_a_name_of_two_enums_stands_for_the_first(dialect: Path, run: Run) -> None:
    """Constants share one module: what would overwrite another is a comment."""
    path = dialect / "parts" / "base.xml"
    path.write_text(path.read_text().replace('value="0" name="UNUSED_ENTRY"', 'value="5" name="RACK_STATE_SHUT"'))
    assert run("--dialect", "rack.xml", "--messages", "all", "--out", "lib")[0] == 0
    lines = (dialect / "lib" / "enums.py").read_text().splitlines()
    assert [line for line in lines if "SHUT" in line] == ["RACK_STATE_SHUT = 1", "# RACK_STATE_SHUT = 5"]


def test_page_shows_fields_and_runs_its_own_example(dialect: Path, run: Run) -> None:
    """Whoever copies the first example gets a message out; tables survive a bar in a description."""
    assert run("--dialect", "rack.xml", "--messages", "HEARTBEAT,PAYLOAD_RACK", "--out", "lib")[0] == 0
    page = (dialect / "lib" / "README.md").read_text()
    assert "| weights | uint16[4] | g |  | 65535 in an element | Weight of each slot |" in page
    assert "$" not in page
    example = page.split("```python\n")[1].split("```")[0]
    example = example.replace("from machine import UART\n", "").replace("UART(0, 57600)", "open('sent', 'wb')")
    (dialect / "example.py").write_text(example)
    environment = os.environ | {"PYTHONPATH": str(dialect / "lib"), "PYTHONDONTWRITEBYTECODE": "1"}
    subprocess.run([sys.executable, "example.py"], env=environment, check=True, cwd=dialect)
    assert (dialect / "sent").read_bytes()[:1] == b"\xfd"


def test_a_second_run_writes_nothing(dialect: Path, run: Run) -> None:
    arguments = ("--dialect", "rack.xml", "--messages", "all", "--out", "lib")
    assert run(*arguments)[2].endswith(" files written, 0 unchanged\n")
    assert run(*arguments)[2].startswith("up to date: ")
    assert run(*arguments, "--check")[0] == 0
    (dialect / "lib" / "messages.py").write_text("# mine\n")
    code, out, _ = run(*arguments)
    assert code == 1
    assert "lib/messages.py" in out
    assert (dialect / "lib" / "messages.py").read_text() == "# mine\n"


def test_compiled_for_a_board(dialect: Path, run: Run) -> None:
    """Each architecture has its own files, without what it does not run; MicroPython loads those of this host."""
    for architecture, has_machine_code in (("armv6m", True), ("bytecode", False)):
        arguments = ("--dialect", "rack.xml", "--messages", "all", "--mpy", architecture)
        assert run(*arguments, "--out", architecture)[0] == 0
        found = files(dialect / architecture)
        assert not [path for path in found if path.endswith(".py")]
        assert {"messages.mpy", "enums.mpy", "README.md"} <= found
        assert "frames_plain.mpy" in found  # for whoever copies it to another processor
        assert ("frames_viper.mpy" in found) == has_machine_code
    assert run("--dialect", "rack.xml", "--messages", "all", "--mpy", "x64", "--out", "host")[0] == 0
    program = str(Path(sys.executable).parent / "micropython")
    (dialect / "script.py").write_text(SCRIPT)
    for folder in ("host", "bytecode"):
        environment = os.environ | {"MICROPYPATH": str(dialect / folder)}
        done = subprocess.run([program, "script.py"], env=environment, capture_output=True, text=True, check=False)
        assert (done.stdout, done.returncode) == (PRINTED, 0), done.stderr


@pytest.mark.parametrize(
    ("arguments", "code", "expected"),
    [
        (("rack.xml", "HEARTBAET,RACK,MESSAGE"), 1, ["codec-message", "HEARTBAET", "did you mean HEARTBEAT?", "RACK"]),
        (("comon", "all"), 2, ["codec-dialect", "did you mean common?"]),
        (("none.xml", "all"), 2, ["none.xml", "file-not-found"]),
        (("parts/broken.xml", "all"), 2, ["parts/broken.xml:1:", "xml-syntax"]),
        (("parts/empty.xml", "all"), 1, ["codec-empty"]),
        (("parts/long.xml", "all"), 1, ["parts/long.xml:2:1: error message-payload"]),
    ],
)
def test_what_cannot_be_made_is_said_with_its_place(
    dialect: Path, run: Run, arguments: tuple[str, str], code: int, expected: list[str]
) -> None:
    """All findings of a run, exit code 1 or 2, and no file."""
    (dialect / "parts" / "broken.xml").write_text("<mavlink>")
    (dialect / "parts" / "empty.xml").write_text("<mavlink></mavlink>")
    field = '<field type="uint64_t[32]" name="a">A</field>'
    (dialect / "parts" / "long.xml").write_text(
        f'<mavlink><messages>\n<message id="1" name="A"><description>A</description>{field}</message>\n'
        "</messages></mavlink>\n"
    )
    found, out, _ = run("--dialect", arguments[0], "--messages", arguments[1], "--out", "lib")
    assert found == code
    assert [text for text in expected if text not in out] == []
    assert not (dialect / "lib").exists()


def test_no_message_is_asked_for(run: Run) -> None:
    code, out, err = run("--dialect", "rack.xml", "--messages", " ,", "--out", "lib")
    assert (code, out) == (2, "")
    assert "names no message" in err


def test_what_mpy_cross_refuses_is_a_finding() -> None:
    """At the module, with what mpy-cross says."""
    report = Report()
    assert compiled({"lib/odd.py": "def f(:\n"}, BYTECODE, report) == {}
    (finding,) = report
    assert (finding.rule.id, finding.place.file) == ("mpy-refused", os.path.abspath("lib/odd.py"))


def test_mpy_cross_that_is_missing_is_a_finding(dialect: Path, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("codegen.emit.mpy.find_spec", lambda _: None)
    code, out, _ = run("--dialect", "rack.xml", "--messages", "all", "--out", "lib", "--mpy", "armv6m")
    assert code == 2
    assert "mpy-cross-missing" in out
    assert not (dialect / "lib").exists()


HOSTILE = """<mavlink>
  <enums>
    <enum name="E"><entry value="1" name="class"/><entry value="2" name="None"/><entry value="3" name="E_OK"/></enum>
  </enums>
  <messages>
    <message id="1" name="NONE"><description>A</description>
      <field type="uint8_t" name="a" enum="E" units='m&quot;&quot;&quot;; 1/0; &quot;&quot;&quot;'>d</field>
      <field type="uint8_t" name="b" units="\\N{x} &#10;raise SystemExit(9)">d</field>
    </message>
    <message id="2" name="_"><description>A</description><field type="uint8_t" name="a">d</field></message>
    <message id="3" name="_3D"><description>A</description><field type="uint8_t" name="a">d</field></message>
    <message id="4" name="A_B"><description>A</description><field type="uint8_t" name="a">d</field></message>
    <message id="5" name="lower_case"><description>A</description><field type="uint8_t" name="a">d</field></message>
    <message id="6" name="AB"><description>A</description><field type="uint8_t" name="a">d</field></message>
  </messages>
</mavlink>
"""


def test_no_text_of_a_dialect_becomes_code(dialect: Path, run: Run) -> None:
    """Units, names and the file's own name are other people's text; what Python cannot call so gets an underscore."""
    name = 'hostile"""\nraise SystemExit(9)\n.xml'
    (dialect / name).write_text(HOSTILE)
    assert run("--dialect", name, "--messages", "all", "--out", "lib")[0] == 0
    script = (
        "import enums, messages\n"
        "print([one.__name__ for one in messages.ALL], enums.class_, enums.None_, enums.E_OK)\n"
        "print([messages.ALL[0]().names()])\n"
    )
    (dialect / "script.py").write_text(script)
    for interpreter in ("python", "micropython"):
        program = str(Path(sys.executable).parent / interpreter)
        environment = os.environ | {"PYTHONPATH": "lib", "MICROPYPATH": "lib", "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run([program, "script.py"], env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        assert done.stdout == (
            "['None_', '_', '_3d', 'AB', 'LowerCase', 'Ab'] 1 2 3\n[['a', 'b']]\n"
        )  # fmt: skip


def test_names_are_found_in_any_case_and_all_excuses_none(dialect: Path, run: Run) -> None:
    (dialect / "hostile.xml").write_text(HOSTILE)
    for name in ("lower_case", "LOWER_CASE", "Lower_Case"):
        assert run("--dialect", "hostile.xml", "--messages", name, "--out", "lib")[0] == 0
    code, out, _ = run("--dialect", "hostile.xml", "--messages", "all,FOO", "--out", "lib")
    assert code == 1
    assert "no message FOO" in out
    assert run("--dialect", "hostile.xml", "--messages", "all", "--out", "")[0] == 2


def test_nothing_of_an_earlier_codec_is_imported(dialect: Path, run: Run) -> None:
    """MicroPython prefers sources to compiled modules, and machine code would be found before plain code."""
    assert run("--dialect", "rack.xml", "--messages", "HEARTBEAT", "--out", "lib")[0] == 0
    assert run("--dialect", "rack.xml", "--messages", "HEARTBEAT", "--out", "lib", "--bytecode")[0] == 0
    assert not (dialect / "lib" / "frames_viper.py").exists()
    assert "viper import" not in (dialect / "lib" / "frames.py").read_text()
    assert run("--dialect", "rack.xml", "--messages", "MESSAGE", "--out", "lib", "--mpy", "bytecode")[0] == 0
    assert not [path for path in files(dialect / "lib") if path.endswith(".py")]


def test_page_without_a_live_field(dialect: Path, run: Run) -> None:
    """AUTH_KEY is text only: there is nothing to be live, and so no example of it."""
    assert run("--dialect", "common", "--messages", "AUTH_KEY", "--out", "lib")[0] == 0
    assert "live" not in (dialect / "lib" / "README.md").read_text()
