"""Runs the codec on the interpreter that it is started with: cases as JSON in, results as JSON out.

The same cases go through CPython and MicroPython, so this file keeps to what both have. Bytes are {"hex": ...} and
numbers that JSON lacks {"float": ...}. Operations answer for each form of the frames, "plain" and, where there is
machine code, "viper".
"""

import json
import sys

import frames
import frames_plain
import mavlink
import receiver
import sender
import signing
from message import Message

try:
    import frames_viper

    FORMS = {"plain": frames_plain, "viper": frames_viper}
except (AttributeError, ImportError):
    FORMS = {"plain": frames_plain}

COUNTERS = ("received", "signed", "refused", "unknown", "crc_errors", "dropped")


class Sink:
    """A stream that takes everything and keeps nothing."""

    def write(self, data):
        return len(data)


class Loop:
    """A stream that hands everything to a receiver, which has to read it at once: a sender goes on in its buffer."""

    def __init__(self):
        self.receiver = None
        self.heard = 0

    def write(self, data):
        self.receiver.put(data)
        while self.receiver.receive() is not None:
            self.heard += 1
        return len(data)


class Clock:
    """A clock that stands where it was put."""

    def __init__(self, now):
        self.now = now

    def __call__(self):
        return self.now


def use(form):
    """Let senders and receivers that are made from now on take a form of the frames."""
    module = FORMS[form]
    sender.encoder = module.encoder
    receiver.decoder = module.decoder
    receiver.taker = module.taker


def in_each_form(operation):
    """Make an operation answer {form: result}."""

    def run(request):
        results = {}
        for form in FORMS:
            use(form)
            results[form] = operation(request)
        return results

    return run


def from_json(value):
    """Return the value that JSON stands for."""
    if isinstance(value, dict):
        return bytes.fromhex(value["hex"]) if "hex" in value else float(value["float"])
    return [from_json(item) for item in value] if isinstance(value, list) else value


def to_json(value):
    """Return what JSON can say of a field's value."""
    if isinstance(value, bytes):
        return {"hex": value.hex()}
    if isinstance(value, tuple):
        return [to_json(item) for item in value]
    if isinstance(value, float) and (value != value or value - value != 0):  # noqa: PLR0124 - no math.isnan on boards
        return {"float": str(value)}
    return value


def message_class(description):
    """Make the class that messages.py would have."""
    return type(description["NAME"], (Message,), dict(description))


def classes_of(request):
    """Make all classes of a request."""
    return [message_class(description) for description in request["classes"]]


def raw_fields(message):
    """Return every field as it stands on the wire."""
    return {name: to_json(message.raw(name)) for name in message.names()}


def source(message):
    """Return where a message comes from."""
    return [message.source_system, message.source_component, message.source_sequence]


def choice(_request):
    """Tell whether each function of `frames` is the plain one."""
    names = ("decoder", "encoder", "taker")
    return [getattr(frames, name) is getattr(frames_plain, name) for name in names]


class Everything:
    """The messages of a receiver that takes every id for one of a class."""

    def get(self, _number):
        return False

    def values(self):
        return ()

    def __contains__(self, _number):
        return True

    def __getitem__(self, _number):
        return False


class Watched(receiver.Receiver):
    """A receiver that has no message and keeps the checksum of each frame that it finds, without CRC_EXTRA."""

    def __init__(self):
        super().__init__()
        self.found = []
        self._messages = Everything()
        self.receive = receiver.decoder(self)

    def _admitted(self, _message):
        self.found.append([self._state[3], self._state[7]])


@in_each_form
def checksums(request):
    """CRC without CRC_EXTRA of the frame that begins at a place in the data."""
    results = []
    for text, at in request["cases"]:
        watched = Watched()
        watched.put(bytes.fromhex(text))
        watched.receive()
        results.append(dict(watched.found).get(at))
    return results


@in_each_form
def sent_frames(request):
    """Set fields, encode, read the fields back."""
    classes = classes_of(request)
    link = mavlink.Link(Sink(), request["system"], request["component"], request["version"])
    results = []
    for index, sequence, values in request["cases"]:
        message = classes[index](unknown=False)
        for field, value in values.items():
            message.set(field, from_json(value))
        link.sequence = sequence
        read = {field: to_json(message.raw(field)) for field in values}
        results.append([bytes(link.encode(message)).hex(), read])
    return results


