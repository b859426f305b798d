# Generated from templates/tests/program/storage_checks.py: do not edit.
# Inputs: 72cc6966913327ed
"""Saved parameters through the whole vehicle: restarts, damage, power cuts at every byte, and what a save costs."""

import asyncio
import struct
from binascii import crc32

from program_bench import (
    IS_MICROPYTHON,
    SETTABLE,
    Craft,
    Flash,
    good_count,
    live,
    finish,
    main,
    messages,
    mock_time,
    needs,
    needs_arming,
    new_craft,
    number_of,
    ready_craft,
    run,
    save,
    silent,
)
from parameters import Parameters
from program_facts import CHUNK, CONTROL_US, FILES, LINKS_US, MEASURED, PARAMETERS, REPORT_MS, STEP_LIMIT_US
from storage import Storage
from texts import Texts
from vehicle import Vehicle

import dialect


class Start:
    """The start of a vehicle, as far as its parameters are loaded: what is tried at each byte needs no more of it."""

    said = Craft.said

    def __init__(self, flash):
        flash.use()
        self.texts = Texts(silent, 500)
        self.parameters = Parameters()
        self.storage = Storage(tuple(FILES), CHUNK)
        Vehicle._load_parameters(self)


def _other(facts):
    """Return steps that are not the default, where there are any."""
    if facts["choices"]:
        return next((steps for steps in facts["choices"] if steps != facts["default"]), facts["default"])
    return facts["maximum"] if facts["default"] != facts["maximum"] else facts["minimum"]


def _values(craft):
    return [getattr(craft.parameters, facts["attribute"]) for facts in PARAMETERS]


def _defaults():
    return [facts["default"] for facts in PARAMETERS]


def _set_all(craft):
    for facts in PARAMETERS:
        assert craft.parameters.set(facts["name"], _other(facts) * facts["numerator"] / facts["denominator"]), facts


def _wait(milliseconds):
    async def story():
        await asyncio.sleep_ms(milliseconds)

    return story


def set_over_the_link_survives_a_restart():
    """A multiplier that a ground station sets is saved by itself, and after a restart readings use it."""
    for measured in MEASURED:
        facts = next(each for each in PARAMETERS if each["attribute"] == measured["multiplier"])
        craft = new_craft()
        station = craft.ground_station()
        steps = facts["default"] + 658 if facts["default"] + 658 <= facts["maximum"] else facts["minimum"]
        value = steps * facts["numerator"] / facts["denominator"]
        station.set_parameter(facts, value)
        live(craft, _wait(1000))
        assert craft.connections[0].faults == 0, craft.said()
        again = new_craft(flash=craft.flash)
        assert getattr(again.parameters, facts["attribute"]) == steps
        needs(measured["first"] == measured["component"], "a single instance")
        run(again, 1000000)
        whole = (good_count(measured) >> measured["spare_bits"]) * steps * measured["numerator"]
        exact = (2 * whole + measured["denominator"]) // (2 * measured["denominator"])
        assert getattr(getattr(again.state, measured["component"]), measured["attribute"]) == exact


def all_values_survive():
    """Every parameter that differs from its default is in force before the first pass of the next program."""
    craft = new_craft()
    _set_all(craft)
    live(craft, _wait(1000))
    again = new_craft(flash=craft.flash)
    assert _values(again) == [_other(facts) for facts in PARAMETERS]
    assert [text for severity, text in again.said() if severity <= dialect.MAV_SEVERITY_WARNING] == []


def absent_files_give_defaults():
    """Without files: the defaults, and nothing to warn about."""
    craft = new_craft()
    assert _values(craft) == _defaults()
    assert [text for severity, text in craft.said() if severity < 6] == []


def damaged_files_give_defaults_and_a_warning():
    """Any changed byte is noticed with one warning: defaults, also beside rubbish; beside a whole slot its values."""
    craft = new_craft()
    _set_all(craft)
    save(craft)
    name = next(each for each in FILES if each in craft.flash.files)
    whole = craft.flash.files[name]
    for at in range(len(whole)):
        damaged = whole[:at] + bytes([whole[at] ^ 0x10]) + whole[at + 1 :]
        flash = Flash()
        flash.files.update({name: damaged})
        if at % 2:
            flash.files.update({FILES[1] if name == FILES[0] else FILES[0]: b"rubbish"})
        again = Start(flash)
        assert _values(again) == _defaults(), at
        warnings = [text for severity, text in again.said() if severity == dialect.MAV_SEVERITY_WARNING]
        assert len(warnings) == 1, (at, warnings)
        if at % 8 == 0:
            flash.files.update({FILES[0]: whole, FILES[1]: damaged})
            again = Start(flash)
            assert _values(again) == _values(craft)
            assert len(again.said("parameters are those of an earlier save: ")) == len(again.said()) == 1, again.said()


