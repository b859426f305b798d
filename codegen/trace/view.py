"""The trace as views that are ready to print, for the terminal, Markdown and HTML alike."""

import os
from collections.abc import Collection, Iterable, Mapping, Sequence, Sized
from dataclasses import replace
from functools import cache

from codegen.diagnostics import Diagnostic, Severity
from codegen.frozen import dataclass
from codegen.model.spec.spec import Requirement
from codegen.source import Place
from codegen.summaries.fields import in_table
from codegen.trace.coverage import Coverage, Tested, Verdict
from codegen.trace.findings import counted_text, unmet_text
from codegen.trace.graph import Row, Symbol, Trace
from codegen.trace.link import criterion_link, row_links, test_link
from codegen.trace.lock import Review

_MOODS = {
    Verdict.PASSED: "good",
    Verdict.NO_RESULT: "",
    Verdict.PARTLY: "warn",
    Verdict.BENCH: "warn",
    Verdict.SKIPPED: "bad",
    Verdict.STALE: "bad",
    Verdict.FAILED: "bad",
    Verdict.NO_TEST: "bad",
}
_Words = Mapping[Verdict, tuple[str, str]]
_WITHOUT_RESULTS: _Words = {Verdict.NO_RESULT: ("has tests", "")}
_ONLY_GENERATED: _Words = {
    Verdict.NO_RESULT: ("has generated tests", ""),
    Verdict.BENCH: ("no generated test", "warn"),
    Verdict.NO_TEST: ("no generated test", "warn"),
}
"""The name of a verdict, and its mood, where less is known."""
_TAGS = {
    "uncovered": "uncovered",
    "suspect": "suspect",
    "partly": "partly passed",
    "unspecified": "cited by no row",
    "dependency": "depends on what is not shown",
    "bench": "needs the bench",
    "by-hand": "tests by hand",
    "decision": "decisions",
}
"""The filters for criteria, with their names for people."""


@dataclass(frozen=True, slots=True)
class RowView:
    """A row: what it is about, and where it stands; suspect where nobody looked at it with the text as it is now."""

    kind: str
    label: str
    place: str
    is_suspect: bool = False


@dataclass(frozen=True, slots=True)
class SymbolsView:
    """The symbols of one generated file."""

    file: str
    names: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TestView:
    """A test: its name, how many cases it has (empty for one that has no parameters), and how they went."""

    name: str
    file: str
    function: str
    cases: str
    result: str
    mood: str
    is_suspect: bool


@dataclass(frozen=True, slots=True)
class DependencyView:
    """A criterion that another one depends on, or that depends on it; how it stands in words, where that matters."""

    name: str
    note: str
    is_suspect: bool


@dataclass(frozen=True, slots=True)
class CriterionView:
    """One criterion; ``status`` is how its tests went in words, ``mood`` good, warn, bad or empty.

    ``cell`` is its text for a table of Markdown. ``rows_by_document`` are those that cite the whole document. ``tags``
    are what a table can be filtered by.
    """

    name: str
    text: str
    cell: str
    place: str
    status: str
    mood: str
    result: str
    review: str
    is_suspect: bool
    rows: tuple[RowView, ...]
    rows_by_document: tuple[RowView, ...]
    symbols: tuple[SymbolsView, ...]
    tests: tuple[TestView, ...]
    depends_on: tuple[DependencyView, ...]
    needed_by: tuple[DependencyView, ...]
    host_limit: str
    tags: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class DocumentView:
    """One document with its criteria."""

    id: str
    title: str
    status: str
    aliases: str
    links: tuple[str, ...]
    place: str
    is_decision: bool
    criteria: tuple[CriterionView, ...]


@dataclass(frozen=True, slots=True)
class AttentionView:
    """A finding about the trace; ``kind`` is the name of its rule."""

    kind: str
    mood: str
    message: str
    hint: str
    place: str


@dataclass(frozen=True, slots=True)
class TraceView:
    """The whole trace. ``totals`` are pairs of a number and what there are so many of.

    ``verdicts`` are a status, the number of its criteria and its mood; ``tags`` are those that occur, with their names.
    ``uncited`` is how many rows cite nothing, ``is_locked`` is whether there is a lock file. With ``only_generated``
    tests by hand are not in it.
    """

    project: str
    totals: tuple[tuple[int, str], ...]
    verdicts: tuple[tuple[str, int, str], ...]
    uncited: int
    tags: tuple[tuple[str, str], ...]
    is_locked: bool
    only_generated: bool
    has_results: bool
    results: tuple[str, ...]
    attention: tuple[AttentionView, ...]
    documents: tuple[DocumentView, ...]
    decisions: tuple[DocumentView, ...]


