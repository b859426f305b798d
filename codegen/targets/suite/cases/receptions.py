"""Cases for the tables of received messages: what arrives, in steps, and which criterion each case shows.

What has to come of them the suite computes by itself: templates/tests/receives/receives_model.py.
"""

import struct
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.reception import Proviso, ReceivedField, Reception
from codegen.model.spec.receive import Sender
from codegen.model.system import System

GROUND_STATION = 255, 190
_COUNTED = 6  # fields that are refused more than once
Value = int | float | str
Step = Mapping[str, object]


@dataclass(frozen=True, slots=True)
class ReceptionCase:
    """``name`` within its table; ``steps`` are frames, or times that pass."""

    table: str
    name: str
    requirement: str
    steps: tuple[Step, ...]

    @property
    def identifier(self) -> str:
        """Return what the suite calls it."""
        return f"{self.table}-{self.name}-{self.requirement}"


def reception_cases(system: System) -> Iterator[ReceptionCase]:
    """Yield the cases of all tables."""
    for table in system.receptions:
        yield from _Cases(table, system).cases()


class _Cases:
    """The cases of one table."""

    def __init__(self, table: Reception, system: System) -> None:
        self._table = table
        self._own = system.system_id, system.component_id
        self._plain = {each.label: _plain(each) for each in table.fields}
        self._said = _said([proviso for each in table.fields for proviso in each.provisos], {})
        # The value of a quantity after this is seen at the next change.
        is_own = table.spec.sender is Sender.OWN_SYSTEM
        self._sender = (self._own[0], self._own[1] % 255 + 1) if is_own else GROUND_STATION
        self._before = [] if table.spec.sender is not Sender.GROUND_STATION else [_heartbeat(self._sender)]

    def cases(self) -> Iterator[ReceptionCase]:
        for taken in self._table.fields:
            yield from self._of_field(taken)
        yield from self._of_table()

    def _of_field(self, taken: ReceivedField) -> Iterator[ReceptionCase]:
        own, table = str(taken.citation), self._table
        is_asked = taken.spec.requirement is not None
        by_range = own if is_asked and "range" not in table.aspects else table.cited("range")
        by_sentinel = own if is_asked and "sentinel" not in table.aspects else table.cited("sentinel")
        for name, value in _taken_values(taken).items():
            yield self._case(
                f"{taken.label}-{name}",
                own,
                self._message(taken=taken),
                self._message({taken.label: value}, taken=taken),
            )
        for name, value in _refused_values(taken).items():
            yield self._case(
                f"{taken.label}-{name}",
                by_range,
                self._message(taken=taken),
                self._message({taken.label: value}, taken=taken),
            )
        for name, value in _unknown_values(taken).items():
            speaking = taken.speaking if name == "sentinel" else (taken.element,)
            values = {f"{taken.field.name}[{each}]": value for each in speaking} if taken.field.is_array else {}
            values = {taken.label: value} if taken.is_text or not values else values
            yield self._case(
                f"{taken.label}-{name}", by_sentinel, self._message(taken=taken), self._message(values, taken=taken)
            )
        for name, value in _beside_values(taken).items():
            yield self._case(
                f"{taken.label}-{name}",
                by_sentinel,
                self._message(taken=taken),
                self._message({taken.label: value}, taken=taken),
            )
        for number in taken.unchanged:
            steps = (self._message(taken=taken), self._message({taken.label: number}, taken=taken))
            yield self._case(f"{taken.label}-unchanged-{number}", by_sentinel, *steps)
            yield self._case(f"{taken.label}-unchanged-{number}-alone", by_sentinel, *steps[1:])
        for number, (field, said) in enumerate(_broken(taken.provisos), 1):
            steps = (self._message(taken=taken), self._message(others={field: said}, taken=taken))
            yield self._case(f"{taken.label}-no-value-{number}", by_sentinel, *steps)
            yield self._case(f"{taken.label}-no-value-{number}-alone", by_sentinel, *steps[1:])
        after_ms = taken.quantity.trust.stale_after_ms
        if taken.quantity.ages and after_ms is not None:
            cited = table.cited("stale_after") or own
            yield self._case(f"{taken.label}-in-time", cited, self._message(taken=taken), {"ms": after_ms})
            yield self._case(f"{taken.label}-too-old", cited, self._message(taken=taken), {"ms": after_ms + 1})
            refreshed = (self._message(taken=taken), {"ms": after_ms}, self._message(taken=taken), {"ms": after_ms})
            yield self._case(f"{taken.label}-again", cited, *refreshed)
            for name, left in self._leaving(taken):  # it grows stale as if that message had not come
                yield self._case(
                    f"{taken.label}-{name}", cited, self._message(taken=taken), {"ms": after_ms}, left, {"ms": 1}
                )

    def _leaving(self, taken: ReceivedField) -> Iterator[tuple[str, Step]]:
        """Yield what may leave the quantity as it was: numbers that say so or are not plausible, and other fields."""
        for number in taken.unchanged:
            yield f"left-{number}", self._message({taken.label: number}, taken=taken)
        for value in list(_refused_values(taken).values())[:1]:
            yield "refused-and-old", self._message({taken.label: value}, taken=taken)
        for field, said in list(_broken(taken.provisos))[:1]:
            yield "no-value-and-old", self._message(others={field: said}, taken=taken)

    def _of_table(self) -> Iterator[ReceptionCase]:
        table = self._table
        cited = str(table.citation)
        zeros: dict[str, Value] = {each.label: "" if each.is_text else 0 for each in table.fields}
        yield self._case("truncated", cited, self._message(), self._message(zeros))
        refused = [(each.label, value) for each in table.fields for value in list(_refused_values(each).values())[:1]]
        often = [
            self._message({label: value}) for at, (label, value) in enumerate(refused[:_COUNTED]) for _ in range(at + 2)
        ]
        if often:  # each field another number of times, so that none is counted for another one
            yield self._case("refused-in-turn", table.cited("range"), *often)
        yield self._case("others-are-zero", cited, self._message())
        if table.wire.id <= 255:
            yield self._case("MAVLink-1", cited, self._message(), self._message(version=1))
        for field, number in table.conditions:
            other = number + 1 if number < field.type.maximum else number - 1
            yield self._case(f"other-{field.name}", cited, self._message(others={field.name: other}))
        target = table.cited("target")
        system, component = table.targets
        if system is not None:
            number = self._own[0] % 255 + 1
            yield self._case("for-another-system", target, self._message(others={system.name: number}))
            yield self._case("for-every-system", target, self._message(others={system.name: 0}))
        if component is not None:
            number = self._own[1] % 255 + 1
            yield self._case("for-another-component", target, self._message(others={component.name: number}))
            yield self._case("for-every-component", target, self._message(others={component.name: 0}))
        sender = table.cited("sender")
        yield self._case("own", sender, self._message(sender=self._own))
        another = (self._own[0] + 1) % 255 + 1, 1
        if table.spec.sender is not Sender.ANY:
            yield self._case("of-another-system", sender, self._message(sender=another))
        if table.spec.sender is Sender.GROUND_STATION:
            yield ReceptionCase(table.name, "of-nobody-heard", sender, (self._message(),))
            no_station = {**_heartbeat(another), "values": {"type": 2}}
            yield self._case("of-no-ground-station", sender, no_station, self._message(sender=another))

    def _case(self, name: str, requirement: str, *steps: Step) -> ReceptionCase:
        return ReceptionCase(self._table.name, name, requirement, (*self._before, *steps))

    def _message(
        self,
        values: Mapping[str, Value] | None = None,
        others: Mapping[str, int] | None = None,
        sender: tuple[int, int] | None = None,
        version: int = 2,
        taken: ReceivedField | None = None,
    ) -> Step:
        """A frame of the message, of plain values but for some; ``others`` are fields that the table does not take.

        Other fields say that ``taken`` is a value, and as far as that is possible beside it all others are.
        """
        system, component = self._table.targets
        about = {field.name: number for field, number in self._table.conditions}
        about |= {field.name: own for field, own in zip((system, component), self._own, strict=True) if field}
        said = {} if taken is None else _said(taken.provisos, self._said)
        step: dict[str, object] = {
            "message": self._table.wire.name,
            "values": {**self._plain, **self._said, **said, **about, **(values or {}), **(others or {})},
            "from": list(sender or self._sender),
        }
        return step | ({"version": version} if version != 2 else {})