def lost_parameters_refuse_arming():
    """Without a whole stored copy, arming is refused and the reason is said, until parameters are saved anew."""
    needs_arming()
    flash = Flash()
    flash.files.update(dict.fromkeys(FILES, b"rubbish"))
    craft = ready_craft(flash=flash)
    run(craft, 1000000)
    problem = craft.arm()
    assert problem.startswith("PreArm: parameters have their defaults: "), problem
    assert not craft.state.vehicle.ready
    assert craft.arm(force=True) is None
    craft.disarm()
    facts = next((each for each in SETTABLE if each["after_restart"]), SETTABLE[0])  # one that changes nothing now
    craft.parameters.set(facts["name"], _other(facts) * facts["numerator"] / facts["denominator"])
    live(craft, _wait(1000))
    run(craft, 1000000)
    assert craft.arm() is None, craft.said()
    assert Start(flash).said() == []


def power_cut_leaves_old_or_new():
    """After a cut at each byte of a save, from either slot, the old values or the new ones are in force."""
    for saves in (0, 1, 2, 3):
        craft = new_craft()
        facts = SETTABLE[0]
        for index in range(saves):
            assert craft.parameters.set(
                facts["name"],
                (_other(facts) if index % 2 else facts["default"]) * facts["numerator"] / facts["denominator"],
            )
            save(craft)
        old_files = dict(craft.flash.files)
        old = _values(craft)
        craft.flash.operations = []
        _set_all(craft)
        save(craft)
        new = _values(craft)
        target, image = craft.flash.operations[-1]
        assert len({path for path, _ in craft.flash.operations}) == 1, "one slot is left alone"
        for length in range(len(image) + 1):  # one after the other: all of them at once would need much memory
            flash = Flash()
            flash.files = dict(old_files)
            flash.files[target] = image[:length]
            expected = new if length == len(image) else old
            assert _values(Start(flash)) == expected, (saves, length)


def sequence_wraps():
    """After the largest sequence number the next save is still the newer one."""
    craft = new_craft()
    craft.storage._sequence = 0xFFFE
    for facts in SETTABLE[:3]:
        craft.parameters.set(facts["name"], _other(facts) * facts["numerator"] / facts["denominator"])
        save(craft)
        assert _values(new_craft(flash=craft.flash)) == _values(craft)


