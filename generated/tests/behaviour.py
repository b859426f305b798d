# Generated from specs/board.yaml, specs/codegen.yaml, specs/dialects/battery_cell_voltages_rfc_0018.xml,
#   specs/dialects/battery_info_upstream.xml, specs/dialects/battery_upstream.xml,
#   specs/dialects/corrections_rfc_0018.yaml, specs/dialects/protocol_version.xml,
#   specs/dialects/upstream.xml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_cell_faults_rfc_0018.yaml,
#   specs/messages/battery_cell_voltages.yaml, specs/messages/battery_info.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/battery_status_v2_rfc_0018.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/protocol_version.yaml, specs/messages/smart_battery_info.yaml,
#   specs/messages/sys_status.yaml, specs/parameters.yaml, specs/receiver.yaml,
#   specs/state.yaml, specs/streams.yaml, specs/vehicle.yaml, dialect common: do not edit.
# Inputs: 3e8b26d225944fc5
"""Checks of the board and the state that need more than one step, run as they are on every interpreter.

As a program it prints one JSON object: what went wrong in each check, or null. Its arguments are the names of the
checks to run; without any, all are.
"""

import sys

import mock_time

mock_time.install()

import time  # noqa: E402  this is the clock of the mocks now, on CPython in part

from mavlink import Link  # noqa: E402  the clock has to be in place before the firmware looks at it
from mock_board import MockBoard, scenario  # noqa: E402
from parameters import Parameters  # noqa: E402
from state import SystemState  # noqa: E402
from streams import Streams  # noqa: E402
from telling import tell  # noqa: E402

import single_readings  # noqa: E402
import telemetry  # noqa: E402

try:
    from micropython import heap_lock, heap_unlock
except ImportError:  # CPython collects by counting references: there is no heap to lock

    def heap_lock():
        pass

    def heap_unlock():
        pass


try:
    from micropython import mem_total  # bytes that were ever allocated, also those that are free again
except ImportError:  # CPython, and boards: only MicroPython on a host counts them

    def mem_total():
        return 0


HALF_TURN_MS = 1 << 29  # what is half a turn of ticks_ms() away lies ahead, as for ticks_diff()


class Log:
    """Keeps what was logged: warnings and errors in `lines`, what is only told in `notes`."""

    def __init__(self):
        self.lines = []
        self.notes = []

    def __call__(self, *words):
        line = " ".join(str(word) for word in words)
        (self.lines if line.startswith(("warning", "error")) else self.notes).append(line)


def known(state):
    """Return the state with a value in everything that a message is withheld for while it is unknown."""
    return state


def make_messages(state):
    """Let the messages that builders return be made: that happens once."""
    for build in STEADY:
        build(state)


def told(value):
    """Return a value as it is now; of a list its values."""
    return list(value) if hasattr(value, "__len__") and not isinstance(value, str) else value


def sent(link, message):
    """Send a message, unless it is withheld."""
    if message is not None:
        link.send(message)


class Sink:
    """A stream that takes everything and keeps nothing."""

    def write(self, data):
        return len(data)


class Recorder:
    """A stream that counts the MAVLink 2 frames that it takes, by their ids."""

    def __init__(self):
        self.counts = {}

    def write(self, data):
        number = data[7] | data[8] << 8 | data[9] << 16
        self.counts[number] = self.counts.get(number, 0) + 1
        return len(data)

    def total(self):
        """Return how many there were."""
        return sum(self.counts.values())


def fresh(count, name="adc"):
    """Return a board that reads this count at one input, a state, and the log of both."""
    log = Log()
    board = MockBoard(log=log)
    getattr(board, f"set_{name}_value")(count)
    return board, known(SystemState(log=log)), log


def battery_mean():
    board, _, _ = fresh(0)
    low = 1021
    counts = [low] * 4 + [low + 4]  # the mean is nearer to low + 1
    board.set_adc_waveform([count << 0 for count in counts])
    assert board.read_battery_adc() == low + 1
    counts = [low] * 4 + [low + 1]  # the mean is nearer to low
    board.set_adc_waveform([count << 0 for count in counts])
    assert board.read_battery_adc() == low + 0


def battery_full_scale():
    board, _, _ = fresh(4095)
    assert board.read_battery_adc() == 4095


def battery_failed_reading_keeps_the_last_value():
    board, state, log = fresh(3063)
    state.update_battery(board)
    before = state.battery[0].voltage_mv
    assert before is not None
    board.set_adc_value(1021)
    board.fail_adc(1)
    state.update_battery(board)
    assert state.battery[0].voltage_mv == before
    assert board.battery_inputs.figures()[0] == 1
    assert len(log.lines) == 1, log.lines
    board.fail_adc(1)
    assert board.read_battery_adc() == -1
    assert len(log.lines) == 1, log.lines
    state.update_battery(board)
    assert state.battery[0].voltage_mv < before
    assert board.battery_inputs.figures()[0] == 0


