"""pymavlink's mavutil as a ground station."""

import os
import sys
import time
from collections.abc import Callable
from types import TracebackType
from typing import Any, Self

import pytest
from programs import PATIENCE_S
from pymavlink import mavutil
from pymavlink.dialects.v20 import common

VEHICLE = (1, 1)
"""System and component of the rover."""
_ACCEPT_ANY: Callable[[Any], bool] = lambda _: True  # noqa: E731


class GroundLink:
    """A connection of mavutil, everything that arrived at it, and what a ground station says to the rover."""

    def __init__(self, device: str = "udpin:127.0.0.1:0", system: int = 255) -> None:
        versions = {name: os.environ.get(name) for name in ("MAVLINK20", "MAVLINK09")}
        os.environ["MAVLINK20"] = "1"
        try:
            self._connection = mavutil.mavlink_connection(
                device, source_system=system, source_component=190, dialect="common"
            )
        finally:  # it tells the rest of its process by the environment; nobody else is to hear it
            for name, value in versions.items():
                os.environ.pop(name, None) if value is None else os.environ.update({name: value})
        self.heard: list[Any] = []
        """The messages in the order of their arrival."""

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, place: TracebackType | None
    ) -> None:
        self._connection.close()
        sys.stdout.write(f"---- pymavlink heard:\n{self.newest()}\n")  # pytest shows it when the test fails

    @property
    def port(self) -> int:
        """Return the port that the rover has to send to."""
        number: int = self._connection.port.getsockname()[1]
        return number

    @property
    def senders(self) -> set[tuple[str, int]]:
        """The addresses that datagrams came from; what is said goes to all of them."""
        return set(self._connection.clients)

    def forget(self) -> None:
        """Forget what was heard and who said it: that simulator has ended, and its port may be anybody's."""
        self.take_in(0.05)
        self.heard.clear()
        self._connection.clients.clear()

    @property
    def send(self) -> Any:
        """pymavlink's MAVLink, with its methods ..._send()."""
        return self._connection.mav

    def write(self, data: bytes) -> None:
        """Send any bytes as a datagram."""
        self._connection.write(data)

    def newest(self) -> str:
        """The last messages as lines, the telemetry only as names."""
        telemetry = ("HEARTBEAT", "SYS_STATUS", "BATTERY_STATUS")
        heard = [message.get_type() if message.get_type() in telemetry else str(message) for message in self.heard]
        return "\n".join(heard[-60:])

    def take_in(self, seconds: float = 0.0) -> int:
        """Take in what has arrived, for a while if need be; return the number of messages so far."""
        deadline = time.monotonic() + seconds
        while True:
            message = self._connection.recv_match(blocking=seconds > 0, timeout=0.05)
            if message is not None and message.get_type() != "BAD_DATA":
                self.heard.append(message)
            elif time.monotonic() >= deadline:
                return len(self.heard)

    def since(self, position: int, name: str) -> list[Any]:
        """The messages of a name that were heard since a position."""
        return [message for message in self.heard[position:] if message.get_type() == name]

    def wait_for(self, name: str, since: int | None = None, where: Callable[[Any], bool] = _ACCEPT_ANY) -> Any:
        """The first message of a name since a position; without one, of those to come."""
        return self.heard[self.find(name, self.take_in() if since is None else since, where)]

    def find(self, name: str, since: int, where: Callable[[Any], bool] = _ACCEPT_ANY) -> int:
        """The position of the first message of a name since a position; it is waited for."""
        position = since
        deadline = time.monotonic() + PATIENCE_S
        while True:
            while position < len(self.heard):
                message = self.heard[position]
                if message.get_type() == name and where(message):
                    return position
                position += 1
            if time.monotonic() > deadline:
                pytest.fail(f"no such {name} came in {PATIENCE_S:g} s, but:\n{self.newest()}")
            message = self._connection.recv_match(blocking=True, timeout=0.05)
            if message is not None and message.get_type() != "BAD_DATA":
                self.heard.append(message)

    def command(self, number: int, *values: float) -> Any:
        """Send a COMMAND_LONG and return its COMMAND_ACK."""
        position = self.take_in()
        padded = (*values, 0, 0, 0, 0, 0, 0, 0)[:7]
        self.send.command_long_send(*VEHICLE, number, 0, *padded)
        return self.wait_for("COMMAND_ACK", position, lambda answer: answer.command == number)

    def parameter(self, name: str) -> Any:
        """Read a parameter and return its PARAM_VALUE."""
        position = self.take_in()
        self.send.param_request_read_send(*VEHICLE, name.encode(), -1)
        return self.wait_for("PARAM_VALUE", position, lambda answer: answer.param_id == name)

    def set_parameter(self, name: str, value: float) -> Any:
        """Set a parameter and return the PARAM_VALUE that answers it."""
        position = self.take_in()
        self.send.param_set_send(*VEHICLE, name.encode(), value, common.MAV_PARAM_TYPE_REAL32)
        return self.wait_for("PARAM_VALUE", position, lambda answer: answer.param_id == name)

    def per_heartbeat(self, name: str, heartbeats: int = 10) -> float:
        """Return the number of messages of a name for each HEARTBEAT, which marks a second of the rover's time."""
        first = last = self.find("HEARTBEAT", self.take_in())
        for _ in range(heartbeats):
            last = self.find("HEARTBEAT", last + 1)
        between = self.heard[first:last]
        return sum(message.get_type() == name for message in between) / heartbeats
