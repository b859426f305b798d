"""SETUP_SIGNING: a new key for the links that are signed, over a cable that is trusted."""

import messages


def take_keys(connection, vehicle):
    """Let SETUP_SIGNING, where it is for this vehicle, bring a new key over a connection; none takes signing away."""

    def take(message):
        key = bytes(message.secret_key)
        if not any(key):
            vehicle.texts("warning: links stay signed: SETUP_SIGNING without a key is refused")
        elif getattr(vehicle, "is_armed", False):
            vehicle.texts("warning: a new key is refused while armed")
        else:
            vehicle.access.replace(key, message.raw("initial_timestamp"))

    connection.services.take(messages.SetupSigning, take)
