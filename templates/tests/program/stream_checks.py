"""Streams of the whole vehicle: rates by parameter, by interval and by request, each on its own link."""

from generation_checks import is_chosen, reported, reporting
from program_bench import SECOND_US, GroundStation, Port, Sink, know, main, messages, mock_time, needs, new_craft, run
from program_facts import (
    GENERATIONS,
    LINKS_US,
    MEASURED,
    MESSAGES,
    ON_REQUEST,
    SENT,
    SHARED,
    SHORTEST_US,
    STREAMS,
    WITHHELD,
)

import dialect

STEP_US = 10000  # between passes while frames are counted: more often than any stream


class Counter(Sink):
    """A port that counts the frames of each message."""

    def __init__(self):
        Sink.__init__(self)
        self.ids = {}

    def write(self, frame):
        """Take all."""
        number = frame[7] | frame[8] << 8 | frame[9] << 16
        self.ids[number] = self.ids.get(number, 0) + 1
        return len(frame)


def _counted(craft, port, seconds):
    port.ids = {}
    run(craft, seconds * SECOND_US, STEP_US)
    return port.ids


def _by_parameter():
    found = [stream for stream in STREAMS if stream["parameter"] and stream["messages"]]
    needs(found, "a stream with a parameter")
    return found


def _owners(craft, component):
    """Return the instances of a component."""
    owner = getattr(craft.state, component)
    return list(owner)


def _frames(craft, number):
    """Return how many frames one turn of a message takes: one for each page of each instance that is reported."""
    return len(reporting(craft, number)) * MESSAGES[number]["pages"] if is_chosen(craft, number) else 0


def _both_generations(craft):
    """Let the craft send all that there is."""
    for each in GENERATIONS:
        if each["parameter"]:
            craft.parameters.set(each["parameter"], 2)


def _within(found, expected, frames=1):
    """Return whether so many were found, give or take the frames of one turn, which may just fall into the time."""
    return abs(found - expected) <= (frames if expected else 0)


def rates_by_parameter():
    """Each rate, changed while the program runs, from the next pass on: so many frames in 20 seconds."""
    for stream in _by_parameter():
        port = Counter()
        craft = new_craft(ports=[port])
        _both_generations(craft)
        run(craft, SECOND_US)
        for steps in (0, stream["default"], 3, 7, stream["maximum"], stream["minimum"]):
            if not stream["minimum"] <= steps <= stream["maximum"]:
                continue
            craft.parameters.set(stream["parameter_name"], steps * stream["numerator"] / stream["denominator"])
            rate = steps * stream["numerator"] / stream["denominator"]
            found = _counted(craft, port, 20)
            for number, _, _ in stream["messages"]:
                expected = round(20 * rate) * _frames(craft, number)
                assert _within(found.get(number, 0), expected, _frames(craft, number)), (stream["name"], steps, found)


def fixed_rates():
    """What has a fixed rate, such as HEARTBEAT, keeps it for a minute."""
    port = Counter()
    craft = new_craft(ports=[port])
    found = _counted(craft, port, 60)
    for stream in STREAMS:
        if stream["parameter"] is None:
            for number, _, _ in stream["messages"]:
                expected = 60000 * stream["period_denominator"] // stream["period_numerator"] * _frames(craft, number)
                assert _within(found.get(number, 0), expected, _frames(craft, number)), (stream["name"], found)


def default_rates():
    """Without any setting each stream has its default rate."""
    port = Counter()
    craft = new_craft(ports=[port])
    found = _counted(craft, port, 60)
    for stream in _by_parameter():
        for number, _, _ in stream["messages"]:
            expected = round(60 * stream["default"] * stream["numerator"] / stream["denominator"])
            frames = _frames(craft, number)
            assert _within(found.get(number, 0), expected * frames, frames), (stream["name"], found)


def nothing_is_reported_without_the_monitor():
    """Messages of a component that is not measured are not sent; all others are."""
    port = Counter()
    craft = new_craft(ports=[port])
    _both_generations(craft)
    needs([each for each in MEASURED if each["enabled"]], "a component that can be off")
    for measured in MEASURED:
        if measured["enabled"]:
            for owner in _owners(craft, measured["component"]):
                setattr(owner, measured["enabled"], False)
    found = _counted(craft, port, 20)
    for stream in STREAMS:
        for number, _, may_be_off in stream["messages"]:
            is_off = may_be_off or _frames(craft, number) == 0
            assert (number in found) != is_off or (stream["parameter"] and stream["default"] == 0), (number, found)


