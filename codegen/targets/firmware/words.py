"""The layout of the state: 32-bit words in one array, a block of them for each instance of each component.

A number, an enum's value and a boolean take one word; what is unknown is -2 ** 30 there, less than every limit, and the
largest magnitude that 32-bit boards read without allocating. What a small integer does not hold takes a word for every
16 bits, the low ones first (codegen/model/code/storage.py); while it is unknown, the first of them is -2 ** 30. A
quantity with elements takes the words of each, one element behind the other, last of all.
"""

from collections.abc import Iterator, Mapping

from codegen.frozen import dataclass
from codegen.model.quantities.conversion import Factor
from codegen.model.quantities.set_together import set_together
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, Quantity, Reading
from codegen.once import once
from codegen.targets.firmware.readings.sum_words import sum_words
from codegen.targets.naming import family_constant


@dataclass(frozen=True, slots=True)
class Block:
    """The words of one component: the first instance from ``base`` on, each of them takes ``size``.

    ``offsets`` has the place of each word in the block of an instance, by name. ``base_constant`` is ``_BATTERY``,
    where the words of the first instance begin in the array, and ``size_constant`` ``_BATTERY_SIZE``, what one takes.
    """

    component: Component
    base: int
    size: int
    offsets: Mapping[str, int]
    base_constant: str
    size_constant: str
    constants: Mapping[str, str]

    def constant(self, word: str) -> str:
        """``_BATTERY_VOLTAGE_MV``, the place of a word in the block of an instance."""
        return self.constants.get(word, f"{self.base_constant}_{word.upper()}")


@dataclass(frozen=True, slots=True)
class ConstantView:
    """A constant of a generated module."""

    name: str
    value: int


@dataclass(frozen=True, slots=True)
class Layout:
    """The whole array: a block for each component, by name, and how many words there are."""

    blocks: Mapping[str, Block]
    size: int

    def places(self, component: str, word: str) -> tuple[int, ...]:
        """Return where a word of each instance stands in the array."""
        block = self.blocks[component]
        return tuple(block.base + block.size * at + block.offsets[word] for at in range(block.component.instances))

    def constants(self, component: str, words: set[str], *, in_array: bool) -> tuple[ConstantView, ...]:
        """The constants with which a module reaches words of a component, in their order.

        ``in_array``: from the whole array; else from the part of an instance.
        """
        block = self.blocks[component]
        placed = [ConstantView(block.constant(word), at) for word, at in block.offsets.items() if word in words]
        if not in_array:
            return tuple(placed)
        several = [ConstantView(block.size_constant, block.size)] if block.component.instances > 1 else []
        return (ConstantView(block.base_constant, block.base), *several, *placed)


@once
def word_layout(system: System) -> Layout:
    """The layout of a system's state."""
    blocks: dict[str, Block] = {}
    base = 0
    names = _Names(system)
    for component in system.components.values():
        offsets: dict[str, int] = {}
        size = 0
        for name, width in _words(component):
            offsets[name] = size
            size += width
        own = names.free(f"_{component.name}"), names.free(f"_{component.name}_size")
        constants = {word: names.free(f"_{component.name}_{word}", component.instances) for word in offsets}
        blocks[component.name] = Block(component, base, size, offsets, *own, constants)
        base += size * component.instances
    return Layout(blocks, base)


OWN_CONSTANTS = frozenset(
    (
        *("_SIZE", "_AGED", "_UNKNOWN", "_FAILURES", "_LONGEST_US", "_TOTAL_US", "_READINGS", "_LONG", "_OWN"),
        *("_LENGTHS", "_LOOK_MS", "_WITHHELD", "_FURTHEST_MS", "_TICKS", "_DUE_MS", "_LATE_BY", "_PERIOD", "_PARTS"),
        *("_STEP", "_IDS", "_STREAMS", "_SHORTEST_US", "_GENERATIONS", "_NUMBER_AT", "_DATA_STREAMS", "_FASTEST_HZ"),
        *("_ENCODERS", "_SENDERS", "_TELLS", "_ANNOUNCED", "_MESSAGES", "_ON_CONNECTION", "_JOBS", "_SAVE_MS"),
        *("_UNSETTLED_MS", "_COST_MS", "_CREDIT_MS", "_LEAVE_MS", "_REMIND_S", "_FAREWELL_MS"),
    )
)
"""The constants that the modules have beside those of words, as their templates are written."""


class _Names:
    """The names of constants, each of which is taken once: MicroPython refuses a second one, and CPython takes it."""

    def __init__(self, system: System) -> None:
        self._taken = set(OWN_CONSTANTS)
        self._taken |= {family_constant(each) for each in system.parameters.values() if each.siblings}
        for component in system.components.values():
            for quantity in component.quantities.values():
                if quantity.derivation.curves_by_instance:
                    self._taken.add(curve_constant(quantity, component))

    def free(self, name: str, instances: int = 1) -> str:
        """Return a name for a constant, with underscores behind it until it, and those by instance, are free."""
        name = name.upper()
        of_each = range(1, instances + 1) if instances > 1 else ()
        while (own := {name, *(f"{name}_{number}" for number in of_each)}) & self._taken:
            name += "_"
        self._taken |= own
        return name


