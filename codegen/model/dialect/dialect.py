"""A dialect as its XML files state it, before includes are read and wire order is computed."""

from collections.abc import Iterator
from dataclasses import field
from enum import Enum
from fractions import Fraction
from typing import NamedTuple

from codegen.frozen import dataclass
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class Lifecycle:
    """The lifecycle of a message, enum or entry: ``wip``, ``deprecated`` and ``superseded``."""

    wip: bool = False
    deprecated_since: str | None = None
    superseded_since: str | None = None
    replaced_by: str | None = None
    remark: str = ""


IN_USE = Lifecycle()
"""The lifecycle of a definition that the dialect neither deprecates nor marks as work in progress."""


class CommandParameter(NamedTuple):
    """One ``<param>`` of a command, an entry of MAV_CMD.

    ``number``, the attribute index, and ``attributes`` (label, units, enum, minValue, reserved ...) are as written.
    """

    number: str
    attributes: tuple[tuple[str, str], ...]
    description: str
    place: Place


class EnumEntry(NamedTuple):
    """One entry of an enum; ``value`` is the number of the XML (``0x``, ``0b`` and ``2**n`` already read).

    ``is_implicit`` marks an entry without a ``value`` attribute: the previous value plus one, as mavgen does.
    ``traits`` are further attributes as written, such as hasLocation; like ``parameters`` they belong to commands.
    """

    name: str
    value: int
    description: str
    place: Place
    lifecycle: Lifecycle = IN_USE
    is_implicit: bool = False
    parameters: tuple[CommandParameter, ...] = ()
    traits: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True, slots=True)
class EnumDefinition:
    """An enum of one XML file, or, after resolving, of the whole dialect (entries of all files merged)."""

    name: str
    entries: tuple[EnumEntry, ...]
    is_bitmask: bool
    description: str
    place: Place
    lifecycle: Lifecycle = IN_USE

    def entry(self, name: str) -> EnumEntry | None:
        """The entry called ``name``, or None."""
        return next((entry for entry in self.entries if entry.name == name), None)


class FieldDefinition(NamedTuple):
    """One ``<field>`` in XML order. Attributes are as written; None where the attribute is absent.

    ``type`` is the element type (``uint16_t``), ``length`` the number of elements or None for a scalar.
    ``maximum``, ``minimum``, ``increment``, ``default``, ``multiplier`` and ``invalid`` keep their text: their meaning
    depends on the type. All but ``multiplier`` are numbers on the wire. ``unchanged`` and ``unknown``, which only
    corrections state, are numbers on the wire too, with commas between them: to who receives the field these say that
    nothing changes, and that there is no value.
    """

    name: str
    type: str
    length: int | None
    is_extension: bool
    place: Place
    units: str | None = None
    enum: str | None = None
    is_bitmask: bool = False
    is_instance: bool = False
    multiplier: str | None = None
    minimum: str | None = None
    maximum: str | None = None
    invalid: str | None = None
    print_format: str | None = None
    description: str = ""
    increment: str | None = None
    default: str | None = None
    unchanged: str | None = None
    unknown: str | None = None


MAX_MESSAGE_ID = 0xFFFFFF
UNNUMBERED = -1
"""The id of a message whose XML writes none that can be read, until a correction states one."""


@dataclass(frozen=True, slots=True)
class MessageDefinition:
    """One ``<message>``, fields in XML order.

    ``written_id`` is the text of an id that cannot be read; ``id_place`` is the correction that states the id, if one
    does.
    """

    id: int
    name: str
    fields: tuple[FieldDefinition, ...]
    description: str
    place: Place
    lifecycle: Lifecycle = IN_USE
    written_id: str | None = None
    id_place: Place | None = None


@dataclass(frozen=True, slots=True)
class Include:
    """One ``<include>`` as written: a path relative to the file that holds it."""

    path: str
    place: Place


