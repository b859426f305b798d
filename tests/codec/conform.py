"""Runs on MicroPython: compares a generated codec with what pymavlink does, case by case.

`micropython conform.py CASES` reads lines of JSON, which conformance_cases.py writes, and prints one: how much was
compared, and what differed. The first line describes the dialect as pymavlink has it: nothing that is expected comes
from the codec. Whole numbers are those of JSON; a float is [m, e] for m * 2 ** e, or text such as "nan"; characters are
text, or [hex] where they are bytes.
"""

import json
import math
import struct
import sys

import frames
import frames_plain
import messages
from mavlink import Link
from receiver import Receiver

SHOWN = 25
COUNTERS = ("received", "signed", "refused", "unknown", "crc_errors", "dropped")
V1, V2 = 1, 2
INFINITY = float("inf")
HAS_DOUBLES = struct.unpack("<d", b"\0\0\0\0\0\0\xf0\x47")[0] != INFINITY  # 2 ** 128 is beyond floats of 32 bits

counts = {}
differences = []
state = {"case": "", "differences": 0}


class Sink:
    """A stream that takes everything and keeps nothing."""

    def write(self, data):
        return len(data)


class Subject:
    """A message: what pymavlink says about it, and what the codec has."""

    def __init__(self, description, cls):
        self.name, self.id, self.crc_extra, self.length, self.base_length, self.order, fields = description
        self.fields = fields  # [name, code, count, form of the sentinel, extension?] as in the XML
        self.cls = cls
        self.scratch = cls()
        self.target = cls()


def differ(what, found, expected):
    """Note a difference."""
    state["differences"] += 1
    if len(differences) < SHOWN:
        differences.append("%s: %s is %r, not %r" % (state["case"], what, found, expected))  # noqa: UP031


def expect(what, found, expected):
    """Compare something that has to be alike."""
    if found != expected:
        differ(what, found, expected)


def count(kind, number=1):
    """Count comparisons of a kind."""
    counts[kind] = counts.get(kind, 0) + number


def number(value):
    """Return the float that JSON stands for: put together from whole numbers, not read by struct."""
    return float(value) if isinstance(value, str) else math.ldexp(value[0], value[1])


def plain(field, value):
    """Return the value of a field that JSON stands for."""
    code = field[1]
    if code == "s":
        return bytes.fromhex(value[0]) if isinstance(value, list) else value
    if code in "fd" and value is not None:
        if field[2]:
            return [None if item is None else number(item) for item in value]
        return number(value)
    return value


def put(message, field, value):
    """Set a field by name, and where floats have 32 bits by fractions the doubles that are no such float."""
    if field[1] != "d" or HAS_DOUBLES:
        message.set(field[0], plain(field, value))
        return
    doubles = __import__("doubles")  # a codec without doubles has none
    items = value if field[2] else [value]
    floats = [single(item) for item in items]
    message.set(field[0], floats if field[2] else floats[0])
    for index, item in enumerate(items):
        if isinstance(item, list):
            doubles.set_ratio(message, field[0], *fraction(item), index)


def single(item):
    """Return the float of 32 bits that is nearest to a float of JSON."""
    return struct.unpack("<f", struct.pack("<f", number(item)))[0]


def fraction(item):
    """Return numerator and denominator of a float of JSON."""
    mantissa, exponent = item
    return (mantissa << exponent, 1) if exponent > 0 else (mantissa, 1 << -exponent)


def check_doubles(message, field, value):
    """Compare doubles where floats have 32 bits: the nearest float, the whole number beyond all, and the fraction."""
    doubles = __import__("doubles")
    found = message.raw(field[0])
    for index, item in enumerate(value if field[2] else [value]):
        one = found[index] if field[2] else found
        expected = single(item)
        if isinstance(item, list):
            numerator, denominator = fraction(item)
            if abs(expected) == INFINITY:
                expected = numerator
            top, bottom = doubles.ratio(message, field[0], index)
            expect("ratio(" + field[0] + ")", top * denominator, numerator * bottom)
        if not is_same(one, expected):
            differ("raw(" + field[0] + ")", one, expected)


def is_same(found, expected):
    """Compare values as they are on the wire: NaN is NaN, a list is a tuple, types count."""
    if isinstance(expected, list):
        if not isinstance(found, tuple) or len(found) != len(expected):
            return False
        return all(is_same(found[index], value) for index, value in enumerate(expected))
    if type(found) is not type(expected):
        return False
    return found == expected or (found != found and expected != expected)  # noqa: PLR0124  NaN


def check_values(subject, message, values):
    """Compare raw() of every field."""
    for field, value in zip(subject.fields, values):  # noqa: B905 - MicroPython has no strict
        if field[1] == "d" and not HAS_DOUBLES:
            check_doubles(message, field, value)
            continue
        expected = plain(field, value)
        found = message.raw(field[0])
        if not is_same(found, expected):
            differ("raw(" + field[0] + ")", found, expected)


