"""What was accepted of a specification, and could not be meant: each is told at its place, with what to write.

A case changes files of a project: ``old`` becomes ``new``, in which ``§`` marks the place of the finding.
"""

import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
BOAT = "examples/boat"
VEHICLE, PARAMETERS, BOARD, STATE = "vehicle.yaml", "parameters.yaml", "board.yaml", "state.yaml"
TIMEOUT = "unit: s, default: 5, min: 2, max: 120, step: 1"
WIFI = "udp: 14550, to: 255.255.255.255, credentials: wifi.json, retry: 5 s"
OUTPUTS = (
    "message: ACTUATOR_OUTPUT_STATUS\nrequirement: FR-2.1\nstream: POSITION\nsend: while_known\n"
    "fields: {time_usec: {clock: §unix}, active: {constant: 0}, actuator: unknown}\n"
)
UNKNOWN_LOAD = (
    "failsafes:\n  busy:\n    watches: vehicle.load\n    levels: {lost: {unknown: §true, after: 5 s}}\n"
    "    arming: false\n    requirement: FR-4.2\n"
)
SILENT = "after: FS_GCS_TIMEOUT, action: come_back"


@dataclass(frozen=True)
class Change:
    """A text of a file, and what takes its place; none is a new file."""

    file: str
    old: str
    new: str


@dataclass(frozen=True)
class Case:
    """Changes of a project with the finding that they lead to, alone."""

    rule: str
    says: str
    hint: str
    changes: tuple[Change, ...]
    project: str = BOAT
    is_error: bool = True


def case(rule: str, says: str, hint: str, *changes: tuple[str, str, str], at: str = BOAT, error: bool = True) -> Case:
    """A case with its changes as tuples."""
    return Case(rule, says, hint, tuple(Change(*each) for each in changes), at, error)


def warns(rule: str, says: str, hint: str, *changes: tuple[str, str, str], at: str = BOAT) -> Case:
    """The same of a warning."""
    return case(rule, says, hint, *changes, at=at, error=False)