@in_each_form
def decode(request):
    """Feed pieces and tell the messages and the counters."""
    known = classes_of(request)
    if request["reuse"]:
        known = [cls() for cls in known]
    link = receiver.Receiver(known, size=request["size"])
    messages = []
    for piece in request["pieces"]:
        # A view that begins anywhere: a driver hands over what it has.
        data = memoryview(b"-" + bytes.fromhex(piece))[1:]
        if request["reuse"]:
            link.put(data)
            while True:
                message = link.receive()
                if message is None:
                    break
                messages.append([message.NAME, bytes(message.wire).hex(), source(message)])
        else:
            for message in link.feed(data):
                messages.append([message.NAME, bytes(message.wire).hex(), source(message)])
    return {"messages": messages, "counters": {name: getattr(link, name) for name in COUNTERS}}


def refusals(request):
    """Tell for each value how set() refuses it, or that it does not, and whether the payload stayed as it was."""
    results = []
    for field, value in request["cases"]:
        message = message_class({"NAME": "SAMPLE", "LENGTH": 64, "FIELDS": "before:8s field:" + field})(unknown=False)
        message.wire[:] = b"\x55" * 64
        try:
            number = from_json(value)
            message.set("field", number)
            by_name = bytes(message.wire)
            message.wire[:] = b"\x55" * 64
            message.field = number
            by_attribute = bytes(message.wire)
            message.wire[:] = b"\x55" * 64
            results.append([None, by_name == by_attribute == bytes(message.update(field=number).wire)])
        except ValueError:
            results.append(["ValueError", bytes(message.wire) == b"\x55" * 64])
    return results


def attributes(request):
    """Write a field as an attribute and by a keyword, and read it; what each has done, or the error."""
    results = []
    for field, attribute in request["cases"]:
        message = message_class({"NAME": "SAMPLE", "LENGTH": 3, "FIELDS": "before:B " + field + ":H"})(unknown=False)
        try:
            setattr(message, attribute, 513)
            found = [getattr(message, attribute), bytes(message.wire).hex()]
            message.update(**{attribute: 770})
            found += [message.get(field), bytes(message.wire).hex()]
            results.append(found)
        except AttributeError as error:
            results.append([error.args[0], bytes(message.wire).hex()])
    return results


@in_each_form
def live(request):
    """Encode messages with live values and receive them into others: raw fields, frames, what arrived."""
    classes = classes_of(request)
    results = []
    for index, names, wire, values in request["cases"]:
        message = classes[index](live=names, unknown=False)
        message.wire[:] = bytes.fromhex(wire)
        for place, value in enumerate(values):
            message.live[place] = value
        raw = raw_fields(message)
        frames = [bytes(mavlink.Link(Sink(), version=version).encode(message)) for version in (2, 1)]
        arrived = []
        for frame in frames:
            target = classes[index](live=names)
            (received,) = receiver.Receiver([target]).feed(frame)
            assert received is target
            # The wire is looked at first: to read a field puts the live values there again.
            arrived.append([bytes(target.wire).hex(), list(target.live), raw_fields(target)])
        results.append([raw, [frame.hex() for frame in frames], arrived])
    return results


def unknown(request):
    """Tell [get, raw] of a field at the start and, or the error, after set(); and what is on the wire."""
    results = []
    for description, name, value in request["cases"]:
        message = message_class(description)()
        answer = [to_json(message.get(name)), to_json(message.raw(name))]
        message = message_class(description)(unknown=False)
        message.wire[:] = b"\x55" * description["LENGTH"]
        try:
            message.set(name, from_json(value))
            answer += [to_json(message.get(name)), to_json(message.raw(name))]
        except ValueError:
            answer.append("ValueError")
        answer.append(bytes(message.wire).hex())
        results.append(answer)
    return results


def sign(request):
    """Encode signed frames, each at the time of the clock that it names."""
    classes = classes_of(request)
    clock = Clock(request["clock"])
    signer = signing.Signing(bytes.fromhex(request["key"]), request["link"], request["timestamp"], clock)
    link = mavlink.Link(Sink(), request["system"], request["component"], signing=signer)
    results = []
    for index, sequence, now, values in request["cases"]:
        clock.now = now
        message = classes[index](unknown=False)
        for field, value in values.items():
            message.set(field, from_json(value))
        link.sequence = sequence
        results.append(bytes(link.encode(message)).hex())
    return results


