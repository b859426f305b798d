"""Runs the firmware's framing on the interpreter that it is started with: cases as JSON in, results as JSON out.

The same cases go through CPython and MicroPython, so this file keeps to what both have. Bytes are {"hex": ...} and
numbers that JSON lacks {"float": ...}.
"""

import json
import sys

import crc
import crc_plain
import fields
import mavlink
from crc_table import TABLE

try:
    import crc_viper
except ImportError:
    crc_viper = None


class Sink:
    """A stream that takes everything and keeps nothing."""

    def write(self, data):
        return len(data)


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
    description["FIELDS"] = {name: tuple(field) for name, field in description["FIELDS"].items()}
    return type(description["NAME"], (mavlink.Message,), description)


def checksums(request):
    """CRC of pieces of data, by each implementation that there is."""
    results = {}
    for name, module in (("plain", crc_plain), ("viper", crc_viper)):
        if module:
            results[name] = [
                module.update(start_value, TABLE, bytes.fromhex(data), start, end)
                for data, start, end, start_value in request["cases"]
            ]
    return {"results": results, "native": crc.update is not crc_plain.update}


def frames(request):
    """Set fields, encode, read the fields back; with either implementation of the checksum."""
    classes = [message_class(description) for description in request["classes"]]
    results = {}
    for name, module in (("plain", crc_plain), ("viper", crc_viper)):
        if not module:
            continue
        mavlink.write_frame = module.write_frame
        link = mavlink.Link(Sink(), request["system"], request["component"], request["version"])
        results[name] = []
        for index, sequence, values in request["cases"]:
            message = classes[index]()
            for field, value in values.items():
                message.set(field, from_json(value))
            link.sequence = sequence
            read = {field: to_json(message.get(field)) for field in values}
            results[name].append([bytes(link.encode(message)).hex(), read])
    mavlink.write_frame = crc.write_frame
    return results


def decode(request):
    """Feed pieces and tell the messages, what each feed() yielded, and the counters."""
    link = mavlink.Link(Sink(), messages=[message_class(description) for description in request["classes"]])
    messages = []
    for piece in request["pieces"]:
        for message in link.feed(bytes.fromhex(piece)):
            source = [message.system_id, message.component_id, message.sequence]
            messages.append([message.NAME, bytes(message.payload).hex(), source])
    names = ("received", "signed", "unknown", "crc_errors", "dropped")
    return {"messages": messages, "counters": {name: getattr(link, name) for name in names}}


def refusals(request):
    """Tell for each value how set() refuses it, or that it does not, and whether the payload stayed as it was."""
    results = []
    for field, value in request["cases"]:
        payload = bytearray(b"\x55" * 64)
        before = bytes(payload)
        try:
            fields.write(payload, field, from_json(value))
            results.append([None, True])
        except ValueError:
            results.append(["ValueError", bytes(payload) == before])
    return results


def without_heap(request):
    """Send random payloads of every class with the heap locked from the first frame on; return the lengths."""
    import micropython  # noqa: PLC0415 - only MicroPython has it

    results = []
    for version in (1, 2):
        for description in request["classes"]:
            if version == 2 or description["ID"] <= 0xFF:
                link = mavlink.Link(Sink(), version=version)
                message = message_class(dict(description))()
                seen = bytearray(281)
                micropython.heap_lock()
                try:
                    send_random(link, message, seen, request["rounds"])
                finally:
                    micropython.heap_unlock()
                lengths = [length for length in range(len(seen)) if seen[length]]
                results.append([version, description["NAME"], lengths, link.sequence, link.tx_errors])
    return results


def send_random(link, message, seen, rounds):
    """Send `rounds` frames whose payloads end in ever other numbers of zeros; mark the lengths in `seen`."""
    payload = message.payload
    number = 1
    for turn in range(rounds):
        kept = turn % (len(payload) + 1)
        for index in range(len(payload)):
            number = (number * 75 + 74) % 65537
            payload[index] = number & 0xFF if index < kept else 0
        seen[len(link.encode(message))] = 1
        link.send(message)


OPERATIONS = {
    "checksums": checksums,
    "frames": frames,
    "decode": decode,
    "refusals": refusals,
    "without_heap": without_heap,
}

if __name__ == "__main__":
    asked = json.loads(sys.stdin.read())
    sys.stdout.write(json.dumps(OPERATIONS[asked["operation"]](asked)))
