"""Subjects of the messages that set quantities."""

from collections.abc import Iterator

from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.subject import Fact, Subject, cited
from codegen.diff.system.trace_rules import CITATION
from codegen.model.reception import ReceivedField, Reception
from codegen.model.system import System


def reception_subjects(system: System) -> Iterator[Subject]:
    """The tables of received messages, and each of the fields that they take."""
    for table in system.receptions:
        yield _table(table)
        yield from (_field(table, taken) for taken in table.fields)


def _table(table: Reception) -> Subject:
    spec = table.spec
    conditions = ", ".join(f"{field.name} {number}" for field, number in table.conditions)
    facts = [
        Fact("message", table.wire.name, rules.TAKEN_FROM, spec.at("receive")),
        Fact("taken from", spec.sender.value, rules.TAKEN_FROM, spec.at("from")),
        Fact("taken where", conditions, rules.TAKEN_FROM, spec.at("where")),
        Fact("calls the vehicle", "yes" if spec.call else "", rules.TAKEN_FROM, spec.at("call")),
        Fact("answers to", str(table.citation), CITATION, spec.at("requirement")),
        *(
            Fact(f"{aspect} answers to", str(citation), CITATION, spec.at(f"criteria.{aspect}"))
            for aspect, citation in table.aspects.items()
        ),
    ]
    return Subject(
        name=f"{table.name}, received",
        says=f"from {spec.sender.value}",
        added=rules.TAKEN,
        removed=rules.NOT_TAKEN,
        place=spec.at("receive"),
        facts=tuple(facts),
        cited=cited(table.citation, table.aspects),
        messages=(table.wire.name,),
        row=table.name,
    )


def _field(table: Reception, taken: ReceivedField) -> Subject:
    spec = taken.spec
    rounding = "" if taken.factor.denominator == 1 else f", {spec.rounding.value}"
    otherwise = "otherwise as it was" if taken.is_kept_otherwise else "otherwise unknown"
    provisos = f"{taken.proviso_words}, {otherwise}" if taken.provisos else ""
    facts = [
        Fact("sets", taken.quantity.path, rules.TAKEN_INTO, spec.at("state")),
        Fact("factor", f"{taken.factor}{rounding} to {taken.quantity.kept_in}", rules.TAKEN_AS, spec.at("state")),
        Fact("takes", taken.limit_words, rules.TAKEN_RANGE, spec.at("min" if spec.min is not None else "max")),
        Fact("unknown", taken.sentinel_words, rules.TAKEN_VALUE, spec.at("unknown")),
        Fact("left as it was by", taken.unchanged_words, rules.TAKEN_VALUE, spec.at("unchanged")),
        Fact("is a value", provisos, rules.TAKEN_VALUE, spec.at("when" if spec.when else "unless")),
        Fact("answers to", str(taken.citation), CITATION, spec.at("requirement")),
    ]
    return Subject(
        name=f"{table.name}.{taken.label}, received",
        says=f"sets {taken.quantity.path}",
        added=rules.FIELD_TAKEN,
        removed=rules.FIELD_NOT_TAKEN,
        place=spec.place,
        facts=tuple(facts),
        cited=cited(taken.citation),
        messages=(table.wire.name,),
        row=f"{table.name}.{taken.label}",
    )
