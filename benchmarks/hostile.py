# ruff: noqa: T201  what is wrong is printed
"""Lets hostile bytes arrive at the generated receiver, millions of them, with frames among them that are right.

`make fuzz` does it for a codec and for the rover's program, each in machine code and in plain Python, under
MicroPython. Which frames have to be found says a search with pymavlink's checksum: from left to right, and only a frame
that is right hides what is within it. Nothing may raise; what is looked at before the receiver lets others run is
limited; the rover answers each PING that is right, at a port that brings bytes and at one that brings datagrams.
"""

import argparse
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import measure
import quality_results
from pymavlink.dialects.v10 import common as common_1
from pymavlink.dialects.v20 import common as common_2
from pymavlink.generator.mavcrc import x25crc
from whole_program import module_folders

CODEC = ("HEARTBEAT", "SYS_STATUS", "PARAM_VALUE", "TIMESYNC", "BATTERY_STATUS", "STATUSTEXT", "LOGGING_DATA", "PING")
"""The messages that the codec receives: truncated and long ones, text, and words of 64 bits."""
LONGEST_PIECE = 1400
"""Bytes, so that it fits into a datagram."""
PING = 4
REBOOT = 246
FORMS = ("machine code", "plain")
PORTS = ("bytes", "datagrams")
_HEADERS = {0xFD: 10, 0xFE: 6}
_START = re.compile(rb"[\xfd\xfe]")


@dataclass(frozen=True)
class Stream:
    """Pieces as they arrive."""

    pieces: tuple[bytes, ...]

    def write(self, path: Path) -> None:
        """Write the pieces, each with its length of two bytes before it."""
        path.write_bytes(b"".join(len(piece).to_bytes(2, "little") + piece for piece in self.pieces))


