"""Parts of the program by themselves: who is heard, what is told, what waits, and what is kept or refused."""

from program_bench import (
    GOES_OUT,
    OTHER_SYSTEM,
    SECOND_US,
    TURN_MS_US,
    Flash,
    finish,
    id_of,
    main,
    messages,
    mock_time,
    needs,
    needs_arming,
    new_craft,
    run,
    run_passes,
    sequence_of,
)
from program_facts import COMPONENT_ID, LINKS_US, PARAMETERS, SENT, STREAMS, SYSTEM_ID
from storage import Storage
from texts import Texts

import dialect

SILENCE_MS = 10000


def listeners_are_known_by_their_names():
    """One that is heard is new at first and after a silence; where all places are taken the longest silent one goes.

    Times are compared where they start again, too. What is expected stands in a dictionary of names.
    """
    from listeners import Listeners  # noqa: PLC0415  the clock has to be in place before

    lot, now_ms, places = 1, 0x3FFFFFFF - 60000, 3
    listeners, known, last = Listeners(SILENCE_MS, places), {}, 0
    for turn in range(600):
        lot = lot * 1103515245 + 12345 & 0x3FFFFFFF
        now_ms += (1, 900, 2500, SILENCE_MS - 1, SILENCE_MS, 1700, 300, 40)[lot >> 20 & 7]
        ticks_ms = now_ms & 0x3FFFFFFF
        if turn % 7 == 6:
            listeners.forget_silent(ticks_ms)
            known = {name: heard_ms for name, heard_ms in known.items() if now_ms - heard_ms < SILENCE_MS}
            last = last if last in known else 0
        elif turn % 5 == 4 and last:
            listeners.heard_ms = ticks_ms  # the same one again
            known[last] = now_ms
        else:
            name = 0x100 * (1 + (lot >> 10 & 3)) + 1
            is_new = name not in known or now_ms - known[name] >= SILENCE_MS
            if name not in known:
                known = {each: heard_ms for each, heard_ms in known.items() if now_ms - heard_ms < SILENCE_MS}
                if len(known) == places:
                    is_new = False
                    del known[min(known, key=known.get)]
            known[name] = now_ms
            last = name
            assert listeners.hear(name, ticks_ms) == is_new, (turn, name, known)
            assert listeners.heard_ms == ticks_ms
        assert listeners.last == last, (turn, listeners.last, known)
        assert sorted([each for each in listeners.names if each]) == sorted(known), (turn, known)
    assert len(Listeners(1).names) > 1


class Shown:
    """Something that cannot be shown."""

    def __str__(self):
        raise ValueError("no")

    __repr__ = __str__


def texts_are_kept_by_their_numbers():
    """The newest by their numbers with the severity that stands in front; whoever shows them may fail."""
    shown = []
    texts = Texts(shown.append, 3)
    assert (texts.last, texts.get(0), texts.get(1)) == (0, None, None)
    texts("error: one", 2, None)
    assert (texts.last, texts.get(1)) == (1, (dialect.MAV_SEVERITY_ERROR, "one 2 None"))
    texts("warning: w")
    texts("notice: n")
    texts("plain error: p")
    texts.say(0, "worse")  # MAV_SEVERITY_EMERGENCY
    assert shown == ["error: one 2 None", "warning: w", "notice: n", "plain error: p", "error: worse"], shown
    assert [texts.get(number) for number in range(-1, 7)] == [None] * 4 + [
        (dialect.MAV_SEVERITY_NOTICE, "n"),
        (dialect.MAV_SEVERITY_INFO, "plain error: p"),
        (0, "worse"),
        None,
    ]
    texts("x", Shown())
    assert texts.get(6) == (dialect.MAV_SEVERITY_ERROR, "a text cannot be shown: ValueError"), texts.get(6)

    def fail(_text):
        raise OSError(5)

    texts = Texts(fail)
    texts("kept")
    assert texts.get(1) == (dialect.MAV_SEVERITY_INFO, "kept")


