"""Bits of a bitmask: always set, or while a boolean of the state is true."""

from collections import Counter
from collections.abc import Iterator, Mapping

from codegen.answers.constant import fits
from codegen.answers.fitting import NOT_AN_ENUM_FIELD, field_enum
from codegen.answers.instance import bytes_of
from codegen.answers.kind import KindOfAnswer
from codegen.answers.scope import Scope
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.answers.account import FLAGS, Aspect, Origins, ReadBack, StateCase, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode
from codegen.model.code.reading import Reading, flag_names
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Component, Quantity, QuantityKind
from codegen.source import Place

NOT_A_BOOLEAN = Rule(
    "not-a-boolean",
    "Only a boolean quantity can decide whether a flag is set.",
    remedy="name a quantity with boolean: true",
)
VOID_CONDITION = Rule(
    "void-condition",
    "A flag with a condition is set without one by the same field, too, so that the condition decides nothing: the "
    "flag is always set.",
    remedy="leave out the flag that has no condition, or the condition",
)


@dataclass(frozen=True, slots=True)
class FlagsAnswer(KindOfAnswer):
    """Bits of a bitmask: ``mask`` is always set, each of ``conditional`` only while its quantity is true."""

    covers: Elements
    mask: int
    names: tuple[str, ...]
    conditional: tuple[tuple[str, int, Quantity], ...]

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``flags: [ENTRY, ENTRY if component.quantity]``."""
        return written.flags is not None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "FlagsAnswer | None":
        """Entries of the field's bitmask; those that cannot be are left out with a finding."""
        enum = field_enum(covers, "flags", scope)
        if enum is None:
            return None
        place = covers.written.at("flags")
        if not (enum.is_bitmask or covers.field.definition.is_bitmask):
            message = f"{enum.name} is not a bitmask"
            scope.report.add(NOT_AN_ENUM_FIELD, place, message, "give one entry with 'enum'")
            return None
        if not covers.field.type.is_integer:
            message = f"{covers.field.name} ({covers.field.type.name}) is no whole number, whose bits are flags"
            scope.report.add(NOT_AN_ENUM_FIELD, place, message, "give what it carries with state, or a constant")
            return None
        mask, names, conditional = 0, [], []
        for flag in covers.written.flags or ():
            name, separator, path = flag.partition(" if ")
            value = scope.entry(enum, name.strip(), place)
            quantity = condition_of(path.strip(), place, scope) if separator else None
            if (
                value is None
                or (separator and quantity is None)
                or not fits(covers, value, "flags", name, scope.report)
            ):
                continue
            if quantity is None:
                mask |= value
                names.append(name.strip())
            else:
                conditional.append((name.strip(), value, quantity))
        void = [(name, quantity) for name, value, quantity in conditional if value and not value & ~mask]
        for name, quantity in void:
            message = f"{name} is always set, so that 'if {quantity.path}' decides nothing"
            hint = f"write it once: {name} if {quantity.path}"
            scope.report.add(VOID_CONDITION, place, message, hint)
        if void:
            return None  # it is not known which of both is meant
        return cls(covers, mask, tuple(names), tuple(conditional))

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The conditions."""
        return tuple(quantity for _, _, quantity in self.conditional)

    @property
    def conditions(self) -> Mapping[int, frozenset[str]]:
        """Each bit with its conditions; what is always set has none."""
        found: dict[int, frozenset[str]] = {}
        for _, value, quantity in self.conditional:
            for bit in _bits(value & ~self.mask):
                found[bit] = found.get(bit, frozenset()) | {quantity.path}
        return {**dict.fromkeys(_bits(self.mask), frozenset[str]()), **found}

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The bits of those conditions that hold, in each element."""
        mask = self.mask
        for _, value, quantity in self.conditional:
            mask |= value if quantity.derivation.value(quantity, known, instance) else 0
        return (mask,) * self.covers.count

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return the bytes of the flags that are always set, and those of all flags."""
        every = self.mask
        for _, value, _ in self.conditional:
            every |= value
        return bytes_of(self.mask), bytes_of(every)

    def statements(self, code: PayloadCode) -> list[str]:
        """The bits that are always set, then each condition; a number of more than 16 bits in parts of 16."""
        covers = self.covers
        label, cited = f"# {covers.label}:", f"({covers.citation})"
        if not self.conditional:
            return [f"{label} {FLAGS.join(self.names) or 'no flag'} {cited}", *code.fill(covers, self.mask)]
        words = [f"{name} if {quantity.path}" for name, _, quantity in self.conditional]
        line = f"{label} {', '.join(words)} {cited}"
        head = [line] if len(line) < 100 else [f"{label} {cited}", *(f"#   {word}" for word in words)]
        return head + code.flags(covers, self.mask, self._each_once())

    def _each_once(self) -> list[tuple[int, Quantity]]:
        """Each condition once with all of its bits, and one behind the other what the same quantity decides."""
        bits: dict[str, int] = {}
        deciding: dict[str, dict[str, Quantity]] = {}
        for _, value, quantity in self.conditional:
            bits[quantity.path] = bits.get(quantity.path, 0) | value
            deciding.setdefault(quantity.decided_by, {})[quantity.path] = quantity
        return [(bits[path], each) for group in deciding.values() for path, each in group.items()]

    def words(self) -> Words:
        """The flags, each with its condition."""
        flags = [*self.names, *(f"{name} if {quantity.path}" for name, _, quantity in self.conditional)]
        always = f"= {self.mask:#x}" if self.mask or not self.conditional else ""
        return Words(FLAGS.join(flags) or "no flag", always)

    def way(self, origins: Origins) -> Iterator[Step]:
        """Yield what is always set, then each condition."""
        if self.names or not self.conditional:
            own = (str(self.covers.citation),)
            yield Step("table", f"always {FLAGS.join(self.names) or 'no flag'}", (f"= {self.mask:#x}",), own)
        for name, value, quantity in self.conditional:
            details = (f"{value:#x} while {quantity.path} is true", quantity.derivation.words(quantity))
            cited = (str(quantity.citation),) if quantity.citation else ()
            yield Step("condition", f"{name} if {quantity.path}", details, cited)

    def traits(self, position: int) -> Iterator[Trait]:
        """Each flag with its condition."""
        yield Trait("source", "flags", Aspect.SOURCE)
        for name in self.names:
            yield Trait(name, "always", Aspect.FLAGS)
        for name, value, quantity in self.conditional:
            yield Trait(name, f"({value:#x}) if {quantity.path}", Aspect.FLAGS)
        yield Trait("bits always set", f"{self.mask:#x}", Aspect.FLAGS)

    @property
    def entries(self) -> tuple[str, ...]:
        """The flags."""
        return (*self.names, *(name for name, _, _ in self.conditional))

    def readings(self, component: Component, dialect: Dialect) -> Iterator[Reading]:
        """The names of the bits that are set, and each boolean of the component that alone decides some bits."""
        field = self.covers.field
        enum = dialect.enums.get(field.definition.enum or "")
        if field.is_array or enum is None:
            return
        yield flag_names(field, enum)
        for name, value, quantity in self._deciding():
            if quantity.component == component.name and not value & self.mask:
                expression = f'is_set(get("{field.name}"), {value:#x})'
                yield Reading(quantity.name, expression, "", quantity.spec.doc, name, uses=("is_set",))

    def read_back(self) -> Iterator[ReadBack]:
        """The booleans that tests can set and that alone decide some bits."""
        for _, _, quantity in self._deciding():
            if quantity.derivation.is_set_by_code:
                yield ReadBack(quantity, {"stored": quantity.attribute, "boolean": True})

    def _deciding(self) -> list[tuple[str, int, Quantity]]:
        """The conditions of bits over which no other decides."""
        deciding = Counter(value for _, value, _ in self.conditional)
        return [condition for condition in self.conditional if deciding[condition[1]] == 1]

    @property
    def varies(self) -> bool:
        """Flags have a case for each condition, if there is one."""
        return True

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """Each condition true and false, and of a limit also unknown: with the limit of every instance."""
        flags = [flag for flag, _, _ in self.conditional]
        for flag, _, quantity in self.conditional:
            derivation, path = quantity.derivation, quantity.decided_by
            name = flag + (f"-{quantity.name}" if flags.count(flag) > 1 else "")
            numbers = range(instances) if derivation.differs_by_instance else range(1)
            for number in numbers:
                suffix = f"-{number}" if len(numbers) > 1 else ""
                for state, value in derivation.deciding(number, plain[path]).items():
                    yield StateCase(f"{name}-{state}{suffix}", {path: value}, number)


def _bits(mask: int) -> list[int]:
    """The bits of a number, each as a number."""
    return [1 << place for place in range(mask.bit_length()) if mask >> place & 1]


def condition_of(path: str, place: Place, scope: Scope) -> Quantity | None:
    """The boolean that a path names; None after a finding."""
    negated, _, denied = path.partition(" ")
    if negated == "not" and denied:
        message = f"a flag cannot be set while {denied.strip()} is false"
        scope.report.add(NOT_A_BOOLEAN, place, message, "name a boolean that is true then: code or a limit can set one")
        return None
    quantity = scope.quantity(path, place)
    if quantity is not None and quantity.kind is not QuantityKind.BOOLEAN:
        scope.report.add(NOT_A_BOOLEAN, place, f"{path} is not a boolean")
        return None
    return quantity
