"""The smart battery beside an autopilot, on the bench of its generated suite; prints what went wrong in each check."""

import asyncio

import dialect
from program_bench import (
    SECOND_US,
    live,
    main,
    messages,
    new_rover,
    run,
    run_passes,
    save,
)

TYPE_BATTERY = 36  # MAV_TYPE_BATTERY and MAV_AUTOPILOT_INVALID of MAVLink's minimal.xml
NO_AUTOPILOT = 8


def _started(**values):
    """Return a battery that starts with these parameters, as saved by the run before."""
    before = new_rover()
    for name, value in values.items():
        assert before.parameters.set(name, value), name
    save(before)
    return new_rover(flash=before.flash)


def _sources(rover):
    return {(frame[5], frame[6]) for frame in rover.port.frames}


def heartbeat_is_that_of_a_battery():
    """Once a second, a battery and no autopilot, active."""
    battery = new_rover()
    station = battery.ground_station()
    run(battery, 60 * SECOND_US)
    beats = station.received(messages.Heartbeat)
    assert len(beats) == 60, len(beats)
    seen = {(beat.raw("type"), beat.raw("autopilot"), beat.base_mode, beat.system_status) for beat in beats}
    assert seen == {(TYPE_BATTERY, NO_AUTOPILOT, 0, dialect.MAV_STATE_ACTIVE)}, seen


def component_id_counts_from_the_next_start():
    """180 by default, and still after it is set; 181 after the restart; and it is then called by that."""
    battery = new_rover()
    assert battery.parameters.set("COMPID_BATT", 181)
    run(battery, 2 * SECOND_US)
    assert _sources(battery) == {(1, 180)}, _sources(battery)
    second = _started(COMPID_BATT=181, SYSID_THISMAV=7)
    run(second, 2 * SECOND_US)
    assert _sources(second) == {(7, 181)}, _sources(second)
    station = second.ground_station()
    station.received()
    for component, count in ((180, 0), (181, 1)):
        station.command(410, target_system=7, target_component=component)
        run_passes(second, 4)
        assert len(station.received(messages.CommandAck)) == count, component


def status_comes_every_two_seconds():
    """0.5 Hz by default; the parameter changes it at once, and 0 switches it off."""
    battery = new_rover()
    station = battery.ground_station()
    for rate, expected in ((None, 30), (2, 120), (0, 0)):
        if rate is not None:
            assert battery.parameters.set("BATT_STATUS_RATE", rate)
        run(battery, SECOND_US // 10)
        station.received()
        run(battery, 60 * SECOND_US)
        found = len(station.received(messages.BatteryStatus))
        assert abs(found - expected) <= 1, (rate, found)


def battery_has_an_id_of_its_own():
    """2 by default, so that the autopilot's own batteries, 0 and 1, are others."""
    for battery, expected in ((new_rover(), 2), (_started(BATT_ID=5), 5)):
        station = battery.ground_station()
        run(battery, SECOND_US)
        found = {status.raw("id") for status in station.received(messages.BatteryStatus)}
        assert found == {expected}, found


def nothing_can_be_armed():
    """The command is unknown to a battery, whatever it asks for, and there is nothing that code could call."""
    battery = new_rover()
    station = battery.ground_station()
    for params in ((1,), (1, 21196), (0,), (2,)):
        station.command(dialect.MAV_CMD_COMPONENT_ARM_DISARM, *params)
        run_passes(battery, 4)
        acks = station.received(messages.CommandAck)
        assert [ack.result for ack in acks] == [dialect.MAV_RESULT_UNSUPPORTED], (params, acks)
    for name in ("arm", "disarm", "is_armed", "arming_problem", "FORCE_ARM"):
        assert not hasattr(battery, name), name


def parameters_are_saved_within_a_second():
    """What a ground station sets is in the flash without anything else being done."""
    battery = new_rover()
    station = battery.ground_station()

    async def story():
        station.send(messages.ParamSet, param_id="BATT_CAPACITY", param_value=5200)
        await asyncio.sleep_ms(1000)

    live(battery, story)
    assert battery.flash.files
    assert new_rover(flash=battery.flash).parameters.batt_capacity == 5200


def measure_comes_before_the_reading():
    """measure() of the user's code runs in each pass of a reading, before it."""
    battery = new_rover()
    order = []
    slot = next(job for job in battery.scheduler._jobs if job.name == "measure")
    slot.call = lambda: order.append("measure")
    reading = battery.state.update_battery

    def update(board):
        order.append("reading")
        reading(board)

    battery.state.update_battery = update
    run(battery, SECOND_US)
    assert order == ["measure", "reading"] * 10, order


def measure_that_raises_stops_nothing():
    """A gauge chip that does not answer is logged once, and all the rest goes on."""
    battery = new_rover()
    slot = next(job for job in battery.scheduler._jobs if job.name == "measure")

    def fail():
        raise OSError(5)

    slot.call = fail
    station = battery.ground_station()
    run(battery, 10 * SECOND_US)
    assert len(battery.said("measure failed")) == 1, battery.said()
    assert len(station.received(messages.Heartbeat)) == 10
    assert battery.state.battery.voltage_mv is not None


def measured_current_goes_out():
    """What measure() writes into the state is in the next status."""
    battery = new_rover()
    slot = next(job for job in battery.scheduler._jobs if job.name == "measure")

    def measure():
        battery.state.battery.current_ca = 1234

    slot.call = measure
    station = battery.ground_station()
    run(battery, 5 * SECOND_US)
    assert station.received(messages.BatteryStatus)[-1].raw("current_battery") == 1234


def two_batteries_share_a_vehicle():
    """Asked as everybody, each answers with its own component; asked by its component, it alone answers."""
    first, second = new_rover(), _started(COMPID_BATT=181, BATT_ID=3)
    stations = [first.ground_station(), second.ground_station()]
    for component, answers in ((180, [1, 0]), (181, [0, 1]), (0, [1, 1])):
        found = []
        for battery, station in zip((first, second), stations):  # noqa: B905  MicroPython has no strict
            station.command(410, target_component=component)
            run_passes(battery, 4)
            found.append(len(station.received(messages.CommandAck)))
        assert found == answers, (component, found)


CHECKS = (
    ("", 1, heartbeat_is_that_of_a_battery),
    ("", 2, component_id_counts_from_the_next_start),
    ("", 2, two_batteries_share_a_vehicle),
    ("", 3, status_comes_every_two_seconds),
    ("", 7, battery_has_an_id_of_its_own),
    ("", 0, nothing_can_be_armed),
    ("", 0, parameters_are_saved_within_a_second),
    ("", 9, measure_comes_before_the_reading),
    ("", 9, measure_that_raises_stops_nothing),
    ("", 9, measured_current_goes_out),
)

if __name__ == "__main__":
    main(CHECKS)
