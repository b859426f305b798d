# Generated from templates/tests/program/stream_checks.py: do not edit.
# Inputs: 75c6c45e4da94834
"""Streams of the whole vehicle: rates by parameter, by interval and by request, each on its own link."""

from generation_checks import is_chosen, reported, reporting
from program_bench import (
    GOES_OUT,
    SECOND_US,
    GroundStation,
    Port,
    Sink,
    id_of,
    know,
    main,
    messages,
    mock_time,
    needs,
    new_craft,
    run,
)
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

STEP_US = min(10000, LINKS_US)  # between passes while frames are counted: as often as any stream can go


class Counter(Sink):
    """A port that counts the frames of each message."""

    def __init__(self):
        Sink.__init__(self)
        self.ids = {}

    def write(self, frame):
        """Take all."""
        number = id_of(frame)
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
    """Return whether so many were found, give or take the frames of two turns, which may just fall into the time."""
    return abs(found - expected) <= (2 * frames if expected else 0)


def _fixed_hz(stream):
    return 1000 * stream["period_denominator"] / stream["period_numerator"]


def rates_by_parameter():
    """Each rate, changed while the program runs, from the next pass on: so many frames in 10 seconds.

    All streams have rates at the same time, each another one, but for those that share a parameter.
    """
    streams = _by_parameter()
    names = [stream["parameter_name"] for stream in streams]
    port = Counter()
    craft = new_craft(ports=[port])
    _both_generations(craft)
    run(craft, SECOND_US)
    for turn in range(6):
        rates = []
        for stream in streams:
            place = names.index(stream["parameter_name"])
            choices = (0, stream["default"], 3, 7, stream["maximum"], stream["minimum"])
            steps = choices[(turn + place) % 6]
            if not stream["minimum"] <= steps <= stream["maximum"]:
                steps = stream["default"]
            rates.append(steps * stream["numerator"] / stream["denominator"])
            craft.parameters.set(stream["parameter_name"], rates[-1])
        found = _counted(craft, port, 10)
        for place, stream in enumerate(streams):
            for number, _, _ in stream["messages"]:
                turns, frames = 10 * rates[place], _frames(craft, number)
                assert _within(found.get(number, 0), turns * frames, frames), (stream["name"], rates, found)


def fixed_rates():
    """A message with a fixed rate, such as HEARTBEAT, keeps it for half a minute."""
    port = Counter()
    craft = new_craft(ports=[port])
    found = _counted(craft, port, 30)
    for stream in STREAMS:
        if stream["parameter"] is None:
            for number, _, _ in stream["messages"]:
                turns, frames = 30 * _fixed_hz(stream), _frames(craft, number)
                assert _within(found.get(number, 0), turns * frames, frames), (stream["name"], found)


