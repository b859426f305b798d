"""Changing the mode by MAV_CMD_DO_SET_MODE, which is acknowledged; set_mode.py has the older message."""

import dialect
from micropython import const

_LARGEST = const(0xFFFFFFFF)  # that custom_mode carries


def answer_modes(connection, vehicle):
    """Let a connection change the mode of a vehicle."""
    connection.services.commands.table[dialect.MAV_CMD_DO_SET_MODE] = ModeService(vehicle).do


class ModeService:
    """Changes the mode of a vehicle."""

    def __init__(self, vehicle):
        self._vehicle = vehicle

    def do(self, command):
        """Return the MAV_RESULT of MAV_CMD_DO_SET_MODE, and None."""
        return self.change(command.whole(1, 0, 0xFF), command.whole(2, 0, _LARGEST)), None

    def change(self, flags, mode):
        """Change the mode, unless something speaks against it, which a text says; return the MAV_RESULT."""
        result = dialect.MAV_RESULT_DENIED
        if flags is None or mode is None or not flags & dialect.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED:
            text = "Mode: only custom modes, by whole numbers"
        elif mode not in self._vehicle.MODES:
            text = "Mode: there is no mode " + str(mode)
        else:
            result = dialect.MAV_RESULT_FAILED
            text = self._vehicle.set_mode(mode)
        if text is None:
            return dialect.MAV_RESULT_ACCEPTED
        self._vehicle.texts.say(dialect.MAV_SEVERITY_ERROR, text)
        return result
