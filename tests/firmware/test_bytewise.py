"""Parameters bytewise: the bytes that pymavlink has of each type, and nothing else is taken for a number."""

import json
import math
import struct
from types import SimpleNamespace
from typing import Any

import pytest
from firmware_runs import FIRMWARE, MOCKS, PROGRAM, interpret
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common
from pymavlink.mavparm import MAVParmDict
from service_runs import Answer, Services, packed

UINT8, INT8, UINT16, INT16, UINT32, INT32, UINT64, INT64, REAL32, REAL64 = range(1, 11)
CODES = {UINT8: "B", INT8: "b", UINT16: "H", INT16: "h", UINT32: "I", INT32: "i"}
OUT_OF_RANGE = 2
KINDS = {"BATT_CAPACITY": INT32, "NAME_OF_SIXTEEN_": INT8, "SR0_EXTRA1": INT16}
DEFAULTS = {
    "BATT_CAPACITY": struct.pack("<i", 3300),
    "NAME_OF_SIXTEEN_": b"\xfb\0\0\0",
    "SR0_EXTRA1": b"\x02\0\0\0",
}
SCRIPT = """
import json, sys
from bytewise import number, put
for line in sys.stdin:
    kind, value = json.loads(line)
    wire = bytearray(b"\\xee" * 12)
    put(wire, 4, kind, value)
    print(json.dumps([list(wire), number(wire, 4, kind)]))
"""


def limits(kind: int) -> tuple[int, int]:
    """The smallest and the largest number of a type."""
    bits = 8 * struct.calcsize(CODES[kind])
    return (-(1 << bits - 1), (1 << bits - 1) - 1) if CODES[kind].islower() else (0, (1 << bits) - 1)


def by_pymavlink(kind: int, value: float) -> bytes:
    """The bytes of param_value with which pymavlink sets a parameter of a type."""
    sent: list[bytes] = []

    def keep(name: str, number: float, parm_type: int) -> None:
        sent.append(packed(common.MAVLink_param_set_message(1, 1, name.encode(), number, parm_type))[10:14])

    answers = SimpleNamespace(param_set_send=keep, recv_match=lambda **_: SimpleNamespace(param_id="ANY"))
    assert MAVParmDict().mavset(answers, "ANY", value, parm_type=kind)
    return sent[0]


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_bytes_of_each_type(interpreter: str, tmp_path: Any) -> None:
    """As pymavlink has them, zeros behind them, nothing else of the payload, and back again."""
    asked = [
        (kind, value) for kind in CODES for low, high in (limits(kind),) for value in (low, low + 1, 0, 1, 5, high)
    ]
    asked += [(INT32, -5), (INT32, 16777217), (INT32, -1), (UINT32, 0x7F800001), (UINT32, 0xFF800001), (INT32, 1 << 30)]
    asked += [(REAL32, 10.5), (REAL32, -0.25), (REAL32, 5)]
    names = [f"MAV_PARAM_TYPE_{name}" for name in ("UINT8", "INT8", "UINT16", "INT16", "UINT32", "INT32", "REAL32")]
    (tmp_path / "dialect.py").write_text("".join(f"{name} = {getattr(common, name)}\n" for name in names), "utf-8")
    (tmp_path / "script.py").write_text(SCRIPT, "utf-8")
    lines = "".join(f"{json.dumps(each)}\n" for each in asked)
    folders = (tmp_path, PROGRAM, FIRMWARE, MOCKS)
    printed = interpret(interpreter, str(tmp_path / "script.py"), lines, folders).splitlines()
    for (kind, value), line in zip(asked, printed, strict=True):
        wire, back = json.loads(line)
        assert wire[:4] + wire[8:] == [0xEE] * 8, (kind, value)
        assert back == value, (kind, value)
        found = bytes(wire[4:8])
        assert found == struct.pack("<f" if kind == REAL32 else f"<{CODES[kind]}", value).ljust(4, b"\0"), (kind, value)
        if not math.isnan(struct.unpack("<f", found)[0]):  # pymavlink makes a float of it, which loses bits of a NaN
            assert found == by_pymavlink(kind, value), (kind, value)


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_beyond_the_type_is_the_nearest_number(interpreter: str, tmp_path: Any) -> None:
    """Code may set an attribute of a parameter to anything: no byte is cut off, so that 300 is never told as 44."""
    asked: list[tuple[int, float, int]] = []
    for kind in CODES:
        low, high = limits(kind)
        above = [high + 1, 2 * high + 45, high + 0.5, 1e30, math.inf]
        asked += [(kind, value, high) for value in above]
        asked += [(kind, value, low) for value in (low - 1, 2 * low - 45, low - 0.25, -1e30, -math.inf)]
        asked += [(kind, 2.75, 3), (kind, high - 1, high - 1)]
    names = [f"MAV_PARAM_TYPE_{name}" for name in ("UINT8", "INT8", "UINT16", "INT16", "UINT32", "INT32", "REAL32")]
    (tmp_path / "dialect.py").write_text("".join(f"{name} = {getattr(common, name)}\n" for name in names), "utf-8")
    told = [(kind, "inf" if value == math.inf else "-inf" if value == -math.inf else value) for kind, value, _ in asked]
    script = SCRIPT.replace(
        "json.loads(line)\n", "json.loads(line)\n    value = float(value) if value in ('inf', '-inf') else value\n"
    )
    (tmp_path / "script.py").write_text(script, "utf-8")
    lines = "".join(f"{json.dumps(each)}\n" for each in told)
    printed = interpret(interpreter, str(tmp_path / "script.py"), lines, (tmp_path, PROGRAM, FIRMWARE, MOCKS))
    for (kind, value, expected), line in zip(asked, printed.splitlines(), strict=True):
        assert json.loads(line)[1] == expected, (kind, value)


