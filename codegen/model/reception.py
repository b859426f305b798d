"""A message that is received into quantities, resolved: the inverse of a populated one."""

import math
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.answers.scaling import rounded
from codegen.model.dialect.dialect import Kind, SentinelForm, WireField, WireMessage
from codegen.model.spec.receive import Otherwise, ReceivedFieldSpec, ReceiveSpec
from codegen.model.vehicle import Citation, Cited, Quantity, QuantityKind

SYSTEM_FIELDS = ("target_system", "target")
"""The fields that say which system a message is for; MANUAL_CONTROL has the second name for it."""
COMPONENT_FIELD = "target_component"


@dataclass(frozen=True, slots=True)
class Proviso:
    """A demand on another field of whole numbers, without which a received one is no value.

    ``numbers`` are masks where it ``is_of_flags``: all have to be set, and where it ``is_denied`` none may be. Others
    are numbers on the wire of which it has to have one, or none. ``names`` are these as the table has them.
    """

    field: WireField
    numbers: tuple[int, ...]
    names: tuple[str, ...]
    is_of_flags: bool
    is_denied: bool

    def holds(self, number: int) -> bool:
        """Return whether the field says so with a number on the wire."""
        met = [number & each == each if self.is_of_flags else number == each for each in self.numbers]
        if self.is_denied:
            return not any(met)
        return all(met) if self.is_of_flags else any(met)

    @property
    def words(self) -> str:
        """``when flags has ADSB_FLAGS_VALID_COORDS (1)``, for people."""
        pairs = zip(self.names, self.numbers, strict=True)
        shown = [name if name == str(number) else f"{name} ({number})" for name, number in pairs]
        joined = (" and " if self.is_of_flags and not self.is_denied else " or ").join(shown)
        return (
            f"{'unless' if self.is_denied else 'when'} {self.field.name} {'has' if self.is_of_flags else 'is'} {joined}"
        )


