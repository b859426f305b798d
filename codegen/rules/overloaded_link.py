"""Rule for links that carry less than is streamed over them by default."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.price import BITS_OF_A_BYTE, capacity, price_on, signature_on
from codegen.model.system import System

RULE = Rule(
    "overloaded-link",
    "At the default rates more bytes may be streamed than a serial link carries: a tenth of its baud rate each second, "
    "of which a signature takes 13 of each frame. What has no room is left out, of what is due at once the last "
    "streams of streams.yaml first, and what goes out less often than its stream says is nowhere told. Lower default "
    "rates, or raise the baud rate; the page about bandwidth has the share of each message.",
    Severity.WARNING,
)
_USUAL = (9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600)
"""The rates that radios and cables are sold with."""


def check(system: System) -> Iterator[Diagnostic]:
    """Every link of which the board states how much it carries."""
    for link in system.links:
        carried = capacity(link)
        taken = price_on(link, system).high
        if carried is None or taken <= carried:
            continue
        enough = next((baud for baud in _USUAL if baud >= taken * BITS_OF_A_BYTE), None)
        signed = ", signatures included" if signature_on(link, system) else ""
        yield Diagnostic(
            link.spec.at("baud"),
            RULE,
            f"up to {float(taken):.0f} bytes are streamed each second by default{signed}, and {link.name} carries "
            f"{float(carried):.0f}",
            "lower the default rates of streams" + (f", or write baud: {enough}" if enough else ""),
        )
