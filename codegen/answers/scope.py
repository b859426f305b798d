"""The names that the answers of one table can refer to."""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence

from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.model.answers.answer import Elements
from codegen.model.dialect.dialect import Dialect, EnumDefinition
from codegen.model.spec.board import BoardSpec
from codegen.model.spec.population import PopulationSpec
from codegen.model.vehicle import Component, Parameter, Quantity
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class Pages:
    """The content of a message with pages: ``size`` values of ``quantity`` on each of ``count`` pages."""

    quantity: Quantity
    size: int
    count: int


@dataclass(frozen=True, slots=True)
class Scope(ABC):
    """The names that a table can use, and what is known of its message before its answers are bound.

    ``component`` is what the message is sent for each of, or None; ``elements`` is all that the table answers for.
    A look-up that finds nothing reports that, unless what was looked for is broken and has been reported already.
    """

    population: PopulationSpec
    board: BoardSpec
    dialect: Dialect
    components: Mapping[str, Component]
    component: Component | None
    elements: Sequence[Elements]
    pages: Pages | None
    report: Report

    @abstractmethod
    def quantity(self, path: str, place: Place) -> Quantity | None:
        """The quantity that is written as ``component.quantity``."""

    @abstractmethod
    def parameter(self, name: str, place: Place) -> Parameter | None:
        """The parameter of a name."""

    @abstractmethod
    def enum(self, name: str) -> EnumDefinition | None:
        """The enum that a field of the dialect names; None where there is none, which the dialect has a finding for."""

    @abstractmethod
    def entry(self, enum: EnumDefinition, name: str, place: Place) -> int | None:
        """The value of an entry of an enum."""

    @abstractmethod
    def is_unread(self, component: str) -> bool:
        """Return whether a component is written in a way that could not be read, which has been reported."""

    @abstractmethod
    def facts(self) -> list[str]:
        """Every fact that board.yaml states, as tables name them: ``battery.cells``."""
