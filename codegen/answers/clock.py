"""The time since the start, or since 1970, in the unit of the field."""

import math
from collections.abc import Iterator
from fractions import Fraction

from codegen.answers.fitting import BAD_SOURCE, WITHHELD, field_unit, no_sentinel
from codegen.answers.kind import KindOfAnswer
from codegen.answers.scope import Scope
from codegen.frozen import dataclass
from codegen.measure import UNIT_MISMATCH
from codegen.model.answers.account import Aspect, Origins, StateCase, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value, kept_number, shown_value
from codegen.model.answers.step import Step
from codegen.model.code.clock import BOOT, CLOCK
from codegen.model.code.payload_code import PayloadCode, indented
from codegen.model.code.statements import tested
from codegen.model.code.storage import HALF
from codegen.model.spec.population import FieldAnswer, Send
from codegen.model.units.unit import decimal, ratio, unit_named
from codegen.model.vehicle import Quantity

_MS = 1000
_PARTS = {1: 0, _MS: 1, 10 * _MS: 10, 100 * _MS: 100, 1000 * _MS: 1000}
"""Microseconds of a unit that a field can count, with the milliseconds that are divided for it; 0 for microseconds."""
_NS = Fraction(1, 1000)
"""The same of a nanosecond: the clock in microseconds is multiplied, so that every number is a whole thousand."""


