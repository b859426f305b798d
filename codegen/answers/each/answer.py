"""The answer: a value for each element, limited as every live value, over the fields of a message or its pages."""

from collections.abc import Iterator, Sequence

from codegen.answers.each.elements import BAD_EACH, can_take, has_all, room_of, unknown_of
from codegen.answers.each.reading import element_readings
from codegen.answers.filling import apart, comment, fitted, origin
from codegen.answers.fitting import WITHHELD
from codegen.answers.kind import POINTLESS_KEY, KindOfAnswer
from codegen.answers.limits import Bounds, check_declared, check_reach, scaling_of
from codegen.answers.scaled import conversion_trait, conversion_words, fitting, limit_cases, limit_words, sentinel_cases
from codegen.answers.scope import Scope
from codegen.answers.source import taken
from codegen.answers.split import SplitAnswer
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, ReadBack, StateCase, Together, ToldNumber, Trait, Words
from codegen.model.answers.answer import Answer, Elements
from codegen.model.answers.known import Known, Stored, Value
from codegen.model.answers.scaling import Scaling
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode, indented
from codegen.model.code.reading import Reading
from codegen.model.code.storage import is_small
from codegen.model.spec.population import FieldAnswer, Send
from codegen.model.vehicle import Quantity


@dataclass(frozen=True, slots=True)
class EachAnswer(KindOfAnswer):
    """One value of a quantity with elements for each covered element, from the value ``first`` on.

    On pages (``is_paged``) ``first`` counts from the begin of the page. What is unknown, and what lies beyond the last
    value, becomes ``unknown``, the sentinel of every element. With a ``room`` the values go out together or not at all:
    only while all of them are known and no more than the ``room`` that the message has; otherwise ``fallback`` goes
    out, or ``unknown`` in every element.
    Where the field has no sentinel, and there is a value for each of its elements, the answer ``withholds`` the message
    while one of these is unknown.
    Source: the dialect's text for BATTERY_STATUS.voltages.
    """

    SHAPED_BY = frozenset({"from", "split", "min", "max", "rounding"})

    covers: Elements
    source: Quantity
    first: int
    scaling: Scaling
    unknown: int | None
    is_paged: bool = False
    fallback: SplitAnswer | None = None
    room: int | None = None
    withholds: bool = False

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``each: component.quantity``."""
        return written.each is not None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "EachAnswer | None":
        """The values from the one that the table names on, and what is split in their place."""
        written, report = covers.written, scope.report
        if written.state is None and "split" in written.places:
            report.add(
                POINTLESS_KEY,
                written.at("split"),
                "split says nothing without state beside each",
                hint="leave split out, or add state: a quantity for what has no values one by one",
            )
        place = written.at("each")
        quantity = scope.quantity(written.each or "", place)
        fallback = None
        if written.state is not None:
            if not written.split:
                report.add(BAD_EACH, written.at("state"), "state beside each is what is split instead", "split: true")
                return None
            fallback = SplitAnswer.bind(covers, scope)
        if quantity is None or (written.state is not None and fallback is None):
            return None
        is_paged = scope.pages is not None and scope.pages.quantity is quantity
        if not can_take(covers, quantity, is_paged, scope):
            return None
        found = taken(covers, quantity, "each", report)
        if found is None:
            return None
        room = None if is_paged else room_of(covers, scope)
        withholds = room is None and not is_paged and _withholds(covers, quantity, scope)
        unknown = None if withholds else unknown_of(covers, quantity, scope)
        if unknown is None and not withholds:
            return None
        scaling = scaling_of(covers.field, unknown, found.bounds, found.factor, written, report)
        if scaling is None:
            return None
        check_reach(covers, found.written, scaling, unknown, report)
        check_declared(covers, found, Bounds(scaling.low, scaling.high), report)
        return cls(covers, quantity, written.first, scaling, unknown, is_paged, fallback, room, withholds)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The one with the values, and the one that goes out in their place."""
        return (self.source, *(self.fallback.quantities if self.fallback else ()))

    @property
    def absent(self) -> int:
        """Return what an element has that has no value: the sentinel; where each has one, that does not happen."""
        return 0 if self.unknown is None else self.unknown

    @property
    def withheld_for(self) -> tuple[Quantity, ...]:
        """The one with the values, where the field cannot say that one of them is unknown."""
        return (self.source,) if self.withholds else ()

    def is_withheld(self, known: Known) -> bool:
        """Return whether one of the values that it carries is unknown, where that withholds the message."""
        values = known[self.source.path] if self.withholds else ()
        assert isinstance(values, tuple)
        return None in values[self.first : self.first + self.covers.count]

    def withholding(self, code: PayloadCode) -> list[str]:
        """Look at each of these values."""
        if not self.withholds:
            return []
        end = self.first + self.covers.count
        return [
            f"place = {self.first}",
            f"while place < {end}:  # {self.covers.label} cannot say so",
            *indented([f"if {code.is_unknown(self.source, 'place')}:", "    return None", "place += 1"]),
        ]

    @property
    def carried(self) -> tuple[Quantity, ...]:
        """The same, but for values that there are not: the field begins behind the last one."""
        return self.quantities if self._is_reached else self.quantities[1:]

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The values that are known, and the sentinel."""
        stored = known[self.source.path]
        values = stored if isinstance(stored, tuple) else ()
        count = self.covers.count
        if self.room is not None and (None in values or not 0 < len(values) <= self.room):
            return self.fallback.values(known, instance, page) if self.fallback else (self.absent,) * count
        first = page * count if self.is_paged else self.first
        row = values[first : first + count]
        sent = [self.absent if value is None else self.scaling.whole(int(value)) for value in row]
        return (*sent, *[self.absent] * (count - len(sent)))

    @property
    def scalings(self) -> tuple[Scaling, ...]:
        """Return the scaling of the elements, if any is reached, and those of the answer that stands in for them."""
        return (*((self.scaling,) if self._is_reached else ()), *(self.fallback.scalings if self.fallback else ()))

    @property
    def _is_reached(self) -> bool:
        return self.is_paged or self.first < max(self.source.elements or (0,))

    @property
    def together(self) -> Together | None:
        """The values, where they go out together or not at all."""
        if self.room is None or self.is_paged:
            return None
        return Together(self.source, self.room, self.fallback.source if self.fallback else None)

    def statements(self, code: PayloadCode) -> list[str]:
        """Value by value; where they go out together, only after it was looked whether all are known."""
        covers, fallback = self.covers, self.fallback
        words = origin(covers, self.source) + (f", from {self.first}" if self.first else "")
        words += ", a page of them" if self.is_paged else ""
        words += " while all are known" if self.room is not None else ""
        words += f", else {origin(covers, fallback.source)}, spilling above {fallback.element_high}" if fallback else ""
        head = [comment(covers, words)]
        most = max(self.source.elements or (0,))
        if not self.is_paged and self.first >= most:
            return [*head, f"# there are {most}: all unknown", *code.fill(covers, self.absent)]
        if self.room is None:
            return [*head, *self._each(code)]
        each = self._each(code)
        others = fallback.spilled(code) if fallback else code.fill(covers, self.absent)
        count = code.count(self.source)
        known = code.is_known(self.source, "place")
        fits = f"place == {count}" if most <= self.room else f"place == {count} and place <= {self.room}"
        return [
            *head,
            "place = 0",
            f"while place < {count} and {known}:",
            "    place += 1",
            f"if {fits}:",
            *indented(each),
            "else:",
            *indented(others),
        ]

    def _each(self, code: PayloadCode) -> list[str]:
        covers, last = self.covers, self.covers.first + self.covers.count
        count, most = code.count(self.source), max(self.source.elements or (0,))
        shift = self.first - covers.first
        if self.is_paged:
            source = f"place + page * {covers.count}{f' - {covers.first}' if covers.first else ''}"
        else:
            source = f"place + {shift}" if shift > 0 else f"place - {-shift}" if shift else "place"
        varies = self.is_paged or not count.isdigit()
        bounds = [f"{source} < {count}"] if varies and not self.withholds else []
        end = last if bounds else min(last, most - shift)
        place = "place < " + str(end)
        store = code.store_at(covers, "place", "value")
        element = [f"value = {code.read(self.source, source)}"]
        if self.unknown is None or is_small(self.unknown):
            element += [*fitted(self.scaling, self.unknown), *store]
        else:
            turn = f"(place - {covers.first})" if covers.first else "place"
            unknown = code.store(covers, self.unknown, element=turn, over=True)
            element += apart(self.unknown, unknown, [*fitted(self.scaling, None), *store])
        element.append("place += 1")
        return [
            f"place = {covers.first}",
            f"while {' and '.join([place, *bounds])}:",
            *indented(element),
            *(code.rest(covers, self.unknown) if self.unknown is not None and (bounds or end < last) else []),
        ]

    def words(self) -> Words:
        """Return which values, how each is scaled, and its limits on the wire."""
        source = f"each of {self.source.path}"
        source += f", from {self.first}" if self.first else ""
        source += ", by pages" if self.is_paged else ""
        conversion = conversion_words(self.covers, self.source, self.scaling)
        if self.fallback is not None:
            source += f", else {self.fallback.source.path}"
            conversion += f"; else spills above {self.fallback.element_high}"
        elif self.room is not None:
            source += ", while all are known"
        return Words(source, conversion, limit_words(self.scaling))

    def way(self, origins: Origins) -> Iterator[Step]:
        """The values; where they stand in for a quantity that is spread over the elements, that one first."""
        words = self.words()
        own = (str(self.covers.citation),)
        all_known = (f"while all are known and no more than {self.room}",) if self.room is not None else ()
        if self.fallback is None:
            yield from origins.steps(self.source)
            yield Step("elements", words.source, all_known, own)
        else:
            yield from origins.steps(self.fallback.source)
            *source, state = origins.steps(self.source)
            details = (*all_known, *(step.text for step in source), *state.details)
            criteria = tuple(dict.fromkeys((*own, *state.criteria)))
            yield Step("instead", f"each of {self.source.path}, if there are such", details, criteria)
        element_high = self.fallback.element_high if self.fallback else None
        yield from fitting(self.covers, self.scaling, words.conversion, self.unknown, element_high)
        if self.withholds:
            yield WITHHELD

    @property
    def shift(self) -> int:
        """Return how far the number of a value is above that of its element."""
        return self.first - self.covers.first

    def traits(self, position: int) -> Iterator[Trait]:
        """Yield which value is in which element, scaling, limits and sentinel, and what goes out otherwise."""
        shift = self.shift  # so that the elements of a field say the same
        number = "i" if not shift else f"i {'+' if shift > 0 else '-'} {abs(shift)}"
        paged = " of the page" if self.is_paged else ""
        room = "" if self.room is None else f", while all of at most {self.room} are known"
        yield Trait("source", f"value {number}{paged} of {self.source.path} in element i{room}", Aspect.SOURCE)
        yield conversion_trait(self.covers, self.source, self.scaling)
        yield Trait("limits", limit_words(self.scaling, "as"), Aspect.LIMITS)
        yield Trait("unknown", WITHHELD.text if self.withholds else str(self.unknown), Aspect.UNKNOWN)
        for trait in self.fallback.traits(position) if self.fallback else ():
            yield trait._replace(attribute=f"otherwise {trait.attribute}")

    def joint_readings(self, answers: Sequence[Answer]) -> Iterator[Reading]:
        """The values of all fields of the message that take some of them, and their sum."""
        takers = [other for other in answers if isinstance(other, EachAnswer) and other.source.path == self.source.path]
        if takers[0] is self:
            yield from element_readings(takers, answers)

    @property
    def told_quantities(self) -> tuple[Quantity, ...]:
        """Return what goes out in place of the values, which is their sum: it can be
        told whichever of them went out.
        """
        return self.fallback.told_quantities if self.fallback else ()

    def told(self, wire: Sequence[int | float]) -> Iterator[ToldNumber]:
        """The same."""
        if self.fallback:
            yield from self.fallback.told(wire)

    def read_back(self) -> Iterator[ReadBack]:
        """The sum. Pages, and what is spread where single values are unknown, have tests of their own."""
        for one in self.fallback.read_back() if self.fallback else ():
            yield ReadBack(one.quantity, {**one.about, "unless": self.source.attribute})

    @property
    def varies(self) -> bool:
        """Return True: it changes with its source."""
        return True

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """All values at the ends of the range and beyond, each of them unknown, only one of them known."""
        path = self.source.path
        values = plain[path]
        assert isinstance(values, tuple)
        rows: dict[str, Stored] = {}
        for case in (*limit_cases(self.scaling, path), *sentinel_cases(self.covers, self.scaling, path)):
            value = case.changes[path]
            if isinstance(value, int):
                rows[case.name] = (value,) * len(values)
        for index in range(len(values)):
            rows[f"without-{index}"] = tuple(None if place == index else one for place, one in enumerate(values))
            rows[f"only-{index}"] = tuple(one if place == index else None for place, one in enumerate(values))
        for name, row in rows.items():
            for page in range(pages):
                yield StateCase(f"{name}-page-{page}" if pages > 1 else name, {path: row}, page=page)
        for case in self.fallback.value_cases() if self.fallback else ():
            yield StateCase(f"fallback-{case.name}", {path: rows["without-0"], **case.changes})


def _withholds(covers: Elements, quantity: Quantity, scope: Scope) -> bool:
    """Return whether a field without a sentinel withholds its message: each of its elements gets a value of its own."""
    if covers.field.sentinel is not None or scope.population.send is not Send.WHILE_KNOWN:
        return False
    return has_all(covers, quantity, covers.written.first)
