"""The commands that the vehicle answers, resolved: those of the project, those of every program, and its modes."""

import math
import struct
from collections.abc import Callable
from enum import Enum
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import EnumDefinition, EnumEntry
from codegen.model.spec.command import CommandParamSpec, CommandSpec
from codegen.model.spec.program import ModeSpec
from codegen.model.units.affine import AffineMap
from codegen.model.units.unit import Unit
from codegen.model.vehicle import Citation, Cited, Quantity

_FAR = 1 << 128
"""Beyond every float of 32 bits."""


WHOLE_IN_INT = (5, 6)
"""The parameters of which COMMAND_INT has whole numbers: x and y."""


def single(value: Fraction) -> Fraction:
    """Return the nearest float of 32 bits, which COMMAND_LONG carries."""
    return Fraction(struct.unpack("<f", struct.pack("<f", value))[0])


class Axis(Enum):
    """The coordinate of a position that a parameter is."""

    LATITUDE = 90
    LONGITUDE = 180


@dataclass(frozen=True, slots=True)
class CommandParam:
    """A parameter of a command: ``number`` 1 to 7.

    A value on the wire, which is in ``wire_unit``, becomes the method's argument, which is in ``unit``, by ``scale``.
    ``minimum`` and ``maximum`` are limits on the wire, floats of 32 bits, None where there is none; ``limits`` says
    them in words and in ``unit``. ``default`` is the argument for NaN. Of an ``enum`` the value is an entry or, where
    that is a bitmask, a sum of them. COMMAND_INT carries parameters 5 and 6 as whole numbers: of ``steps`` to one in
    ``wire_unit``, as the 1e-7 degrees of a position (``axis``), or of it, where ``steps`` is None. It says in a frame
    from where an altitude counts. For numbers of ``left`` on the wire the argument is None, and where
    ``is_none_for_nan`` for NaN. ``ends`` are the limits as they are meant, in ``unit``.
    """

    number: int
    name: str
    unit: Unit
    wire_unit: Unit
    scale: AffineMap
    minimum: Fraction | None
    maximum: Fraction | None
    limits: str
    is_whole: bool
    enum: EnumDefinition | None
    default: Fraction | None
    axis: Axis | None
    steps: Fraction | None
    is_altitude: bool
    spec: CommandParamSpec
    left: tuple[Fraction, ...] = ()
    is_none_for_nan: bool = False
    ends: tuple[Fraction | None, Fraction | None] = (None, None)

    @property
    def is_rounded(self) -> bool:
        """Return whether an argument is whole of which the wire has fractions, so that the nearest one is meant."""
        return self.is_whole and (self.steps is not None or self.scale.ratio is None or self.scale.ratio.numerator != 1)

    @property
    def int_ends(self) -> tuple[Fraction | None, Fraction | None]:
        """The limits of x or y in COMMAND_INT, whole numbers of its steps: as they are meant, not as floats."""
        steps = Fraction(1) if self.steps is None else self.steps
        to_steps = AffineMap(steps / self.scale.factor, -self.scale.pi)
        found: list[Fraction | None] = []
        sides: tuple[Callable[[Fraction], int], ...] = (math.ceil, math.floor)
        for limit, end, inward in zip((self.minimum, self.maximum), self.ends, sides, strict=True):
            if limit is None:
                found.append(None)
            elif end is None:  # of the dialect, and pi lies between its unit and that of the argument
                found.append(Fraction(inward(limit * steps) if self.steps is None else round(limit * steps)))
            else:
                found.append(Fraction(to_steps.settled(end, inward)))
        return found[0], found[1]

    @property
    def int_left(self) -> tuple[Fraction, ...]:
        """The numbers of ``left`` in COMMAND_INT: of what it multiplies those that are written, not their floats."""
        if self.steps is None:
            return self.left
        written = [each for each in self.spec.unchanged or () if isinstance(each, Fraction)]
        meant = (next((each for each in written if single(each) == value), value) for value in self.left)
        return tuple(dict.fromkeys(Fraction(round(each * self.steps)) for each in meant))

    @property
    def whole_ends(self) -> tuple[int, int] | None:
        """The ends of a whole argument where a limit on the wire, a float of 32 bits, is beyond one; None elsewhere."""
        if not self.is_whole or self.enum is not None or self.scale.ratio is None:
            return None
        found, is_beyond = [], False
        for limit, end, sign in ((self.minimum, self.ends[0], -1), (self.maximum, self.ends[1], 1)):
            if limit is None or end is None:
                found.append(sign * _FAR)
                continue
            inner = sign * math.floor(sign * end)
            found.append(inner)
            is_beyond = is_beyond or sign * round(self.scale.settled(limit, Fraction)) > sign * inner
        return (found[0], found[1]) if is_beyond else None