def a_save_begins_with_what_is_there():
    """Nothing is done before it begins; the newest slot stays, though nobody has loaded it; too much is refused."""
    flash = Flash()
    flash.files = {}
    slots = ("a", "b")
    storage = Storage(slots, 64)
    assert (storage.step(), storage.is_saving, storage.problem) == (False, False, None)
    for payload in (b"one", b"two", b"three"):
        storage = Storage(slots, 64)
        storage.begin(payload)
        finish(storage)
        assert (storage.problem, storage.is_saving) == (None, False)
        assert Storage(slots, 64).load() == payload
    assert len(flash.files) == 2
    assert [name for name, content in flash.files.items() if b"two" in content] == ["b"]
    try:
        storage.begin(bytes(0x10000))
    except ValueError as error:
        assert error.args[0] == "a slot holds up to 65535 bytes", error  # noqa: PT017
    else:
        raise AssertionError("it is taken")
    assert not storage.is_saving
    storage.begin(bytes(0xFFFF))
    assert storage.is_saving
    opened = flash.open

    class Full:
        """A file that takes nothing."""

        def write(self, _data):
            """Take nothing."""
            return 0

        def close(self):
            """Be closed."""

    import storage as module  # noqa: PLC0415  its files are others here

    try:
        module.open = lambda path, mode: Full() if mode == "wb" else opened(path, mode)
        finish(storage)
    finally:
        module.open = opened
    assert storage.problem.startswith("b cannot be written: OSError"), storage.problem
    assert Storage(slots, 64).load() == b"three"
    for damage, words in (
        (lambda content: content[:9], "it is too short"),
        (lambda content: b"x" + content[1:], "it begins with something else"),
        (lambda content: content[:4] + b"\x02" + content[5:], "it begins with something else"),
        (lambda content: content + b"x", "its length is wrong"),
        (lambda content: content[:-1], "its length is wrong"),
        (lambda content: content[:-1] + bytes([content[-1] ^ 1]), "its checksum is wrong"),
    ):
        flash.files = {"a": damage(flash.files["a"])}
        storage = Storage(slots, 64)
        loaded = storage.load()
        assert (loaded, storage.problem) == (None, f"a is damaged: {words}"), (loaded, storage.problem)
        flash.files = {}
        storage.begin(b"three")
        finish(storage)
        assert list(flash.files) == ["a"]


def records_that_are_cut():
    """Records of dump(), cut anywhere: whole ones count, and one that ends within is told; names are checked."""
    needs(PARAMETERS, "parameters")
    from parameters import Parameters  # noqa: PLC0415  there are some

    own = Parameters()
    changed = [each for each in PARAMETERS if each["minimum"] != each["default"]][:3]
    needs(changed, "a parameter with another value than its default")
    for facts in changed:
        setattr(own, facts["attribute"], facts["minimum"])
    data, ends = own.dump(), [0]
    while ends[-1] < len(data):
        ends.append(ends[-1] + 1 + data[ends[-1]] + 4)
    assert len(ends) == len(changed) + 1
    for cut in range(len(data) + 1):
        fresh = Parameters()
        whole = len([end for end in ends[1:] if end <= cut])
        expected = [] if cut in ends else ["the stored parameters end within one"]
        assert fresh.restore(data[:cut]) == expected, cut
        for place, facts in enumerate(changed):
            kept = facts["minimum" if place < whole else "default"]
            assert getattr(fresh, facts["attribute"]) == kept, (cut, facts["name"])
    for name in ("", "NO_SUCH", changed[0]["name"][:-1], changed[0]["name"] + " ", changed[0]["name"].lower()):
        try:
            own.get(name)
        except KeyError as error:
            assert error.args[0] == name  # noqa: PT017
            continue
        raise AssertionError(name)


def services_can_be_taken_twice():
    """Code that takes a message, too, gets it after the program; what it takes of all, whoever that is for."""
    craft = new_craft()
    services, taken = craft.connections[0].services, []
    station = craft.ground_station()
    services.take(messages.Ping, lambda message: taken.append(("own", message.raw("seq"))))
    services.take_any(messages.Ping.ID, lambda _message: taken.append("any"))
    own, other = (SYSTEM_ID, COMPONENT_ID), (OTHER_SYSTEM, 0)
    for system, component, count in ((0, 0, 1), own + (1,), (SYSTEM_ID, 0, 1), (0, COMPONENT_ID, 1), other + (0,)):  # noqa: RUF005
        station.send(messages.Ping, target_system=system, target_component=component, seq=5)
        run_passes(craft, 4)
        assert taken == [("own", 5), "any"] * count, (system, component, taken)
        del taken[:]
    assert len(station.received(messages.Ping)) == 1, "who pings everybody is answered by the program, too"
    services.take_any(77, lambda message: taken.append(message.ID))
    craft.connections[0].link._messages[77] = False
    craft.connections[0].link._classes[77] = messages.CommandAck
    station.send(messages.CommandAck, target_system=OTHER_SYSTEM)
    run_passes(craft, 4)
    assert taken == [77]
    assert craft.connections[0].faults == 0, craft.said()