def check_unknown(subject, message, values, has_extensions):
    """Whatever was set to None has to be None for get(), too; `values` are those that were set."""
    for field, value in zip(subject.fields, values):  # noqa: B905
        name, code, _, form, is_extension = field
        if not form or code == "s" or (is_extension and not has_extensions):
            continue
        found = message.get(name)
        if value is None and form == "each":
            expect("get(" + name + ")", [item is None for item in found], [True] * len(found))
        elif value is None and form == "positions":
            expect("get(" + name + ")", any(item is None for item in found), True)
        elif value is None:
            expect("get(" + name + ")", found, None)
        elif isinstance(value, list) and form == "each":
            for index, item in enumerate(value):
                if item is None:
                    expect("get(" + name + ")", found[index], None)


def padded(subject, frame):
    """Return the payload of a frame in the length that the message has."""
    start = 10 if frame[0] == 0xFD else 6
    payload = frame[start : start + frame[1]][: subject.length]
    return payload + bytes(subject.length - len(payload))


def origin(frame):
    """Return system, component and sequence number of a frame."""
    return (frame[5], frame[6], frame[4]) if frame[0] == 0xFD else (frame[3], frame[4], frame[2])


def source(message):
    """Return where a message comes from."""
    return (message.source_system, message.source_component, message.source_sequence)


