"""The commands of this vehicle: what each is given is looked at, then the method of the vehicle does it."""

import time

import dialect
import messages
from command_table import COMMANDS
from guard import Guard
from heard import is_heard
from micropython import const

# The parts of a command in command_table.py.
_METHOD = const(0)
_TITLE = const(1)  # what texts call it
_ARMED = const(2)  # whether the vehicle has to be armed for it; None: either way
_STATIONS = const(3)  # whether only ground stations may ask
_LONG = const(4)
_PARAMS = const(5)
_INT_PARAMS = const(6)  # the parameters as COMMAND_INT has them, with a position; () where they are the same
_FRAMES = const(7)  # in which COMMAND_INT may state it; () for any
_FRAME_WORDS = const(8)
# Some have more parts.
_LEAVES = const(9)  # numbers on the wire that leave things as they are; None among them: NaN
_ENDS = const(10)  # of the argument, where a float of 32 bits on the wire may be beyond them

# The parts of a parameter in command_table.py.
_NUMBER = const(0)
_LEAST = const(1)
_MOST = const(2)
_MULTIPLIER = const(3)
_DIVISOR = const(4)
_FORM = const(5)
_AMONG = const(6)  # the values that can be, or all flags; None: all within the limits
_DEFAULT = const(7)  # for NaN; None: NaN is denied
_WORDS = const(8)

_WHOLE = const(1)
_ROUNDED = const(2)
_BITS = const(48)  # behind the point, of a number that is to be multiplied as with all its digits
_UNKNOWN_INT = const(0x7FFFFFFF)  # in x and y of COMMAND_INT, which have no NaN
_QUIET_MS = const(1000)  # between two texts that say the same
_CANNOT = object()  # what the argument is of a value that cannot be


def answer_commands(connection, vehicle):
    """Let a connection answer the commands of a vehicle."""
    do = OwnCommands(vehicle, connection).do
    for number in COMMANDS:
        connection.services.commands.table[number] = do


class OwnCommands:
    """Does the commands of a vehicle that arrive on one connection."""

    def __init__(self, vehicle, connection):
        self._vehicle = vehicle
        self._connection = connection
        self._guard = Guard()
        self._text = None
        self._said_ms = 0

    def do(self, command):
        """Return the MAV_RESULT of a command, and None; why it is not done, a text says.

        What cannot be right later either is denied, what may be is rejected for now.
        """
        row = COMMANDS[command.number]
        if row[_STATIONS] and not is_heard(self._connection.services.listeners, command.system):
            return self._refuse(row, dialect.MAV_RESULT_DENIED, "only for ground stations that are heard")
        running = self._vehicle.long_commands.running(row[_METHOD]) if row[_LONG] else None
        if running is not None and running.is_asked_again(command):
            command.progress = running.progress
            return dialect.MAV_RESULT_IN_PROGRESS, None
        values = []
        problem = _read(row, command, values)
        if problem is not None:
            return self._refuse(row, dialect.MAV_RESULT_DENIED, problem)
        if row[_ARMED] is not None and row[_ARMED] != self._vehicle.is_armed:
            first = "arm first" if row[_ARMED] else "disarm first"
            return self._refuse(row, dialect.MAV_RESULT_TEMPORARILY_REJECTED, first)
        if running is not None:
            return self._refuse(row, dialect.MAV_RESULT_TEMPORARILY_REJECTED, "is going on already")
        return self._begin(row, command, values)

    def _begin(self, row, command, values):
        result, text = called(self._guard, getattr(self._vehicle, row[_METHOD]), values)
        if result != dialect.MAV_RESULT_ACCEPTED:
            return self._refuse(row, result, text)
        if row[_LONG]:
            self._vehicle.long_commands.begin(row, command, self._connection)
            return dialect.MAV_RESULT_IN_PROGRESS, None
        return result, None

    def _refuse(self, row, result, text):
        """Say why, if there is anything to say: to many commands that are refused alike once in a while."""
        now_ms = time.ticks_ms()
        if text is not None:
            text = row[_TITLE] + ": " + text
            if text != self._text or time.ticks_diff(now_ms, self._said_ms) >= _QUIET_MS:
                self._text = text
                self._said_ms = now_ms
                self._vehicle.texts.say(dialect.MAV_SEVERITY_ERROR, text)
        return result, None


