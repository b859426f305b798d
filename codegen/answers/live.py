"""A value that is read when the message is built: a quantity of the state, or a parameter."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.answers.filling import apart, comment, fitted, origin, read, stand_in
from codegen.answers.fitting import BAD_SOURCE, WITHHELD, no_sentinel
from codegen.answers.instance import bytes_of
from codegen.answers.kind import KindOfAnswer
from codegen.answers.limits import Bounds, check_declared, check_reach, kept_apart, scaling_of
from codegen.answers.scaled import (
    conversion_trait,
    conversion_words,
    fitting,
    limit_cases,
    limit_words,
    parameter_cases,
    property_cases,
    read_back,
    sentinel_cases,
    to_unit,
)
from codegen.answers.scope import Scope
from codegen.answers.source import Taken, take
from codegen.frozen import dataclass
from codegen.model.answers.account import Arriving, Aspect, Origins, ReadBack, StateCase, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value, shown_value, stored_value
from codegen.model.answers.scaling import FLOAT_DIVISOR_MAX, Scaling, float_parts
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode
from codegen.model.code.reading import Reading, plausible, scaled
from codegen.model.code.storage import SMALL_INT_MAX, Storage, is_small
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.population import FieldAnswer, Send
from codegen.model.vehicle import Component, Parameter, Quantity, QuantityKind


@dataclass(frozen=True, slots=True)
class LiveAnswer(KindOfAnswer):
    """A value that is read when the message is built, and scaled. Unknown becomes ``unknown``.

    Where ``unknown`` is None the source has a value at all times: one stands in for what is not known, or else the
    answer ``withholds`` the message.
    """

    SHAPED_BY = frozenset({"min", "max", "rounding"})

    covers: Elements
    source: Quantity | Parameter
    scaling: Scaling
    unknown: int | float | None
    withholds: bool = False

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``state: component.quantity`` or ``parameter: NAME``."""
        return written.state is not None or written.parameter is not None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "LiveAnswer | None":
        """The source, converted exactly to the unit of the field and limited to what it can carry."""
        report = scope.report
        taken = take(covers, scope)
        if taken is None:
            return None
        if covers.count != 1:
            report.add(
                BAD_SOURCE,
                covers.written.at(taken.key),
                f"{covers.label} has {covers.count} elements and gets one value",
                "add 'split: true', or answer the elements one by one",
            )
            return None
        return cls.of(taken, covers, scope)

    @classmethod
    def of(cls, taken: Taken, covers: Elements, scope: Scope, *, is_known: bool = False) -> "LiveAnswer | None":
        """Return what is made of a source that fits; ``is_known``: what is unknown does not come here."""
        source, report = taken.source, scope.report
        sentinel = covers.field.sentinel.values[covers.first] if covers.field.sentinel else None
        may_be_unknown = isinstance(source, Quantity) and source.initial is None and not is_known
        withholds = may_be_unknown and sentinel is None and scope.population.send is Send.WHILE_KNOWN
        if may_be_unknown and sentinel is None and not withholds:
            no_sentinel(covers, taken.key, source.path, report)
            return None
        apart = kept_apart(source, sentinel)
        scaling = scaling_of(covers.field, apart, taken.bounds, taken.factor, covers.written, report)
        if scaling is None:
            return None
        unknown = sentinel if may_be_unknown else None
        check_reach(covers, taken.written, scaling, unknown, report)
        check_declared(covers, taken, Bounds(scaling.low, scaling.high), report)
        return cls(covers, source, scaling, unknown, withholds)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The source, where it is one."""
        return (self.source,) if isinstance(self.source, Quantity) else ()

    @property
    def carried(self) -> tuple[Quantity, ...]:
        """The same."""
        return self.quantities

    @property
    def withheld_for(self) -> tuple[Quantity, ...]:
        """The source, where the field cannot say that it is unknown."""
        return self.quantities if self.withholds else ()

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The source, where it is one."""
        return (self.source,) if isinstance(self.source, Parameter) else ()

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The number that comes of what is stored, or the sentinel."""
        stored = stored_value(self.source, known)
        if stored is None:
            assert self.unknown is not None
            return (self.unknown,)
        return (self.scaling.whole(stored) if self.covers.field.type.is_integer else self.scaling.real(stored),)

    @property
    def scalings(self) -> tuple[Scaling, ...]:
        """The one."""
        return (self.scaling,)

    @property
    def _is_long(self) -> bool:
        """Return whether a float needs numbers of several words on the way.

        One of 32 bits does without while value times numerator, and the shifted rest of the division by the
        denominator, fit a board's small integers.
        """
        wire_type, factor = self.covers.field.type, self.scaling.factor
        largest = max(map(abs, self.scaling.steps)) * factor.numerator
        return wire_type.size != 4 or largest > SMALL_INT_MAX or factor.denominator > FLOAT_DIVISOR_MAX

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return the bytes of the limits and of the sentinel; a negative number takes all."""
        scaling, unknown, size = self.scaling, self.unknown, self.covers.field.type.size
        can_be_zero = scaling.low <= 0 <= scaling.high and scaling.hole != 0
        if not self.covers.field.type.is_integer:
            return 0 if can_be_zero or unknown == 0 else size, size
        numbers = [int(scaling.low), int(scaling.high), *([] if unknown is None else [int(unknown)])]
        most = size if min(numbers) < 0 else bytes_of(max(numbers))
        values = numbers if scaling.low > 0 else [0] if scaling.high >= 0 else numbers
        if scaling.low <= 0 <= scaling.high and scaling.hole == 0:
            values = [1]
        if unknown == 0:
            values = [0]
        return min(bytes_of(value) if value >= 0 else size for value in values), most

    def statements(self, code: PayloadCode) -> list[str]:
        """Read, scaled and limited; a float is limited before it is divided."""
        return [comment(self.covers, origin(self.covers, self.source)), *self.written(code)]

    def written(self, code: PayloadCode, element: str = "") -> list[str]:
        """The same without the comment; ``element`` is the place in a list, and in the field, in a loop over both."""
        lines = [f"value = {read(code, self.source, element)}"]
        initial = self.source.initial if isinstance(self.source, Quantity) else None
        assert initial is None or isinstance(initial, int)
        instead, why = self.unknown, "unknown"
        if self.covers.field.type.is_integer and initial is not None and self.scaling.whole(initial) == initial:
            instead, why = initial, "until it is set"
        elif self.unknown is None:
            lines += stand_in(self.source)
        if not self.covers.field.type.is_integer:
            return lines + self._float(code, element)
        assert instead is None or isinstance(instead, int)
        store = code.store(self.covers, "value", element=element)
        if instead is None or is_small(instead):
            return [*lines, *fitted(self.scaling, instead, why), *store]
        unknown = code.store(self.covers, instead, element=element, over=True)
        return [*lines, *apart(instead, unknown, [*fitted(self.scaling, None), *store])]

    def _float(self, code: PayloadCode, element: str) -> list[str]:
        factor = self.scaling.factor
        if self._is_long:
            write = code.put_real(self.covers, float_parts(factor), element)
        else:
            product = f"value * {factor.numerator}" if factor.numerator != 1 else "value"
            write = code.put_float(self.covers, product, factor.denominator, self.unknown, element)
        lines = [*fitted(self._in_steps, None), *write]
        if self.unknown is None:
            return lines
        # The float beside it is written as a whole.
        unknown = code.store(self.covers, self.unknown, element=element, over=True)
        return apart(self.unknown, unknown, lines)

    @property
    def _in_steps(self) -> Scaling:
        """The limits of a float field in stored steps, in which nothing has to be scaled."""
        low, high = self.scaling.steps
        factor, hole, beside = self.scaling.factor, self.scaling.hole, self.scaling.beside
        step = None if hole is None else hole / factor
        if step is None or step.denominator != 1 or beside is None:
            return Scaling(Fraction(1), self.scaling.rounding, Fraction(low), Fraction(high))
        return Scaling(Fraction(1), self.scaling.rounding, Fraction(low), Fraction(high), step, beside / factor)

    def words(self) -> Words:
        """The path of the source, how it is scaled, and its limits on the wire."""
        conversion = conversion_words(self.covers, self.source, self.scaling)
        return Words(self.source.path, conversion, limit_words(self.scaling))

    def way(self, origins: Origins) -> Iterator[Step]:
        """The source, then what is done so that it fits."""
        yield from origins.steps(self.source)
        yield from fitting(self.covers, self.scaling, self.words().conversion, self.unknown)
        if self.withholds:
            yield WITHHELD

    def traits(self, position: int) -> Iterator[Trait]:
        """Source, scaling, limits and sentinel."""
        yield Trait("source", self.source.path, Aspect.SOURCE)
        yield conversion_trait(self.covers, self.source, self.scaling)
        yield Trait("limits", limit_words(self.scaling, "as"), Aspect.LIMITS)
        unknown = "" if self.unknown is None else shown_value(self.unknown)
        yield Trait("unknown", WITHHELD.text if self.withholds else unknown, Aspect.UNKNOWN)

    def is_fact(self, component: Component) -> bool:
        """Unless it is a quantity of the component itself."""
        return not self._is_of(component)

    def readings(self, component: Component, dialect: Dialect) -> Iterator[Reading]:
        """The quantity."""
        if not self._is_of(component) or not isinstance(self.source, Quantity):
            return
        source, covers = self.source, self.covers
        got = f'get("{covers.field.name}")'
        uses = ("element",) if covers.field.is_array else ()
        expression, used = scaled(
            f"element({got}, {covers.first})" if covers.field.is_array else got, to_unit(source, self.scaling)
        )
        enum = source.enum.name if source.kind is QuantityKind.ENUM and source.enum else ""
        if source.kind is QuantityKind.NUMBER:
            expression, judged = plausible(expression, *self._told_ends(source))
            used = (*used, *judged)
        yield Reading(source.name, expression, source.unit.name, source.spec.doc, covers.label, enum, (*used, *uses))

    def _told_ends(self, source: Quantity) -> tuple[Fraction | None, Fraction | None]:
        """The limits of the quantity, as wide as what the field tells of a value at them, in the receiver's floats."""
        low, high = source.spec.min, source.spec.max
        wire = self.covers.field.type
        ends = self.scaling.low, self.scaling.high
        sent = [int(end) if wire.is_integer else float(Storage(wire.code).nearest(end)) for end in ends]
        factor = to_unit(source, self.scaling)
        told = [Fraction(end * factor.numerator / factor.denominator) for end in sent]
        return None if low is None else min(low, told[0]), None if high is None else max(high, told[1])

    def read_back(self) -> Iterator[ReadBack]:
        """The quantity."""
        if isinstance(self.source, Quantity):
            yield read_back(self.covers, self.source, self.scaling)

    @property
    def arriving(self) -> Arriving | None:
        """The quantity, where it is a number."""
        source = self.source
        is_number = isinstance(source, Quantity) and source.kind is QuantityKind.NUMBER and not source.is_computed
        return Arriving(source, self.scaling, self.unknown) if is_number and isinstance(source, Quantity) else None

    @property
    def varies(self) -> bool:
        """Return True: it changes with its source."""
        return True

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """A quantity at its limits and beyond, and set through its property; a parameter at its limits."""
        if isinstance(self.source, Parameter):
            yield from parameter_cases(self.source)
        else:
            yield from limit_cases(self.scaling, self.source.path)
            yield from sentinel_cases(self.covers, self.scaling, self.source.path)
            yield from property_cases(self.source, plain)

    def _is_of(self, component: Component) -> bool:
        return isinstance(self.source, Quantity) and self.source.component == component.name
