"""The number of the instance that a message is about."""

from collections.abc import Iterator

from codegen.answers.fitting import BAD_SOURCE
from codegen.answers.kind import KindOfAnswer
from codegen.answers.limits import counts
from codegen.answers.scope import Scope
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value, stored_value
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Parameter

BAD_INSTANCE = Rule(
    "bad-instance",
    "Only a message that is sent for_each component can carry the number of the instance, and of that component.",
)


@dataclass(frozen=True, slots=True)
class InstanceAnswer(KindOfAnswer):
    """The index of the component's instance, from 0, or from the number that the parameter ``first`` has at start."""

    covers: Elements
    component: str
    first: Parameter | None = None

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``state: component.instance``."""
        owner, _, name = (written.state or "").partition(".")
        return name == "instance" and owner in scope.components and written.each is None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "InstanceAnswer | None":
        """The number of the instance that the message is sent for, in one integer that can count so far."""
        owner = (covers.written.state or "").partition(".")[0]
        place, component = covers.written.at("state"), scope.component
        if component is None or component.name != owner:
            scope.report.add(BAD_INSTANCE, place, f"the message is not sent for each {owner}", f"for_each: {owner}")
            return None
        first = component.first_number
        least, last = first.minimum if first else 0, component.instances - 1 + (first.maximum if first else 0)
        if not counts(covers, range(least, last + 1)):
            message = f"{covers.field.name} cannot carry an instance number"
            goes = f"that goes from {least} to {last}, none of which means unknown,"
            scope.report.add(
                BAD_SOURCE,
                place,
                f"{message} up to {last}" if first else message,
                hint=f"a whole number {goes} carries it; answer this one otherwise, or count otherwise: first_number",
            )
            return None
        return cls(covers, component.name, first)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The one that has the number of the first instance."""
        return (self.first,) if self.first else ()

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The number."""
        first = stored_value(self.first, known) if self.first else 0
        return ((first or 0) + instance,)

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return the bytes of the numbers of the first and the last instance."""
        return bytes_of(first), bytes_of(last)

    def statements(self, code: PayloadCode) -> list[str]:
        """The index, or the number that was fixed at the start."""
        covers = self.covers
        if self.first is None:
            words = f"# {covers.label}: the {self.component}'s number ({covers.citation})"
            return [words, *code.store(covers, "instance")]
        words = f"# {covers.label}: {self.first.name}, counted on ({covers.citation})"
        return [words, f"value = {code.number(self.component)}", *code.store(covers, "value")]

    def words(self) -> Words:
        """Whose number, and from where it is counted."""
        counted = f", from {self.first.name} on" if self.first else ""
        return Words(f"number of the {self.component}{counted}")

    def way(self, origins: Origins) -> Iterator[Step]:
        """The program knows it."""
        yield Step("program", self.words().source, (), (str(self.covers.citation),))

    def traits(self, position: int) -> Iterator[Trait]:
        """Whose number, and from where it is counted."""
        counted = f", counted from {self.first.name}" if self.first else ""
        yield Trait("source", f"number of the {self.component}{counted}", Aspect.SOURCE)

    @property
    def is_instance_number(self) -> bool:
        """Return True: it is the number of the instance."""
        return True


def bytes_of(number: int) -> int:
    """Bytes that a number from 0 on takes without the zeros in front."""
    return (number.bit_length() + 7) // 8
