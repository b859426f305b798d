"""The rover's battery messages on the bench of its generated suite, as MAVLink's documents describe them.

The number of cells of a battery is the argument. Prints what went wrong in each check.
"""

import sys

import dialect
import machine
from program_bench import SECOND_US, main, messages, new_craft, run, run_passes, save

CELLS = int(sys.argv[1])
PAGE = 12  # cells that one BATTERY_CELL_VOLTAGES has
ROVER = 10  # MAV_TYPE_GROUND_ROVER
RELATIVE_TO_FULL = 262144  # MAV_BATTERY_STATUS_FLAGS_CAPACITY_RELATIVE_TO_FULL
OVERHEAD = 12  # bytes of a MAVLink 2 frame around its payload


def _rover(**values):
    """Return a rover that starts with these parameters, as saved by the run before, and its ground station."""
    before = new_craft()
    for name, value in values.items():
        assert before.parameters.set(name, value), name
    save(before)
    rover = new_craft(flash=before.flash)
    return rover, rover.ground_station()


def batteries_are_part_of_the_autopilot():
    """The messages about either battery come from the autopilot's ids, and HEARTBEAT says rover."""
    rover, station = _rover(BATT2_MONITOR=3, BATT_REPORT=2)
    run(rover, 30 * SECOND_US)
    sources = {(frame[5], frame[6]) for frame in rover.port.frames}
    assert sources == {(1, 1)}, sources
    received = station.received(
        messages.Heartbeat,
        messages.BatteryStatus,
        messages.BatteryStatusV2,
        messages.SmartBatteryInfo,
        messages.BatteryInfo,
    )
    kinds = {message.raw("type") for message in received if isinstance(message, messages.Heartbeat)}
    assert kinds == {ROVER}, kinds
    told = {(message.ID, message.raw("id")) for message in received if not isinstance(message, messages.Heartbeat)}
    assert told == {(number, battery) for number in (147, 369, 370, 372) for battery in (0, 1)}, told


def cells_come_on_request_only():
    """Nothing about single cells in five minutes of everything else; on request all pages, by their first cell."""
    rover, station = _rover(BATT_REPORT=2)
    run(rover, 300 * SECOND_US, 100_000)
    assert station.received(messages.BatteryCellVoltages) == []
    cells = [3000 + 10 * cell for cell in range(CELLS)]
    for cell in range(CELLS):
        rover.state.battery[0].cells_mv[cell] = cells[cell]
    station.command(dialect.MAV_CMD_REQUEST_MESSAGE, messages.BatteryCellVoltages.ID)
    run_passes(rover, 30)
    pages = station.received(messages.BatteryCellVoltages)
    assert [page.raw("index") for page in pages] == list(range(0, CELLS, PAGE))
    found = []
    for page in pages:
        found += list(page.raw("voltages"))
    assert found == cells + [0] * (len(found) - CELLS), found
    run(rover, 60 * SECOND_US)
    assert station.received(messages.BatteryCellVoltages) == [], "once only"


def cells_that_are_not_there_are_not_sent():
    """The last page ends with its last cell: the zeros behind it are cut off."""
    rover, station = _rover()
    for cell in range(CELLS):
        rover.state.battery[0].cells_mv[cell] = 4000
    station.command(dialect.MAV_CMD_REQUEST_MESSAGE, messages.BatteryCellVoltages.ID)
    run_passes(rover, 30)
    number = messages.BatteryCellVoltages.ID
    lengths = [frame[1] for frame in rover.port.frames if frame[7] | frame[8] << 8 | frame[9] << 16 == number]
    assert lengths[-1] == 2 + 2 + 2 * ((CELLS - 1) % PAGE + 1), lengths


def one_battery_is_told_alike():
    """With one battery SYS_STATUS has the voltage, current and charge of BATTERY_STATUS, known and unknown."""
    rover, station = _rover()
    battery = rover.state.battery[0]
    for current, charge in ((None, None), (1234, 56), (-250, 100)):
        battery.current_ma = None if current is None else 10 * current
        battery.remaining_pct = charge
        run(rover, 3 * SECOND_US)
        found = station.received(messages.BatteryStatus, messages.SysStatus)
        status = [message for message in found if isinstance(message, messages.BatteryStatus)][-1]
        system = [message for message in found if isinstance(message, messages.SysStatus)][-1]
        old = (status.raw("voltages")[0], status.raw("current_battery"), status.raw("battery_remaining"))
        new = (system.raw("voltage_battery"), system.raw("current_battery"), system.raw("battery_remaining"))
        assert old == new, (old, new)
        assert old[1:] == (-1 if current is None else current, -1 if charge is None else charge), old


