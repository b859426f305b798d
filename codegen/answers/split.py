"""A quantity that is spread over the elements of an array, because one element cannot hold it."""

from collections.abc import Iterator, Sequence
from fractions import Fraction

from codegen.answers.filling import comment, fitted, origin, read, stand_in
from codegen.answers.kind import KindOfAnswer
from codegen.answers.limits import Bounds, check_declared
from codegen.answers.scaled import (
    conversion_trait,
    conversion_words,
    fitting,
    limit_cases,
    limit_words,
    property_cases,
    read_back,
    to_unit,
)
from codegen.answers.scope import Scope
from codegen.answers.source import take
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, ReadBack, StateCase, ToldNumber, Trait, Words, told_number
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value, stored_value
from codegen.model.answers.scaling import Scaling
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import UNKNOWN, PayloadCode, indented
from codegen.model.code.reading import Reading, scaled
from codegen.model.code.storage import is_small
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Component, Parameter, Quantity

BAD_SPLIT = Rule(
    "bad-split",
    "Only a quantity can be split, over at least two elements of an integer array whose sentinel is the largest "
    "number of its type.",
    remedy="leave split out, or answer an integer array of which the sentinel is the largest number",
)


@dataclass(frozen=True, slots=True)
class SplitAnswer(KindOfAnswer):
    """A quantity spread over elements: each holds up to ``element_high``, the rest spills into the next.

    ``unused`` is the sentinel of elements that are not reached; the scaling is that of the whole.
    Source: the dialect's text for BATTERY_STATUS.voltages.
    """

    SHAPED_BY = frozenset({"split", "min", "max", "rounding"})

    covers: Elements
    source: Quantity
    scaling: Scaling
    element_high: int
    unused: int

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``state: component.quantity`` with ``split: true``."""
        return written.split and (written.state is not None or written.parameter is not None)

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "SplitAnswer | None":
        """The quantity, limited to what all elements hold together."""
        taken = take(covers, scope)
        if taken is None:
            return None
        field = covers.field
        wire_type = field.type
        sentinels = field.sentinel.values[covers.first : covers.first + covers.count] if field.sentinel else ()
        if (
            isinstance(taken.source, Parameter)
            or covers.count < 2
            or not wire_type.is_integer
            or any(value != wire_type.maximum for value in sentinels)
            or not sentinels
        ):
            scope.report.add(BAD_SPLIT, covers.written.at("split"), f"{covers.label} cannot be split")
            return None
        element_high = wire_type.maximum - 1
        bounds = taken.bounds.within(Bounds(Fraction(0), Fraction(element_high * covers.count)))
        low, high = bounds.whole()
        check_declared(covers, taken, Bounds(low, high), scope.report)
        return cls(
            covers=covers,
            source=taken.source,
            scaling=Scaling(taken.factor, covers.written.rounding, low, high),
            element_high=element_high,
            unused=wire_type.maximum,
        )

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The one that is spread."""
        return (self.source,)

    @property
    def carried(self) -> tuple[Quantity, ...]:
        """The same."""
        return (self.source,)

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """Full elements, the rest, and the sentinel in those that are not reached."""
        stored = stored_value(self.source, known)
        count = self.covers.count
        if stored is None:
            return (self.unused,) * count
        full, last = divmod(self.scaling.whole(stored), self.element_high)
        elements = [self.element_high] * full
        if last or not elements:
            elements.append(last)
        return tuple(elements + [self.unused] * (count - len(elements)))

    @property
    def scalings(self) -> tuple[Scaling, ...]:
        """Return the scaling of the whole value."""
        return (self.scaling,)

    def statements(self, code: PayloadCode) -> list[str]:
        """The value into the first element; what that cannot hold into the next ones."""
        words = f"{origin(self.covers, self.source)}, spilling above {self.element_high}"
        return [comment(self.covers, words), *self.spilled(code)]

    def spilled(self, code: PayloadCode) -> list[str]:
        """The statements without their comment."""
        covers, most, last = self.covers, self.element_high, self.covers.first + self.covers.count - 1
        full = [
            f"while value > {most} and place < {last}:",
            *indented([*code.store_at(covers, "place", str(most)), f"value -= {most}", "place += 1"]),
        ]
        spread = [
            *fitted(self.scaling, None),
            f"place = {covers.first}",
            *(full if is_small(most) else []),  # what is kept is smaller than all that one element holds
            *code.store_at(covers, "place", "value"),
        ]
        lines = [f"value = {read(code, self.source)}", *stand_in(self.source), *code.fill(covers, self.unused, 1)]
        if self.source.initial is not None:
            return lines + spread
        unknown = code.store(covers, self.unused)
        return [*lines, f"if value == {UNKNOWN}:", *indented(unknown), "else:", *indented(spread)]

    def words(self) -> Words:
        """The path of the source, how it is scaled and spread, and its limits on the wire."""
        conversion = conversion_words(self.covers, self.source, self.scaling)
        spread = f"spills above {self.element_high}"
        text = f"{conversion}, {spread}" if conversion else spread
        return Words(self.source.path, text, limit_words(self.scaling))

    def way(self, origins: Origins) -> Iterator[Step]:
        """The source, then what is done so that it fits."""
        yield from origins.steps(self.source)
        yield from fitting(self.covers, self.scaling, self.words().conversion, self.unused, self.element_high)

    def traits(self, position: int) -> Iterator[Trait]:
        """Source, scaling, limits and sentinel."""
        yield Trait("source", f"{self.source.path}, spilling over", Aspect.SOURCE)
        yield conversion_trait(self.covers, self.source, self.scaling)
        yield Trait("limits", f"{limit_words(self.scaling)}, {self.element_high} an element", Aspect.LIMITS)
        yield Trait("unknown", str(self.unused), Aspect.UNKNOWN)

    def readings(self, component: Component, dialect: Dialect) -> Iterator[Reading]:
        """The quantity: the sum of the elements that are reached."""
        source, covers = self.source, self.covers
        if source.component != component.name:
            return
        whole = f'joined(raw("{covers.field.name}"), {covers.first}, {covers.count}, {self.unused})'
        expression, uses = scaled(whole, to_unit(source, self.scaling))
        uses = (*uses, "joined")
        yield Reading(source.name, expression, source.unit.name, source.spec.doc, covers.label, uses=uses)

    @property
    def told_quantities(self) -> tuple[Quantity, ...]:
        """The one that is spread."""
        return (self.source,)

    def told(self, wire: Sequence[int | float]) -> Iterator[ToldNumber]:
        """The sum of the elements that are reached."""
        reached = [value for value in wire if value != self.unused]
        factor = to_unit(self.source, self.scaling)
        value = sum(map(Fraction, reached), Fraction(0)) * factor if reached else None
        yield told_number(self.source, value, factor, self.covers.field.type)

    def read_back(self) -> Iterator[ReadBack]:
        """The quantity."""
        yield read_back(self.covers, self.source, self.scaling)

    @property
    def varies(self) -> bool:
        """Return True: it changes with its source."""
        return True

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """The quantity at its limits and beyond, around each full element, and set through its property."""
        yield from self.value_cases()
        yield from property_cases(self.source, plain)

    def value_cases(self) -> Iterator[StateCase]:
        """Yield the cases of stored values."""
        path = self.source.path
        yield from limit_cases(self.scaling, path)
        for elements in range(1, self.covers.count + 1):
            for name, wire in (("full", 0), ("full-and-one", 1), ("full-less-one", -1)):
                stored = self.scaling.to_stored(elements * self.element_high + wire)
                yield StateCase(f"{elements}-elements-{name}", {path: stored})
        yield StateCase("sentinel", {path: self.scaling.to_stored(self.unused)})
