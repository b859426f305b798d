"""Ports take whole frames, keep their order, and neither block nor raise.

At the first UDP port of this computer answers one who sends every datagram back, in capitals, and at the second one
who tells the first where datagrams shall come from: see test_ports.py.
"""

import json
import sys

import mock_time

mock_time.install()

import select  # noqa: E402
import time  # noqa: E402

import machine  # noqa: E402
import network  # noqa: E402
import network_port  # noqa: E402
import readiness  # noqa: E402
import serial_port  # noqa: E402
import udp_port  # noqa: E402
from checks import allocated, run, taken  # noqa: E402
from serial_port import StreamPort, open_uart, open_usb  # noqa: E402
from udp_port import UdpPort  # noqa: E402

FOLDER, ECHO, OTHER = sys.stdin.read().split()
ECHO, OTHER = int(ECHO), int(OTHER)
RETRY_MS = 5000
KEY = "of a network that is made up"


class Sink:
    """A stream that takes so much of each write, of the list's last number for ever, and keeps it."""

    def __init__(self, *parts):
        self.parts = list(parts)
        self.sent = b""
        self.calls = 0

    def write(self, data):
        self.calls += 1
        part = self.parts[0] if len(self.parts) == 1 else self.parts.pop(0)
        if isinstance(part, Exception):
            raise part
        if part is None or not isinstance(part, int):
            return part
        self.sent += bytes(data[: max(0, part)])
        return min(part, len(data)) if part < 1000 else part

    def readinto(self, _buffer):
        return None


class Log:
    """Keeps what was logged."""

    def __init__(self):
        self.lines = []

    def __call__(self, *words):
        self.lines.append(" ".join([str(word) for word in words]))


def frame(number, length):
    """Return a frame that no other is like, as a memoryview, which a sender's are."""
    return memoryview(bytes([(number + place) & 0xFF for place in range(length)]))


def joined(frames):
    return b"".join([bytes(each) for each in frames])


def whole_frames_go_through():
    sink = Sink(1000)
    port = StreamPort("serial", sink, 300)
    frames = [frame(number, 20 + number) for number in range(10)]
    assert [port.write(each) for each in frames] == [20 + number for number in range(10)]
    assert sink.sent == joined(frames)
    assert (port.name, port.is_up, port.sent, port.received, port.dropped) == ("serial", True, 245, 0, 0)
    assert sink.calls == 10


def partial_writes_are_resumed_in_order():
    for parts in ((1,), (7,), (31,), (32,), (33,), (3, None, 0, 8, 5), (50, 1, None, 32, 2)):
        sink = Sink(*parts)
        port = StreamPort("serial", sink, 300)
        taken_frames = []
        for number in range(300):
            each = frame(number, 20 + number * 7 % 60)
            if port.write(each):
                taken_frames.append(each)
            if number % 3 == 0:
                port.poll(0)
        sink.parts = [64]
        for _ in range(20):
            port.poll(0)
        assert sink.sent == joined(taken_frames), parts
        assert len(taken_frames) + port.dropped == 300
        assert port.sent == len(sink.sent)
        calls = sink.calls
        port.poll(0)
        assert sink.calls == calls  # nothing is left


def full_buffer_drops_whole_frames():
    sink = Sink(None)
    port = StreamPort("serial", sink, 100)
    frames = [frame(number, 30) for number in range(6)]
    assert [port.write(each) for each in frames] == [30, 30, 30, 0, 0, 0]
    assert port.dropped == 3
    assert port.write(frame(9, 10)) == 10  # a shorter one fits
    assert port.write(frame(9, 1)) == 0
    sink.parts = [1000]
    port.poll(0)
    assert sink.sent == joined(frames[:3]) + bytes(frame(9, 10))
    assert port.write(frame(5, 100)) == 100
    before = len(sink.sent)
    assert port.write(frame(6, 101)) == 0
    assert len(sink.sent) == before  # not even its beginning
    assert port.dropped == 5


def broken_stream_is_survived():
    for part in (OSError(5), ValueError("broken"), "text", -3, 1 << 20, 3.5):
        sink = Sink(part)
        port = StreamPort("serial", sink, 100)
        for number in range(20):
            assert port.write(frame(number, 30)) in (0, 30), part
            port.poll(0)
        assert port.is_up == (part in (-3, 1 << 20, 3.5)), part


