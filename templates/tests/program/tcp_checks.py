"""Connections over TCP, with sockets that do what a check says: what is sent in parts, what lasts, and who waits."""

import errno

from program_bench import main, mock_time, needs
from stand_ins import Thing
from tcp_peer import Peer
from tcp_port import TcpPort
from tcp_stations import TcpStations

try:
    import tcp_client
except ImportError:  # nothing connects from here
    tcp_client = None

RETRY_MS = 500
TIMEOUT_MS = 6000
LONG_AGO_MS = 7000  # before all that a check does


class Socket:
    """A socket that takes `room` bytes at once, None for all, and gives what is in `gives`; `sent` is what it took."""

    def __init__(self, refuses=None):
        self.room = None
        self.sent = b""
        self.gives = []
        self.closed_ms = None
        self._refuses = refuses

    def send(self, data):
        """Take what there is room for."""
        part = bytes(data[: self.room])
        self.sent += part
        if not part:
            raise OSError(errno.EAGAIN, "busy")
        return len(part)

    def recv(self, _size):
        """Give the next piece; a list that is empty has nothing yet."""
        if not self.gives:
            raise OSError(errno.EAGAIN, "busy")
        return self.gives.pop(0)

    def connect(self, _address):
        """Begin to connect, or refuse."""
        raise OSError(self._refuses or errno.EINPROGRESS, "it is said later")

    def setblocking(self, _blocks):
        """Do nothing."""

    def setsockopt(self, *_option):
        """Do nothing."""

    def close(self):
        """Be open no more."""
        self.closed_ms = mock_time.ticks_ms()


class Looks:
    """Stands in for what asks whether sockets are ready: those in `ready` are."""

    def __init__(self):
        self.ready = []

    def watch(self, _opened):
        """Do nothing."""

    forget = watch

    def key(self, opened):
        """Return what tells of a socket."""
        return opened

    def look(self, _wait_ms):
        """Tell of those that are ready; 4 is POLLOUT."""
        return [(opened, 4) for opened in self.ready]


def frames_go_out_whole_and_in_turn():
    """The end of one that was sent in part comes before the next, and as it was: the buffer of frames is used again."""
    socket = Socket()
    peer, buffer = Peer(socket, None, 0), bytearray(b"one frame")
    frame = memoryview(buffer)
    socket.room = 3
    assert peer.send(frame)
    buffer[:] = b"TWO FRAME"
    assert not peer.send(frame), "the first one is not out"
    assert socket.sent == b"one fr"
    socket.room = None
    assert peer.send(frame)
    assert socket.sent == b"one frameTWO FRAME"
    socket.room = 0
    assert not peer.send(frame)
    assert peer.flush(), "nothing of it is left"
    assert peer.error is None


def what_lasts_too_long_ends_a_connection():
    """One over which nobody is heard, or that takes nothing, as long as that lasts without a break."""
    socket = Socket()
    peer = Peer(socket, None, 0)
    for now_ms in (1, TIMEOUT_MS - 1):
        peer.check(now_ms, TIMEOUT_MS)
        assert peer.error is None
    peer.check(TIMEOUT_MS, TIMEOUT_MS)
    assert peer.error == "silent"
    peer = Peer(socket, None, 0)
    for now_ms in range(0, 40000, 500):
        peer.heard_ms = now_ms
        socket.room = None if now_ms % 5000 == 0 else 0  # it takes something again before the time is over
        peer.send(b"frame")
        peer.check(now_ms, TIMEOUT_MS)
        assert peer.error is None, now_ms
    for now_ms in range(40000, 41000 + TIMEOUT_MS, 500):
        assert peer.error is None, now_ms
        peer.heard_ms = now_ms
        socket.room = 0 if now_ms > 40000 else None
        peer.send(b"frame")
        peer.check(now_ms, TIMEOUT_MS)
    assert peer.error == "takes nothing"


def a_beginning_is_given_up_once_its_end_does_not_come():
    """After two seconds that it was there; another one that has come meanwhile has its own time."""
    socket = Socket()
    peer = Peer(socket, None, 0)
    for now_ms, arrives in (
        (0, b"\xfdone"),
        (1500, b"\xfdtwo\xfdthree"),  # the first one is whole, and another one has begun
        (2500, None),
        (3400, None),
    ):
        peer.heard_ms = now_ms
        if arrives:
            socket.gives.append(arrives)
            assert peer.receive().endswith(arrives)
            peer.keep(arrives)
        peer.check(now_ms, TIMEOUT_MS)
        assert not peer.is_ready, now_ms
    peer.check(3500, TIMEOUT_MS)
    assert peer.is_ready, "what is behind its first byte is looked at"
    assert peer.receive() == b"\xfdthree"


