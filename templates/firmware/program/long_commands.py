"""Commands that take long: who asked is told how far they are, and how they end."""

import time
from struct import pack_into

import dialect
import messages
from guard import Guard
from micropython import const
from own_commands import judged, told

_METHOD = const(0)  # of a row of command_table.py, as own_commands has them
_TITLE = const(1)
_ASK_MS = const(100)  # between two questions to the vehicle how far it is
_TELL_MS = const(1000)  # between two COMMAND_ACK that say so


class _Running:
    """A command that goes on; `progress` is 0 to 100."""

    def __init__(self, vehicle, row, command, connection):
        self.method = row[_METHOD]
        self.title = row[_TITLE]
        self.ask = getattr(vehicle, row[_METHOD] + "_progress")
        self.number = command.number
        self.system = command.system
        self.component = command.component
        self.connection = connection
        self.station = connection.station
        self.progress = 0
        self.asked_ms = self.told_ms = time.ticks_ms()

    def is_asked_again(self, command):
        """Return whether who asked for it repeats that, because no answer has arrived; COMMAND_INT does not count."""
        if (command.number, command.system, command.component) != (self.number, self.system, self.component):
            return False
        message = command.message
        return message.ID == messages.CommandInt.ID or message.wire[dialect.COMMAND_LONG_CONFIRMATION_AT] > 0


class LongCommands:
    """The commands of a vehicle that go on, one of a method, for all its connections."""

    def __init__(self, vehicle):
        self._vehicle = vehicle
        self._running = []
        self._ack = messages.CommandAck(unknown=False)
        self._guard = Guard()

    def running(self, method):
        """Return the running command that this method of the vehicle does, or None."""
        for running in self._running:
            if running.method == method:
                return running
        return None

    def begin(self, row, command, connection):
        """Note a command that the vehicle has begun."""
        self._running.append(_Running(self._vehicle, row, command, connection))

    def run(self, now_ms):
        """Ask the vehicle how far it is and tell who asked; call it in every pass with time.ticks_ms()."""
        for place in range(len(self._running) - 1, -1, -1):  # backwards: one that ends goes
            running = self._running[place]
            if time.ticks_diff(now_ms, running.asked_ms) >= _ASK_MS:
                running.asked_ms = now_ms
                self._ask(running)
                if running in self._running and time.ticks_diff(now_ms, running.told_ms) >= _TELL_MS:
                    running.told_ms = now_ms
                    self.tell(running)

    def named(self, number):
        """Return the running command with this number, or None."""
        for running in self._running:
            if running.number == number:
                return running
        return None

    def tell(self, running):
        """Tell the station that asked how far its command is; a lost message is made good by the next one."""
        running.connection.turn_to(running.station)
        self._send((running, dialect.MAV_RESULT_IN_PROGRESS))

    def end(self, running, result, text):
        """Tell who asked how it ended, and everybody why, if there is a text."""
        self._running.remove(running)
        if text is not None:
            self.say(running, text)
        running.progress = 0
        running.connection.turn_to(running.station)
        running.connection.deliver(self._send, (running, result))

    def say(self, running, text):
        """Send a text about a running command to all stations."""
        self._vehicle.texts.say(dialect.MAV_SEVERITY_ERROR, running.title + ": " + text)

    def _ask(self, running):
        said = None
        with self._guard:
            said = running.ask()
            if said is not None and not isinstance(said, (bool, str)):
                running.progress = min(max(int(said), 0), 100)
                return
        if self._guard.error is None:
            self.end(running, *judged(said))
        else:
            self.end(running, dialect.MAV_RESULT_FAILED, told(self._guard.error))

    def _send(self, answer):
        running, result = answer
        wire = self._ack.wire
        pack_into("<H", wire, dialect.COMMAND_ACK_COMMAND_AT, running.number)
        wire[dialect.COMMAND_ACK_RESULT_AT] = result
        wire[dialect.COMMAND_ACK_PROGRESS_AT] = running.progress
        wire[dialect.COMMAND_ACK_TARGET_SYSTEM_AT] = running.system
        wire[dialect.COMMAND_ACK_TARGET_COMPONENT_AT] = running.component
        return running.connection.send(self._ack)