def _heartbeat(sender: tuple[int, int]) -> dict[str, object]:
    """Return the HEARTBEAT of a ground station: MAV_TYPE_GCS is 6."""
    return {"message": "HEARTBEAT", "values": {"type": 6}, "from": list(sender)}


def _plain(taken: ReceivedField) -> Value:
    """A number somewhere within what is taken."""
    if taken.is_text:
        return "plain"[: taken.field.count]
    if not taken.field.type.is_integer:
        low, high = max(taken.low, Fraction(-1000)), min(taken.high, Fraction(1000))
        low, high = (taken.low, taken.high) if low > high else (low, high)
        return _held(taken, low + (high - low) * Fraction(3, 7))
    number = int(taken.low + (taken.high - taken.low) * Fraction(3, 7))
    while number in taken.special and number < taken.high:
        number += 1
    while number in taken.special:
        number -= 1
    return number


def _said(provisos: Sequence[Proviso], before: Mapping[str, int]) -> dict[str, int]:
    """The numbers of other fields with which all provisos hold that can; flags that none asks for are as ``before``."""
    found: dict[str, int] = {}
    for field in {each.field.name: each.field for each in provisos}.values():
        of_field = [each for each in provisos if each.field.name == field.name]
        wanted = [number for each in of_field if not each.is_denied for number in each.numbers]
        denied = [number for each in of_field if each.is_denied for number in each.numbers]
        if of_field[0].is_of_flags:
            bits = before.get(field.name, 0)
            for mask in wanted:
                bits |= mask
            for mask in denied:
                bits &= ~(mask & ~_united(wanted) or mask)
            found[field.name] = _signed(field, bits)
        else:
            candidates = (*wanted, *range(len(denied) + 1))
            found[field.name] = next((each for each in candidates if each not in denied), candidates[0])
    return found