def nothing_waits_once_it_is_due():
    """A message that is due when the link has its turn goes out in it, unless the turn is full."""
    craft = new_craft()  # its port says whether something has arrived: without that a link is served in each turn
    connection = craft.connections[0]
    run_turn = connection.run
    waiting = []

    def noted(now_ms):
        is_left = run_turn(now_ms)
        times = connection.streams._times
        for at in range(0, len(times) - 2, 4):
            due_ms, late_by, _, parts = times[at + 2 : at + 6]
            if parts and late_by >= 0 and not is_left and not 0 < due_ms - now_ms & 0x3FFFFFFF < 0x20000000:
                waiting.append((now_ms, at // 4, due_ms))
        return is_left

    connection.run = noted
    run(craft, 5 * SECOND_US)
    assert waiting == [], waiting[:3]


def default_rates():
    """Without any setting each stream has its default rate, and nobody says that something was left out."""
    port = Counter()
    craft = new_craft(ports=[port])
    found = _counted(craft, port, 30)
    for stream in _by_parameter():
        for number, _, _ in stream["messages"]:
            turns, frames = 30 * stream["default"] * stream["numerator"] / stream["denominator"], _frames(craft, number)
            assert _within(found.get(number, 0), turns * frames, frames), (stream["name"], found)
    for connection in craft.connections:
        connection.report()
    assert [text for text in craft.said() if "left out" in text[1]] == []


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
    return len([frame for frame in port.frames if id_of(frame) == number])


def intervals_on_one_link():
    """The table of intervals: asked for on one link it changes there only, and what is reported is what is sent.

    The first message of each stream has another interval at the same time.
    """
    streams = _by_parameter()
    craft, (station, other) = _two_links()
    numbers = [stream["messages"][0][0] for stream in streams]
    own = []
    for place, number in enumerate(numbers):
        stream = streams[place]
        rate = stream["default"] * stream["numerator"] / stream["denominator"]
        own.append(int(1000000 / rate) if rate else -1)
        assert _interval(craft, station, number) == own[-1]
    needs([number for number in numbers if _frames(craft, number)], "a message that is sent")
    for turn in range(5):
        expected = []
        for place, number in enumerate(numbers):
            fastest = SHORTEST_US[SENT.index(number)]
            slow = fastest * 5
            choices = ((slow, slow), (-1, -1), (0, own[place]), (fastest // 4, fastest), (0, own[place]))
            asked, interval_us = choices[(turn + place) % 5]
            expected.append(interval_us)
            station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, asked)
            run(craft, 4 * LINKS_US)
            acks = station.received(messages.CommandAck)
            assert [ack.result for ack in acks] == [dialect.MAV_RESULT_ACCEPTED], (asked, acks)
            assert _interval(craft, station, number) == interval_us, asked
        (sent,) = _sent_in(craft, 10, station)
        for place, number in enumerate(numbers):
            interval_us, frames = expected[place], _frames(craft, number)
            count = 0 if interval_us < 0 else frames * 10 * SECOND_US // interval_us
            assert _within(sent.count(number), count, frames), (number, interval_us, sent.count(number))
            assert _interval(craft, other, number) == own[place]


def intervals_of_others():
    """A message that the vehicle does not have: denied, and its interval is 0; what is sent on request is off."""
    craft, (station, _) = _two_links()
    station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, 9999, 100000)
    run(craft, 4 * LINKS_US)
    assert [ack.result for ack in station.received(messages.CommandAck)] == [dialect.MAV_RESULT_DENIED]
    assert _interval(craft, station, 9999) == 0
    for number, shortest_us in zip(SENT, SHORTEST_US):  # noqa: B905  MicroPython cannot
        own_us = _interval(craft, station, number)
        assert number not in ON_REQUEST or own_us == -1
        station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, 1)
        run(craft, 4 * LINKS_US)
        expected = shortest_us if shortest_us > 0 else own_us  # its stream's own is longer than what can be asked for
        assert _interval(craft, station, number) == expected, (number, expected)
        station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, -1)
        run(craft, 4 * LINKS_US)


def intervals_have_a_longest():
    """From one microsecond, taken as the shortest, to the largest float below 2 ** 30; others change nothing."""
    craft, (station, _) = _two_links()
    number = SENT[0]
    own = _interval(craft, station, number)
    for asked, is_taken in (
        (1073741760, True),
        (1073741824, False),
        (0.5, False),
        (-0.5, False),
        (-2, False),
        (float("nan"), False),
        (float("inf"), False),
        (-1, True),
        (1, True),
        (1e9, True),
    ):
        before = _interval(craft, station, number)
        station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, asked)
        run(craft, 4 * LINKS_US)
        result = dialect.MAV_RESULT_ACCEPTED if is_taken else dialect.MAV_RESULT_DENIED
        assert [ack.result for ack in station.received(messages.CommandAck)] == [result], asked
        shortest_us = SHORTEST_US[SENT.index(number)]
        taken = max(asked, shortest_us) if asked > 0 else asked
        if asked > 0 and shortest_us < 0:  # its stream's own, which is longer than what can be asked for
            taken = own
        assert _interval(craft, station, number) == (taken if is_taken else before), asked


