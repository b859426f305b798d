"""Several tables of one message, each with a name of its own: what every stage makes of the names."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from edited_project import system_of
from in_process import build

from codegen.commands.trace import read_trace
from codegen.diagnostics import Report
from codegen.diff.change import Change
from codegen.diff.system.system import compare_systems
from codegen.explain.story import explain
from codegen.importing.existing import senders
from codegen.model.system import System
from codegen.project.systems import read_systems

POSITION = "messages/global_position_int.yaml"
PROJECT = Path(__file__).resolve().parents[1] / "projects" / "named_tables" / "specs"


@pytest.fixture(scope="module")
def system() -> System:
    """The project as it is."""
    report = Report()
    system = system_of(PROJECT, report)
    assert not list(report)
    return system


def findings(folder: Path, file: str, old: str, new: str) -> list[tuple[str, int, str]]:
    """Rule, line and file of what is reported after one change."""
    path = folder / file
    assert path.read_text().count(old) == 1
    path.write_text(path.read_text().replace(old, new))
    report = Report()
    read_systems(str(folder / "codegen.yaml"), report)
    return [(found.rule.id, found.place.line, Path(found.place.file).name) for found in report]


@pytest.mark.parametrize(
    ("name", "rule"),
    [
        ("stern", "duplicate-table"),
        ("Bow", "bad-table-name"),
        ("2nd", "bad-table-name"),
        ("bow-1", "bad-table-name"),
        ("attitude", "bad-table-name"),
        ("gps_raw_int", "bad-table-name"),
        ("gps", "bad-table-name"),
    ],
)
def test_a_name_that_cannot_be_is_reported_at_its_line(name: str, rule: str, folder: Path) -> None:
    """Another table's, none of Python's, that of a message or of a component; where two have one, at the later file."""
    file = "stern.yaml" if rule == "duplicate-table" else "bow.yaml"
    assert findings(folder, "messages/bow.yaml", "as: bow", f"as: {name}") == [(rule, 2, file)]


def test_the_name_of_a_stream_is_taken(folder: Path) -> None:
    """Explain and reports call both by their names."""
    for file in ("streams.yaml", "messages/bow.yaml", "messages/stern.yaml", "messages/log_speed.yaml", POSITION):
        old = "  POSITION:" if file == "streams.yaml" else "stream: POSITION"
        path = folder / file
        path.write_text(path.read_text().replace(old, old.replace("POSITION", "position")))
    assert findings(folder, "messages/bow.yaml", "as: bow", "as: position") == [("bad-table-name", 2, "bow.yaml")]


def test_without_a_name_two_tables_of_a_message_are_one_too_many(folder: Path) -> None:
    """One may go without; the second one is the fault."""
    assert findings(folder, "messages/bow.yaml", "as: bow\n", "") == []
    assert findings(folder, "messages/stern.yaml", "as: stern\n", "") == [("duplicate-table", 1, "stern.yaml")]


def test_a_generation_has_no_message_of_several_tables(folder: Path) -> None:
    """A receiver of such a message could not tell which generation it is of."""
    streams = folder / "streams.yaml"
    streams.write_text(streams.read_text() + "generations:\n  gps: {doc: d, old: [bow], new: [stern], send: both}\n")
    found = findings(folder, "board.yaml", "pico_2", "pico")
    assert [rule for rule, _, _ in found if rule == "bad-generations"] == ["bad-generations"] * 2


def test_explain_tells_all_tables_of_a_message_and_one_by_its_name(system: System) -> None:
    """Fields, too."""
    report = Report()
    both, one = explain("GPS_RAW_INT", system, report), explain("stern", system, report)
    assert both is not None
    assert one is not None
    assert [line for line in both.splitlines() if "CRC_EXTRA" in line] == [
        "bow: GPS_RAW_INT (24), CRC_EXTRA 24, payload 30 bytes, 52 with extensions",
        "stern: GPS_RAW_INT (24), CRC_EXTRA 24, payload 30 bytes, 52 with extensions",
    ]
    assert both.endswith(one)
    assert "bow:" not in one
    field = explain("stern.lon", system, report)
    assert field is not None
    assert field.startswith("stern.lon\n")
    fields = explain("gps_raw_int.lon", system, report)
    assert fields is not None
    assert fields.startswith("bow.lon\n")
    assert fields.endswith(field)
    assert not list(report)


def changes(old: System, new: System) -> dict[str, Change]:
    return {f"{change.rule.id} {change.subject}": change for change in compare_systems((old,), (new,)).changes}


def test_a_change_is_told_by_the_table(system: System, folder: Path) -> None:
    """Not by the message, of which the other table has not changed; it is one of the message all the same."""
    assert findings(folder, "messages/stern.yaml", "lon: {constant: 0}", "lon: {constant: 7}") == []
    found = changes(system, system_of(folder, Report()))
    assert list(found) == ["population-constant-changed stern.lon"]
    assert found["population-constant-changed stern.lon"].messages == ("GPS_RAW_INT",)


def test_a_renamed_table_is_no_message_that_comes_and_goes(system: System, folder: Path) -> None:
    """Other changes are told by its new name; a second table of a message has come."""
    assert findings(folder, "messages/stern.yaml", "lon: {constant: 0}", "lon: {constant: 7}") == []
    assert findings(folder, "messages/stern.yaml", "as: stern", "as: aft") == []
    other = system_of(folder, Report())
    for old, new, name in ((system, other, "aft"), (other, system, "stern")):
        assert set(changes(old, new)) == {f"table-renamed {name}", f"population-constant-changed {name}.lon"}
    (folder / "messages" / "stern.yaml").unlink()
    alone = system_of(folder, Report())
    assert "message-sent aft" in changes(alone, other)
    assert "message-no-longer-sent aft" in changes(other, alone)


def test_the_trace_has_rows_by_table(system: System) -> None:
    """With the symbols and the tests of that table only."""
    trace = read_trace((system,), Report())
    row = next(row for row in trace.rows if row.name == "stern")
    assert {symbol.name for symbol in row.symbols} == {"GpsRawInt", "build_stern"}
    assert {test.about for test in trace.tests if test.about} >= {"bow", "stern", "depth", "log_speed"}


def test_a_document_is_compared_with_the_table_that_cites_it(system: System) -> None:
    """Or with all of them, of which the nearest one counts."""
    cited = system.messages[1].citation.requirement.place.file
    (gps,) = senders("GPS_RAW_INT", (system,), cited)
    (heartbeat,) = senders("HEARTBEAT", (system,), "elsewhere.md")
    assert [table.name for table in gps.tables] == ["bow", "stern"]
    assert [table.name for table in heartbeat.tables] == ["HEARTBEAT"]
    assert senders("ATTITUDE", (system,), cited) == ()


def test_a_program_lists_its_tables_by_name(folder: Path) -> None:
    """The name of the message says which there are."""
    (folder / "small").mkdir()
    project = folder / "codegen.yaml"
    project.write_text(project.read_text() + "programs: {small: small/codegen.yaml}\n")
    program = folder / "small" / "codegen.yaml"
    program.write_text("base: ..\nproject: small\nmessages: [HEARTBEAT, stern]\n")
    report = Report()
    _, small = read_systems(str(project), report)
    assert [message.name for message in small.messages] == ["HEARTBEAT", "stern"], list(report)
    program.write_text(program.read_text().replace("stern", "GPS_RAW_INT"))
    report = Report()
    read_systems(str(project), report)
    assert [(found.rule.id, found.hint) for found in report if found.rule.id == "no-table"] == [
        ("no-table", "its tables have names: bow, stern")
    ]


def test_requests_reach_all_tables_of_a_message(tmp_path: Path) -> None:
    """Once each, in the interval that is asked for, all off; and the interval that is told is the shortest one."""
    shutil.copytree(PROJECT, tmp_path / "specs")
    build(tmp_path)
    script = """
