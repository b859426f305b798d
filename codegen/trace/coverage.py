"""The coverage of each criterion: rows that cite it, outcomes of its tests, whether its text is the reviewed one."""

from collections.abc import Mapping
from dataclasses import replace
from enum import StrEnum

from codegen.frozen import dataclass
from codegen.model.spec.spec import Criterion, HostLimit, Requirement
from codegen.trace.graph import Row, Test, Trace, is_decision
from codegen.trace.link import Link
from codegen.trace.lock import Review
from codegen.trace.results import Counts, Results, counts_of


class Verdict(StrEnum):
    """The outcome of all tests of a criterion; ``NO_RESULT`` also where no results were given."""

    PASSED = "passed"
    PARTLY = "partly passed"
    FAILED = "failed"
    SKIPPED = "skipped"
    STALE = "stale"
    NO_RESULT = "no result"
    BENCH = "on the bench"
    NO_TEST = "no test"


@dataclass(frozen=True, slots=True)
class Tested:
    """A test, and how its cases went; None without results."""

    test: Test
    counts: Counts | None


@dataclass(frozen=True, slots=True)
class Coverage:
    """One criterion; ``by_document`` are rows that cite its document as a whole, ``whole_tests`` the cases that do.

    ``host_limit`` is what its document says that tests on a host cannot show of it. A decision asks for nothing, and
    its ``review`` is None. ``suspects`` are the links that were made for another text. ``depends_on`` and ``needed_by``
    are the criteria that it depends on and those that depend on it, ``unmet`` those that it depends on, by detours
    too, and that are not shown, with what is known of them.
    """

    name: str
    requirement: Requirement
    criterion: Criterion
    rows: tuple[Row, ...]
    by_document: tuple[Row, ...]
    tests: tuple[Tested, ...]
    whole_tests: int
    verdict: Verdict
    review: Review | None
    host_limit: HostLimit | None
    is_decision: bool
    suspects: tuple[Link, ...]
    depends_on: tuple[str, ...]
    needed_by: tuple[str, ...]
    unmet: tuple[tuple[str, Verdict], ...] = ()

    @property
    def is_uncovered(self) -> bool:
        """Return whether no test shows it: none is there, or, with results, none passed or one failed."""
        if self.is_decision:
            return False
        has_results = any(each.counts is not None for each in self.tests)
        bad = (Verdict.FAILED, Verdict.SKIPPED, Verdict.STALE, *([Verdict.NO_RESULT] if has_results else []))
        return self.verdict is Verdict.NO_TEST or self.verdict in bad

    @property
    def is_suspect(self) -> bool:
        """Return whether its links were made for another text."""
        return self.review in (Review.CHANGED, Review.NEW)

    @property
    def is_unspecified(self) -> bool:
        """Return whether no row of the tables asks for it: it is met by what is the
        same in every project, or by nothing.
        """
        return not self.is_decision and not self.rows and not self.by_document

    @property
    def counts(self) -> Counts | None:
        """The cases of all its tests; None without results."""
        counted = [each.counts for each in self.tests if each.counts is not None]
        return sum(counted, Counts()) if counted else None


def coverage_of(
    trace: Trace,
    reviews: Mapping[str, Review],
    suspects: Mapping[str, tuple[Link, ...]],
    results: Results | None,
) -> tuple[Coverage, ...]:
    """Every criterion and decision, in the order of the documents."""
    found = {
        name: _coverage(name, requirement, criterion, trace, reviews.get(name), suspects.get(name, ()), results)
        for name, (requirement, criterion) in trace.criteria.items()
    }
    shown = {Verdict.PASSED} if results is not None else {*Verdict} - {Verdict.NO_TEST}
    verdicts = {
        name: each.verdict for name, each in found.items() if each.verdict not in shown and not each.is_decision
    }
    return tuple(
        replace(each, unmet=tuple((other, verdicts[other]) for other in _needed(name, trace) if other in verdicts))
        if each.depends_on
        else each
        for name, each in found.items()
    )


def _needed(name: str, trace: Trace) -> list[str]:
    """The criteria that one depends on, by detours too: the nearest first."""
    needed: dict[str, None] = dict.fromkeys(trace.depends_on.get(name, ()))
    waiting = list(needed)
    for other in waiting:
        further = [each for each in trace.depends_on.get(other, ()) if each not in needed and each != name]
        needed.update(dict.fromkeys(further))
        waiting += further
    return list(needed)


def _coverage(
    name: str,
    requirement: Requirement,
    criterion: Criterion,
    trace: Trace,
    review: Review | None,
    suspects: tuple[Link, ...],
    results: Results | None,
) -> Coverage:
    tests = trace.tests_of.get(name, ())
    tested = tuple(Tested(test, None if results is None else counts_of(test, results)) for test in tests)
    limits = [limit for limit in requirement.host_limits if criterion.number in limit.numbers]
    return Coverage(
        name=name,
        requirement=requirement,
        criterion=criterion,
        rows=trace.rows_of.get(name, ()),
        by_document=trace.rows_of.get(requirement.id, ()),
        tests=tested,
        whole_tests=sum(max(1, len(test.cases)) for test in trace.tests_of.get(requirement.id, ())),
        verdict=_verdict(tested, bool(limits)),
        review=review,
        host_limit=limits[0] if limits else None,
        is_decision=is_decision(requirement),
        suspects=suspects,
        depends_on=trace.depends_on.get(name, ()),
        needed_by=trace.needed_by.get(name, ()),
    )


def _verdict(tested: tuple[Tested, ...], has_limit: bool) -> Verdict:
    """Failed as soon as one case has; passed when every case of every test has."""
    if not tested:
        return Verdict.BENCH if has_limit else Verdict.NO_TEST
    counts = sum((each.counts for each in tested if each.counts is not None), Counts())
    if counts.failed:
        return Verdict.FAILED
    if counts.passed:
        return Verdict.PASSED if counts.passed == counts.cases else Verdict.PARTLY
    if counts.stale:
        return Verdict.STALE
    return Verdict.SKIPPED if counts.skipped else Verdict.NO_RESULT