def stream_that_says_nonsense_about_reading_is_survived():
    class Liar:
        def __init__(self, says):
            self.says = says

        def readinto(self, _buffer):
            return self.says

    for says, count in ((-1, 0), (9, 8), ("text", 0), (None, 0), (2, 2)):
        assert StreamPort("serial", Liar(says), 100).readinto(bytearray(8)) == count, says


def stream_that_works_again_goes_on():
    sink = Sink(OSError(5))
    port = StreamPort("serial", sink, 100)
    assert port.write(frame(1, 30)) == 30
    assert not port.is_up
    sink.parts = [1000]
    port.poll(0)
    assert port.is_up
    assert sink.sent == bytes(frame(1, 30))


def uart_is_opened_as_asked():
    machine.reset_serial()
    port = open_uart("telem", 0, 12, 13, 57600, 512)
    settings = machine.serial(0).settings
    assert [settings[name] for name in ("baudrate", "timeout", "rxbuf", "txbuf")] == [57600, 0, 512, 512], settings
    assert [settings[name].id for name in ("tx", "rx")] == [12, 13]
    assert port.is_up


def uart_reads_what_arrived():
    machine.reset_serial()
    port = open_uart("telem", 1, 4, 5, 57600, 512)
    buffer = bytearray(8)
    assert port.readinto(buffer) == 0
    machine.serial(1).arrives(b"0123456789")
    assert port.readinto(buffer) == 8
    assert buffer == b"01234567"
    assert port.readinto(buffer) == 2
    assert buffer[:2] == b"89"
    assert port.readinto(memoryview(buffer)) == 0
    machine.serial(1).failures = 1
    machine.serial(1).arrives(b"x")
    assert port.readinto(buffer) == 0
    assert not port.is_up
    assert port.readinto(buffer) == 1
    assert port.is_up
    assert port.received == 11


def uart_writes_in_parts():
    machine.reset_serial()
    line = machine.serial(0)
    port = open_uart("telem", 0, 0, 1, 57600, 100)
    line.parts = [5, 0, 3]
    assert port.write(frame(1, 40)) == 40
    assert port.write(frame(2, 40)) == 40
    port.poll(0)
    assert len(line.sent) == 5
    port.poll(0)
    assert len(line.sent) == 8
    port.poll(0)
    assert bytes(line.sent) == joined([frame(1, 40), frame(2, 40)])
    line.room = 10
    assert port.write(frame(3, 60)) == 60
    assert port.write(frame(4, 60)) == 0
    line.room = None
    port.poll(0)
    assert bytes(line.sent[80:]) == bytes(frame(3, 60))


def uart_that_is_not_there_is_survived():
    machine.reset_serial()
    machine.serial(0).absent = machine.serial(7).absent = True
    for port in (open_uart("telem", 0, 0, 1, 57600, 100), open_uart("telem", 7, 0, 1, 57600, 100)):
        assert not port.is_up
        assert isinstance(port.problem, (OSError, ValueError))
        assert port.write(frame(1, 10)) == 0
        assert port.readinto(bytearray(10)) == 0
        port.poll(0)
        assert port.dropped == 1
    machine.reset_serial()


class Polled:
    """Stands in for standard input or output and for its readiness."""

    def __init__(self):
        self.buffer = self
        self.arrived = b""
        self.sent = b""
        self.room = 0

    def readinto(self, buffer):
        assert self.arrived, "this would block"
        assert len(buffer) <= len(self.arrived), "so would this"
        buffer[:] = self.arrived[: len(buffer)]
        self.arrived = self.arrived[len(buffer) :]
        return len(buffer)

    def write(self, data):
        assert len(data) <= self.room, "this would block"
        self.room -= len(data)
        self.sent += bytes(data)
        return len(data)

    def ipoll(self, timeout):
        assert timeout == 0
        return [self] if self.arrived or self.room else []


class Poller:
    """Stands in for select."""

    POLLIN = POLLOUT = 1

    def __init__(self):
        self.streams = []

    def register(self, stream, _events):
        self.streams.append(stream)

    def ipoll(self, timeout):
        return [each for stream in self.streams for each in stream.ipoll(timeout)]


