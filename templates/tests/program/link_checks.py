"""The links of the board's own ports under a whole vehicle: partial writes, full buffers, faults, and coming back."""

import io
import socket
import sys

from program_bench import (
    SECOND_US,
    Craft,
    GroundStation,
    Port,
    live,
    machine,
    main,
    messages,
    mock_time,
    needs,
    new_craft,
    run,
    run_passes,
)
from program_facts import CONTROL_US, LINKS, LINKS_US, MEASURED, PARAMETERS, STREAMS

import board
import network
import network_port
from serial_port import StreamPort, open_uart
from udp_port import UdpPort


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
    assert len([each for each in found if each.ID == messages.Heartbeat.ID]) >= _beats(10), len(found)
    assert (station.link.crc_errors, port.dropped) == (0, 0)


def _bytes_sent(seconds):
    """Return how many bytes go out in so many seconds over a line that takes all of them."""
    craft, station, _, _ = _wired(4096)
    run(craft, seconds * SECOND_US)
    return len(station.port.frames[0])


def _beats(seconds):
    """Return how many HEARTBEATs come at least in so many seconds."""
    for stream in STREAMS:
        if stream["parameter"] is None and stream["messages"] and stream["messages"][0][0] == messages.Heartbeat.ID:
            return seconds * 1000 * stream["period_denominator"] // stream["period_numerator"] - 1
    return 0


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


def slow_line_takes_the_whole_list():
    """A list of parameters over a UART as slow as a radio: nothing is missing in it."""
    needs(PARAMETERS, "parameters")
    craft, station, line, _ = _wired()
    station.send(messages.ParamRequestList)
    for _ in range(2000):
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
    assert len(station.received(messages.Heartbeat)) >= _beats(5)


class Raising:
    """A stream that raises for so many calls, and then takes and gives all there is."""

    def __init__(self, failures):
        self.failures = failures
        self.sent = b""

    def _fail(self):
        if self.failures:
            self.failures -= 1
            raise OSError(5)

    def write(self, data):
        """Take bytes."""
        self._fail()
        self.sent += bytes(data)
        return len(data)

    def readinto(self, buffer):
        """Give bytes."""
        self._fail()
        return len(buffer)


def a_stream_that_raises_takes_nothing():
    """Nothing has gone out or come in then, and all bytes of a frame go out later, in their order."""
    for failures in range(4):
        stream = Raising(failures)
        port = StreamPort("raising", stream, 100)
        frame = bytes(range(80))
        assert port.write(frame) == len(frame)
        assert port.is_up == (not failures)
        for _ in range(4):
            port.poll(0)
        assert stream.sent == frame, failures
        assert port.sent == len(frame), failures
        assert port.is_up
        stream.failures, buffer = failures, bytearray(5)
        assert [port.readinto(buffer) for _ in range(4)] == [0] * failures + [5] * (4 - failures)
        assert port.received == 5 * (4 - failures)


class Sipping:
    """A stream that takes and gives `part` bytes of what it is asked for, or as many as there are."""

    def __init__(self):
        self.part = None
        self.sent = b""

    def write(self, data):
        """Take a part, or say None."""
        if self.part is None:
            return None
        self.sent += bytes(data[: self.part])
        return min(self.part, len(data))

    def readinto(self, _buffer):
        """Tell of a part, even one that no stream can give."""
        return self.part


