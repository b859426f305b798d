"""Reads quantities back from the messages of a program: frames as they went out, decoded by the specification."""

import struct
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.answers.answer import Answer
from codegen.model.dialect.dialect import Kind
from codegen.model.quantities.precision import Precision
from codegen.model.system import PopulatedMessage, System

_NEW = 0xFD
"""The first byte of a frame of MAVLink 2."""


@dataclass(frozen=True, slots=True)
class Told:
    """A number that a message told: of an instance from 0, in the unit of the quantity; None for unknown.

    ``exact`` is the same before it became a float, and ``precision`` that of the field and of what is kept.
    """

    path: str
    instance: int
    value: float | None
    exact: Fraction | None = None
    precision: Precision = Precision()


class Telling:
    """Reads what frames tell; ``tables`` are all that a program sends."""

    def __init__(self, tables: Sequence[PopulatedMessage] = ()) -> None:
        """Take the tables that tell of any quantity."""
        self._tables: dict[int, list[PopulatedMessage]] = {}
        for table in tables:
            self._tables.setdefault(table.wire.id, []).append(table)
        self.ids = tuple(
            number for number, found in sorted(self._tables.items()) if any(paths_of(table) for table in found)
        )

    def read(self, frame: bytes, parameters: Mapping[str, float]) -> Iterator[Told]:
        """Yield what a whole frame tells; ``parameters`` are those that the program has."""
        is_new = frame[0] == _NEW
        number = int.from_bytes(frame[7:10], "little") if is_new else frame[5]
        tables = self._tables.get(number, [])
        if not tables:
            return
        payload = frame[10 if is_new else 6 :][: frame[1]].ljust(tables[0].wire.length, b"\0")
        for table in tables:
            if len(tables) == 1 or _is_meant(table, payload):
                yield from _read(table, payload, parameters)
                return


def paths_of(table: PopulatedMessage) -> tuple[str, ...]:
    """The quantities that a table tells, of instances that its messages name."""
    quantities = (quantity for answer in table.answers for quantity in answer.told_quantities)
    return tuple(quantity.path for quantity in quantities if table.tells_of(quantity.component))


def told_paths(system: System) -> tuple[str, ...]:
    """The quantities that the messages of a program tell, each once."""
    return tuple(dict.fromkeys(path for table in system.messages for path in paths_of(table)))


def _read(table: PopulatedMessage, payload: bytes, parameters: Mapping[str, float]) -> Iterator[Told]:
    paths = paths_of(table)
    instance = _instance(table, payload, parameters)
    for answer in table.answers:
        if answer.told_quantities:
            for told in answer.told(_numbers(answer, payload)):
                path, exact = told.quantity.path, told.value
                whose = 0 if told.quantity.component in table.represents else instance
                if path in paths and whose is not None:
                    yield Told(path, whose, None if exact is None else float(exact), exact, told.precision)


def _instance(table: PopulatedMessage, payload: bytes, parameters: Mapping[str, float]) -> int | None:
    """Whose message it is, from 0; None where no instance has its number."""
    component = table.component
    if component is None:
        return 0
    answer = next((each for each in table.answers if each.is_instance_number), None)
    if answer is None or component.instances == 1:
        return 0
    first = component.first_number
    begin = 0 if first is None else round(parameters.get(first.name, float(first.default * first.step)))
    instance = int(_numbers(answer, payload)[0]) - begin
    return instance if 0 <= instance < component.instances else None


def _is_meant(table: PopulatedMessage, payload: bytes) -> bool:
    """Return whether all that a table always says stands in a message: several tables may share its number."""
    for answer in table.answers:
        always = answer.always
        if always is None:
            continue
        field = answer.covers.field
        if field.type.kind is Kind.CHAR:
            text = payload[field.offset : field.offset + field.size].split(b"\0")[0]
            if text != str(always[0]).encode()[: field.size]:
                return False
        elif any(
            struct.pack(f"<{field.type.code}", number) != struct.pack(f"<{field.type.code}", expected)
            for number, expected in zip(_numbers(answer, payload), always, strict=True)
        ):
            return False
    return True


def _numbers(answer: Answer, payload: bytes) -> tuple[int | float, ...]:
    """The elements of an answer in a payload that is filled up with zeros."""
    covers = answer.covers
    return struct.unpack_from(f"<{covers.count}{covers.field.type.code}", payload, covers.offset)