def tables_are_asked_for_together():
    """A message of several tables: one of each on request, each in the interval that is asked for, and off together."""
    needs(SHARED, "a message of several tables")
    for number, tables in SHARED.items():
        craft, (station, _) = _two_links()
        frames = sum(len(reported(craft, facts)) * facts["pages"] for facts in tables)
        own = [int(1000000 / facts["rate"]) for facts in tables if facts["rate"]]
        assert abs(_interval(craft, station, number) - min(own or [-1])) <= 1
        asked = 3 * max(facts["shortest_us"] for facts in tables)
        if asked < 0:  # each of them goes so seldom that nothing else can be asked for
            continue
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
        found = [frame for frame in station.port.frames if id_of(frame) == number]
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
            setattr(craft.state, "update_" + component, lambda _board: None)  # a reading would set it again
            for result, frames in (
                (dialect.MAV_RESULT_TEMPORARILY_REJECTED, 0),
                (dialect.MAV_RESULT_ACCEPTED, _frames(craft, number)),
            ):
                station.port.frames = []
                station.command(dialect.MAV_CMD_REQUEST_MESSAGE, number)
                run(craft, 4 * LINKS_US)
                found = len([frame for frame in station.port.frames if id_of(frame) == number])
                acks = station.received(messages.CommandAck)
                assert [ack.result for ack in acks] == [result], (number, attribute, acks)
                assert found >= frames, (number, attribute, found)
                found = _frames_in(craft, station.port, number, 10)
                rate = MESSAGES[number]["rate"]
                assert _within(found, 10 * rate * frames, frames), (number, attribute, found)
                know(craft.state)
                run(craft, SECOND_US // 4)  # what was withheld, or has changed, may be announced


def _request(station, data_stream, rate, start=1):
    station.send(messages.RequestDataStream, req_stream_id=data_stream, req_message_rate=rate, start_stop=start)


def data_streams_by_request():
    """A rate for one stream or for all, on one link, up to the fastest; a stop is off; the parameter rules again."""
    streams = _by_parameter()
    needs([stream for stream in streams if stream["data_stream"] is not None], "a number of the stream")
    for stream in streams:
        if stream["data_stream"] is not None:
            _follows_requests(stream["data_stream"], [stream])
    numbered = [stream for stream in streams if stream["data_stream"] is not None]
    _follows_requests(dialect.MAV_DATA_STREAM_ALL, numbered)


def _follows_requests(data_stream, streams):
    craft, (station, other) = _two_links()
    for rate, start in ((5, 1), (0, 1), (1000, 1), (5, 0)):
        _request(station, data_stream, rate, start)
        run(craft, 4 * LINKS_US)
        sent, seen = _sent_in(craft, 5, station, other)
        for stream in streams:
            number, frames = stream["messages"][0][0], _frames(craft, stream["messages"][0][0])
            own = stream["default"] * stream["numerator"] / stream["denominator"]
            expected = min(rate, stream["fastest_hz"] or 1) if start else 0
            if frames:
                own_us = SECOND_US // expected if expected else -1
                if expected and not stream["fastest_hz"]:  # less often than once in a second, whatever is asked for
                    own_us = SHORTEST_US[SENT.index(number)]
                    expected = SECOND_US / own_us
                assert _interval(craft, station, number) == own_us, (stream["name"], rate, start)
            assert _within(sent.count(number), frames * 5 * expected, frames), (stream["name"], rate, start)
            assert _within(seen.count(number), frames * 5 * own, frames), (stream["name"], rate, start)
    rates = []
    for stream in streams:
        steps = stream["maximum"] if stream["default"] != stream["maximum"] else stream["minimum"]
        rates.append(steps * stream["numerator"] / stream["denominator"])
        craft.parameters.set(stream["parameter_name"], rates[-1])
    sent, _ = _sent_in(craft, 5, station, other)
    for place, stream in enumerate(streams):
        number, frames = stream["messages"][0][0], _frames(craft, stream["messages"][0][0])
        assert _within(sent.count(number), frames * 5 * rates[place], frames), (stream["name"], rates)


def an_interval_of_zero_is_the_streams_own():
    """The default of SET_MESSAGE_INTERVAL is the rate without requests, of this message and no other of its stream."""
    streams = [stream for stream in _by_parameter() if stream["data_stream"] is not None and stream["default"]]
    needs(streams, "a number of a stream")
    craft, (station, _) = _two_links()
    for stream in streams:
        number = stream["messages"][0][0]
        own_us = _interval(craft, station, number)
        _request(station, stream["data_stream"], 2 if own_us == SECOND_US else 1)
        run(craft, 4 * LINKS_US)
        assert _interval(craft, station, number) != own_us, stream["name"]
        others = [each[0] for each in stream["messages"] if each[0] != number]
        asked_us = [_interval(craft, station, other) for other in others]
        station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, 0)
        craft.parameters.changes += 1  # all rates are looked at again
        run(craft, 4 * LINKS_US)
        assert _interval(craft, station, number) == own_us, stream["name"]
        assert [_interval(craft, station, other) for other in others] == asked_us, stream["name"]


def _sent_in(craft, seconds, *stations):
    """Return the numbers of the messages that go out to each station in some seconds."""
    for station in stations:
        station.port.frames = []
    run(craft, seconds * SECOND_US, STEP_US)
    return [[id_of(frame) for frame in station.port.frames] for station in stations]


