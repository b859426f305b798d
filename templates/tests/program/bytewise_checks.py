"""Parameters as the bytes of their types: what PARAM_SET carries otherwise is refused, and never taken for a number."""

from program_bench import (
    SECOND_US,
    SETTABLE,
    WHOLE,
    main,
    messages,
    new_craft,
    number_of,
    put_number,
    run,
    run_turns,
)
from program_facts import BYTEWISE, COMPONENT_ID, PARAMETERS, SYSTEM_ID, VERSION

import dialect

OTHER_TYPES = [0, dialect.MAV_PARAM_TYPE_REAL32 + 1, 255, dialect.MAV_PARAM_TYPE_REAL32] + list(WHOLE)  # noqa: RUF005


def _met():
    """Return a vehicle that has said what it says at its start, and its ground station."""
    craft = new_craft()
    run(craft, SECOND_US)
    run_turns(craft, craft.texts.last)
    station = craft.ground_station()
    station.received()
    return craft, station


def _message(facts, kind):
    message = messages.ParamSet(unknown=False)
    message.update(target_system=SYSTEM_ID, target_component=COMPONENT_ID, param_id=facts["name"])
    return message.update(param_type=kind)


def _is_refused(craft, station, facts, message):
    """Send a PARAM_SET that is to change nothing: an error, a text that says why, and the value in force."""
    station.link.send(message)
    run_turns(craft, 4)
    found = station.received(messages.ParamError, messages.ParamValue, messages.Statustext)
    texts = [each.text for each in found if isinstance(each, messages.Statustext)]
    assert "%s is not sent as bytes of type %d" % (facts["name"], facts["type"]) in texts, texts  # noqa: UP031
    (value,) = [each for each in found if isinstance(each, messages.ParamValue)]
    errors = [each for each in found if isinstance(each, messages.ParamError)]
    assert len(errors) == (VERSION == 2), errors  # its id is above 255: MAVLink 1 does not carry it
    for error in errors:
        assert (error.param_id, error.error) == (facts["name"], dialect.MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE), error
    steps = facts["default"]
    assert number_of(value) == steps * facts["numerator"] / facts["denominator"], value
    assert getattr(craft.parameters, facts["attribute"]) == steps, facts["name"]


def another_type_is_refused():
    """The same bytes are another number as another type, so that nobody knows which is meant."""
    craft, station = _met()
    for facts in SETTABLE:
        for kind in OTHER_TYPES:
            if kind != facts["type"]:
                message = _message(facts, kind)
                put_number(message, facts["maximum"] * facts["numerator"] / facts["denominator"])
                _is_refused(craft, station, facts, message)


def numbers_as_floats_are_refused():
    """A C cast has something behind the bytes of a small integer, and is not taken for the 0 in them."""
    craft, station = _met()
    for facts in PARAMETERS:
        size = WHOLE[facts["type"]][0] if facts["type"] in WHOLE else 4
        for cast in (1, 2, 5, -1, 100) if size < 4 else ():
            message = _message(facts, facts["type"]).update(param_value=cast)
            _is_refused(craft, station, facts, message)
        for place in range(size, 4):
            message = _message(facts, facts["type"])
            put_number(message, facts["maximum"] * facts["numerator"])
            message.wire[place] = 1
            _is_refused(craft, station, facts, message)


CHECKS = (
    (another_type_is_refused, "storage.set"),
    (numbers_as_floats_are_refused, "storage.set"),
)
LONG = (another_type_is_refused,)

SUBJECT = BYTEWISE
"""True where whole parameters are bytes; else these checks are left out."""

if __name__ == "__main__":
    main(CHECKS, SUBJECT)
