"""Ports as they are opened: UARTs with the settings that they are given, and USB, a byte at a time without waiting."""

import sys

import micropython
import serial_port
from program_bench import machine, main
from readiness import Readiness
from serial_port import StreamPort

BYTES = bytes(range(1, 8))


def uarts_are_opened_with_their_settings():
    """Pins, rate and buffers; a pause is as long as 280 bytes and a radio's; one that is not there is told of."""
    for number, baud, patience_ms in ((0, 57600, 148), (1, 9600, 391), (1, 2800000, 101)):
        for opener, pins in ((serial_port.open_uart, {"tx": 4, "rx": 5}), (serial_port.open_fixed_uart, {})):
            machine.reset_serial()
            line = machine.serial(number)
            port = opener("radio", number, baud=baud, size=300, **pins)
            settings = dict(line.settings)
            for name, pin in pins.items():
                assert settings.pop(name).id == pin
            assert settings.pop("txbuf", 300) == 300
            assert settings == {"baudrate": baud, "timeout": 0, "rxbuf": 300}, settings
            assert (port.name, port.problem, port.is_up, port.patience_ms) == ("radio", None, True, patience_ms)
            assert port.write(BYTES) == 7
            assert bytes(line.sent) == BYTES
            line.arrives(BYTES)
            buffer = bytearray(9)
            assert port.readinto(buffer) == 7
            assert bytes(buffer[:7]) == BYTES
            line.room = 0
            assert [port.write(bytes(150)) for _ in range(3)] == [150, 150, 0]
            line.absent = True
            port = opener("radio", number, baud=baud, size=300, **pins)
            line.absent = False
            assert isinstance(port.problem, OSError)
            assert not port.is_up
            assert (port.write(BYTES), port.readinto(buffer), port.dropped) == (0, 0, 1)
    machine.reset_serial()


class Ready:
    """Stands in for what asks whether streams are ready: so often each is."""

    made = []  # noqa: RUF012  of all, for the check

    def __init__(self, events):
        self.events = events
        self.streams = []
        self.left = 0
        self.made.append(self)

    def watch(self, stream):
        """Look at a stream."""
        self.streams.append(stream)

    def check(self):
        """Return whether it is ready."""
        self.left -= 1
        return self.left >= 0


class Character:
    """Standard input or output: `buffer` is what takes and gives bytes, here one at a time."""

    def __init__(self):
        self.buffer = self
        self.given = b""
        self.taken = b""
        self.room = 100

    def readinto(self, piece):
        """Give a byte."""
        assert len(piece) == 1
        if not self.given:
            return None
        piece[:] = self.given[:1]
        self.given = self.given[1:]
        return 1

    def write(self, piece):
        """Take a byte."""
        assert len(piece) == 1
        if not self.room:
            return None
        self.room -= 1
        self.taken += bytes(piece)
        return 1


class Buffered:
    """A buffer more, as CPython has it, which nobody may read from: `raw` is what is below it."""

    def __init__(self, raw):
        self.raw = raw


def usb_takes_and_gives_what_is_ready():
    """Each byte is asked for, and one that would have to wait is left; a port on it opens without Ctrl-C."""
    ready, keyboard, ended = serial_port.Readiness, getattr(micropython, "kbd_intr", None), []
    serial_port.Readiness, Ready.made = Ready, []
    try:
        source, sink = Character(), Character()
        source.buffer = Buffered(source)
        usb = serial_port._Usb(source, sink)
        inwards, outwards = Ready.made
        assert (inwards.streams, outwards.streams) == ([source], [sink])
        assert (inwards.events, outwards.events) == (serial_port.select.POLLIN, serial_port.select.POLLOUT)
        for count, given, room, expected in (
            (100, BYTES, 5, BYTES[:5]),
            (3, BYTES, 5, BYTES[:3]),
            (100, BYTES[:2], 5, BYTES[:2]),
            (0, BYTES, 5, b""),
        ):
            source.given, inwards.left, buffer = given, count, bytearray(room)
            assert usb.readinto(buffer) == len(expected), (count, given)
            assert bytes(buffer) == expected + bytes(room - len(expected))
            assert source.given == given[len(expected) :], "what is not asked for stays"
            sink.taken, sink.room, outwards.left = b"", 100, count
            assert usb.write(given[:5]) == len(expected)
            assert sink.taken == expected
        sink.taken, sink.room, outwards.left = b"", 4, 100
        assert usb.write(BYTES) == 4
        assert sink.taken == BYTES[:4]
        if sys.implementation.name != "micropython":  # whose keyboard is that of who runs this
            micropython.kbd_intr = ended.append
        port = serial_port.open_usb("cable", 200)
        assert (port.name, port.problem, port.is_up, port.patience_ms) == ("cable", None, True, 101)
        assert [each.streams for each in Ready.made[2:]] == [[sys.stdin], [sys.stdout]]
        assert ended == [-1] or sys.implementation.name == "micropython"
        Ready.made[2].left = 0
        assert port.readinto(bytearray(5)) == 0, "nothing has arrived"
        Ready.made[3].left = 0
        assert [port.write(bytes(100)) for _ in range(3)] == [100, 100, 0]
    finally:
        serial_port.Readiness = ready
        if keyboard is not None:
            (keyboard(3) if sys.implementation.name == "micropython" else setattr(micropython, "kbd_intr", keyboard))


class Poller:
    """A poller as select gives it: of numbers or of objects, and those that it watches."""

    def __init__(self):
        self.watched = {}
        self.ready = []

    def register(self, stream, events):
        """Look at one."""
        self.watched[stream] = events

    def unregister(self, stream):
        """Look at it no more."""
        del self.watched[stream]

    def poll(self, wait_ms):
        """Return those that are ready."""
        assert wait_ms == 0, "nothing waits"
        return self.ready


class Iterating(Poller):
    """The same where it takes no heap."""

    def ipoll(self, wait_ms):
        """Return those that are ready."""
        return Poller.poll(self, wait_ms)

    def poll(self, _wait_ms):
        """Take heap, which nobody wants."""
        raise AssertionError


class Numbered:
    """A stream with a number."""

    def fileno(self):
        """Return it."""
        return 17


class Select:
    """The module, as far as it is needed: a function that makes a poller, here the same one each time."""

    def __init__(self, poller):
        self.poll = lambda: poller


def streams_are_asked_without_waiting():
    """Each that is watched, for what it is watched for, and none any more that is forgotten."""
    import readiness  # noqa: PLC0415  its select is another one here

    true = readiness.select
    try:
        for kind in (Poller, Iterating):
            poller, stream = kind(), Numbered()
            readiness.select = Select(poller)
            ready = Readiness(5)
            ready.watch(stream)
            assert poller.watched == {stream: 5}
            assert ready.key(stream) == (stream if kind is Iterating else 17)
            assert ready.check() is False
            poller.ready = [(stream, 1)]
            assert ready.check() is True
            assert list(ready.look(0)) == poller.ready
            ready.forget(stream)
            assert poller.watched == {}
    finally:
        readiness.select = true


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
        found = [(port.readinto(buffer), port.is_up) for _ in range(4)]
        assert found == [(0, False)] * failures + [(5, True)] * (4 - failures), found
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


CHECKS = (
    (a_stream_that_raises_takes_nothing, "services.links"),
    (what_waits_goes_out_in_its_order, "services.links"),
    (uarts_are_opened_with_their_settings, "services.links"),
    (usb_takes_and_gives_what_is_ready, "services.links"),
    (streams_are_asked_without_waiting, "services.links"),
)

if __name__ == "__main__":
    main(CHECKS)
