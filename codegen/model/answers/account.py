"""An answer's account of itself: a record for each stage that asks."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from enum import Enum, auto
from fractions import Fraction
from typing import NamedTuple

from codegen.frozen import dataclass
from codegen.model.answers.known import Stored
from codegen.model.answers.scaling import Scaling
from codegen.model.answers.step import Step
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import WireType
from codegen.model.quantities.precision import Precision, kept_with, share_of
from codegen.model.vehicle import Parameter, Quantity

FLAGS = " + "
"""The sign between the flags of a source in words."""


@dataclass(frozen=True, slots=True)
class Words:
    """Source, conversion and limits for a row of a table; empty where there is nothing to say."""

    source: str
    conversion: str = ""
    limits: str = ""


class Origins(ABC):
    """The steps up to a quantity or a parameter; the caller that prints the steps of an answer passes one."""

    @abstractmethod
    def steps(self, source: Quantity | Parameter) -> tuple[Step, ...]:
        """The steps up to where the source is kept, that one last."""


class Aspect(Enum):
    """The aspect of an answer that a fact is about: changes of each are reported under a rule of its own."""

    SOURCE = auto()
    CONSTANT = auto()
    FLAGS = auto()
    CONVERSION = auto()
    LIMITS = auto()
    UNKNOWN = auto()


class Trait(NamedTuple):
    """One attribute of an answer, as text that differs exactly when the attribute does."""

    attribute: str
    text: str
    aspect: Aspect


@dataclass(frozen=True, slots=True)
class StateCase:
    """A state that tests of a field set: ``changes`` of a plain state, by path, about an instance and a page from 0.

    ``written`` is a quantity that is set through its property for people, and to what: ``"nan"``, ``"inf"`` and
    ``"-inf"`` stand for the floats.
    """

    name: str
    changes: Mapping[str, Stored]
    instance: int = 0
    page: int = 0
    written: tuple[Quantity, float | str | None] | None = None


@dataclass(frozen=True, slots=True)
class Together:
    """Values of ``source``, one for each element, that go out together while there are at most ``room`` of them.

    ``instead`` is what goes out otherwise, or None where that is unknown.
    """

    source: Quantity
    room: int
    instead: Quantity | None


@dataclass(frozen=True, slots=True)
class Arriving:
    """A number of the state that a field carries alone: how it is scaled, and what says that it is unknown."""

    quantity: Quantity
    scaling: Scaling
    unknown: int | float | None


@dataclass(frozen=True, slots=True)
class ToldNumber:
    """A number that a message tells of a quantity, exactly, in its unit; None for unknown."""

    quantity: Quantity
    value: Fraction | None
    precision: Precision


def told_number(quantity: Quantity, value: Fraction | None, step: Fraction, wire_type: WireType) -> ToldNumber:
    """Return it with its precision: that of the field, of which 1 is ``step`` in the unit, or of what is kept."""
    kept = kept_with(quantity.storage, quantity.steps)
    if wire_type.is_integer:
        return ToldNumber(quantity, value, Precision(max(step, kept.step), kept.share))
    share = share_of(Storage.BINARY32 if wire_type.size == 4 else Storage.BINARY64)
    return ToldNumber(quantity, value, Precision(kept.step, max(share, kept.share)))


@dataclass(frozen=True, slots=True)
class ReadBack:
    """The expectations of a receiver's tests for a quantity: ``about`` has the keys of ``receiver_facts.json``."""

    quantity: Quantity
    about: Mapping[str, object]
