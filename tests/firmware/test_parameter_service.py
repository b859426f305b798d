"""Parameters over the link: lists, single values, sets with what is in force as the answer, refusals with reasons."""

import math
import struct
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v10 import common as common_1
from pymavlink.dialects.v20 import common
from service_runs import GROUND, Answer, Services, fields, packed

NAMES = ["BATT_CAPACITY", "BATT_LOW_VOLT", "BATT_VOLT_MULT", "NAME_OF_SIXTEEN_", "SR0_EXTRA1"]
TYPES = [6, 9, 9, 2, 4]
DEFAULTS = [3300.0, 10.5, pytest.approx(3.95), -5.0, 2.0]
NOT_IN_LIST = 65535
DOES_NOT_EXIST, OUT_OF_RANGE = 1, 2


def values(answer: Answer) -> list[tuple[Any, ...]]:
    """(name, value, type, index) of each PARAM_VALUE."""
    found = answer.of("PARAM_VALUE")
    assert all(message.param_count == len(NAMES) for message in found)
    return [fields(message, "param_id", "param_value", "param_type", "param_index") for message in found]


def errors(answer: Answer) -> list[tuple[Any, ...]]:
    """(name, index, error) of each PARAM_ERROR."""
    found = answer.of("PARAM_ERROR")
    assert all(fields(message, "target_system", "target_component") == GROUND for message in found)
    return [fields(message, "param_id", "param_index", "error") for message in found]


def texts(answer: Answer) -> list[tuple[int, str]]:
    """(severity, text) of each STATUSTEXT."""
    return [fields(message, "severity", "text") for message in answer.of("STATUSTEXT")]


def read(name: bytes = b"", index: int = -1) -> Any:
    """A PARAM_REQUEST_READ."""
    return common.MAVLink_param_request_read_message(1, 1, name, index)


def write(name: bytes, value: float, kind: int = 9) -> Any:
    """A PARAM_SET."""
    return common.MAVLink_param_set_message(1, 1, name, value, kind)


REQUEST_LIST = common.MAVLink_param_request_list_message(1, 1)
WHOLE_LIST = list(zip(NAMES, DEFAULTS, TYPES, range(5), strict=True))


def test_list(services: Services) -> None:
    """All values once, in order, with their types; names of 16 characters are whole."""
    answer = services.ask(REQUEST_LIST)
    assert values(answer) == WHOLE_LIST
    assert answer.state["faults"] == 0


def test_second_request_restarts_the_list(services: Services) -> None:
    """A ground station that asks again has begun anew."""
    answer = services.run(*two_requests())
    indexes = [message.param_index for message in answer.of("PARAM_VALUE")]
    assert indexes == [0, 1, 0, 1, 2, 3, 4]


def two_requests() -> list[tuple[str, Any]]:
    """The second one after two values."""
    frame = packed(REQUEST_LIST)
    return [("arrive", frame), ("passes", 2), ("arrive", frame), ("passes", 8)]


def test_list_waits_for_the_port(services: Services) -> None:
    """A port with room for one frame in several passes gets every value once, and no sequence number is left out."""
    steps = [("port", {"room": 40, "left": 0}), ("in", packed(REQUEST_LIST))]
    answer = services.run(*steps, ("port", {"room": 20}), ("passes", 5), ("port", {"room": 40}), ("passes", 9))
    assert values(answer) == WHOLE_LIST
    sequence = [message.get_seq() for message in answer.all]
    assert sequence == list(range(sequence[0], sequence[0] + len(sequence)))


def test_read_by_name_and_by_index(services: Services) -> None:
    """The index decides unless it is -1; both answer with the index."""
    asked = [read(b"BATT_LOW_VOLT"), read(b"NAME_OF_SIXTEEN_"), read(b"SR0_EXTRA1", 0), read(b"", 4)]
    assert values(services.ask(*asked)) == [WHOLE_LIST[index] for index in (1, 3, 0, 4)]


@pytest.mark.parametrize(
    "name", [b"", b"BATT_LOW_VOL", b"BATT_LOW_VOLTS", b"batt_low_volt", b"\xff\xfe\x80", b"\x80" * 16]
)
def test_unknown_names(services: Services, name: bytes) -> None:
    """They get a PARAM_ERROR, and no text that could not be read."""
    answer = services.run(*[("in", raw) for raw in (packed(read(name)), packed(write(name, 5.0)))])
    assert [error[1:] for error in errors(answer)] == [(-1, DOES_NOT_EXIST)] * 2
    returned = [name_on_wire(message) for message in answer.of("PARAM_ERROR")]
    assert returned == [name] * 2
    assert values(answer) == []
    assert answer.state["faults"] == 0
    readable = name.decode() if name.isascii() and name else ""
    expected = f"{readable} is no parameter" if readable else "a parameter of this name does not exist"
    assert texts(answer) == [(5, expected)]


def name_on_wire(message: Any) -> bytes:
    """The 16 characters behind a header of 10 bytes, an index and a target."""
    return bytes(message.get_msgbuf())[14:30].rstrip(b"\0")


