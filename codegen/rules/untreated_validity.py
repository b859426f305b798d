"""Other fields of a received message say whether one is a value, and the table takes it without a look at them."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.stated_validity import StatedValidity, stated_validities
from codegen.model.reception import ReceivedField, Reception
from codegen.model.system import System

RULE = Rule(
    "untreated-validity",
    "The dialect says that a field of a received message is a value only where other fields say so, with a bit, a flag "
    "or a number, and the table takes it without a look at these: what its sender did not mean is taken for a value, "
    "and looks fresh. Write under 'when' or 'unless' what they have to say, take the other field into a quantity that "
    "code looks at, or name under 'where' what the table counts with. 'when: {}' says that it is a value here, "
    "whatever they say.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each field that is taken and another one of which nothing takes notice."""
    for table in system.receptions:
        stated = list(stated_validities(table.wire, system.dialect.enums))
        for taken in table.fields:
            for each in stated:
                if each.field == taken.field.name and not table.looks_at(each.judge, taken):
                    yield _finding(table, taken, each)


def _finding(table: Reception, taken: ReceivedField, stated: StatedValidity) -> Diagnostic:
    judge = table.wire.field(stated.judge)
    assert judge is not None
    write = f"write {stated.proviso}" if stated.proviso else "write what it has to say under when"
    return Diagnostic(
        taken.spec.place,
        RULE,
        f"{table.wire.name}.{taken.label} is taken whatever {stated.judge} says of it: {stated.words!r}",
        f"{write}, or take it, for code to look at: {stated.judge}: {{state: ...}}",
        ((judge.definition.place, f"{stated.judge} is declared here"),),
    )
