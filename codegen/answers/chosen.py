"""One entry of an enum: the first of several whose boolean of the state is true, else the last one."""

from collections.abc import Iterator

from codegen.answers.constant import fits
from codegen.answers.fitting import NOT_AN_ENUM_FIELD, field_enum
from codegen.answers.flags import condition_of
from codegen.answers.instance import bytes_of
from codegen.answers.kind import KindOfAnswer
from codegen.answers.scope import Scope
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.answers.account import FLAGS, Aspect, Origins, StateCase, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode, indented
from codegen.model.dialect.dialect import EnumDefinition
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Quantity

BAD_CHOICE = Rule(
    "bad-choice",
    "one_of is a list of entries of the field's enum: each but the last as 'ENTRY if component.quantity', the last one "
    "without a condition, for when none of these is true. What stands behind an entry without one is never sent.",
    remedy="write one_of: [ENTRY if component.quantity, OTHER_ENTRY]",
)

LONG = 100
"""Columns from which on a comment has a line for each entry."""


@dataclass(frozen=True, slots=True)
class ChosenAnswer(KindOfAnswer):
    """The value of the first of ``conditional`` whose quantity is true, else ``otherwise``, in each element."""

    covers: Elements
    conditional: tuple[tuple[str, int, Quantity], ...]
    otherwise: tuple[str, int]

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``one_of: [ENTRY if component.quantity, ENTRY]``."""
        return written.one_of is not None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "ChosenAnswer | None":
        """Entries of the field's enum; None after a finding."""
        enum, place = field_enum(covers, "one_of", scope), covers.written.at("one_of")
        if enum is None:
            return None
        if enum.is_bitmask or covers.field.definition.is_bitmask:
            scope.report.add(NOT_AN_ENUM_FIELD, place, f"{enum.name} is a bitmask", "name its bits with 'flags'")
            return None
        *entries, last = covers.written.one_of or ("",)
        if not entries or " if " in last or not all(" if " in entry for entry in entries):
            message = f"{covers.label} needs entries with conditions, and behind them one without"
            scope.report.add(BAD_CHOICE, place, message)
            return None
        conditional = [_conditional(entry, enum, covers, scope) for entry in entries]
        value = _value(last.strip(), enum, covers, scope)
        found = tuple(entry for entry in conditional if entry is not None)
        if value is None or len(found) < len(entries):
            return None
        return cls(covers, found, (last.strip(), value))

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The conditions."""
        return tuple(quantity for _, _, quantity in self.conditional)

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The entry that is chosen, in each element."""
        holding = (entry for _, entry, each in self.conditional if each.derivation.value(each, known, instance))
        return (next(holding, self.otherwise[1]),) * self.covers.count

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return the bytes of the smallest entry, and those of the largest."""
        used = [bytes_of(value) for value in (*(entry for _, entry, _ in self.conditional), self.otherwise[1])]
        return min(used), max(used)

    def statements(self, code: PayloadCode) -> list[str]:
        """The last entry, and over it each one whose condition holds, the first of them at the end."""
        covers = self.covers
        words = [*(f"{name} if {quantity.path}" for name, _, quantity in self.conditional), f"else {self.otherwise[0]}"]
        head = [f"# {covers.label}: {', '.join(words)} ({covers.citation})"]
        if len(head[0]) >= LONG:
            head = [f"# {covers.label}: the first of ({covers.citation})", *(f"#   {each}" for each in words)]
        lines, read = code.fill(covers, self.otherwise[1]), ""
        for _, value, quantity in reversed(self.conditional):
            source, condition = code.condition(quantity)
            lines += [f"value = {source}"] if source and source != read else []
            read = source or read
            put = [line for at in range(covers.count) for line in code.store(covers, value, at, always=False)]
            lines += [f"if {condition}:", *indented(put)]
        return head + lines

    def words(self) -> Words:
        """The entries, each with its condition."""
        entries = [f"{name} if {quantity.path}" for name, _, quantity in self.conditional]
        return Words(FLAGS.join((*entries, f"else {self.otherwise[0]}")), "")

    def way(self, origins: Origins) -> Iterator[Step]:
        """Yield a step for each condition, then one for the entry that is sent where none is true."""
        for name, value, quantity in self.conditional:
            details = (f"{value} while {quantity.path} is true", quantity.derivation.words(quantity))
            cited = (str(quantity.citation),) if quantity.citation else ()
            yield Step("condition", f"{name} if {quantity.path}", details, cited)
        yield Step("table", f"else {self.otherwise[0]}", (f"= {self.otherwise[1]}",), (str(self.covers.citation),))

    def traits(self, position: int) -> Iterator[Trait]:
        """Each entry with its condition and its rank."""
        yield Trait("source", "one of several entries", Aspect.SOURCE)
        for rank, (name, value, quantity) in enumerate(self.conditional, start=1):
            yield Trait(name, f"({value}) if {quantity.path}, number {rank}", Aspect.CONSTANT)
        yield Trait("otherwise", f"{self.otherwise[1]} ({self.otherwise[0]})", Aspect.CONSTANT)

    @property
    def entries(self) -> tuple[str, ...]:
        """The entries."""
        return (*(name for name, _, _ in self.conditional), self.otherwise[0])

    @property
    def varies(self) -> bool:
        """Return True: there is a case for each condition."""
        return True

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """Each condition true and false, and of a limit also unknown: with the limit of every instance."""
        for name, _, quantity in self.conditional:
            derivation, path = quantity.derivation, quantity.decided_by
            numbers = range(instances) if derivation.differs_by_instance else range(1)
            for number in numbers:
                suffix = f"-{number}" if len(numbers) > 1 else ""
                for state, value in derivation.deciding(number, plain[path]).items():
                    yield StateCase(f"{name}-{quantity.name}-{state}{suffix}", {path: value}, number)


def _conditional(entry: str, enum: EnumDefinition, covers: Elements, scope: Scope) -> tuple[str, int, Quantity] | None:
    name, _, path = entry.partition(" if ")
    value = _value(name.strip(), enum, covers, scope)
    quantity = condition_of(path.strip(), covers.written.at("one_of"), scope)
    return None if value is None or quantity is None else (name.strip(), value, quantity)


def _value(name: str, enum: EnumDefinition, covers: Elements, scope: Scope) -> int | None:
    """The number of an entry that the field holds; None after a finding."""
    value = scope.entry(enum, name, covers.written.at("one_of"))
    return value if value is not None and fits(covers, value, "one_of", name, scope.report) else None
