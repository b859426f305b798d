"""A quantity that no small integer holds: its halves go to the wire as they are kept."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.answers.fitting import no_sentinel
from codegen.answers.halves import float_bounds, float_within, next_float
from codegen.answers.limits import Bounds, check_declared, check_reach, kept_apart, scaling_of
from codegen.answers.live import LiveAnswer
from codegen.answers.scope import Scope
from codegen.answers.source import Taken, take
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.answers.account import StateCase
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value, kept_number
from codegen.model.code.halves import above, below, equal
from codegen.model.code.payload_code import PayloadCode, indented
from codegen.model.code.statements import tested
from codegen.model.code.storage import HALF, Storage
from codegen.model.spec.population import FieldAnswer, Send
from codegen.model.vehicle import Quantity

NOT_AS_KEPT = Rule(
    "not-as-kept",
    "A quantity that is kept in more than 30 bits, or as a float, goes out as it is kept: in fields of its stored "
    "unit, an integer in integer fields and a float in float fields of its size. For a field of another unit, keep a "
    "quantity of its own in that unit.",
    remedy="answer with a quantity that is kept as the field carries it: its unit, and float or not",
)


@dataclass(frozen=True, slots=True)
class CopiedAnswer(LiveAnswer):
    """A value that is copied from the state, half by half: the factor of its ``scaling`` is 1."""

    SHAPED_BY = frozenset({"min", "max"})

    source: Quantity

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``state: component.quantity``, where more than a small integer is kept of it."""
        component, _, name = (written.state or "").partition(".")
        owner = scope.components.get(component)
        quantity = owner.quantities.get(name) if owner else None
        return quantity is not None and quantity.storage is not Storage.SMALL and not written.split

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "CopiedAnswer | None":
        """The quantity, limited to what the field can carry."""
        taken = take(covers, scope)
        return None if taken is None else cls.of(taken, covers, scope)

    @classmethod
    def of(cls, taken: Taken, covers: Elements, scope: Scope, *, is_known: bool = False) -> "CopiedAnswer | None":
        """Return what is made of a source that fits; ``is_known``: what is unknown does not come here."""
        source, field = taken.source, covers.field
        assert isinstance(source, Quantity)
        is_same = source.storage.is_float != field.type.is_integer
        if source.storage.is_float and is_same:
            is_same = source.storage.halves * 2 == field.type.size
        if taken.factor != 1 or covers.count != 1 or not is_same:
            kept = f"in {source.stored.name}" if source.stored.name else "without a unit"
            kind = "a float" if source.storage.is_float else "an integer"
            size = f"{kind} of {source.storage.halves * HALF} bits"
            wanted = f"{field.type.name}{f'[{covers.count}]' if covers.count != 1 else ''}"
            message = f"{source.path} is kept {kept} as {size}, and {covers.label} is {wanted}"
            message += f" in {field.unit_text}" if field.unit_text else " without a unit"
            related = [(field.definition.place, f"{field.name} is declared here")]
            scope.report.add(NOT_AS_KEPT, covers.written.at("state"), message, related=related)
            return None
        sentinel = field.sentinel.values[covers.first] if field.sentinel else None
        may_be_unknown = source.initial is None and not is_known
        withholds = may_be_unknown and sentinel is None and scope.population.send is Send.WHILE_KNOWN
        if may_be_unknown and sentinel is None and not withholds:
            no_sentinel(covers, "state", source.path, scope.report)
            return None
        # Beside a float are others that are much closer than a step.
        at_end = None if source.storage.is_float else kept_apart(source, sentinel)
        scaling = scaling_of(field, at_end, taken.bounds, Fraction(1), covers.written, scope.report)
        if scaling is None:
            return None
        if source.storage.is_float:
            scaling = float_within(scaling, sentinel, source.storage)
        unknown = sentinel if may_be_unknown else None
        written = float_bounds(taken.written, source.storage) if source.storage.is_float else taken.written
        check_reach(covers, written, scaling, unknown, scope.report)
        carried = taken.bounds if source.storage.is_float else Bounds(scaling.low, scaling.high)
        check_declared(covers, taken, carried, scope.report)
        return cls(covers, source, scaling, unknown, withholds)

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The number that is kept, or the sentinel."""
        kept = kept_number(self.source, known)
        if kept is None:
            assert self.unknown is not None
            return (self.unknown,)
        value = self._fitting(kept)
        return (self.source.storage.held(float(value) if self.source.storage.is_float else int(value)),)

    def _fitting(self, kept: int | Fraction) -> int | Fraction:
        """Return a number brought within the limits, and off the sentinel."""
        value = max(self.scaling.low, min(self.scaling.high, kept))
        beside = self.scaling.beside
        return beside if beside is not None and value == self.scaling.hole else value

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return the least and most bytes up to the last that is not 0: none if the value can be 0, and all."""
        scaling, size = self.scaling, self.covers.field.type.size
        can_be_zero = scaling.low <= 0 <= scaling.high and scaling.hole != 0
        return 0 if can_be_zero or self.unknown == 0 else 1, size

    def written(self, code: PayloadCode, element: str = "") -> list[str]:
        """Half by half; what is unknown, or beyond a limit, is a number that is known now."""
        source, covers = self.source, self.covers
        halves = [code.half(source, at, element) for at in range(source.storage.halves)]
        copy = code.copy(covers, halves, signed=source.storage.is_signed, element=element)
        compared = [*halves[:-1], "value"]
        tests: list[tuple[str, float | Fraction, str]] = [*self._limited(compared), *self._hole(compared)]
        lines = [f"value = {halves[-1]}"] if tests else []
        initial = source.initial
        assert not isinstance(initial, str)
        instead = self.unknown if initial is None else self._fitting(initial)
        why = "unknown" if self.unknown is not None else "until it is set"
        if instead is not None:
            tests.insert(0, (f"{halves[0]} >> {HALF}", instead, why))
        if not tests:
            return [*lines, *copy]
        for at, (condition, value, remark) in enumerate(tests):
            number = int(value) if covers.field.type.is_integer else float(value)
            lines += [
                *tested("elif" if at else "if", condition, remark),
                *indented(code.store(covers, number, element=element, over=True)),
            ]
        return [*lines, "else:", *indented(copy)]

    def _limited(self, halves: list[str]) -> Iterator[tuple[str, int | Fraction, str]]:
        """The limits that the quantity itself can pass."""
        storage, source, scaling = self.source.storage, self.source, self.scaling
        if scaling.low > source.minimum:
            yield below(halves, scaling.low, storage), scaling.low, "too small"
        if scaling.high < source.maximum:
            yield above(halves, scaling.high, storage), scaling.high, "too large"

    def _hole(self, halves: list[str]) -> Iterator[tuple[str, int | Fraction, str]]:
        hole, beside = self.scaling.hole, self.scaling.beside
        if hole is not None and beside is not None and self.scaling.low <= hole <= self.scaling.high:
            yield equal(halves, hole, self.source.storage), beside, "would read as unknown"

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """The ends of the range, beyond both, unknown, zero, every half on its own, and the sentinel."""
        path, storage = self.source.path, self.source.storage
        low, high = storage.limits
        named: dict[str, int | Fraction | None] = {
            "minimum": self.scaling.low,
            "maximum": self.scaling.high,
            "far-below": low,
            "far-above": high,
            "zero": Fraction(0) if storage.is_float else 0,
            "minus-one": Fraction(-1) if storage.is_float else -1,
            "unknown": None,
        }
        if self.scaling.hole is not None:
            named["sentinel"] = self.scaling.hole
        if storage.is_float:
            named |= {f"{tenths}-tenths": Fraction(storage.held(tenths / 10)) for tenths in (-6, 1, 15)}
            named["smallest"] = next_float(Fraction(0), storage)
        else:
            named |= {"below-minimum": self.scaling.low - 1, "above-maximum": self.scaling.high + 1}
            named |= {f"half-{at}": 0x8001 << HALF * at for at in range(storage.halves)}
        for name, value in named.items():
            if value is None or low <= value <= high:
                yield StateCase(name, {path: value if value is None or storage.is_float else int(value)})