def _broken(provisos: Sequence[Proviso]) -> Iterator[tuple[str, int]]:
    """Yield fields, each with a number of it with which one of the provisos does not hold, all others do that can."""
    held = _said(provisos, {})
    for each in provisos:
        field, number = each.field, held[each.field.name]
        for said in each.numbers:
            if each.is_of_flags:
                yield field.name, _signed(field, number | said if each.is_denied else number & ~said)
            elif each.is_denied:
                yield field.name, said
        if not each.is_of_flags and not each.is_denied:
            yield field.name, next(other for other in range(len(each.numbers) + 1) if other not in each.numbers)


def _united(masks: Sequence[int]) -> int:
    bits = 0
    for mask in masks:
        bits |= mask
    return bits


def _signed(field: WireField, bits: int) -> int:
    """The number that a field has with these bits."""
    bits &= (1 << 8 * field.type.size) - 1
    return bits if bits <= field.type.maximum else bits - (1 << 8 * field.type.size)


def _taken_values(taken: ReceivedField) -> dict[str, Value]:
    if taken.is_text:
        return {"full": "x" * taken.field.count, "one": "~"}
    found: dict[str, Value] = {"lowest": _number(taken, taken.ends[0]), "highest": _number(taken, taken.ends[1])}
    if taken.field.type.is_integer:
        if taken.factor.denominator != 1:  # a half, on both sides
            half = taken.factor.denominator // 2
            found |= {
                name: number
                for name, number in (("half", half), ("minus-half", -half))
                if taken.low <= number <= taken.high
            }
    elif taken.low <= 0 <= taken.high:
        found |= {"zero": 0.0, "minus-zero": -0.0}
        if not taken.quantity.storage.is_float:  # halves of a step, and what is next to nothing
            near = {"half": Fraction(1, 2), "minus-half": Fraction(-3, 2), "tiny": Fraction(1, 10**30)}
            found |= {name: _held(taken, number / taken.factor) for name, number in near.items()}
    return {name: value for name, value in found.items() if value not in taken.special and _is_within(taken, value)}


def _is_within(taken: ReceivedField, value: Value) -> bool:
    return isinstance(value, str) or taken.low <= Fraction(value) <= taken.high


def _refused_values(taken: ReceivedField) -> dict[str, Value]:
    field = taken.field
    if taken.is_text:
        return {"no-ascii": "é"}
    if not field.type.is_integer:
        least, most = Storage(field.type.code).limits
        ends = {"below": taken.low - abs(taken.low) / 1000 - 1, "above": taken.high + abs(taken.high) / 1000 + 1}
        held = {name: _held(taken, end) for name, end in ends.items() if least <= end <= most}
        return {name: value for name, value in held.items() if not taken.low <= Fraction(value) <= taken.high}
    low, high, smallest, largest = int(taken.low), int(taken.high), field.type.minimum, field.type.maximum
    limits = {"below": low - 1, "above": high + 1, "least": smallest, "most": largest}
    return {
        name: number
        for name, number in limits.items()
        if smallest <= number <= largest and not low <= number <= high and number not in taken.special
    }


def _unknown_values(taken: ReceivedField) -> dict[str, Value]:
    found: dict[str, Value] = {}
    if taken.sentinel is not None:
        found["sentinel"] = "" if taken.field.type.kind is Kind.CHAR else taken.sentinel
    found |= {f"unknown-{number}": number for number in taken.absent}
    if taken.field.type.kind is Kind.FLOAT:
        found |= {"nan": float("nan"), "infinite": float("inf"), "minus-infinite": -float("inf")}
    return found


_BITS = {"f": (12, 16), "d": (32, 48)}
"""Bits that make of a whole number as a float another one that all interpreters print alike."""


def _beside_values(taken: ReceivedField) -> dict[str, Value]:
    """Return numbers that differ from a special one in one bit, of each byte: they have none of its meaning."""
    field, found = taken.field, dict[str, Value]()
    for number in () if taken.is_text else taken.special:
        is_usual = field.type.is_integer or (number and float(number).is_integer())
        for bit in _BITS.get(field.type.code, range(0, 8 * field.type.size, 8)) if is_usual else ():
            code = f"<{field.type.code}"
            bits = bytearray(struct.pack(code, number))
            bits[bit // 8] ^= 1 << bit % 8
            (beside,) = struct.unpack(code, bits)
            if beside not in taken.special:
                found[f"beside-{number}-{bit}"] = beside
    return found


def _number(taken: ReceivedField, number: Fraction) -> Value:
    return int(number) if taken.field.type.is_integer else float(number)


def _held(taken: ReceivedField, number: Fraction) -> float:
    """The nearest float of the field's size."""
    code = f"<{taken.field.type.code}"
    held: float = struct.unpack(code, struct.pack(code, float(number)))[0]
    return held
