"""Changing the mode: MAV_CMD_DO_SET_MODE, which is acknowledged, and SET_MODE, which the HEARTBEAT answers."""

import dialect
import messages
from micropython import const

_LARGEST = const(0xFFFFFFFF)  # that custom_mode carries


def answer_modes(connection, vehicle):
    """Let a connection change the mode of a vehicle."""
    service = _ModeService(vehicle)
    services = connection.services
    services.commands.table[dialect.MAV_CMD_DO_SET_MODE] = service.do
    if hasattr(messages, "SetMode"):  # not every dialect has it any more
        services.take(messages.SetMode, service.take)


class _ModeService:
    def __init__(self, vehicle):
        self._vehicle = vehicle

    def do(self, command):
        """Return the MAV_RESULT of MAV_CMD_DO_SET_MODE, and None."""
        return self._change(command.whole(1, 0, 0xFF), command.whole(2, 0, _LARGEST)), None

    def take(self, message):
        """Do what a SET_MODE asks for; it has no target component."""
        self._change(message.raw("base_mode"), message.raw("custom_mode"))

    def _change(self, flags, mode):
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