def trace_view(
    project: str,
    folder: str,
    trace: Trace,
    coverage: Sequence[Coverage],
    findings: Iterable[Diagnostic],
    results: Iterable[str] | None = None,
    *,
    only_generated: bool = False,
) -> TraceView:
    """The view of a trace; places are shown relative to ``folder``, and ``results`` are the files of results.

    With ``only_generated`` nothing is known of tests that are written by hand.
    """
    has_results = results is not None
    if only_generated:  # whether another criterion has a test is not known then
        coverage = [replace(each, unmet=()) for each in coverage]
    words = _ONLY_GENERATED if only_generated else {} if has_results else _WITHOUT_RESULTS
    views = {each.name: _criterion(each, folder, words) for each in coverage}
    asked = [each for each in coverage if not each.is_decision]
    documents = [_document(requirement, views, folder) for requirement in trace.requirements]
    by_hand = {test.name for test in trace.tests if test.place}
    generated = {(test.name, case) for test in trace.tests if not test.place for case in test.cases or ("",)}
    return TraceView(
        project=project,
        totals=(
            _counted({each.requirement.id for each in asked}, "requirement document", "requirement documents"),
            _counted(asked, "criterion", "criteria"),
            _counted(trace.rows, "row that cites one", "rows that cite them"),
            _counted({symbol for row in trace.rows for symbol in row.symbols}, "symbol", "generated symbols"),
            _counted(generated, "generated test case", "generated test cases"),
            *([] if only_generated else [_counted(by_hand, "test written by hand", "tests written by hand")]),
        ),
        verdicts=tuple(_verdicts(asked, words)),
        uncited=len(trace.uncited),
        tags=tuple(
            ("uncovered", "no generated test") if only_generated and tag == "uncovered" else (tag, name)
            for tag, name in _TAGS.items()
            if any(tag in view.tags for view in views.values())
        ),
        is_locked=any(each.review is not Review.NO_LOCK for each in asked),
        only_generated=only_generated,
        has_results=has_results,
        results=tuple(results or ()),
        attention=tuple(_attention(finding, folder) for finding in findings),
        documents=tuple(each for each in documents if not each.is_decision),
        decisions=tuple(each for each in documents if each.is_decision),
    )


def _counted(found: Sized, one: str, several: str) -> tuple[int, str]:
    return len(found), one if len(found) == 1 else several


def only(view: TraceView, chosen: Collection[str]) -> TraceView:
    """The view with these criteria and no others."""
    kept = [
        replace(each, criteria=tuple(one for one in each.criteria if one.name in chosen))
        for each in (*view.documents, *view.decisions)
    ]
    kept = [each for each in kept if each.criteria]
    return replace(
        view,
        documents=tuple(each for each in kept if not each.is_decision),
        decisions=tuple(each for each in kept if each.is_decision),
    )


def _attention(finding: Diagnostic, folder: str) -> AttentionView:
    rule = finding.rule
    mood = "bad" if rule.severity is Severity.ERROR else "warn"
    return AttentionView(rule.id, mood, finding.message, finding.advice or "", _shown(finding.place, folder))


def _verdicts(asked: Sequence[Coverage], words: _Words) -> Iterable[tuple[str, int, str]]:
    """Status, number of criteria and mood, each status that occurs."""
    numbers: dict[tuple[str, str], int] = {}
    for verdict in _MOODS:
        number = sum(each.verdict is verdict for each in asked)
        numbers[_said(verdict, words)] = numbers.get(_said(verdict, words), 0) + number
    yield from ((status, number, mood) for (status, mood), number in numbers.items() if number)
    suspect = sum(each.is_suspect for each in asked)
    if suspect:
        yield "suspect", suspect, "bad"
    unspecified = sum(each.is_unspecified for each in asked)
    if unspecified:
        yield "cited by no row", unspecified, "warn"
    unmet = sum(bool(each.unmet) for each in asked)
    if unmet:
        yield _TAGS["dependency"], unmet, "warn"