def _two_links():
    ports = [Port(), Port()]
    craft = new_craft(ports=ports)
    _both_generations(craft)
    run(craft, 2 * LINKS_US)
    return craft, [GroundStation(port) for port in ports]


def _interval(craft, station, number):
    station.command(dialect.MAV_CMD_GET_MESSAGE_INTERVAL, number)
    run(craft, 4 * LINKS_US)
    answer = station.received(messages.MessageInterval)
    assert len(answer) == 1, answer
    assert answer[0].message_id == number
    return answer[0].interval_us


def _frames_in(craft, port, number, seconds):
    port.frames = []
    run(craft, seconds * SECOND_US, STEP_US)
    return len([frame for frame in port.frames if (frame[7] | frame[8] << 8 | frame[9] << 16) == number])


def intervals_on_one_link():
    """The table of intervals: asked for on one link it changes there only, and what is reported is what is sent."""
    for stream in _by_parameter():
        number = stream["messages"][0][0]
        rate = stream["default"] * stream["numerator"] / stream["denominator"]
        own = int(1000000 / rate) if rate else -1
        fastest = SHORTEST_US[SENT.index(number)]
        craft, (station, other) = _two_links()
        frames = _frames(craft, number)
        needs(frames, "a message that is sent")
        assert _interval(craft, station, number) == own
        slow = fastest * 5
        for asked, expected in ((slow, slow), (-1, -1), (0, own), (fastest // 4, fastest), (0, own)):
            station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, asked)
            run(craft, 4 * LINKS_US)
            acks = station.received(messages.CommandAck)
            assert [ack.result for ack in acks] == [dialect.MAV_RESULT_ACCEPTED], (asked, acks)
            assert _interval(craft, station, number) == expected, asked
            count = 0 if expected < 0 else frames * 10 * SECOND_US // expected
            assert _within(_frames_in(craft, station.port, number, 10), count, frames), (asked, expected)
            assert _interval(craft, other, number) == own


def intervals_of_others():
    """A message that the vehicle does not have: denied, and its interval is 0; what is sent on request is off."""
    craft, (station, _) = _two_links()
    station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, 9999, 100000)
    run(craft, 4 * LINKS_US)
    assert [ack.result for ack in station.received(messages.CommandAck)] == [dialect.MAV_RESULT_DENIED]
    assert _interval(craft, station, 9999) == 0
    for number in ON_REQUEST:
        assert _interval(craft, station, number) == -1
        station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, 1000)
        run(craft, 4 * LINKS_US)
        assert _interval(craft, station, number) == SHORTEST_US[SENT.index(number)]


def tables_are_asked_for_together():
    """A message of several tables: one of each on request, each in the interval that is asked for, and off together."""
    needs(SHARED, "a message of several tables")
    for number, tables in SHARED.items():
        craft, (station, _) = _two_links()
        frames = sum(len(reported(craft, facts)) * facts["pages"] for facts in tables)
        own = [int(1000000 / facts["rate"]) for facts in tables if facts["rate"]]
        assert abs(_interval(craft, station, number) - min(own or [-1])) <= 1
        asked = 3 * max(facts["shortest_us"] for facts in tables)
        for interval_us in (asked, -1):
            station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, interval_us)
            run(craft, 4 * LINKS_US)
            acks = station.received(messages.CommandAck)
            assert [ack.result for ack in acks] == [dialect.MAV_RESULT_ACCEPTED], acks
            assert _interval(craft, station, number) == interval_us
            count = 10 * SECOND_US // asked * frames if interval_us > 0 else 0
            found = _frames_in(craft, station.port, number, 10)
            assert _within(found, count, frames), (number, interval_us, found, count)
        station.port.frames = []
        station.command(dialect.MAV_CMD_REQUEST_MESSAGE, number)
        run(craft, 4 * LINKS_US)
        found = [frame for frame in station.port.frames if (frame[7] | frame[8] << 8 | frame[9] << 16) == number]
        assert len(found) == frames, (number, len(found))


def withheld_messages_are_rejected_for_now():
    """While something is unknown that a message cannot say it is not sent, and a request for it is refused for now."""
    needs(WITHHELD, "a message that may be withheld")
    for number, quantities in WITHHELD.items():
        for component, attribute in quantities:
            craft, (station, _) = _two_links()
            owners = _owners(craft, component)
            for owner in owners:
                setattr(owner, attribute, None)
            for result, frames in (
                (dialect.MAV_RESULT_TEMPORARILY_REJECTED, 0),
                (dialect.MAV_RESULT_ACCEPTED, _frames(craft, number)),
            ):
                station.port.frames = []
                station.command(dialect.MAV_CMD_REQUEST_MESSAGE, number)
                run(craft, 4 * LINKS_US)
                found = len([frame for frame in station.port.frames if frame[7] | frame[8] << 8 == number])
                acks = station.received(messages.CommandAck)
                assert [ack.result for ack in acks] == [result], (number, attribute, acks)
                assert found >= frames, (number, attribute, found)
                found = _frames_in(craft, station.port, number, 20)
                rate = MESSAGES[number]["rate"]
                assert _within(found, 20 * rate * frames, frames), (number, attribute, found)
                know(craft.state)


