# Generated from templates/firmware/program/connection.py, dialect common: do not edit.
# Inputs: 7a99b7cb03685cfd
"""One port of the vehicle: what arrives is answered, and what is due is sent.

Nothing here waits, and a pass of the main loop does a limited share of the work that a port brings. A pass in which
nothing arrives and no text is new allocates nothing; what arrives is taken in without allocating too.
"""

import time
from struct import pack_into

import messages
from guard import Guard
from inbox import Inbox
from micropython import const
from services import Services

# Numbers of the dialect.
_STATUSTEXT_CHUNK_SEQ_AT = const(53)
_STATUSTEXT_ID_AT = const(51)
_STATUSTEXT_SEVERITY_AT = const(0)
_STATUSTEXT_TEXT_AT = const(1)

_MESSAGES = const(2)  # in a pass
_REPLIES = const(8)  # that wait for the port
_QUIET_MS = const(1000)  # between two texts about faults
_TEXT = const(50)  # characters of a STATUSTEXT


class Connection:
    """Services and streams of one port.

    `port` reads and writes bytes (see ports), `link` makes frames of messages and back: it writes to `port`, and has
    been given services.receivable() as the messages that it receives. `streams` are this link's.

    `faults` counts exceptions that were caught, `lost_replies` replies that a port did not take for too long.
    """

    def __init__(self, vehicle, port, link, streams):
        self.port = port
        self.link = link
        self.streams = streams
        self.faults = 0
        self.lost_replies = 0
        # Each frame says whom it comes from.
        frame = link.encode(messages.Heartbeat(unknown=False))
        at = 5 if link.version == 2 else 3
        self.system_id = frame[at]
        self.component_id = frame[at + 1]
        self.services = Services(vehicle, self)
        self._log = vehicle.texts
        self._inbox = Inbox(port, link)
        self._texts = _TextSender(self, vehicle.texts)
        self._waiting = []
        self._guard = Guard()
        self._quiet_from_ms = None

    def run(self, now_ms):
        """Do one pass, at time.ticks_ms(): read, answer, send what is due.

        Raises nothing: a fault ends the part of the pass that it is in.
        """
        with self._guard:
            self._take_in()
        self._note(now_ms)
        with self._guard:
            self._send_waiting()
        self._note(now_ms)
        with self._guard:
            self.streams.run(now_ms)
            if self.port.is_up:
                self.streams.announce()
        self._note(now_ms)
        with self._guard:
            self.services.run()
            self._texts.run()
        self._note(now_ms)
        self.port.poll(now_ms)

    def send(self, message):
        """Send a message; return whether the port took it.

        If not, it may be sent again: the receiver does not count it as lost. ValueError: it does not fit the link.
        """
        link = self.link
        sequence = link.sequence
        errors = link.tx_errors
        if link.send(message):
            return True
        link.sequence = sequence
        link.tx_errors = errors
        return False

    def deliver(self, send, argument):
        """Call send(argument), now and in later passes until it returns True: replies that must not get lost.

        They keep their order. Of too many, the oldest is given up: who asked has to ask again anyway.
        """
        if not self._waiting and send(argument):
            return
        if len(self._waiting) == _REPLIES:
            self._waiting.pop(0)
            self.lost_replies += 1
        self._waiting.append((send, argument))

    def _take_in(self):
        self._inbox.begin()
        for _ in range(_MESSAGES):
            message = self._inbox.next()
            if message is None:
                return
            self.services.handle(message)

    def _send_waiting(self):
        while self._waiting:
            reply = self._waiting.pop(0)  # before it can raise: so a faulty one goes
            if not self.port.is_up:
                self.lost_replies += 1  # nobody expects it by the time that the port is up again
            elif not reply[0](reply[1]):
                self._waiting.insert(0, reply)
                return

    def _note(self, now_ms):
        if self._quiet_from_ms is not None and time.ticks_diff(now_ms, self._quiet_from_ms) >= _QUIET_MS:
            self._quiet_from_ms = None
        if self._guard.error is None:
            return
        self.faults += 1
        if self._quiet_from_ms is None:
            self._quiet_from_ms = now_ms
            self._log("error:", self.port.name, "fault", repr(self._guard.error))


class _TextSender:
    """Sends each text once. Long ones go in chunks: MAVLink 2 puts them together, MAVLink 1 gets their beginning."""

    def __init__(self, connection, texts):
        self._connection = connection
        self._texts = texts
        self._message = messages.Statustext(unknown=False)
        self._number = 0  # of the text at hand
        self._text = b""
        self._id = 0
        self._chunk = -1  # that the message holds; -1: none

    def run(self):
        """Send at most one message."""
        if self._chunk < 0 and self._number == self._texts.last:
            return
        if self._connection.port.is_up and (self._chunk >= 0 or self._take()) and self._connection.send(self._message):
            self._go_on()

    def _take(self):
        """Take the next text; False: all that were new are overwritten already."""
        while self._number != self._texts.last:
            self._number += 1
            found = self._texts.get(self._number)
            if found is not None:
                self._begin(found[0], found[1].encode())
                return True
        return False

    def _begin(self, severity, text):
        if self._connection.link.version == 1:
            text = text[:_TEXT]
        is_long = len(text) > _TEXT
        if is_long:
            self._id = self._id % 0xFFFF + 1  # 0 says that there is one chunk only
        self._text = text
        self._message.wire[_STATUSTEXT_SEVERITY_AT] = severity
        pack_into("<H", self._message.wire, _STATUSTEXT_ID_AT, self._id if is_long else 0)
        self._put(0)

    def _go_on(self):
        # A NUL ends a long text: the chunk after 50 characters may be empty.
        if len(self._text) <= _TEXT or (self._chunk + 1) * _TEXT > len(self._text):
            self._chunk = -1
        else:
            self._put(self._chunk + 1)

    def _put(self, chunk):
        """Put a chunk of the text into the message."""
        self._chunk = chunk
        pack_into("<50s", self._message.wire, _STATUSTEXT_TEXT_AT, self._text[chunk * _TEXT :])
        self._message.wire[_STATUSTEXT_CHUNK_SEQ_AT] = chunk
