"""The smart battery beside an autopilot, on the bench of its generated suite; prints what went wrong in each check."""

import asyncio
import binascii

import machine

CHIP = b"\xe6\x00\x64\x08\x43\x29\x5a\xff"
machine.set_unique_id(CHIP)  # before the firmware looks at it, which is once

import dialect  # noqa: E402
from mavlink import Link  # noqa: E402
from program_bench import (  # noqa: E402
    SECOND_US,
    live,
    main,
    messages,
    new_craft,
    run,
    run_passes,
    save,
)

TYPE_BATTERY = 36  # MAV_TYPE_BATTERY and MAV_AUTOPILOT_INVALID of MAVLink's minimal.xml
NO_AUTOPILOT = 8
RELATIVE_TO_FULL = 1 << 18  # MAV_BATTERY_STATUS_FLAGS_CAPACITY_RELATIVE_TO_FULL


def _started(**values):
    """Return a battery that starts with these parameters, as saved by the run before."""
    before = new_craft()
    for name, value in values.items():
        assert before.parameters.set(name, value), name
    save(before)
    return new_craft(flash=before.flash)


def _sources(rover):
    return {(frame[5], frame[6]) for frame in rover.port.frames}


def heartbeat_is_that_of_a_battery():
    """Once a second, a battery and no autopilot, active."""
    battery = new_craft()
    station = battery.ground_station()
    run(battery, 60 * SECOND_US)
    beats = station.received(messages.Heartbeat)
    assert len(beats) == 60, len(beats)
    seen = {(beat.raw("type"), beat.raw("autopilot"), beat.base_mode, beat.system_status) for beat in beats}
    assert seen == {(TYPE_BATTERY, NO_AUTOPILOT, 0, dialect.MAV_STATE_ACTIVE)}, seen


def component_id_counts_from_the_next_start():
    """180 by default, and still after it is set; 181 after the restart; and it is then called by that."""
    battery = new_craft()
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


def _measuring(measure):
    """Return a battery whose user code reads the gauge chip by a call with the battery's state."""
    battery = new_craft()
    slot = next(job for job in battery.scheduler._jobs if job.name == "measure")
    slot.call = lambda: measure(battery.state.battery)
    return battery


STATUS = (messages.BatteryStatus, messages.BatteryStatusV2)