def main() -> int:
    """Draw, let arrive, compare; 1 where something is not as it has to be."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--bytes", type=int, default=10_000_000, dest="count", help="for each receiver")
    parser.add_argument("--rover", type=Path, default=measure.ROOT / "generated", help="the folder of a build")
    parser.add_argument("--store", action="store_true", help="keep the numbers for docs/quality.md")
    arguments = parser.parse_args()
    faults = receivers = 0
    with tempfile.TemporaryDirectory(prefix="codegen-hostile-") as folder:
        for name, found in outcomes(arguments.seed, arguments.count, arguments.rover, Path(folder)):
            print(f"{name}: {'; '.join(found) or 'nothing is wrong'}", flush=True)
            faults += len(found)
            receivers += 1
    print(f"seed {arguments.seed}: {arguments.count} hostile bytes for each receiver, {faults} faults")
    if arguments.store:
        found = {"bytes": arguments.count, "receivers": receivers, "faults": faults}
        quality_results.store("hostile", str(arguments.seed), found)
    return 1 if faults else 0


def outcomes(seed: int, count: int, rover: Path, folder: Path) -> Iterator[tuple[str, list[str]]]:
    """Return for each receiver what is wrong with it."""
    stream = drawn(seed, count)
    for form in FORMS:
        options = ("--bytecode",) if form == "plain" else ()
        made = measure.codec(folder / f"codec {form}", ",".join(CODEC), *options)
        yield f"codec, {form}", codec_faults(made, stream, folder, form)
    for form in FORMS:
        generated = rover if form == "machine code" else measure.without_machine_code(measure.ROOT, folder / "plain")
        for port in PORTS:
            yield f"rover, {form}, {port}", rover_faults(generated, stream, folder, form, port)


def drawn(seed: int, count: int) -> Stream:
    """Draw pieces of so many bytes together, or some more."""
    lot = random.Random(seed)
    sender = common_2.MAVLink(None, srcSystem=255, srcComponent=190)
    pieces, ping, length = [], 0, 0
    while length < count:
        parts = [_part(lot, sender) for _ in range(lot.choice((1, 1, 2, 3)) if lot.random() < 0.99 else 40)]
        if lot.random() < 0.1:
            ping += 1
            message = common_2.MAVLink_ping_message(lot.randrange(1 << 40), ping, 0, 0)
            parts.insert(lot.randrange(len(parts) + 1), bytes(message.pack(sender)))
            sender.seq = (sender.seq + 1) & 0xFF
        pieces.append(b"".join(parts)[:LONGEST_PIECE] or b"\0")
        length += len(pieces[-1])
    return Stream(tuple(pieces))


def _part(lot: random.Random, sender: common_2.MAVLink) -> bytes:
    """Return bytes that are no message, or a message that nobody expects to be well meant."""
    kind = lot.randrange(9)
    if kind == 0:
        return lot.randbytes(lot.randrange(120))
    if kind == 1:
        return bytes(lot.choices(b"\xfd\xfe\xff\x00", k=lot.randrange(60)))
    if kind == 2:  # the head of a frame that does not come
        number = lot.choice((0, 4, 76, lot.randrange(1 << 24)))
        return bytes((0xFD, lot.randrange(256), lot.choice((0, 0, 1, 2, 255)), 0, 0, 255, 190)) + number.to_bytes(
            3, "little"
        )
    frame = bytearray(_frame(lot, sender))
    if kind == 3:
        frame[lot.randrange(len(frame))] ^= 1 << lot.randrange(8)
    elif kind == 4:
        del frame[lot.randrange(len(frame)) :]
    elif kind == 5:
        at = lot.randrange(len(frame))
        frame[at:at] = lot.randbytes(lot.randrange(1, 4))
    elif kind == 6:  # one in another, of a message that nobody knows
        body = bytes((min(len(frame), 255), 0, 0, 0, 1, 1)) + (70_000).to_bytes(3, "little") + bytes(frame[:255])
        return b"\xfd" + body + x25crc(body + b"\x07").crc.to_bytes(2, "little")
    return bytes(frame)


def _frame(lot: random.Random, sender: common_2.MAVLink) -> bytes:
    """Return a frame that is right, with any values; none restarts the vehicle."""
    dialect, version = (common_2, 2) if lot.random() < 0.7 else (common_1, 1)
    numbers = [
        *(0, 20, 21, 23, 66, 75, 76, 110, 111),
        *(each.id for name, each in _by_name(dialect).items() if name in CODEC),
    ]
    number = lot.choice([each for each in numbers if each in dialect.mavlink_map and each != PING])
    kind = dialect.mavlink_map[number]
    payload = bytearray(lot.choice((lot.randbytes, bytes))(kind.unpacker.size))
    names = list(kind.ordered_fieldnames)
    offsets = _offsets(kind)
    for name, value in (("target_system", 1), ("target_component", lot.choice((0, 1)))):
        if name in names and lot.random() < 0.9:
            payload[offsets[name]] = value
    if "command" in names:
        command = lot.choice((lot.randrange(1 << 16), 400, 410, 511, 512, 519, 520, 521, 241, 245))
        at = offsets["command"]
        payload[at : at + 2] = (0 if command == REBOOT else command).to_bytes(2, "little")
    extra = kind.crc_extra
    sender.seq = (sender.seq + 1) & 0xFF
    if version == 1:
        body = bytes((len(payload), sender.seq, 255, 190, number)) + bytes(payload)
        return b"\xfe" + body + x25crc(body + bytes((extra,))).crc.to_bytes(2, "little")
    sent = bytes(payload).rstrip(b"\0") or b"\0"
    body = bytes((len(sent), 0, 0, sender.seq, 255, 190)) + number.to_bytes(3, "little") + sent
    return b"\xfd" + body + x25crc(body + bytes((extra,))).crc.to_bytes(2, "little")


def _by_name(dialect: object) -> dict[str, type]:
    return {each.msgname: each for each in dialect.mavlink_map.values()}  # type: ignore[attr-defined]


def _offsets(kind: type) -> dict[str, int]:
    """Return where the fields of a message begin."""
    sizes = {"b": 1, "B": 1, "c": 1, "h": 2, "H": 2, "i": 4, "I": 4, "f": 4, "q": 8, "Q": 8, "d": 8}
    found, at = {}, 0
    codes = kind.native_format.decode()[1:]  # type: ignore[attr-defined]
    for name, code, count in zip(kind.ordered_fieldnames, codes, kind.array_lengths, strict=True):  # type: ignore[attr-defined]
        found[name] = at
        at += sizes[code] * max(1, count)
    return found


def frames_in(data: bytes, known: dict[int, int]) -> Iterator[bytes]:
    """Return the frames of known messages (their ids with CRC_EXTRA) from left to right, whole and right ones."""
    at = 0
    while (start := _START.search(data, at)) is not None:
        at = start.start()
        frame = _frame_at(data, at, known)
        if frame is None:
            at += 1
        else:
            yield frame
            at += len(frame)


def _frame_at(data: bytes, at: int, known: dict[int, int]) -> bytes | None:
    header = _HEADERS[data[at]]
    if at + header > len(data):
        return None
    flags = data[at + 2] if header == 10 else 0
    number = int.from_bytes(data[at + 7 : at + 10], "little") if header == 10 else data[at + 5]
    body = header + data[at + 1]
    whole = body + 2 + (13 if flags else 0)
    if flags > 1 or number not in known or at + whole > len(data):
        return None
    crc = x25crc(data[at + 1 : at + body] + bytes((known[number],))).crc
    return data[at : at + whole] if crc == data[at + body] | data[at + body + 1] << 8 else None


def codec_expected(stream: Stream) -> list[str]:
    """Return the messages that the codec has to find, as hostile_codec.py prints them."""
    kinds = {each.id: each for name, each in _by_name(common_2).items() if name in CODEC}
    extras = {number: kind.crc_extra for number, kind in kinds.items()}
    expected = []
    for frame in frames_in(b"".join(stream.pieces), extras):
        header = _HEADERS[frame[0]]
        number = int.from_bytes(frame[7:10], "little") if header == 10 else frame[5]
        length = kinds[number].unpacker.size
        payload = frame[header : header + frame[1]][:length].ljust(length, b"\0")
        expected.append(f"{number} {frame[4 if header == 10 else 2]} {payload.hex()}")
    return expected


def pings_expected(stream: Stream, known: dict[int, int], port: str) -> list[int]:
    """Return the numbers of the PINGs that the rover has to answer."""
    found = []
    for data in stream.pieces if port == "datagrams" else (b"".join(stream.pieces),):
        for frame in frames_in(data, known):
            is_2 = frame[0] == 0xFD
            if (int.from_bytes(frame[7:10], "little") if is_2 else frame[5]) == PING:
                payload = frame[10 : 10 + frame[1]].ljust(14, b"\0") if is_2 else frame[6:20]
                found.append(int.from_bytes(payload[8:12], "little"))
    return found


def _ran(script: str, modules: tuple[Path, ...], stream: Stream, folder: Path, *arguments: str) -> dict[str, object]:
    """Return what a script of benchmarks/micropython answers, and the lines that it has written to a file."""
    pieces, lines = folder / "pieces", folder / "lines"
    stream.write(pieces)
    command = [measure.tool("micropython"), "-X", "heapsize=64m", str(measure.HERE / "micropython" / script)]
    path = os.pathsep.join((*map(str, modules), ".frozen"))
    environment = {**os.environ, "MICROPYPATH": path}
    done = subprocess.run(  # noqa: S603  the interpreter of the development tools
        [*command, str(pieces), str(lines), *arguments], env=environment, capture_output=True, text=True, check=False
    )
    said = done.stdout.strip().splitlines()
    if done.returncode or not said:
        return {"raised": (done.stdout + done.stderr).strip()[-500:]}
    return {**json.loads(said[-1]), "lines": lines.read_text().splitlines()}


def codec_faults(made: Path, stream: Stream, folder: Path, form: str) -> list[str]:
    """Return what is wrong with the codec in a folder."""
    answer, expected = _ran("hostile_codec.py", (made,), stream, folder), codec_expected(stream)
    if "raised" in answer:
        return [f"it raised: {answer['raised']}"]
    faults = _common_faults(answer, form)
    lines = answer["lines"]
    if lines != expected:
        pairs = zip((*lines, ""), (*expected, ""), strict=False)  # type: ignore[misc]
        at = next(index for index, (line, other) in enumerate(pairs) if line != other)
        faults.append(f"{len(lines)} messages in place of {len(expected)}, others from number {at} on")  # type: ignore[arg-type]
    return faults


def rover_faults(generated: Path, stream: Stream, folder: Path, form: str, port: str) -> list[str]:
    """Return what is wrong with the program in the folder of a build."""
    modules = tuple(module_folders(generated, "tests", "firmware", "mocks"))
    answer = _ran("hostile_rover.py", modules, stream, folder, port)
    if "raised" in answer:
        return [f"it raised: {answer['raised']}"]
    faults = _common_faults(answer, form)
    if answer["faults"]:
        faults.append(f"{answer['faults']} exceptions: {answer['said']}")
    known = {int(number): extra for number, extra in answer["known"].items()}  # type: ignore[attr-defined]
    expected, answered = pings_expected(stream, known, port), [int(line) for line in answer["lines"]]  # type: ignore[attr-defined]
    if answered != expected:
        lost, more = set(expected) - set(answered), set(answered) - set(expected)
        faults.append(
            f"{len(answered)} of {len(expected)} PINGs are answered; not: {sorted(lost)[:3]}, more: {sorted(more)[:3]}"
        )
    return faults


def _common_faults(answer: dict[str, object], form: str) -> list[str]:
    faults = []
    if answer["form"] != form:
        faults.append(f"it ran as {answer['form']}")
    if answer["work"] > answer["most"]:  # type: ignore[operator]
        faults.append(f"{answer['work']} bytes were looked at in one pass")
    return faults


if __name__ == "__main__":
    sys.exit(main())
