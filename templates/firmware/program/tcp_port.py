"""The common part of ports over TCP: the open connections, and the bytes that go over them."""

import select
from time import ticks_ms

from micropython import const
from network_port import NetworkPort
from readiness import Readiness
from tcp_peer import Peer
from tcp_stations import TcpStations

_WRAP = const(0x3FFFFFFF)
_TO_READ = const(2)  # of what is left after a pass
_IPPROTO_TCP = const(6)  # of lwIP and of Linux alike; few ports of MicroPython have a name for it
_TCP_NODELAY = const(1)
_len = len  # found here, it is found sooner than among the built-in names


class TcpPort(NetworkPort):
    """TCP connections over Wi-Fi, each the way to a station.

    Frames go to the peer ends[0], and what was read last came from ends[1]; without one they are dropped. read() brings
    what a peer sent, and what is not a whole frame at its end goes back by keep(). A connection over which no frame of
    a station comes, or that takes nothing, for `timeout_ms` is closed. `is_up` is whether one is open. `credentials`
    and `retry_ms` are those of NetworkPort.
    """

    stations = TcpStations
    home = None

    def __init__(self, name, credentials, retry_ms, timeout_ms, log):
        self.listed = None  # the stations, who are told of peers
        self.peers = []
        self.ends = [None, None]
        self._timeout_ms = timeout_ms
        self._ready = Readiness(select.POLLIN)
        self.look = self._ready.look
        NetworkPort.__init__(self, name, credentials, retry_ms, log)

    def read(self):
        """Return what the next peer has sent, None for nothing; who was read has to wait for the others."""
        with self._guard:
            self._find_ready()
        if self._guard.error is not None:
            self._fail(self._guard.error)
        for _ in range(_len(self.peers)):
            peer = self.peers.pop(0)
            self.peers.append(peer)
            if peer.is_ready:
                data = peer.receive()
                if data:
                    self.ends[1] = peer
                    self.received = (self.received + peer.arrived) & _WRAP
                    return data
                if peer.error is not None:
                    self._lose(peer)
                    return None
        return None

    def keep(self, link):
        """Take the beginning of a frame, which ended what was read last, out of a link."""
        state = link._state  # frames_plain says what it holds
        if self.ends[1] is not None:
            self.ends[1].keep(bytes(memoryview(link._buffer)[state[0] : state[1]]))
        state[0] = state[1]

    def write(self, frame):
        """Send a frame, or its beginning now and its end soon, and return its length; or drop it and return 0."""
        peer = self.ends[0]
        if peer is not None and peer.send(frame):
            length = _len(frame)
            self.sent = (self.sent + length) & _WRAP
            return length
        self.dropped = (self.dropped + 1) & _WRAP
        return 0

    def poll(self, now_ms):
        """Keep Wi-Fi and connections up, at time.ticks_ms().

        Return whether the end of a frame waits to be sent, and 2 where what a peer has sent is to be read once more.
        """
        if self._has_wifi and not self._poll_wifi(now_ms):
            self._close()
            return False
        with self._guard:
            self._keep_open(now_ms)
        if self._guard.error is not None:
            self._fail(self._guard.error)
        waits = False
        for peer in self.peers:
            if not peer.flush():
                waits = waits or True  # _TO_READ stays
            peer.check(now_ms, self._timeout_ms)
            if peer.is_ready:
                waits = _TO_READ
            if peer.error is not None:
                self._lose(peer)
                return True  # the others have their turn in the next pass
        return waits

    def _find_ready(self):
        for ready in self._ready.look(0):
            self._note_ready(ready[0])

    def _note_ready(self, key):
        for peer in self.peers:
            if peer.key == key:
                peer.is_ready = True

    def _keep_open(self, now_ms):
        """Open what is closed and due."""

    def _open_peer(self, opened):
        """Serve who is at the other end of a socket."""
        with self._guard:  # a frame does not wait for the next one, where that can be said
            opened.setsockopt(_IPPROTO_TCP, _TCP_NODELAY, 1)
        self._ready.watch(opened)
        peer = Peer(opened, self._ready.key(opened), ticks_ms())
        self.peers.append(peer)
        self.is_up = True
        if self.listed is not None and self.listed.join(peer) and self.ends[0] is None:
            self.ends[0] = peer

    def _lose(self, peer):
        if peer.is_heard:  # who only connects, again and again, must not fill the texts
            self._say("notice:", "has lost a connection:", peer.error)
        self._close_peer(peer)

    def _close_peer(self, peer):
        self.peers.remove(peer)
        self.is_up = _len(self.peers) > 0
        self._discard(peer.socket)
        peer.error = peer.error or "closed"
        if self.listed is not None:
            self.listed.leave(peer)

    def _discard(self, opened):
        """Close a socket, looked at or not."""
        with self._guard:
            self._ready.forget(opened)
        with self._guard:
            opened.close()

    def _close(self):
        """Close everything."""
        while self.peers:
            self._close_peer(self.peers[0])

    def _fail(self, error):
        """Close everything; it is tried again. An error is logged once until that has worked."""
        if self.problem is None:
            self._say("error:", "has a socket that fails:", error)
        self.problem = error
        self._close()