class Run:
    """One dialect."""

    def __init__(self, head):
        classes = {cls.ID: cls for cls in messages.ALL}
        state["case"] = "dialect"
        expect("ids of the messages", sorted(classes), head["ids"])
        # A message that is missing is a difference; for its cases any other stands in.
        self.subjects = [
            Subject(description, classes.get(description[1], messages.ALL[0])) for description in head["messages"]
        ]
        self.links = {version: Link(Sink(), head["system"], head["component"], version=version) for version in (V1, V2)}
        self.reusing = Receiver([subject.target for subject in self.subjects])
        self.making = Receiver([subject.cls for subject in self.subjects])
        self.fed = {True: 0, False: 0}

    def arrive(self, subject, frame, is_new):
        """Let a frame arrive in two pieces; return the message, None if it is not just this one."""
        receiver = self.making if is_new else self.reusing
        if not is_new:
            subject.target.wire[:] = b"\x55" * subject.length
        self.fed[is_new] += 1
        cut = origin(frame)[2] % len(frame)
        found = list(receiver.feed(frame[:cut]))
        found += list(receiver.feed(frame[cut:]))
        if len(found) != 1 or not isinstance(found[0], subject.cls):
            differ("what arrives", [message.NAME for message in found], [subject.name])
            return None
        message = found[0]
        expect("source", source(message), origin(frame))
        wire = bytes(message.wire)
        if wire != padded(subject, frame):
            differ("wire", wire.hex(), padded(subject, frame).hex())
        return message

    def encoded(self, message, version, sequence, frame):
        """Compare the frame that the codec makes."""
        link = self.links[version]
        link.sequence = sequence
        found = bytes(link.encode(message))
        if found != frame:
            differ("frame", found.hex(), frame.hex())

    def classes(self, kind, index):
        """Compare what the class says; None for fields that have no sentinel; MAVLink 1 with ids above 255."""
        subject = self.subjects[index]
        cls = subject.cls
        expect("NAME", cls.NAME, subject.name)
        expect("CRC_EXTRA", cls.CRC_EXTRA, subject.crc_extra)
        expect("LENGTH", cls.LENGTH, subject.length)
        expect("BASE_LENGTH", cls.BASE_LENGTH, subject.base_length)
        expect("names()", cls().names(), subject.order)
        message = cls(unknown=False)
        expect("wire at first", bytes(message.wire), bytes(subject.length))
        for name, _, _, form, _ in subject.fields:
            if not form:
                try:
                    message.set(name, None)
                    differ("set(" + name + ", None)", "accepted", "no sentinel")
                except ValueError:
                    pass
        if subject.id > 255:
            try:
                self.links[V1].encode(message)
                differ("MAVLink 1", "a frame", "no such id")
            except ValueError:
                pass
        count(kind)

    def both(self, kind, index, version, sequence, values, text, expected):
        """Set every field by name and encode; let pymavlink's frame arrive and read every field."""
        subject = self.subjects[index]
        frame = bytes.fromhex(text)
        is_new = bool(sequence & 1)
        message = subject.cls() if is_new else subject.scratch
        for field, value in zip(subject.fields, values):  # noqa: B905
            put(message, field, value)
        self.encoded(message, version, sequence, frame)
        self.decoded(subject, frame, is_new, expected or values, values)
        count(kind)
        count("encode")
        count("decode")
        if version == V1:
            count("v1", 2)

    def decoded(self, subject, frame, is_new, expected, values=None):
        """Let a frame arrive and compare every field."""
        message = self.arrive(subject, frame, is_new)
        if message is not None:
            check_values(subject, message, expected)
            if values is not None:
                check_unknown(subject, message, values, frame[0] == 0xFD)

    def default(self, kind, index, version, sequence, text, expected):
        """A message that nobody has written to: every sentinel stands."""
        subject = self.subjects[index]
        frame = bytes.fromhex(text)
        message = subject.cls()
        self.encoded(message, version, sequence, frame)
        self.decoded(subject, frame, False, expected)
        count(kind)
        count("encode")
        count("decode")
        if version == V1:
            count("v1", 2)

    def arrives(self, kind, index, text, expected):
        """Let a frame arrive that the codec itself would not send."""
        subject = self.subjects[index]
        frame = bytes.fromhex(text)
        self.decoded(subject, frame, False, expected)
        count(kind)
        count("decode")
        if frame[0] == 0xFE:
            count("v1")

    def truncated(self, kind, index, sequence, payload, texts):
        """Payloads with zeros from each place on: texts[k] is the frame with k bytes that are not zero."""
        subject = self.subjects[index]
        message = subject.scratch
        message.wire[:] = bytes.fromhex(payload)
        for used in range(subject.length, -1, -1):
            if used < subject.length:
                message.wire[used] = 0
            frame = bytes.fromhex(texts[used])
            self.encoded(message, V2, sequence, frame)
            self.arrive(subject, frame, False)
        count(kind, len(texts))
        count("encode", len(texts))
        count("decode", len(texts))

    def live(self, kind, index, version, sequence, names, numbers, values, text, expected):
        """Live fields are given in `numbers`, the others by name."""
        subject = self.subjects[index]
        frame = bytes.fromhex(text)
        message = subject.cls(live=names, unknown=False)
        bases = {name.split("[")[0] for name in names}
        for field, value in zip(subject.fields, values):  # noqa: B905
            # A field of which one element is live needs the others, too.
            if field[0] not in bases or any(name.startswith(field[0] + "[") for name in names):
                put(message, field, value)
        for place, value in enumerate(numbers[0]):
            message.live[place] = value
        self.encoded(message, version, sequence, frame)
        target = subject.cls(live=names)
        found = list(Receiver([target]).feed(frame))
        if len(found) != 1 or found[0] is not target:
            differ("what arrives", [message.NAME for message in found], [subject.name])
        else:
            expect("wire", bytes(target.wire), padded(subject, frame))
            expect("live", list(target.live), numbers[1])
            expect("source", source(target), origin(frame))
            check_values(subject, target, expected)
        count(kind)
        count("encode")
        count("decode")
        if version == V1:
            count("v1", 2)

    def stream(self, kind, pieces, expected, counters):
        """Frames among what is none: which arrive, and the counters, each between two bounds."""
        receiver = Receiver([subject.cls for subject in self.subjects])
        found = []
        for piece in pieces:
            for message in receiver.feed(bytes.fromhex(piece)):
                found.append([message.NAME, bytes(message.wire).hex(), list(source(message))])
        if found != expected:
            names = [item[0] for item in found]
            wanted = [item[0] for item in expected]
            differ("stream", names if names != wanted else found, wanted if names != wanted else expected)
        for name in COUNTERS:
            low, high = counters[name]
            if not low <= getattr(receiver, name) <= high:
                differ(name, getattr(receiver, name), counters[name])
        count(kind)
        count("decode", len(expected))
        count("refused", counters["unknown"][0] + counters["crc_errors"][0] + counters["dropped"][0])

    def enum(self, kind, entries):
        """Compare the entries of an enum."""
        found = __import__("enums")
        for name, value in entries.items():
            expect(name, getattr(found, name, None), value)
        count(kind, len(entries))

    def close(self):
        """Nothing that was fed may have been counted as anything but a message."""
        state["case"] = "at the end"
        for is_new, receiver in ((True, self.making), (False, self.reusing)):
            expect("received", receiver.received, self.fed[is_new])
            for name in ("refused", "unknown", "crc_errors", "dropped"):
                expect(name, getattr(receiver, name), 0)


def lines(path):
    """Read a file in large pieces: readline() asks the system for every single byte."""
    rest = b""
    with open(path, "rb") as file:
        while True:
            piece = file.read(1 << 18)
            if not piece:
                return
            *whole, rest = (rest + piece).split(b"\n")
            yield from whole


def main(path):
    """Read the cases and print the result."""
    cases = lines(path)
    run = Run(json.loads(next(cases)))
    for line in cases:
        operation, kind, *rest = json.loads(line)
        about = run.subjects[rest[0]].name if rest and isinstance(rest[0], int) else ""
        is_versioned = operation in ("both", "default", "live")
        state["case"] = kind + " " + about + (" v" + str(rest[1]) if is_versioned else "")
        try:
            getattr(run, operation)(kind, *rest)
        except Exception as error:  # a codec that raises is a difference like any other
            differ(operation, repr(error), "no error")
    run.close()
    form = "plain" if frames.encoder is frames_plain.encoder else "viper"
    result = {"form": form, "counts": counts, "differences": differences, "different": state["differences"]}
    sys.stdout.write(json.dumps(result) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
