# Generated from templates/firmware/program/station.py, dialect common: do not edit.
# Inputs: b5f5f2594decad88
"""The state of each station that a link serves, and the texts that it is sent.

Long texts go in chunks: MAVLink 2 puts their bytes together, MAVLink 1 gets their beginning, up to a whole character.
"""

from struct import pack_into

import messages
from micropython import const

# Numbers of the dialect.
_STATUSTEXT_CHUNK_SEQ_AT = const(53)
_STATUSTEXT_ID_AT = const(51)
_STATUSTEXT_SEVERITY_AT = const(0)
_STATUSTEXT_TEXT_AT = const(1)

_TEXT = const(50)  # bytes of a STATUSTEXT; a NUL among them ends the text, so that a chunk may end within a character


class Station:
    """A station: its rates, and how far it has been told; `address` None is the declared one, or a wire's end.

    `heard_ms` is the time.ticks_ms() of its last frame, and counts while `is_heard`. `streams` are those of its rates,
    `sequence` is the number of its next frame, `waiting` has replies that the port did not take yet, and `parameter` is
    the index of the next one of the list, or None.
    """

    def __init__(self, streams, text):
        self.streams = streams
        self.address = None
        self.is_heard = False
        self.heard_ms = 0
        self.sequence = 0
        self.waiting = []
        self.parameter = None
        self.text = text  # number of the text at hand, or of the last one
        self.said = None  # its severity and the text itself, while it is being sent
        self.text_id = 0
        self.chunk = 0


class TextSender:
    """Sends each text once to each station of a connection, as STATUSTEXT."""

    def __init__(self, connection, texts):
        self._connection = connection
        self._texts = texts
        self._message = messages.Statustext(unknown=False)

    def run(self, station):
        """Send at most one message to a station, at which the connection is."""
        if station.said is None and station.text == self._texts.last:
            return
        if not self._connection.port.is_up:
            return
        if station.said is None:
            self._take(station)
        if self._send(station):
            # A NUL ends a long text: the chunk after 50 bytes may be empty.
            station.chunk += 1
            length = len(station.said[1])
            if length <= _TEXT or station.chunk * _TEXT > length:
                station.said = None

    def _take(self, station):
        """Take the next text that is not overwritten, as the newest never is."""
        found = None
        while found is None:
            station.text += 1
            found = self._texts.get(station.text)
        text = found[1].encode()
        if self._connection.link.version == 1 and len(text) > _TEXT:
            end = _TEXT
            while text[end] & 0xC0 == 0x80:  # within a character
                end -= 1
            text = text[:end]
        if len(text) > _TEXT:
            station.text_id = station.text_id % 0xFFFF + 1  # 0 says that there is one chunk only
        station.said = found[0], text
        station.chunk = 0

    def _send(self, station):
        severity, text = station.said
        wire = self._message.wire
        wire[_STATUSTEXT_SEVERITY_AT] = severity
        pack_into("<50s", wire, _STATUSTEXT_TEXT_AT, text[station.chunk * _TEXT :])
        pack_into("<H", wire, _STATUSTEXT_ID_AT, station.text_id if len(text) > _TEXT else 0)
        wire[_STATUSTEXT_CHUNK_SEQ_AT] = station.chunk
        return self._connection.send(self._message)
