"""Types for reading a cell: where it stands, and the answer of a population table or the proposal that it yields."""

from collections.abc import Collection, Mapping
from dataclasses import field

from codegen.decode.record import decode_record
from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.load.yaml_tree import parse_yaml
from codegen.model.dialect.dialect import Dialect, EnumDefinition, WireField, WireMessage
from codegen.model.spec.population import FieldAnswer
from codegen.model.units.unit import Unit
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class Sources:
    """The possible sources of values. ``quantities`` has the unit of each path, None without a project."""

    dialect: Dialect
    quantities: Mapping[str, Unit] | None = None
    parameters: Collection[str] = field(default_factory=frozenset)
    for_each: str | None = None


@dataclass(frozen=True, slots=True)
class Target:
    """The elements that a row answers for: ``count`` of them from ``first`` on, all of them for a scalar."""

    message: WireMessage
    field: WireField
    first: int
    count: int

    @property
    def label(self) -> str:
        """``voltages``, ``voltages[0]`` or ``voltages[1..9]``."""
        return self.field.label(self.first, self.count)

    @property
    def name(self) -> str:
        """``BATTERY_STATUS.voltages[0]``."""
        return f"{self.message.name}.{self.label}"

    @property
    def sentinel(self) -> int | float | None:
        """The number on the wire that means unknown in the first of these elements, if there is one."""
        sentinel = self.field.sentinel
        return None if sentinel is None else sentinel.values[self.first]

    @property
    def elements(self) -> range:
        """The elements by number."""
        return range(self.first, self.first + self.count)

    def enum(self, dialect: Dialect) -> EnumDefinition | None:
        """The enum of the field."""
        return dialect.enums.get(self.field.definition.enum or "")


@dataclass(frozen=True, slots=True)
class Reading:
    """The content of a cell as flow YAML: ``unknown`` or ``{state: battery.voltage}``.

    Either an ``answer``, or, where it cannot be read without guessing, a ``proposal`` for people to take or to leave.
    ``is_whole`` marks an answer that the document writes as the tables do, so that what it leaves out is left out.
    """

    answer: str | None = None
    proposal: str | None = None
    is_whole: bool = False


UNREAD = Reading()
"""Nothing can be said, and why has been reported."""


def field_answer(written: str, place: Place, report: Report) -> FieldAnswer | None:
    """The record that flow YAML of one line stands for, or None; findings lie in the line of ``place``, behind it."""
    found = Report()
    node = parse_yaml(written, place.file, found)
    answer = None if node is None else decode_record(node, FieldAnswer, found)
    for finding in found:
        at = place._replace(column=place.column + finding.place.column - 1)
        report.add(finding.rule, at, finding.message, finding.hint)
    return None if found.has_errors else answer
