# Generated from templates/firmware/program/storage.py: do not edit.
# Inputs: 89f632bfa67cc98c
"""Keeps a few hundred bytes in flash so that a power cut, whenever it comes, leaves the old ones or the new ones.

There are two files, and a save writes the one that does not hold the newest payload: magic, version, sequence number,
length, payload, CRC-32 over all of that. A file counts only as a whole.
"""

import errno
import struct
from binascii import crc32

from guard import Guard
from micropython import const

LONGEST_PAYLOAD = 0xFFFF

_HEADER = "<4sHHH"  # magic, version, sequence, length
_HEADER_SIZE = const(10)
_CRC_SIZE = const(4)
_MAGIC = b"SLOT"
_VERSION = const(1)


class Storage:
    """A payload in the two files `slots`, written `chunk` bytes at a time.

    `is_saving` is True from begin() until the last step(). `problem` is None, or the text that says what was found
    damaged by load(), or why the last save failed; it is about the newest of these calls only. Nothing here raises
    but for a payload that is too long.
    """

    def __init__(self, slots, chunk):
        self.is_saving = False
        self.problem = None
        self._slots = slots
        self._chunk = chunk
        self._guard = Guard()
        self._is_loaded = False
        self._newest = None  # index of the slot that must not be written
        self._sequence = 0
        self._file = None
        self._image = None
        self._written = 0

    def load(self):
        """Return the payload of the newest valid slot, or None if there is none; `problem` names what is damaged.

        A slot that is not there is no problem. One that is damaged beside a valid one is what a power cut leaves.
        """
        self._is_loaded = True
        self._newest = None
        self._sequence = 0
        self.problem = None
        newest = None
        for index in range(2):
            image = self._read(index)
            if image is None:
                continue
            sequence = struct.unpack_from(_HEADER, image)[2]
            if newest is None or 0 < (sequence - self._sequence) & 0xFFFF < 0x8000:  # it wraps
                newest = image
                self._newest = index
                self._sequence = sequence
        return None if newest is None else newest[_HEADER_SIZE:-_CRC_SIZE]

    def begin(self, payload):
        """Start to save a payload; step() does the work. An unfinished save is given up for it.

        ValueError: it is longer than LONGEST_PAYLOAD bytes.
        """
        if len(payload) > LONGEST_PAYLOAD:
            raise ValueError(f"a slot holds up to {LONGEST_PAYLOAD} bytes")
        if not self._is_loaded:
            self.load()  # else it would not be known which slot has to stay
        self._close()
        size = len(payload)
        image = bytearray(_HEADER_SIZE + size + _CRC_SIZE)
        struct.pack_into(_HEADER, image, 0, _MAGIC, _VERSION, (self._sequence + 1) & 0xFFFF, size)
        image[_HEADER_SIZE : _HEADER_SIZE + size] = payload
        struct.pack_into("<I", image, _HEADER_SIZE + size, crc32(memoryview(image)[:-_CRC_SIZE]) & 0xFFFFFFFF)
        self._image = image
        self._written = 0
        self.problem = None
        self.is_saving = True

    def step(self):
        """Do the next part of a save: open the file, write a chunk, close it, or read it back.

        Return True while there is more to do. An OSError ends the save, and the slot with the old payload is as it was.
        """
        if not self.is_saving:
            return False
        with self._guard:
            self._advance()
        if self._guard.error is not None:
            self._fail(f"{self._target()} cannot be written: {self._guard.error!r}")
        return self.is_saving

    def _advance(self):
        if self._file is None and self._written == 0:
            self._file = open(self._target(), "wb")  # noqa: SIM115 - it stays open over many steps
        elif self._written < len(self._image):
            written = self._file.write(memoryview(self._image)[self._written : self._written + self._chunk])
            if not written:
                raise OSError(errno.EIO)
            self._written += written
        elif self._file is not None:
            file = self._file
            self._file = None
            file.close()  # only now it is in flash
        else:
            self._finish()

    def _finish(self):
        index = self._target_index()
        if self._read(index) != self._image:
            self._fail(f"{self._target()} does not hold what was written")
            return
        self._newest = index
        self._sequence = (self._sequence + 1) & 0xFFFF
        self._image = None
        self.is_saving = False

    def _fail(self, problem):
        self.problem = problem
        self._close()
        self._image = None
        self.is_saving = False

    def _close(self):
        file = self._file
        self._file = None
        if file is not None:
            with self._guard:  # what it holds does not count anyway
                file.close()

    def _target_index(self):
        return 1 if self._newest == 0 else 0

    def _target(self):
        return self._slots[self._target_index()]

    def _read(self, index):
        """Return the bytes of a slot if it is whole, else None; `problem` says why unless there is no file."""
        with self._guard:
            return self._checked(self._slots[index])
        error = self._guard.error
        if not (isinstance(error, OSError) and error.errno == errno.ENOENT):
            self.problem = f"{self._slots[index]} is damaged: {error}"
        return None

    def _checked(self, path):
        with open(path, "rb") as file:
            header = file.read(_HEADER_SIZE)
            if len(header) < _HEADER_SIZE:
                raise ValueError("it is too short")
            magic, version, _, size = struct.unpack(_HEADER, header)
            if magic != _MAGIC or version != _VERSION:
                raise ValueError("it begins with something else")
            rest = file.read(size + _CRC_SIZE + 1)  # one byte more, to see that the file ends there
        if len(rest) != size + _CRC_SIZE:
            raise ValueError("its length is wrong")
        image = header + rest
        if crc32(memoryview(image)[:-_CRC_SIZE]) & 0xFFFFFFFF != struct.unpack("<I", rest[-_CRC_SIZE:])[0]:
            raise ValueError("its checksum is wrong")
        return image