@dataclass(frozen=True, slots=True)
class DialectFile:
    """One XML file: ``version`` and ``number`` are its ``<version>`` and ``<dialect>``.

    ``is_overlay`` marks a file of the project's own that adds to the dialect.
    """

    path: str
    version: int | None
    number: int | None
    includes: tuple[Include, ...]
    enums: tuple[EnumDefinition, ...]
    messages: tuple[MessageDefinition, ...]
    is_overlay: bool = False


@dataclass(frozen=True, slots=True)
class KnownMessage:
    """A message of a dialect that the project does not use, where its name or id is taken."""

    id: int
    name: str
    place: Place


class Standing(Enum):
    """The standing of a correction: it holds, the project refuses it, or its words are gone from the dialect."""

    APPLIED = "applied"
    REFUSED = "refused"
    OUTDATED = "outdated"


class AttributeCorrection(NamedTuple):
    """A correction of one attribute: its new text, and the one ``before`` (None: there was none).

    It is an attribute of the field ``part`` of the message ``owner``, of the message itself (``part`` is empty), of the
    entry ``part`` of an enum, or of the parameter with the number ``part`` of a command.

    ``grounds`` are the reason that a project gives, with its ``source``; of a correction that comes with codegen the
    words of the dialect, which stand in the element at ``stated``. ``refusal`` is the reason of one, and its place.
    """

    owner: str
    part: str
    attribute: str
    text: str
    before: str | None
    grounds: str
    place: Place
    standing: Standing = Standing.APPLIED
    source: str = ""
    stated: Place | None = None
    refusal: tuple[str, Place] | None = None

    @property
    def is_shipped(self) -> bool:
        """Return whether it comes with codegen."""
        return not self.source


class Kind(Enum):
    """The kind of value that the bytes of a wire type encode."""

    UNSIGNED = "unsigned"
    SIGNED = "signed"
    FLOAT = "float"
    CHAR = "char"


@dataclass(frozen=True, slots=True)
class WireType:
    """An element type of the wire: size in bytes, ``struct`` code (little-endian), name hashed into CRC_EXTRA.

    ``minimum`` and ``maximum`` bound what an integer type can hold; both are 0 for float types.
    """

    name: str
    size: int
    code: str
    kind: Kind
    minimum: int
    maximum: int

    @property
    def is_integer(self) -> bool:
        """Return whether values are whole numbers with the given bounds."""
        return self.kind in (Kind.UNSIGNED, Kind.SIGNED)


class SentinelForm(Enum):
    """The form in which ``invalid`` was written: those that real dialects use."""

    VALUE = "V"
    EACH = "[V]"
    FIRST = "[V:]"
    POSITIONS = "[V1,,V3]"


@dataclass(frozen=True, slots=True)
class Sentinel:
    """The value(s) that mean "unknown" in one field.

    ``values`` has one item per element (a scalar has one): the number on the wire, NaN for floats, or None where
    that element has no sentinel. With ``FIRST`` only item 0 is set; it speaks for the whole array.
    ``written`` is the attribute as it stands in the XML or in a correction.
    """

    form: SentinelForm
    values: tuple[int | float | None, ...]
    written: str
    place: Place


