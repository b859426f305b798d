# Generated from templates/tests/program/network_checks.py: do not edit.
# Inputs: b427b6099123556b
"""UDP and Wi-Fi, under a vehicle and by themselves: sockets, who is at their other end, a network that is lost."""

import errno
import io
import socket
import sys

from program_bench import SECOND_US, GroundStation, Port, beats, main, messages, mock_time, new_craft, run, run_passes

import network
import network_port
import udp_port
from udp_port import UdpPort


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
    assert len(station.received(messages.Heartbeat)) >= beats(9)
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


class Net:
    """Stands in for the module socket, as a board has it: one answer to each question, sockets that note all calls."""

    AF_INET, SOCK_DGRAM, SOL_SOCKET, SO_BROADCAST = 2, 1, 0xFFF, 0x20

    def __init__(self):
        self.sockets = []

    def getaddrinfo(self, host, port):
        """Return the only address."""
        return [(2, 1, 0, "", (host, port))]

    def socket(self, *kind):
        """Open a socket."""
        self.sockets.append(Socket(kind))
        return self.sockets[-1]


class Socket:
    """A socket that notes what it is asked; `gives` has datagrams with their senders, or errors."""

    def __init__(self, kind):
        self.calls = [("socket",) + kind]  # noqa: RUF005  MicroPython
        self.gives = []
        for name in ("setblocking", "setsockopt", "bind", "sendto"):
            setattr(self, name, self._noting(name))

    def _noting(self, name):
        def note(*arguments):
            self.calls.append((name,) + arguments)  # noqa: RUF005  MicroPython

        return note

    def close(self):
        """Note it."""
        self.calls.append(("close",))

    def recvfrom(self, size):
        """Give a datagram."""
        self.calls.append(("recvfrom", size))
        given = self.gives.pop(0)
        if isinstance(given, Exception):
            raise given
        return given


class Looking:
    """Stands in for what asks whether a socket has something: it has as long as there are datagrams."""

    def __init__(self):
        self.watched = []

    def watch(self, opened):
        """Look at a socket."""
        self.watched.append(opened)

    def forget(self, opened):
        """Look at it no more."""
        self.watched.remove(opened)

    def check(self):
        """Return whether one has something."""
        return any([opened.gives for opened in self.watched])  # noqa: C419


def a_socket_is_what_is_declared():
    """Its kind, its own port and its end; what arrives is taken with its sender, and errors close it or do not."""
    for host, port, local_port in (("10.0.0.255", 14550, 0), ("10.0.0.7", 9, 14551), (None, 0, 14550)):
        net, texts = Net(), []
        own = UdpPort("net", host, port, local_port, None, 1000, lambda *words: texts.append(" ".join(map(str, words))))  # noqa: B023
        end = (host, port) if host else None
        assert own.look == own._ready.look, "what a pass asks for"
        own._ready, before = Looking(), udp_port.socket
        udp_port.socket = net
        try:
            assert own.read() is None
            assert (own.home, own.ends, own.is_up, own.problem) == (None, [None, None], False, None)
            own.poll(0)
            (opened,) = net.sockets
            assert opened.calls == [
                ("socket", net.AF_INET, net.SOCK_DGRAM),
                ("setblocking", False),
                ("setsockopt", net.SOL_SOCKET, net.SO_BROADCAST, 1),
                ("bind", ("0.0.0.0", local_port)),  # noqa: S104  nothing is opened
            ], opened.calls
            assert own._ready.watched == [opened]
            assert (own.home, own.ends, own.is_up) == (end, [end, None], True)
            assert (own.write(b"frame"), own.sent, own.dropped) == ((5, 5, 0) if host else (0, 0, 1))
            own.ends[0] = ("10.0.0.9", 5)
            assert own.write(b"other frame") == 11
            assert opened.calls[-1] == ("sendto", b"other frame", ("10.0.0.9", 5))
            opened.gives = [(b"datagram", ("10.0.0.8", 77)), (b"", ("10.0.0.9", 78)), OSError(errno.EAGAIN, "later")]
            assert own.read() == b"datagram"
            assert (own.ends[1], own.received, opened.calls[-1]) == (("10.0.0.8", 77), 8, ("recvfrom", 1472))
            own.received = 0x3FFFFFFF - 1
            opened.gives[0] = (b"abc", ("10.0.0.9", 78))
            assert (own.read(), own.ends[1], own.received) == (b"abc", ("10.0.0.9", 78), 1)
            assert own.read() is None, "what it would have to wait for is no fault"
            assert own.read() is None
            assert (own.is_up, own.problem, texts) == (True, None, []), (host, texts)
            opened.gives = [OSError(5)]
            assert own.read() is None
            assert (own.is_up, own._socket, own._ready.watched, opened.calls[-1]) == (False, None, [], ("close",))
            assert isinstance(own.problem, OSError)
            assert len(texts) == 1, texts
            own.poll(0)
            own.poll(2000)
            assert len(net.sockets) == 2, "it is opened again"
            assert (own.ends[0], own.home, own.problem) == (("10.0.0.9", 5), end, None)
        finally:
            udp_port.socket = before


def a_try_waits_for_its_pause_and_no_longer():
    """At once, then after each pause: across the end of the ticks, and where nobody asked for half a round of them."""
    for begun_ms in (0, 0x3FFFFFFF - 500):
        retry = network_port.Retry(1000)
        for ahead_ms, is_due in (
            (0, True),
            (1, False),
            (999, False),
            (1000, True),
            (1999, False),
            (2000, True),
            ((1 << 29) + 4500, True),
            ((1 << 29) + 5400, False),
            ((1 << 29) + 5500, True),
        ):
            assert retry.is_due(begun_ms + ahead_ms & 0x3FFFFFFF) is is_due, (begun_ms, ahead_ms)


def ports_share_a_network_that_is_the_same():
    """One of the same name and password: with another password it is another try to join it."""
    joined, network_port._joined = network_port._joined, []
    network.radio.reset()
    try:
        shared = network_port._network("home", "secret", 5000)
        assert network_port._network("home", "secret", 5000) is shared
        others = [network_port._network(*own, 5000) for own in (("home", None), ("home", "other"), ("away", "secret"))]
        assert shared not in others
        assert network_port._joined == [shared] + others  # noqa: RUF005  MicroPython has no stars there
    finally:
        network_port._joined = joined
        network.radio.reset()


CHECKS = (
    (datagrams_over_the_loopback, "services.links"),
    (a_datagram_is_tried_twice, "services.links"),
    (a_socket_that_cannot_be_opened_is_told_once, "services.links"),
    (a_socket_is_what_is_declared, "services.links"),
    (the_network_is_joined_again, "services.links"),
    (a_try_waits_for_its_pause_and_no_longer, "services.links"),
    (ports_share_a_network_that_is_the_same, "services.links"),
)
LONG = (datagrams_over_the_loopback,)

if __name__ == "__main__":
    main(CHECKS)