def battery_repeated_failures_make_it_unknown():
    board, state, log = fresh(3063)
    state.update_battery(board)
    board.fail_adc(5)
    for failures in range(1, 6):
        assert state.battery[0].voltage_mv is not None
        state.update_battery(board)
        assert board.battery_inputs.figures()[0] == failures
    assert state.battery[0].voltage_mv is None
    assert len(log.lines) == 1, log.lines
    state.update_battery(board)
    assert state.battery[0].voltage_mv is not None


def battery_absent_converter_is_no_reason_to_stop():
    log = Log()
    board = MockBoard(log=log, absent=True)
    state = SystemState(log=log)
    for _ in range(10):
        state.update_battery(board)
    assert state.battery[0].voltage_mv is None
    assert "warning" in log.lines[0], log.lines


class BatteryOddity:
    """A board that returns, or raises, what no board should."""

    def __init__(self, result):
        self.result = result
        self.asked = 0

    def read_battery_adc(self, _instance):
        self.asked += 1
        if isinstance(self.result, BaseException):
            raise self.result
        return self.result


def asked_of_battery(state):
    """Return how many the board is asked about: those that are neither off nor set by code."""
    asked = 0
    names = ("batt_monitor", "batt2_monitor")
    for instance in range(2):
        if getattr(state.parameters, names[instance]) != 29:
            asked += state.battery[instance].monitored
    return asked


def battery_broken_board_does_not_raise():
    oddities = (None, "12", -1, 4096, 12.5, float("nan"), OSError(5), ValueError())
    for board in [None] + [BatteryOddity(result) for result in oddities]:
        good, state, log = fresh(3063)
        state.update_battery(good)
        before = state.battery[0].voltage_mv
        notes = list(log.notes)
        state.update_battery(board)
        assert state.battery[0].voltage_mv == before
        measured = asked_of_battery(state)
        assert board is None or board.asked == measured  # about none of them twice
        for _ in range(4):
            state.update_battery(board)
        assert state.battery[0].voltage_mv is None
        # One error of each that is measured.
        assert len(log.lines) <= 2 * len([each for each in state.battery if each.monitored]), log.lines
        assert log.notes == notes, "a reading that fails tells nothing else"
        assert log.lines or not isinstance(getattr(board, "result", None), BaseException), "an error is told"
    # Who interrupts a reading gets the next one nevertheless.
    good, state, _ = fresh(3063)
    try:
        state.update_battery(BatteryOddity(KeyboardInterrupt()))
        raise AssertionError
    except KeyboardInterrupt:
        state.update_battery(good)
    assert state.battery[0].voltage_mv is not None


def battery_late_reading_keeps_the_last_value():
    board, state, log = fresh(3063)
    state.update_battery(board)
    before = state.battery[0].voltage_mv
    board.set_adc_value(1021)
    board.delay_adc(401)
    state.update_battery(board)
    assert state.battery[0].voltage_mv == before
    assert len(log.lines) == 1, log.lines
    board.delay_adc(400)
    state.update_battery(board)
    assert state.battery[0].voltage_mv < before


