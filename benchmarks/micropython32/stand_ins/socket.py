"""A module in place of a network, which this port has not: it can be imported, and makes nothing."""

AF_INET = 2
SOCK_DGRAM = 2
SOL_SOCKET = 1
SO_BROADCAST = 6
SO_REUSEADDR = 2

_ENODEV = 19


def getaddrinfo(host, port):
    """Return the address as it is."""
    return [(AF_INET, SOCK_DGRAM, 0, "", (host, port))]


def socket(*_kind):
    """Fail as where there is no device."""
    raise OSError(_ENODEV)
