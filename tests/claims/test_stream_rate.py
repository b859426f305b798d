"""Rates in a project's own documents, as requirements state them: compared with what a message is sent at first."""

from dataclasses import replace
from fractions import Fraction

import pytest

from codegen.claims.own.stream_rate import check
from codegen.claims.reading import Reading, read_document

RATES = {"HEARTBEAT": (Fraction(1),), "BATTERY_STATUS": (Fraction(2), Fraction(1, 2))}


def told(text: str, reading: Reading) -> list[str]:
    """Return what is said of a text in a project that sends two messages."""
    reference = replace(reading.reference, rates=RATES)
    return [each.message for each in check(read_document(text, "/documents/notes.md", reference))]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("HEARTBEAT shall be sent at 3 Hz.", "not 3 Hz"),
        ("HEARTBEAT must be transmitted at a rate of 2 Hz.", "not 2 Hz"),
        ("HEARTBEAT is sent periodically over the telemetry link with a fixed rate of 5 Hz.", "not 5 Hz"),
        ("BATTERY_STATUS carries the current and `voltages` at 3 Hz.", "not 3 Hz"),
        ("HEARTBEAT carries the mode each 2 s.", "not 0.5 Hz"),
        ("HEARTBEAT goes out each 200 ms.", "not 5 Hz"),
        ("The vehicle sends HEARTBEAT every 500 ms.", "not 2 Hz"),
        ("HEARTBEAT shall be sent at least twice per second.", "less than 2 Hz"),
        ("HEARTBEAT is to be sent every ten seconds.", "not 0.1 Hz"),
    ],
)
def test_a_rate_that_is_not_that_of_the_stream_is_told(read, text: str, said: str) -> None:
    (message,) = told(text, read(""))
    assert said in message


@pytest.mark.parametrize(
    "text",
    [
        "HEARTBEAT shall be sent once per second.",
        "HEARTBEAT shall be sent at least every 2 s.",
        "BATTERY_STATUS carries the current at 2 Hz, and at 0.5 Hz with the other parameter.",
        "HEARTBEAT is answered every 2 s.",
        "HEARTBEAT is sent at 3 Hz if a station asks for that.",
        "The vehicle sends SYS_STATUS every 500 ms.",
        "HEARTBEAT has 9 bytes. It was seen at 5 Hz.",
        "Whoever misses HEARTBEAT every second time is far away.",
    ],
)
def test_what_is_right_or_says_no_rate_of_a_stream_is_left_alone(read, text: str) -> None:
    assert told(text, read("")) == []
