"""A whole vehicle with links over TCP, and who is at their other ends: sockets of this computer, a clock by hand.

The first argument is a port that nobody listens at. What a check finds wrong it raises.
"""

import errno
import json
import socket
import sys

from program_bench import SECOND_US, GroundStation, machine, messages, mock_time, new_craft, run, run_passes
from tcp_client import TcpClient
from tcp_peer import Peer
from tcp_server import TcpServer
from udp_port import UdpPort

try:
    from micropython import mem_total
except ImportError:  # CPython has no heap to measure
    mem_total = None

NUMBER = int(sys.argv[1])
TIMEOUT_MS = 6000
RETRY_MS = 500
BEATS = 2  # HEARTBEATs in a second
NOBODY = 410  # a command that no vehicle knows: who is heard gets an answer all the same


opened_ones = []


def kept(opened):
    """Return a port or a socket that is closed when the check is over."""
    opened_ones.append(opened)
    return opened


def close_all():
    while opened_ones:
        opened = opened_ones.pop()
        getattr(opened, "_close" if hasattr(opened, "_close") else "close")()


class End:
    """The other end of a connection, as GroundStation takes it: `frames` are what has arrived."""

    def __init__(self, opened=None):
        if opened is None:
            opened = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
            opened.connect(socket.getaddrinfo("127.0.0.1", NUMBER)[0][-1])
        opened.setblocking(False)
        self.socket = kept(opened)
        self.is_closed = False
        self.raw = b""

    def arrives(self, data):
        self.socket.send(bytes(data))

    def take(self):
        while not self.is_closed:
            try:
                data = self.socket.recv(4096)
            except OSError as error:
                if error.errno == errno.EAGAIN:
                    return
                data = b""
            self.is_closed = not data
            self.raw += data

    @property
    def frames(self):
        self.take()
        return [self.raw]

    @frames.setter
    def frames(self, _nothing):
        self.raw = b""


class Log:
    """Keeps what was logged."""

    def __init__(self):
        self.lines = []

    def __call__(self, *words):
        self.lines.append(" ".join([str(word) for word in words]))


def server():
    """Return a vehicle that listens, its port, and what that says."""
    log = Log()
    port = kept(TcpServer("field", NUMBER, 4, None, RETRY_MS, TIMEOUT_MS, log))
    craft = new_craft(ports=[port])
    run_passes(craft, 12)
    assert port.problem is None, port.problem
    return craft, port, log


def client():
    """Return a vehicle that connects, its port, and what that says."""
    log = Log()
    port = kept(TcpClient("base", "127.0.0.1", NUMBER, None, RETRY_MS, TIMEOUT_MS, log))
    return new_craft(ports=[port]), port, log


def listening():
    """Return a socket to which the vehicle can connect."""
    opened = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    opened.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    opened.bind(socket.getaddrinfo("127.0.0.1", NUMBER)[0][-1])
    opened.listen(4)
    opened.setblocking(False)
    return kept(opened)


def accepted(opened):
    """Return who has connected, None for nobody."""
    try:
        return End(opened.accept()[0])
    except OSError:
        return None


def answers(station):
    """Return how many commands are answered since the last call."""
    return len(station.received(messages.CommandAck))


def frames_of(data):
    """Return the frames of a stream of whole ones; there is nothing else in it."""
    found = []
    while data:
        assert data[0] == 0xFD, data
        found.append(data[: data[1] + 12])
        assert len(found[-1]) == data[1] + 12, "the last one is torn"
        data = data[data[1] + 12 :]
    return found


def four_stations_are_served_at_once():
    """Each hears what is sent from its connection on, with numbers of its own, and the answers to its own questions."""
    craft, port, _log = server()
    assert not port.is_up
    ends = [End() for _ in range(4)]
    run(craft, 5 * SECOND_US)
    stations = [GroundStation(each, system_id=255 - number) for number, each in enumerate(ends)]
    assert port.is_up
    for number, station in enumerate(stations):
        for _ in range(number):
            station.command(NOBODY)
    run(craft, SECOND_US)
    for number, each in enumerate(ends):
        each.take()
        frames = frames_of(each.raw)
        sequence = [frame[4] for frame in frames]
        assert sequence == [(sequence[0] + index) & 0xFF for index in range(len(sequence))], number
        kinds = [message.ID for message in stations[number].received(messages.Heartbeat, messages.CommandAck)]
        assert kinds.count(messages.CommandAck.ID) == number, (number, kinds)
        assert BEATS * 5 <= kinds.count(messages.Heartbeat.ID) <= BEATS * 6 + 1, kinds


