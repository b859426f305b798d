"""Signatures of MAVLink 2: who has the key can tell that a frame is genuine and no replay. Signing allocates."""

import os
import time
from hashlib import sha256

EPOCH = 1420070400  # 2015-01-01 in seconds since 1970
if hasattr(time, "gmtime") and time.gmtime(0)[0] == 2000:  # the years of some boards begin there
    EPOCH -= 946684800
TICKS = 100000  # of a timestamp in a second
MINUTE = 60 * TICKS
DAY = 1440 * MINUTE
SIGNATURE = 13  # link id, timestamp in 6 bytes, 6 bytes of the hash
LATEST = (1 << 48) - 1
RADIO_STATUS = 109  # radios add it to the stream themselves and have no key


class Signing:
    """Signs the frames of one link and judges those that it receives.

    `key` has 32 bytes and stays secret; `link_id` tells the links of a system apart. `timestamp` is where to go on
    from, in 10 us since 2015-01-01: no frame is ever signed with an older one. `clock` returns seconds since 1970, or
    since 2000 on boards whose time.time() does; while it is behind, as one that was not set yet, timestamps go on from
    the last one as time passes. `unsigned` are ids of messages that are accepted without a signature; the last
    timestamps of up to `streams` senders are remembered. `accepted` counts signed frames.
    """

    def __init__(self, key, link_id=0, timestamp=0, clock=time.time, unsigned=(RADIO_STATUS,), streams=16):
        if len(key) != 32:
            raise ValueError("a key has 32 bytes")
        if not 0 <= link_id <= 255:
            raise ValueError("a link id is a number from 0 to 255")
        if not 0 <= timestamp <= LATEST:
            raise ValueError("a timestamp has 48 bits")
        self.key = bytes(key)
        self.link_id = link_id
        self.timestamp = timestamp
        self.unsigned = unsigned
        self.accepted = 0
        self._clock = clock
        self._looked = self._now()
        self._streams = {}  # (link id, system, component): timestamp of the last frame
        self._most_streams = streams

    def _now(self):
        return int((self._clock() - EPOCH) * TICKS)

    def _advance(self, newer=0):
        """Go on to the clock, or, while it is behind, by what it went on since the last time.

        A clock that jumps by a day or more was set: that is no time that passed.
        """
        now = self._now()
        passed = now - self._looked
        self._looked = max(self._looked, now)
        if now <= self.timestamp:
            now = self.timestamp + max(newer, passed if passed < DAY else 0)
        self.timestamp = min(now, LATEST)

    def sign(self, frame):
        """Fill in the signature, the last 13 bytes of a frame, with a timestamp newer than all before."""
        self._advance(1)
        end = len(frame) - SIGNATURE
        frame[end] = self.link_id
        frame[end + 1 : end + 7] = self.timestamp.to_bytes(6, "little")
        frame[end + 7 :] = self._hash(frame)

    def accepts(self, frame):
        """Tell whether a signed frame is genuine and newer than the last of its sender on that link.

        The first frame of a sender may be a minute old.
        """
        end = len(frame) - SIGNATURE
        difference = 0
        genuine = self._hash(frame)
        for at in range(6):  # all of them: how long it takes tells nothing
            difference |= genuine[at] ^ frame[end + 7 + at]
        if difference:
            return False
        timestamp = int.from_bytes(bytes(frame[end + 1 : end + 7]), "little")
        stream = (frame[end], frame[5], frame[6])
        last = self._streams.get(stream)
        if last is None:
            self._advance()
            if len(self._streams) >= self._most_streams or timestamp + MINUTE < self.timestamp:
                return False
        elif timestamp <= last:
            return False
        self._streams[stream] = timestamp
        self.timestamp = max(self.timestamp, timestamp)
        self.accepted += 1
        return True

    def renew(self, key, timestamp=0):
        """Go on with another key, and not before its timestamp; nobody has signed with it yet."""
        if len(key) != 32:
            raise ValueError("a key has 32 bytes")
        self.key = bytes(key)
        self.timestamp = max(self.timestamp, min(timestamp, LATEST))
        self._streams = {}

    def _hash(self, frame):
        digest = sha256(self.key)
        digest.update(frame[: len(frame) - 6])
        return digest.digest()[:6]

    def save(self, path):
        """Keep key, link id, timestamp and the last timestamp of each sender in a file.

        Call it at least once a minute while frames are signed. What arrived after the last call can be replayed once
        after a reset.
        """
        self._advance()
        content = self.key + bytes([self.link_id]) + self.timestamp.to_bytes(6, "little")
        for stream, timestamp in self._streams.items():
            content += bytes(stream) + timestamp.to_bytes(6, "little")
        with open(path + ".new", "wb") as file:
            file.write(content + sha256(content).digest()[:4])
        os.rename(path + ".new", path)


def load(path, **options):
    """Return a Signing as save() kept it, a minute later; the options are those of Signing.

    OSError: there is no such file. ValueError: it is damaged.
    """
    with open(path, "rb") as file:
        content = file.read()
    end = len(content) - 4
    if end < 39 or sha256(content[:end]).digest()[:4] != content[end:]:
        raise ValueError(path + " is damaged")
    timestamp = min(LATEST, int.from_bytes(content[33:39], "little") + MINUTE)
    signing = Signing(content[:32], content[32], timestamp, **options)
    for at in range(39, end, 9):
        signing._streams[tuple(content[at : at + 3])] = int.from_bytes(content[at + 3 : at + 9], "little")
    return signing
