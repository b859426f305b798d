"""Physical values of the counts of the converter, by the conversions of the project."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.quantities.conversion import Conversion, Factor, factors_by_instance
from codegen.model.system import System
from codegen.model.units.unit import Unit, ratio, unit_named
from codegen.model.vehicle import Parameter, Quantity

_VOLT = unit_named("V")


@dataclass(frozen=True, slots=True)
class Measured:
    """A quantity that the converter measures, of one instance, with the ``factors`` of its conversion."""

    quantity: Quantity
    conversion: Conversion
    factors: tuple[Factor, ...]

    def value(self, count: Fraction, factors: Mapping[str, Fraction], unit: Unit) -> Fraction | None:
        """Return the exact value of a count in a unit; factors that are not given by name have their defaults."""
        return self._in(unit, self.conversion.exact, count, factors)

    def kept(self, count: Fraction, factors: Mapping[str, Fraction], unit: Unit) -> Fraction | None:
        """The same as the state keeps it, rounded to its steps."""
        return self._in(unit, self.conversion.stored, count, factors)

    def at_pin(self, count: Fraction, unit: Unit) -> Fraction | None:
        """The voltage at the pin of the converter that a count stands for; None in a unit of something else."""
        channel, factor = self.conversion.channel, ratio(_VOLT, unit)
        return None if factor is None else count * channel.reference / channel.full_scale * factor

    def takes(self, names: Iterable[str]) -> bool:
        """Return whether all of these names are names of factors."""
        return set(names) <= {factor.name for factor in self.factors}

    @property
    def first(self) -> str:
        """The name of the multiplier."""
        return self.factors[0].name

    def _in(
        self, unit: Unit, turned: Callable[..., int | Fraction], count: Fraction, factors: Mapping[str, Fraction]
    ) -> Fraction | None:
        own = self.quantity
        factor = ratio(own.unit, unit)
        steps = [
            Fraction(each.default) if each.name not in factors else factors[each.name] / each.step
            for each in self.factors
        ]
        if factor is None or count.denominator != 1 or any(each.denominator != 1 for each in steps):
            return None
        return Fraction(turned(int(count), *(int(each) for each in steps))) / own.steps * factor


def measured(systems: Iterable[System], unit: Unit | None, names: Iterable[str] = ()) -> tuple[Measured, ...]:
    """Return the measured quantities with the dimension of ``unit`` (None: any) that have factors of these names."""
    wanted = tuple(names)
    found = (each for system in systems for each in _measured(system))
    return tuple(
        each
        for each in found
        if each.takes(wanted) and (unit is None or unit.dimension == each.quantity.unit.dimension)
    )


def _measured(system: System) -> Iterator[Measured]:
    for reading in system.readings():
        count = reading.component.instances
        sets = (factors_by_instance(each, system.parameters, count) for each in reading.conversion.factors)
        for factors in zip(*sets, strict=True):
            yield Measured(reading.quantity, reading.conversion, factors)


def factor_names(systems: Iterable[System]) -> frozenset[str]:
    """The names of the parameters that conversions take."""
    found = (each for system in systems for each in _measured(system))
    return frozenset(factor.name for each in found for factor in each.factors if isinstance(factor, Parameter))
