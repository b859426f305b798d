"""Messages and numbers of the firmware are pymavlink's: those that are received and answered, too.

What is sent is held to pymavlink frame by frame; a message that is only received would be read by the numbers with
which the tests make it, were they wrong.
"""

import inspect
import json
import re
import struct
from functools import cache

import pytest
from interpreters import CASES, HERE, files
from oracle import message_class, shipped, shipped_names
from pymavlink.generator.mavcrc import x25crc

ABOUT = json.loads(CASES.read_text(encoding="utf-8"))["dialect"]
CONSTANT = re.compile(r"^_*(\w+) = (?:const\()?(\d\w*)\)?(?:  #.*)?$", re.MULTILINE)


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def laid_out(request, printed):
    """Return the firmware's layout of each message, by name, and of those without a name; see dialect_run.py."""
    found = printed(request.param, "dialect_run.py")
    assert "" not in found, found[""]
    return found


def fields_of(known):
    """Return the fields of a message of pymavlink in wire order, each with its name, its form for struct, its place."""
    places, found = 0, []
    forms = struct_forms(known)
    for name, form in zip(known.ordered_fieldnames, forms, strict=True):
        found.append([name, form, places])
        places += struct.calcsize("<" + form)
    return found


def addresses(fields, name):
    """Return where a message has the system and the component that it is for, which take a byte each."""
    names = ("target", "target_component") if name == "MANUAL_CONTROL" else ("target_system", "target_component")
    return [place for target in names for field, form, place in fields if field == target and form == "B"]


def struct_forms(known):
    """Return struct's form of each field in wire order, such as "I", "10H", and "16s"; a character is text, too."""
    text = known.unpacker.format.lstrip("<").replace("c", "s")
    forms, count = [], ""
    for character in text:
        count += character
        if not character.isdigit():
            forms.append(count)
            count = ""
    return forms


def crc_extra(known, length, message=None):
    """Return the CRC_EXTRA of a message whose fields without the extensions take `length` bytes, by MAVLink's rule.

    pymavlink tells the names of messages in capitals: where `message` is not, that is the one of the dialect.
    """
    kinds = dict(zip(known.fieldnames, known.fieldtypes, strict=True))
    counts = dict(zip(known.ordered_fieldnames, known.array_lengths, strict=True))
    crc = x25crc()
    crc.accumulate_str((message or known.msgname) + " ")
    for name, _form, place in fields_of(known):
        if place < length:
            crc.accumulate_str(f"{kinds[name]} {name} ")
            crc.accumulate([counts[name]] if counts[name] else [])
    return (crc.crc & 0xFF) ^ (crc.crc >> 8)


def test_messages(laid_out, modules):
    """Id, CRC_EXTRA, lengths, fields and targets of every message are those of the dialect."""
    for name, (number, extra, base, length, targets, first, fields) in laid_out["named"].items():
        known = message_class(modules[0], name)
        assert known, f"pymavlink has no {name}"
        assert [number, extra, length] == [known.id, known.crc_extra, known.unpacker.size], name
        assert fields == fields_of(known), name
        assert base in (*(place for _name, _form, place in fields), length), name  # an extension begins there
        assert crc_extra(known, base, name) == extra, (name, "bytes without extension fields")
        assert targets == addresses(fields, name), name
        encode = getattr(modules[0].MAVLink, known.msgname.lower() + "_encode")
        defaults = {key: each.default for key, each in inspect.signature(encode).parameters.items()}
        assert first == {key: defaults[key] for key in first}, name


def test_bare_messages(laid_out, modules):
    """So are those of messages that the firmware knows by their ids alone."""
    for number, extra, base, length, targets in laid_out["bare"]:
        known = modules[0].mavlink_map.get(number)
        assert known, f"pymavlink has no {number}"
        fields = fields_of(known)
        assert [extra, length] == [known.crc_extra, known.unpacker.size], known.msgname
        assert base in (*(place for _name, _form, place in fields), length), known.msgname
        assert crc_extra(known, base) == extra, known.msgname
        assert targets == addresses(fields, known.msgname)


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def carried(request, printed):
    """Return what the firmware makes of values of each message, by name; see fields_run.py."""
    found = printed(request.param, "fields_run.py")
    assert "" not in found, found[""]
    return found