@dataclass(frozen=True, slots=True)
class ClockAnswer(KindOfAnswer):
    """A clock of the state, cut to whole units of ``microseconds`` each, which are 1/1000 in a field of nanoseconds.

    It wraps as the field does.

    Unknown becomes ``unknown``, or the answer ``withholds`` the message; the time since the start is always known.
    """

    covers: Elements
    source: Quantity
    microseconds: Fraction
    unknown: int | None
    withholds: bool = False

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``clock: boot`` or ``clock: unix``."""
        return written.clock is not None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "ClockAnswer | None":
        """The clock, for one integer field with a unit of time."""
        place, field = covers.written.at("clock"), covers.field
        unit = field_unit(field, scope.report)
        if unit is None:
            return None
        if not field.type.is_integer or covers.count != 1:
            scope.report.add(
                BAD_SOURCE,
                place,
                f"{covers.label} is {field.type.name}: a clock is a whole number",
                hint="answer a float with a quantity, in which code keeps the time",
            )
            return None
        steps = ratio(unit, unit_named("us"))
        if steps is None or (steps != _NS and steps not in _PARTS):
            message = f"{covers.label} is in {field.unit_text or 'no unit'}, and a clock counts ns, us, ms, cs, ds or s"
            hint = "answer it with a quantity, in which code keeps the time"
            if not field.unit_text:
                hint = "corrections.yaml can set its units"
            scope.report.add(UNIT_MISMATCH, place, message, hint)
            return None
        source = scope.components[CLOCK].quantities[str(covers.written.clock or BOOT)]
        sentinel = field.sentinel.values[covers.first] if field.sentinel else None
        can_be_unknown = source.initial is None
        withholds = can_be_unknown and sentinel is None and scope.population.send is Send.WHILE_KNOWN
        if can_be_unknown and sentinel is None and not withholds:
            no_sentinel(covers, "clock", "the time since 1970", scope.report)
            return None
        unknown = int(sentinel) if can_be_unknown and sentinel is not None else None
        return cls(covers, source, steps, unknown, withholds)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The clock."""
        return (self.source,)

    @property
    def carried(self) -> tuple[Quantity, ...]:
        """The same."""
        return (self.source,)

    @property
    def withheld_for(self) -> tuple[Quantity, ...]:
        """The clock, where no number of the field means unknown."""
        return self.quantities if self.withholds else ()

    @property
    def hole(self) -> int | None:
        """The number that means unknown, which a known time passes."""
        sentinel = self.covers.field.sentinel.values[self.covers.first] if self.covers.field.sentinel else None
        return None if sentinel is None else int(sentinel)

    @property
    def beside(self) -> int:
        """Return what goes out in its place: the step before the last number of the
        type, or else the one farther from 0.
        """
        hole, last = self.hole or 0, self.covers.field.type.maximum
        return hole - 1 if hole == last or self.covers.field.type.minimum < hole < 0 else hole + 1

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The whole units, as many of their bits as the field has."""
        kept = kept_number(self.source, known)
        if kept is None:
            assert self.unknown is not None
            return (self.unknown,)
        wire_type = self.covers.field.type
        value = int(int(kept) // self.microseconds) & (1 << 8 * wire_type.size) - 1
        value -= 1 << 8 * wire_type.size if value > wire_type.maximum else 0
        return (self.beside if value == self.hole else value,)

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return none at the start, and all later."""
        return 0, self.covers.field.type.size

    def statements(self, code: PayloadCode) -> list[str]:
        """Half by half, of the clock in microseconds, multiplied or not, or in milliseconds, divided or not."""
        covers, source = self.covers, self.source
        divisor = _PARTS.get(int(self.microseconds), 0)
        word = source.attribute if not divisor else f"{source.name}_ms"
        halves = [code.clock_half(word, at) for at in range(source.storage.halves)]
        lines = [self._comment()]
        if self.microseconds == _NS:
            written = self._multiplied(code, halves)
        elif divisor > 1:
            written = self._divided(code, halves, divisor)
        else:
            written = code.copy(covers, halves, signed=False)
        if self.hole is not None:
            passed = tested("if", code.is_written(covers, self.hole), "would read as unknown")
            written = [*written, *passed, *indented(code.store(covers, self.beside, over=True))]
        if self.unknown is None:
            return [*lines, *written]
        unknown = code.store(covers, self.unknown, over=True)
        return [
            *lines,
            f"if {code.clock_half(source.attribute, 0)} >> {HALF}:  # unknown",
            *indented(unknown),
            "else:",
            *indented(written),
        ]

    def _divided(self, code: PayloadCode, halves: list[str], divisor: int) -> list[str]:
        """Return the lines of a long division: the highest half first, each remainder in front of the next half."""
        size = self.covers.field.type.size
        lines = [f"value = {halves[-1]} % {divisor}"] if size < 2 * len(halves) else []
        for at in reversed(range(len(halves) - len(lines))):
            left = f"value << {HALF} | " if lines else ""
            lines.append(f"value = {left}{halves[at]}")
            if 2 * at < size:
                lines += code.copy_half(self.covers, at, f"value // {divisor}")
            if at:
                lines.append(f"value %= {divisor}")
        return lines

    def _multiplied(self, code: PayloadCode, halves: list[str]) -> list[str]:
        """Return the lines of a long multiplication: the lowest half first, what it carries added to the next one."""
        count = max(1, self.covers.field.type.size // 2)
        lines: list[str] = []
        for at, half in enumerate(halves[:count]):
            carried = f" + (value >> {HALF})" if lines else ""
            lines.append(f"value = {half} * {1 / _NS}{carried}")
            lines += code.copy_half(self.covers, at, "value")
        return lines

    def _comment(self) -> str:
        covers = self.covers
        return f"# {covers.label} [{covers.field.unit_text}]: {self.words().source} ({covers.citation})"

    def words(self) -> Words:
        """Return which clock, and that it wraps."""
        since = "the start" if self.source.name == BOOT else "1970"
        passed = "" if self.hole is None else f", {self.hole} -> {self.beside}"
        return Words(f"time since {since}", f"whole {self.covers.field.unit_text}", f"wraps as the field does{passed}")

    def way(self, origins: Origins) -> Iterator[Step]:
        """The ticks, and the unit."""
        yield from origins.steps(self.source)
        words = self.words()
        yield Step("unit", f"{words.conversion}, {words.limits}", (), (str(self.covers.citation),))
        if self.withholds:
            yield WITHHELD

    def traits(self, position: int) -> Iterator[Trait]:
        """Yield which clock, its unit, and the sentinel."""
        yield Trait("source", f"{CLOCK}: {self.source.name}", Aspect.SOURCE)
        yield Trait("conversion", f"whole units of {decimal(self.microseconds)} us", Aspect.CONVERSION)
        unknown = "" if self.unknown is None else shown_value(self.unknown)
        yield Trait("unknown", WITHHELD.text if self.withholds else unknown, Aspect.UNKNOWN)

    @property
    def varies(self) -> bool:
        """Return True: it changes with the time."""
        return True

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """Around a unit, around each wrap of the ticks and of the field, and at the end of 64 bits."""
        path, size = self.source.path, self.covers.field.type.size
        for name, end in {
            "unit": math.ceil(self.microseconds),
            "microseconds": 1 << 30,
            "milliseconds": 1000 << 30,
            "half": math.ceil(self.microseconds * (1 << HALF)),
            "wrap": min(math.ceil(self.microseconds * (1 << 8 * size)), 1 << 64),
            "end": 1 << 64,
        }.items():
            yield StateCase(f"before-{name}", {path: end - 1})
            if end < 1 << 64:
                yield StateCase(f"after-{name}", {path: end})
        if self.hole is not None:
            passed = (self.hole & (1 << 8 * size) - 1) * self.microseconds
            step = max(self.microseconds, Fraction(1))
            for name, value in {"before": passed - 1, "at": passed, "after": passed + step}.items():
                if 0 <= value < 1 << 64:
                    yield StateCase(f"{name}-sentinel", {path: math.floor(value)})
        yield StateCase("unknown", {path: None})