def who_was_read_waits_for_the_others():
    """Of several that always have something each is read in turn."""
    port = TcpPort("net", None, RETRY_MS, TIMEOUT_MS, lambda *_words: None)
    port._ready = looks = Looks()
    sockets = [Socket(), Socket(), Socket()]
    for socket in sockets:
        socket.gives = [b"more"] * 9
        port._open_peer(socket)
    port._ready.ready = looks.ready = sockets
    port._ready.look = port.look = looks.look
    read = []
    for _ in range(6):
        assert port.read() == b"more"
        read.append(sockets.index(port.ends[1].socket))
    assert sorted(read[:3]) == sorted(read[3:]) == [0, 1, 2], read


def each_peer_is_a_station_of_its_own():
    """It gets what is sent on connection, is there while its connection is, and what it says is of its time."""
    made = []

    def make():
        connects = []
        made.append(
            Thing(address=None, heard_ms=None, connects=connects, streams=Thing(connect=lambda: connects.append(1)))
        )
        return made[-1]

    port = Thing(listed=None)
    stations, peers = TcpStations(port, make, 0), [Thing(is_heard=False, heard_ms=0) for _ in range(2)]
    assert [stations.join(peer) for peer in peers] == [True, False]
    assert [len(each.connects) for each in stations.served] == [1, 1]
    found = stations.hear(peers[1], 77)
    assert (found.address, found.heard_ms, peers[1].heard_ms, peers[1].is_heard) == (peers[1], 77, 77, True)
    assert peers[0].is_heard is False
    for peer in peers:
        stations.leave(peer)
        assert stations.hear(peer, 78) is None
    assert [each.address for each in stations.served] == [None]


class Client:
    """A client whose tries end as a check says, and a clock; `tries` has when each began."""

    def __init__(self):
        mock_time.set_ticks_us(LONG_AGO_MS * 1000)
        self.refuses = errno.ECONNREFUSED
        self.tries = []
        self.sockets = []
        self._kept = tcp_client.socket
        tcp_client.socket = Thing(AF_INET=2, SOCK_STREAM=1, getaddrinfo=lambda *at: [at], socket=self._open)
        self.port = tcp_client.TcpClient("net", "10.0.0.7", 5760, None, RETRY_MS, TIMEOUT_MS, lambda *_words: None)
        self.port._pending, self.port._ready = Looks(), Looks()

    def _open(self, *_kind):
        self.tries.append(mock_time.ticks_ms())
        self.sockets.append(Socket(self.refuses))
        return self.sockets[-1]

    def run(self, duration_ms):
        """Poll the port each 100 ms; return the times between the tries that were begun, from the last one before."""
        before = len(self.tries)
        for _ in range(duration_ms // 100):
            self.port.poll(mock_time.ticks_ms())
            mock_time.advance_us(100000)
        times = self.tries[max(before - 1, 0) :]
        return [later - earlier for earlier, later in zip(times, times[1:])]  # noqa: B905, RUF007  MicroPython

    def close(self):
        """Give back the true module."""
        tcp_client.socket = self._kept


def pauses_become_longer_until_somebody_is_heard():
    """Twice as long each time, up to sixteen times; after a connection over which a station was heard, as at first."""
    needs(tcp_client, "a client")
    client = Client()
    try:
        assert client.run(40000) == [500, 1000, 2000, 4000, 8000, 8000, 8000, 8000], client.tries
        client.refuses = None
        client.run(8100)
        client.port._pending.ready = client.sockets[-1:]
        client.run(100)
        assert client.port.is_up
        client.port.peers[0].is_heard = True
        client.port.peers[0].error = "lost"
        client.refuses, client.port._pending.ready = errno.ECONNREFUSED, []
        lost_ms = mock_time.ticks_ms()
        client.run(5000)
        since = [begun_ms - lost_ms for begun_ms in client.tries if begun_ms >= lost_ms]
        assert since == [500, 1000, 2000, 4000], since
    finally:
        client.close()


def a_try_without_an_answer_ends():
    """Each after the timeout, counted from its own beginning; its socket is closed then."""
    needs(tcp_client, "a client")
    client = Client()
    client.refuses = None
    try:
        client.run(4 * TIMEOUT_MS)
        assert len(client.tries) >= 3
        took_ms = [opened.closed_ms - begun_ms for begun_ms, opened in zip(client.tries[:3], client.sockets)]  # noqa: B905
        assert took_ms == [TIMEOUT_MS] * 3, took_ms
    finally:
        client.close()


CHECKS = (
    (frames_go_out_whole_and_in_turn, "services.links"),
    (what_lasts_too_long_ends_a_connection, "services.links"),
    (a_beginning_is_given_up_once_its_end_does_not_come, "services.links"),
    (who_was_read_waits_for_the_others, "services.links"),
    (each_peer_is_a_station_of_its_own, "services.stations"),
    (pauses_become_longer_until_somebody_is_heard, "services.links"),
    (a_try_without_an_answer_ends, "services.links"),
)

if __name__ == "__main__":
    main(CHECKS)