def repeated_requests_keep_the_phase():
    """Ground stations repeat their requests: that neither adds frames nor takes any away."""
    stream = next((each for each in _by_parameter() if each["data_stream"] is not None), None)
    needs(stream, "a stream that can be asked for")
    number = stream["messages"][0][0]
    craft, (station, _) = _two_links()
    instances = _frames(craft, number)
    _request(station, stream["data_stream"], 3)
    run(craft, SECOND_US)
    interval_us = _interval(craft, station, number)  # longer where the stream may not go so fast
    count = 0
    start_us = mock_time.elapsed_us()
    for _ in range(100):
        _request(station, stream["data_stream"], 3)
        station.port.frames = []
        run(craft, 70 * 1000)
        count += len([frame for frame in station.port.frames if id_of(frame) == number])
    expected = instances * (mock_time.elapsed_us() - start_us) // interval_us if interval_us > 0 else 0
    assert abs(count - expected) <= instances, (count, expected)


def streams_go_on_across_the_wrap():
    """Rates hold where ticks_ms() starts again."""
    port = Counter()
    craft = new_craft(ports=[port], at_us=((1 << 30) - 10000) * 1000)
    found = _counted(craft, port, 20)
    for stream in STREAMS:
        rate = stream["default"] * stream["numerator"] / stream["denominator"]
        if stream["parameter"] is None:
            rate = _fixed_hz(stream)
        for number, _, _ in stream["messages"]:
            turns, frames = 20 * rate, _frames(craft, number)
            assert _within(found.get(number, 0), turns * frames, frames), (stream["name"], found)
    mock_time.set_ticks_us(0)


def streams_go_on_after_standing_still():
    """The ticks go half round in 6 days, and once in 12: whatever was due then is due now, once, not in some days."""
    # Just before they are round, what was due looks like what is due: the longest interval tells them apart.
    slowest_hz = min([_fixed_hz(stream) for stream in STREAMS if stream["parameter"] is None] or [1])
    for hours in (24, 150, 7 * 24, 9 * 24, 11 * 24, 297 - int(2 / slowest_hz) // 3600):
        port = Counter()
        craft = new_craft(ports=[port], at_us=1000000)
        _counted(craft, port, 3)
        mock_time.advance_us(hours * 3600 * SECOND_US)
        found = _counted(craft, port, 20)
        for stream in STREAMS:
            if stream["parameter"] is None:
                rate = _fixed_hz(stream)
                for number, _, _ in stream["messages"]:
                    turns, frames = int(20 * rate), _frames(craft, number)
                    count = found.get(number, 0)
                    assert turns * frames <= count <= (turns + 1) * frames, (hours, stream["name"], found)
    mock_time.set_ticks_us(0)


def what_waits_for_room_is_noted():
    """A message that is due waits until there is room; one that has waited for a period or more is counted."""
    craft = new_craft()
    own = craft.connections[0].streams
    run(craft, 2 * SECOND_US)
    needs([number for number in GOES_OUT if own.interval_us(number) > 0], "a message that is sent by itself")
    budget = own._budget
    longest_us = max([own.interval_us(number) for number in GOES_OUT])
    for room, late_us, waits, is_counted in (
        (1000, 0, False, False),
        (0, longest_us, True, False),
        (0, 10 * longest_us, True, False),
        (1000, 0, False, True),
        (1000, 10 * longest_us, False, False),
    ):
        mock_time.advance_us(late_us + longest_us)
        budget[0], left_out = room, budget[1]
        own.run(mock_time.ticks_ms())
        assert own.has_waited == waits, (room, late_us)
        assert (budget[1] > left_out) == is_counted, (room, late_us, budget[1] - left_out)
        assert budget[0] == 0 if waits else budget[0] < room


CHECKS = (
    (what_waits_for_room_is_noted, "services.links"),
    (rates_by_parameter, "streams.rate", "storage.reboot"),
    (nothing_waits_once_it_is_due, "streams.fixed", "streams.rate"),
    (default_rates, "streams.rate"),
    (fixed_rates, "streams.fixed"),
    (streams_go_on_across_the_wrap, "streams.fixed"),
    (streams_go_on_after_standing_still, "streams.fixed"),
    (nothing_is_reported_without_the_monitor, "component.reported"),
    (intervals_on_one_link, "services.intervals"),
    (intervals_of_others, "services.intervals"),
    (intervals_have_a_longest, "services.intervals"),
    (withheld_messages_are_rejected_for_now, "services.intervals"),
    (tables_are_asked_for_together, "services.intervals"),
    (an_interval_of_zero_is_the_streams_own, "services.intervals"),
    (data_streams_by_request, "services.data_streams"),
    (repeated_requests_keep_the_phase, "services.data_streams"),
)
LONG = (
    rates_by_parameter,
    default_rates,
    fixed_rates,
    streams_go_on_across_the_wrap,
    streams_go_on_after_standing_still,
    intervals_on_one_link,
    data_streams_by_request,
    repeated_requests_keep_the_phase,
)

if __name__ == "__main__":
    main(CHECKS)
