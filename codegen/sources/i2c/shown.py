"""The registers of monitors in the generated suite for a voltage and a current, by their data sheets."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.quantities.device import Device, Exact, Shown
from codegen.model.units.unit import unit_named

_SHARES = ((Fraction(5, 13), Fraction(3, 7)), (Fraction(7, 13), Fraction(-5, 7)), (Fraction(2, 13), Fraction(-1, 21)))
"""Of all that the registers for bus and shunt can show: each scene has both."""


@dataclass(frozen=True, slots=True)
class Sheet:
    """Numbers of a data sheet: registers after a ``reset`` with their values, and those that are ``read_only``.

    A step of the register for the bus is so many ``volts``, above ``bus_shift`` bits, in which ``bus_flags`` say that a
    conversion has ended; one of the register for the shunt is so many volts ``across`` it, in two's complement.
    ``averages`` are numbers of conversions with their code, which stands at ``setting_shifts`` of register 0, where the
    bits of ``setting_mask`` have ``setting`` else.
    """

    reset: dict[int, int]
    read_only: tuple[int, ...]
    volts: Fraction
    bus_shift: int
    bus_flags: int
    most_bus: int
    across: Fraction
    most_across: int
    averages: tuple[tuple[int, int], ...]
    setting_mask: int
    setting: int
    setting_shifts: tuple[int, ...]


def monitor_device(sheet: Sheet, place: tuple[int, int], shunt: Fraction, average: int, number: int) -> Device:
    """The monitor at a bus and an address, with a shunt of so many Ohm; ``number`` makes its amounts other ones."""
    bus, address = place
    code = dict(sheet.averages)[average]
    setting = sheet.setting | sum(code << shift for shift in sheet.setting_shifts)
    settings = {
        "bus": bus,
        "address": address,
        "reset": sorted(sheet.reset.items()),
        "read_only": sheet.read_only,
        "setting": [sheet.setting_mask, setting],
    }
    return Device("monitor_device", settings, tuple(_shown(sheet, shunt, number, shares) for shares in _SHARES))


def _shown(sheet: Sheet, shunt: Fraction, number: int, shares: tuple[Fraction, Fraction]) -> Shown:
    of_bus, of_shunt = shares
    bus = int(sheet.most_bus * of_bus) - 37 * (number % 16)
    across = int(sheet.most_across * of_shunt) + 53 * (number % 16)
    volts, amperes = bus * sheet.volts, across * sheet.across / shunt
    registers = [[1, across & 0xFFFF], [2, bus << sheet.bus_shift | sheet.bus_flags]]
    return Shown(
        {"registers": registers},
        {
            "voltage": Exact(volts, unit_named("V")),
            "current": Exact(amperes, unit_named("A")),
            "power": Exact(volts * amperes, unit_named("W")),
        },
    )
