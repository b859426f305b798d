"""Facts of the board: one for all, or one that differs between the instances of a component."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.answers.chip import UNIQUE_ID
from codegen.answers.constant import read_constant
from codegen.answers.fixed import UNKNOWN_FACT, FixedAnswer, read_entry, repeated
from codegen.answers.kind import KindOfAnswer
from codegen.answers.letters import carries_text
from codegen.answers.scope import Scope
from codegen.diagnostics import did_you_mean
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value, shown_value
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import LONGEST_RUN, PayloadCode, indented
from codegen.model.spec.population import FieldAnswer
from codegen.model.units.unit import decimal, read_measure
from codegen.model.vehicle import Component, Instance


@dataclass(frozen=True, slots=True)
class FactAnswer(KindOfAnswer):
    """A fact that differs between the instances of the component: what is fixed for each, by number."""

    SHAPED_BY = frozenset({"per"})

    covers: Elements
    parts: tuple[FixedAnswer, ...]

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``board: component.fact``."""
        return written.board is not None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "FactAnswer | FixedAnswer | None":
        """An enum entry, a number or an amount; of a message for each instance, that of each.

        A message that is not sent for each instance has the fact of the first one.
        """
        facts = _facts(covers, scope)
        answers = {fact: _fixed(covers, fact, scope) for fact in dict.fromkeys(facts or ())}
        parts = [answer for answer in answers.values() if answer is not None]
        if not facts or len(parts) < len(answers):
            return None
        if len(parts) == 1:
            return parts[0]
        return cls(covers, tuple(part for fact in facts if (part := answers[fact]) is not None))

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """Return the values of the instance."""
        return self.parts[instance].fixed

    @property
    def constants(self) -> tuple[Value, ...]:
        """Return the values of all instances."""
        return tuple(value for part in self.parts for value in part.fixed)

    @property
    def always(self) -> tuple[Value, ...] | None:
        """The values, where only the words for them differ."""
        return self.parts[0].fixed if len({part.fixed for part in self.parts}) == 1 else None

    def statements(self, code: PayloadCode) -> list[str]:
        """Return the statements that put the value of the instance."""
        covers, values = self.covers, [part.fixed[0] for part in self.parts]
        texts = tuple(value for value in values if isinstance(value, str))
        if texts:
            return [f"# {covers.label}: text of each ({covers.citation})", *code.text(covers, texts)]
        head = f"# {covers.label}: {', '.join(part.meaning for part in self.parts)} ({covers.citation})"
        lines = [head]
        for number, value in enumerate(values):
            assert not isinstance(value, str)
            test = "else:" if number == len(values) - 1 else f"{'elif' if number else 'if'} instance == {number}:"
            lines += [test, *indented(_written(covers, value, code))]
        return lines

    def words(self) -> Words:
        """The fact of each."""
        return Words("fact of each", ", ".join(f"{part.meaning} = {shown_value(part.fixed[0])}" for part in self.parts))

    def way(self, origins: Origins) -> Iterator[Step]:
        """The fact of each instance."""
        owner = (self.covers.written.board or "").partition(".")[0]
        parts = (f"{owner} {number}: {part.meaning} = {part.fixed[0]!r}" for number, part in enumerate(self.parts, 1))
        yield Step("board", f"a fact of each {owner}", tuple(parts), (str(self.covers.citation),))

    def traits(self, position: int) -> Iterator[Trait]:
        """The value of each instance."""
        yield Trait("source", "a fact of each instance", Aspect.SOURCE)
        for number, part in enumerate(self.parts, 1):
            for trait in part.traits(position):
                if trait.attribute == "value":
                    yield Trait(f"value of instance {number}", trait.text, trait.aspect)

    @property
    def entries(self) -> tuple[str, ...]:
        """The entries that the facts name."""
        return tuple(part.meaning for part in self.parts)

    @property
    def tells_apart(self) -> bool:
        """Return whether no two instances have the same."""
        return len({part.fixed for part in self.parts}) == len(self.parts)

    def is_fact(self, component: Component) -> bool:
        """Return True: it is a fact of the board."""
        return True


def _facts(covers: Elements, scope: Scope) -> list[str | Fraction] | None:
    """The fact of each instance that the message is sent for, or of the first one; None after a finding."""
    path = covers.written.board or ""
    owner, _, name = path.partition(".")
    place = covers.written.at("board")
    parts = scope.components[owner].parts if owner in scope.components else ()
    facts = [part.facts.get(name) for part in parts] or [scope.board.facts.get(owner, {}).get(name)]
    if scope.component is None or scope.component.name != owner:
        facts = facts[:1]
    found = [fact for fact in facts if fact is not None]
    if not found:
        if not scope.is_unread(owner):  # else its instances, which may have the fact, are not known
            hint = did_you_mean(path, [*scope.facts(), UNIQUE_ID])
            scope.report.add(UNKNOWN_FACT, place, f"board.yaml has no fact {path}", hint)
        return None
    if len(found) < len(facts):
        message = f"board.yaml has no fact {name} of {owner} {facts.index(None) + 1}"
        hint = f"state it under instances, or under facts for every {owner}"
        scope.report.add(UNKNOWN_FACT, place, message, hint)
        return None
    return _multiplied(covers, found, parts, scope) if covers.written.per is not None else found


def _multiplied(
    covers: Elements, facts: list[str | Fraction], parts: tuple[Instance, ...], scope: Scope
) -> list[str | Fraction] | None:
    """Facts of one of what another fact counts, by instance, as those of all: numbers or amounts times the count."""
    per = covers.written.per or ""
    products: list[str | Fraction] = []
    for fact, part in zip(facts, parts, strict=False):
        count = part.count(per)
        measure = read_measure(fact) if isinstance(fact, str) else None
        if count is None or (isinstance(fact, str) and measure is None):
            number = part.facts.get(per, "no number of")
            message = f"{covers.written.board} of {fact} cannot be multiplied with {number} {per}"
            scope.report.add(UNKNOWN_FACT, covers.written.at("per"), message, did_you_mean(per, part.facts))
            return None
        products.append(f"{decimal(measure.value * count)} {measure.unit.name}" if measure else Fraction(fact) * count)
    return products


def _fixed(covers: Elements, fact: str | Fraction, scope: Scope) -> FixedAnswer | None:
    if isinstance(fact, str) and read_measure(fact) is None and not carries_text(covers):
        value = read_entry(covers, fact, "board", scope)
        return None if value is None else repeated(covers, value, fact)
    found = read_constant(covers, fact, "board", scope.report)
    return None if found is None else repeated(covers, *found)


def _written(covers: Elements, value: float, code: PayloadCode) -> list[str]:
    """Return the statements for one instance: the zeros of one are written where another one may have left a number."""
    if covers.count > LONGEST_RUN or (value and code.is_plain(covers, value)):
        return code.fill(covers, value)
    return [line for at in range(covers.count) for line in code.store(covers, value, at, over=True)]
