"""The flash and heap of a codec for one message, for twelve and for all of common.xml."""

from pathlib import Path

import measure
from figure import Figure

COMPARES = """Sizes of compiled codecs (codegen codec --mpy): bytes of the .mpy files, and bytes of heap once they are
imported, after a collection. "messages" is that module with what it imports; the whole codec is "mavlink" with what it
imports as well. The heap is that of MicroPython's unix port on a 64-bit computer, whose words are twice as long as a
board's: there it is smaller."""

TWELVE = (
    "HEARTBEAT,SYS_STATUS,BATTERY_STATUS,PARAM_VALUE,PARAM_SET,PARAM_REQUEST_LIST,PARAM_REQUEST_READ,COMMAND_LONG,"
    "COMMAND_ACK,STATUSTEXT,PING,AUTOPILOT_VERSION"
)
CHOICES = {"1": ("1 message", "HEARTBEAT"), "12": ("12 messages", TWELVE), "all": ("all messages of common", "all")}
HEAP_ON = "x64"
BOARDS = ("armv6m", "armv7emsp", "bytecode")
PARTS = {"messages": "messages", "codec": "whole codec"}
MOST_FLASH, MOST_HEAP = 6144, 10240


def figures(quick: bool) -> list[Figure]:
    """Write the codecs, and count; a quick run leaves out the one with all messages."""
    flash: list[Figure] = []
    heap: list[Figure] = []
    with measure.scratch() as folder:
        for key, (name, messages) in CHOICES.items():
            if quick and key == "all":
                continue
            is_twelve = key == "12"
            here = measure.codec(folder / f"{HEAP_ON}-{key}", messages, "--mpy", HEAP_ON)
            imported = {"messages": _import(here, "messages"), "codec": _import(here, "messages", "mavlink")}
            for part, title in PARTS.items():
                most = MOST_HEAP if is_twelve and part == "messages" else None
                what = f"heap of {title}, {name}"
                value = imported[part][0]
                heap.append(Figure(f"{part}_{key}_heap", what, "64-bit words", value, "bytes", most=most))
            for board in BOARDS:
                there = measure.codec(folder / f"{board}-{key}", messages, "--mpy", board)
                for part, title in PARTS.items():
                    most = MOST_FLASH if is_twelve and part == "messages" else None
                    what = f".mpy of {title}, {name}"
                    size = _size(there, imported[part][1])
                    flash.append(Figure(f"{part}_{key}_{board}", what, board, size, "bytes", most=most))
    return flash + heap


def _import(folder: Path, *modules: str) -> tuple[int, list[str]]:
    """The heap that modules of a folder take, and what came with them."""
    answer = measure.micropython("heap.py", folder, *modules)
    return answer["heap"], [name for name in answer["modules"] if (folder / f"{name}.mpy").exists()]


def _size(folder: Path, modules: list[str]) -> int:
    """The bytes of modules in a folder: bytecode has the plain form of what is machine code elsewhere."""
    total = 0
    for module in modules:
        path = folder / f"{module}.mpy"
        total += (path if path.exists() else folder / f"{module.replace('_viper', '_plain')}.mpy").stat().st_size
    return total


if __name__ == "__main__":
    measure.run(COMPARES, figures)