def what_waits_goes_out_in_its_order():
    """Frames that fit into what is free are kept, and others dropped, however the stream takes them."""
    lot, size = 1, 100
    stream = Sipping()
    port = StreamPort("sipping", stream, size)
    port.sent = port.dropped = port.received = 0x3FFFFFFF - 20
    taken, dropped = b"", 0
    for turn in range(400):
        lot = lot * 1103515245 + 12345 & 0x3FFFFFFF
        stream.part = (None, None, 0, 1, 31, 32, 33, 200)[lot >> 20 & 7]
        free = size - (len(taken) - len(stream.sent))
        before = len(stream.sent)
        if lot >> 10 & 3 == 0:
            is_left = port.poll(turn)
            assert is_left == (len(taken) > len(stream.sent)), turn
            assert stream.part != 200 or not is_left, "all goes out where all is taken"
            assert not stream.part or free == size or len(stream.sent) > before, "what waits is offered"
            assert stream.part is not None or len(stream.sent) == before, turn
        else:
            length = (free, free + 1, max(free - 1, 1), 20)[lot >> 10 & 3]
            frame = bytes([turn + at & 0xFF for at in range(length)])
            fits = length <= free
            assert port.write(frame) == (length if fits else 0), (turn, length, free)
            taken += frame if fits else b""
            dropped += not fits
            assert not fits or free < size or len(stream.sent) - before == min(length, stream.part or 0), (
                "it is offered"
            )
        assert stream.sent == taken[: len(stream.sent)], turn
        assert port.sent == len(stream.sent) + 0x3FFFFFFF - 20 & 0x3FFFFFFF
        assert port.dropped == dropped + 0x3FFFFFFF - 20 & 0x3FFFFFFF
    assert min(dropped, len(stream.sent) // size) > 20, (dropped, len(stream.sent))
    arrived = 0
    for part, count in ((None, 0), (0, 0), (-1, 0), (9, 9), (10, 10), (11, 10), (1, 1)):
        stream.part = part
        assert port.readinto(bytearray(10)) == count, part
        arrived += count
    assert port.received == arrived + 0x3FFFFFFF - 20 & 0x3FFFFFFF


def absent_line_is_survived():
    """A UART that cannot be opened: the vehicle runs without it, and other links work."""
    machine.reset_serial()
    machine.serial(0).absent = True
    other = Port()
    craft = new_craft(ports=[open_uart("radio", 0, tx=0, rx=1, baud=57600, size=512), other])
    machine.serial(0).absent = False
    run(craft, 5 * SECOND_US)
    assert len(GroundStation(other).received(messages.Heartbeat)) >= _beats(5)


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
    assert len(station.received(messages.Heartbeat)) >= _beats(5)
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
        assert part == "streams" or len(heard) >= _beats(2), (part, len(heard))


def one_message_in_a_pass():
    """Let a pass take in or send a single message: streams, answers, lists and texts have their turns, too."""
    most = Craft.MESSAGES
    Craft.MESSAGES = 1
    try:
        craft = new_craft()
    finally:
        Craft.MESSAGES = most
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
    station.send(messages.Ping, target_system=0, target_component=0, seq=7)
    if PARAMETERS:
        station.send(messages.ParamRequestList)
        expected.append(messages.ParamValue)
    run(craft, 2 * SECOND_US, LINKS_US)
    kinds = [type(message) for message in station.received(messages.Heartbeat, *expected)]
    assert kinds.count(messages.Heartbeat) >= _beats(2), kinds
    assert [kind for kind in expected if kind not in kinds] == [], kinds


def _broken(*_arguments):
    raise ValueError("it is broken")


def datagrams_over_the_loopback():
    """UDP: telemetry to where the port points, answers to who asked, a closed socket is opened again."""
    there = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    there.setblocking(False)
    number = int(sys.argv[1])
    there.bind(socket.getaddrinfo("127.0.0.1", number)[0][-1])
    port = UdpPort("loopback", "127.0.0.1", number, 0, None, 1000, lambda *_words: None)
    craft = new_craft(ports=[port])
    other_end = Port()
    station = GroundStation(other_end)
    peer = None
    for second in range(10):
        if second == 5:
            port._socket.close()
        run(craft, SECOND_US)
        heard = 0
        while True:
            try:
                frame, peer = there.recvfrom(512)
            except OSError:
                break
            other_end.frames.append(frame)
            heard += 1
        assert heard or second in (0, 5), second
    assert len(station.received(messages.Heartbeat)) >= _beats(9)
    there.sendto(bytes(station.link.encode(messages.CommandLong(unknown=False).update(command=410))), peer)
    run_passes(craft, 8)
    answers = []
    while True:
        try:
            answers += station.link.feed(there.recvfrom(512)[0])
        except OSError:
            break
    there.close()
    if hasattr(port._socket, "getsockopt"):  # not on MicroPython; what is declared may be the address of everybody
        assert port._socket.getsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST)
    port._socket.close()
    assert [each.command for each in answers if each.ID == messages.CommandAck.ID] == [410]


class Flaky:
    """A socket that fails so often, and keeps what it has sent after that."""

    def __init__(self, failures):
        self.failures = failures
        self.sent = []

    def sendto(self, frame, _end):
        """Send a datagram."""
        if self.failures:
            self.failures -= 1
            raise OSError(5)
        self.sent.append(frame)

    def close(self):
        """Send nothing more."""


def a_datagram_is_tried_twice():
    """A frame that is sent at the second attempt counts, and is sent once; the next failure is told: it is left out."""
    for failures in range(4):
        texts = []
        port = UdpPort("flaky", "127.0.0.1", 1, 0, None, 1000, lambda *words: texts.append(" ".join(map(str, words))))  # noqa: B023
        port._socket, port.ends[0], port.is_up = Flaky(failures), ("127.0.0.1", 1), True
        sent, is_sent = port._socket.sent, failures < 2
        assert port.write(b"frame") == (5 if is_sent else 0), failures
        assert sent == [b"frame"] * is_sent, failures
        assert [port.sent, port.dropped, port.is_up] == [5 * is_sent, 1 - is_sent, is_sent], failures
        assert len(texts) == 1 - is_sent, texts


