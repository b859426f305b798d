"""A port that connects to a station over TCP."""

import errno
import select
import socket
from time import ticks_diff, ticks_ms

from micropython import const
from network_port import numbered
from readiness import Readiness
from tcp_port import TcpPort

_LONGEST_PAUSE = const(16)  # times retry_ms
_UNDER_WAY = (errno.EINPROGRESS, errno.EALREADY)


class TcpClient(TcpPort):
    """Connects to `host`, an address in numbers, and `port`, and does so again whenever the connection is lost.

    Each pause before the next try is twice the last one, from `retry_ms` to 16 times as long, until a station was
    heard. "host" and "port" in the file of credentials, below the name of this port, override the arguments, "host"
    outside of it too. The rest is as for TcpPort; a try ends after `timeout_ms`.
    """

    def __init__(self, name, host, port, credentials, retry_ms, timeout_ms, log):
        self._address = (host, port)
        self._connecting = None
        self._began_ms = 0
        self._pending = Readiness(select.POLLOUT)
        self._retry_ms = retry_ms
        TcpPort.__init__(self, name, credentials, retry_ms, timeout_ms, log)

    def _take_settings(self, shared, own):
        host, port = self._address
        self._address = (numbered(own.get("host", shared.get("host", host))), own.get("port", port))

    def _keep_open(self, now_ms):
        if self._connecting is not None:
            self._look_after_try(now_ms)
        elif not self.peers and self._retry.is_due(now_ms):
            self._retry.period_ms = min(2 * self._retry.period_ms, _LONGEST_PAUSE * self._retry_ms)
            self._began_ms = now_ms
            self._connecting = opened = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
            opened.setblocking(False)
            try:
                opened.connect(socket.getaddrinfo(*self._address)[0][-1])
            except OSError as error:
                if error.errno not in _UNDER_WAY:
                    raise
            self._pending.watch(opened)

    def _look_after_try(self, now_ms):
        for ready in self._pending.look(0):
            if ready[1] & (select.POLLERR | select.POLLHUP):
                self._connecting.recv(1)  # it raises why
                raise OSError(errno.ECONNREFUSED, "refused")
            self._pending.forget(self._connecting)
            opened, self._connecting = self._connecting, None
            self._open_peer(opened)
            self.problem = None
            return
        if ticks_diff(now_ms, self._began_ms) >= self._timeout_ms:
            raise OSError(errno.ETIMEDOUT, "no answer")

    def _close_peer(self, peer):
        TcpPort._close_peer(self, peer)
        if peer.is_heard:
            self._retry.period_ms = self._retry_ms
        self._retry.begin(ticks_ms())

    def _close(self):
        TcpPort._close(self)
        if self._connecting is not None:
            with self._guard:
                self._pending.forget(self._connecting)
            self._discard(self._connecting)
            self._connecting = None