def usb_never_blocks():
    source, sink = Polled(), Polled()

    class Select:
        POLLIN = POLLOUT = 1

        @staticmethod
        def poll():
            return Poller()

    class System:
        stdin, stdout = source, sink

    before = readiness.select, serial_port.sys
    readiness.select, serial_port.sys = Select, System
    try:
        port = open_usb("usb", 100)
    finally:
        readiness.select, serial_port.sys = before
    assert port.is_up, port.problem
    buffer = bytearray(4)
    assert port.readinto(buffer) == 0
    source.arrived = b"abcdef"
    assert port.readinto(buffer) == 4
    assert port.readinto(buffer) == 2
    assert buffer == b"efcd"
    assert port.write(frame(1, 60)) == 60
    assert port.write(frame(2, 60)) == 0
    sink.room = 7
    port.poll(0)
    assert sink.sent == bytes(frame(1, 60))[:7]
    sink.room = 1000
    for _ in range(3):
        port.poll(0)
    assert sink.sent == bytes(frame(1, 60))
    assert port.is_up, port.problem
    assert (port.received, port.sent, port.dropped) == (6, 60, 1)


def counters_stay_small():
    sink = Sink(1000)
    port = StreamPort("serial", sink, 100)
    port.sent = port.dropped = (1 << 30) - 1
    port.write(frame(0, 30))
    port.write(frame(0, 130))
    assert (port.sent, port.dropped) == (29, 0)


def stream_allocates_nothing():
    class Quick:
        """Takes one number after the other, and reads three bytes."""

        room = 1000

        def write(self, data):
            return self.room if self.room < len(data) else len(data)

        def readinto(self, _buffer):
            return 3

    stream, each, buffer = Quick(), frame(3, 50), bytearray(64)
    port = StreamPort("serial", stream, 200)

    def whole():
        port.write(each)
        port.readinto(buffer)
        port.poll(0)

    assert allocated(whole) == 0
    assert port.dropped == 0
    for room in (1, 13, 32, 0):
        stream.room = room
        assert allocated(whole) == 0, room
    assert port.dropped > 500


def usb_allocates_nothing():
    port = open_usb("usb", 100)
    buffer = bytearray(4)

    def idle():
        port.readinto(buffer)
        port.poll(0)

    assert allocated(idle) == 0


def wait_for(port):
    """Return what the next datagram brings; it may take a while, of the true time."""
    poller = select.poll()
    poller.register(port._socket, select.POLLIN)
    poller.poll(20000)
    return port.read()


def udp(host="127.0.0.1", port=ECHO, credentials=None, local_port=0):
    """Return a port, polled once, and its log."""
    log = Log()
    opened = UdpPort("wifi", host, port, local_port, credentials, RETRY_MS, log)
    opened.poll(time.ticks_ms())
    return opened, log.lines


def udp_sends_a_frame_per_datagram():
    port, log = udp()
    assert port.is_up, port.problem
    assert port.read() is None
    for each in (b"heartbeat", b"x" * 280):
        assert port.write(memoryview(each)) == len(each)
        assert wait_for(port) == each.upper()
    assert port.read() is None
    assert (port.sent, port.received, port.dropped) == (289, 289, 0)
    assert log == []
    assert port.is_up


def udp_says_who_sent_what():
    """A frame goes out to the same address as before: others have to say who is to get it."""
    port, _ = udp()
    port.write(b"tell the other")  # what test_ports.py does is answer from the other socket
    assert wait_for(port) == b"from the other"
    home, other = port.ends
    assert home == port.home
    assert other != home
    port.write(b"to the first")
    assert wait_for(port) == b"TO THE FIRST"
    assert port.ends == [home, home]
    port.ends[0] = other
    port.write(b"to the other")
    assert wait_for(port) == b"other: to the other"
    port._socket.close()
    port._socket = BadSocket(OSError(101, "no network"))
    assert port.write(b"lost") == 0
    mock_time.advance_us(RETRY_MS * 1000)
    port.poll(time.ticks_ms())
    port.write(b"once more")
    assert wait_for(port) == b"other: once more"


def udp_without_a_peer_waits():
    port, _ = udp(host=None)
    assert port.is_up
    assert port.write(b"nobody") == 0
    assert port.dropped == 1
    assert port.read() is None


def udp_broadcast_is_allowed():
    port, _ = udp(host="127.255.255.255")
    assert port.write(b"everybody") == 9, port.problem
    assert port.is_up


def udp_long_datagrams_are_whole():
    port, _ = udp()
    for size in (513, 1472):
        port.write(b"x" * size)
        assert wait_for(port) == b"X" * size


class BadSocket:
    """A socket whose calls fail."""

    def __init__(self, error):
        self.error = error
        self.is_closed = False

    def sendto(self, _data, _peer):
        raise self.error

    def recvfrom(self, _size):
        raise self.error

    def close(self):
        self.is_closed = True
        raise OSError(9)


