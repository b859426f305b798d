"""The trace as objects and relations, for the formats in which tools for requirements exchange them.

A name is what people call a thing, the same in every format and every run: ``FR-00068.3``, ``field BATTERY_STATUS.id``,
``firmware/state.py: BatteryState.cells``, ``test tests/test_x.py::test_y shows FR-00068.3``.
"""

from collections.abc import Iterator
from enum import StrEnum

from codegen.frozen import dataclass
from codegen.trace.view import CriterionView, DocumentView, TraceView


class ObjectKind(StrEnum):
    """The kind of an object."""

    DOCUMENT = "Document"
    CRITERION = "Criterion"
    ROW = "Row"
    SYMBOL = "Symbol"
    TEST = "Test"


class RelationKind(StrEnum):
    """The kind of a relation, from its source to its target."""

    PART = "is part of"
    DEPENDS = "depends on"
    ANSWERS = "answers to"
    REALIZES = "realizes"
    SHOWS = "shows"


@dataclass(frozen=True, slots=True)
class ExchangeObject:
    """One object; ``facts`` are what else is known of it, by the name of the attribute, without empty ones."""

    kind: ObjectKind
    name: str
    title: str
    text: str
    tags: tuple[str, ...]
    facts: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Relation:
    """One relation between two objects by their names; suspect where it was made for another text of the target."""

    kind: RelationKind
    source: str
    target: str
    is_suspect: bool = False


@dataclass(frozen=True, slots=True)
class Exchange:
    """All objects, documents in their order and each before its criteria, then the others by name; and relations."""

    project: str
    objects: tuple[ExchangeObject, ...]
    relations: tuple[Relation, ...]


def exchange_of(view: TraceView) -> Exchange:
    """Return what a trace has to exchange; an object that several criteria share is in it once."""
    objects: dict[str, ExchangeObject] = {}
    answering: dict[str, ExchangeObject] = {}
    relations: dict[Relation, None] = {}
    for document in (*view.documents, *view.decisions):
        objects[document.id] = _document(document)
        for one in document.criteria:
            objects[one.name] = _criterion(one)
            relations[Relation(RelationKind.PART, one.name, document.id)] = None
            for found, relation in _around(one):
                answering.setdefault(found.name, found)
                relations[relation] = None
    known = objects.keys()
    for document in (*view.documents, *view.decisions):
        for one in document.criteria:
            for other in one.needed_by:
                if other.name in known:
                    relations[Relation(RelationKind.DEPENDS, other.name, one.name, other.is_suspect)] = None
    rest = sorted(answering.values(), key=lambda each: (list(ObjectKind).index(each.kind), each.name))
    return Exchange(view.project, (*objects.values(), *rest), tuple(relations))


def _document(document: DocumentView) -> ExchangeObject:
    facts = {
        "status": document.status,
        "aliases": document.aliases,
        "refers_to": ", ".join(document.links),
        "place": document.place,
    }
    tags = ("decision",) if document.is_decision else ()
    return ExchangeObject(ObjectKind.DOCUMENT, document.id, document.title, "", tags, _stated(facts))


def _criterion(one: CriterionView) -> ExchangeObject:
    facts = {
        "status": one.status,
        "result": one.result,
        "review": one.review,
        "bench": one.host_limit,
        "place": one.place,
    }
    return ExchangeObject(ObjectKind.CRITERION, one.name, one.name, one.text, one.tags, _stated(facts))


def _around(one: CriterionView) -> Iterator[tuple[ExchangeObject, Relation]]:
    """Yield what answers to a criterion, with its relation."""
    for row in one.rows:
        name = f"{row.kind} {row.label} in {row.place.rpartition(':')[0]}"  # programs can have rows of one name
        found = ExchangeObject(ObjectKind.ROW, name, f"{row.kind} {row.label}", "", (), _stated({"place": row.place}))
        yield found, Relation(RelationKind.ANSWERS, name, one.name, row.is_suspect)
    for symbols in one.symbols:
        for symbol in symbols.names:
            name = f"{symbols.file}: {symbol}"
            found = ExchangeObject(ObjectKind.SYMBOL, name, name, "", (), _stated({"place": symbols.file}))
            yield found, Relation(RelationKind.REALIZES, name, one.name)
    for test in one.tests:
        name = f"test {test.name} shows {one.name}"
        facts = {"status": _RESULTS[test.mood], "result": test.result, "cases": test.cases, "place": test.file}
        found = ExchangeObject(ObjectKind.TEST, name, f"{test.name} shows {one.name}", "", (), _stated(facts))
        yield found, Relation(RelationKind.SHOWS, name, one.name, test.is_suspect)


_RESULTS = {"good": "passed", "warn": "partly passed", "bad": "not passed", "": "no result"}


def _stated(facts: dict[str, str]) -> tuple[tuple[str, str], ...]:
    return tuple((name, value) for name, value in facts.items() if value)
