"""A saved payload is loaded again; a cut, a flipped bit or a full flash leaves the old one.

Standard input: a folder.
"""

import os
import sys
from binascii import crc32

import storage
from checks import run
from storage import Storage

FOLDER = sys.stdin.read()
SLOTS = (FOLDER + "/slot.a", FOLDER + "/slot.b")
OLD = bytes(range(40))
NEW = b"something else, and longer than that was, too: " + bytes(range(256))


def forget():
    """Remove both slots."""
    for slot in SLOTS:
        put(slot, b"")
        os.remove(slot)


def content(slot):
    with open(slot, "rb") as file:
        return file.read()


def put(slot, data):
    with open(slot, "wb") as file:
        file.write(data)


def save(kept, payload):
    """Save a payload; return how many steps that took."""
    kept.begin(payload)
    steps = 1
    while kept.step():
        steps += 1
    assert not kept.is_saving
    return steps


def saved(*payloads, chunk=64):
    """Return a storage that these payloads were saved in, one after the other, from nothing."""
    forget()
    kept = Storage(SLOTS, chunk)
    for payload in payloads:
        save(kept, payload)
        assert kept.problem is None, kept.problem
    return kept


def loaded():
    """Return what a storage finds after a new start, and its problem."""
    kept = Storage(SLOTS, 64)
    return kept.load(), kept.problem


def nothing_is_no_problem():
    forget()
    assert loaded() == (None, None)
    put(SLOTS[1], b"")
    payload, problem = loaded()
    assert payload is None
    assert SLOTS[1] in problem, problem


def newest_is_loaded():
    kept = saved()
    for number in range(7):
        payload = bytes([number]) * (number * 50)
        save(kept, payload)
        assert loaded() == (payload, None)
        assert kept.load() == payload


def sequence_wraps():
    kept = saved(b"first")
    kept._sequence = 0xFFFD
    for number in range(6):
        save(kept, bytes([number]))
        if number > 0:  # the slot that was first has another sequence
            assert loaded() == (bytes([number]), None), number


def any_length_and_chunk():
    for chunk in (1, 7, 64, 10000):
        for length in (0, 1, 63, 64, 65, 500):
            payload = bytes([length & 0xFF]) * length
            saved(OLD, payload, chunk=chunk)
            assert loaded() == (payload, None)
    saved(bytes(storage.LONGEST_PAYLOAD), chunk=10000)
    assert loaded() == (bytes(storage.LONGEST_PAYLOAD), None)
    try:
        saved(bytes(storage.LONGEST_PAYLOAD + 1))
    except ValueError:
        return
    raise AssertionError("a payload may not be too long")


def format_is_as_stated():
    saved(OLD)
    image = content(SLOTS[0])
    assert image[:10] == b"SLOT\x01\x00\x01\x00\x28\x00", image[:10]
    assert image[10:-4] == OLD
    assert int.from_bytes(image[-4:], "little") == crc32(image[:-4]) & 0xFFFFFFFF


def cut_file(image, before):
    """Yield what a slot may hold when the write of `image` over `before` is cut at any byte."""
    for length in range(len(image)):
        yield image[:length]
        for rest in (b"\x00", b"\xff", b"\xa5"):
            yield image[:length] + rest * (len(image) - length)
        yield image[:length] + before[length:]
        yield image[:length] + bytes([image[length] ^ 1]) + image[length + 1 :]


def cut_at_any_byte_leaves_old_or_new():
    saved(b"before that", OLD)  # in slots a and b: the next goes to a
    before = content(SLOTS[0])
    saved(b"before that", OLD, NEW)
    image = content(SLOTS[0])
    assert image != before
    tried = 0
    for data in cut_file(image, before):
        put(SLOTS[0], data)
        payload, problem = loaded()
        assert payload == (NEW if data == image else OLD), (tried, payload)
        assert (problem is None) == (data in (image, before)), problem
        tried += 1
    assert tried == 6 * len(image)


def cut_of_the_first_save_leaves_nothing_or_it():
    saved(NEW)
    image = content(SLOTS[0])
    for data in cut_file(image, b""):
        put(SLOTS[0], data)
        payload, problem = loaded()
        assert payload == (NEW if data == image else None)
        assert (problem is None) == (data == image)


