"""Runs on MicroPython: sets what the cases say, and prints the frame of each, made in both ways that the firmware has.

`micropython driver.py plan.json values.bin`, with firmware and mocks on MICROPYPATH. A line has the frame in
hexadecimal digits, or `-` where the message is withheld, or both results where they differ.
"""

import json
import struct
import sys

import mock_time

mock_time.install()

import telemetry  # noqa: E402
from mavlink import Link  # noqa: E402  the clock has to be in place before the firmware looks at it
from state import SystemState  # noqa: E402

LEAVE, NONE, REAL, SIGNED, UNSIGNED, TEXT = 0, 1, 2, 3, 4, 5
values_of_list = []


class Wire:
    """A stream that keeps the last frame."""

    def write(self, data):
        self.frame = bytes(data)
        return len(data)


def read(data, at):
    """Return how a value is set, the value, and where the next one begins: a byte, and but for None what it says."""
    how = data[at]
    kind = how & 7
    if kind in (LEAVE, NONE):
        return how, None, at + 1
    if kind == TEXT:
        end = at + 3 + struct.unpack_from("<H", data, at + 1)[0]
        return how, data[at + 3 : end].decode(), end
    return how, struct.unpack_from({REAL: "<d", SIGNED: "<q", UNSIGNED: "<Q"}[kind], data, at + 1)[0], at + 9


def knows(owner, name):
    """Return whether a part of the state has an attribute, without reading it: some are made when they are used."""
    return hasattr(type(owner), name) or f" {name}:" in owner.VIEWS


def put(state, target, stored, value):
    """Set one of both attributes of a quantity, or the booleans of flags."""
    component, people, kept, flags, left = target
    owner = getattr(state, component)
    if flags:
        for name, number in flags:
            assert knows(owner, name), name
            setattr(owner, name, bool(value & number))
        return
    name = kept if stored else people
    assert knows(owner, name), name  # else a new attribute would be made of it, without a word
    if left:
        values_of_list.append(value)
        value = tuple(values_of_list)
        if left > 1:
            return
        values_of_list.clear()
    setattr(owner, name, value)


def frame_of(link, state, build, encode):
    """Return the frame of a message in both ways, told as one where they are equal; None where it is withheld."""
    link.sequence = 0
    straight = encode(link, state)
    first = None if straight is None else bytes(straight).hex()
    message, second = build(state), None
    if message is not None:
        link.sequence = 0
        link.send(message)
        second = link.stream.frame.hex()
    return first if first == second else f"{first} or {second}"


def main(plan, values):
    with open(plan) as file:
        tables = json.loads(file.read())
    with open(values, "rb") as file:
        data = file.read()
    state, link, at = SystemState(log=lambda *_words: None), Link(Wire(), 1, 1, 2), 0
    for table, targets, count in tables:
        build, encode = getattr(telemetry, "build_" + table), getattr(telemetry, "encode_" + table)
        for _ in range(count):
            before, after = struct.unpack_from("<II", data, at)
            at += 8
            mock_time.advance_us(before)
            for target in targets:
                how, value, at = read(data, at)
                if how:
                    put(state, target, how & 8, value)
            mock_time.advance_us(after)
            print(frame_of(link, state, build, encode) or "-")


main(sys.argv[1], sys.argv[2])
