"""Runs on either interpreter: doubles that are set and read, as whole numbers, floats and fractions.

It reads a JSON list of `[numerator, denominator]` as texts, and prints for each of them the double as hexadecimal
digits after set_ratio(), and after update() where it is a whole number, what ratio() says of it, and what get() does.
"""

import json
import struct
import sys

import doubles
import messages


def outcome(function, *arguments):
    """Return what a function returns, or the text of the error."""
    try:
        return function(*arguments)
    except (KeyError, ValueError) as error:
        return str(error.args[0])


def told(numerator, denominator):
    """Return what becomes of a fraction."""
    message = messages.WheelDistance()
    refused = outcome(doubles.set_ratio, message, "distance", numerator, denominator, 15)
    if refused is not None:
        return [refused]
    whole = messages.WheelDistance()
    if denominator == 1:
        whole.update(distance=[numerator, 0.0] * 8)
    found = [str(part) for part in doubles.ratio(message, "distance", 15)]
    value = message.distance[15]
    return [
        bytes(message.wire[128:136]).hex(),
        bytes(whole.wire[120:128]).hex(),
        found,
        type(value).__name__,
        str(value),
    ]


def errors():
    """Return what is refused, in words."""
    message = messages.WheelDistance()
    message.distance = [float("inf"), float("-inf"), float("nan")] + [-0.0] * 13
    cases = [("distance", element) for element in (0, 1, 2, 3, 16, -1)] + [("count", 0), ("distanc", 0)]
    read = [outcome(doubles.ratio, message, name, element) for name, element in cases]
    before = bytes(message.wire)
    cases = [(2**1024, 1), (1, 0), (10**400, 1)]
    written = [outcome(doubles.set_ratio, message, "distance", *case) for case in cases]
    written += [outcome(message.set, "distance", [number] + [0.0] * 15) for number in (2**1024, -(10**400))]
    assert bytes(message.wire) == before
    return [[str(one) for one in read], [one[:60] for one in written]]


has_single_floats = doubles.unpack_from is not struct.unpack_from
cases = [[int(part) for part in case] for case in json.loads(sys.stdin.read())]
sys.stdout.write(json.dumps([[told(*case) for case in cases], errors(), has_single_floats]))
