"""Reading from a board that gives up at a port on which bytes keep coming that are none of a prompt."""

import time
from collections.abc import Callable
from typing import Any

_KEPT = 4096
"""The bytes of what came last, of which only the end is looked at."""


def bounded(transport: Any) -> Callable[..., bytes]:
    """Return a ``read_until`` for mpremote's transport whose ``timeout_overall`` holds while something is read, too.

    mpremote looks at the time only where nothing is there: of a port at which an autopilot or a program of the board's
    own goes on sending it would wait for the prompt for ever.
    """
    unbounded = transport.read_until

    def read_until(
        min_num_bytes: int,
        ending: bytes,
        timeout: float | None = 10,
        data_consumer: Callable[[bytes], None] | None = None,
        timeout_overall: float | None = None,
    ) -> bytes:
        if timeout_overall is None:
            return bytes(unbounded(min_num_bytes, ending, timeout, data_consumer))
        data, until = b"", time.monotonic() + timeout_overall
        while not data.endswith(ending) and time.monotonic() < until:
            if transport.serial.in_waiting:
                data = data[-_KEPT:] + transport.serial.read(1)
            else:
                time.sleep(0.01)
        return data

    return read_until
