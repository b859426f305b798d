"""COMMAND_CANCEL, where the dialect has it: it ends a command that takes long."""

from struct import unpack_from

import dialect
import messages
from command_table import COMMANDS
from guard import Guard
from heard import is_heard
from micropython import const
from own_commands import called

_STATIONS = const(3)  # of a row of command_table.py, as own_commands has it


def answer_cancel(connection, vehicle):
    """Let what takes long be cancelled by a connection."""
    connection.services.take(messages.CommandCancel, _Cancel(connection, vehicle).take)


class _Cancel:
    """Takes COMMAND_CANCEL on one connection."""

    def __init__(self, connection, vehicle):
        self._listeners = connection.services.listeners
        self._vehicle = vehicle
        self._guard = Guard()

    def take(self, message):
        """Ask the vehicle to end a command; what does not go on needs no answer."""
        number = unpack_from("<H", message.wire, dialect.COMMAND_CANCEL_COMMAND_AT)[0]
        commands = self._vehicle.long_commands
        running = commands.named(number)
        if running is None or (COMMANDS[number][_STATIONS] and not is_heard(self._listeners, message.source_system)):
            return
        result, text = called(self._guard, getattr(self._vehicle, running.method + "_cancel"))
        if result == dialect.MAV_RESULT_ACCEPTED:
            commands.end(running, dialect.MAV_RESULT_CANCELLED, None)
        elif self._guard.error is not None:  # nobody knows what it does now
            commands.end(running, result, text)
        else:
            commands.say(running, text or "cannot be cancelled")
            commands.tell(running)
