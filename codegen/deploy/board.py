"""A board as it describes itself: its machine, its file system, its files."""

from collections.abc import Mapping
from typing import Any

from codegen.frozen import dataclass
from codegen.model.board_model import Architecture

_ARCHITECTURES = tuple(Architecture)
"""By their numbers in .mpy files (MicroPython, py/persistentcode.h)."""


@dataclass(frozen=True, slots=True)
class Board:
    """``machine`` is its name for MicroPython; ``free``, ``room`` and ``block`` are bytes of its file system.

    ``mpy`` is the version and sub-version of .mpy files that it loads, (0, 0) if none; ``architecture`` is what
    mpy-cross calls its machine code, ``bytecode`` where it runs none, and None where its ``number`` is unknown.
    ``roms`` is how many partitions for a ROMFS it has, ``heap`` the bytes of its heap.
    """

    version: tuple[int, ...]
    machine: str
    mpy: tuple[int, int]
    number: int
    architecture: str | None
    block: int
    room: int
    free: int
    roms: int
    heap: int

    @property
    def words(self) -> str:
        """Return the board in one line, for people."""
        version = ".".join(map(str, self.version))
        kind = self.architecture or f"architecture {self.number}"
        return f"{self.machine}, MicroPython {version}, {kind}, {self.free // 1024} of {self.room // 1024} KB free"


@dataclass(frozen=True, slots=True)
class Found:
    """A file on the board: bytes; its hash, empty where nobody asked; whether it begins as what codegen generates."""

    size: int
    digest: str
    is_made: bool


def board_of(told: Mapping[str, Any]) -> Board:
    """The board that has answered so."""
    mpy = int(told["mpy"])
    number = mpy >> 10 & 0x3F  # above these bits are flags of the processor
    return Board(
        version=tuple(told["version"]),
        machine=told["machine"],
        mpy=(mpy & 0xFF, mpy >> 8 & 3),
        number=number,
        architecture=_ARCHITECTURES[number].value if number < len(_ARCHITECTURES) else None,
        block=told["block"],
        room=told["room"],
        free=told["free"],
        roms=max(0, told["roms"]),
        heap=told["heap"],
    )
