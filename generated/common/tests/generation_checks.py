# Generated from templates/tests/program/generation_checks.py: do not edit.
# Inputs: bb2d5652cd81d9fe
"""Generations of messages: what is chosen is streamed, what is not is sent on request, and each has its price."""

from program_bench import SECOND_US, GroundStation, Port, id_of, main, messages, needs, new_craft, run, run_passes
from program_facts import GENERATIONS, LINKS_US, MESSAGES, SENT, SHORTEST_US

import dialect

STEP_US = min(10000, LINKS_US)  # between passes while frames are counted: as often as any stream can go
SECONDS = 60


def _generations():
    needs(GENERATIONS, "generations of messages")
    return GENERATIONS


def _choosing():
    found = [each for each in _generations() if each["parameter"]]
    needs(found, "a parameter that chooses a generation")
    return found


def _with_choice(each, choice):
    return (each["old"], each["new"], each["old"] + each["new"])[choice]


def _left_out(each, choice):
    return [number for number in each["old"] + each["new"] if number not in _with_choice(each, choice)]


def is_chosen(craft, number):
    """Tell whether a message is of a generation that is sent now, or of none."""
    for each in GENERATIONS:
        if number in each["old"] + each["new"]:
            choice = getattr(craft.parameters, each["attribute"]) if each["attribute"] else each["default"]
            return number in (each["old"], each["new"], each["old"] + each["new"])[choice]
    return True


def reporting(craft, number):
    """Return the instances, from 0, that a message is sent about."""
    return reported(craft, MESSAGES[number])


def reported(craft, facts):
    """Return those that a table is sent about."""
    if facts["component"] is None or facts["enabled"] is None:
        return list(range(facts["instances"]))
    owners = getattr(craft.state, facts["component"])
    owners = list(owners)
    return [place for place, owner in enumerate(owners) if getattr(owner, facts["enabled"])]


def _ids_in(craft, port, duration_us, step_us=None):
    port.frames = []
    run(craft, duration_us, step_us)
    return [id_of(frame) for frame in port.frames]


def only_the_default_is_streamed():
    """Without any setting: every message of the chosen generation that has a rate, and none of the other."""
    port = Port()
    craft = new_craft(ports=[port])
    found = _ids_in(craft, port, SECONDS * SECOND_US, STEP_US)
    for each in _generations():
        for number in _with_choice(each, each["default"]):
            expected = MESSAGES[number]["rate"] > 0 and reporting(craft, number)
            assert (number in found) or not expected, (number, found)
        for number in _left_out(each, each["default"]):
            assert number not in found, number


def a_choice_acts_at_once():
    """Each choice, one after the other while the program runs: the next passes have what it chooses and nothing else.

    What has been chosen before goes on in its phase; what is chosen anew is due at once, and so is nothing that is not.
    """
    for each in _choosing():
        port = Port()
        craft = new_craft(ports=[port])
        before = each["default"]
        run(craft, 3 * SECOND_US + SECOND_US // 7)
        for choice in (0, 1, 2, 1, 0, 2, 0):
            assert craft.parameters.set(each["parameter"], choice)
            soon = _ids_in(craft, port, 8 * LINKS_US)
            later = _ids_in(craft, port, SECONDS * SECOND_US, STEP_US)
            for number in each["old"] + each["new"]:
                is_chosen = number in _with_choice(each, choice) and MESSAGES[number]["rate"] > 0
                is_sent = bool(is_chosen and reporting(craft, number))
                if number not in _with_choice(each, before):
                    assert (number in soon) == is_sent, (choice, number, soon)
                if not is_sent:
                    assert number not in soon, (choice, number)
                assert (number in later) == is_sent, (choice, number)
            before = choice


def _met():
    port = Port()
    craft = new_craft(ports=[port])
    station = GroundStation(port)
    run(craft, 2 * SECOND_US)
    station.received()
    return craft, port, station


def the_other_one_is_sent_on_request():
    """MAV_CMD_REQUEST_MESSAGE: accepted, and the message comes once about each instance."""
    for each in _generations():
        for number in each["old"] + each["new"]:
            craft, port, station = _met()
            if craft.connections[0].streams.interval_us(number) >= 0:
                continue  # it is streamed anyway
            port.frames = []
            station.command(dialect.MAV_CMD_REQUEST_MESSAGE, number)
            run_passes(craft, 100)
            found = [id_of(frame) for frame in port.frames]
            assert found.count(messages.CommandAck.ID) == 1
            assert found.count(number) == len(reporting(craft, number)) * MESSAGES[number]["pages"], (number, found)


def _interval(craft, station, number):
    station.command(dialect.MAV_CMD_GET_MESSAGE_INTERVAL, number)
    run_passes(craft, 4)
    answers = station.received(messages.MessageInterval)
    assert [answer.message_id for answer in answers] == [number]
    return answers[0].interval_us


def the_other_one_is_sent_in_an_interval():
    """Its interval is -1, until MAV_CMD_SET_MESSAGE_INTERVAL gives it one, and again after 0."""
    for each in _generations():
        for number in _left_out(each, each["default"]):
            craft, port, station = _met()
            assert _interval(craft, station, number) == -1
            asked = SHORTEST_US[SENT.index(number)] * 2
            for interval_us, in_force in ((asked, asked), (0, -1), (-1, -1)):
                station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, interval_us)
                run_passes(craft, 4)
                acks = station.received(messages.CommandAck)
                assert [ack.result for ack in acks] == [dialect.MAV_RESULT_ACCEPTED]
                assert _interval(craft, station, number) == in_force, interval_us
                frames = len(reporting(craft, number)) * MESSAGES[number]["pages"]
                count = 20 * SECOND_US // asked * frames if in_force > 0 else 0
                found = _ids_in(craft, port, 20 * SECOND_US, STEP_US).count(number)
                assert abs(found - count) <= (frames if count else 0), (number, interval_us, found, count)


