"""State to frame of messages that differ in the type of one field, each with a value that is known. See counting.py."""

import counting
import telemetry
from mavlink import Link
from state import SystemState

state = SystemState(log=lambda *_words: None)
state.meter.beside_number = 1234
state.meter.short_number = 23456
state.meter.int32_number = 1234567890
state.meter.int64_number = -1234567890123456
state.meter.uint64_number = 12345678901234567890
state.meter.real = 0.1
state.meter.double = 0.1
link = Link(None)


def encoding(name):
    """Return the workload of one message; each frame is as long as its payload."""
    encode = getattr(telemetry, f"encode_with_{name}")

    def rounds_of(rounds):
        for _ in range(rounds):
            encode(link, state)
        return len(encode(link, state))

    return rounds_of


counting.count(**{name: encoding(name) for name in ("short", "int32", "int64", "uint64", "real", "double")})