def battery_readings_are_timed():
    board, _, _ = fresh(3063)
    inputs = board.battery_inputs
    assert inputs.figures() == (0, 0, 0)
    for us in (7, 1, 4):
        board.delay_adc(us)
        board.read_battery_adc()
    assert inputs.figures()[1:] == (35, 20)
    board.fail_adc(1)  # the board does not answer: that is no time of a reading
    board.read_battery_adc()
    assert inputs.figures()[2] == 20
    inputs.counts[0][2], inputs.counts[0][3] = 0x1FFFFFFF, 1001  # as after many days
    for _ in range(3):
        board.read_battery_adc()
        assert abs(inputs.figures()[2] - 0x1FFFFFFF // 1001) <= 0x1FFFFFFF // 1001 // 200
    assert inputs.counts[0][3] == 503, "both sides of the mean were halved, once"


def battery_lowest_cell_is_found():
    board, state, _ = fresh(3063)
    one = state.battery[0]
    rising = list(range(5, 8))
    without = [list(rising), list(rising)]
    without[0][0] = without[1][-1] = None
    for values in (rising, rising[::-1], without[0], without[1], [7] * 3, [None] * 3):
        one.cells_mv = values
        state.update_battery(board)
        there = [value for value in values if value is not None]
        assert one.lowest_cell_mv == (min(there) if there else None), values
    one.cells_mv = rising
    for _ in range(20):
        state.update_battery(board)
    assert one.lowest_cell_mv == min(rising)
    state.update_battery(board)
    assert one.lowest_cell_mv is None, "the list was forgotten"


def battery_highest_cell_is_found():
    board, state, _ = fresh(3063)
    one = state.battery[0]
    rising = list(range(5, 8))
    without = [list(rising), list(rising)]
    without[0][0] = without[1][-1] = None
    for values in (rising, rising[::-1], without[0], without[1], [7] * 3, [None] * 3):
        one.cells_mv = values
        state.update_battery(board)
        there = [value for value in values if value is not None]
        assert one.highest_cell_mv == (max(there) if there else None), values
    one.cells_mv = rising
    for _ in range(20):
        state.update_battery(board)
    assert one.highest_cell_mv == max(rising)
    state.update_battery(board)
    assert one.highest_cell_mv is None, "the list was forgotten"


def battery_old_reading_is_unknown():
    for build in [
        telemetry.build_sys_status,
        telemetry.build_battery_status,
        telemetry.build_battery_status_v2,
        telemetry.build_battery_cell_voltages,
        lambda state: state.battery[0].expire(),
    ]:
        for start_us in (0, (1 << 30) * 1000 - 500000):  # the second is just before ticks_ms() wraps
            for late_ms, is_old in ((0, False), (1, True), (HALF_TURN_MS - 1, True), (HALF_TURN_MS, False)):
                mock_time.set_ticks_us(start_us)
                board, state, _ = fresh(3063)
                state.update_battery(board)
                mock_time.advance_us((1000 + late_ms) * 1000)
                build(state)
                assert (state.battery[0].voltage_mv is None) == is_old, late_ms
    mock_time.set_ticks_us(0)


def battery_what_code_sets_counts_for_a_while():
    """The board is not asked where another system measures; a value that code no longer sets is unknown."""
    parameters = Parameters()
    parameters.batt_monitor = 29
    state = SystemState(parameters, Log())
    board = BatteryOddity(3063)
    state.update_battery(board)
    assert board.asked == asked_of_battery(state)
    one = state.battery[0]
    assert one.voltage_mv is None
    for value in (9775, 9775 + 1):
        one.voltage_mv = value
        for _ in range(50):
            one.current_ma = 1
            one.consumed_mah = 1
            one.energy_hj = 1
            one.remaining_pct = 1
            one.left_mah = 1
            one.time_left_s = 1
            one.temperature_cdegc = 1
            state.update_battery(board)
            assert one.voltage_mv == value
        state.update_battery(board)
        assert one.voltage_mv is None
        assert told(one.current_ma) is None
        assert told(one.consumed_mah) is None
        assert told(one.energy_hj) is None
        assert told(one.remaining_pct) is None
        assert told(one.left_mah) is None
        assert told(one.time_left_s) is None
        assert told(one.temperature_cdegc) is None
    assert not state.calibrate_battery(12)


def battery_what_code_sets_beside_is_forgotten():
    """All of it is believed while code sets any of it; where some of it is counted, that goes on."""
    names = ("temperature_cdegc", "current_ma", "consumed_mah", "energy_hj", "remaining_pct", "left_mah", "time_left_s")
    parameters = Parameters()
    parameters.batt2_monitor = 0
    parameters.batt_monitor = 3
    state, board = SystemState(parameters, Log()), BatteryOddity(3063)
    one = state.battery[0]
    for last in names:
        for name in names:
            setattr(one, name, 1)
        for _ in range(50):
            state.update_battery(board)
        setattr(one, last, 2)
        for _ in range(50):
            state.update_battery(board)
            assert [getattr(one, name) for name in names if name != last] == [1] * (len(names) - 1), last
        assert getattr(one, last) == 2
        state.update_battery(board)
        assert [getattr(one, name) for name in names] == [None] * len(names), last
    parameters.batt2_monitor = 0
    parameters.batt_monitor = 4
    state, board = SystemState(parameters, Log()), MockBoard(Log(), parameters=parameters)
    board.set_adc_value(3063)
    one = state.battery[0]
    for name in names:
        setattr(one, name, 1)
    one.consumed_mah = 1000
    one.energy_hj = 1000
    for _ in range(51):
        state.update_battery(board)
    assert one.consumed_mah > 500, "it went on from what code had set"
    assert one.energy_hj > 500, "it went on from what code had set"
    assert one.temperature_cdegc is None


def battery_high_value_warns_now_and_then():
    board, state, log = fresh(4084)
    state.update_battery(board)
    assert log.lines == []
    for warnings in (1, 2):
        for _ in range(3):
            board.set_adc_value(4085)
            state.update_battery(board)
            assert len(log.lines) == warnings, log.lines
            board.set_adc_value(4084)
            state.update_battery(board)
        mock_time.advance_us(10000 * 1000 - 1000)
        board.set_adc_value(4085)
        state.update_battery(board)
        assert len(log.lines) == warnings, log.lines
        mock_time.advance_us(1000)
    mock_time.set_ticks_us(0)


def battery_formula_of_people_agrees():
    board, state, _ = fresh(3063)
    state.update_battery(board)
    component = state.battery[0]
    by_hand = component.voltage_from_adc(3063, state.parameters.get("BATT_VOLT_MULT"))
    assert abs(component.voltage - by_hand) < 0.001


def battery_calibration():
    board, state, _ = fresh(3063)
    state.update_battery(board)
    component = state.battery[0]
    before = component.voltage_mv
    step = before / state.parameters.batt_volt_mult + 1  # what one step of the multiplier is worth
    assert state.calibrate_battery(component.voltage * 1.01)
    state.update_battery(board)
    assert component.voltage_mv == before  # a new multiplier counts from the next start
    state = SystemState(state.parameters, log=Log())
    component = state.battery[0]
    state.update_battery(board)
    assert abs(component.voltage_mv - before * 1.01) <= step
    component.voltage = None
    assert not state.calibrate_battery(12.0)


def battery_scenarios():
    for name in ("nominal", "low", "critical", "rising", "falling"):
        board, state, _ = fresh(0)
        board.set_adc_waveform(scenario(name))
        seen = []
        for _ in range(20):
            state.update_battery(board)
            seen.append(state.battery[0].voltage_mv)
        assert seen == sorted(seen, reverse=name == "falling"), name
        assert (seen[0] != seen[-1]) == (name in ("rising", "falling")), name


def battery_steady_cycle_allocates_nothing():
    board, state, log = fresh(4095)
    links = [Link(Sink(), version=2), Link(Sink(), version=1)]
    state.update_battery(board)  # what there is to warn about at full scale is said now
    first = state.battery[0].voltage_mv
    make_messages(state)
    heap_lock()
    try:
        for count in range(4095, -1, -13):
            board.set_adc_value(count)
            state.update_battery(board)
            for build in STEADY:
                message = build(state)
                for link in links:
                    if message is not None and (link.version == 2 or message.ID < 256):
                        link.send(message)
    finally:
        heap_unlock()
    # A function with many variables puts them on the heap while it runs, which a locked heap does not show.
    before = mem_total()
    state.update_battery(board)
    for build in STEADY:
        sent(links[0], build(state))
    assert mem_total() == before
    assert links[0].sequence != links[0].tx_errors == 0
    assert board.battery_inputs.figures()[0] == 0
    assert state.battery[0].voltage_mv < first // 50
    assert len(log.lines) <= 1, log.lines


def reading_of(settings):
    """Return a board, a state, and the log of both, with parameters that are set so."""
    log = Log()
    parameters = Parameters()
    for name, steps in settings.items():
        setattr(parameters, name, steps)
    board = MockBoard(log=log, parameters=parameters)
    return board, known(SystemState(parameters, log=log)), log


BATTERY_CURRENT = {
    "name": "battery_current",
    "input": "battery_current_adc",
    "component": "battery",
    "attribute": "current_ma",
    "several": True,
    "counts": (2559, 2431),
    "instances": 2,
    "full_scale": 4095,
    "invalid_after": 5,
    "stale_after_ms": 1000,
    "on": {"batt2_monitor": 0, "batt_monitor": 4},
    "pins": (26, 28),
    "apart": [
        {
            "batt2_amp_offset": 3300,
            "batt2_amp_pervlt": 0,
            "batt2_capacity": 0,
            "batt2_curr_pin": 28,
            "batt2_monitor": 0,
            "batt_amp_offset": 0,
            "batt_amp_pervlt": 1700,
            "batt_capacity": 3300,
            "batt_curr_pin": 26,
            "batt_monitor": 4,
        },
        {
            "batt2_amp_offset": 0,
            "batt2_amp_pervlt": 1700,
            "batt2_capacity": 3300,
            "batt2_curr_pin": 26,
            "batt2_monitor": 4,
            "batt_amp_offset": 3300,
            "batt_amp_pervlt": 0,
            "batt_capacity": 0,
            "batt_curr_pin": 28,
            "batt_monitor": 0,
        },
    ],
    "off": [
        {"batt2_monitor": 0, "batt_monitor": 0},
        {"batt2_monitor": 0, "batt_monitor": 3},
        {"batt2_monitor": 0, "batt_monitor": 29},
    ],
    "extremes": [
        {"batt2_monitor": 0, "batt_amp_offset": 0, "batt_amp_pervlt": 0, "batt_monitor": 4},
        {"batt2_monitor": 0, "batt_amp_offset": 3300, "batt_amp_pervlt": 9900, "batt_monitor": 4},
    ],
    "lasting": {
        "attribute": "time_left_s",
        "left": "left_mah",
        "factor": 3600,
        "readings": 300,
        "most": 1000000,
    },
    "sums": [
        {
            "attribute": "consumed_mah",
            "times": None,
            "is_after": False,
            "parts": 3600000,
            "least": -1073741823,
            "most": 1073741823,
        },
        {
            "attribute": "energy_hj",
            "times": "voltage_mv",
            "is_after": True,
            "parts": 100000000000,
            "least": -1073741823,
            "most": 1073741823,
        },
    ],
    "rests": [
        {
            "attribute": "remaining_pct",
            "after": "consumed_mah",
            "full": "batt_capacity",
            "steps": 1,
            "share": 100,
            "most": 100,
            "sizes": [0, 7, 3300],
        },
        {
            "attribute": "left_mah",
            "after": "consumed_mah",
            "full": "batt_capacity",
            "steps": 1,
            "share": None,
            "most": 1073741823,
            "sizes": [0, 7, 3300],
        },
    ],
    "builders": [telemetry.build_sys_status, telemetry.build_battery_status, telemetry.build_battery_status_v2],
    "others": [
        {
            "name": "battery",
            "input": "adc",
            "component": "battery",
            "attribute": "voltage_mv",
            "several": True,
            "counts": (2559, 2431),
        },
    ],
}


def battery_current_fails_alone():
    single_readings.fails_alone(BATTERY_CURRENT, reading_of)


def battery_current_ages_alone():
    single_readings.ages_alone(BATTERY_CURRENT, reading_of)


def battery_current_raises_nothing():
    single_readings.raises_nothing(BATTERY_CURRENT, reading_of)


def battery_current_is_left_alone_where_it_is_off():
    single_readings.is_left_alone_where_it_is_off(BATTERY_CURRENT, reading_of)


def battery_current_is_what_its_instance_has():
    single_readings.is_what_its_instance_has(BATTERY_CURRENT, reading_of)


def battery_current_allocates_nothing():
    single_readings.allocates_nothing(BATTERY_CURRENT, reading_of)


def battery_current_lasts_at_the_mean():
    single_readings.lasts_at_the_mean(BATTERY_CURRENT, reading_of)


def battery_current_is_summed_exactly():
    single_readings.is_summed_exactly(BATTERY_CURRENT, reading_of)


# Component, attribute, and what it, or each value of a list, has at the start, but for those that parameters switch on.
FIRST = (
    ("battery", "voltage_mv", None),
    ("battery", "current_ma", None),
    ("battery", "consumed_mah", None),
    ("battery", "energy_hj", None),
    ("battery", "remaining_pct", None),
    ("battery", "left_mah", None),
    ("battery", "time_left_s", None),
    ("battery", "counted_from_full", 0),
    ("battery", "cells_mv", None),
    ("battery", "temperature_cdegc", None),
    ("battery", "trend_mv_s", None),
    ("battery", "health_number", 2),
    ("battery", "failsafe_number", 0),
    ("battery", "swaps_number", 0),
    ("battery", "protected", 0),
    ("battery", "lowest_cell_mv", None),
    ("battery", "highest_cell_mv", None),
    ("vehicle", "armed", 0),
    ("vehicle", "ready", 0),
    ("vehicle", "mode_number", 0),
    ("vehicle", "status", 3),
    ("vehicle", "load_dpct", 0),
)


def everything_starts_as_specified():
    state = SystemState(log=Log())
    for name, attribute, initial in FIRST:
        found = told(getattr(getattr(state, name), attribute))
        expected = [initial] * len(found) if isinstance(found, list) else initial
        assert found == expected, (name, attribute, found)


def every_value_allocates_nothing():
    state = known(SystemState(log=Log()))
    link = Link(Sink())
    values = (None, 0, 1, -1, 255, -32769, 65534, 65535, 655341, 1073741823, -1073741823)
    quantities = (
        (state.battery[0], "voltage_mv"),
        (state.battery[0], "current_ma"),
        (state.battery[0], "consumed_mah"),
        (state.battery[0], "energy_hj"),
        (state.battery[0], "remaining_pct"),
        (state.battery[0], "left_mah"),
        (state.battery[0], "time_left_s"),
        (state.battery[0], "counted_from_full"),
        (state.battery[0], "temperature_cdegc"),
        (state.battery[0], "trend_mv_s"),
        (state.battery[0], "health_number"),
        (state.battery[0], "failsafe_number"),
        (state.battery[0], "swaps_number"),
        (state.battery[0], "monitored"),
        (state.battery[0], "protected"),
        (state.battery[0], "lowest_cell_mv"),
        (state.battery[0], "highest_cell_mv"),
        (state.vehicle, "armed"),
        (state.vehicle, "ready"),
        (state.vehicle, "mode_number"),
        (state.vehicle, "status"),
        (state.vehicle, "load_dpct"),
    )
    make_messages(state)
    for owner, attribute in quantities:
        for value in values:
            setattr(owner, attribute, value)  # what is beyond its limits is told now
            before = mem_total()
            heap_lock()
            try:
                setattr(owner, attribute, value)
                for build in STEADY:
                    sent(link, build(state))
            finally:
                heap_unlock()
            assert mem_total() == before, (attribute, value)


def first(value, count):
    """Return a list of so many values, of which the first one is known."""
    return [value if at == 0 else None for at in range(count)]


LIMITED = (  # component, attribute, what texts call it, a value within its limits, and some beyond
    (
        "battery",
        "voltage_mv",
        "voltage",
        5,
        (-1, 65535),
    ),
    (
        "battery",
        "current_ma",
        "current",
        5,
        (-327681, 327671),
    ),
    (
        "battery",
        "consumed_mah",
        "consumed",
        5,
        (-1073741824, 1073741824),
    ),
    (
        "battery",
        "energy_hj",
        "energy",
        5,
        (-1073741824, 1073741824),
    ),
    (
        "battery",
        "remaining_pct",
        "remaining",
        5,
        (-1, 101),
    ),
    (
        "battery",
        "left_mah",
        "left",
        5,
        (-1, 1073741824),
    ),
    (
        "battery",
        "time_left_s",
        "time_left",
        5,
        (-1, 1000001),
    ),
    (
        "battery",
        "cells_mv",
        "cells_mv",
        first(5, 3),
        (first(-1, 3), first(65535, 3)),
    ),
    (
        "battery",
        "temperature_cdegc",
        "temperature",
        5,
        (-32769, 32767),
    ),
    (
        "battery",
        "trend_mv_s",
        "trend",
        5,
        (-1073741824, 1073741824),
    ),
    (
        "battery",
        "health_number",
        "health",
        2,
        (-1, 3),
    ),
    (
        "battery",
        "failsafe_number",
        "failsafe",
        2,
        (-1, 3),
    ),
    (
        "battery",
        "swaps_number",
        "swaps",
        5,
        (-1, 1000001),
    ),
    (
        "battery",
        "lowest_cell_mv",
        "lowest_cell",
        5,
        (-1073741824, 1073741824),
    ),
    (
        "battery",
        "highest_cell_mv",
        "highest_cell",
        5,
        (-1073741824, 1073741824),
    ),
    (
        "vehicle",
        "mode_number",
        "mode",
        5,
        (-1, 1000001),
    ),
    (
        "vehicle",
        "status",
        "status",
        5,
        (-1, 9),
    ),
    (
        "vehicle",
        "load_dpct",
        "load",
        5,
        (-1, 1001),
    ),
)


def what_is_limited_is_counted_and_told_once():
    for name, attribute, called, within, beyond in LIMITED:
        for value in beyond:
            log = Log()
            owner = getattr(SystemState(log=log), name)
            for told in (0, 1, 2):
                assert len(log.lines) == told, (name, attribute, value, log.lines)
                assert owner.limited.get(called, 0) == 3 * told
                if told == 2:
                    break
                for _ in range(3):
                    setattr(owner, attribute, value)
                assert owner.beyond
                setattr(owner, attribute, None)  # unknown is not right again
                assert owner.beyond
                setattr(owner, attribute, within)
                assert not owner.beyond
            assert log.lines[0].startswith("warning: " + name)
            assert "." + called in log.lines[0], log.lines


def all_that_is_limited_is_told():
    log = Log()
    state = SystemState(log=log)
    for _ in range(2):
        for name, attribute, _, _, beyond in LIMITED:
            setattr(getattr(state, name), attribute, beyond[1])
    assert len(log.lines) == len(set(log.lines)) == len(LIMITED), log.lines


def battery_cells_allocate_nothing():
    state = known(SystemState(log=Log()))
    link = Link(Sink())
    make_messages(state)
    steps = state.battery[0].cells_mv
    for turn in range(2):  # the first one is for what is only made once
        for place in range(len(steps)):
            for value in (None, 0, 1, -1, 65534, 65535, 1073741823, -1073741823, 3700):
                steps[place] = value  # what is beyond its limits is told now
                before = mem_total()
                steps[place] = value
                for build in STEADY:
                    sent(link, build(state))
                assert mem_total() == before or turn == 0


def battery_cells_in_their_unit():
    component = SystemState(log=Log()).battery[0]
    count = len(component.cells_mv)
    component.cells = [None if place == 0 else place for place in range(count)]
    assert list(component.cells_mv) == [None if place == 0 else place * 1000 for place in range(count)]
    assert told(component.cells) == [None if place == 0 else place for place in range(count)]
    component.cells[-1] = 2
    assert component.cells_mv[count - 1] == 2 * 1000
    for wrong in ([], [1.0] * (count + 1)):
        try:
            component.cells = wrong
        except ValueError:
            continue
        raise AssertionError(wrong)
    component.cells = None
    assert told(component.cells) == [None] * count


def sent_in_40_seconds(state):
    """Return how many messages of each id go out in 40 seconds in which 100 passes a second look for what is due."""
    stream = Recorder()
    mock_time.set_ticks_us(((1 << 30) - 5000) * 1000)  # ticks_ms() wraps in the middle
    streams = Streams(state, Link(stream))
    for _ in range(4000):
        streams.run(time.ticks_ms())
        streams.announce()
        mock_time.advance_us(10000)
    mock_time.set_ticks_us(0)
    return stream.counts


def heartbeat_stream_keeps_its_rate():
    state = known(SystemState(log=Log()))
    state.parameters.batt_report = 2  # both generations
    sent = sent_in_40_seconds(state)
    assert abs(sent.get(0, 0) - 1 * 40) <= 1


def extended_status_stream_keeps_its_rate():
    state = known(SystemState(log=Log()))
    state.parameters.batt_report = 2  # both generations
    for rate in (0, 1, 50):
        state.parameters.sr0_ext_stat = rate
        sent = sent_in_40_seconds(state)
        expected = 1 * 40 * rate * 1 // 1
        assert abs(sent.get(1, 0) - expected) <= (expected > 0), rate


def extra1_stream_keeps_its_rate():
    state = known(SystemState(log=Log()))
    state.parameters.batt_report = 2  # both generations
    for instance in range(2):
        state.battery[instance].monitored = True
    for rate in (0, 2, 50):
        state.parameters.sr0_extra1 = rate
        sent = sent_in_40_seconds(state)
        expected = 2 * 40 * rate * 1 // 1
        assert abs(sent.get(147, 0) - expected) <= (expected > 0), rate


def extra3_stream_keeps_its_rate():
    state = known(SystemState(log=Log()))
    state.parameters.batt_report = 2  # both generations
    for instance in range(2):
        state.battery[instance].monitored = True
    for rate in (0, 1, 50):
        state.parameters.sr0_extra3 = rate
        sent = sent_in_40_seconds(state)
        expected = 2 * 40 * rate * 1 // 1
        assert abs(sent.get(369, 0) - expected) <= (expected > 0), rate


def info_stream_keeps_its_rate():
    state = known(SystemState(log=Log()))
    state.parameters.batt_report = 2  # both generations
    for instance in range(2):
        state.battery[instance].monitored = True
    sent = sent_in_40_seconds(state)
    assert abs(sent.get(370, 0) - 2 * 2) <= 1
    assert abs(sent.get(372, 0) - 2 * 2) <= 1


def late_pass_sends_no_burst():
    recorder = Recorder()
    mock_time.set_ticks_us(0)
    streams = Streams(known(SystemState(log=Log())), Link(recorder))
    streams.run(time.ticks_ms())
    at_once = recorder.total()
    longest_us = max([streams.interval_us(number) for number in recorder.counts])
    for _ in range(3):
        mock_time.advance_us(max(100000000, 2 * longest_us))
        for _ in range(3):
            streams.run(time.ticks_ms())
    mock_time.set_ticks_us(0)
    assert recorder.total() == 4 * at_once, recorder.counts


def parameters_start_with_their_defaults():
    parameters = Parameters()
    for attribute, name, steps, value in (
        ("arming_check", "ARMING_CHECK", 1, 1.0),
        ("batt2_amp_offset", "BATT2_AMP_OFFSET", 0, 0.0),
        ("batt2_amp_pervlt", "BATT2_AMP_PERVLT", 1700, 17.0),
        ("batt2_arm_mah", "BATT2_ARM_MAH", 0, 0.0),
        ("batt2_arm_volt", "BATT2_ARM_VOLT", 0, 0.0),
        ("batt2_capacity", "BATT2_CAPACITY", 3300, 3300.0),
        ("batt2_crt_mah", "BATT2_CRT_MAH", 0, 0.0),
        ("batt2_crt_volt", "BATT2_CRT_VOLT", 9900, 9.9),
        ("batt2_curr_pin", "BATT2_CURR_PIN", 28, 28.0),
        ("batt2_fs_crt_act", "BATT2_FS_CRT_ACT", 2, 2.0),
        ("batt2_fs_low_act", "BATT2_FS_LOW_ACT", 2, 2.0),
        ("batt2_low_mah", "BATT2_LOW_MAH", 0, 0.0),
        ("batt2_low_timer", "BATT2_LOW_TIMER", 10, 10.0),
        ("batt2_low_volt", "BATT2_LOW_VOLT", 10500, 10.5),
        ("batt2_monitor", "BATT2_MONITOR", 0, 0.0),
        ("batt2_volt_mult", "BATT2_VOLT_MULT", 39500, 3.95),
        ("batt2_volt_pin", "BATT2_VOLT_PIN", 27, 27.0),
        ("batt_amp_offset", "BATT_AMP_OFFSET", 0, 0.0),
        ("batt_amp_pervlt", "BATT_AMP_PERVLT", 1700, 17.0),
        ("batt_arm_mah", "BATT_ARM_MAH", 0, 0.0),
        ("batt_arm_volt", "BATT_ARM_VOLT", 0, 0.0),
        ("batt_capacity", "BATT_CAPACITY", 3300, 3300.0),
        ("batt_crt_mah", "BATT_CRT_MAH", 0, 0.0),
        ("batt_crt_volt", "BATT_CRT_VOLT", 9900, 9.9),
        ("batt_curr_pin", "BATT_CURR_PIN", 28, 28.0),
        ("batt_fs_crt_act", "BATT_FS_CRT_ACT", 2, 2.0),
        ("batt_fs_low_act", "BATT_FS_LOW_ACT", 2, 2.0),
        ("batt_low_mah", "BATT_LOW_MAH", 0, 0.0),
        ("batt_low_timer", "BATT_LOW_TIMER", 10, 10.0),
        ("batt_low_volt", "BATT_LOW_VOLT", 10500, 10.5),
        ("batt_monitor", "BATT_MONITOR", 3, 3.0),
        ("batt_report", "BATT_REPORT", 0, 0.0),
        ("batt_sys_status", "BATT_SYS_STATUS", 1, 1.0),
        ("batt_volt_mult", "BATT_VOLT_MULT", 39500, 3.95),
        ("batt_volt_pin", "BATT_VOLT_PIN", 26, 26.0),
        ("sr0_extra1", "SR0_EXTRA1", 2, 2.0),
        ("sr0_extra3", "SR0_EXTRA3", 1, 1.0),
        ("sr0_ext_stat", "SR0_EXT_STAT", 1, 1.0),
        ("sysid_thismav", "SYSID_THISMAV", 1, 1.0),
    ):
        assert getattr(parameters, attribute) == steps, name
        assert abs(parameters.get(name) - value) < 1e-5, name
    assert len(parameters.names()) == 39


def parameters_keep_their_limits():
    parameters = Parameters()
    for name in parameters.names():
        default = parameters.get(name)
        for refused in (None, float("nan"), float("inf"), -float("inf"), 3e38, -3e38):
            assert not parameters.set(name, refused), (name, refused)
            assert parameters.get(name) == default
        assert parameters.set(name, default)
        assert parameters.get(name) == default
    assert not parameters.set("NO_SUCH_NAME", 1)


BUILDERS = (
    telemetry.build_heartbeat,
    telemetry.build_sys_status,
    telemetry.build_battery_status,
    telemetry.build_autopilot_version,
    telemetry.build_protocol_version,
    telemetry.build_battery_status_v2,
    telemetry.build_smart_battery_info,
    telemetry.build_battery_info,
    telemetry.build_battery_cell_voltages,
)

STEADY = (
    telemetry.build_heartbeat,
    telemetry.build_sys_status,
    telemetry.build_battery_status,
    telemetry.build_autopilot_version,
    telemetry.build_protocol_version,
    telemetry.build_battery_status_v2,
    telemetry.build_smart_battery_info,
    telemetry.build_battery_info,
    telemetry.build_battery_cell_voltages,
)

CHECKS = (
    ("FR-00066.2", battery_mean),
    ("FR-00066.1", battery_full_scale),
    ("FR-00066.4", battery_failed_reading_keeps_the_last_value),
    ("FR-00067.3", battery_repeated_failures_make_it_unknown),
    ("FR-00066.5", battery_absent_converter_is_no_reason_to_stop),
    ("FR-00067.5", battery_broken_board_does_not_raise),
    ("NFR-00060.2", battery_late_reading_keeps_the_last_value),
    ("", battery_readings_are_timed),
    ("FR-00067.3", battery_old_reading_is_unknown),
    ("FR-00073.10", battery_what_code_sets_counts_for_a_while),
    ("FR-00073.11", battery_what_code_sets_beside_is_forgotten),
    ("FR-00069.5", battery_high_value_warns_now_and_then),
    ("FR-00069.1", battery_formula_of_people_agrees),
    ("FR-00069.6", battery_calibration),
    ("NFR-00062.2", battery_scenarios),
    ("NFR-00060.3", battery_steady_cycle_allocates_nothing),
    ("FR-00072.5", battery_lowest_cell_is_found),
    ("FR-00072.5", battery_highest_cell_is_found),
    ("FR-00077.4", battery_current_fails_alone),
    ("FR-00077.4", battery_current_ages_alone),
    ("FR-00067.5", battery_current_raises_nothing),
    ("FR-00077.2", battery_current_is_left_alone_where_it_is_off),
    ("FR-00077.1", battery_current_is_what_its_instance_has),
    ("NFR-00060.3", battery_current_allocates_nothing),
    ("FR-00077.7", battery_current_lasts_at_the_mean),
    ("FR-00077.5", battery_current_is_summed_exactly),
    ("FR-00068.8", heartbeat_stream_keeps_its_rate),
    ("FR-00068.9", extended_status_stream_keeps_its_rate),
    ("FR-00068.2", extra1_stream_keeps_its_rate),
    ("FR-00072", extra3_stream_keeps_its_rate),
    ("FR-00076.6", info_stream_keeps_its_rate),
    ("", everything_starts_as_specified),
    ("", every_value_allocates_nothing),
    ("", what_is_limited_is_counted_and_told_once),
    ("", all_that_is_limited_is_told),
    ("", battery_cells_allocate_nothing),
    ("FR-00076.7", battery_cells_in_their_unit),
    ("", late_pass_sends_no_burst),
    ("", parameters_start_with_their_defaults),
    ("", parameters_keep_their_limits),
)


def outcome(check):
    """Return None for a check that passes, else what went wrong."""
    try:
        check()
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return None


if __name__ == "__main__":
    asked = sys.argv[1:] or [check.__name__ for _, check in CHECKS]
    tell((check.__name__, outcome(check)) for _, check in CHECKS if check.__name__ in asked)
