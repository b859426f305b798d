"""A ground station in a simulation: what the scenario sends arrives at the first port that looks."""

SYSTEM, COMPONENT = 255, 190  # as ground stations are
_NEVER_MS = 1 << 40
HERE = (True,)  # what a port returns that has something


class Ground:
    """Sends messages: each of `sendings` has `at_ms`, `id`, `crc_extra` and `payload` in hex.

    One with `every_ms` is sent again and again, to `until_ms` or to the end.
    """

    def __init__(self, sendings, start_ms):
        self._sendings = [[_first(sending, start_ms), sending] for sending in sendings]
        self._sequence = 0
        self._waiting = bytearray()

    def speak_to(self, port_class, deaf=()):
        """Let what is sent arrive at ports of this class, but for those called `deaf`, before what really arrives."""
        read = port_class.read

        def heard(port):
            data = bytes(self._waiting)
            if not data or getattr(port, "name", None) in deaf:
                return read(port)
            self._waiting = bytearray()
            peers = getattr(port, "peers", None)  # over TCP it speaks as who is there, or as nobody
            if port.home is None and not getattr(port, "has_network", False):
                return None  # nobody is reached before there is a network
            port.received += len(data)
            port.ends[1] = peers[0] if peers else port.home
            return data

        port_class.read = heard
        init = getattr(port_class, "__init__", None)
        if init is not None and self._sendings:  # one without has nothing to look with either

            def made(port, *arguments, **named):
                init(port, *arguments, **named)
                look = getattr(port, "look", None)
                if look is not None:
                    port.look = lambda wait_ms: HERE if self._waiting and port.name not in deaf else look(wait_ms)

            port_class.__init__ = made

    def waits(self):
        """Return something where something has been sent that no port has read."""
        return HERE if self._waiting else ()

    def speak_into(self, buffer):
        """Write what has been sent into a buffer, as far as there is room; return how many bytes that is."""
        count = min(len(buffer), len(self._waiting))
        buffer[:count] = self._waiting[:count]
        self._waiting = self._waiting[count:]
        return count

    def next_ms(self):
        """Return when something is sent next, far ahead for never."""
        return min([entry[0] for entry in self._sendings if entry[0] is not None] + [_NEVER_MS])

    def turn(self, now_ms):
        """Send what is due."""
        for entry in self._sendings:
            due_ms, sending = entry
            if due_ms is None or due_ms > now_ms:
                continue
            self._waiting.extend(self._frame(sending))
            entry[0] = _next(sending, due_ms)

    def _frame(self, sending):
        text = sending["payload"]
        payload = bytes([int(text[at : at + 2], 16) for at in range(0, len(text), 2)])
        number = sending["id"]
        head = bytes((len(payload), 0, 0, self._sequence, SYSTEM, COMPONENT))
        covered = head + bytes((number & 0xFF, number >> 8 & 0xFF, number >> 16)) + payload
        self._sequence = self._sequence + 1 & 0xFF
        crc = 0xFFFF
        for byte in covered + bytes((sending["crc_extra"],)):
            mixed = (byte ^ crc) & 0xFF
            mixed = (mixed ^ mixed << 4) & 0xFF
            crc = crc >> 8 ^ mixed << 8 ^ mixed << 3 ^ mixed >> 4
        return b"\xfd" + covered + bytes((crc & 0xFF, crc >> 8))


def _first(sending, start_ms):
    """Return when it is sent first after a start, None for never again."""
    due_ms = sending["at_ms"]
    while due_ms is not None and due_ms < start_ms:
        due_ms = _next(sending, due_ms)
    return due_ms


def _next(sending, due_ms):
    """Return when it is sent after a time, None for never."""
    if sending["every_ms"] is None:
        return None
    due_ms += sending["every_ms"]
    until_ms = sending["until_ms"]
    return due_ms if until_ms is None or due_ms < until_ms else None
