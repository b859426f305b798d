"""The contract of answers: what every kind of answer of a table tells the stages."""

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.answers.account import (
    Arriving,
    Origins,
    ReadBack,
    StateCase,
    Together,
    ToldNumber,
    Trait,
    Words,
    told_number,
)
from codegen.model.answers.known import Known, Value
from codegen.model.answers.scaling import Scaling
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode
from codegen.model.code.reading import Reading
from codegen.model.dialect.dialect import Dialect, WireField
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Citation, Component, Parameter, Quantity


@dataclass(frozen=True, slots=True)
class Elements:
    """The elements ``first`` to ``first + count - 1`` of a field, and what the table has ``written`` for them.

    ``by_others``: it has written nothing for them in particular; they are among its others.
    """

    field: WireField
    first: int
    count: int
    written: FieldAnswer
    citation: Citation
    by_others: bool = False

    @property
    def offset(self) -> int:
        """Byte offset of the first element in the payload."""
        return self.field.offset + self.first * self.field.type.size

    @property
    def label(self) -> str:
        """``voltages``, ``voltages[0]`` or ``voltages[1..9]``."""
        return self.field.label(self.first, self.count)

    @property
    def sentinel(self) -> str:
        """The dialect's sentinel of the field as it is written, or nothing."""
        return "" if self.field.sentinel is None else self.field.sentinel.written


class Answer(ABC):
    """The source of the values of some elements of a field. ``codegen/answers/`` has a module for each kind.

    The stages ask these methods and know no kind. What most kinds have in common is the default.
    """

    __slots__ = ()

    covers: Elements

    # The state and parameters that it reads.

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The quantities of the state that decide what goes out."""
        return ()

    @property
    def carried(self) -> tuple[Quantity, ...]:
        """Return the quantities whose numbers go out themselves."""
        return ()

    @property
    def withheld_for(self) -> tuple[Quantity, ...]:
        """The quantities that keep the message from being sent while one of them is unknown."""
        return ()

    def is_withheld(self, known: Known) -> bool:
        """Return whether one of these is unknown while the state is ``known``."""
        return any(known[quantity.path] is None for quantity in self.withheld_for)

    def withholding(self, code: PayloadCode) -> list[str]:
        """The statements that withhold the message then; nothing is written before them."""
        lines = []
        for quantity in self.withheld_for:
            lines += [f"if {code.is_unknown(quantity)}:  # {self.covers.label} cannot say so", "    return None"]
        return lines

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters that decide what goes out; of a family the first one."""
        return ()

    @property
    def conditions(self) -> Mapping[int, frozenset[str]] | None:
        """The bits that may be set, each with the paths of the booleans of which one has to be true; none for a bit
        that always is. None where it is no set of flags.
        """
        return None

    @property
    def shift(self) -> int | None:
        """Return which value of a list, from 0, the element 0 of its field would have; None where it is no list."""
        return None

    @property
    def is_chip_number(self) -> bool:
        """Return whether it is the number of the board's chip: it tells two boards with the same program apart."""
        return False

    # The values that go out.

    @abstractmethod
    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """Return what the elements carry while the state is ``known``, by exact arithmetic: one value for each; a text
        is one.

        ``instance`` and ``page`` count from 0.
        """

    @property
    def constants(self) -> tuple[Value, ...]:
        """The values that the table or the board states, of any instance; not what stands for unknown."""
        return ()

    @property
    def always(self) -> tuple[Value, ...] | None:
        """Return what the elements carry in every message; None where it can differ."""
        return None

    @property
    def scalings(self) -> tuple[Scaling, ...]:
        """The scalings of what is read when the message is built."""
        return ()

    @property
    def together(self) -> Together | None:
        """The values that go out together or not at all, where the answer has such."""
        return None

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Bytes up to the last that is not zero, at least and at most; 0 where all may be, or are, zero.

        The instance has a number from ``first`` to ``last`` in messages: a parameter may have that of the first one.
        """
        return 0, self.covers.field.type.size * self.covers.count

    # The lines with which the firmware writes it.

    @abstractmethod
    def statements(self, code: PayloadCode) -> list[str]:
        """The statements that write its elements, in the function of the message; a comment says which and why."""

    # Its account for people and for diff.

    @abstractmethod
    def words(self) -> Words:
        """Source, conversion and limits, for tables of documents, pages and ``explain``."""

    @abstractmethod
    def way(self, origins: Origins) -> Iterator[Step]:
        """The steps from the source to the number on the wire; the bytes are not among them."""

    @abstractmethod
    def traits(self, position: int) -> Iterator[Trait]:
        """Yield each attribute that a change of the answer can be about, for its element at ``position``, from 0."""

    @property
    def entries(self) -> tuple[str, ...]:
        """The names of entries of enums that it uses."""
        return ()

    # Its readings for receivers.

    @property
    def is_instance_number(self) -> bool:
        """Return whether it is the number by which receivers know the instance."""
        return False

    @property
    def tells_apart(self) -> bool:
        """Return whether it is another one for each instance."""
        return self.is_instance_number

    def is_fact(self, component: Component) -> bool:
        """Return whether a receiver for ``component`` takes the field as it stands, for a fact."""
        return False

    def readings(self, component: Component, dialect: Dialect) -> Iterator[Reading]:
        """Yield what the field says to a receiver for ``component``: quantities of it, and flags."""
        yield from ()

    def joint_readings(self, answers: Sequence["Answer"]) -> Iterator[Reading]:
        """Yield what several fields of a message say together; ``answers`` are all
        of it. The first of them tells it.
        """
        yield from ()

    def read_back(self) -> Iterator[ReadBack]:
        """The quantities that a receiver must know again, and how exactly."""
        yield from ()

    @property
    def told_quantities(self) -> tuple[Quantity, ...]:
        """The quantities whose numbers `told` finds in a message."""
        return (self.arriving.quantity,) if self.arriving else ()

    def told(self, wire: Sequence[int | float]) -> Iterator[ToldNumber]:
        """Yield what its elements, as numbers on the wire, tell of quantities."""
        arriving = self.arriving
        if arriving is not None:
            is_unknown = wire[0] == arriving.unknown or not math.isfinite(wire[0])
            step = 1 / (arriving.scaling.factor * arriving.quantity.steps)
            value = None if is_unknown else Fraction(wire[0]) * step
            yield told_number(arriving.quantity, value, step, self.covers.field.type)

    # Its cases for tests.

    @property
    def arriving(self) -> Arriving | None:
        """The number of the state that arrives, where the field carries one alone and tells it from unknown."""
        return None

    @property
    def varies(self) -> bool:
        """Return whether the state decides what goes out: such a field has cases of its own."""
        return False

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """States that show it at its limits and beyond; ``plain`` is a state in which all it reads is known."""
        yield from ()
