"""The links of the board's own ports under a whole vehicle: partial writes, full buffers, faults, and coming back."""

from program_bench import (
    SECOND_US,
    Craft,
    GroundStation,
    Port,
    beats,
    live,
    machine,
    main,
    messages,
    needs,
    new_craft,
    quieted,
    run,
    run_passes,
    turns,
)
from program_facts import CONTROL_US, LENGTHS, LINKS, LINKS_US, MEASURED, PARAMETERS

import board
from serial_port import open_uart


class Line:
    """The other end of a scripted UART, as GroundStation takes it: whole frames are found by the receiver."""

    def __init__(self):
        machine.reset_serial()
        self.line = machine.serial(0)

    def arrives(self, frame):
        """Let bytes arrive at the UART."""
        self.line.arrives(bytes(frame))

    @property
    def frames(self):
        """Return the bytes that the UART has sent, as one piece."""
        return [bytes(self.line.sent)]

    @frames.setter
    def frames(self, _nothing):
        self.line.sent = bytearray()


def _wired(size=512):
    line = Line()
    port = open_uart("radio", 0, tx=0, rx=1, baud=57600, size=size)
    craft = new_craft(ports=[port])
    return craft, GroundStation(line), line.line, port


def partial_writes_keep_frames_whole():
    """A UART that takes a few bytes at a time, or none: the receiver finds whole frames and no false ones."""
    several = sum(sum(measured["are_on"]) for measured in MEASURED)  # each has messages of its own
    parts, seconds = [0, 1, 2, 3, 5, 7, 11, 0, 0, 13] + [32, 32] * (several - 1), 10
    needed = _bytes_sent(seconds) * 3 // 2  # a line that takes less would have to drop frames
    craft, station, line, port = _wired(max(512 * max(1, several), needed // seconds * 2))
    passes = len(parts)
    while sum(parts) * seconds * SECOND_US < needed * passes * LINKS_US:
        parts += [32] * 8  # whole pieces of the port, as many as it sends in a pass
        passes += 1
    line.parts = parts * 200
    run(craft, seconds * SECOND_US)
    found = station.received(*messages.ALL)
    assert len([each for each in found if each.ID == messages.Heartbeat.ID]) >= beats(10), len(found)
    assert (station.link.crc_errors, port.dropped) == (0, 0)


def _bytes_sent(seconds):
    """Return how many bytes go out in so many seconds over a line that takes all of them."""
    craft, station, _, _ = _wired(4096)
    run(craft, seconds * SECOND_US)
    return len(station.port.frames[0])


def _counting(port):
    """Return a list that grows with each frame that the port takes."""
    taken = []
    write = port.write

    def counted(frame):
        length = write(frame)
        if length:
            taken.append(length)
        return length

    port.write = counted
    return taken


def full_buffer_drops_whole_frames():
    """A UART that takes nothing for a while: frames are dropped whole and counted, the loop goes on, nothing breaks."""
    for size in range(300, 350, 15):
        craft, station, line, port = _wired(size)
        taken = _counting(port)
        run(craft, SECOND_US)
        line.room = 0
        for _ in range(20):  # a vehicle that has little to tell fills it slowly
            run(craft, 8 * SECOND_US)
            if port.dropped:
                break
        assert port.dropped > 0
        assert craft.scheduler.overruns == 0
        line.room = None
        run(craft, 5 * SECOND_US)
        assert len(station.received(*messages.ALL)) == len(taken), (size, "what was taken arrives")
        assert station.link.crc_errors == 0, size


def views_are_kept_of_what_goes_out():
    """From the start a link has a view of each length that goes out, which takes memory, and of no other."""
    expected = [length for first, last in LENGTHS for length in range(first, last + 1)]
    for connection in new_craft().connections:
        views = connection.link.room[1]
        assert [length for length in range(len(views)) if views[length] is not None] == expected, expected


def slow_line_takes_the_whole_list():
    """A list of parameters over a UART as slow as a radio: nothing is missing in it."""
    needs(PARAMETERS, "parameters")
    craft, station, line, _ = _wired()
    station.send(messages.ParamRequestList)
    for _ in range(2000 + turns(len(PARAMETERS))):
        line.room = 5760 * CONTROL_US // SECOND_US  # bytes of 57600 baud in a pass
        run_passes(craft, 1)
    values = station.received(messages.ParamValue)
    assert [value.param_index for value in values] == list(range(values[0].param_count))


def faults_of_a_line_are_survived():
    """A UART that raises: the loop goes on, and telemetry returns when the fault has gone."""
    craft, station, line, port = _wired()
    line.failures = 100000
    run(craft, 5 * SECOND_US)
    assert not port.is_up
    assert craft.scheduler.overruns == 0
    line.failures = 0
    station.received()
    run(craft, 5 * SECOND_US)
    assert port.is_up
    assert len(station.received(messages.Heartbeat)) >= beats(5)


def absent_line_is_survived():
    """A UART that cannot be opened: the vehicle runs without it, and other links work."""
    machine.reset_serial()
    machine.serial(0).absent = True
    other = Port()
    craft = new_craft(ports=[open_uart("radio", 0, tx=0, rx=1, baud=57600, size=512), other])
    machine.serial(0).absent = False
    run(craft, 5 * SECOND_US)
    assert len(GroundStation(other).received(messages.Heartbeat)) >= beats(5)


def one_broken_port_leaves_the_others_alone():
    """A port that raises what no port should: its link stands still, the other links and the loop go on."""
    broken, whole = Port(), Port()

    def fail(*_arguments):
        raise ValueError("broken")

    broken.readinto = fail
    broken.write = fail
    craft = new_craft(ports=[broken, whole])
    station = GroundStation(whole)
    run(craft, 5 * SECOND_US)
    told = [text for _, text in craft.said() if "fault ValueError" in text]
    assert 3 <= len(told) <= 6, told  # once a second
    assert len(station.received(messages.Heartbeat)) >= beats(5)
    station.command(410)
    run_passes(craft, 4)
    assert len(station.received(messages.CommandAck)) == 1


def a_fault_of_any_part_is_counted():
    """Each part of a pass that raises is counted, and told now and then; the others go on."""
    for part in ("streams", "announcements", "services", "texts"):
        craft = new_craft()
        connection = craft.connections[0]
        run_passes(craft, 2)
        owner = {"services": connection.services, "texts": connection._texts}.get(part, connection.station.streams)
        setattr(owner, "announce" if part == "announcements" else "run", _broken)
        craft.port.frames = []
        run(craft, 2 * SECOND_US, LINKS_US)
        told = [text for text in craft.said() if "fault ValueError" in text[1]]
        assert 0 < len(told) < connection.faults, (part, craft.said())
        heard = GroundStation(craft.port).received(messages.Heartbeat)
        assert part == "streams" or len(heard) >= beats(2), (part, len(heard))


def one_message_in_a_pass():
    """Let a pass take in or send a single message: streams, answers, lists and texts have their turns, too."""
    most = Craft.MESSAGES
    Craft.MESSAGES = 1
    try:
        craft = new_craft()
        craft.MESSAGES = 1
    finally:
        Craft.MESSAGES = most
    quieted(craft)  # else they might be more than the port below has room for
    craft.port.room = 1  # before it is polled again, which a pass does that has sent nothing
    station = GroundStation(craft.port)
    run_passes(craft, 20)
    craft.port.frames = []
    craft.texts("warning: this is one of many")
    expected = [messages.Statustext, messages.Ping, messages.CommandAck]
    craft.port.room = 0
    station.command(410)
    run_passes(craft, 3)
    craft.port.room = 1
    if PARAMETERS:
        station.send(messages.ParamRequestList)
        expected.append(messages.ParamValue)
    seconds = 2 + 4 * len(PARAMETERS) * LINKS_US // SECOND_US  # the text comes behind the list
    for number in range(5):  # an answer for which there is no room just then is better none than a late one
        station.send(messages.Ping, target_system=0, target_component=0, seq=number)
        run(craft, seconds * SECOND_US // 5 + number * LINKS_US, LINKS_US)
    kinds = [type(message) for message in station.received(messages.Heartbeat, *expected)]
    assert kinds.count(messages.Heartbeat) >= beats(2), kinds  # during the list, the port may be full when one is due
    assert [kind for kind in expected if kind not in kinds] == [], kinds


def _broken(*_arguments):
    raise ValueError("it is broken")


def boards_own_ports():
    """With the ports of the board description, on a host without credentials: the program runs and tells about it."""
    needs(hasattr(board.Board, "open_ports"), "links")
    machine.reset_serial()
    if hasattr(board, "open_usb"):  # it would write to where this program prints
        board.open_usb = lambda _name, size: Port()  # noqa: ARG005  as the board calls it
    craft = new_craft(ports=new_craft().board.open_ports())

    async def story():
        import asyncio  # noqa: PLC0415

        await asyncio.sleep_ms(5000)

    live(craft, story)
    assert craft.scheduler.overruns == 0
    assert [connection.faults for connection in craft.connections] == [0] * len(craft.connections)


def what_arrives_is_counted():
    """Frames that are right, of messages that nobody takes, with unknown flags, and damaged ones: each once."""
    craft = new_craft()
    link = craft.connections[0].link
    whole = bytes(GroundStation(Port()).link.encode(messages.Ping(unknown=False).update(time_usec=1, target_system=9)))
    assert whole.count(b"\xfd") + whole.count(b"\xfe") == 1, "nothing in it looks like the start of a frame"
    names = ("received", "unknown", "dropped", "crc_errors")
    for name, at, byte in zip(names, (0, 8, 2, len(whole) - 1), (0xFD, 0xEE, 2, whole[-1] ^ 1)):  # noqa: B905  MicroPython
        before = [getattr(link, each) for each in names]
        for count in (1, 2, 3):
            craft.port.arrives((whole[:at] + bytes([byte]) + whole[at + 1 :]) * count)
            run_passes(craft, 4)
        found = [getattr(link, each) - earlier for each, earlier in zip(names, before)]  # noqa: B905  as above
        assert found == [6 if each == name else 0 for each in names], (name, found)
    link = GroundStation(Port()).link
    link._state[16] = 1000  # so many bytes may be looked at, and [15] of them were: frames_plain says so
    link.put(whole * 3 + bytes(5))
    for count in (1, 2, 3):
        assert link.receive() is not None
        assert link._state[15] == count * (len(whole) - 2), (count, link._state[15])
    assert link.receive() is None
    assert link._state[15] == 3 * (len(whole) - 2) + 5, link._state[15]
    link._state[15] = 0
    assert whole[4] == 0, "so that it is a HEARTBEAT to who takes the byte before it for the first one of MAVLink 1"
    link.put(b"\xfe" + whole + bytes(300))
    found = [link.receive() for _ in range(2)]
    assert [message and message.ID for message in found] == [messages.Ping.ID, None], found
    assert link.crc_errors == 1


def the_end_of_a_frame_is_waited_for():
    """Half a second, and no longer: then what stands behind a frame without an end is found."""
    craft = new_craft()
    link, station = craft.connections[0].link, GroundStation(Port()).link
    whole = bytes(station.encode(messages.Ping(unknown=False).update(time_usec=1, target_system=9)))
    longer = bytes(station.encode(messages.CommandLong(unknown=False).update(param7=1.0, confirmation=1)))
    assert len(longer) > 12 + len(whole), "it would take the other one for its own end"
    before = link.received
    for part, wait_us, count in (
        (whole[:-1], 400_000, 0),
        (whole[-1:], 2 * LINKS_US, 1),
        (longer[:12] + whole, 400_000, 1),
        (b"", 200_000, 2),
        (longer[:12] + whole[:4], 300_000, 2),  # what comes behind its beginning makes it no younger
        (whole[4:], 100_000, 2),
        (b"", 200_000, 3),
    ):
        craft.port.arrives(part)
        run(craft, wait_us)
        assert link.received - before == count, (part, link.received - before)


OPENED = {  # by what the board opens a link with: its kind, and what the first arguments are
    "open_uart": ("uart", "name", "uart"),
    "open_fixed_uart": ("uart", "name", "uart"),
    "open_usb": ("usb", "name"),
    "UdpPort": ("udp", "name", "to", "udp"),
    "TcpServer": ("tcp_server", "name", "tcp_server"),
    "TcpClient": ("tcp_client", "name", "to", "tcp_client"),
}


def ports_are_those_of_the_specification():
    """Each link is opened in its order, and with its settings."""
    needs(LINKS, "links")
    opened = []

    def noting(kind, names):
        def note(*values, log=None, **settings):  # noqa: ARG001  where a port tells what goes wrong
            settings.update(dict(zip(names, values)))  # noqa: B905  MicroPython's has no strict
            opened.append((kind, settings))

        return note

    craft = new_craft()
    true = {name: getattr(board, name) for name in OPENED if hasattr(board, name)}
    try:
        for name in true:
            kind, *names = OPENED[name]
            setattr(board, name, noting(kind, names))
        craft.board.open_ports()
    finally:
        for name, opener in true.items():
            setattr(board, name, opener)
    assert opened == list(LINKS), opened


CHECKS = (
    (partial_writes_keep_frames_whole, "services.links"),
    (full_buffer_drops_whole_frames, "services.links"),
    (views_are_kept_of_what_goes_out,),
    (slow_line_takes_the_whole_list, "storage.read"),
    (faults_of_a_line_are_survived, "services.links"),
    (absent_line_is_survived, "services.links"),
    (one_broken_port_leaves_the_others_alone, "services.links"),
    (a_fault_of_any_part_is_counted, "services.links"),
    (one_message_in_a_pass, "services.links"),
    (boards_own_ports, "services.links"),
    (what_arrives_is_counted, "services.garbage"),
    (the_end_of_a_frame_is_waited_for, "services.garbage"),
    (ports_are_those_of_the_specification, "services.links"),
)
LONG = (
    partial_writes_keep_frames_whole,
    full_buffer_drops_whole_frames,
    slow_line_takes_the_whole_list,
    faults_of_a_line_are_survived,
    boards_own_ports,
)

if __name__ == "__main__":
    main(CHECKS)