@dataclass(frozen=True, slots=True)
class ReceivedField:
    """An element of a field, and the quantity that it sets to ``number * factor`` stored steps, rounded.

    Numbers on the wire from ``low`` to ``high`` are taken, others are counted; of a text both are 0. Before that,
    those of ``unchanged`` leave the quantity as it was, and those of ``absent`` set it unknown, as the sentinel does.
    Where one of ``provisos`` does not hold it is no value, whatever its number.
    """

    field: WireField
    element: int
    quantity: Quantity
    factor: Fraction
    low: Fraction
    high: Fraction
    spec: ReceivedFieldSpec
    citation: Citation
    unchanged: tuple[int | float, ...] = ()
    absent: tuple[int | float, ...] = ()
    provisos: tuple[Proviso, ...] = ()

    @property
    def is_kept_otherwise(self) -> bool:
        """Return whether the quantity stays as it was where a proviso does not hold."""
        return self.quantity.kind is QuantityKind.BOOLEAN or self.spec.otherwise is Otherwise.UNCHANGED

    @property
    def proviso_words(self) -> str:
        """Return the demands on other fields without which it is no value, for people, or nothing."""
        return ", ".join(each.words for each in self.provisos)

    @property
    def label(self) -> str:
        """``chan1_raw`` or ``voltages[2]``."""
        return self.field.name if self.is_text else self.field.label(self.element, 1)

    @property
    def offset(self) -> int:
        """Return where it begins in the payload."""
        return self.field.offset + self.element * self.field.type.size

    @property
    def is_text(self) -> bool:
        """Return whether it is characters."""
        return self.field.type.kind is Kind.CHAR

    @property
    def is_extension(self) -> bool:
        """Return whether the field is an extension, which frames of MAVLink 1 lack."""
        return self.field.definition.is_extension

    @property
    def sentinel(self) -> int | float | None:
        """The number on the wire that means unknown; None for one that here leaves the quantity as it was."""
        sentinel = self.field.sentinel
        number = sentinel.values[self.speaking[0]] if sentinel else None
        return None if self.speaks_for_itself and _words(number) in map(_words, self.unchanged) else number

    @property
    def special(self) -> tuple[int | float, ...]:
        """The finite numbers of its own that set no value."""
        own = (self.sentinel,) if self.speaks_for_itself else ()
        numbers = (*self.unchanged, *self.absent, *own)
        return tuple(number for number in numbers if number is not None and math.isfinite(number))

    @property
    def is_kept_by_nan(self) -> bool:
        """Return whether NaN, and what is infinite, leave the quantity as it was."""
        return any(math.isnan(number) for number in self.unchanged)

    @property
    def is_unknown_by_nan(self) -> bool:
        """Return whether NaN, which only floats can be, sets the quantity unknown."""
        return self.field.type.kind is Kind.FLOAT and not self.is_kept_by_nan

    @property
    def is_kept_by_absence(self) -> bool:
        """Return whether a frame that lacks the field leaves the quantity as it was: what it lacks reads as 0."""
        return self.quantity.kind is QuantityKind.BOOLEAN or 0 in self.unchanged

    @property
    def speaking(self) -> tuple[int, ...]:
        """The elements whose numbers say that this one is unknown.

        Its own, the first one for the whole array, or all of the array together.
        """
        form = self.field.sentinel.form if self.field.sentinel else None
        if form is SentinelForm.FIRST:
            return (0,)
        return tuple(range(self.field.count)) if form is SentinelForm.VALUE and not self.is_text else (self.element,)

    @property
    def speaks_for_itself(self) -> bool:
        """Return whether its own number alone says that it is unknown."""
        return self.speaking == (self.element,)

    def kept(self, number: int | Fraction) -> int | Fraction:
        """Return what the quantity is, in stored units, after a number on the wire that is taken."""
        if self.quantity.kind is QuantityKind.BOOLEAN:
            return int(number != 0)
        if self.quantity.storage.is_float:
            return Fraction(number)
        return rounded(Fraction(number) * self.factor, self.spec.rounding)

    @property
    def ends(self) -> tuple[Fraction, Fraction]:
        """The smallest and the largest number that set a value: a sentinel at an end of an integer field does not."""
        low, high = self.low, self.high
        if self.field.type.is_integer and self.quantity.kind is not QuantityKind.BOOLEAN:
            special = self.special
            while low in special and low < high:
                low += 1
            while high in special and low < high:
                high -= 1
        return low, high

    @property
    def range_words(self) -> str:
        """``1000..2000 us``, what is taken, for people; nothing for a text."""
        return self._from_to(self.ends)

    @property
    def limit_words(self) -> str:
        """``0..65535 us``, what is plausible, special values among it, for people; nothing for a text."""
        return self._from_to((self.low, self.high))

    def _from_to(self, ends: tuple[Fraction, Fraction]) -> str:
        if self.is_text:
            return ""
        words = [str(int(end)) if self.field.type.is_integer else f"{float(end):.7g}" for end in ends]
        return f"{'..'.join(words)} {self.field.unit_text}".rstrip()

    @property
    def sentinel_words(self) -> str:
        """The numbers that set the quantity unknown, for people, or nothing."""
        if self.quantity.kind is QuantityKind.BOOLEAN:
            return ""
        if self.is_text:
            return "" if self.sentinel is None else "the empty text"
        return ", ".join(
            dict.fromkeys(_words(number) for number in (self.sentinel, *self.absent) if number is not None)
        )

    @property
    def unchanged_words(self) -> str:
        """The numbers that leave the quantity as it was, for people, or nothing."""
        return ", ".join(map(_words, self.unchanged))


def _words(number: float | None) -> str:
    if number is None:
        return ""
    return "NaN" if math.isnan(number) else f"{number:g}" if isinstance(number, float) else str(number)


@dataclass(frozen=True, slots=True)
class Reception(Cited):
    """A table: a message, and the fields of it that set quantities, in the order of their offsets.

    ``conditions`` are scalar fields of whole numbers with the number that each has to have.
    """

    wire: WireMessage
    fields: tuple[ReceivedField, ...]
    conditions: tuple[tuple[WireField, int], ...]
    spec: ReceiveSpec

    @property
    def name(self) -> str:
        """Return what its table is called."""
        return self.spec.name

    @property
    def title(self) -> str:
        """``RC_CHANNELS_OVERRIDE (70)``, or with a name of the table's own ``stick: MANUAL_CONTROL (69)``."""
        message = f"{self.wire.name} ({self.wire.id})"
        return message if self.name == self.wire.name else f"{self.name}: {message}"

    @property
    def targets(self) -> tuple[WireField | None, WireField | None]:
        """The fields with the system and with the component that it is for."""
        system = next((field for name in SYSTEM_FIELDS if (field := self.wire.field(name))), None)
        return system, self.wire.field(COMPONENT_FIELD)

    def looks_at(self, name: str, taken: ReceivedField) -> bool:
        """Return whether what another field says of one is heeded: by the table, by its own provisos, or by code.

        ``when: {}`` says that nothing is to be heeded.
        """
        if taken.spec.when == {} or any(each.field.name == name for each in taken.provisos):
            return True
        return any(each.field.name == name for each in self.fields) or any(
            field.name == name for field, _ in self.conditions
        )

    @property
    def has_extensions(self) -> bool:
        """Return whether it takes fields that MAVLink 1 does not have."""
        return any(field.is_extension for field in self.fields)
