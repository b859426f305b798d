"""Recognises a sender as a ground station: one of its HEARTBEATs arrives on the same link."""


def is_heard(listeners, system):
    """Return whether Listeners hear a ground station of a system; any() would make an object at each call."""
    for name in listeners.names:  # noqa: SIM110
        if name >> 8 == system:
            return True
    return False
