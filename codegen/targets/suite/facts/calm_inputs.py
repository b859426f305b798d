"""Counts for the inputs that checks of the program leave alone: with them no failsafe on what is measured holds."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from codegen.model.quantities.conversion import Factor, factors_by_instance
from codegen.model.system import System
from codegen.model.vehicle import Reading
from codegen.targets.firmware.readings.board import reader_views

PARTS = 32
"""A count is so many parts of the full scale, which leaves values between most pairs of thresholds."""
ORDER = (0, *range(20, PARTS), *range(19, 0, -1))


class CalmInput(NamedTuple):
    """The GPIO number of an input, and what its converter shows there, of 16 bits."""

    gpio: int
    shown: int


def calm_inputs(system: System) -> tuple[CalmInput, ...]:
    """The inputs at which 0 calls for something; those of plain readings are left out, as checks set their counts."""
    return tuple(dict.fromkeys(each for each in _inputs(system) if each.shown))


def _inputs(system: System) -> Iterator[CalmInput]:
    for reading, reader in zip(system.readings(), reader_views(system), strict=True):
        if reading.is_plain:
            continue
        component, conversion = reading.component, reading.conversion
        by_factor = [factors_by_instance(each, system.parameters, component.instances) for each in conversion.factors]
        for instance, gpio in enumerate(system.gpios(component, conversion.channel)):
            factors = [each[instance] for each in by_factor]
            yield CalmInput(gpio, _calm_count(reading, factors, system) << reader.spare_bits)


def _calm_count(reading: Reading, factors: Sequence[Factor], system: System) -> int:
    """The first count of which the value is beyond no threshold and no limit; 0 where there is none.

    Where only what is computed of it is watched, it is one from the middle.
    """
    conversion, quantity, threshold = reading.conversion, reading.quantity, reading.quantity.derivation.threshold
    steps = [factor.default for factor in factors]
    failsafes = system.program.failsafes if system.program else ()
    watched = [each for one in failsafes for each in (*one.conditions, *one.to_arm)]
    conditions = [each for each in watched if each.quantity is quantity]
    counts: list[int] = [conversion.channel.full_scale * part // PARTS for part in ORDER]
    if not conditions:
        others = [each.quantity for each in watched if each.quantity and each.quantity.component == quantity.component]
        return counts[1] if any(quantity.name in other.derivation.sources for other in others) else 0
    for count in counts:
        value = conversion.stored(count, *steps)
        is_within = quantity.minimum <= value <= quantity.maximum
        is_warned = threshold is not None and value > min(threshold.above)
        if is_within and not is_warned and all(each.rests_at(value) for each in conditions):
            return count
    return 0
