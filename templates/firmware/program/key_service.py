"""SETUP_SIGNING: a new key for the links that are signed, over a cable that is trusted."""

from struct import unpack_from

import dialect
import messages
from micropython import const

_KEY_SIZE = const(32)


def take_keys(connection, vehicle):
    """Let SETUP_SIGNING, where it is for this vehicle, bring a new key over a connection; none takes signing away."""

    def take(message):
        wire = message.wire
        at = dialect.SETUP_SIGNING_SECRET_KEY_AT
        key = bytes(wire[at : at + _KEY_SIZE])
        if not any(key):
            vehicle.texts("warning: links stay signed: SETUP_SIGNING without a key is refused")
        elif getattr(vehicle, "is_armed", False):
            vehicle.texts("warning: a new key is refused while armed")
        else:
            timestamp = unpack_from("<Q", wire, dialect.SETUP_SIGNING_INITIAL_TIMESTAMP_AT)[0]
            vehicle.access.replace(key, timestamp)

    connection.services.take(messages.SetupSigning, take)