def _request(station, data_stream, rate, start=1):
    station.send(messages.RequestDataStream, req_stream_id=data_stream, req_message_rate=rate, start_stop=start)


def data_streams_by_request():
    """A rate for one stream or for all, on one link, up to the fastest; a stop is off; the parameter rules again."""
    for stream in _by_parameter():
        needs(stream["data_stream"] is not None, "a number of the stream")
        number = stream["messages"][0][0]
        own = stream["default"] * stream["numerator"] / stream["denominator"]
        for data_stream in (stream["data_stream"], dialect.MAV_DATA_STREAM_ALL):
            craft, (station, other) = _two_links()
            frames = _frames(craft, number)
            fastest = stream["fastest_hz"]
            for rate, start, expected in ((5, 1, 5), (0, 1, 0), (1000, 1, fastest), (5, 0, 0)):
                _request(station, data_stream, rate, start)
                run(craft, 4 * LINKS_US)
                other.port.frames = []
                found = _frames_in(craft, station.port, number, 10)
                assert _within(found, frames * 10 * min(expected, fastest), frames), (
                    stream["name"],
                    rate,
                    start,
                    found,
                )
                seen = len([frame for frame in other.port.frames if frame[7] | frame[8] << 8 == number])
                assert _within(seen, frames * 10 * own, frames), (stream["name"], seen)
            steps = stream["maximum"] if stream["default"] != stream["maximum"] else stream["minimum"]
            craft.parameters.set(stream["parameter_name"], steps * stream["numerator"] / stream["denominator"])
            found = _frames_in(craft, station.port, number, 10)
            assert _within(found, frames * 10 * steps * stream["numerator"] / stream["denominator"], frames), found


def repeated_requests_keep_the_phase():
    """Ground stations repeat their requests: that neither adds frames nor takes any away."""
    stream = next((each for each in _by_parameter() if each["data_stream"] is not None), None)
    needs(stream, "a stream that can be asked for")
    number = stream["messages"][0][0]
    craft, (station, _) = _two_links()
    instances = _frames(craft, number)
    _request(station, stream["data_stream"], 3)
    run(craft, SECOND_US)
    count = 0
    start_us = mock_time.elapsed_us()
    for _ in range(100):
        _request(station, stream["data_stream"], 3)
        station.port.frames = []
        run(craft, 70 * 1000)
        count += len([frame for frame in station.port.frames if frame[7] | frame[8] << 8 == number])
    expected = instances * 3 * (mock_time.elapsed_us() - start_us) // SECOND_US
    assert abs(count - expected) <= instances, (count, expected)


def streams_go_on_across_the_wrap():
    """Rates hold where ticks_ms() starts again."""
    port = Counter()
    craft = new_craft(ports=[port], at_us=((1 << 30) - 10000) * 1000)
    found = _counted(craft, port, 20)
    for stream in STREAMS:
        rate = stream["default"] * stream["numerator"] / stream["denominator"]
        if stream["parameter"] is None:
            rate = 1000 * stream["period_denominator"] / stream["period_numerator"]
        for number, _, _ in stream["messages"]:
            expected = round(20 * rate * _frames(craft, number))
            assert _within(found.get(number, 0), expected, _frames(craft, number)), (stream["name"], found)
    mock_time.set_ticks_us(0)


CHECKS = (
    (rates_by_parameter, "streams.rate", "storage.reboot"),
    (default_rates, "streams.rate"),
    (fixed_rates, "streams.fixed"),
    (streams_go_on_across_the_wrap, "streams.fixed"),
    (nothing_is_reported_without_the_monitor, "component.reported"),
    (intervals_on_one_link, "services.intervals"),
    (intervals_of_others, "services.intervals"),
    (withheld_messages_are_rejected_for_now, "services.intervals"),
    (tables_are_asked_for_together, "services.intervals"),
    (data_streams_by_request, "services.data_streams"),
    (repeated_requests_keep_the_phase, "services.data_streams"),
)

if __name__ == "__main__":
    main(CHECKS)