CASES = {
    # the time from which a new value of a parameter counts
    "stream_after_restart": case(
        "bad-stream",
        "SR0_EXTRA1 is used only after a restart, but a stream follows it at once",
        "take reboot: true out at SR0_EXTRA1",
        (PARAMETERS, "max: 20, step: 1, requirement: FR-2.3", "max: 20, step: 1, reboot: true, requirement: FR-2.3"),
        ("streams.yaml", "parameter: SR0_EXTRA1", "parameter: §SR0_EXTRA1"),
    ),
    "threshold_after_restart": case(
        "bad-failsafe",
        "SHALLOW is used only after a restart, but a failsafe follows it at once",
        "take reboot: true out at SHALLOW",
        (PARAMETERS, "step: 0.01, requirement: FR-4.1", "step: 0.01, reboot: true, requirement: FR-4.1"),
        (VEHICLE, "below: SHALLOW", "below: §SHALLOW"),
    ),
    "switch_after_restart": case(
        "bad-failsafe",
        "FS_GCS_ENABLE is used only after a restart",
        "take reboot: true out at FS_GCS_ENABLE",
        (PARAMETERS, 'values: {0: "Off", 1: "On"}', 'values: {0: "Off", 1: "On"}\n    reboot: true'),
        (VEHICLE, "enabled_by: FS_GCS_ENABLE", "enabled_by: §FS_GCS_ENABLE"),
    ),
    "system_id_at_once": case(
        "bad-project",
        "SYSID_THISMAV is looked at when the board starts",
        "SYSID_THISMAV: reboot: true",
        (PARAMETERS, "step: 1, reboot: true", "step: 1"),
        (VEHICLE, "system_id: SYSID", "system_id: §SYSID"),
    ),
    "system_id_in_metres": case(
        "bad-project",
        "SYSID_THISMAV is in m, and a system id is a number without a unit",
        "take unit: m out at SYSID_THISMAV",
        (PARAMETERS, "type: int16, default: 1", "type: int16, unit: m, default: 1"),
        (VEHICLE, "system_id: SYSID", "system_id: §SYSID"),
    ),
    "pin_at_once": case(
        "bad-adc",
        "LEFT_PIN is looked at when the board starts",
        "LEFT_PIN: reboot: true",
        (PARAMETERS, "max: 28, step: 1, reboot: true", "max: 28, step: 1"),
        (BOARD, "pin: LEFT_PIN", "pin: §LEFT_PIN"),
        at="tests/projects/two_batteries",
    ),
    "pin_in_volts": case(
        "bad-adc",
        "LEFT_PIN is in V, and a pin is a number without a unit",
        "take unit: V out at LEFT_PIN",
        (PARAMETERS, "type: uint8, default: 27", "type: uint8, unit: V, default: 27"),
        (BOARD, "pin: LEFT_PIN", "pin: §LEFT_PIN"),
        at="tests/projects/two_batteries",
    ),
    "no_such_reading": case(
        "bad-adc",
        "no mean takes 1000 s, so that nothing would be told of one that takes too long",
        "2 ms, up to 1 s",
        (BOARD, "limit: 2 ms", "limit: §1000 s"),
        at="tests/projects/power_monitor",
    ),
    # values of parameters
    "two_meanings": case(
        "bad-parameter",
        "1.50 of SHALLOW means 'a' already, and nobody could tell which it is",
        "keep one of them",
        (PARAMETERS, "max: 20, step: 0.01, ", "max: 20, step: 0.01, values: {1.5: a, 1.50: §b}, "),
    ),
    "no_such_unit": case(
        "bad-parameter",
        "of what OLD was, SHALLOW would take over 0 alone: no unit is 1e+30 of another",
        "was: {OLD: 1}, if a number means the same",
        (PARAMETERS, "max: 20, step: 0.01, ", "max: 20, step: 0.01, was: {OLD: §1e30}, "),
    ),
    "no_such_small_unit": case(
        "bad-parameter",
        "of what OLD was, SHALLOW would take over 0 alone: no unit is 1e-10 of another",
        "was: {OLD: 1}, if a number means the same",
        (PARAMETERS, "max: 20, step: 0.01, ", "max: 20, step: 0.01, was: {OLD: §-1e-10}, "),
    ),
    # links
    "one_local_port": case(
        "bad-link",
        "local_port of wifi is UDP port 14550 of the vehicle, which b takes already",
        "take another one",
        (
            BOARD,
            "links:\n",
            "links:\n  b: {udp: 1, local_port: 14550, to: 10.0.0.1, credentials: wifi.json, retry: 5 s}\n",
        ),
        (BOARD, WIFI, f"{WIFI}, local_port: §14550"),
    ),
    "other_credentials": case(
        "bad-link",
        "credentials of wifi are other.json, and wifi.json has those of the one Wi-Fi there is",
        "credentials: wifi.json; under the name of a link",
        (BOARD, "links:\n", "links:\n  b: {udp: 1, to: 10.0.0.1, credentials: wifi.json, retry: 5 s}\n"),
        (BOARD, WIFI, WIFI.replace("wifi.json", "§other.json")),
    ),
    **{
        f"address_{written}": case(
            "bad-link", f"{written} is {says}", "to: ", (BOARD, WIFI, WIFI.replace("255.255.255.255", f"§{written}"))
        )
        for written, says in (
            ("300.1.1.1", "no address: 300 is more than 255"),
            ("0.0.0.0", "the address of no station"),  # noqa: S104
            ("010.0.0.1", "read as another address where a number with 0 in front is octal"),
            ("240.0.0.1", "the address of no station"),
            ("\u0663.1.1.1", "not an address"),
        )
    },
    "connection_to_a_group": case(
        "bad-link",
        "224.0.0.1 is a group, and a TCP connection goes to one station",
        "to: 192.168.4.2",
        (BOARD, WIFI, WIFI.replace("udp:", "tcp_client:").replace("255.255.255.255", "§224.0.0.1") + ", timeout: 9 s"),
    ),
    # fields of messages
    "unix_since_boot": case(
        "other-clock",
        "ATTITUDE.time_boot_ms counts from the start, as its name says, and clock: unix from 1970",
        "write {clock: boot}",
        ("messages/attitude.yaml", "{clock: boot}", "{clock: §unix}"),
    ),
    "boot_since_1970": case(
        "other-clock",
        "SYSTEM_TIME.time_unix_usec counts from 1970, as its name says, and clock: boot from the start",
        "write {clock: unix}",
        ("messages/system_time.yaml", "send: while_known\n", ""),
        ("messages/system_time.yaml", "time_unix_usec: {clock: unix}", "time_unix_usec: {clock: §boot}"),
    ),
    "unix_by_words": warns(
        "other-clock-in-words",
        "ACTUATOR_OUTPUT_STATUS.time_usec is 'Timestamp (since system boot)', and clock: unix counts from 1970",
        "write {clock: boot}",
        ("messages/outputs.yaml", "", OUTPUTS),
    ),
    "moving_instance": warns(
        "instance-that-changes",
        "DISTANCE_SENSOR.id tells instances apart, and vehicle.mode can become another number",
        "write one number, such as {constant: 0}",
        ("messages/distance_sensor.yaml", "  id: {constant: 1}", "  id: {state: §vehicle.mode}"),
    ),
    # the program
    "empty_text": case(
        "bad-failsafe",
        "an empty text goes to every ground station, and tells none what has happened",
        "leave it out: without it a text says what is watched",
        (VEHICLE, "text: The ground is not seen", 'text: §""'),
    ),
    "empty_over": case(
        "bad-failsafe",
        "an empty text goes to every ground station",
        "leave it out",
        (VEHICLE, "over: The ground is seen again", 'over: §" "'),
    ),
    "empty_title": case(
        "bad-failsafe", "'' names nothing", "leave it out", (VEHICLE, "  echo:\n", '  echo:\n    title: §""\n')
    ),
    "twice_in_base": case(
        "bad-mode",
        "steered is listed twice",
        "leave out the second one",
        (VEHICLE, "base: [steered]", "base: [steered, §steered]"),
    ),
    "station_twice": case(
        "bad-access",
        "255 is listed twice",
        "leave out the second one",
        (VEHICLE, "stations: [255, 254]", "stations: [255, §255]"),
        at="tests/projects/guarded",
    ),
    "setup_twice": case(
        "bad-access",
        "cable is listed twice",
        "leave out the second one",
        (VEHICLE, "setup: [cable]", "setup: [cable, §cable]"),
        at="tests/projects/guarded",
    ),
    "no_such_step": case(
        "bad-program",
        "no step of a save takes 10 s: to erase flash takes 0.4 s at most",
        "step_limit: 10 ms, up to 1 s",
        (VEHICLE, "step_limit: 10 ms", "step_limit: §10 s"),
    ),
    "flood_of_texts": case(
        "bad-program",
        "1 ms is more than ten texts a second, which miss slots themselves",
        "report_every: 10 s",
        (VEHICLE, "report_every: 10 s", "report_every: §1 ms"),
    ),
    "load_unknown": warns(
        "known-for-ever",
        "vehicle.load is never unknown: the program keeps it from the start on",
        "leave ",
        (VEHICLE, "failsafes:\n", UNKNOWN_LOAD),
    ),
    # silence of ground stations
    "silent_between_two": case(
        "silence-between-heartbeats",
        "ground_station waits for a silence of 0.01 s, and HEARTBEATs come once a second",
        "after: 5 s",
        (VEHICLE, SILENT, "after: §10 ms, action: come_back"),
    ),
    "silent_at_once": case(
        "silence-between-heartbeats",
        "ground_station waits for a silence of 0 s",
        "after: 5 s",
        (VEHICLE, SILENT, "after: §0 s, action: come_back"),
    ),
    "silent_by_default": case(
        "silence-between-heartbeats",
        "ground_station waits for a silence of 1 s, the default of FS_GCS_TIMEOUT, and HEARTBEATs",
        "default: 5 at FS_GCS_TIMEOUT",
        (PARAMETERS, TIMEOUT, "unit: s, default: 1, min: 1, max: 120, step: 1"),
        (VEHICLE, SILENT, "after: §FS_GCS_TIMEOUT, action: come_back"),
    ),
    "silent_soon": warns(
        "silence-of-one-heartbeat",
        "ground_station waits for a silence of 1.5 s",
        "after: 5 s",
        (VEHICLE, SILENT, "after: §1.5 s, action: come_back"),
    ),
    "silent_where_set": warns(
        "silence-of-one-heartbeat",
        "ground_station waits for a silence of 1 s where FS_GCS_TIMEOUT is set to its least",
        "min: 2 at FS_GCS_TIMEOUT",
        (PARAMETERS, TIMEOUT, "unit: s, default: 5, min: 1, max: 120, step: 1"),
        (VEHICLE, SILENT, "after: §FS_GCS_TIMEOUT, action: come_back"),
    ),
    "stations_gone": case(
        "silence-between-heartbeats",
        "a ground station is gone after a silence of 0.1 s",
        "silence: 10 s",
        (VEHICLE, "fastest: 20 Hz}", "fastest: 20 Hz, silence: §0.1 s}"),
    ),
    "stations_gone_soon": warns(
        "silence-of-one-heartbeat",
        "a ground station is gone after a silence of 1.9 s",
        "silence: 10 s",
        (VEHICLE, "fastest: 20 Hz}", "fastest: 20 Hz, silence: §1.9 s}"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_is_told_at_its_place(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The rule, the place, the words and the hint are right; of errors there is no other."""
    one = CASES[name]
    specs = Path(shutil.copytree(ROOT / one.project / "specs", tmp_path / "specs"))
    place = ""
    for change in one.changes:
        path = specs / change.file
        text = path.read_text() if change.old else ""
        assert change.old in text
        text = text.replace(change.old, change.new, 1)
        before, mark, _ = text.partition("§")
        path.write_text(text.replace("§", ""))
        if mark:
            place = f"{change.file}:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}: "
    assert main(["check", "--project", str(specs / "codegen.yaml")]) == int(one.is_error)
    printed = capsys.readouterr().out
    lines = printed.splitlines()
    severity = "error" if one.is_error else "warning"
    wanted = f"{place}{severity} {one.rule}: {one.says}"
    found = [index for index, line in enumerate(lines) if wanted in line]
    assert len(found) == 1, printed
    assert any(one.hint in line for line in lines[found[0] + 1 : found[0] + 4] if " hint: " in line), printed
    assert sum(": error " in line for line in lines) == int(one.is_error), printed
