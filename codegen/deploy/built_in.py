"""The modules that a MicroPython has built in: what a board says of it, or else all that any of them may have."""

from collections.abc import Iterable

_END = "Plus any modules"
"""The words below the list of help("modules")."""

_PLAIN = """
__main__ _asyncio _boot _espnow _onewire _rp2 _thread _webrepl aioble aioespnow apa102 apa106 argparse array
asyncio binascii bluetooth btree builtins cmath collections cryptolib deflate dht ds18x20 errno esp esp32
espnow flashbdev framebuf gc hashlib heapq inisetup io json lcd160cr lwip machine marshal math micropython
mimxrt mip neopixel network nrf ntptime onewire openamp os platform pyb random re requests rp2 samd select
socket ssl ssd1306 stm struct sys time tls uctypes umqtt upip upysh usb vfs webrepl webrepl_setup websocket
zephyr zlib zsensor
"""


def built_in(printed: str) -> frozenset[str] | None:
    """Return the modules in what ``help("modules")`` has printed; None where this MicroPython lists none.

    Packages are listed by their modules, ``asyncio/core``.
    """
    listed, end, _ = printed.partition(_END)
    return _with_both_names(name.partition("/")[0] for name in listed.split()) if end else None


def _with_both_names(names: Iterable[str]) -> frozenset[str]:
    """The names with a u in front, and without: ``time`` was ``utime``, and most can be imported by either."""
    names = set(names)
    return frozenset({*names, *(f"u{name}" for name in names), *(name[1:] for name in names if name[:1] == "u")} - {""})


ANYWHERE = _with_both_names(_PLAIN.split())
"""The modules that builds of MicroPython for any kind of board have."""