def curve_constant(quantity: Quantity, component: Component) -> str:
    """``_BATTERY_REMAINING_CURVE``, or ``CURVES``: the points of an estimate."""
    return f"_{component.name}_{quantity.name}_curve{'s' if component.instances > 1 else ''}".upper()


def _words(component: Component) -> Iterator[tuple[str, int]]:
    """The names and widths of a component's words, in their order."""
    quantities = component.quantities.values()
    for quantity in quantities:
        if quantity.elements is None and not quantity.is_computed:
            yield quantity.attribute, quantity.words
        if quantity.ages:
            yield age_word(quantity), 1
        own = {"limit": quantity.derivation.own_limits, "floor": quantity.derivation.own_floors}
        yield from ((f"{quantity.name}_{word}", 1) for word, values in own.items() if differ(values))
        if differ(quantity.derivation.back_from):
            yield f"{quantity.name}_back_from", 1
    if component.first_number:
        yield "number", 1
    if any(quantity.derivation.counts_time for quantity in quantities):
        yield from CLOCK_WORDS
    yield from _of_readings(component)
    for quantity in quantities:
        if quantity.elements is not None:
            yield from _of_list(quantity, quantity.elements)


def _of_list(quantity: Quantity, elements: tuple[int, ...]) -> Iterator[tuple[str, int]]:
    """The words of a list: those beside its values come first."""
    if differ(elements):
        yield f"{quantity.attribute}_count", 1
    if quantity.ages_by_readings:
        yield f"{quantity.attribute}_age", 1
    yield quantity.attribute, quantity.storage.words * max(elements)


@dataclass(frozen=True, slots=True)
class AgedWords:
    """The words of what is forgotten so long after it was set, by their places in the whole array.

    ``count`` words from ``place`` on have the value, and the one at ``expires`` what age_word() names.
    """

    place: int
    count: int
    expires: int


def aged_words(layout: Layout) -> Iterator[AgedWords]:
    """Yield what is forgotten with time, of each instance."""
    for block in layout.blocks.values():
        for quantity in block.component.quantities.values():
            if not quantity.ages:
                continue
            count = quantity.storage.words * max(quantity.elements) if quantity.elements else quantity.words
            for instance in range(block.component.instances):
                base = block.base + instance * block.size
                at, expires = block.offsets[quantity.attribute], block.offsets[age_word(quantity)]
                yield AgedWords(base + at, count, base + expires)


def age_word(quantity: Quantity) -> str:
    """The word with the time until which what code has set is believed, in ms; unknown is for ever."""
    return f"{quantity.attribute}_expires_ms"


def _of_readings(component: Component) -> Iterator[tuple[str, int]]:
    """The words that readings need beside the values that they give."""
    for reading in component.readings:
        words = ["count", *FACTOR_WORDS[: len(reading.conversion.factors)], "failures", "is_logged"]
        constant = [word for word, factor in factor_words(reading) if not isinstance(factor, Parameter)]
        yield from ((reading.word(word), 1) for word in words if word not in constant)
        decided = {"is_read": reading.is_conditional, "is_set": reading.quantity.derivation.represented}
        yield from ((reading.word(word), 1) for word, is_there in decided.items() if is_there)
        if reading.quantity.trust.stale_after_ms is not None:
            yield reading.word("expires_ms"), 1
        threshold = reading.quantity.derivation.threshold
        if threshold is not None:
            yield reading.word("warned_ms"), 1
            if differ(threshold.above):
                yield reading.word("warn_above"), 1
        if reading.returns:
            yield "gone", 1
            if set_together(component):
                yield SET_AGE, 1
        yield from ((word, 1) for word in sum_words(reading))
    for basis in component.counted_on:
        yield from ((word, 1) for word in sum_words(basis))
    for quantity in component.quantities.values():
        if quantity.derivation.kept_readings:
            yield from ((f"{quantity.name}_{word}", 1) for word in TREND_WORDS)
            yield f"{quantity.name}_readings", quantity.derivation.kept_readings


SET_AGE = "set_age"
"""The number of readings since code has set one of those forgotten together; unknown is never, or long ago."""

FACTOR_WORDS = ("multiplier", "offset")


def factor_words(reading: Reading) -> tuple[tuple[str, Factor], ...]:
    """The factors of a reading with the names of their words, which constants do not have."""
    return tuple(zip(FACTOR_WORDS, reading.conversion.factors, strict=False))


CLOCK_WORDS = (("last_us", 1), ("last_ms", 1), ("boot_ms", 4), ("unix_ms", 4))
"""The further words of clocks that count in microseconds; clock_viper.py and clock_plain.py know their order."""

TREND_WORDS = ("count", "newer", "older")
"""The further words of a trend beside its readings: their number, and the sums of the two halves."""


def differ(numbers: tuple[int, ...]) -> bool:
    """Return whether instances have numbers of their own."""
    return len(set(numbers)) > 1
