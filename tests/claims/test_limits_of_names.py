"""Limits of what finds a name of a dialect behind a misspelled one, or a range in the words of a description."""

from types import SimpleNamespace
from typing import Any

import pytest

from codegen.claims.described_range import range_of
from codegen.claims.misspelled import is_spelled_so, numbered_message, shortened_message


@pytest.mark.parametrize(
    ("name", "known", "expected"),
    [
        ("pump_flow", "flow_pump", False),  # another first letter
        ("pump_of_flow", "pump_flow_of", True),
        ("pump_flow", "pump_flows", True),
        ("pump_flows", "pump_flow", True),
        ("pump_flow", "pump_flow2", False),  # a version
        ("pump_flw", "pump_flow", True),
        ("pump_fl", "pump_flow", False),  # two letters
        ("pump_fly", "pump_flow", False),
        ("pump", "pumps", False),  # of one word many are alike
    ],
)
def test_names_that_are_one_in_another_spelling(name: str, known: str, expected: bool) -> None:
    assert is_spelled_so(name, ["anchor", known]) is expected


MESSAGES: Any = {
    name: SimpleNamespace(id=number)
    for number, name in enumerate(("PUMP_FLOW_STATUS", "KEEL_DEPTH", "SAIL_OF_THE_MAST", "PUMP_OF_DECK"), 40)
}


@pytest.mark.parametrize(
    ("text", "below", "found"),
    [
        ("PUMP_STATE (40)", None, "PUMP_FLOW_STATUS"),
        ("PUMP_STATE (41)", None, None),  # nothing alike
        ("PUMP_STATE", None, None),
        ("PUMP_STATE", 40, "PUMP_FLOW_STATUS"),
        ("PUMP_STATE (40)", 43, None),  # two of them
        ("PUMP (40)", None, None),
        ("MY_DEPTH (41)", None, "KEEL_DEPTH"),  # half of its words
        ("MY_MAST (42)", None, None),  # a fourth
        ("PUMP_STATE (40 Hz)", None, None),
    ],
)
def test_a_name_beside_an_id(text: str, below: int | None, found: str | None) -> None:
    assert numbered_message(text, 0, len(text.partition(" ")[0]), MESSAGES, below) == found


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("PUMPFLOW_STATUS", "PUMP_FLOW_STATUS"),
        ("PUMPFLOWSTATUS", None),  # one word
        ("PUMP_STATUS", None),  # two words may be those of anything
        ("SAIL_THE_MAST", "SAIL_OF_THE_MAST"),
        ("SAIL_MAST_THE", None),
        ("SAIL_OF_THE", None),
        ("OF_THE_MAST", None),
        ("SAIL_BIG_MAST", None),
    ],
)
def test_a_name_without_words_of_its_middle(name: str, found: str | None) -> None:
    assert shortened_message(name, MESSAGES) == found


@pytest.mark.parametrize(
    ("minimum", "maximum", "description", "found"),
    [
        ("1", "5", "Share (0-100)", (1, 5)),
        ("1", None, "Share (0-100)", (0, 100)),
        (None, None, "Share [0, 100]", (0, 100)),
        (None, None, "Share (-1.5 to 1.5 of all)", (-1.5, 1.5)),
        (None, None, "Share 0..100 of all", (0, 100)),
        (None, None, "Share, 0: empty, 255: full", (0, 255)),
        (None, None, "Share (5-5)", None),
        (None, None, "Share (5-4)", None),
        (None, None, "Share (0-100) or (0-255)", None),
        (None, None, "Share", None),
    ],
)
def test_ranges_in_words(
    minimum: str | None, maximum: str | None, description: str, found: tuple[float, float] | None
) -> None:
    field: Any = SimpleNamespace(definition=SimpleNamespace(minimum=minimum, maximum=maximum, description=description))
    assert range_of(field) == found
