"""A message that is received into quantities, resolved: the inverse of a populated one."""

import math
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.answers.scaling import rounded
from codegen.model.dialect.dialect import Kind, SentinelForm, WireField, WireMessage
from codegen.model.spec.receive import ReceivedFieldSpec, ReceiveSpec
from codegen.model.vehicle import Citation, Cited, Quantity, QuantityKind

SYSTEM_FIELDS = ("target_system", "target")
"""The fields that say which system a message is for; MANUAL_CONTROL has the second name for it."""
COMPONENT_FIELD = "target_component"


@dataclass(frozen=True, slots=True)
class ReceivedField:
    """An element of a field, and the quantity that it sets to ``number * factor`` stored steps, rounded.

    Numbers on the wire from ``low`` to ``high`` are taken, others are counted; of a text both are 0.
    """

    field: WireField
    element: int
    quantity: Quantity
    factor: Fraction
    low: Fraction
    high: Fraction
    spec: ReceivedFieldSpec
    citation: Citation

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
        """The number on the wire that means unknown."""
        sentinel = self.field.sentinel
        return sentinel.values[self.speaking] if sentinel else None

    @property
    def speaking(self) -> int:
        """The element whose number says that this one is unknown: its own, or the first one for the whole array."""
        sentinel = self.field.sentinel
        return 0 if sentinel and sentinel.form is SentinelForm.FIRST else self.element

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
            return low + (low == self.sentinel), high - (high == self.sentinel)
        return low, high

    @property
    def range_words(self) -> str:
        """``1000..2000 us``, what is taken, for people; nothing for a text."""
        if self.is_text:
            return ""
        ends = [str(int(end)) if self.field.type.is_integer else f"{float(end):.7g}" for end in self.ends]
        return f"{'..'.join(ends)} {self.field.unit_text}".rstrip()

    @property
    def sentinel_words(self) -> str:
        """The number that sets the quantity unknown, for people, or nothing."""
        sentinel = self.sentinel
        if sentinel is None or self.quantity.kind is QuantityKind.BOOLEAN:
            return ""
        if self.is_text:
            return "the empty text"
        return "NaN" if math.isnan(sentinel) else f"{sentinel:g}" if isinstance(sentinel, float) else str(sentinel)


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

    @property
    def has_extensions(self) -> bool:
        """Return whether it takes fields that MAVLink 1 does not have."""
        return any(field.is_extension for field in self.fields)
