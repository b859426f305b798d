"""Records the frames that a port took in a simulation."""

import binascii


class Wire:
    """Records the frames that a port accepted.

    `counts` has of each message, by its number as text, how many frames and bytes there were; frames of the `told`
    numbers are recorded whole. `before` is called ahead of the first of these.
    """

    def __init__(self, records, told, before):
        self._records = records
        self._told = told
        self._before = before
        self._next_sequence = {}
        self._port_classes = ()
        self.counts = {}
        self.frames = 0
        self.size = 0
        self.gaps = 0

    def listen(self, port_class):
        """Take note of every frame that ports of this class accept."""
        self._port_classes += (port_class,)
        write = port_class.write

        def heard(port, frame):
            taken = write(port, frame)
            if taken:
                self.take(port, frame)
            return taken

        port_class.write = heard

    def take(self, port, frame):
        """Take note of one whole frame."""
        is_new = frame[0] == 0xFD
        number = frame[7] | frame[8] << 8 | frame[9] << 16 if is_new else frame[5]
        self._check_sequence(port, frame[4] if is_new else frame[2])
        count = self.counts.setdefault(str(number), [0, 0])
        count[0] += 1
        count[1] += len(frame)
        self.frames += 1
        self.size += len(frame)
        if number in self._told:
            if self._before is not None:
                self._before()
                self._before = None
            self._records.put("frame", data=binascii.hexlify(bytes(frame)).decode())

    def _check_sequence(self, port, sequence):
        expected = self._next_sequence.get(id(port), sequence)
        self._next_sequence[id(port)] = (sequence + 1) & 0xFF
        self.gaps += (sequence - expected) & 0xFF

    def status_of_links(self, vehicle):
        """Return the sums of the counters that the heard ports and their links keep."""
        connections = getattr(vehicle, "connections", None) or ()
        heard = [connection for connection in connections if isinstance(connection.port, self._port_classes)]
        return {
            "dropped": sum(connection.port.dropped for connection in heard),
            "received": sum(connection.port.received for connection in heard),
            "crc_errors": sum(connection.link.crc_errors for connection in heard),
            "gaps": self.gaps,
        }


class SilentPort:
    """A port without anybody at its other end."""

    is_up = False
    dropped = sent = received = 0

    def __init__(self, name):
        self.name = name

    def readinto(self, buffer):  # noqa: ARG002 - nothing arrives
        """Read nothing."""
        return 0

    def write(self, frame):  # noqa: ARG002 - nobody takes it
        """Take nothing."""
        return 0

    def poll(self, now_ms):
        """Do nothing."""


class SpokenPort(SilentPort):
    """A cable at whose other end the scenario speaks, and nobody listens."""

    is_up = True

    def __init__(self, name, ground):
        SilentPort.__init__(self, name)
        self._ground = ground

    def look(self, wait_ms):  # noqa: ARG002 - it does not wait
        """Return something where something has been said."""
        return self._ground.waits()

    def readinto(self, buffer):
        """Read what the scenario has said, as far as there is room."""
        return self._ground.speak_into(buffer)

    def write(self, frame):
        """Let it go: what goes out is told of the network."""
        return len(frame)
