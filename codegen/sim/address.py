"""Addresses of a simulation: the receiver of its frames, ``udp:HOST:PORT``, and the ends of its links over TCP."""

import socket

from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Address:
    """An IPv4 address in dotted form and a UDP port; ``written`` is what the user wrote."""

    host: str
    port: int
    written: str


class AddressError(ValueError):
    """An error in an address; the text says for the user why it cannot be used."""


def parse_address(text: str) -> Address:
    """``udp:HOST:PORT`` as an address, the host's name looked up. AddressError: it cannot be used."""
    scheme, _, rest = text.partition(":")
    host, _, port = rest.rpartition(":")
    if scheme not in ("udp", "udpout") or not host:
        raise AddressError(f"{text!r} is not an address; write udp:HOST:PORT, such as udp:127.0.0.1:14550")
    if not (port.isascii() and port.isdigit() and 1 <= int(port) <= 65535):
        raise AddressError(f"{port!r} is not a port from 1 to 65535")
    if ":" in host:
        raise AddressError("the vehicle speaks IPv4 only; write udp:HOST:PORT, such as udp:127.0.0.1:14550")
    try:
        found = socket.getaddrinfo(host, int(port), socket.AF_INET, socket.SOCK_DGRAM)
    except (OSError, UnicodeError):
        raise AddressError(f"the host {host!r} is not known") from None
    return Address(str(found[0][4][0]), int(port), text)


@dataclass(frozen=True, slots=True)
class LinkEnd:
    """The end of a link over TCP in a simulation, to listen on or to connect to; ``host`` None: the usual host."""

    host: str | None
    port: int


def parse_link(text: str) -> tuple[str, LinkEnd]:
    """``NAME=HOST:PORT`` or ``NAME=PORT``: the name of a link and its end. AddressError: it cannot be used."""
    name, equals, rest = text.partition("=")
    host, _, port = rest.rpartition(":")
    if not equals or not name or not (port.isascii() and port.isdigit() and 1 <= int(port) <= 65535):
        raise AddressError(f"{text!r} is not NAME=HOST:PORT or NAME=PORT, such as stations=127.0.0.1:5760")
    if not host:
        return name, LinkEnd(None, int(port))
    try:
        found = socket.getaddrinfo(host, int(port), socket.AF_INET, socket.SOCK_STREAM)
    except (OSError, UnicodeError):
        raise AddressError(f"the host {host!r} is not known") from None
    return name, LinkEnd(str(found[0][4][0]), int(port))


def free_port() -> int:
    """A UDP port of this host that nobody uses at the moment."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("", 0))
        port: int = probe.getsockname()[1]
        return port
