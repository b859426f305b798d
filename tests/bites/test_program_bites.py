"""The checks of the program notice a fault that nothing else does: each of these makes the check beside it fail."""

import shutil
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest
from generated_suite import scripts_of
from in_process import build

ROOT = Path(__file__).resolve().parents[2]
INTERPRETERS = ("cpython", "micropython")
Suites = Callable[[str], ModuleType]

EARLIER = "storage what_an_earlier_release_has_saved_is_read"
TURN = "        running.connection.turn_to(running.station)\n"
OVER = "\n        self._reached = condition\n        self._follow()\n        if self._is_watching"
INPUTS = "health faults_of_an_input_are_told_now_and_then"

# A check, and changes of modules: what is replaced by what, both where a fault is made alike in two places.
FAULTS = [
    ("order-of-bytes-of-a-slot", EARLIER, [("storage", '"<4sHHH"', '">4sHHH"')]),
    ("order-of-bytes-of-its-checksum", EARLIER, [("storage", '"<I"', '">I"')] * 2),
    ("what-the-checksum-is-of", EARLIER, [("storage", "image)[:-_CRC_SIZE]", "image)[4:-_CRC_SIZE]")] * 2),
    ("order-of-bytes-of-a-value", EARLIER, [("parameters", 'pack("<f"', 'pack(">f"')] * 2),
    (
        "view-that-nobody-needs",
        "link views_are_kept_of_what_goes_out",
        [("streams", "_LENGTHS = ((0, 54)", "_LENGTHS = ((0, 55)")],
    ),
    ("ticks-that-start-again", INPUTS, [("adc_faults", "- told_ms & _TICKS <", "- told_ms <")]),
    ("time-between-texts", INPUTS, [("adc_faults", "const(10000)", "const(10100)")]),
    (
        "warning-that-waits-for-days",
        "health high_value_is_warned_about_at_intervals",
        [("state_plain", "now_ms - since & 0x3FFFFFFF >= 10000", "now_ms - since >= 10000")],
    ),
    ("faults-counted-again", INPUTS, [("adc_faults", "self._untold[instance] = 0", "pass")]),
    ("another-fault-that-waits", INPUTS, [("adc_faults", "and not is_first_late", "")]),
    (
        "converter-that-stays-away",
        "health a_converter_that_comes_back_is_used",
        [("adc_faults", "elif self._inputs.open(instance):", "elif False:")],
    ),
    (
        "half-a-round-of-the-ticks",
        "network a_try_waits_for_its_pause_and_no_longer",
        [("network_port", "if 0 < ahead_ms <= self.period_ms:", "if 0 < ahead_ms:")],
    ),
    (
        "password-of-another",
        "network ports_share_a_network_that_is_the_same",
        [("network_port", " and self._password == password", "")],
    ),
    (
        "answer-that-overtakes",
        "part answers_wait_for_room",
        [("connection", "if self.station.waiting or not send(argument):", "if not send(argument):")],
    ),
    (
        "number-told-again",
        "part what_is_left_out_is_told_once",
        [("connection", "            self._budget[1] = 0\n", "")],
    ),
    (
        "rate-lost-with-any-parameter",
        "part what_was_asked_for_holds_while_its_parameter_does",
        [("streams", "        self._steps = steps\n", "")],
    ),
    (
        "first-station-for-ever",
        "service ground_stations_are_noted",
        [("services", "self.ground_station = (name >> 8", "self.ground_station = self.ground_station or (name >> 8")],
    ),
]
# The same of other projects.
FAULTS_OF_BOATS = [
    (
        "progress-for-another-station",
        "command progress_is_for_who_asked",
        [("long_commands", f"{TURN}        self._send", "        self._send")],
    ),
    (
        "end-for-another-station",
        "command progress_is_for_who_asked",
        [("long_commands", f"{TURN}        running.connection.deliver", "        running.connection.deliver")],
    ),
    (
        "progress-of-what-is-over",
        "command progress_is_told",
        [("long_commands", f"        running.progress = 0\n{TURN}", TURN)],
    ),
    (
        "level-that-is-not-over",
        "watched a_level_stays_or_is_over",
        [("failsafe", f"self._rows[_UP] = level{OVER}", f"level{OVER}")],
    ),
    (
        "threshold-that-stays-away",
        "watched a_level_stays_or_is_over",
        [("failsafe", "        self._follow()\n        if self._is_watching", "        if self._is_watching")],
    ),
    (
        "stations-of-the-first-link",
        "watched a_station_on_any_link_is_heard",
        [("failsafe", "for index in range(len(connections)):", "for index in range(1):")],
    ),
]
FAULTS_OF_ACCESS = [
    (
        "timestamps-of-another-way",
        "access each_sender_counts_for_itself",
        [("signing", "stream = (frame[end], ", "stream = (0, ")],
    ),
    (
        "timestamps-of-another-component",
        "access each_sender_counts_for_itself",
        [("signing", "frame[5], frame[6])", "frame[5], 0)")],
    ),
    (
        "clock-that-is-behind",
        "access who_is_ahead_is_followed",
        [("signing", "        self.timestamp = max(self.timestamp, timestamp)\n", "")],
    ),
    (
        "key-that-comes-again",
        "access a_key_that_comes_again_takes_nothing_back",
        [("signing", "max(self.timestamp, min(timestamp, LATEST))", "min(timestamp, LATEST)")],
    ),
    (
        "start-without-a-gap",
        "access timestamps_go_on_after_a_restart",
        [("signing", '"little") + MINUTE', '"little")')],
    ),
    (
        "heartbeats-without-a-key",
        "access unsigned_frames_are_not_obeyed",
        [("signing", "RADIO_STATUS = 109", "RADIO_STATUS = 0")],
    ),
]
FAULTS_OF_PACKS = [
    (
        "chip-that-is-cut",
        "twin what_is_watched_is_what_goes_out",
        [("vehicle", "((370, 21, 16, 18)", "((370, 21, 15, 18)")],
    ),
    (
        "number-of-another",
        "twin what_is_watched_is_what_goes_out",
        [("vehicle", "self.parameters.batt_id + 1)", "self.parameters.batt_id + 2)")],
    ),
    (
        "saves-without-a-limit",
        "part a_minute_is_worth_a_save",
        [("vehicle", "min(self._credit_ms + _SAVE_MS, _CREDIT_MS)", "self._credit_ms + _SAVE_MS")],
    ),
]
FAULTS_OF_TCP = [
    (
        "end-of-another-frame",
        "tcp frames_go_out_whole_and_in_turn",
        [("tcp_peer", "self._unsent = bytes(frame[count:])", "self._unsent = frame[count:]")],
    ),
    (
        "end-that-is-lost",
        "tcp frames_go_out_whole_and_in_turn",
        [("tcp_peer", "self._unsent = bytes(frame[count:])", "pass")],
    ),
    (
        "time-that-nothing-was-taken",
        "tcp what_lasts_too_long_ends_a_connection",
        [("tcp_peer", "            self._full_ms = None\n", "            pass\n")],
    ),
    (
        "silence",
        "tcp what_lasts_too_long_ends_a_connection",
        [("tcp_peer", "if ticks_diff(now_ms, self.heard_ms) >= timeout_ms:", "if False:")],
    ),
    (
        "time-of-another-beginning",
        "tcp a_beginning_is_given_up_once_its_end_does_not_come",
        [("tcp_peer", "            self._kept_ms = None  # it is another one\n", "            pass\n")],
    ),
    (
        "first-peer-alone",
        "tcp who_was_read_waits_for_the_others",
        [
            (
                "tcp_port",
                "            self.peers.append(peer)\n            if",
                "            self.peers.insert(0, peer)\n            if",
            )
        ],
    ),
    (
        "station-that-is-told-nothing",
        "tcp each_peer_is_a_station_of_its_own",
        [("tcp_stations", "        station.streams.connect()\n", "")],
    ),
    (
        "pauses-that-stay-short",
        "tcp pauses_become_longer_until_somebody_is_heard",
        [("tcp_client", "min(2 * self._retry.period_ms", "min(self._retry.period_ms")],
    ),
    (
        "pauses-without-an-end",
        "tcp pauses_become_longer_until_somebody_is_heard",
        [("tcp_client", "_LONGEST_PAUSE = const(16)", "_LONGEST_PAUSE = const(64)")],
    ),
    (
        "pauses-that-stay-long",
        "tcp pauses_become_longer_until_somebody_is_heard",
        [("tcp_client", "            self._retry.period_ms = self._retry_ms\n", "            pass\n")],
    ),
    (
        "try-without-an-end",
        "tcp a_try_without_an_answer_ends",
        [("tcp_client", "if ticks_diff(now_ms, self._began_ms) >= self._timeout_ms:", "if False:")],
    ),
    (
        "beginning-of-another-try",
        "tcp a_try_without_an_answer_ends",
        [("tcp_client", "            self._began_ms = now_ms\n", "")],
    ),
]
EVERY = [
    *(("rover", *fault) for fault in FAULTS),
    *(("boat", *fault) for fault in FAULTS_OF_BOATS),
    *(("guarded", *fault) for fault in FAULTS_OF_ACCESS),
    *(("smart_battery", *fault) for fault in FAULTS_OF_PACKS),
    *(("networked", *fault) for fault in FAULTS_OF_TCP),
]