def data_streams_do_not_reach_the_other_one():
    """REQUEST_DATA_STREAM for all streams changes rates, not generations."""
    for each in _generations():
        craft, port, station = _met()
        station.send(messages.RequestDataStream, req_stream_id=0, req_message_rate=5, start_stop=1)
        run_passes(craft, 4)
        found = _ids_in(craft, port, 10 * SECOND_US, STEP_US)
        for number in _left_out(each, each["default"]):
            assert number not in found, number


def no_choice_costs_more_than_it_says():
    """A minute of each choice: every frame within its bytes, each message at its rate, their sum within the price."""
    for each in _generations():
        for choice in (0, 1, 2) if each["parameter"] else (each["default"],):
            port = Port()
            craft = new_craft(ports=[port])
            if each["parameter"]:
                craft.parameters.set(each["parameter"], choice)
            run(craft, 2 * SECOND_US + SECOND_US // 7)  # what is sent at the start is no part of the price
            port.frames = []
            run(craft, SECONDS * SECOND_US, STEP_US)
            whole, slack = 0, 0
            for number in _with_choice(each, choice):
                facts = MESSAGES[number]
                on = reporting(craft, number)
                sizes = [len(frame) for frame in port.frames if id_of(frame) == number]
                if not on:
                    assert sizes == []
                    continue
                low = min(facts["frames"][place][0] for place in on)
                high = max(facts["frames"][place][1] for place in on)
                assert all(low <= size <= high for size in sizes), (number, low, high, sizes[:5])
                turn = len(on) * facts["pages"]
                assert abs(len(sizes) - SECONDS * facts["rate"] * turn) <= turn, (number, len(sizes))
                whole += sum(sizes)
                slack += turn * high
            low, high = each["prices"][choice]
            low = 0 if craft.set_by_code else low  # which is nothing here, and has its price nevertheless
            assert SECONDS * low - slack <= whole <= SECONDS * high + slack, (choice, whole / SECONDS, low, high)


CHECKS = (
    (only_the_default_is_streamed, "generations.choice"),
    (a_choice_acts_at_once, "generations.choice"),
    (the_other_one_is_sent_on_request, "generations.other", "message.request"),
    (the_other_one_is_sent_in_an_interval, "generations.other"),
    (data_streams_do_not_reach_the_other_one, "generations.other"),
    (no_choice_costs_more_than_it_says, "generations.price"),
)
LONG = (
    only_the_default_is_streamed,
    a_choice_acts_at_once,
    the_other_one_is_sent_on_request,
    the_other_one_is_sent_in_an_interval,
    data_streams_do_not_reach_the_other_one,
    no_choice_costs_more_than_it_says,
)

if __name__ == "__main__":
    main(CHECKS)