@dataclass(frozen=True, slots=True)
class Command(Cited):
    """A command of the project: ``name`` is its entry of MAV_CMD, ``number`` the entry's value.

    ``frames`` are the entries of MAV_FRAME that COMMAND_INT may have, none where any is accepted.
    """

    name: str
    number: int
    params: tuple[CommandParam, ...]
    frames: tuple[EnumEntry, ...]
    spec: CommandSpec


@dataclass(frozen=True, slots=True)
class Mode:
    """A mode of the vehicle: ``number`` is its custom_mode, ``base`` what is true of the vehicle in it."""

    number: int
    name: str
    base: tuple[Quantity, ...]
    citation: Citation | None
    spec: ModeSpec


class Needs(Enum):
    """The feature that a project must have, so that a command of every program is answered."""

    NOTHING = "nothing"
    ARMING = "arming"
    MODES = "modes"


@dataclass(frozen=True, slots=True)
class BuiltInCommand:
    """A command that programs answer by themselves.

    ``method`` is the one of templates/firmware/program/commands.py.j2, None for a command that another module answers.
    ``configured`` says where a project decides about it.
    """

    name: str
    doc: str
    method: str | None
    needs: Needs = Needs.NOTHING
    configured: str = "every program answers it by itself"


BUILT_IN = (
    BuiltInCommand("MAV_CMD_REQUEST_MESSAGE", "Sends a message once.", "_request_message"),
    BuiltInCommand("MAV_CMD_SET_MESSAGE_INTERVAL", "Sets how often a message is sent.", "_set_interval"),
    BuiltInCommand("MAV_CMD_GET_MESSAGE_INTERVAL", "Tells how often a message is sent.", "_get_interval"),
    BuiltInCommand("MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES", "Sends AUTOPILOT_VERSION once.", "_request_capabilities"),
    BuiltInCommand("MAV_CMD_REQUEST_PROTOCOL_VERSION", "Sends PROTOCOL_VERSION once.", "_request_protocol_version"),
    BuiltInCommand(
        "MAV_CMD_COMPONENT_ARM_DISARM",
        "Arms or disarms the vehicle.",
        "_arm_disarm",
        Needs.ARMING,
        "arming in vehicle.yaml says how the vehicle is armed, and check_arming() of its code what speaks against it",
    ),
    BuiltInCommand("MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN", "Restarts the board.", "_reboot"),
    BuiltInCommand("MAV_CMD_PREFLIGHT_STORAGE", "Gives all parameters their defaults.", "_do_rarely"),
    BuiltInCommand("MAV_CMD_RUN_PREARM_CHECKS", "Tells what speaks against arming.", "_do_rarely", Needs.ARMING),
    BuiltInCommand(
        "MAV_CMD_DO_SET_MODE",
        "Changes to one of the modes.",
        None,
        Needs.MODES,
        "modes in vehicle.yaml declares them, and check_mode() of the vehicle's code says what speaks against one",
    ),
)
"""The commands that programs answer by themselves, in the order of the firmware's table."""
