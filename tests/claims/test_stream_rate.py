"""Rates in a project's own documents, as requirements state them: compared with what a message is sent at first."""

from dataclasses import replace
from fractions import Fraction

import pytest

from codegen.claims.own import rate_column
from codegen.claims.own.stream_rate import check
from codegen.claims.reading import Reading, read_document

RATES = {"HEARTBEAT": (Fraction(1),), "BATTERY_STATUS": (Fraction(2), Fraction(1, 2))}


def told(text: str, reading: Reading) -> list[str]:
    """Return what is said of a text in a project that sends two messages."""
    reference = replace(reading.reference, rates=RATES)
    read = read_document(text, "/documents/notes.md", reference)
    return [each.message for each in (*check(read), *rate_column.check(read))]


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
        ("HEARTBEAT (ID 0, CRC_EXTRA 50) is sent at 2 Hz.", "not 2 Hz"),
        ("HEARTBEAT is sent four times per second.", "not 4 Hz"),
        ("HEARTBEAT is sent at least ten times per second.", "less than 10 Hz"),
        ("HEARTBEAT is sent at 1,5 Hz.", "not 1.5 Hz"),
        ("HEARTBEAT is sent every 0,5 s.", "not 2 Hz"),
        ("HEARTBEAT shall be transmitted with a period of 100 ms.", "not 10 Hz"),
        ("HEARTBEAT goes out at intervals of two seconds.", "not 0.5 Hz"),
        ("Six times per second HEARTBEAT (0) is sent.", "not 6 Hz"),
        ("It lives. At 3 Hz, `HEARTBEAT` shall be sent.", "not 3 Hz"),
        ("Every 200 ms the HEARTBEAT goes out.", "not 5 Hz"),
        ("The rate of HEARTBEAT is 6 Hz.", "not 6 Hz"),
        ("- HEARTBEAT (0): 6 Hz", "not 6 Hz"),
        ("What goes out (HEARTBEAT, 2 Hz) is little.", "not 2 Hz"),
        ("| Message | Rate |\n| - | - |\n| HEARTBEAT | 2 Hz |\n| BATTERY_STATUS | 2 Hz |", "not 2 Hz"),
        ("| Message | Period [ms] |\n| - | - |\n| HEARTBEAT (0) | 500 |\n| `BATTERY_STATUS` | 500 |", "not 500"),
        ("| Message | Rate (Hz) |\n| - | - |\n| HEARTBEAT | 1 |\n| BATTERY_STATUS | 4 |", "2 Hz or 0.5 Hz, not 4"),
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
        "HEARTBEAT is sent with a period of 1000 ms \u00b1 10 ms, that is at 1,0 Hz.",
        "Once per second HEARTBEAT (0) is sent; the loop runs at 400 Hz. HEARTBEAT does not.",
        "At 400 Hz HEARTBEAT would fill the link.",
        "HEARTBEAT: 1 Hz",
        "HEARTBEAT, 2 Hz steps",
        "| Message | Rate |\n| - | - |\n| HEARTBEAT | 1 Hz |\n| BATTERY_STATUS | 500 ms |",
        "| Message | Rate |\n| - | - |\n| HEARTBEAT | 2 Hz |",
        "| Message | Max. rate |\n| - | - |\n| HEARTBEAT | 1 Hz |\n| BATTERY_STATUS | 9 Hz |",
        "| Message | Rate |\n| - | - |\n| HEARTBEAT | 1 |\n| BATTERY_STATUS | 9 |",
        "Whoever misses HEARTBEAT every second time is far away.",
    ],
)
def test_what_is_right_or_says_no_rate_of_a_stream_is_left_alone(read, text: str) -> None:
    assert told(text, read("")) == []