import mock_time
mock_time.install()
from mavlink import Link
from state import SystemState
import streams as streams_module
from streams import Streams

class Sent:
    ids = []
    def write(self, data):
        self.ids.append((data[7] | data[8] << 8 | data[9] << 16, bytes(data)))
        return len(data)

sent = Sent()
state = SystemState(log=print)
streams = Streams(state, Link(sent))
assert streams.send(24) and not sent.ids  # both are withheld
state.gps.altitude_mm = 5
assert streams.send(24) and [number for number, _ in sent.ids] == [24, 24]
assert sent.ids[0][1][10:40] != sent.ids[1][1][10:40]  # each is its own table
assert not streams.send(30) and streams.interval_us(30) == 0 and not streams.set_interval(30, 1000)
assert not streams.set_interval(24, -2)
assert streams.interval_us(24) == 1000000
streams._set_interval(streams_module._IDS.index(24), 250000)  # one of them alone, which no request does
assert streams.interval_us(24) == 250000
streams._set_interval(streams_module._IDS.index(24), -1)
assert streams.interval_us(24) == 1000000
assert streams.set_interval(24, 200000) and streams.interval_us(24) == 200000
bow = streams_module._IDS.index(24)
assert streams._interval_us[bow] == streams._interval_us[bow + 1] == 200000
assert streams.set_interval(24, -1) and streams.interval_us(24) == -1
"""
    path = f"{tmp_path}/generated/firmware:{tmp_path}/generated/mocks"
    for program, variable in ((sys.executable, "PYTHONPATH"), ("micropython", "MICROPYPATH")):
        command = [program if program == sys.executable else Path(sys.executable).with_name(program), "-c", script]
        done = subprocess.run(command, env={variable: f"{path}:.frozen"}, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