def save_is_done_in_steps():
    """No write is longer than a chunk, and no control slot is missed where writing takes no time."""
    craft = new_craft()
    _set_all(craft)
    live(craft, _wait(2000))
    assert 0 < craft.flash.longest <= CHUNK, craft.flash.longest
    assert craft.storage._chunk == CHUNK, craft.storage._chunk
    assert craft.scheduler.overruns == 0
    writes = len(craft.flash.operations)
    assert craft.said("a step of a save") == []
    craft = new_craft()
    craft.flash.delay_us = STEP_LIMIT_US + 1
    _set_all(craft)
    live(craft, _wait(3000))
    assert len(craft.said("a step of a save")) == 1, craft.said()
    assert _values(new_craft(flash=craft.flash)) == _values(craft)
    assert (craft.scheduler.overruns > 0) == (STEP_LIMIT_US >= 2 * CONTROL_US), craft.scheduler.overruns
    assert craft.scheduler.overruns <= writes * -(-craft.flash.delay_us // CONTROL_US), craft.scheduler.overruns
    assert craft.port.looks > 2900000 // LINKS_US - writes * -(-craft.flash.delay_us // LINKS_US)


def failed_write_keeps_the_old_values():
    """A flash that cannot be written is an error text; the values stay in force, and the saved ones as they were."""
    for works in range(3):
        craft = new_craft()
        save(craft)
        before = dict(craft.flash.files)
        craft.flash.fail_after = works
        _set_all(craft)
        live(craft, _wait(1000))
        needs(len(craft.parameters.dump()) > 2 * CHUNK, "a save of several chunks")
        errors = [text for severity, text in craft.said() if severity == dialect.MAV_SEVERITY_ERROR]
        assert len(errors) == 1, errors
        assert _values(craft) == [_other(facts) for facts in PARAMETERS]
        assert _values(new_craft(flash=craft.flash)) == _defaults()
        for path, content in before.items():
            assert craft.flash.files[path] == content


def flash_that_keeps_something_else_is_told():
    """A saved file that reads back differently is an error text, once; the values stay in force."""
    craft = new_craft()
    note = craft.flash.note
    craft.flash.note = lambda path, content: note(path, content[:-1] + b"\x00" if content else content)
    _set_all(craft)
    live(craft, _wait(1000))
    errors = [text for severity, text in craft.said() if severity == dialect.MAV_SEVERITY_ERROR]
    assert len(errors) == 1, errors
    assert not craft.storage.is_saving
    assert _values(craft) == [_other(facts) for facts in PARAMETERS]
    assert _values(new_craft(flash=craft.flash)) == _defaults()


def restart_tries_a_failed_save_again():
    """A save that failed just now is tried once more before a restart, at once."""
    craft = new_craft()
    craft.flash.fail_after = 0

    async def story():
        _set_all(craft)
        await asyncio.sleep_ms(1000)
        assert len(craft.said("parameters are not saved")) == 1, craft.said()
        craft.flash.fail_after = None
        craft.reboot(force=True)
        await asyncio.sleep_ms(10000)

    assert live(craft, story), "no reset"
    assert _values(new_craft(flash=craft.flash)) == _values(craft)


def saving_waits_while_armed():
    """While armed nothing is written, which is told once; after disarming it is saved."""
    needs_arming()
    craft = new_craft()

    async def story():
        craft.arm(force=True)
        _set_all(craft)
        await asyncio.sleep_ms(2000)
        assert craft.flash.operations == []
        assert len(craft.said("parameters are saved after disarming")) == 1
        craft.disarm()
        await asyncio.sleep_ms(1000)

    live(craft, story)
    assert craft.flash.operations != []
    assert _values(new_craft(flash=craft.flash)) == _values(craft)


def what_is_not_understood_is_skipped():
    """Names that this firmware does not have are skipped with a warning each, and stay stored for one that has them."""
    craft = new_craft()
    facts = SETTABLE[0]
    craft.parameters.set(facts["name"], _other(facts) * facts["numerator"] / facts["denominator"])
    unknown = b"\x07NO_SUCH\x00\x00\x80\x3f"
    craft.storage.begin(unknown + craft.parameters.dump())
    finish(craft.storage)
    again = new_craft(flash=craft.flash)
    assert _values(again) == _values(craft)
    assert len([text for severity, text in again.said() if severity == dialect.MAV_SEVERITY_WARNING]) == 1
    for _ in range(2):
        save(again)
        assert again.parameters.dump() == unknown + craft.parameters.dump()
        again = new_craft(flash=craft.flash)
    assert _values(again) == _values(craft)


def what_an_earlier_release_has_saved_is_read():
    """The bytes in flash are those that they always were, of a slot and of what is in it: both ways."""
    facts = _changing()
    name, steps = facts["name"], _other(facts)
    value = steps * facts["numerator"] / facts["denominator"]
    record = bytes([len(name)]) + name.encode() + struct.pack("<f", value)
    for number, file in ((0x0102, FILES[0]), (0x0103, FILES[1])):
        slot = b"SLOT" + struct.pack("<HHH", 1, number, len(record)) + record
        slot += struct.pack("<I", crc32(slot) & 0xFFFFFFFF)
        if number == 0x0102:
            flash = Flash()
            flash.files[file] = slot
            start = Start(flash)
            assert start.said() == []
            assert _values(start) == [steps if each is facts else each["default"] for each in PARAMETERS]
            save(start)
        assert flash.files[file] == slot, number


def save_waits_while_armed():
    """A value set while armed is used, and saved after disarming; a save that has begun goes on only then, too."""
    needs_arming()
    craft = new_craft()
    steps = []
    step = craft.storage.step

    def noted():
        steps.append(craft.is_armed)
        return step()

    craft.storage.step = noted

    async def story():
        _set_all(craft)
        while len(steps) < 2:
            await asyncio.sleep_ms(1)
        craft.arm(force=True)
        await asyncio.sleep_ms(3000)
        assert craft.storage.is_saving
        craft.disarm()
        await asyncio.sleep_ms(1000)

    live(craft, story)
    assert len(steps) > 2
    assert True not in steps, steps
    assert _values(new_craft(flash=craft.flash)) == _values(craft)


def failed_save_is_tried_again():
    """A flash that works again gets what could not be saved, without anybody setting it again, and what comes later."""
    craft = new_craft()
    craft.flash.fail_after = 0

    async def story():
        _set_all(craft)
        await asyncio.sleep_ms(1000)
        assert len(craft.said("parameters are not saved")) == 1, craft.said()
        craft.flash.fail_after = None
        await asyncio.sleep_ms(REPORT_MS + 1000)

    live(craft, story)
    assert _values(new_craft(flash=craft.flash)) == _values(craft)
    mock_time.advance_us(((1 << 29) + 60000) * 1000)  # the ticks of the failure seem to lie ahead now
    facts = SETTABLE[0]
    craft.parameters.set(facts["name"], facts["default"] * facts["numerator"] / facts["denominator"])
    live(craft, _wait(1000))
    assert _values(new_craft(flash=craft.flash)) == _values(craft), "a failure of long ago"


def lack_of_memory_does_not_end_the_program():
    """Whatever a save raises is told, and everything goes on."""
    craft = new_craft()

    def fail():
        raise MemoryError("no room")

    craft.parameters.dump = fail
    _set_all(craft)
    live(craft, _wait(1000))
    assert len(craft.said("parameters are not saved")) == 1, craft.said()
    looks = craft.port.looks
    run(craft, 1000000)
    assert craft.port.looks > looks


def no_arming_before_a_restart():
    """Between the answer to a restart and the restart itself, nobody arms; a forced restart disarms."""
    needs_arming()
    craft = new_craft()
    craft.arm(force=True)
    assert craft.reboot() is not None
    assert craft.is_armed
    assert craft.reboot(force=True) is None
    assert not craft.is_armed
    assert craft.arm(force=True) is not None
    assert not craft.is_armed


def restart_saves_first():
    """A restart over the link is acknowledged, waits for the save, and then resets the board, once."""
    craft = new_craft()
    station = craft.ground_station()
    facts = SETTABLE[-1]

    async def story():
        await asyncio.sleep_ms(300)
        value = _other(facts) * facts["numerator"] / facts["denominator"]
        station.set_parameter(facts, value)
        station.command(dialect.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, dialect.REBOOT_SHUTDOWN_ACTION_REBOOT)
        await asyncio.sleep_ms(10000)

    assert live(craft, story), "no reset"
    assert mock_time.elapsed_us() < 3000000
    acks = station.received(messages.CommandAck)
    assert [ack.result for ack in acks] == [dialect.MAV_RESULT_ACCEPTED], acks
    assert getattr(new_craft(flash=craft.flash).parameters, facts["attribute"]) == _other(facts)


def _changing():
    """Facts of a parameter that has two values."""
    found = [facts for facts in SETTABLE if _other(facts) != facts["default"]]
    needs(found, "a parameter with two values")
    return found[0]


def _value(facts, is_other):
    return (_other(facts) if is_other else facts["default"]) * facts["numerator"] / facts["denominator"]


def _set_for(craft, facts, seconds, every_ms, rest_s=61):
    """Change a parameter again and again, then rest, while nothing runs but what saves.

    Return when saves began, in ms. In the end the last value is the one that is stored.
    """
    began = []
    start_us = mock_time.elapsed_us()
    begin = craft.storage.begin

    def noted(payload):
        began.append((mock_time.elapsed_us() - start_us) // 1000)
        begin(payload)

    craft.storage.begin = noted

    async def both():
        keeping = asyncio.create_task(craft._keep_parameters())
        for index in range(seconds * 1000 // every_ms):
            craft.parameters.set(facts["name"], _value(facts, index % 2 == 0))
            await asyncio.sleep_ms(every_ms)
        last = getattr(craft.parameters, facts["attribute"])
        await asyncio.sleep_ms(rest_s * 1000)
        keeping.cancel()
        assert getattr(new_craft(flash=craft.flash).parameters, facts["attribute"]) == last

    if IS_MICROPYTHON:
        asyncio.new_event_loop()
    asyncio.run(both())
    return began


def flash_is_not_worn_out():
    """A value set again and again is saved ten times, then once a minute, which is told; the last value in any case."""
    facts = _changing()
    for every_ms in (1000, 50):  # settings that are saved one by one, and such that come without a pause
        craft = new_craft()
        began = _set_for(craft, facts, 600, every_ms)
        assert len([ms for ms in began if ms <= 600000]) in (19, 20), began
        gaps = [began[index + 1] - began[index] for index in range(9)]
        assert max(gaps) <= (1200 if every_ms == 1000 else 10500), gaps
        assert len(craft.said("parameters change so often")) == 1, craft.said()


def credit_comes_back():
    """After ten minutes without settings the next ones are saved at once again."""
    facts = _changing()
    craft = new_craft()
    _set_for(craft, facts, 60, 1000, rest_s=660)
    began = _set_for(craft, facts, 12, 1000)
    assert len([ms for ms in began if ms < 12000]) >= 10, began


def restart_in_a_flood():
    """Whatever arrives, the board starts again within 3 s, and what was accepted is saved; then nothing more is."""
    facts = _changing()
    craft = new_craft()
    craft._credit_ms = 0  # ten saves were made just before
    station = craft.ground_station()
    asked_us = []

    async def story():
        index = 0
        while True:
            index += 1
            station.set_parameter(facts, _value(facts, index % 2))
            if index == 21:
                asked_us.append(mock_time.elapsed_us())
                station.command(dialect.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, dialect.REBOOT_SHUTDOWN_ACTION_REBOOT)
            await asyncio.sleep_ms(50)

    assert live(craft, story), "no reset"
    assert mock_time.elapsed_us() - asked_us[0] < 3000000
    told = [number_of(value) for value in station.received(messages.ParamValue)]
    assert told[-5:] == [struct.unpack("<f", struct.pack("<f", _value(facts, True)))[0]] * 5, told
    assert getattr(new_craft(flash=craft.flash).parameters, facts["attribute"]) == _other(facts)


def code_that_changes_parameters_does_not_keep_the_board():
    """Parameters that change in every pass do not keep a restart waiting."""
    facts = _changing()
    craft = new_craft()

    async def story():
        craft.reboot()
        for index in range(10000):
            craft.parameters.set(facts["name"], _value(facts, index % 2))
            await asyncio.sleep_ms(1)

    assert live(craft, story), "no reset"
    assert mock_time.elapsed_us() < 3000000


def a_fault_beside_a_save_is_none_of_it():
    """check_arming() that fails at each turn meanwhile: the parameters are saved, and nothing else is said of them."""
    needs_arming()
    craft = ready_craft()
    run(craft, 5000000)

    def fail():
        raise ValueError("broken")

    craft.check_arming = fail
    craft.flash.delay_us = 9000
    facts = next((each for each in SETTABLE if each["after_restart"]), SETTABLE[0])  # one that changes nothing now
    craft.parameters.set(facts["name"], _other(facts) * facts["numerator"] / facts["denominator"])
    live(craft, _wait(2000))
    assert craft.flash.operations
    assert craft.said("parameters are not saved") == []


CHECKS = (
    (all_values_survive, "storage.kept"),
    (absent_files_give_defaults, "storage.defaults"),
    (damaged_files_give_defaults_and_a_warning, "storage.defaults"),
    (what_is_not_understood_is_skipped, "storage.defaults"),
    (what_an_earlier_release_has_saved_is_read, "storage.kept"),
    (lost_parameters_refuse_arming, "storage.lost"),
    (power_cut_leaves_old_or_new, "storage.power_cut"),
    (sequence_wraps, "storage.power_cut"),
    (failed_write_keeps_the_old_values, "storage.power_cut"),
    (flash_that_keeps_something_else_is_told, "storage.power_cut"),
    (save_is_done_in_steps, "storage.steps"),
    (saving_waits_while_armed, "storage.steps"),
    (flash_is_not_worn_out, "storage.wear"),
    (credit_comes_back, "storage.wear"),
    (restart_in_a_flood, "storage.leaving"),
    (code_that_changes_parameters_does_not_keep_the_board, "storage.leaving"),
    (set_over_the_link_survives_a_restart, "storage.over_link"),
    (restart_saves_first, "services.restart"),
    (restart_tries_a_failed_save_again, "services.restart"),
    (no_arming_before_a_restart, "services.restart"),
    (save_waits_while_armed, "storage.steps"),
    (failed_save_is_tried_again, "storage.power_cut"),
    (lack_of_memory_does_not_end_the_program, "storage.kept"),
    (a_fault_beside_a_save_is_none_of_it, "storage.kept"),
)
LONG = (
    damaged_files_give_defaults_and_a_warning,
    power_cut_leaves_old_or_new,
    failed_write_keeps_the_old_values,
    save_is_done_in_steps,
    saving_waits_while_armed,
    flash_is_not_worn_out,
    credit_comes_back,
    code_that_changes_parameters_does_not_keep_the_board,
    save_waits_while_armed,
    failed_save_is_tried_again,
    a_fault_beside_a_save_is_none_of_it,
)

SUBJECT = PARAMETERS
"""The parameters of the program; without any, these checks are left out."""

if __name__ == "__main__":
    main(CHECKS, SUBJECT)
