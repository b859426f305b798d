"""The estimate of the heap that a program takes on its board, and what is left of it for running."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.memory.costs import bytes_of, measured_costs
from codegen.memory.parts import Counts, Part, counted
from codegen.model.system import System
from codegen.once import once

SHARE = Fraction(4, 5)
"""The part of a heap that a program may take once it has started: running takes up to a quarter more than that."""
ACCURACY = Fraction(1, 10)
"""The share of an estimate by which it may be off: of nearly all programs that no cost was fitted to it is less."""

GROUPS: dict[str, tuple[Part, ...]] = {
    "the program itself": (Part.PROGRAM,),
    "links": (Part.LINK, Part.NETWORK),
    "messages that are sent": (Part.MESSAGE, Part.TABLE, Part.CONSTANT, Part.VALUE),
    "messages that are received": (Part.RECEPTION, Part.TAKEN),
    "the state": (Part.COMPONENT, Part.QUANTITY, Part.LARGE, Part.LIST, Part.STORAGE),
    "parameters": (Part.PARAMETER,),
    "readings and sensors": (Part.READING, Part.SENSOR),
    "failsafes and commands": (Part.FAILSAFE, Part.COMMAND),
}
"""The parts by the names that they are told under; every part is in one group."""


@dataclass(frozen=True, slots=True)
class Estimate:
    """The heap in bytes that a program takes once it is imported and has started, without the user's own code.

    ``machine_code`` is what it would take less without machine code; ``shares`` are its parts by what they are, the
    largest first. ``heap`` is what the board has for it, None where nobody knows. ``programs`` is how many were
    measured.
    """

    bytes: int
    machine_code: int
    shares: tuple[tuple[str, int], ...]
    heap: int | None
    programs: int

    @property
    def least(self) -> int:
        """Return what it takes at least."""
        return int(self.bytes * (1 - ACCURACY))

    @property
    def never_fits(self) -> bool:
        """Return whether the board has too little memory for it, however far the estimate is off."""
        return self.heap is not None and self.least > self.heap

    @property
    def leaves_too_little(self) -> bool:
        """Return whether it takes more than the share of the heap that leaves enough for running."""
        return self.heap is not None and self.bytes > self.heap * SHARE


@once
def memory_estimate(system: System) -> Estimate | None:
    """Return the estimate of a program; None where there is none."""
    program = system.program
    if program is None:
        return None
    costs, counts, board = measured_costs(), counted(system, program), system.board
    has_machine_code = system.spec.project.machine_code
    more = costs.more(board.spec.architecture if board else "") if has_machine_code else {}
    each = {part: costs.plain[part] + more.get(part, 0) for part in Part}
    shares = [(name, bytes_of(each, Counts({part: counts[part] for part in parts}))) for name, parts in GROUPS.items()]
    memory = board.memory if board else None
    return Estimate(
        bytes=bytes_of(each, counts),
        machine_code=bytes_of(more, counts) if has_machine_code else 0,
        shares=tuple(sorted((share for share in shares if share[1]), key=lambda share: -share[1])),
        heap=None if memory is None else memory.heap - (memory.wifi if counts[Part.NETWORK] else 0),
        programs=costs.programs,
    )
