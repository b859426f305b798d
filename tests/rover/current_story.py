"""Prints what the rover makes of counts of a current sensor, as one JSON object; MICROPYPATH has the output."""

import json

import telemetry
from mock_board import MockBoard
from parameters import Parameters
from program_bench import Craft, Flash, Link, Sink, machine, mock_time, run, save
from state import SystemState

GOOD = 3770  # of the voltage: 12 V
DRAWN = 1234  # of the current: 16.91 A
READING_US = 100000
found = {}


def started(**settings):
    """Return a board and a state after a start with parameters of these values; both inputs are connected."""
    mock_time.set_ticks_us(0)
    machine.reset_analog()
    parameters = Parameters()
    for name, value in settings.items():
        parameters.set(name, value)
    board = MockBoard(log=lambda *_: None, parameters=parameters)
    board.set_adc_value(GOOD)
    return board, SystemState(parameters, log=lambda *_: None)


def read(board, state, current, voltage=GOOD):
    """Take a reading of these counts, None of one that fails, a tenth of a second after the one before."""
    mock_time.advance_us(READING_US)
    board.set_adc_waveform([voltage])
    board.set_battery_current_adc_waveform([current])
    state.update_battery(board)
    battery = state.battery[0]
    return [
        battery.current_ma,
        battery.consumed_mah,
        battery.energy_hj,
        battery.left_mah,
        battery.remaining_pct,
        battery.time_left_s,
    ]


def frame(state):
    return "".join(f"{byte:02x}" for byte in telemetry.encode_battery_status(Link(Sink()), state, 0))


def conversion():
    rows = ((0, 17, 0), (2047, 17, 0), (4095, 17, 0), (4095, 99, 0), (0, 17, 0.33), (1000, 0, 0))
    for count, factor, offset in rows:
        board, state = started(BATT_MONITOR=4, BATT_AMP_PERVLT=factor, BATT_AMP_OFFSET=offset)
        yield read(board, state, count)[0]


def without_a_sensor():
    board, state = started()
    assert not hasattr(board, "read_battery_current_adc")
    mock_time.advance_us(READING_US)
    state.update_battery(board)
    battery = state.battery[0]
    yield [battery.current, battery.consumed, battery.energy, battery.left, battery.remaining, battery.time_left]
    yield frame(state)


def drawn():
    board, state = started(BATT_MONITOR=4)
    for _ in range(40):
        yield read(board, state, DRAWN)
    yield frame(state)


def charged():
    board, state = started(BATT_MONITOR=4, BATT_AMP_OFFSET=1.65)
    for _ in range(30):
        yield read(board, state, 1000)


def swapped():
    """37 readings of a pack, five without one, and then one that is full."""
    board, state = started(BATT_MONITOR=4)
    for _ in range(37):
        read(board, state, DRAWN)
    for _ in range(5):
        yield read(board, state, 0, voltage=0)
    for _ in range(30):
        yield read(board, state, DRAWN)


def failing():
    board, state = started(BATT_MONITOR=4)
    for count in (DRAWN, DRAWN, None, None, None, None, None, DRAWN, DRAWN):
        yield read(board, state, count), state.battery[0].voltage is not None


def interrupted():
    """Ctrl-C while the sensor is read, and on with both readings."""
    board, state = started(BATT_MONITOR=4)
    read(board, state, DRAWN)
    good = board.read_battery_current_adc

    def interrupt(*_instance):
        raise KeyboardInterrupt

    board.read_battery_current_adc = interrupt
    try:
        read(board, state, DRAWN)
    except KeyboardInterrupt:
        yield "interrupted"
    board.read_battery_current_adc = good
    yield read(board, state, 1000, voltage=3000)[0], state.battery[0].voltage_mv


def endless():
    """An infinite value that code sets is no number."""
    _, state = started()
    battery = state.battery[0]
    for value in (float("inf"), float("-inf"), float("nan")):
        battery.voltage = battery.current = battery.temperature = value
        yield [battery.voltage_mv, battery.current_ma, battery.temperature_cdegc, battery.limited]
    yield bytes(telemetry.build_battery_status_v2(state, 0).wire).hex()


def emptied():
    """A pack of 5 mAh, then one of which nobody said the size."""
    board, state = started(BATT_MONITOR=4, BATT_CAPACITY=5)
    for _ in range(12):
        last = read(board, state, DRAWN)
    yield last
    state.parameters.set("BATT_CAPACITY", 0)
    yield read(board, state, DRAWN)


def rover_with(**settings):
    """Return a rover that was started with parameters of these values, and draws 16.91 A of a pack of 12 V."""
    machine.reset_analog()
    flash = Flash()
    before = Craft(flash=flash)
    for name, value in settings.items():
        before.parameters.set(name, value)
    save(before)
    machine.analog(26).source = GOOD
    machine.analog(28).source = DRAWN
    rover = Craft(flash=flash)
    run(rover, 500000)
    return rover


def empty_failsafe():
    """16.91 A are 4.7 mAh in a second: low after 2 s, critical after 4 s or so."""
    rover = rover_with(BATT_MONITOR=4, BATT_LOW_MAH=3290, BATT_CRT_MAH=3280, BATT_LOW_TIMER=0)
    yield rover.arm()
    for _ in range(11):
        run(rover, 500000)
        battery = rover.state.battery[0]
        yield [battery.left_mah, battery.failsafe_number, battery.health_number]
    yield [text for _, text in rover.said("Battery 1 is")]
    rover.disarm()
    yield rover.arm()


def never_empty():
    """Without thresholds, and with a current that is not measured, nothing comes of it."""
    for settings in ({"BATT_MONITOR": 4}, {"BATT_LOW_MAH": 3299, "BATT_CRT_MAH": 3298, "BATT_ARM_MAH": 3300}):
        rover = rover_with(**settings)
        problem = rover.arm()
        run(rover, 3000000)
        yield [problem, rover.state.battery[0].failsafe_number]


def arming():
    for settings in (
        {"BATT_ARM_MAH": 3299},
        {"BATT_ARM_MAH": 3290},
        {"BATT_LOW_MAH": 3299},
        {"BATT_CRT_MAH": 3299},
        {"BATT_LOW_MAH": 100, "BATT_CRT_MAH": 100},
        {"BATT_LOW_MAH": 100, "BATT_CRT_MAH": 99},
    ):
        rover = rover_with(BATT_MONITOR=4, **settings)
        run(rover, 1000000)
        yield rover.arm()


for tell in (
    conversion,
    without_a_sensor,
    drawn,
    charged,
    swapped,
    failing,
    interrupted,
    endless,
    emptied,
    empty_failsafe,
    never_empty,
    arming,
):
    found[tell.__name__] = list(tell())
print(json.dumps(found))  # noqa: T201