def called(guard, method, values=()):
    """Call a method of the vehicle; return the MAV_RESULT of its answer or exception, and its text or None."""
    with guard:
        return judged(method(*values))
    return dialect.MAV_RESULT_FAILED, told(guard.error)


def told(error):
    """Return an exception in words: its kind, and what it says, if anything."""
    said = str(error)
    kind = type(error).__name__
    return kind + ": " + said if said else kind


def judged(said):
    """Return the MAV_RESULT of what a method returned, and the text with it, or None.

    TypeError: it is nothing that a method can return.
    """
    if said is None or said is True:
        return dialect.MAV_RESULT_ACCEPTED, None
    if said is False:
        return dialect.MAV_RESULT_FAILED, None
    if said is NotImplemented:  # no code overrides the method
        return dialect.MAV_RESULT_UNSUPPORTED, None
    if isinstance(said, str):
        return dialect.MAV_RESULT_FAILED, said
    raise TypeError("returned " + repr(said))


def _read(row, command, values):
    """Append the arguments for the method to `values`; return what is wrong with a parameter, or None."""
    is_int = command.message.ID == messages.CommandInt.ID
    if is_int and row[_FRAMES] and command.message.wire[dialect.COMMAND_INT_FRAME_AT] not in row[_FRAMES]:
        return row[_FRAME_WORDS]
    for param in (is_int and row[_INT_PARAMS]) or row[_PARAMS]:
        value = _argument(param, command.param(param[_NUMBER]), is_int)
        if value is _CANNOT:
            return param[_WORDS]
        values.append(value)
    return None


def _argument(param, value, is_int):
    """Return what a value on the wire is for the method, None where nothing is to change; _CANNOT: it cannot be."""
    leaves = param[_LEAVES] if len(param) > _LEAVES else ()
    # The float of 32 bits beside 0x7FFFFFFF equals it on a board, and is a number.
    if value != value or (is_int and isinstance(value, int) and value == _UNKNOWN_INT):  # noqa: PLR0124  NaN
        if None in leaves:
            return None
        return _CANNOT if param[_DEFAULT] is None else param[_DEFAULT]
    if value in leaves:
        return None
    if not param[_LEAST] <= value <= param[_MOST]:
        return _CANNOT
    if param[_FORM] == _ROUNDED and isinstance(param[_MULTIPLIER], int):
        value = _nearest(value, param[_MULTIPLIER], param[_DIVISOR])
    elif param[_MULTIPLIER] != param[_DIVISOR]:
        value = value * param[_MULTIPLIER] / param[_DIVISOR]
    if not param[_FORM]:
        return value
    whole = round(value) if param[_FORM] == _ROUNDED else int(value)
    if whole != value and param[_FORM] == _WHOLE:
        return _CANNOT
    if len(param) > _ENDS:
        return min(max(whole, param[_ENDS][0]), param[_ENDS][1])
    return whole if _is_among(param[_AMONG], whole) else _CANNOT


def _nearest(value, multiplier, divisor):
    """Return the whole number nearest to a value times a fraction, by whole numbers: a board's floats have 24 bits."""
    whole = int(value)
    parts = (whole << _BITS) + int((value - whole) * (1 << _BITS))
    one = divisor << _BITS
    nearest = (2 * abs(parts) * multiplier + one) // (2 * one)
    return -nearest if parts < 0 else nearest


def _is_among(among, value):
    if among is None:
        return True
    return value in among if isinstance(among, tuple) else value & ~among == 0
