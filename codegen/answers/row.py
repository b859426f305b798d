"""A list of numbers for the elements of a field: it goes out as a whole, and single ones can be unknown."""

from collections.abc import Iterator
from dataclasses import replace

from codegen.answers.copied import CopiedAnswer
from codegen.answers.filling import comment, origin
from codegen.answers.fitting import WITHHELD
from codegen.answers.kind import KindOfAnswer
from codegen.answers.live import LiveAnswer
from codegen.answers.scope import Scope
from codegen.answers.source import taken
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, ReadBack, StateCase, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Stored, Value, is_known, shown_value
from codegen.model.answers.scaling import Scaling
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import ELEMENT, PayloadCode, each_element, indented
from codegen.model.code.reading import Reading
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import Dialect, SentinelForm
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Component, Quantity

UNEQUAL_LENGTH = Rule(
    "unequal-length",
    "A list goes out as a whole: a quantity with 'elements: 4' answers a field of four elements, or four that follow "
    "one another, as in 'field[2..5]'. What is left over on either side would go out as something that nobody set.",
)


@dataclass(frozen=True, slots=True)
class RowAnswer(KindOfAnswer):
    """The values of a list, one in each element; ``parts`` are the runs of elements that say unknown alike.

    Each part is the answer for one value of it, told by the number of its first element and of the one behind it.
    With ``whole`` the dialect knows only that the whole field is unknown: that, and zeros behind it, goes out while one
    of the values is unknown.
    Source: the dialect's ``invalid``, of which ``[V:]`` is the form for a whole array.
    """

    SHAPED_BY = frozenset({"min", "max", "rounding"})

    covers: Elements
    source: Quantity
    parts: tuple[tuple[LiveAnswer, int, int], ...]
    whole: int | float | None = None

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``state: component.quantity``, where that is a list of a length that the table says."""
        component, _, name = (written.state or "").partition(".")
        owner = scope.components.get(component)
        quantity = owner.quantities.get(name) if owner else None
        return quantity is not None and quantity.is_row and not written.split and written.each is None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "RowAnswer | None":
        """The list, which is as long as what it goes into, and what each of its values becomes."""
        source = scope.quantity(covers.written.state or "", covers.written.at("state"))
        if source is None:
            return None
        count = (source.elements or (0,))[0]
        if count != covers.count:
            message = f"{source.path} has {_counted(count)}, and {covers.label} is {covers.count}"
            hint = f"elements: {covers.count}"
            if count < covers.field.count:
                hint += f", or answer a part: {covers.field.name}[{covers.first}..{covers.first + count - 1}]"
            related = [(source.spec.at("elements"), "the list gets its length here")]
            scope.report.add(UNEQUAL_LENGTH, covers.written.at("state"), message, hint, related)
            return None
        sentinel = covers.field.sentinel
        sentinels = sentinel.values[covers.first : covers.first + count] if sentinel else (None,) * count
        is_whole = sentinel is not None and sentinel.form is SentinelForm.FIRST and covers.first == 0
        is_whole = is_whole and source.initial is None
        kind = LiveAnswer if source.storage is Storage.SMALL else CopiedAnswer
        parts = []
        for first, end in _runs(sentinels):
            one = Elements(covers.field, covers.first + first, 1, covers.written, covers.citation)
            found = taken(one, source.element, "state", scope.report)
            part = None if found is None else kind.of(found, one, scope, is_known=is_whole)
            if part is None:
                return None
            parts.append((replace(part, covers=covers), first, end))
        return cls(covers, source, tuple(parts), sentinels[0] if is_whole else None)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The list."""
        return (self.source,)

    @property
    def carried(self) -> tuple[Quantity, ...]:
        """The same, once for each part."""
        return (self.source,) * len(self.parts)

    @property
    def withheld_for(self) -> tuple[Quantity, ...]:
        """The list, where no number of one of its elements means unknown."""
        return self.quantities if self._withholds else ()

    def is_withheld(self, known: Known) -> bool:
        """Return whether one of the values is unknown, where that withholds the message."""
        return self._withholds and not is_known(self.source, known)

    def withholding(self, code: PayloadCode) -> list[str]:
        """Look at each of the values."""
        if not self._withholds:
            return []
        test = [f"if {code.is_unknown(self.source, ELEMENT)}:  # {self.covers.label} cannot say so", "    return None"]
        return each_element(0, self.covers.count, test)

    @property
    def _withholds(self) -> bool:
        return any(part.withholds for part, _, _ in self.parts)

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """Return what each value becomes."""
        if self.whole is not None and not is_known(self.source, known):
            return (self.whole, *[0] * (self.covers.count - 1))
        kept = known[self.source.path]
        values = kept if isinstance(kept, tuple) else (None,) * self.covers.count
        return tuple(
            value
            for part, first, end in self.parts
            for one in values[first:end]
            for value in part.values({**known, self.source.path: one}, instance, page)
        )

    @property
    def scalings(self) -> tuple[Scaling, ...]:
        """Return the scaling of each part."""
        return tuple(part.scaling for part, _, _ in self.parts)

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return the bytes up to those of the last part, which lies behind all others."""
        part, begin, end = self.parts[-1]
        size = self.covers.field.type.size
        least, most = part.used_bytes(first, last)
        if self.whole is not None or (begin and not least):
            least = 0
        return (least + size * (end - 1) if least else 0), size * (end - 1) + most

    def statements(self, code: PayloadCode) -> list[str]:
        """Value by value in a loop, in the order of the wire."""
        lines = [line for part, first, end in self.parts for line in self._turns(code, part, first, end)]
        head = comment(self.covers, origin(self.covers, self.source))
        if self.whole is None:
            return [head, *lines]
        known = code.is_unknown(self.source, ELEMENT).replace(" == ", " != ")
        unknown = [*code.store(self.covers, self.whole, over=True)]
        zero = code.store(self.covers, 0, element=ELEMENT, over=True)
        return [
            f"{head}, while all are known",
            f"{ELEMENT} = 0",
            f"while {ELEMENT} < {self.covers.count} and {known}:",
            f"    {ELEMENT} += 1",
            f"if {ELEMENT} == {self.covers.count}:",
            *indented(lines),
            f"else:  # goes out as {shown_value(self.whole)}, and zeros",
            *indented([*each_element(0, self.covers.count, zero), *unknown]),
        ]

    def _turns(self, code: PayloadCode, part: LiveAnswer, first: int, end: int) -> list[str]:
        return each_element(first, end, part.written(code, ELEMENT))

    def words(self) -> Words:
        """The path of the list; the conversion and the limits of its values."""
        words = [part.words() for part, _, _ in self.parts]
        limits = dict.fromkeys(each.limits for each in words)
        return Words(f"each of {self.source.path}", words[0].conversion, "; ".join(limits))

    def way(self, origins: Origins) -> Iterator[Step]:
        """The list, then what is done so that each value fits."""
        yield from origins.steps(self.source)
        yield Step("elements", f"each of {self.source.path}", (), (str(self.covers.citation),))
        seen: dict[Step, None] = {}
        for part, _, _ in self.parts:
            steps = list(part.way(_Nowhere()))
            seen |= dict.fromkeys(step for step in steps if step != WITHHELD)
        yield from seen
        if self.whole is not None:
            text = f"{shown_value(self.whole)}, the dialect's {self.covers.sentinel}, and zeros"
            yield Step("unknown", text, ("goes out while one of the values is not known",), ())
        if self._withholds:
            yield WITHHELD

    @property
    def shift(self) -> int:
        """The list begins at the first element that it covers."""
        return -self.covers.first

    def traits(self, position: int) -> Iterator[Trait]:
        """Yield the number of the list's value in this element, then the traits of that value."""
        part = next((part for part, first, end in self.parts if first <= position < end), self.parts[-1][0])
        shift = f" - {self.covers.first}" if self.covers.first else ""
        yield Trait("source", f"value i{shift} of {self.source.path} in element i", Aspect.SOURCE)
        for trait in part.traits(position):
            if trait.attribute == "unknown" and self.whole is not None:
                yield Trait("unknown", f"{shown_value(self.whole)} and zeros, while one is unknown", Aspect.UNKNOWN)
            elif trait.attribute != "source":
                yield trait

    def is_fact(self, component: Component) -> bool:
        """Unless it is a quantity of the component itself."""
        return self.source.component != component.name

    def readings(self, component: Component, dialect: Dialect) -> Iterator[Reading]:
        """Yield nothing: receivers take the field as it stands."""
        yield from ()

    def read_back(self) -> Iterator[ReadBack]:
        """None."""
        yield from ()

    @property
    def varies(self) -> bool:
        """Return True: it changes with its source."""
        return True

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """All values at the ends of the range and beyond; some of them unknown, only one of them known."""
        path, rows = self.source.path, dict[str, Stored]()
        values = plain[path]
        assert isinstance(values, tuple)
        for part, first, end in self.parts:
            one = replace(part, covers=replace(self.covers, first=self.covers.first + first, count=1))
            for case in one.cases({**plain, path: values[first]}, instances, pages):
                value = case.changes[path]
                assert not isinstance(value, tuple | str)
                if case.written is None:
                    name = case.name if len(self.parts) == 1 else f"{first}-{case.name}"
                    rows[name] = tuple(value if first <= at < end else kept for at, kept in enumerate(values))
        for at in sorted({0, len(values) // 2, len(values) - 1}):
            rows[f"without-{at}"] = tuple(None if place == at else kept for place, kept in enumerate(values))
            rows[f"only-{at}"] = tuple(kept if place == at else None for place, kept in enumerate(values))
        for name, row in rows.items():
            yield StateCase(name, {path: row})


class _Nowhere(Origins):
    """Tells nothing of where a value comes from: that of a list is told once."""

    def steps(self, source: object) -> tuple[Step, ...]:
        return ()


def _counted(count: int) -> str:
    return "one value" if count == 1 else f"{count} values"


def _runs(sentinels: tuple[int | float | None, ...]) -> Iterator[tuple[int, int]]:
    """First and end of the elements that follow one another and have the same sentinel; NaN is one, too."""
    first = 0
    for at in range(1, len(sentinels) + 1):
        if at == len(sentinels) or repr(sentinels[at]) != repr(sentinels[first]):
            yield first, at
            first = at