def _said(verdict: Verdict, words: _Words) -> tuple[str, str]:
    """Status and mood."""
    return words.get(verdict, (verdict.value, _MOODS[verdict]))


def _document(requirement: Requirement, views: dict[str, CriterionView], folder: str) -> DocumentView:
    criteria = tuple(views[f"{requirement.id}.{one.number}"] for one in requirement.criteria)
    return DocumentView(
        id=requirement.id,
        title=requirement.title,
        status=requirement.status,
        aliases=", ".join(requirement.aliases),
        links=requirement.links,
        place=_shown(requirement.place, folder),
        is_decision=any("decision" in view.tags for view in criteria),
        criteria=criteria,
    )


def _criterion(each: Coverage, folder: str, words: _Words) -> CriterionView:
    symbols = dict.fromkeys(symbol for row in each.rows for symbol in row.symbols)
    counts = each.counts
    status, mood = _said(each.verdict, words)
    suspect = {link.name for link in each.suspects}
    rows = zip(each.rows, row_links(each.rows), strict=True)
    return CriterionView(
        name=each.name,
        text=each.criterion.text,
        cell=in_table(each.criterion.text),
        place=_shown(each.criterion.place, folder),
        status=status,
        mood="warn" if each.unmet and mood == "good" else mood,
        result=counted_text(counts) if counts else "",
        review="" if each.review in (None, Review.NO_LOCK) else str(each.review),
        is_suspect=each.is_suspect,
        rows=tuple(_row(row, folder, is_suspect=link in suspect) for row, link in rows),
        rows_by_document=tuple(_row(row, folder) for row in each.by_document),
        symbols=_symbols(symbols),
        tests=tuple(_test(tested, is_suspect=test_link(tested.test) in suspect) for tested in each.tests),
        depends_on=tuple(_dependencies(each)),
        needed_by=tuple(
            DependencyView(name, "", is_suspect=criterion_link(name) in suspect) for name in each.needed_by
        ),
        host_limit=each.host_limit.text if each.host_limit else "",
        tags=tuple(_tags(each)),
    )


def _dependencies(each: Coverage) -> Iterable[DependencyView]:
    """Return what a criterion depends on, and behind it, by detours, what of that is not shown."""
    unmet = {name: unmet_text(name, verdict).partition(", ")[2] for name, verdict in each.unmet}
    for name in dict.fromkeys([*each.depends_on, *unmet]):
        yield DependencyView(name, unmet.get(name, ""), is_suspect=False)


def _tags(each: Coverage) -> Iterable[str]:
    if each.is_decision:
        yield "decision"
    if each.is_uncovered:
        yield "uncovered"
    if each.verdict is Verdict.PARTLY:
        yield "partly"
    if each.is_suspect:
        yield "suspect"
    if each.is_unspecified:
        yield "unspecified"
    if each.unmet:
        yield "dependency"
    if each.host_limit:
        yield "bench"
    if any(tested.test.place for tested in each.tests):
        yield "by-hand"


def _row(row: Row, folder: str, *, is_suspect: bool = False) -> RowView:
    return RowView(str(row.kind), row.label, _shown(row.place, folder), is_suspect)


def _symbols(symbols: Iterable[Symbol]) -> tuple[SymbolsView, ...]:
    files: dict[str, list[str]] = {}
    for symbol in sorted(symbols):
        files.setdefault(symbol.file, []).append(symbol.name)
    return tuple(SymbolsView(file, tuple(names)) for file, names in files.items())


def _test(tested: Tested, *, is_suspect: bool) -> TestView:
    counts, number = tested.counts, len(tested.test.cases)
    mood = ""
    if counts is not None:
        mood = "bad" if counts.failed or not counts.passed else "good" if counts.passed == counts.cases else "warn"
    about = f", {tested.test.about}" if tested.test.about else ""
    cases = f"{number} {'case' if number == 1 else 'cases'}{about}" if number else ""
    test = tested.test
    result = counted_text(counts) if counts else ""
    return TestView(test.name, test.file, test.function, cases, result, mood, is_suspect)


def _shown(place: Place, folder: str) -> str:
    """``specs/streams.yaml:12``, with slashes: pages are the same on every machine."""
    return f"{_below(place.file, folder)}:{place.line}"


@cache
def _below(path: str, folder: str) -> str:
    return os.path.relpath(path, folder).replace(os.sep, "/")