def judge(request):
    """Feed a signing link one piece after the other; tell the messages, the counters and the timestamp after each."""
    clock = Clock(request["clock"])
    signer = signing.Signing(bytes.fromhex(request["key"]), timestamp=request["timestamp"], clock=clock)
    link = mavlink.Link(Sink(), messages=classes_of(request), signing=signer)
    results = []
    for piece in request["pieces"]:
        messages = [[message.NAME, bytes(message.wire).hex()] for message in link.feed(bytes.fromhex(piece))]
        results.append([messages, [getattr(link, name) for name in COUNTERS], signer.timestamp])
    return results


def keep(request):
    """Save at one time and load at another; return what was loaded, and the first timestamp that it signs with."""
    clock = Clock(request["saved_at"])
    path = request["path"]
    signer = signing.Signing(bytes.fromhex(request["key"]), request["link"], request["timestamp"], clock)
    signer.save(path)
    signer.save(path)  # over the first one
    loaded = signing.load(path, clock=Clock(request["loaded_at"]))
    frame = bytearray(30)
    loaded.sign(frame)
    with open(path, "rb") as file:
        content = file.read()
    errors = 0
    damaged = [content[:-1], content + b"\0", b""]
    for place in range(len(content)):
        wrong = bytearray(content)
        wrong[place] ^= 1
        damaged.append(bytes(wrong))
    for wrong in damaged:
        with open(path, "wb") as file:
            file.write(wrong)
        try:
            signing.load(path)
        except ValueError:
            errors += 1
    try:
        signing.load(path + ".absent")
    except OSError:
        errors += 1
    return [loaded.key.hex(), loaded.link_id, int.from_bytes(bytes(frame[18:24]), "little"), errors - len(damaged)]


@in_each_form
def equal_frames(request):
    """Write random frames; what comes back, the link's buffer and the payload."""
    classes = classes_of(request)
    results = []
    for index, names, buffer, wire, values in request["cases"]:
        message = classes[index](live=names, unknown=False)
        message.wire[:] = bytes.fromhex(wire)
        for place, value in enumerate(values):
            message.live[place] = value
        whole = bytearray(bytes(8) + bytes.fromhex(buffer))
        sender.pack_into("<Q", whole, 0, sender.address(sender.TABLE))
        data = memoryview(whole)[8:]
        try:
            answer = sender.encoder(data, range(256), int)(message)
            end = 14 + data[3] if data[2] == 0xFD else 10 + data[3]
        except ValueError as error:
            answer = str(error)
            end = len(data)
        results.append([answer, bytes(data[:end]).hex(), bytes(message._image).hex(), list(message.live)])
    return results


@in_each_form
def equal_streams(request):
    """Take pieces in, and tell all that each message leaves behind."""
    classes = classes_of(request)
    results = []
    for size, offset, pieces in request["cases"]:
        known = []
        for index, cls in enumerate(classes):
            known.append(cls(live=request["live"][index]))
        taking = receiver.Receiver(known, size=size)
        steps = []
        for piece in pieces:
            taking.put(memoryview(bytes(offset) + bytes.fromhex(piece))[offset:])
            message = taking.receive()
            while message is not None:
                steps.append([message.NAME, bytes(message._image).hex(), list(message.live), list(taking._state)[:19]])
                message = taking.receive()
            # What describes a frame means nothing when there is none.
            state = taking._state
            steps.append([state[0], state[1], state[2], state[8], state[10], state[11], state[12]])
            steps.append([getattr(taking, name) for name in COUNTERS])
        results.append([steps, bytes(taking._buffer[: taking._state[1]]).hex()])  # behind that stands anything
    return results


def allocation(request):
    """Send random payloads of every class to a receiver, and let it take pieces: what does it allocate?

    Once with the heap locked from the first frame on, and once counted: a function that silently puts its variables
    on the heap when there is one does without when it is locked.
    """
    import micropython  # noqa: PLC0415 - only MicroPython has it

    results = []
    for description, names in zip(request["classes"], request["live"]):  # noqa: B905 - MicroPython has no strict
        for version in (1, 2):
            if version == 1 and description["ID"] > 0xFF:
                continue
            cls = message_class(description)
            loop = Loop()
            link = mavlink.Link(loop, version=version)
            message = cls(live=names)
            loop.receiver = receiver.Receiver([cls(live=names)])
            seen = bytearray(300)
            micropython.heap_lock()
            try:
                exchange(link, message, seen, request["rounds"])
            finally:
                micropython.heap_unlock()
            allocated = exchange_counted(link, message, seen, request["rounds"])
            lengths = [length for length in range(len(seen)) if seen[length]]
            counted = [link.sequence, link.tx_errors, loop.receiver.received, loop.heard, allocated]
            results.append([version, description["NAME"], lengths, counted])
    known = [cls() for cls in classes_of(request)]
    pieces = [bytes.fromhex(piece) for piece in request["pieces"]]
    taking = receiver.Receiver(known)
    micropython.heap_lock()
    try:
        found = take(taking, pieces)
    finally:
        micropython.heap_unlock()
    allocated = take_counted(taking, pieces)
    return {
        "sent": results,
        "taken": [found, allocated],
        "control": allocation_of_one(pieces),
        "is_plain": choice(None),
    }


