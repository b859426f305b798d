"""The links from a criterion: rows that cite it, tests written by hand that show it, criteria that depend on it.

All of them were made for its text as it read then. When the text changes, each is suspect until somebody has looked at
it; the lock keeps which ones were. What the generator makes of a row follows the row.
"""

from collections.abc import Iterator, Sequence

from codegen.diagnostics import did_you_mean
from codegen.frozen import dataclass
from codegen.model.spec.trace_lock import TraceLockSpec
from codegen.source import Place
from codegen.trace.graph import Row, Test, Trace
from codegen.trace.lock import Review, reviews, text_fingerprint


@dataclass(frozen=True, slots=True)
class Link:
    """One link: ``name`` is unique for its criterion (``parameter SR0_EXTRA1``), ``says`` what it has to do with it."""

    name: str
    place: Place
    says: str


def links_of(criterion: str, trace: Trace) -> tuple[Link, ...]:
    """The links from a criterion in the order rows, tests, criteria.

    Rows of several programs can be called the same: then each is named with its file, as far as it has to be.
    """
    return tuple(_links(criterion, trace))


def row_links(rows: Sequence[Row]) -> list[str]:
    """The names of the links to the rows of one criterion, in their order."""
    names = [f"{row.kind} {row.label}" for row in rows]
    twins: dict[str, list[list[str]]] = {}
    for name, row in zip(names, rows, strict=True):
        twins.setdefault(name, []).append(_path(row))
    return [
        name if len(twins[name]) == 1 else f"{name} in {_told_apart(_path(row), twins[name])}"
        for name, row in zip(names, rows, strict=True)
    ]


def _path(row: Row) -> list[str]:
    return row.place.file.replace("\\", "/").split("/")


def _told_apart(own: Sequence[str], paths: Sequence[Sequence[str]]) -> str:
    """Return as many last parts of a path as no other one ends with."""
    for depth in range(1, len(own)):
        if sum(path[-depth:] == own[-depth:] for path in paths) == 1:
            return "/".join(own[-depth:])
    return "/".join(own)


def test_link(test: Test) -> str:
    """The name of the link to a test written by hand."""
    return f"test {test.name}"


def criterion_link(name: str) -> str:
    """The name of the link to a criterion that depends on another one."""
    return f"criterion {name}"


def suspects(trace: Trace, lock: TraceLockSpec | None) -> dict[str, tuple[Link, ...]]:
    """Return by criterion, if its text is not the reviewed one, the links that nobody has looked at since.

    A criterion that was never reviewed has all of its links in it.
    """
    found = {}
    for name, review in reviews(trace, lock).items():
        if review in (Review.CHANGED, Review.NEW):
            now = text_fingerprint(trace.criteria[name][1].text)
            kept = lock.criteria[name].links if lock and name in lock.criteria else {}
            seen = {link for link, each in kept.items() if each.text.lower() == now}
            found[name] = tuple(link for link in links_of(name, trace) if link.name not in seen)
    return found


def chosen_link(asked: str, links: Sequence[Link]) -> Link | str:
    """The link that is meant by its name, or by its name without the kind; or, in words, why there is none."""
    meant = [link for link in links if link.name == asked]
    meant = meant or [link for link in links if link.name.partition(" ")[2] == asked or _label(link) == asked]
    if len(meant) == 1:
        return meant[0]
    if meant:
        return f"{asked} can be {' or '.join(link.name for link in meant)}"
    hint = did_you_mean(asked, [link.name for link in links])
    return f"{asked} is none of its suspect links; {hint or 'it has none'}"


def _label(link: Link) -> str:
    """The last word of a name: kinds of rows can be several words."""
    return link.name.rpartition(" ")[2]


def _links(criterion: str, trace: Trace) -> Iterator[Link]:
    rows = trace.rows_of.get(criterion, ())
    for name, row in zip(row_links(rows), rows, strict=True):
        yield Link(name, row.place, "cites it")
    for test in trace.tests_of.get(criterion, ()):
        if test.place is not None:
            yield Link(test_link(test), test.place, "shows it")
    for other in trace.needed_by.get(criterion, ()):
        yield Link(criterion_link(other), trace.criteria[other][1].place, "depends on it")