def at_rest(craft):
    """Let no message go out of its own accord."""
    for number in GOES_OUT:
        craft.connections[0].streams.set_interval(number, -1)


def answers_wait_for_room():
    """In their order, up to the newest few; what is given up is counted, as is what waits for a port that is down."""
    craft = new_craft()
    station, connection = craft.ground_station(), craft.connections[0]
    run(craft, SECOND_US)
    at_rest(craft)
    station.received()
    craft.port.room = 0
    asked = list(range(400, 420))
    for number in asked:
        station.command(number)
        run_passes(craft, 2)
    craft.port.room = None
    asked.append(420)  # its answer comes behind those that wait
    station.command(420)
    run_passes(craft, 10)
    found = [ack.command for ack in station.received(messages.CommandAck)]
    assert 1 < len(found) < len(asked), found
    assert found == asked[-len(found) :]
    assert connection.lost_replies == len(asked) - len(found)
    before = connection.lost_replies
    craft.port.room = 0
    for number in asked[:3]:
        station.command(number)
    run_passes(craft, 4)
    craft.port.is_up = False
    run_passes(craft, 4)
    craft.port.room, craft.port.is_up = None, True
    run_passes(craft, 4)
    assert [ack.command for ack in station.received(messages.CommandAck)] == []
    assert connection.lost_replies == before + 3


def what_is_left_out_is_told_once():
    """So many messages for which there was no room since the last report, and nothing where there are none."""
    connection = new_craft().connections[0]
    told = []
    connection._log = lambda *words: told.append(words[-1])
    for left_out in (3, 0, 5):
        connection._budget[1] += left_out
        connection.report()
    assert told == [3, 5], told


def a_message_that_is_asked_for_waits_for_room():
    """One that the port did not take goes out later with the next number: who receives it counts none as lost."""
    craft = new_craft()
    station, link = craft.ground_station(), craft.connections[0].link
    run(craft, SECOND_US)
    needs(SENT, "a message that is sent")
    at_rest(craft)
    craft.port.frames = []
    craft.port.room = 0
    station.command(dialect.MAV_CMD_REQUEST_MESSAGE, SENT[0])
    run_passes(craft, 6)
    errors = link.tx_errors
    craft.port.room = 1
    run_passes(craft, 8)
    frames = craft.port.frames
    found = [id_of(frame) for frame in frames]
    assert found[:2] == [messages.CommandAck.ID, SENT[0]], found
    numbers = [sequence_of(frame) for frame in frames]
    assert [each - numbers[0] & 0xFF for each in numbers] == list(range(len(numbers))), numbers
    assert link.tx_errors == errors, (errors, link.tx_errors)