@pytest.fixture(scope="module")
def suites(tmp_path_factory: pytest.TempPathFactory) -> Suites:
    """Return a call for what runs the scripts of a program's suite: the committed one, or that of a project."""
    made = {
        "rover": scripts_of(ROOT / "generated" / "tests"),
        "smart_battery": scripts_of(ROOT / "generated" / "smart_battery" / "tests"),
    }

    def by(program: str) -> ModuleType:
        if program not in made:
            folder = ROOT / ("examples" if program == "boat" else "tests/projects") / program
            copy = tmp_path_factory.mktemp("bites") / program
            shutil.copytree(folder, copy, ignore=shutil.ignore_patterns("generated", "tests"))
            build(copy)
            made[program] = scripts_of(copy / "generated" / "tests")
        return made[program]

    return by


def found(scripts: ModuleType, interpreter: str, *checks: str) -> list[str]:
    """Return what checks print, in their order: a name each, and what went wrong or null."""
    printed: str = scripts.run_under(interpreter, "checks_run.py", "0", *checks)
    return printed.splitlines()


@pytest.mark.parametrize("interpreter", INTERPRETERS)
@pytest.mark.parametrize("program", ["rover", "smart_battery", "boat", "guarded", "networked"])
def test_none_fails_as_it_is(program: str, interpreter: str, suites: Suites) -> None:
    """What fails below fails because of the fault."""
    checks = sorted({fault[2] for fault in EVERY if fault[0] == program})
    said = found(suites(program), interpreter, *checks)
    assert len(said) == len(checks)
    assert [line for line in said if not line.endswith(", null]")] == []


@pytest.mark.parametrize(
    ("program", "check", "changes"), [pytest.param(fault[0], *fault[2:], id=fault[1]) for fault in EVERY]
)
def test_fault_is_noticed(
    program: str,
    check: str,
    changes: list[tuple[str, str, str]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    suites: Suites,
) -> None:
    """By the check that is about it."""
    scripts = suites(program)
    for module, old, new in changes:
        changed = tmp_path / f"{module}.py"
        text = (changed if changed.exists() else scripts.path_of("firmware", changed.name)).read_text()
        assert old in text, f"{old!r} is not in {module}"
        changed.write_text(text.replace(old, new, 1))
    monkeypatch.setattr(scripts, "PATHS", [str(tmp_path), *scripts.PATHS])
    (said,) = found(scripts, "cpython", check)
    assert "Error" in said
