"""Faults of bytes and of lines, whatever a file means."""

import random

from fuzzing.hostile import BYTES

_PLACES = 3  # at which bytes become others


def by_bytes(data: bytes, lot: random.Random) -> bytes:
    """Return the file with one fault."""
    return lot.choice((_other, _inserted, _cut, _dropped, _doubled, _coded, _lines, _lines, _indented, _ended))(
        data, lot
    )


def _at(data: bytes, lot: random.Random) -> int:
    return lot.randrange(len(data) + 1)


def _other(data: bytes, lot: random.Random) -> bytes:
    changed = bytearray(data)
    for _ in range(min(_PLACES, len(data))):
        changed[lot.randrange(len(data))] = lot.randrange(256)
    return bytes(changed)


def _inserted(data: bytes, lot: random.Random) -> bytes:
    at = _at(data, lot)
    return data[:at] + lot.choice(BYTES) * lot.choice((1, 1, 1, 3, 1000)) + data[at:]


def _cut(data: bytes, lot: random.Random) -> bytes:
    return data[: _at(data, lot)]


def _dropped(data: bytes, lot: random.Random) -> bytes:
    at = _at(data, lot)
    return data[:at] + data[at + lot.choice((1, 1, 2, 8, 50, 500)) :]


def _doubled(data: bytes, lot: random.Random) -> bytes:
    start = _at(data, lot)
    part = data[start : start + lot.choice((1, 5, 40, 400))]
    at = _at(data, lot)
    return data[:at] + part * lot.choice((1, 1, 2, 50)) + data[at:]


def _coded(data: bytes, lot: random.Random) -> bytes:
    """Return the text in another encoding, with or without its mark."""
    text = data.decode("utf-8", "replace")
    encoding = lot.choice(("utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-8-sig", "latin-1", "cp037", "utf-7"))
    return text.encode(encoding, "replace")


def _lines(data: bytes, lot: random.Random) -> bytes:
    """Return the lines with one of them left out, doubled, exchanged or put elsewhere."""
    lines = data.splitlines(keepends=True)
    if not lines:
        return b"\n"
    first, second = lot.randrange(len(lines)), lot.randrange(len(lines))
    kind = lot.randrange(5)
    if kind == 0:
        del lines[first]
    elif kind == 1:
        lines.insert(second, lines[first])
    elif kind == 2:
        lines[first], lines[second] = lines[second], lines[first]
    elif kind == 3:
        lines[first : first + lot.randrange(20)] = []
    else:
        lines.insert(second, lines.pop(first))
    return b"".join(lines)


def _indented(data: bytes, lot: random.Random) -> bytes:
    lines = data.splitlines(keepends=True) or [b""]
    at = lot.randrange(len(lines))
    lines[at] = lot.choice((b" ", b"  ", b"\t", b"      ")) + lines[at] if lot.random() < 0.5 else lines[at].lstrip()
    return b"".join(lines)


def _ended(data: bytes, lot: random.Random) -> bytes:
    return lot.choice(
        (data.replace(b"\n", b"\r\n"), data.replace(b"\n", b"\r"), data.rstrip(), b"", b"\n", data + data)
    )