def faults_are_told_after_days():
    """One that comes half a turn of the ticks after another is told: to that time the other is not ahead of it."""
    for later_us in (TURN_MS_US // 2 + SECOND_US, TURN_MS_US - 3 * SECOND_US):
        craft = new_craft()
        station = craft.ground_station()
        craft.connections[0].services.take(messages.Ping, fail)
        for count in (1, 2):
            station.send(messages.Ping)
            run_passes(craft, 4)
            told = [text for _, text in craft.said() if "fault ValueError" in text]
            assert len(told) == count, (count, told)
            run(craft, 5 * SECOND_US // 2, LINKS_US)
            mock_time.set_ticks_us(mock_time.elapsed_us() + later_us)


def fail(_message):
    """Be broken."""
    raise ValueError("broken")


def arming_asks_the_users_code():
    """on_arm() is called once, and keeps it disarmed where it fails; so does a restart that is coming."""
    needs_arming()
    craft = new_craft()
    on_arm, on_disarm = craft.on_arm, craft.on_disarm
    craft.on_arm = lambda: fail(None)
    assert craft.arm(force=True) == "Arm: on_arm() failed: " + repr(ValueError("broken"))
    assert not craft.is_armed
    craft.on_arm = on_arm
    assert [craft.arm(force=True) for _ in range(2)] == [None, None]
    assert (craft.is_armed, craft.calls) == (True, ["on_arm"])
    craft.on_disarm = lambda: fail(None)
    craft.disarm()
    assert not craft.is_armed
    assert craft.said("on_disarm() failed"), craft.said()
    craft.on_disarm = on_disarm
    craft.disarm()
    assert craft.calls == ["on_arm"], "it is disarmed already"
    assert craft.reboot() is None
    assert craft.arm(force=True) == "PreArm: the vehicle is about to restart"
    assert not craft.is_armed


def a_stream_takes_back_what_was_asked_for_a_message():
    """Its messages go out at the rate that is asked for, though one had an interval, also where that is repeated."""
    streams = [each for each in STREAMS if each["data_stream"] and each["messages"] and each["fastest_hz"] >= 2]
    needs(streams, "a data stream")
    craft = new_craft()
    own, looked_at = craft.connections[0].streams, 0
    for stream in streams:
        number = stream["messages"][0][0]
        own.set_interval(number, 0)
        own.request(stream["data_stream"], 1)
        if own.interval_us(number) != 1000000:  # it is not the one that is chosen, or another stream has it, too
            continue
        looked_at += 1
        for interval_us in (-1, 7000000):
            assert own.set_interval(number, interval_us)
            assert own.interval_us(number) == interval_us
            for _ in range(2):
                assert own.request(stream["data_stream"], 2)
                assert own.interval_us(number) == 500000, (stream["name"], interval_us, own.interval_us(number))
        assert own.request(stream["data_stream"], 60000)
        assert own.interval_us(number) == 1000000 // stream["fastest_hz"]
        assert own.set_interval(number, 0)
        assert own.request(stream["data_stream"], 0)
        assert own.interval_us(number) == -1
    assert not own.request(250, 1)
    assert looked_at, "no stream"


def what_was_asked_for_holds_while_its_parameter_does():
    """The rate of a stream stays while other parameters change, though its own one has changed before."""
    streams = [
        each for each in STREAMS if each["data_stream"] and each["messages"] and each["minimum"] < each["maximum"]
    ]
    needs(streams, "a data stream with a parameter")
    craft = new_craft()
    own, parameters = craft.connections[0].streams, craft.parameters

    def follow(stream, steps):
        setattr(parameters, stream["parameter"], steps)
        own.run(mock_time.ticks_ms())

    for stream in streams:
        number = stream["messages"][0][0]
        follow(stream, stream["minimum"])
        follow(stream, stream["maximum"])
        before_us = own.interval_us(number)
        own.request(stream["data_stream"], 0)
        asked_us = own.interval_us(number)
        follow(stream, stream["maximum"])  # it is stored, and nothing changes
        assert own.interval_us(number) == asked_us, stream["name"]
        follow(stream, stream["minimum"])
        follow(stream, stream["maximum"])
        assert own.interval_us(number) == before_us, stream["name"]


def a_minute_is_worth_a_save():
    """Once all saves are used up that may come at once, the next one is due a minute later; it looks each 100 ms."""
    needs(PARAMETERS, "parameters")
    craft = new_craft()
    craft.parameters.changes += 1
    craft._credit_ms = 0
    looks = 1
    while not craft._is_due_to_save():
        looks += 1
        assert looks < 1000
    assert looks == 600, looks
    assert len(craft.said("parameters change so often")) == 1, craft.said()
    for _ in range(10 * 600 + 1):
        craft._is_due_to_save()
    assert craft._credit_ms == 600000, "ten saves may come at once, however long none has come"


def texts_from_before_the_link_are_sent():
    """All that is told while the vehicle is made goes to the first station, too, from the first text on."""
    craft = new_craft()
    told = [(severity, text[:50]) for severity, text in craft.said()]
    needs(told, "a text at the start")
    station = craft.ground_station()
    run(craft, SECOND_US, LINKS_US)
    found = [message for message in station.received(messages.Statustext) if message.raw("chunk_seq") == 0]
    assert [(message.severity, message.text) for message in found][: len(told)] == told, found


CHECKS = (
    (listeners_are_known_by_their_names,),
    (texts_are_kept_by_their_numbers,),
    (a_save_begins_with_what_is_there, "storage.defaults"),
    (records_that_are_cut, "storage.defaults"),
    (services_can_be_taken_twice,),
    (answers_wait_for_room, "services.links"),
    (a_message_that_is_asked_for_waits_for_room, "services.links"),
    (what_is_left_out_is_told_once, "services.links"),
    (faults_are_told_after_days, "services.links"),
    (texts_from_before_the_link_are_sent,),
    (arming_asks_the_users_code,),
    (a_stream_takes_back_what_was_asked_for_a_message,),
    (what_was_asked_for_holds_while_its_parameter_does,),
    (a_minute_is_worth_a_save, "storage.set"),
)

if __name__ == "__main__":
    main(CHECKS)