def a_socket_that_cannot_be_opened_is_told_once():
    """It is tried again at its pace, and once it is open, nothing is wrong; a Wi-Fi that cannot be asked is down."""
    texts = []
    port = UdpPort("shut", "127.0.0.1", 1, 0, None, 1000, lambda *words: texts.append(" ".join(map(str, words))))
    opened, tries = port._open, []

    def fail():
        tries.append(mock_time.ticks_ms())
        raise OSError(5)

    mock_time.set_ticks_us(0)
    port._open = fail
    for _ in range(30):
        port.poll(mock_time.ticks_ms())
        assert (port.is_up, isinstance(port.problem, OSError)) == (False, True)
        assert port.write(b"frame") == 0
        mock_time.advance_us(100000)
    assert tries == [0, 1000, 2000], tries
    assert len(texts) == 1, texts
    port._open = opened
    port.poll(mock_time.ticks_ms())
    assert (port.is_up, port.problem, port.dropped) == (True, None, 30)
    port._socket.close()
    for host in ("10.0.0.255", "", None):
        assert network_port.numbered(host) == host
    for host in ("station", "10.0.0.x", "10..1"):
        try:
            network_port.numbered(host)
        except ValueError:
            continue
        raise AssertionError(host)
    wifi = network_port._Wifi("home", None, 5000)
    wifi.is_up, wifi._wlan = True, None
    wifi.poll(0)
    assert wifi.is_up is False


WIFI = """{"ssid": "home", "password": "secret", "host": "127.0.0.9", "port": 1,
  "bench": {"host": "127.0.0.2", "port": 2, "local_port": 0}, "spare": {"ssid": "other"}}"""


def the_network_is_joined_again():
    """A port waits for the Wi-Fi of its file, where its own entries come first; a lost one is joined at its pace."""
    files, joined, texts = [], network_port._joined, []
    network_port.open = lambda name: files.append(name) or io.StringIO(WIFI)
    network_port._joined = []
    network.radio.reset()
    mock_time.set_ticks_us(0)
    try:
        arguments = ("127.0.0.1", 3, 0, "wifi.json", 5000, lambda *words: texts.append(" ".join(map(str, words))))
        port, twin = UdpPort("bench", *arguments), UdpPort("twin", *arguments)
        assert files == ["wifi.json"] * 2
        assert port._address == ("127.0.0.2", 2, 0), port._address
        assert twin._address == ("127.0.0.9", 1, 0), twin._address
        tries, ups = [], []
        for tenth in range(300):
            before = network.radio.connects
            if tenth == 20:  # it is lost, and not found for 12 s
                network.radio.drop()
                network.radio.connect_after_ms = None
            if tenth == 140:
                network.radio.connect_after_ms = 1000
            for each in (port, twin):
                each.poll(tenth * 100)
            tries += [tenth] * (network.radio.connects - before)
            ups += [port.has_network]
            assert twin.has_network == port.has_network, tenth
            assert port.has_network or not port.is_up, "its socket is closed with it"
            mock_time.advance_us(100000)
        assert network.radio.credentials == ("home", "secret")
        assert tries == [0, 50, 100], tries
        assert [tenth for tenth in range(1, 300) if ups[tenth] != ups[tenth - 1]] == [10, 20, 140], ups
        told = [text for text in texts if text.startswith("notice: bench Wi-Fi")]
        assert [text.split()[-1] for text in told] == ["up", "down", "up"], texts
        network.radio.absent = True
        network_port._joined = []
        lost = UdpPort("spare", *arguments)
        assert texts[-1].startswith("warning: spare has no Wi-Fi: "), texts
        lost.poll(0)
        assert (port.is_up, twin.is_up, lost.is_up) == (True, True, False)
    finally:
        network_port._joined = joined
        del network_port.open
        network.radio.reset()
        for each in (port, twin):
            if each._socket is not None:
                each._socket.close()


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
    (slow_line_takes_the_whole_list, "storage.read"),
    (faults_of_a_line_are_survived, "services.links"),
    (a_stream_that_raises_takes_nothing, "services.links"),
    (what_waits_goes_out_in_its_order, "services.links"),
    (absent_line_is_survived, "services.links"),
    (one_broken_port_leaves_the_others_alone, "services.links"),
    (a_fault_of_any_part_is_counted, "services.links"),
    (one_message_in_a_pass, "services.links"),
    (datagrams_over_the_loopback, "services.links"),
    (a_datagram_is_tried_twice, "services.links"),
    (a_socket_that_cannot_be_opened_is_told_once, "services.links"),
    (the_network_is_joined_again, "services.links"),
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
    datagrams_over_the_loopback,
    boards_own_ports,
)

if __name__ == "__main__":
    main(CHECKS)