def udp_that_is_ready_for_nothing_does_not_block():
    port, log = udp(port=OTHER)
    port._ready.check = lambda: True
    assert port.read() is None
    assert port.is_up
    assert log == []


def udp_busy_is_no_error():
    for number in (11, 105, 12):
        port, log = udp()
        port._socket = BadSocket(OSError(number, "busy"))
        port._ready.check = lambda: True
        assert port.write(b"frame") == 0
        assert port.read() is None
        assert port.dropped == 1
        assert port.is_up
        assert log == []


def udp_error_closes_and_reopens():
    for error in (OSError(101), ValueError("broken")):
        for call in (lambda port: port.write(b"frame"), lambda port: port.read()):
            mock_time.set_ticks_us(0)
            port, log = udp()
            port._socket.close()
            port._socket = bad = BadSocket(error)
            port._ready.check = lambda: True
            assert not call(port)
            assert bad.is_closed
            assert not port.is_up
            assert len(log) == 1, log
            assert log[0].startswith("error: wifi")
            assert port.write(b"frame") == 0
            port.poll(time.ticks_ms())
            assert not port.is_up  # not at once
            mock_time.advance_us(RETRY_MS * 1000)
            port.poll(time.ticks_ms())
            assert port.is_up
            assert port.write(b"frame") == 5
            assert wait_for(port) == b"FRAME"


def udp_socket_that_cannot_be_opened_is_tried_again():
    mock_time.set_ticks_us(0)

    class Failing:
        """Stands in for the module socket."""

        calls = 0

        def __getattr__(self, name):
            Failing.calls += 1
            raise OSError(23)

    before, udp_port.socket = udp_port.socket, Failing()
    try:
        port, log = udp()
        for _ in range(4000):  # 20 seconds
            mock_time.advance_us(5000)
            port.poll(time.ticks_ms())
            assert not port.is_up
            assert port.write(b"frame") == 0
        assert Failing.calls == 5, Failing.calls
        assert len(log) == 1, log
    finally:
        udp_port.socket = before
    mock_time.advance_us(RETRY_MS * 1000)
    port.poll(time.ticks_ms())
    assert port.is_up
    port, log = udp(port=OTHER, local_port=70000 << 8)
    assert not port.is_up or port.problem is None


def reset_radio():
    """Let nobody have joined a network, and no port know of one."""
    network.radio.reset()
    network_port._joined.clear()


def credentials(**settings):
    """Write a file and return its name."""
    name = FOLDER + "/wifi.json"
    with open(name, "w") as file:
        file.write(json.dumps(settings))
    return name


def udp_waits_for_wifi():
    reset_radio()
    mock_time.set_ticks_us(0)
    port, log = udp("203.0.113.9", 9, credentials(ssid="field", password=KEY, host="127.0.0.1", port=ECHO))
    assert network.radio.credentials == ("field", KEY)
    assert not port.is_up
    assert port.write(b"frame") == 0
    mock_time.advance_us(999 * 1000)
    port.poll(time.ticks_ms())
    assert not port.is_up
    mock_time.advance_us(1000)
    port.poll(time.ticks_ms())
    assert port.is_up
    assert network.radio.connects == 1
    assert log == ["notice: wifi Wi-Fi is up"], log
    assert port.write(b"frame") == 5
    assert wait_for(port) == b"FRAME"


def udp_joins_again():
    reset_radio()
    mock_time.set_ticks_us((1 << 30) * 1000 - 20 * 1000000)  # before the wrap of ticks_ms
    port, log = udp(credentials=credentials(ssid="open one"))
    assert network.radio.credentials == ("open one", None)
    for _ in range(5):
        for _ in range(200):  # ten seconds
            mock_time.advance_us(50000)
            port.poll(time.ticks_ms())
        assert port.is_up
        assert port.write(b"frame") == 5
        network.radio.drop()
        port.poll(time.ticks_ms())
        assert not port.is_up
        assert port.write(b"frame") == 0
    assert log == ["notice: wifi Wi-Fi is up", "notice: wifi Wi-Fi is down"] * 5, log


def udp_network_that_is_out_of_reach_is_tried_again():
    reset_radio()
    network.radio.connect_after_ms = None
    network.radio.failures = 2
    mock_time.set_ticks_us(0)
    port, _ = udp(credentials=credentials(ssid="far", password=KEY))
    for _ in range(7200):  # an hour
        mock_time.advance_us(500000)
        port.poll(time.ticks_ms())
    assert network.radio.connects == 721, network.radio.connects