def status_comes_at_the_rate_of_its_generation():
    """0.5 Hz and 1 Hz by default, for those that are chosen; each parameter changes its own at once, 0 switches off."""
    for choice, kinds in ((0, (1, 0)), (1, (0, 1)), (2, (1, 1))):
        battery = new_craft()
        station = battery.ground_station()
        if choice:
            assert battery.parameters.set("BATT_REPORT", choice)
        rates = [0.5, 1]
        for place, name, rate in (
            (0, None, 0.5),
            (0, "BATT_STATUS_RATE", 2),
            (1, "BATT_V2_RATE", 3),
            (0, "BATT_STATUS_RATE", 0),
            (1, "BATT_V2_RATE", 0),
        ):
            rates[place] = rate
            if name is not None:
                assert battery.parameters.set(name, rate)
            run(battery, SECOND_US // 10)
            station.received()
            run(battery, 60 * SECOND_US)
            found = station.received(*STATUS)
            for kind, is_sent, hz in zip(STATUS, kinds, rates):  # noqa: B905
                count = len([message for message in found if isinstance(message, kind)])
                assert abs(count - is_sent * hz * 60) <= is_sent, (choice, rates, kind, count)


def _twin(battery, component=180, sequence=0):
    """Return somebody with the ids of a battery, who sends over the same link."""
    twin = battery.ground_station()
    twin.link = Link(twin, 1, component)
    twin.link.sequence = sequence
    return twin


def _heard(battery, seconds, send):
    """Let somebody send once a second; return the texts about ids, each with its second."""
    found = []
    for second in range(seconds):
        before = battery.texts.last
        send(second)
        run(battery, SECOND_US)
        new = [battery.texts.get(number) for number in range(before + 1, battery.texts.last + 1)]
        found += [(second, text) for text in new if "in use" in text[1]]
    return found


IN_USE = (dialect.MAV_SEVERITY_WARNING, "COMPID_BATT 180 is in use by another: change one")


def a_heartbeat_of_its_own_ids_is_told():
    """From somebody with other sequence numbers: at the second one, and every 30 s while it lasts, as a STATUSTEXT."""
    for sequence in (100, 130, 160):
        battery = new_craft()
        station = battery.ground_station()
        twin = _twin(battery, sequence=sequence)
        found = _heard(battery, 70, lambda _: twin.send(messages.Heartbeat, type=TYPE_BATTERY))  # noqa: B023
        assert found == [(second, IN_USE) for second in (1, 31, 61)], (sequence, found)
        assert [text.text for text in station.received(messages.Statustext)].count(IN_USE[1]) == 3
        assert len(IN_USE[1]) <= 50, "one message"


def another_chip_with_its_own_ids_is_told():
    """Whatever its sequence numbers are, in either info; and a battery that has no number is another one, too."""
    for kind in INFOS:
        for serial in ("e66064084329ffff", "e6606408", "", "e6006408432\x005aff"):
            battery = new_craft()
            twin = _twin(battery)

            def send(second):
                twin.link.sequence = battery.connections[0].link.sequence - 1  # noqa: B023
                if second % 20 == 5:
                    twin.send(kind, id=2, serial_number=serial)  # noqa: B023

            found = _heard(battery, 60, send)
            assert found == [(second, IN_USE) for second in (5, 45)], (kind, serial, found)


def its_own_frames_that_come_back_are_no_news():
    """A link that returns each frame, at once or a second later, and a ground station that asks a lot."""
    for late in (1, 20):
        battery = new_craft()
        station = battery.ground_station()
        assert battery.parameters.set("BATT_REPORT", 2)
        returned = 0
        for tick in range(60 * 20):
            if tick % 100 == 50:
                station.send(messages.ParamRequestList)
            if tick % late == 0:
                for frame in battery.port.frames[returned:]:
                    battery.port.arrives(frame)
                returned = len(battery.port.frames)
            run(battery, SECOND_US // 20)
        assert returned > 150, returned
        assert not [text for _, text in battery.said() if "in use" in text], battery.said()


def a_battery_id_of_another_component_is_told():
    """Of one with the same battery id, and of none with another id, or of another vehicle."""
    for kind in INFOS:
        for system, component, number, value in (
            (1, 181, 2, "component 181"),
            (1, 1, 2, "component 1"),
            (1, 181, 3, None),
            (1, 1, 0, None),
            (7, 180, 2, None),
            (7, 181, 2, None),
        ):
            battery = new_craft()
            other = _twin(battery)
            other.link = Link(other, system, component)
            found = _heard(battery, 40, lambda _: other.send(kind, id=number, serial_number="x"))  # noqa: B023
            text = (dialect.MAV_SEVERITY_WARNING, f"BATT_ID 2 is in use by {value}: change one")
            assert found == ([(0, text), (30, text)] if value else []), (kind, system, component, number, found)


def two_that_are_told_apart_say_nothing():
    """180 with 2 and 181 with 3: neither warns of the other."""
    first, second = new_craft(), _started(COMPID_BATT=181, BATT_ID=3)
    for _ in range(60 * 20):
        for one, other in ((first, second), (second, first)):
            for frame in one.port.frames:
                other.port.arrives(frame)
            one.port.frames = []
        for battery in (first, second):
            run(battery, SECOND_US // 20)
    for battery in (first, second):
        assert not [text for _, text in battery.said() if "in use" in text], battery.said()


ABOUT_THE_BATTERY = (
    messages.BatteryStatus,
    messages.BatteryStatusV2,
    messages.SmartBatteryInfo,
    messages.BatteryInfo,
    messages.BatteryCellVoltages,
)


def battery_has_an_id_of_its_own():
    """2 by default, so that the autopilot's own batteries, 0 and 1, are others; the same in each of its messages."""
    for battery, expected in ((new_craft(), 2), (_started(BATT_ID=5), 5)):
        station = battery.ground_station()
        for kind in ABOUT_THE_BATTERY:
            station.received()
            station.command(dialect.MAV_CMD_REQUEST_MESSAGE, kind.ID)
            run(battery, SECOND_US)
            found = {message.raw("id") for message in station.received(kind)}
            assert found == {expected}, (kind, found)


INFOS = (messages.SmartBatteryInfo, messages.BatteryInfo)


def info_comes_when_it_is_wanted():
    """At the start, every 20 s, to who appears, on request and when the cells were exchanged; in what is chosen."""
    for choice in (0, 1):
        battery = _started(BATT_REPORT=choice)
        station = battery.ground_station()
        run(battery, SECOND_US)
        assert [type(info) for info in station.received(*INFOS)] == [INFOS[choice]], "at the start"
        run(battery, 60 * SECOND_US)
        assert len(station.received(*INFOS)) == 3, "every 20 s"
        station.send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS)
        run(battery, SECOND_US)
        assert [type(info) for info in station.received(*INFOS)] == [INFOS[choice]], "who appears"
        for kind in INFOS:
            station.command(dialect.MAV_CMD_REQUEST_MESSAGE, kind.ID)
            run(battery, SECOND_US)
            assert [type(info) for info in station.received(*INFOS)] == [kind], "on request"
        battery.state.battery.swaps_number += 1
        run(battery, SECOND_US)
        assert [type(info) for info in station.received(*INFOS)] == [INFOS[choice]], "on a change"


def serial_number_is_that_of_the_chip():
    """In hex, all of it, in both infos."""
    for choice in (0, 1):
        battery = _started(BATT_REPORT=choice)
        station = battery.ground_station()
        run(battery, SECOND_US)
        found = [info.serial_number for info in station.received(INFOS[choice])]
        assert found == [binascii.hexlify(CHIP).decode()], (choice, found)


def nothing_can_be_armed():
    """The command is unknown to a battery, whatever it asks for, and there is nothing that code could call."""
    battery = new_craft()
    station = battery.ground_station()
    for params in ((1,), (1, 21196), (0,), (2,)):
        station.command(dialect.MAV_CMD_COMPONENT_ARM_DISARM, *params)
        run_passes(battery, 4)
        acks = station.received(messages.CommandAck)
        assert [ack.result for ack in acks] == [dialect.MAV_RESULT_UNSUPPORTED], (params, acks)
    for name in ("arm", "disarm", "is_armed", "arming_problem", "FORCE_ARM"):
        assert not hasattr(battery, name), name


def parameters_are_saved_within_a_second():
    """A parameter set by a ground station is in the flash without anything else being done."""
    battery = new_craft()
    station = battery.ground_station()

    async def story():
        station.send(messages.ParamSet, param_id="BATT_CAPACITY", param_value=5200)
        await asyncio.sleep_ms(1000)

    live(battery, story)
    assert battery.flash.files
    assert new_craft(flash=battery.flash).parameters.batt_capacity == 5200


def measure_comes_before_the_reading():
    """measure() of the user's code runs in each pass of a reading, before it."""
    battery = new_craft()
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
    battery = new_craft()
    slot = next(job for job in battery.scheduler._jobs if job.name == "measure")

    def fail():
        raise OSError(5)

    slot.call = fail
    station = battery.ground_station()
    run(battery, 10 * SECOND_US)
    assert len(battery.said("measure failed")) == 1, battery.said()
    assert len(station.received(messages.Heartbeat)) == 10
    assert battery.state.battery.voltage_mv is not None


def what_the_gauge_says_goes_out():
    """The values that measure() writes into the state are in the next status of either generation."""

    def measure(pack):
        pack.current_ma = 12340
        pack.consumed_mah = 1100
        pack.energy_hj = 456
        pack.left_mah = 2200
        pack.remaining_pct = 67
        pack.temperature_cdegc = 2525
        pack.counted_from_full = True

    battery = _measuring(measure)
    assert battery.parameters.set("BATT_REPORT", 2)
    station = battery.ground_station()
    run(battery, 5 * SECOND_US)
    found = station.received(messages.BatteryStatus, messages.BatteryStatusV2)
    old = [message for message in found if isinstance(message, messages.BatteryStatus)][-1]
    new = [message for message in found if isinstance(message, messages.BatteryStatusV2)][-1]
    assert [old.raw(name) for name in OLD_GAUGE] == [1234, 1100, 456, 67, 2525]
    expected = (12.34, 1.1, 2.2, 67.0)
    for place, name in enumerate(NEW_GAUGE):
        assert abs(new.get(name) - expected[place]) < 1e-5, (name, new.get(name))
    assert new.raw("temperature") == 2525
    assert new.status_flags == RELATIVE_TO_FULL, new.status_flags


OLD_GAUGE = ("current_battery", "current_consumed", "energy_consumed", "battery_remaining", "temperature")
NEW_GAUGE = ("current", "capacity_consumed", "capacity_remaining", "state_of_charge")


def what_no_gauge_says_is_unknown():
    """Without code that reads a gauge chip the voltage is all that is known; nothing is guessed."""
    battery = new_craft()
    assert battery.parameters.set("BATT_REPORT", 2)
    station = battery.ground_station()
    run(battery, 5 * SECOND_US)
    found = station.received(messages.BatteryStatus, messages.BatteryStatusV2)
    old = [message for message in found if isinstance(message, messages.BatteryStatus)][-1]
    new = [message for message in found if isinstance(message, messages.BatteryStatusV2)][-1]
    assert [old.raw(name) for name in OLD_GAUGE] == [-1, -1, -1, -1, 32767]
    for name in NEW_GAUGE:
        assert new.get(name) is None, (name, new.get(name))
    assert old.raw("voltages")[0] == battery.state.battery.voltage_mv
    assert abs(new.voltage - battery.state.battery.voltage) < 1e-5
    assert new.status_flags == 0, new.status_flags


def two_batteries_share_a_vehicle():
    """Asked as everybody, each answers with its own component; asked by its component, it alone answers."""
    first, second = new_craft(), _started(COMPID_BATT=181, BATT_ID=3)
    stations = [first.ground_station(), second.ground_station()]
    for component, answers in ((180, [1, 0]), (181, [0, 1]), (0, [1, 1])):
        found = []
        for battery, station in zip((first, second), stations):  # noqa: B905  MicroPython has no strict
            station.command(410, target_component=component)
            run_passes(battery, 4)
            found.append(len(station.received(messages.CommandAck)))
        assert found == answers, (component, found)


CHECKS = (
    (heartbeat_is_that_of_a_battery,),
    (component_id_counts_from_the_next_start,),
    (two_batteries_share_a_vehicle,),
    (status_comes_at_the_rate_of_its_generation,),
    (a_heartbeat_of_its_own_ids_is_told,),
    (another_chip_with_its_own_ids_is_told,),
    (its_own_frames_that_come_back_are_no_news,),
    (a_battery_id_of_another_component_is_told,),
    (two_that_are_told_apart_say_nothing,),
    (info_comes_when_it_is_wanted,),
    (serial_number_is_that_of_the_chip,),
    (battery_has_an_id_of_its_own,),
    (nothing_can_be_armed,),
    (parameters_are_saved_within_a_second,),
    (measure_comes_before_the_reading,),
    (measure_that_raises_stops_nothing,),
    (what_the_gauge_says_goes_out,),
    (what_no_gauge_says_is_unknown,),
)

if __name__ == "__main__":
    main(CHECKS)