def exchange(link, message, seen, rounds):
    """Send `rounds` frames that end in ever other numbers of zeros, every other one with live values of 32 bits.

    Marks the lengths in `seen`.
    """
    wire = message.wire
    live = message.live
    number = 1
    for turn in range(rounds):
        number = fill_wire(wire, turn % (len(wire) + 1), number)
        if turn & 1:
            number = fill_live(live, number)
        else:
            clear_live(live)
        seen[len(link.encode(message))] = 1
        link.send(message)


def exchange_counted(link, message, seen, rounds):
    """Return what exchange() allocates; the frame of exchange() itself, the same for any rounds, is taken off."""
    import micropython  # noqa: PLC0415

    exchange(link, message, seen, 1)
    start = micropython.mem_total()
    exchange(link, message, seen, 0)
    middle = micropython.mem_total()
    exchange(link, message, seen, rounds)
    end = micropython.mem_total()
    return (end - middle) - (middle - start)


def fill_wire(wire, kept, number):
    """Fill in random bytes, and zeros from some place on; small, as all that runs while it counts."""
    for index in range(len(wire)):
        number = (number * 75 + 74) % 65537
        wire[index] = number & 0xFF if index < kept else 0
    return number


def fill_live(live, number):
    """Fill in random values of 32 bits."""
    for index in range(len(live)):
        number = (number * 75 + 74) % 65537
        live[index] = (number - 32768) * 65535 + (number >> 1)
    return number


def clear_live(live):
    """Fill in zeros, as which live values leave a frame short."""
    for index in range(len(live)):
        live[index] = 0


def take(into, pieces):
    """Take pieces in as they come; return how many messages they complete."""
    found = 0
    for piece in pieces:
        into.put(piece)
        while into.receive() is not None:
            found += 1
    return found


def take_counted(into, pieces):
    """Return what take() allocates for all pieces; its own frame is taken off."""
    import micropython  # noqa: PLC0415

    none = pieces[:0]
    take(into, pieces)
    start = micropython.mem_total()
    take(into, none)
    middle = micropython.mem_total()
    take(into, pieces)
    end = micropython.mem_total()
    return (end - middle) - (middle - start)


def allocation_of_one(pieces):
    """Return what one copy of some bytes allocates: the count has to move for it."""
    import micropython  # noqa: PLC0415

    start = micropython.mem_total()
    bytearray(pieces[0])
    return micropython.mem_total() - start


def misuse(request):
    """Put wrong things where machine code takes addresses from; tell what came of it."""
    message = classes_of(request)[0](live=("custom_mode",))
    link = mavlink.Link(Sink(), messages=[message])
    before = bytes(link.encode(message))
    is_same = True
    for wrong in (5, None, b"", bytearray(1)):
        try:
            message.live = wrong
            is_same = False
        except AttributeError:
            pass
        is_same = is_same and bytes(link.encode(message)) == before
    data = bytearray(bytes.fromhex(request["frame"]) + bytes(2000))
    link.put(data)
    received = [int(link.receive() is not None)]
    data[:] = bytes(10)
    received.append(int(link.receive() is not None))
    received.append(len(list(link.feed(bytes(5000) + bytes.fromhex(request["frame"])))))
    refused = 0
    for wrong in (5, "text", [1], 1.5):
        try:
            link.put(wrong)
        except TypeError:
            refused += 1
    return {"same": is_same, "received": received, "refused": refused}


OPERATIONS = {
    "misuse": misuse,
    "choice": choice,
    "checksums": checksums,
    "sent_frames": sent_frames,
    "decode": decode,
    "refusals": refusals,
    "attributes": attributes,
    "live": live,
    "unknown": unknown,
    "sign": sign,
    "judge": judge,
    "keep": keep,
    "equal_frames": equal_frames,
    "equal_streams": equal_streams,
    "allocation": allocation,
}

if __name__ == "__main__":
    asked = json.loads(sys.stdin.read())
    sys.stdout.write(json.dumps(OPERATIONS[asked["operation"]](asked)))