def write(name: bytes, kind: int, data: bytes) -> bytes:
    """The frame of a PARAM_SET with four bytes for param_value."""
    message = common.MAVLink_param_set_message(1, 1, name, 0.0, kind)
    payload = data + struct.pack("<BB16sB", 1, 1, name, kind)
    return bytes(message._pack(common.MAVLink(None, srcSystem=255, srcComponent=190), message.crc_extra, payload))


def told(answer: Answer) -> list[tuple[str, int, bytes, int]]:
    """Name, type, bytes and index of each PARAM_VALUE."""
    found = answer.of("PARAM_VALUE")
    return [(each.param_id, each.param_type, bytes(each.get_msgbuf())[10:14], each.param_index) for each in found]


def texts(answer: Answer) -> list[str]:
    """The texts."""
    return [each.text for each in answer.of("STATUSTEXT")]


def test_list(bytewise_services: Services) -> None:
    """Each as its type: floats as they were, and -5 as one byte with zeros behind it."""
    answer = bytewise_services.ask(common.MAVLink_param_request_list_message(1, 1))
    assert told(answer) == [
        ("BATT_CAPACITY", INT32, struct.pack("<i", 3300), 0),
        ("BATT_LOW_VOLT", REAL32, struct.pack("<f", 10.5), 1),
        ("BATT_VOLT_MULT", REAL32, struct.pack("<f", 3.95), 2),
        ("NAME_OF_SIXTEEN_", INT8, b"\xfb\0\0\0", 3),
        ("SR0_EXTRA1", INT16, b"\x02\0\0\0", 4),
    ]


@pytest.mark.parametrize(
    ("name", "kind", "value"),
    [
        ("BATT_CAPACITY", INT32, 5),
        ("BATT_CAPACITY", INT32, 100000),
        ("NAME_OF_SIXTEEN_", INT8, -1),
        ("NAME_OF_SIXTEEN_", INT8, -128),
        ("SR0_EXTRA1", INT16, 50),
        ("BATT_LOW_VOLT", REAL32, 11.5),
    ],
)
def test_set_by_pymavlink(bytewise_services: Services, name: str, kind: int, value: float) -> None:
    """The answer has the bytes that were sent."""
    data = by_pymavlink(kind, value)
    answer = bytewise_services.run(("in", write(name.encode(), kind, data)))
    assert told(answer) == [(name, kind, data, 65535)]
    assert (texts(answer), answer.of("PARAM_ERROR")) == ([], [])


