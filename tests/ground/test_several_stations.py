"""Several pymavlink stations at the one UDP link of the simulated rover, under MicroPython."""

import itertools
import socket
import time
from collections.abc import Iterator
from contextlib import ExitStack
from typing import Any

import pytest
from ground_link import GroundLink
from pymavlink.dialects.v20 import common

pytestmark = [pytest.mark.timeout(120), pytest.mark.requirement("FR-00070.11")]

BATTERY, BEAT_S = 147, 0.2


class Stations:
    """The declared station, and others that found the rover; each beats as it hears."""

    def __init__(self, declared: GroundLink, stack: ExitStack) -> None:
        self.declared = declared
        self._stack = stack

    def joined(self) -> GroundLink:
        """A further station of the same system id, which speaks from a port of its own."""
        other = self._stack.enter_context(GroundLink())
        other._connection.clients |= self.declared.senders
        other._connection.last_address = next(iter(self.declared.senders))
        return other

    def listen(self, seconds: float, *links: GroundLink) -> list[list[Any]]:
        """Return the messages that each heard while it beat."""
        since = [len(link.heard) for link in links]
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            for link in links:
                link.send.heartbeat_send(common.MAV_TYPE_GCS, common.MAV_AUTOPILOT_INVALID, 0, 0, 0)
                link.take_in()
            time.sleep(BEAT_S)
        return [link.heard[start:] for link, start in zip(links, since, strict=True)]


@pytest.fixture
def stations(start: Any, link: GroundLink) -> Iterator[Stations]:
    """A rover that is five times as fast as time, and the station that it was told of."""
    start(link.port, "steady", "--speed", "5")
    link.wait_for("HEARTBEAT", 0)
    with ExitStack() as stack:
        yield Stations(link, stack)


def count(messages: list[Any], name: str) -> int:
    return sum(message.get_type() == name for message in messages)


def lost(messages: list[Any]) -> int:
    """Return how many sequence numbers are missing between messages of one sender."""
    numbers = [message.get_seq() for message in messages]
    return sum((after - before - 1) % 256 for before, after in itertools.pairwise(numbers))


def test_stations_do_not_disturb_one_another(stations: Stations) -> None:
    """Rates, parameters and sequence numbers are of each; a stray byte, a restart and a departure change nothing."""
    first, second = stations.declared, stations.joined()
    stations.listen(1.0, first, second)
    second.command(common.MAV_CMD_SET_MESSAGE_INTERVAL, BATTERY, 100000)
    slow, fast = stations.listen(2.0, first, second)
    assert count(slow, "HEARTBEAT") >= 5
    assert count(fast, "HEARTBEAT") >= 5
    assert count(fast, "BATTERY_STATUS") > 3 * count(slow, "BATTERY_STATUS") > 0
    assert (lost(slow), lost(fast)) == (0, 0)

    second.send.param_request_list_send(1, 1)
    plain, asked = stations.listen(2.0, first, second)
    assert count(plain, "PARAM_VALUE") == 0
    values = [message for message in asked if message.get_type() == "PARAM_VALUE"]
    assert [value.param_index for value in values] == list(range(values[0].param_count))

    with socket.socket(type=socket.SOCK_DGRAM) as stranger:
        for stray in (b"\0", b"\xfd\xff\0", bytes(2000)):
            stranger.sendto(stray, next(iter(first.senders)))
        slow, fast = stations.listen(1.0, first, second)
        stranger.setblocking(False)
        with pytest.raises(BlockingIOError):
            stranger.recv(1)
    assert count(slow, "HEARTBEAT") >= 3
    assert count(fast, "HEARTBEAT") >= 3

    third = stations.joined()  # as the second one, started again: it has another port
    slow, new = stations.listen(1.5, first, third)
    assert count(slow, "HEARTBEAT") >= 4
    assert count(new, "HEARTBEAT") >= 4
    stations.listen(2.0, third)  # the first one is silent for longer than 10 s of the rover
    first.take_in()
    silent = len(first.heard)
    (still,) = stations.listen(1.0, third)
    assert first.take_in() == silent, "who is gone is not sent to"
    assert count(still, "HEARTBEAT") >= 3
    third.take_in(3.0)
    since = first.take_in()
    assert first.wait_for("HEARTBEAT", since), "the declared address, when nobody is left"