@pytest.mark.parametrize("index", [5, 32767, -2, -32768])
def test_unknown_indexes(services: Services, index: int) -> None:
    """An index outside the list is refused by its number."""
    answer = services.ask(read(b"", index))
    assert errors(answer) == [("", index, DOES_NOT_EXIST)]
    assert values(answer) == []


def test_set_answers_with_what_is_in_force(services: Services) -> None:
    """Rounded to its step, with the index of an answer to PARAM_SET; read back it is the same."""
    answer = services.ask(write(b"BATT_LOW_VOLT", 11.1234), read(b"BATT_LOW_VOLT"), write(b"SR0_EXTRA1", 5.0, 4))
    assert values(answer) == [
        ("BATT_LOW_VOLT", pytest.approx(11.12), 9, NOT_IN_LIST),
        ("BATT_LOW_VOLT", pytest.approx(11.12), 9, 1),
        ("SR0_EXTRA1", 5.0, 4, NOT_IN_LIST),
    ]
    assert (texts(answer), errors(answer)) == ([], [])


@pytest.mark.parametrize(
    ("value", "said"), [(99.0, "99"), (-0.5, "-0.5"), (math.nan, "nan"), (math.inf, "inf"), (-math.inf, "-inf")]
)
def test_refused_values(services: Services, value: float, said: str) -> None:
    """Nothing changes; the reason comes before the value that stays in force."""
    answer = services.ask(write(b"BATT_LOW_VOLT", value))
    assert values(answer) == [("BATT_LOW_VOLT", 10.5, 9, NOT_IN_LIST)]
    assert errors(answer) == [("BATT_LOW_VOLT", -1, OUT_OF_RANGE)]
    assert texts(answer) == [(5, f"BATT_LOW_VOLT: {said} is not 0 to 60")]
    names = [message.get_type() for message in answer.of("PARAM_VALUE", "PARAM_ERROR")]
    assert names == ["PARAM_ERROR", "PARAM_VALUE"]


def test_restart_is_mentioned_when_something_changes(services: Services) -> None:
    """The same value again changes nothing."""
    answer = services.ask(write(b"BATT_VOLT_MULT", 4.0), write(b"BATT_VOLT_MULT", 4.0))
    assert texts(answer) == [(5, "BATT_VOLT_MULT counts from the next start")]
    assert [value for _, value, _, _ in values(answer)] == [4.0, 4.0]


def test_mavlink_1_has_no_parameter_error(services: Services) -> None:
    """Its id does not fit: the value and the text have to do."""
    side = common_1.MAVLink(None, *GROUND)
    frame = bytes(common_1.MAVLink_param_set_message(1, 1, b"BATT_LOW_VOLT", 99.0, 9).pack(side))
    unknown = bytes(common_1.MAVLink_param_request_read_message(1, 1, b"NONE", -1).pack(side))
    answer = services.run(("in", frame), ("in", unknown), versions=(1,))
    assert values(answer) == [("BATT_LOW_VOLT", 10.5, 9, NOT_IN_LIST)]
    assert errors(answer) == []
    assert answer.state["faults"] == 0


def test_other_connections_hear_of_a_change(services: Services) -> None:
    """Another ground station would show the old value; a set that changes nothing is no news for it."""
    frames = [packed(write(b"SR0_EXTRA1", value)) for value in (7.0, 7.0, 99.0)]
    answer = services.run(*[("in", frame) for frame in frames], versions=(2, 2))
    heard = [message for step in answer.replies for message in step[1] if message.get_type() == "PARAM_VALUE"]
    assert [fields(message, "param_value", "param_index") for message in heard] == [(7.0, NOT_IN_LIST)]


def test_answer_to_a_set_waits_for_the_port(services: Services) -> None:
    """A full port delays the answer; it then carries what is in force at that time."""
    full = ("port", {"room": 10, "left": 0})
    answer = services.run(full, ("in", packed(write(b"SR0_EXTRA1", 7.0))), ("in", packed(write(b"SR0_EXTRA1", 8.0))))
    assert values(answer) == []
    answer = services.run(
        full,
        ("in", packed(write(b"SR0_EXTRA1", 7.0))),
        ("in", packed(write(b"SR0_EXTRA1", 8.0))),
        ("port", {"room": None}),
        ("passes", 1),
    )
    assert [value for _, value, _, _ in values(answer)] == [8.0, 8.0]


@settings(max_examples=80)
@given(
    name=st.sampled_from([name.encode() for name in NAMES]) | st.binary(max_size=16),
    bits=st.integers(0, 2**32 - 1),
    kind=st.integers(0, 255),
    index=st.integers(-(2**15), 2**15 - 1),
)
def test_anything_set_or_read(services: Services, name: bytes, bits: int, kind: int, index: int) -> None:
    """Any name, any bits as a value: no fault, and what is in force stays a number within the limits."""
    (value,) = struct.unpack("<f", struct.pack("<I", bits))
    answer = services.ask(write(name, value, kind), read(name, index), REQUEST_LIST)
    assert answer.state["faults"] == 0
    in_force = {found: value for found, value, _, _ in values(answer)}
    assert sorted(in_force) == NAMES
    assert all(math.isfinite(value) for value in in_force.values())
    assert 0 <= in_force["BATT_LOW_VOLT"] <= 60
