"""Criteria that depend on others: these are there, and none depends on itself by a detour."""

from collections.abc import Iterator, Mapping

from codegen.diagnostics import Diagnostic, Rule, did_you_mean
from codegen.model.spec.spec import Criterion, Requirement
from codegen.model.system import System

RULE = Rule(
    "unknown-dependency",
    "A criterion depends on one that no document has, or on a whole document. Name a criterion, as ID.number; older "
    "ids work where the document lists them as aliases.",
)
CYCLE = Rule(
    "dependency-cycle",
    "Criteria depend on one another in a circle, so that none of them can be met first. Take one of the dependencies "
    "out of the documents.",
    remedy="take one of these dependencies out of the documents",
)

_Found = Mapping[str, tuple[Requirement, Criterion]]


def check(system: System) -> Iterator[Diagnostic]:
    """The dependencies of all documents, those of no such criterion first, then one finding for each circle."""
    documents = {each.id: each for each in system.requirements.values()}
    criteria = {f"{each.id}.{one.number}": (each, one) for each in documents.values() for one in each.criteria}
    if not any(one.depends_on for _, one in criteria.values()):
        return
    known: dict[str, list[str]] = {}
    for name, (_, criterion) in criteria.items():
        for written in criterion.depends_on:
            meant = _meant(written, system.requirements)
            if meant in criteria:
                known.setdefault(name, []).append(meant)
            elif _is_citation(written, documents):
                yield _unknown(name, written, meant, criteria, system.requirements)
    for circle in _circles(known):
        first, *others = circle
        following = zip(others, [*circle[2:], first], strict=False)
        related = tuple((criteria[name][1].place, f"{name} depends on {needed}") for name, needed in following)
        shown = " on ".join([*circle, first])
        yield Diagnostic(criteria[first][1].place, CYCLE, f"{shown}: they depend on one another", None, related)


def _meant(written: str, names: Mapping[str, Requirement]) -> str:
    """The name with the id of its document in place of an alias."""
    document, dot, number = written.partition(".")
    return f"{names[document].id if document in names else document}{dot}{number}"


def _is_citation(written: str, documents: Mapping[str, Requirement]) -> bool:
    """Return whether a name is meant for a criterion: ``UTF-8`` looks like the id of a document, and is none."""
    fronts = {name.partition("-")[0] for name in documents}
    return "." in written or written.partition("-")[0] in fronts


def _unknown(name: str, written: str, meant: str, criteria: _Found, names: Mapping[str, Requirement]) -> Diagnostic:
    place = criteria[name][1].place
    if meant in names:
        numbers = [str(one.number) for one in names[meant].criteria]
        hint = f"name one of its criteria, such as {meant}.{numbers[0]}" if numbers else "it has no criteria"
        return Diagnostic(place, RULE, f"{name} depends on {written}, which is a whole document", hint)
    hint = did_you_mean(written, criteria) or "no document has criteria"
    return Diagnostic(place, RULE, f"{name} depends on {written}, which no document has", hint)


def _circles(known: Mapping[str, list[str]]) -> Iterator[list[str]]:
    """Each circle once, from its first name on, where every name depends on the next one and the last on the first.

    Of circles that share a criterion one is told; the others come to light once it is gone.
    """
    done: set[str] = set()
    for start in known:
        way: dict[str, Iterator[str]] = {}
        name: str | None = start
        while name is not None:
            if name not in way and name not in done:
                way[name] = iter(known.get(name, ()))
            elif name in way and name not in done:
                names = list(way)
                circle = names[names.index(name) :]
                least = circle.index(min(circle))
                done.update(circle)
                yield [*circle[least:], *circle[:least]]
            name = None
            while way and name is None:
                last = next(reversed(way))
                name = next(way[last], None)
                if name is None:
                    done.add(last)
                    del way[last]
