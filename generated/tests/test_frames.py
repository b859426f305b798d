# Generated from specs/board.yaml, specs/codegen.yaml, specs/dialects/battery_v2.xml,
#   specs/dialects/corrections.yaml, specs/messages/battery_status.yaml,
#   specs/messages/heartbeat.yaml, specs/messages/sys_status.yaml, specs/parameters.yaml,
#   specs/state.yaml, specs/streams.yaml, dialect common: do not edit.
# Inputs: db0965e098fde33c
"""Every case's frames, byte for byte as pymavlink encodes the expected values, on both interpreters."""

import json

import pytest
from interpreters import CASES
from pymavlink.dialects.v10 import common as v10
from pymavlink.dialects.v20 import common as v20

DATA = json.loads(CASES.read_text())
DIALECTS = [v20, v10]


def named(cases):
    return [pytest.param(case, id=f"{case['name']}-{case['requirement']}") for case in cases]


def number(value):
    return float("nan") if value == "nan" else value


def encoded(dialect, case):
    """Return the frame of the expected values by pymavlink, or None where the dialect's version cannot send it."""
    message_class = getattr(dialect, f"MAVLink_{case['message'].lower()}_message", None)
    if message_class is None:
        return None
    values = {}
    for name in message_class.fieldnames:
        value = case["expect"][name]
        if isinstance(value, list):
            value = [number(item) for item in value]
        elif message_class.fieldtypes[message_class.fieldnames.index(name)] == "char":
            value = value.encode()
        else:
            value = number(value)
        values[name] = value
    sender = dialect.MAVLink(None, srcSystem=1, srcComponent=1)
    return message_class(**values).pack(sender).hex()


@pytest.mark.parametrize("case", named(DATA["messages"]))
def test_frames(case, results):
    """MAVLink 2 and MAVLink 1 frames equal pymavlink's."""
    assert results["frames"][case["name"]] == [encoded(dialect, case) for dialect in DIALECTS]


@pytest.mark.parametrize("case", named(DATA["conversions"]))
def test_conversion(case, results):
    """An ADC count becomes the number that the formula gives."""
    assert results["conversions"][case["name"]] == case["expect"]


def test_every_field_is_tested():
    """Each populated field has the value of at least one case, so that no field goes out unseen."""
    for case in DATA["messages"]:
        fields = getattr(v20, f"MAVLink_{case['message'].lower()}_message").fieldnames
        assert sorted(case["expect"]) == sorted(fields)
