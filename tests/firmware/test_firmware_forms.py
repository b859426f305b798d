"""The plain form and machine code do the same, step for step and to the last byte that was received or is sent."""

import random
from typing import Any

import pymavlink_oracle as oracle
import pytest
from firmware_runs import Exercise

SMALL = oracle.described("SMALL", "a:I b:h c:B d:b x:i y:H z:I", 17, base_length=8)
ODD = oracle.described("ODD", "a:B b:3b c:B d:2H e:2i f:I", 0x10002, base_length=5)
ONE = oracle.described("ONE", "a:B", 1)
FOUR = oracle.described("FOUR", "a:I", 0x302)
EMPTY = oracle.described("EMPTY", "", 2)
DESCRIPTIONS = [SMALL, ODD, ONE, FOUR, EMPTY, oracle.describe("BATTERY_STATUS"), oracle.describe("TUNNEL")]
COUNTERS = ("received", "signed", "refused", "unknown", "crc_errors", "dropped")  # as exercise.py tells them
LIVE = [["a", "b", "d", "x", "z"], ["a", "b[1]", "d", "e", "f"], [], ["a"], [], ["voltages", "temperature"], []]


def both(exercise: Exercise, operation: str, **arguments: Any) -> list[Any]:
    """Return the answers of both forms; machine code, where there is any, has to answer like the plain form."""
    results = exercise(operation, classes=DESCRIPTIONS, **arguments)
    assert set(results) == exercise.forms
    for found in results.values():
        for index, (answer, plain) in enumerate(zip(found, results["plain"], strict=True)):
            assert answer == plain, arguments["cases"][index]
    answers: list[Any] = results["plain"]
    return answers


@pytest.mark.parametrize("seed", [1, 2])
def test_frames_are_written_alike(exercise: Exercise, seed: int) -> None:
    """Any payload and live values, both versions, links that are too short, ids that do not go, junk in the buffer."""
    chance = random.Random(seed)
    cases = []
    for _ in range(1500):
        index = chance.randrange(len(DESCRIPTIONS))
        length = DESCRIPTIONS[index]["LENGTH"]
        longest = chance.choice([length, 255, max(1, length - 1), chance.randrange(1, 256)])
        buffer = bytearray(chance.randbytes(2 + 10 + longest + 2 + 15))
        buffer[0] = longest
        buffer[2] = chance.choice([0xFD, 0xFD, 0xFE])
        used = chance.randrange(length + 1)
        wire = chance.randbytes(used) + bytes(length - used)
        names = [name for name in LIVE[index] if chance.random() < 0.7]
        values = [chance.choice([0, -1, chance.randrange(-(2**31), 2**31)]) for _ in range(elements(index, names))]
        cases.append([index, names, buffer.hex(), wire.hex(), values])
    answers = [answer[0] for answer in both(exercise, "equal_frames", cases=cases)]
    # The cases have to bring up everything that there is.
    assert {answer for answer in answers if isinstance(answer, str)} == {
        "MAVLink 1 has no message ids above 255",
        "the link is too short for this message",
    }
    assert {answer for answer in answers if isinstance(answer, int)} >= {0, 1, 2, 3, 4, 36, 54}


def elements(index: int, names: list[str]) -> int:
    """Return the number of live values that the names stand for."""
    layout = oracle.layout(DESCRIPTIONS[index])
    return sum(1 if "[" in name else layout[name][2] or 1 for name in names)


def some_frame(chance: random.Random) -> bytes:
    """A frame of a known message, now and then damaged, signed, longer or shorter than the message."""
    description = chance.choice(DESCRIPTIONS)
    length = chance.choice([description["LENGTH"], chance.randrange(256), 255, chance.randrange(12)])
    extra = chance.choice([description["CRC_EXTRA"]] * 5 + [99])
    payload = chance.randbytes(length)
    if description["ID"] <= 255 and chance.random() < 0.4:
        return oracle.raw_frame_1(description["ID"], payload, extra)
    if chance.random() < 0.3:
        return oracle.raw_frame(description["ID"], payload, extra, flags=1, tail=chance.randbytes(13))
    return oracle.raw_frame(description["ID"], payload, extra, flags=chance.choice([0] * 9 + [2, 0x81]))


def garbage(chance: random.Random) -> bytes:
    """Bytes of which many announce a frame."""
    weights = [6, 6, 3, 3, 1, 1]
    return bytes(chance.choices([0xFD, 0xFE, 0, 1, 17, chance.randrange(256)], weights, k=chance.randrange(60)))


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_streams_are_taken_in_alike(exercise: Exercise, seed: int) -> None:
    """Frames and garbage, cut anywhere, at odd and even addresses: what is found, where, and all that it leaves."""
    chance = random.Random(seed)
    cases = []
    for _ in range(30):
        parts = [chance.choice([some_frame, garbage])(chance) for _ in range(chance.randrange(1, 25))]
        stream = b"".join(parts) + bytes(chance.choice([0, 300]))
        longest = chance.choice([1, 5, 40, 300, 5000])
        pieces = []
        while stream:
            size = chance.randrange(1, longest + 1)
            pieces.append(stream[:size].hex())
            stream = stream[size:]
        cases.append([chance.choice([280, 281, 283, 560]), chance.randrange(4), pieces])
    answers = both(exercise, "equal_streams", cases=cases, live=LIVE)
    # A message is told with the whole state: beginnings, payloads, signatures of all kinds came up.
    found = [step[3] for steps, _ in answers for step in steps if len(step) == 4]
    assert {state[3] % 4 for state in found} == {state[4] % 4 for state in found} == {0, 1, 2, 3}
    assert {state[9] for state in found} == {0, 1}
    assert {state[6] for state in found} == {description["ID"] for description in DESCRIPTIONS}
    counted = [step for steps, _ in answers for step in steps if len(step) == len(COUNTERS)]
    for name in ("received", "signed", "unknown", "crc_errors", "dropped"):
        assert any(step[COUNTERS.index(name)] for step in counted), name
