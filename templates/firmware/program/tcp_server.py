"""A port to which stations connect over TCP."""

import errno
import socket
from time import ticks_diff, ticks_ms

from micropython import const
from network_port import BUSY, numbered
from tcp_port import TcpPort

_MOST = const(4)
_GONE_MS = const(3000)  # who is silent for so long makes room where others wait
_NO_FAULT = BUSY + (errno.ECONNABORTED,)  # noqa: RUF005 - MicroPython has no other way; who asked has gone


class TcpServer(TcpPort):
    """Listens at `port`, with up to `backlog` connections that wait to be taken, for up to four stations at once.

    "host" and "port" in the file of credentials, below the name of this port, override where it listens: the address
    of one interface, without it of all. The rest is as for TcpPort.
    """

    def __init__(self, name, port, backlog, credentials, retry_ms, timeout_ms, log):
        self._address = ("0.0.0.0", port)  # noqa: S104 - a ground station may be anywhere
        self._backlog = backlog
        self._listener = None
        self._key = None
        self._is_asked = False  # whether somebody wants to connect
        self._is_full = False
        TcpPort.__init__(self, name, credentials, retry_ms, timeout_ms, log)

    def _take_settings(self, _shared, own):
        host, port = self._address
        self._address = (numbered(own.get("host", host)), own.get("port", port))

    def _keep_open(self, now_ms):
        if self._listener is None and self._retry.is_due(now_ms):
            self._listener = opened = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
            opened.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            opened.bind(socket.getaddrinfo(*self._address)[0][-1])
            opened.listen(self._backlog)
            opened.setblocking(False)
            self._ready.watch(opened)
            self._key = self._ready.key(opened)
            self.problem = None

    def _find_ready(self):
        TcpPort._find_ready(self)
        if self._is_asked:
            self._is_asked = False
            self._accept()

    def _note_ready(self, key):
        if key == self._key:
            self._is_asked = True
        else:
            TcpPort._note_ready(self, key)

    def _accept(self):
        try:
            accepted = self._listener.accept()[0]
        except OSError as error:
            if error.errno in _NO_FAULT:
                return
            raise
        accepted.setblocking(False)
        if len(self.peers) == _MOST and not self._make_room():
            accepted.close()
            if not self._is_full:
                self._is_full = True
                self._say("warning:", "has no place for another station:", _MOST)
            return
        self._is_full = False
        self._open_peer(accepted)

    def _make_room(self):
        """Close the connection of who is silent for longest, if that is long enough; return whether it was."""
        now_ms = ticks_ms()
        oldest = self.peers[0]
        for peer in self.peers:
            if ticks_diff(peer.heard_ms, oldest.heard_ms) < 0:
                oldest = peer
        if ticks_diff(now_ms, oldest.heard_ms) < _GONE_MS:
            return False
        oldest.error = "silent, and another one waits"
        self._lose(oldest)
        return True

    def _close(self):
        TcpPort._close(self)
        if self._listener is not None:
            self._discard(self._listener)
            self._listener = self._key = None
