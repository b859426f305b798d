# Generated from specs/codegen.yaml, specs/dialects/battery_cell_voltages_rfc_0018.xml,
#   specs/dialects/battery_info_upstream.xml, specs/dialects/battery_upstream.xml,
#   specs/dialects/corrections_rfc_0018.yaml, specs/dialects/protocol_version.xml,
#   specs/dialects/upstream.xml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_cell_faults_rfc_0018.yaml,
#   specs/messages/battery_cell_voltages.yaml, specs/messages/battery_status.yaml,
#   specs/messages/battery_status_v2.yaml, specs/messages/battery_status_v2_rfc_0018.yaml,
#   specs/messages/protocol_version.yaml, specs/smart_battery/board.yaml,
#   specs/smart_battery/codegen.yaml, specs/smart_battery/messages/battery_info.yaml,
#   specs/smart_battery/messages/heartbeat.yaml,
#   specs/smart_battery/messages/smart_battery_info.yaml,
#   specs/smart_battery/parameters.yaml, specs/smart_battery/state.yaml,
#   specs/smart_battery/streams.yaml, specs/smart_battery/vehicle.yaml, dialect common: do not edit.
# Inputs: 8e4825f7db72c0dc
"""Every case's frames, byte for byte as pymavlink encodes the expected values, on both interpreters."""

import json
import math

import pytest
from interpreters import CASES
from oracle import message_class
from units import one, zero

DATA = json.loads(CASES.read_text(encoding="utf-8"))
SENDER = {"srcSystem": 1, "srcComponent": 180}


def named(cases):
    """Return the cases for pytest, each with its name and the criteria that it shows."""
    return [
        pytest.param(
            case,
            id=f"{case['name']}-{case['requirement']}",
            marks=pytest.mark.requirement(*filter(None, [case["requirement"], *case.get("also", [])])),
        )
        for case in cases
    ]


def plain(value, kind):
    """Return a value as pymavlink takes it: JSON has no NaN and no bytes."""
    if isinstance(value, list):
        return [plain(item, kind) for item in value]
    if kind == "char":
        return value.encode()
    return float("nan") if value == "nan" else value


def encoded(dialect, case):
    """Return the frame of the expected values by pymavlink, or None: it is withheld, or this version cannot send it."""
    if not case["expect"]:
        return None
    known = message_class(dialect, case["message"])
    if known is None or (dialect.WIRE_PROTOCOL_VERSION == "1.0" and known.id > 255):
        return None
    kinds = dict(zip(known.fieldnames, known.fieldtypes, strict=True))
    values = {name: plain(case["expect"][name], kind) for name, kind in kinds.items()}
    return known(**values).pack(dialect.MAVLink(None, **SENDER)).hex()


@pytest.mark.parametrize("case", named(DATA["messages"]))
def test_frames(case, results, modules):
    """MAVLink 2 and MAVLink 1 frames equal pymavlink's."""
    assert results["frames"][case["name"]] == [encoded(module, case) for module in modules]


@pytest.mark.parametrize("case", named(DATA["conversions"]))
def test_conversion(case, results):
    """An ADC count becomes the number that the formula gives."""
    assert results["conversions"][case["name"]] == case["expect"]


def test_values_arrive_in_units(results, modules):
    """pymavlink decodes the value that was set, in the units of both, to a step of the field or of the stored value."""
    parser = modules[0].MAVLink(None)
    frames = [(case, results["frames"][case["name"]][0]) for case in DATA["messages"]]
    arrived = [(case, parser.parse_buffer(bytearray.fromhex(frame))[0]) for case, frame in frames if frame]
    for source in DATA["sources"]:
        compared = 0
        for case, decoded in arrived:
            value = value_set(case, source) if case.get("table", case["message"]) == source["table"] else None
            if value is None:
                continue
            wire = getattr(decoded, source["field"])
            wire = wire[source["element"]] if "element" in source else wire
            stated = type(decoded).fieldunits_by_name.get(source["field"], "")
            units = source["unit"], source.get("corrected", stated)
            sizes = [one(unit) for unit in units]
            assert None not in sizes, (source, units)
            if wire == source["unknown"] or math.isnan(wire):
                continue
            step = sizes[0] / sizes[1]
            low, high = source["ends"]
            exact = min(max(value * step + (zero(units[0]) - zero(units[1])) / sizes[1], low), high)
            apart = abs(wire - exact) - abs(exact) * (1e-9 if source["is_whole"] else 2.0**-23)
            bound = 1 if source["is_whole"] else step * 1.000001
            if source["is_whole"] and source["unknown"] is not None and abs(exact - source["unknown"]) < 1:
                bound += abs(wire - source["unknown"]) == 1  # it would be told as unknown, and is a step beside it
            assert apart <= bound, (case["name"], source["field"], wire, exact)
            compared += 1
        assert compared, source


def value_set(case, source):
    """Return the number that a case sets a source to, or None."""
    found = None
    for component, attribute, value, *instance in case["set"]:
        named = component, attribute, (instance or [0])[0]
        if named == (source["component"], source["attribute"], case["instance"]):
            found = value
    return None if found is None or isinstance(found, (str, bool)) else found


@pytest.mark.parametrize("message", sorted({case["message"] for case in DATA["messages"]}))
def test_every_field_is_expected(message, modules):
    """A case has a value for each field of its message, so that none goes out unseen, or the message is withheld."""
    fields = sorted(message_class(modules[0], message).fieldnames)
    expected = [case for case in DATA["messages"] if case["message"] == message and case["expect"]]
    assert [case["name"] for case in expected if sorted(case["expect"]) != fields] == []