def ports_share_a_network():
    """Or one would break off what the other one has begun."""
    reset_radio()
    mock_time.set_ticks_us(0)
    network.radio.connect_after_ms = 4000
    name = credentials(ssid="field", password=KEY, host="127.0.0.1", other={"port": OTHER})
    log = Log()
    ports = [UdpPort(each, None, ECHO, 0, name, RETRY_MS, log) for each in ("wifi", "other")]
    for _ in range(100):  # five seconds
        mock_time.advance_us(50000)
        for port in ports:
            port.poll(time.ticks_ms())
    assert network.radio.connects == 1, network.radio.connects
    assert [port.is_up for port in ports] == [True, True]
    assert log.lines == ["notice: wifi Wi-Fi is up", "notice: other Wi-Fi is up"], log.lines
    assert [port.home == udp(port=number)[0].home for port, number in zip(ports, (ECHO, OTHER))] == [True, True]  # noqa: B905


def udp_broken_wifi_is_down():
    class Broken:
        def isconnected(self):
            raise OSError(5)

    reset_radio()
    network.radio.connect_after_ms = 0
    port, log = udp(credentials=credentials(ssid="field"))
    port.poll(time.ticks_ms())
    assert port.is_up
    port._wifi._wlan = Broken()
    port.poll(time.ticks_ms())
    assert not port.is_up
    assert log == ["notice: wifi Wi-Fi is up", "notice: wifi Wi-Fi is down"], log


def udp_without_wifi_is_survived():
    reset_radio()
    for name, absent in ((FOLDER + "/nothing.json", False), (credentials(password=KEY), False), (None, True)):
        reset_radio()
        network.radio.absent = absent
        port, log = udp(credentials=name or credentials(ssid="field"))
        for _ in range(3):
            mock_time.advance_us(RETRY_MS * 1000)
            port.poll(time.ticks_ms())
            assert port.write(b"frame") == 0
            assert port.read() is None
        assert not port.is_up
        assert port.problem is not None
        assert len(log) == 1, log
        assert log[0].startswith("warning: wifi has no Wi-Fi:"), log
    network.radio.absent = False
    for text in ("", "[1, 2]", "{", "12"):
        name = credentials()
        with open(name, "w") as file:
            file.write(text)
        port, log = udp(credentials=name)
        assert not port.is_up
        assert len(log) == 1, log
    reset_radio()


def udp_broken_log_is_survived():
    def broken(*_words):
        raise OSError(5)

    port = UdpPort("wifi", None, 1, 0, FOLDER + "/nothing.json", RETRY_MS, broken)
    port.poll(0)
    assert not port.is_up


def udp_idle_allocates_nothing():
    reset_radio()
    network.radio.connect_after_ms = 0
    port, _ = udp(credentials=credentials(ssid="field", host="127.0.0.1", port=OTHER))
    port.poll(time.ticks_ms())  # it was connecting
    assert port.is_up

    def idle():
        port.read()
        port.poll(5)

    assert allocated(idle) == 0
    each = memoryview(b"s" * 50)
    assert taken(lambda: port.write(each)) == 0  # at most what the socket itself takes
    assert port.dropped == 0


run(
    whole_frames_go_through,
    partial_writes_are_resumed_in_order,
    full_buffer_drops_whole_frames,
    broken_stream_is_survived,
    stream_that_works_again_goes_on,
    stream_that_says_nonsense_about_reading_is_survived,
    uart_is_opened_as_asked,
    uart_reads_what_arrived,
    uart_writes_in_parts,
    uart_that_is_not_there_is_survived,
    usb_never_blocks,
    counters_stay_small,
    stream_allocates_nothing,
    usb_allocates_nothing,
    udp_sends_a_frame_per_datagram,
    udp_says_who_sent_what,
    udp_without_a_peer_waits,
    udp_broadcast_is_allowed,
    udp_long_datagrams_are_whole,
    udp_busy_is_no_error,
    udp_that_is_ready_for_nothing_does_not_block,
    udp_error_closes_and_reopens,
    udp_socket_that_cannot_be_opened_is_tried_again,
    udp_waits_for_wifi,
    udp_joins_again,
    udp_network_that_is_out_of_reach_is_tried_again,
    ports_share_a_network,
    udp_broken_wifi_is_down,
    udp_without_wifi_is_survived,
    udp_broken_log_is_survived,
    udp_idle_allocates_nothing,
)