def cut_after_any_step_leaves_old_or_new():
    """The true files, as far as they were written; with what was not flushed lost, and with it there."""
    steps = save(saved(b"before that", OLD, chunk=5), NEW)
    assert steps > len(NEW) // 5
    outcomes = []
    for number in range(steps + 1):
        kept = saved(b"before that", OLD, chunk=5)
        kept.begin(NEW)
        for _ in range(number):
            kept.step()
        seen = [loaded()[0]]
        if kept._file is not None:
            kept._file.flush()
            seen.append(loaded()[0])
            kept._file.close()
        assert all(payload in (OLD, NEW) for payload in seen)
        outcomes.append(seen[0] == NEW)
    assert outcomes[-1]
    assert not outcomes[0]
    assert outcomes == sorted(outcomes)


def any_flipped_bit_is_noticed():
    saved(NEW)
    image = content(SLOTS[0])
    for place in range(len(image) * 8):
        damaged = bytearray(image)
        damaged[place // 8] ^= 1 << place % 8
        put(SLOTS[0], damaged)
        payload, problem = loaded()
        assert payload is None, place
        assert "damaged" in problem
    put(SLOTS[0], image + b"\x00")
    assert loaded()[0] is None
    put(SLOTS[0], image)
    assert loaded() == (NEW, None)


def both_damaged_is_a_problem():
    saved(OLD, NEW)
    for slot in SLOTS:
        put(slot, content(slot)[:-1])
    payload, problem = loaded()
    assert payload is None
    assert "damaged" in problem
    kept = Storage(SLOTS, 64)
    kept.load()
    for _ in range(2):
        save(kept, OLD)
    assert kept.load() == OLD
    assert kept.problem is None
    put(SLOTS[0], b"damaged once more")
    assert kept.load() == OLD
    assert SLOTS[0] in kept.problem
    put(SLOTS[0], content(SLOTS[1]))
    assert kept.load() == OLD
    assert kept.problem is None


class Opened:
    """Stands in for open(): remembers what is opened for writing, and lets files fail."""

    def __init__(self, failing=None):
        self.failing = failing
        self.written = []

    def __call__(self, path, mode):
        if mode != "wb":
            return open(path, mode)
        self.written.append(path)
        if self.failing == "open":
            raise OSError(28)
        return File(open(path, mode), self.failing)


class File:
    """A file that fails in a way."""

    def __init__(self, file, failing):
        self._file = file
        self._failing = failing
        self._writes = 0

    def write(self, data):
        self._writes += 1
        if self._failing == "short":
            return self._file.write(bytes(data[:3]))
        if self._writes == 3 and self._failing == "write":
            raise OSError(28)
        if self._writes == 3 and self._failing in ("none", "zero"):
            return None if self._failing == "none" else 0
        if self._writes == 3 and self._failing == "garbage":
            return self._file.write(b"?" * len(data))
        return self._file.write(data)

    def close(self):
        self._file.close()
        if self._failing == "close":
            raise OSError(28)


def newest_slot_is_never_opened_for_writing():
    for attempt in range(5):
        kept = saved(*[bytes([number]) for number in range(attempt + 1)])
        storage.open = opened = Opened()
        try:
            fresh = Storage(SLOTS, 7)  # which did not load: it has to find out by itself
            save(fresh, NEW)
            fresh.begin(OLD)
            fresh.step()
            fresh.begin(NEW)
            save(fresh, NEW)
            save(kept, OLD)
        finally:
            del storage.open
        # attempt 0 has the payload in a, so that the save goes to b, and the next two to a
        a, b = SLOTS if attempt % 2 else (SLOTS[1], SLOTS[0])
        assert opened.written[:3] == [a, b, b], opened.written


def full_flash_keeps_the_old_payload():
    for failing in ("open", "write", "none", "zero", "garbage", "close"):
        kept = saved(b"before that", OLD)
        storage.open = opened = Opened(failing)
        try:
            for _ in range(3):  # not even repeated
                save(kept, NEW)
                assert SLOTS[0] in kept.problem, (failing, kept.problem)
                payload, _ = loaded()
                assert payload == NEW if failing == "close" else payload == OLD, failing
                if failing == "close":
                    break
            assert set(opened.written) == {SLOTS[0]}
        finally:
            del storage.open
        save(kept, NEW)
        assert kept.problem is None
        assert loaded() == (NEW, None)


def short_writes_are_gone_on_with():
    kept = saved(OLD)
    storage.open = Opened("short")
    try:
        save(kept, NEW)
    finally:
        del storage.open
    assert loaded() == (NEW, None)


def begin_replaces_what_is_not_finished():
    kept = saved(b"before that", OLD, chunk=7)
    for number in range(20):
        kept.begin(bytes([number]) * 100)
        for _ in range(number):
            assert kept.step()
        assert kept.is_saving
    payload = bytearray(NEW)
    kept.begin(payload)
    payload[0] ^= 0xFF  # what the caller does with it afterwards does not count
    while kept.step():
        pass
    assert loaded() == (NEW, None)
    assert not kept.step()


def unreadable_is_damaged():
    """A file system that fails is not the same as a slot that is not there."""

    def broken(_path, _mode):
        raise OSError(5)

    saved(OLD)
    storage.open = broken
    try:
        payload, problem = loaded()
    finally:
        del storage.open
    assert payload is None
    assert "damaged" in problem


class Flash:
    """A flash for littlefs. After `left` operations it writes half of one more and nothing any more."""

    BLOCK = 512

    def __init__(self, blocks=16):
        self._data = bytearray(b"\xff" * (blocks * self.BLOCK))
        self.left = None

    def copy(self, left):
        other = Flash()
        other._data = bytearray(self._data)
        other.left = left
        return other

    def readblocks(self, block, buffer, offset=0):
        start = block * self.BLOCK + offset
        buffer[:] = self._data[start : start + len(buffer)]

    def writeblocks(self, block, buffer, offset=0):
        start = block * self.BLOCK + offset
        length = self._allowed(len(buffer))
        self._data[start : start + length] = buffer[:length]
        if length < len(buffer):
            raise OSError(5)

    def ioctl(self, operation, block):
        if operation == 4:
            return len(self._data) // self.BLOCK
        if operation == 5:
            return self.BLOCK
        if operation == 6:
            length = self._allowed(self.BLOCK)
            start = block * self.BLOCK
            self._data[start : start + length] = b"\xff" * length
            return 0 if length == self.BLOCK else -5
        return 0

    def _allowed(self, length):
        if self.left is None:
            return length
        self.left -= 1
        return length if self.left >= 0 else length // 2 if self.left == -1 else 0


def cut_of_littlefs_leaves_old_or_new():
    """Power is cut at each operation of the flash that a save makes, in the true file system of the board."""
    global SLOTS  # noqa: PLW0603 - every function here means these
    if not hasattr(os, "VfsLfs2"):
        return  # CPython has no littlefs
    before, SLOTS = SLOTS, ("/flash/slot.a", "/flash/slot.b")
    try:
        flash = Flash()
        os.VfsLfs2.mkfs(flash)
        os.mount(os.VfsLfs2(flash), "/flash")
        saved(b"before that", OLD)
        os.umount("/flash")
        outcomes = []
        while not outcomes or not outcomes[-1][1]:
            cut = flash.copy(len(outcomes))
            os.mount(os.VfsLfs2(cut), "/flash")
            kept = Storage(SLOTS, 50)
            save(kept, NEW)
            problem = kept.problem
            os.umount("/flash")
            os.mount(os.VfsLfs2(cut.copy(None)), "/flash")
            payload, _ = loaded()
            os.umount("/flash")
            assert payload in (OLD, NEW), (len(outcomes), payload)
            outcomes.append((payload == NEW, problem is None))
        assert len(outcomes) > 5, outcomes
        assert outcomes[0] == (False, False)
        assert outcomes[-1] == (True, True)
    finally:
        SLOTS = before


run(
    nothing_is_no_problem,
    newest_is_loaded,
    sequence_wraps,
    any_length_and_chunk,
    format_is_as_stated,
    cut_at_any_byte_leaves_old_or_new,
    cut_of_the_first_save_leaves_nothing_or_it,
    cut_after_any_step_leaves_old_or_new,
    any_flipped_bit_is_noticed,
    both_damaged_is_a_problem,
    newest_slot_is_never_opened_for_writing,
    full_flash_keeps_the_old_payload,
    short_writes_are_gone_on_with,
    begin_replaces_what_is_not_finished,
    unreadable_is_damaged,
    cut_of_littlefs_leaves_old_or_new,
)