def packed(known, given):
    """Return the payload of values by name, as struct packs it; what has none is 0."""
    payload = b""
    for name, form, _place in fields_of(known):
        value = given.get(name, 0)
        if form.endswith("s"):
            value = value.encode() if value else b""
        elif form[:-1]:
            payload += struct.pack("<" + form, *(value or [0] * int(form[:-1])))
            continue
        payload += struct.pack("<" + form, value)
    return payload


def test_fields(carried, modules):
    """Values of every field, from the smallest to the largest, stand in the payload where the dialect has them.

    What a frame has of live fields is received by them, and read and set by name: all at once, and those of each size.
    """
    for name, (found, frames, *_others) in carried.items():
        known = message_class(modules[0], name)
        for given, payload, read in found:
            assert bytes.fromhex(payload) == packed(known, given), (name, given)
            assert read == given, name
        for given, sent, received in frames:
            frame = bytes.fromhex(sent)
            crc = x25crc(frame[1:-2])
            crc.accumulate([known.crc_extra])
            assert frame[-2:] == struct.pack("<H", crc.crc), (name, given)
            assert frame[10:-2] == (packed(known, given).rstrip(b"\0") or b"\0"), (name, given)
            assert all(received), (name, given, received)


def test_unknown_fields(carried):
    """A field that can be unknown is so at first and when it is set to None; a value set in between is told.

    So are some elements of an array that are known, beside others that are not.
    """
    for name, (_found, _frames, unknown, *_others) in carried.items():
        for field, first, given, told, mixed, mixed_told, last in unknown:
            assert is_without_number(first), (name, field, first)
            assert (told, mixed_told) == (given, mixed), (name, field)
            assert is_without_number(last), (name, field, last)


def is_without_number(value):
    """Return whether a value is unknown: as a whole, or in each element that can be (the others are 0)."""
    return value is None or (isinstance(value, list) and None in value and not any(value))


def test_misspelt_fields(carried):
    """A wrong name of a field is told, with the right one where at most a quarter of its letters is wrong."""
    assert any(misspelt for *_others, misspelt, _named in carried.values())
    for name, (found, _frames, _unknown, misspelt, _named) in carried.items():
        fields = found[0][0]
        for wrong, told in misspelt:
            letters, nearest = min((distance(wrong, field), field) for field in fields)
            hint = f"; did you mean {nearest}?" if letters <= max(1, len(wrong) // 4) else ""
            assert told == f"{name} has no field {wrong}{hint}", (name, wrong)


def test_fields_as_attributes(carried):
    """A field is an attribute, too, and nothing else can be set as one."""
    assert {name: named for name, (*_others, named) in carried.items() if named} == {}


@cache
def distance(one, other):
    """Return how many letters one name has to be changed in, put in or left out, to be the other one."""
    if not one or not other:
        return len(one) + len(other)
    changed = distance(one[1:], other[1:]) + (one[0] != other[0])
    return min(changed, distance(one[1:], other) + 1, distance(one, other[1:]) + 1)


def constants():
    """Return file, name and number of each constant of the firmware: `NAME = 5`, or with const()."""
    for path in files("firmware/*.py"):
        for name, number in CONSTANT.findall(path.read_text(encoding="utf-8")):
            yield path.name, name, int(number, 0)


def numbers_of(modules):
    """Return the numbers of the dialect by name: entries of its enums, and the places of fields as PING_SEQ_AT."""
    numbers = {
        entry.name: value
        # The last one has no enums of shipped files.
        for module in (*(shipped("v20", name) for name in shipped_names(ABOUT, HERE)), modules[0])
        for entries in module.enums.values()
        for value, entry in entries.items()
    }
    changed = {each["entry"]: int(each["set"]["value"], 0) for each in ABOUT.get("corrections", ()) if "entry" in each}
    for known in modules[0].mavlink_map.values():
        for field, _form, place in fields_of(known):
            numbers[f"{known.msgname}_{field}_AT".upper()] = place
    return {**numbers, **changed}


def test_numbers(modules):
    """A constant with the name of an entry or of a field's place has the dialect's number; dialect.py has no other."""
    numbers = numbers_of(modules)
    found = list(constants())
    assert [each for each in found if each[2] != numbers.get(each[1], each[2])] == []
    assert [name for file, name, _value in found if file == "dialect.py" and name not in numbers] == []