@dataclass(frozen=True, slots=True)
class WireField:
    """A field with its place in the payload.

    ``offset`` is in bytes from the start of the payload, ``count`` the number of elements (1 for a scalar) and
    ``definition`` the field as the dialect (after corrections) states it. A number on the wire times ``multiplier`` is
    the value in the units of the definition.
    """

    definition: FieldDefinition
    type: WireType
    offset: int
    count: int
    sentinel: Sentinel | None
    multiplier: Fraction = Fraction(1)

    @property
    def unit_text(self) -> str:
        """Return what its numbers count, in words: ``mV``, ``steps of 1E-2``, ``steps
        of 360/255 deg``; empty for numbers.
        """
        units = self.definition.units or ""
        return units if self.multiplier == 1 else f"steps of {self.definition.multiplier} {units}".rstrip()

    @property
    def name(self) -> str:
        """The name in the dialect."""
        return self.definition.name

    @property
    def is_address(self) -> bool:
        """Return whether it can carry the id of a system or of a component."""
        is_one = self.type.kind is Kind.UNSIGNED and self.type.size == 1 and not self.is_array
        return is_one and not self.definition.units

    @property
    def is_array(self) -> bool:
        """Return whether the dialect declares an array (of one element, too)."""
        return self.definition.length is not None

    @property
    def size(self) -> int:
        """Bytes in the payload."""
        return self.type.size * self.count

    def label(self, first: int, count: int) -> str:
        """``count`` of its elements from ``first`` on: ``voltages``, ``voltages[0]`` or ``voltages[1..9]``."""
        if not self.is_array or count == self.count:
            return self.name
        return f"{self.name}[{first}]" if count == 1 else f"{self.name}[{first}..{first + count - 1}]"


@dataclass(frozen=True, slots=True)
class WireMessage:
    """A message as it goes over the wire.

    ``fields`` are in wire order (base fields by element size, then extensions as written); ``crc_extra`` is the
    byte that closes the checksum; ``base_length`` and ``length`` are payload bytes without and with extensions.
    """

    definition: MessageDefinition
    fields: tuple[WireField, ...]
    crc_extra: int
    base_length: int
    length: int

    @property
    def name(self) -> str:
        """The name in the dialect."""
        return self.definition.name

    @property
    def id(self) -> int:
        """The message id, 0 to 16777215; up to 255 the message can be sent in MAVLink 1."""
        return self.definition.id

    @property
    def targets(self) -> tuple[int, ...]:
        """Return where the payload has its target system and component, as far as it has them."""
        fields = (self.target_system, self.target_component) if self.target_system else ()
        return tuple(field.offset for field in fields if field)

    @property
    def target_system(self) -> WireField | None:
        """Return the field with the system that it is for, which MANUAL_CONTROL calls ``target``.

        In other messages that is a name for any value, such as where a servo is to go.
        """
        return self._address("target" if self.name == "MANUAL_CONTROL" else "target_system")

    @property
    def target_component(self) -> WireField | None:
        """Return the field with the component that it is for."""
        return self._address("target_component")

    def _address(self, name: str) -> WireField | None:
        found = self.field(name)
        return found if found is not None and found.is_address else None

    def field(self, name: str) -> WireField | None:
        """The field called ``name``, or None."""
        for each in self.fields:
            if each.definition.name == name:
                return each
        return None


@dataclass(frozen=True, slots=True)
class Dialect:
    """A dialect with all its includes, overlays and corrections applied.

    ``messages`` by name in order of id, ``enums`` by name, ``files`` every XML file that was read (absolute paths,
    each once), ``version`` the value of ``uint8_t_mavlink_version`` fields. ``overlays`` are those of ``files`` that
    the project adds, ``known`` the messages of other dialects that share a name or an id with a message of these.
    ``corrections`` are all that were applied, refused or outdated, of the project and those that come with codegen.
    ``digest`` is a hash of everything that it was made of; without one that is not known.
    """

    name: str
    version: int
    messages: dict[str, WireMessage]
    enums: dict[str, EnumDefinition]
    files: tuple[str, ...]
    overlays: frozenset[str] = frozenset()
    known: tuple[KnownMessage, ...] = ()
    corrections: tuple[AttributeCorrection, ...] = ()
    digest: str = field(default="", compare=False, repr=False)

    def added_messages(self) -> Iterator[WireMessage]:
        """The messages that files of the project add, in order of id."""
        return (message for message in self.messages.values() if message.definition.place.file in self.overlays)

    def corrections_of(self, owner: str, part: str) -> Iterator[AttributeCorrection]:
        """The corrections of a field, or of a parameter of a command, in the order in which they were applied."""
        return (each for each in self.corrections if (each.owner, each.part) == (owner, part))