@pytest.mark.parametrize(
    ("name", "kind", "value", "said"),
    [
        ("BATT_CAPACITY", INT32, -1, "BATT_CAPACITY: -1 is not 0 to 100000"),  # the bits of a NaN
        ("BATT_CAPACITY", INT32, 100001, "BATT_CAPACITY: 100001 is not 0 to 100000"),
        ("SR0_EXTRA1", INT16, -1, "SR0_EXTRA1: -1 is not 0 to 50"),
    ],
)
def test_beyond_the_limits(bytewise_services: Services, name: str, kind: int, value: int, said: str) -> None:
    """Refused with the number that was meant, and nothing changes."""
    data = struct.pack(f"<{CODES[kind]}", value).ljust(4, b"\0")
    answer = bytewise_services.run(("in", write(name.encode(), kind, data)))
    assert [each.error for each in answer.of("PARAM_ERROR")] == [OUT_OF_RANGE]
    assert texts(answer) == [said]
    assert told(answer) == [(name, kind, DEFAULTS[name], 65535)]


@pytest.mark.parametrize("name", ["NAME_OF_SIXTEEN_", "SR0_EXTRA1", "BATT_CAPACITY"])
@pytest.mark.parametrize("value", [5.0, 1.0, -1.0, 100.0])
def test_who_casts_is_refused(bytewise_services: Services, name: str, value: float) -> None:
    """A number as a float, with the type that the parameter has or that of a float, is not taken for another number."""
    kind = KINDS[name]
    for stated in (kind, REAL32):
        answer = bytewise_services.run(("in", write(name.encode(), stated, struct.pack("<f", value))))
        assert [each.error for each in answer.of("PARAM_ERROR")] == [OUT_OF_RANGE]
        assert told(answer) == [(name, kind, DEFAULTS[name], 65535)]
        if name != "BATT_CAPACITY" or stated == REAL32:  # all four bytes are the number there
            assert texts(answer) == [f"{name} is not sent as bytes of type {kind}"]


@pytest.mark.parametrize("kind", [0, UINT8, INT8, UINT16, INT16, UINT32, UINT64, INT64, REAL64, 11, 255])
def test_another_type_is_refused(bytewise_services: Services, kind: int) -> None:
    """The bytes would be another number."""
    for name, own in (("BATT_CAPACITY", INT32), ("BATT_LOW_VOLT", REAL32)):
        answer = bytewise_services.run(("in", write(name.encode(), kind, struct.pack("<i", 5))))
        assert texts(answer) == [f"{name} is not sent as bytes of type {own}"]
        assert [each.error for each in answer.of("PARAM_ERROR")] == [OUT_OF_RANGE]


@settings(max_examples=80)
@given(
    name=st.sampled_from(["BATT_CAPACITY", "BATT_LOW_VOLT", "NAME_OF_SIXTEEN_", "SR0_EXTRA1"]),
    data=st.binary(min_size=4, max_size=4),
    kind=st.integers(0, 255) | st.sampled_from([INT32, INT8, INT16, REAL32]),
)
def test_anything_set(bytewise_services: Services, name: str, data: bytes, kind: int) -> None:
    """Any bytes: no fault, and what is told afterwards is what was sent, or the default."""
    answer = bytewise_services.run(("in", write(name.encode(), kind, data)))
    assert answer.state["faults"] == 0
    refused = bool(answer.of("PARAM_ERROR"))
    ((_, _, in_force, _),) = told(answer)
    if name != "BATT_LOW_VOLT":
        assert in_force == (DEFAULTS[name] if refused else data)
