"""SET_MODE, where the dialect still has it: the HEARTBEAT answers it."""

from struct import unpack_from

import dialect
import messages
from micropython import const  # noqa: F401  numbers of the dialect are constants
from mode_service import ModeService


def answer_set_mode(connection, vehicle):
    """Let a connection change the mode of a vehicle by SET_MODE, which has no target component."""
    service = ModeService(vehicle)

    def take(message):
        wire = message.wire
        mode = unpack_from("<I", wire, dialect.SET_MODE_CUSTOM_MODE_AT)[0]
        service.change(wire[dialect.SET_MODE_BASE_MODE_AT], mode)

    connection.services.take(messages.SetMode, take)
