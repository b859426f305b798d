# Generated from templates/tests/program/parameter_checks.py: do not edit.
# Inputs: 412e0f0f0376636e
"""Parameters over a link: read, listed, set, refused, and when they count."""

import struct

from program_bench import (
    SETTABLE,
    GroundStation,
    Port,
    can_be_sent,
    main,
    messages,
    needs,
    new_craft,
    number_of,
    quieted,
    run_passes,
    run_turns,
    save,
    sender_of,
    turns,
)
from program_facts import MEASURED, PARAMETERS, SYSTEM_ID, VERSION

import dialect

NO_INDEX = 0xFFFF
KINDS = (messages.ParamValue, messages.ParamError)
ERRORS = [messages.ParamError] if VERSION == 2 else []  # its id is above 255: MAVLink 1 does not carry it


def _sent(value):
    """Return what is left of a number in a float of 32 bits."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


def _worth(facts, steps):
    return _sent(steps * facts["numerator"] / facts["denominator"])


def _beyond(facts, end, way):
    """Return the first number beyond a limit that is another one as a float of 32 bits."""
    steps = end + way
    while _worth(facts, steps) == _worth(facts, end):
        steps += way
    return _worth(facts, steps)


def _set(craft, station, facts, value):
    station.set_parameter(facts, value)
    run_passes(craft, 4)
    return station.received(*KINDS)


def _accepted(facts):
    if facts["choices"]:
        return facts["choices"]
    return (facts["minimum"], facts["default"], (facts["minimum"] + facts["maximum"]) // 2, facts["maximum"])


def set_answers_with_the_value():
    """An accepted value comes back as it is in force, with its type and without an index."""
    craft = new_craft()
    station = craft.ground_station()
    for facts in PARAMETERS:
        for steps in _accepted(facts):
            answers = _set(craft, station, facts, _worth(facts, steps))
            assert len(answers) == 1, (facts["name"], steps, answers)
            answer = answers[0]
            assert (answer.param_id, number_of(answer)) == (facts["name"], _worth(facts, steps)), (answer, steps)
            assert (answer.param_index, answer.param_count) == (NO_INDEX, len(PARAMETERS)), answer
            assert answer.param_type == facts["type"]
            assert getattr(craft.parameters, facts["attribute"]) == steps
    assert craft.connections[0].faults == 0, craft.said()


def refused_values_change_nothing():
    """Outside the limits, NaN, infinite, none of the choices: an error, and then the value in force."""
    craft = new_craft()
    station = craft.ground_station()
    for facts in PARAMETERS:
        outside = [_beyond(facts, facts["minimum"], -1), _beyond(facts, facts["maximum"], 1)]
        outside += [float("nan"), float("inf"), -float("inf"), 3e38]
        if facts["choices"]:
            gaps = [steps for steps in range(facts["minimum"], facts["maximum"]) if steps not in facts["choices"]]
            outside += [_worth(facts, steps) for steps in gaps]
            if gaps:
                _names_what_is_accepted(craft, station, facts, _worth(facts, gaps[0]))
        for value in [each for each in outside if can_be_sent(facts, each)]:
            answers = _set(craft, station, facts, value)
            assert [type(each) for each in answers] == ERRORS + [messages.ParamValue], answers  # noqa: RUF005  MicroPython
            for error in answers[:-1]:
                assert error.error == dialect.MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE
                assert (error.param_id, error.raw("param_index")) == (facts["name"], -1), error
            assert number_of(answers[-1]) == _worth(facts, facts["default"]), (facts["name"], value, answers[-1])
            assert answers[-1].param_index == NO_INDEX
            assert getattr(craft.parameters, facts["attribute"]) == facts["default"]
    assert craft.parameters.changes == 0


def _names_what_is_accepted(craft, station, facts, value):
    """The text about a value in a gap has those that are accepted, as many as it has room for."""
    station.set_parameter(facts, value)
    run_turns(craft, 4)
    (said,) = [each.text for each in station.received(*KINDS, messages.Statustext) if each.ID == messages.Statustext.ID]
    accepted = ["%g" % _worth(facts, steps) for steps in facts["choices"]]  # noqa: UP031  MicroPython
    head = "%s: %g is not " % (facts["name"], value)  # noqa: UP031
    whole = head + ", ".join(accepted[:-1]) + " or " + accepted[-1] if len(accepted) > 1 else head + accepted[0]
    if len(whole) <= 50:
        assert said == whole, said
    else:
        assert said.startswith(head + accepted[0]), said
        assert said.endswith(", ... " + accepted[-1]), said


def values_are_rounded_to_steps():
    """A value between two steps becomes the nearest, and that is the answer."""
    craft = new_craft()
    station = craft.ground_station()
    for facts in PARAMETERS:
        if facts["choices"] or facts["maximum"] - facts["minimum"] < 2:
            continue
        steps = facts["minimum"] + 1
        value = (steps + 0.3) * facts["numerator"] / facts["denominator"]
        if not can_be_sent(facts, value):
            value = steps * facts["numerator"] + facts["numerator"] // 3
        assert number_of(_set(craft, station, facts, value)[0]) == _worth(facts, steps), facts["name"]


def unknown_names_are_refused():
    """A name that is no parameter: an error only, on setting and on reading."""
    craft = new_craft()
    station = craft.ground_station()
    answers = _set(craft, station, {"name": "NO_SUCH_NAME", "type": dialect.MAV_PARAM_TYPE_REAL32}, 1)
    station.send(messages.ParamRequestRead, param_id="NO_SUCH_NAME", param_index=-1)
    for index in (len(PARAMETERS), -2, 32767):
        station.send(messages.ParamRequestRead, param_index=index)
    run_passes(craft, 8)
    answers += station.received(*KINDS)
    assert [each.error for each in answers] == [dialect.MAV_PARAM_ERROR_DOES_NOT_EXIST] * 5 * len(ERRORS), answers
    asked = [("NO_SUCH_NAME", -1)] * 2 + [("", index) for index in (len(PARAMETERS), -2, 32767)]
    asked = asked if ERRORS else []
    assert [(each.param_id, each.raw("param_index")) for each in answers] == asked, answers
    for name, text in (
        ("OTHER", "OTHER is no parameter"),
        ("", "a parameter of this name does not exist"),
        ("N\xe9", "a parameter of this name does not exist"),
    ):
        message = messages.ParamSet(unknown=False).update(target_system=SYSTEM_ID)
        data = bytes([ord(each) for each in name])
        marked = bytes(messages.ParamSet(unknown=False).update(param_id="@").wire)
        place = marked.index(b"@")
        message.wire[place : place + len(data)] = data
        station.link.send(message)
        run_passes(craft, 4)
        assert craft.said()[-1][1] == text, craft.said()


def list_is_complete():
    """Each parameter once, in the order of the indices, with count and type; also over a port that is often full."""
    for every in (1, 2, 5):
        craft = quieted(new_craft(), every)
        station = craft.ground_station()
        station.send(messages.ParamRequestList)
        for index in range(turns(len(PARAMETERS) + 14, every) * every):
            craft.port.room = None if index % every == 0 else 0
            run_passes(craft, 1)
        values = station.received(messages.ParamValue)
        assert [value.param_index for value in values] == list(range(len(PARAMETERS))), every
        for facts, value in zip(PARAMETERS, values):  # noqa: B905  MicroPython has no strict
            assert value.param_id == facts["name"]
            assert value.param_count == len(PARAMETERS)
            assert (value.param_type, number_of(value)) == (facts["type"], _worth(facts, facts["default"])), value


def read_by_name_and_by_index():
    """Both ways give the value with its index."""
    craft = new_craft()
    station = craft.ground_station()
    for index, facts in enumerate(PARAMETERS):
        station.send(messages.ParamRequestRead, param_id=facts["name"], param_index=-1)
        station.send(messages.ParamRequestRead, param_index=index)
        run_passes(craft, 4)
        found = [(value.param_id, value.param_index) for value in station.received(*KINDS)]
        assert found == [(facts["name"], index)] * 2, found


def change_is_announced_on_other_links():
    """A value set over one link is told on the others."""
    ports = [Port(), Port()]
    craft = new_craft(ports=ports)
    one, other = [GroundStation(port) for port in ports]
    for facts in SETTABLE:
        steps = next(each for each in _accepted(facts) if each != facts["default"])
        one.set_parameter(facts, _worth(facts, steps))
        run_turns(craft, 4)
        assert len(one.received(messages.ParamValue)) == 1
        told = other.received(messages.ParamValue)
        assert [(value.param_id, number_of(value)) for value in told] == [(facts["name"], _worth(facts, steps))], told
    assert [connection.faults for connection in craft.connections] == [0, 0], craft.said()
    late = [text for _, text in craft.said() if text.endswith("counts from the next start")]
    assert len(late) == len([facts for facts in SETTABLE if facts["after_restart"]]), late


def multiplier_counts_from_the_next_start():
    """A multiplier that is set while the program runs changes no reading before the next start."""
    for measured in MEASURED:
        needs(measured["latched"], "a multiplier that waits for the next start")
        facts = next(each for each in PARAMETERS if each["attribute"] == measured["multiplier"])
        craft = new_craft()
        read = "update_" + measured["component"]
        getattr(craft.state, read)(craft.board)
        component = getattr(craft.state, measured["component"])
        needs(measured["first"] == measured["component"], "a single instance")
        before = getattr(component, measured["attribute"])
        setattr(craft.parameters, facts["attribute"], facts["maximum"])
        getattr(craft.state, read)(craft.board)
        assert getattr(component, measured["attribute"]) == before
        save(craft)
        again = new_craft(flash=craft.flash)
        getattr(again.state, read)(again.board)
        assert getattr(getattr(again.state, measured["component"]), measured["attribute"]) > before


def system_id_counts_from_the_next_start():
    """Frames carry the old system id until the next start, and then the new one."""
    ids = [facts for facts in PARAMETERS if facts["after_restart"] and "SYSID" in facts["name"]]
    needs(ids, "a parameter with the system id")
    craft = new_craft()
    assert craft.parameters.set(ids[0]["name"], 42)
    run_passes(craft, 10)
    assert {sender_of(frame) for frame in craft.port.frames} == {SYSTEM_ID}
    save(craft)
    craft = new_craft(flash=craft.flash)
    run_passes(craft, 10)
    assert {sender_of(frame) for frame in craft.port.frames} == {42}


CHECKS = (
    (set_answers_with_the_value, "storage.set", "quantity.multiplier"),
    (refused_values_change_nothing, "storage.set"),
    (values_are_rounded_to_steps, "storage.set"),
    (unknown_names_are_refused, "storage.set"),
    (list_is_complete, "storage.read"),
    (read_by_name_and_by_index, "storage.read"),
    (change_is_announced_on_other_links, "storage.set"),
    (multiplier_counts_from_the_next_start, "storage.reboot", "quantity.calibration"),
    (system_id_counts_from_the_next_start, "storage.reboot"),
)
LONG = (
    list_is_complete,
    change_is_announced_on_other_links,
    set_answers_with_the_value,
    refused_values_change_nothing,
)

SUBJECT = PARAMETERS
"""The parameters of the program; without any, these checks are left out."""

if __name__ == "__main__":
    main(CHECKS, SUBJECT)