def large_amounts_need_the_new_generation():
    """400 A and 40 Ah: floats carry both; the old current ends at 327.67 A, while its charge and its cells go on."""
    rover, station = _rover(BATT_REPORT=2)
    battery = rover.state.battery[0]
    rover.state.update_battery = lambda _board: None
    battery.voltage_mv = 70000
    battery.current_ma = 400000
    battery.consumed_mah = 40000
    run(rover, 3 * SECOND_US)
    found = station.received(messages.BatteryStatus, messages.BatteryStatusV2)
    old = [message for message in found if isinstance(message, messages.BatteryStatus)][-1]
    new = [message for message in found if isinstance(message, messages.BatteryStatusV2)][-1]
    assert (new.raw("voltage"), new.raw("current"), new.raw("capacity_consumed")) == (70, 400, 40)
    assert (old.raw("current_battery"), old.raw("current_consumed")) == (32767, 40000)
    assert list(old.raw("voltages")) == [65534, 70000 - 65534] + [65535] * 8


def new_status_is_shorter():
    """39 bytes, 38 for battery 0, whose id is cut off; the old one has 48, because -1 % ends its base."""
    rover, _ = _rover(BATT2_MONITOR=3, BATT_REPORT=2)
    rover.state.update_battery = lambda _board: None
    for battery in rover.state.battery:
        battery.voltage_mv = 4000 * CELLS
    run(rover, 10 * SECOND_US)
    lengths = {}
    for frame in rover.port.frames:
        lengths.setdefault(frame[7] | frame[8] << 8 | frame[9] << 16, set()).add(len(frame))
    assert lengths[369] == {27 + OVERHEAD, 26 + OVERHEAD}, lengths
    assert lengths[147] == {36 + OVERHEAD}, lengths


def cells_come_in_an_interval():
    """A station that keeps a log has them once a minute, on its own link."""
    rover, station = _rover()
    number = messages.BatteryCellVoltages.ID
    rover.state.battery[0].cells_mv[0] = 4000
    station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, 60_000_000)
    run_passes(rover, 4)
    assert [answer.result for answer in station.received(messages.CommandAck)] == [dialect.MAV_RESULT_ACCEPTED]
    run(rover, 600 * SECOND_US, 100_000)
    turns = len(station.received(messages.BatteryCellVoltages)) // -(-CELLS // PAGE)
    assert 9 <= turns <= 11, turns


def a_power_monitor_supposes_nothing():
    """The rover counts nothing from a full pack, and so neither says so nor tells what would be left."""
    rover, station = _rover(BATT_REPORT=1)
    run(rover, 5 * SECOND_US)
    told = station.received(messages.BatteryStatusV2)
    assert told
    for message in told:
        assert not message.raw("status_flags") & RELATIVE_TO_FULL
        assert str(message.raw("capacity_remaining")) == str(message.raw("capacity_consumed")) == "nan"


def charge_adds_up_to_the_capacity():
    """With a current sensor, what was drawn and what is left are BATT_CAPACITY, as if the pack had been full.

    That it was, a flag says, which code sets that knows.
    """
    rover, station = _rover(BATT_MONITOR=4, BATT_REPORT=1, BATT_CAPACITY=3300)
    machine.analog(rover.parameters.batt_curr_pin).source = 2047
    battery = rover.state.battery[0]
    drawn = []
    for is_known in (False, True):
        battery.counted_from_full = is_known
        run(rover, 60 * SECOND_US)
        told = station.received(messages.BatteryStatusV2)[-1]
        assert bool(told.raw("status_flags") & RELATIVE_TO_FULL) == is_known
        consumed, left = told.raw("capacity_consumed"), told.raw("capacity_remaining")
        assert consumed > 0.01, consumed
        assert abs(consumed + left - 3.3) < 1e-6, (consumed, left)
        drawn.append(consumed)
    assert drawn[0] < drawn[1], drawn


CHECKS = (
    (batteries_are_part_of_the_autopilot,),
    (cells_come_on_request_only,),
    (cells_that_are_not_there_are_not_sent,),
    (one_battery_is_told_alike,),
    (large_amounts_need_the_new_generation,),
    (new_status_is_shorter,),
    (cells_come_in_an_interval,),
    (a_power_monitor_supposes_nothing,),
    (charge_adds_up_to_the_capacity,),
)

if __name__ == "__main__":
    main(CHECKS)