def who_comes_too_late_is_turned_away_until_somebody_is_silent():
    craft, _port, log = server()
    stations = [GroundStation(End(), system_id=255 - number) for number in range(4)]
    for _ in range(6):
        for station in stations:
            station.command(NOBODY)
        run(craft, SECOND_US)
    late = End()
    run_passes(craft, 8)
    late.take()
    assert late.is_closed
    assert [line for line in log.lines if "no place" in line] == ["warning: field has no place for another station: 4"]
    for _ in range(4):
        for station in stations[1:]:
            station.command(NOBODY)
        run(craft, SECOND_US)
    late = GroundStation(End(), system_id=9)
    run_passes(craft, 8)
    late.command(NOBODY)
    run_passes(craft, 8)
    assert answers(late) == 1
    stations[0].port.take()
    assert stations[0].port.is_closed
    assert [station.port.is_closed for station in stations[1:]] == [False] * 3


def silence_and_garbage_end_a_connection():
    """Bytes without a frame do not keep it open; frames do."""
    craft, port, _log = server()
    station, garbler = GroundStation(End()), End()
    for second in range(TIMEOUT_MS // 1000 + 2):
        station.command(NOBODY)
        if second < TIMEOUT_MS // 1000:
            garbler.arrives(b"\xfd\x09garbage")
        run(craft, SECOND_US)
    garbler.take()
    assert garbler.is_closed
    assert answers(station) == TIMEOUT_MS // 1000 + 2
    assert not station.port.is_closed
    assert len(port.peers) == 1
    assert len(craft.connections[0].stations) == 1


def frames_come_in_any_pieces_from_several():
    """Byte by byte, in turns: what one sends never becomes part of another one's frame."""
    craft, _port, _log = server()
    stations = [GroundStation(End(), system_id=255 - number) for number in range(3)]
    ends = [station.port for station in stations]
    streams = []
    for station in stations:
        sent = []
        station.port = Kept(sent)
        for _ in range(5):
            station.command(NOBODY, 1.5)
        streams.append(b"".join(sent))
    for size in (1, 7, 300):
        for at in range(0, max(len(stream) for stream in streams), size):
            for each, stream in zip(ends, streams):  # noqa: B905 - MicroPython's is not strict
                if stream[at : at + size]:
                    each.arrives(stream[at : at + size])
            run_passes(craft, 1)
        run_passes(craft, 20)
        for station, each in zip(stations, ends):  # noqa: B905 - MicroPython's is not strict
            station.port = each
            assert answers(station) == 5, size
    assert craft.connections[0].faults == 0


class Kept:
    """A port that keeps what is sent to it."""

    def __init__(self, sent):
        self._sent = sent

    def arrives(self, data):
        self._sent.append(bytes(data))


def hostile_bytes_hide_no_frame():
    """Starts of frames that never end, cut frames, zeros: what follows is found, and the loop keeps its time."""
    craft, _port, _log = server()
    station, other = GroundStation(End()), GroundStation(End(), system_id=254)
    sent = []
    station.port, opened = Kept(sent), station.port
    station.command(NOBODY)
    station.port = opened
    frame = sent[0]
    for hostile in (
        b"\xfd",
        b"\xfd\xff\x00\x00\x00\xff\xbe\x4c\x00\x00",
        frame[:-1],
        frame[1:],
        bytes(3000),
        b"\xfe\xff",
    ):
        opened.arrives(hostile)
        other.command(NOBODY)
        run_passes(craft, 30)
        assert answers(other) == 1, hostile
        opened.arrives(frame)
        run(craft, 3 * SECOND_US)
        opened.arrives(frame)
        run(craft, SECOND_US)
        assert answers(station) == 2, hostile
    assert craft.scheduler.overruns == 0
    assert craft.connections[0].faults == 0


def what_is_whole_behind_a_false_start_is_answered():
    """Though nothing more arrives: 2 s after each start that never ends, and what arrives meanwhile loses nothing."""
    craft, port, _log = server()
    port._timeout_ms = 10 * TIMEOUT_MS
    station, other = GroundStation(End()), GroundStation(End(), system_id=254)
    run_passes(craft, 30)
    for starts in (1, 2):
        for start in (b"\xfd\xff\x00\x00\x00", b"\xfe\xff\x00"):
            station.port.arrives(start * starts)
            station.command(NOBODY)
            station.command(NOBODY)
            other.command(NOBODY)
            run(craft, SECOND_US)
            assert (answers(station), answers(other)) == (0, 1), start
            run(craft, (3 * starts - 1) * SECOND_US)
            assert answers(station) == 2, (start, starts)
            assert not station.port.is_closed
    station.port.arrives(b"\xfd\xff\x00\x00\x00")
    run(craft, 3 * SECOND_US)
    looked = []
    for peer in port.peers:
        peer.receive = lambda receive=peer.receive: looked.append(receive()) or looked[-1]
    run(craft, 3 * SECOND_US)
    assert [data for data in looked if data] == [], "what is given up is not looked at for ever"
    station.command(NOBODY)
    run(craft, SECOND_US)
    assert answers(station) == 1
    assert craft.connections[0].faults == 0


def bytes_that_are_kept_count_once():
    """Byte by byte, and behind starts that were given up: `received` is what has come over the connections."""
    craft, port, _log = server()
    port._timeout_ms = 10 * TIMEOUT_MS
    station = GroundStation(End())
    sent = []
    opened, station.port = station.port, Kept(sent)
    for _ in range(3):
        station.command(NOBODY, 1.5)
    frames = b"".join(sent)
    run_passes(craft, 30)
    for place in range(len(frames)):
        opened.arrives(frames[place : place + 1])
        run_passes(craft, 1)
    run(craft, SECOND_US)
    assert port.received == len(frames), (port.received, len(frames))
    station.port = opened
    assert answers(station) == 3
    opened.arrives(b"\xfd\xff\x00\x00\x00" + frames)
    run(craft, 4 * SECOND_US)
    assert answers(station) == 3
    assert port.received == 2 * len(frames) + 5
    port.received = 0x3FFFFFFF
    opened.arrives(frames)
    run(craft, SECOND_US)
    assert port.received == len(frames) - 1, "it is counted in 30 bits"


class Sink:
    """A socket that takes so much of each send, of the list's last number for ever; an exception is raised."""

    def __init__(self, *parts):
        self.parts = list(parts)
        self.sent = b""

    def send(self, data):
        part = self.parts[0] if len(self.parts) == 1 else self.parts.pop(0)
        if isinstance(part, Exception):
            raise part
        self.sent += bytes(data[:part])
        return min(part, len(data))


def frame(number, length):
    return memoryview(bytes([(number + place) & 0xFF for place in range(length)]))


def torn_writes_are_finished_first():
    """A frame that the socket took in part goes on where it stopped; a frame is taken whole or not at all."""
    full = OSError(errno.EAGAIN, "full")
    for parts in ((1,), (7,), (50, 1, full, full, 30, full, full, 3, 100), (full, full, 200, 1), (0, 5)):
        sink = Sink(*parts)
        peer = Peer(sink, None, 0)
        expected = b""
        for number in range(200):
            each = frame(number, 20 + number * 7 % 60)
            if peer.send(each):
                expected += bytes(each)
            if number % 3 == 0:
                peer.flush()
            assert expected[: len(sink.sent)] == sink.sent, parts
        sink.parts = [1000]
        assert peer.flush()
        assert sink.sent == expected, parts
        assert peer.error is None


def a_connection_that_breaks_within_a_frame_is_not_used_again():
    sink = Sink(5, OSError(errno.ECONNRESET, "gone"))
    peer = Peer(sink, None, 0)
    assert peer.send(frame(1, 30))
    assert not peer.send(frame(2, 30))
    assert peer.error.errno == errno.ECONNRESET
    sink.parts = [1000]
    assert not peer.send(frame(3, 30))
    assert not peer.flush()
    assert sink.sent == bytes(frame(1, 30))[:5]


def a_reader_that_stands_still_is_closed():
    """It keeps its connection open and speaks, but takes nothing: others are served meanwhile, frames stay whole."""
    craft, port, log = server()
    station, stuck = GroundStation(End(), system_id=254), GroundStation(End())
    run_passes(craft, 8)
    stuck.command(NOBODY)
    run_passes(craft, 8)
    stuck_peer = craft.connections[0].station.address
    stuck_peer.socket = Stuck(stuck_peer.socket)
    for _ in range(TIMEOUT_MS // 1000 + 2):
        station.command(NOBODY)
        run(craft, SECOND_US)
        stuck_peer.heard_ms = mock_time.ticks_ms()
    assert stuck_peer.error == "takes nothing", (stuck_peer.error, log.lines)
    assert len(port.peers) == 1
    assert answers(station) == TIMEOUT_MS // 1000 + 2


class Stuck:
    """A socket whose other end takes nothing."""

    def __init__(self, opened):
        self._opened = opened

    def send(self, _data):
        raise OSError(errno.EAGAIN, "full")

    def recv(self, size):
        return self._opened.recv(size)

    def close(self):
        self._opened.close()


def who_comes_back_is_served_anew():
    """The connection is lost and opened again: from then on as one that was never there."""
    craft, port, _log = server()
    for _ in range(3):
        station = GroundStation(End())
        station.command(NOBODY)
        run(craft, SECOND_US)
        assert answers(station) == 1
        station.port.socket.close()
        run(craft, SECOND_US)
        assert not port.is_up
        assert [each.address for each in craft.connections[0].stations] == [None]
    assert craft.connections[0].faults == 0


def a_taken_port_is_tried_again():
    taken = listening()
    log = Log()
    port = kept(TcpServer("field", NUMBER, 4, None, RETRY_MS, TIMEOUT_MS, log))
    craft = new_craft(ports=[port])
    run(craft, 3 * SECOND_US)
    assert isinstance(port.problem, OSError)
    assert len(log.lines) == 1, log.lines
    taken.close()
    run(craft, SECOND_US)
    assert port.problem is None
    station = GroundStation(End())
    station.command(NOBODY)
    run_passes(craft, 20)
    assert answers(station) == 1


def it_connects_when_somebody_listens():
    """Before, it is tried again and again, ever more seldom, and said once."""
    craft, port, log = client()
    tries = Counted(port)
    run(craft, 40 * SECOND_US)
    assert not port.is_up
    assert len(log.lines) == 1, log.lines
    pauses = [after - before for before, after in zip(tries.at_ms, tries.at_ms[1:])]  # noqa: B905
    expected = [RETRY_MS, 2 * RETRY_MS, 4 * RETRY_MS, 8 * RETRY_MS, 16 * RETRY_MS, 16 * RETRY_MS]
    assert len(pauses) >= len(expected), pauses
    for pause, longest in zip(pauses, expected):  # noqa: B905 - MicroPython's is not strict
        assert 0 <= pause - longest <= 400, pauses
    there = listening()
    run(craft, 17 * RETRY_MS * 1000)
    station = GroundStation(accepted(there))
    station.command(NOBODY)
    run(craft, SECOND_US)
    assert answers(station) == 1
    assert port.is_up


class Counted:
    """Notes when a port tries to connect."""

    def __init__(self, port):
        self.at_ms = []
        before = port._retry.is_due

        def is_due(now_ms):
            due = before(now_ms)
            if due:
                self.at_ms.append(now_ms)
            return due

        port._retry.is_due = is_due


def it_connects_again():
    """After a loss, and after a silence of the other end; soon, where a station had been heard."""
    there = listening()
    craft, port, _log = client()
    for turn in range(3):
        run(craft, 2 * SECOND_US)
        opened = accepted(there)
        assert opened is not None, turn
        station = GroundStation(opened)
        station.command(NOBODY)
        run(craft, SECOND_US)
        assert answers(station) == 1
        opened.socket.close()
        run_passes(craft, 20)
        assert not port.is_up
    run(craft, 2 * SECOND_US)
    silent = accepted(there)
    run(craft, TIMEOUT_MS * 1000 + 200000)
    silent.take()
    assert silent.is_closed
    assert craft.scheduler.overruns == 0


def a_try_that_comes_to_nothing_is_given_up():
    """Nobody answers, neither yes nor no: the loop goes on, and the try ends after the timeout."""
    craft, port, log = client()

    class Nowhere:
        def look(self, _wait_ms):
            return ()

        def watch(self, _opened):
            """Look at nothing."""

        forget = watch

    port._pending = Nowhere()
    run(craft, TIMEOUT_MS * 1000 // 2)
    assert port._connecting is not None
    run(craft, TIMEOUT_MS * 1000)
    assert len(log.lines) == 1, log.lines
    assert port.problem.errno == errno.ETIMEDOUT
    assert craft.scheduler.overruns == 0


def an_idle_link_allocates_nothing():
    """With nobody there, with two stations, and connected: passes in which nothing is due keep off the heap."""
    if mem_total is None:
        return
    craft, port, _log = server()
    stations = []
    there = None
    for situation in ("nobody", "two stations", "connected"):
        if situation == "two stations":
            stations = [GroundStation(End()), GroundStation(End(), system_id=254)]
            for station in stations:
                station.command(NOBODY)
        elif situation == "connected":
            close_all()
            there = listening()
            craft, port, _log = client()
            run(craft, SECOND_US)
            stations = [GroundStation(accepted(there))]
            stations[0].command(NOBODY)
        run(craft, 3 * SECOND_US)
        connection = craft.connections[0]
        for _ in range(200):  # to where nothing is due: HEARTBEATs are, twice a second
            mock_time.advance_us(5000)
            connection.run(mock_time.ticks_ms())
        before = port.sent
        for _ in range(3):
            start = mem_total()
            middle = mem_total()
            connection.run(mock_time.ticks_ms())
            taken = mem_total() - middle - (middle - start)
            assert taken == 0, (situation, taken)
        assert port.sent == before


def an_idle_pass_calls_what_that_of_udp_does():
    """Not one function more, with two stations connected."""
    if mem_total is not None:  # MicroPython tells nobody what it calls
        return
    udp = kept(UdpPort("air", "127.0.0.1", NUMBER, 0, None, RETRY_MS, Log()))
    there = new_craft(ports=[udp])
    run(there, 3 * SECOND_US)
    expected = called(there.connections[0])
    craft, port, _log = server()
    for number in range(2):
        GroundStation(End(), system_id=255 - number).command(NOBODY)
    run(craft, 3 * SECOND_US)
    assert len(port.peers) == 2
    assert called(craft.connections[0]) == expected
    assert 0 < expected < 10, expected


def called(connection):
    """Return how many functions a pass calls in which nothing is due."""
    found = []
    for _ in range(3):
        mock_time.advance_us(1000)
        calls = []
        now_ms = mock_time.ticks_ms()
        sys.setprofile(lambda _frame, event, _argument, calls=calls: calls.append(event.endswith("call")))
        connection.run(now_ms)
        sys.setprofile(None)
        found.append(sum(calls))
    return min(found) - 1  # without the call that ends the count


CHECKS = (
    four_stations_are_served_at_once,
    who_comes_too_late_is_turned_away_until_somebody_is_silent,
    silence_and_garbage_end_a_connection,
    frames_come_in_any_pieces_from_several,
    hostile_bytes_hide_no_frame,
    what_is_whole_behind_a_false_start_is_answered,
    bytes_that_are_kept_count_once,
    torn_writes_are_finished_first,
    a_connection_that_breaks_within_a_frame_is_not_used_again,
    a_reader_that_stands_still_is_closed,
    who_comes_back_is_served_anew,
    a_taken_port_is_tried_again,
    it_connects_when_somebody_listens,
    it_connects_again,
    a_try_that_comes_to_nothing_is_given_up,
    an_idle_link_allocates_nothing,
    an_idle_pass_calls_what_that_of_udp_does,
)


def outcome(check):
    """Return None, or what a check raised."""
    machine.reset_serial()
    try:
        check()
    except Exception as error:
        if hasattr(sys, "print_exception"):
            import io  # noqa: PLC0415

            text = io.StringIO()
            sys.print_exception(error, text)
            return text.getvalue()
        import traceback  # noqa: PLC0415 - MicroPython has none

        return "".join(traceback.format_exception(error))
    finally:
        close_all()
    return None


sys.stdout.write(json.dumps({check.__name__: outcome(check) for check in CHECKS}))
