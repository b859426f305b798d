"""The answer that is the number of instances of a component."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.answers.constant import read_constant
from codegen.answers.fitting import BAD_SOURCE
from codegen.answers.instance import bytes_of
from codegen.answers.kind import KindOfAnswer
from codegen.answers.scope import Scope
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Component


@dataclass(frozen=True, slots=True)
class CountAnswer(KindOfAnswer):
    """The number of instances of ``component`` in board.yaml, switched on or not."""

    covers: Elements
    component: str
    count: int

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``state: component.instances``; a quantity of that name comes first."""
        owner, _, name = (written.state or "").partition(".")
        component = scope.components.get(owner) if written.each is None else None
        return name == "instances" and component is not None and name not in component.quantities

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "CountAnswer | None":
        """The number, in one integer without a unit that can carry it and does not take it for unknown."""
        owner, field = (covers.written.state or "").partition(".")[0], covers.field
        if not field.type.is_integer or covers.count != 1 or field.definition.units or field.definition.enum:
            message = f"{covers.label} cannot carry how many of {owner} there are"
            scope.report.add(
                BAD_SOURCE,
                covers.written.at("state"),
                message,
                hint="it fits one whole number without unit and enum; answer this one otherwise",
            )
            return None
        count = scope.components[owner].instances
        found = read_constant(covers, Fraction(count), "state", scope.report)
        return None if found is None else cls(covers, owner, count)

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The same one always."""
        return (self.count,)

    @property
    def constants(self) -> tuple[Value, ...]:
        """The number."""
        return (self.count,)

    @property
    def always(self) -> tuple[Value, ...]:
        """The number."""
        return (self.count,)

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return the bytes of the number."""
        return bytes_of(self.count), bytes_of(self.count)

    def statements(self, code: PayloadCode) -> list[str]:
        """The number."""
        covers = self.covers
        return [f"# {covers.label}: {self.words().source} ({covers.citation})", *code.store(covers, self.count)]

    def words(self) -> Words:
        """Return what is counted."""
        return Words(f"how many of {self.component} there are", f"= {self.count}")

    def way(self, origins: Origins) -> Iterator[Step]:
        """The board says it."""
        words = self.words()
        yield Step("board", words.source, (words.conversion,), (str(self.covers.citation),))

    def traits(self, position: int) -> Iterator[Trait]:
        """Yield what is counted, and the number."""
        yield Trait("source", f"how many of {self.component} there are", Aspect.SOURCE)
        yield Trait("value", str(self.count), Aspect.CONSTANT)

    def is_fact(self, component: Component) -> bool:
        """Return True: the number stays the same."""
        return True
