"""Findings about a trace, with places: rules for what needs attention, which a command counts or only lists."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace

from codegen.diagnostics import Diagnostic, Rule, Severity, did_you_mean
from codegen.model.spec.trace_lock import ReviewedSpec
from codegen.model.test_record import TestResult
from codegen.source import Place
from codegen.trace.coverage import Coverage, Verdict
from codegen.trace.graph import Trace
from codegen.trace.lock import Review
from codegen.trace.results import Counts, Results, hand_written_results, undated_results_of_suites

UNCOVERED = Rule(
    "trace-uncovered",
    "Nothing shows a criterion: no test is marked with it, or, of the results that were given, none passed, or one "
    "failed. Write a test with @pytest.mark.requirement(\"ID.number\"), or state under 'What a host cannot show' of "
    "the document what the bench shows.",
    remedy='mark a test with @pytest.mark.requirement("ID.number"), or say what the bench shows',
)
ORPHANED = Rule(
    "trace-orphaned",
    "A test, or a line of the lock file, names a criterion that no document has any more. Name the one that took its "
    "place, or remove the mark; codegen trace accept removes the line of the lock.",
    remedy="name the criterion that took its place, or remove the mark",
)
SUSPECT = Rule(
    "trace-suspect",
    "The text of a criterion is not the one that was reviewed with its rows and tests, so that these may be about "
    'something else. Look at them, then say so: codegen trace accept ID --reason "...".',
    remedy='look at its rows and tests, then: codegen trace accept ID --reason "..."',
)
UNSPECIFIED = Rule(
    "trace-unspecified",
    "A criterion is cited by no row of the tables, nor is its document as a whole: what meets it does not follow from "
    "the specification. Cite it where the tables decide it.",
    Severity.WARNING,
    remedy="cite it where the tables decide it: requirement: ID.number",
)
UNCITED = Rule(
    "trace-uncited",
    "A record of the specification cites no requirement, and no part of it does: nobody has asked for it, or it is not "
    "said who. Give it a requirement: ID.number of the criterion that asks for it.",
    Severity.WARNING,
    remedy="add requirement: ID.number of the criterion that asks for it",
)
PARTLY = Rule(
    "trace-partly",
    "Some cases of a criterion's tests have passed, and others were skipped, have no result, or one that is stale.",
    Severity.WARNING,
    remedy="run the tests that were skipped or have no result, and give their results with --results",
)
DEPENDENCY = Rule(
    "trace-dependency",
    "A criterion depends on another one that nothing shows: no test is marked with that one, or, of the results that "
    "were given, not all have passed. What its own tests show holds only where the other one is met.",
    Severity.WARNING,
    remedy="show the other criterion: mark tests with it, and let them pass",
)
UNRELATED_RESULTS = Rule(
    "results-unrelated",
    "A file of results says nothing about this project: it knows none of its tests, and names none of its criteria.",
    Severity.WARNING,
)
UNCOLLECTED_RESULTS = Rule(
    "results-uncollected",
    "A file of results is of a run in which pytest could not collect the tests of a module, as it could not be read or "
    "imported: each of its tests has failed, and pytest may have run none of the others. Run the tests again once "
    "the module can be imported.",
    Severity.WARNING,
    remedy="mend what the error says, and run the tests again",
)
OUTDATED_RESULTS = Rule(
    "results-outdated",
    "A file of results has some of tests written by hand that were run with another specification than the one that "
    "there is now: they show nothing. Run the tests again, after a build.",
    Severity.WARNING,
)
LOST_TESTS = Rule(
    "results-without-test",
    "A file of results has some of a file of tests that is not there any more: it was deleted or renamed since. What "
    "they show counts, as tests can lie elsewhere. Run the tests again, and give these results alone.",
    Severity.WARNING,
)
UNDATED_RESULTS = Rule(
    "results-undated",
    "A file of results has some of tests written by hand that do not say with which specification they were run, so "
    "they are taken for results of this one. With pytest -p codegen.pytest_plugin --junit-xml=FILE they say it, once "
    "the project is built; another tool can write the property codegen-specification. Generated suites say it by "
    "themselves, as the property codegen-inputs: where a tool that joins or rewrites files of results has left the "
    "properties out, these results count as those of another specification.",
    Severity.WARNING,
)

KINDS: Mapping[str, Rule] = {
    "uncovered": UNCOVERED,
    "orphaned": ORPHANED,
    "suspect": SUSPECT,
    "unspecified": UNSPECIFIED,
    "uncited": UNCITED,
    "partly": PARTLY,
    "dependency": DEPENDENCY,
}
"""The kinds of findings that can be asked to fail, by their names on the command line."""

COUNTED = ("uncovered", "orphaned", "suspect")
"""The kinds that fail unless others are asked for."""

TOLD = (*COUNTED, "dependency")
"""The kinds that are told even where they do not count."""

_REMEDIES: Mapping[Verdict, str] = {
    Verdict.FAILED: "look at the tests that failed, and at what they are about",
    Verdict.SKIPPED: "run the tests where nothing makes them skip, and give the results with --results",
    Verdict.STALE: "build, run the tests again, and give their results with --results",
    Verdict.NO_RESULT: "run the tests, and give their results with --results",
}
"""The remedy for a criterion that has tests, by how these went."""

_UNMET: Mapping[Verdict, str] = {
    Verdict.PARTLY: "which has passed only partly",
    Verdict.FAILED: "which has failed",
    Verdict.SKIPPED: "of which all tests were skipped",
    Verdict.STALE: "of which all results are of another specification",
    Verdict.NO_RESULT: "which has no result",
    Verdict.BENCH: "which only the bench shows",
    Verdict.NO_TEST: "which has no test",
}


def trace_findings(
    trace: Trace,
    coverage: Iterable[Coverage],
    gone: Mapping[str, ReviewedSpec],
    counted: Collection[str] = COUNTED,
    chosen: Collection[str] | None = None,
    only: Collection[str] = KINDS.keys(),
) -> Iterator[Diagnostic]:
    """The findings: errors of the kinds ``counted``, warnings of others that ``TOLD`` has, and no more.

    ``only`` has the kinds that are told at all. ``gone`` are entries of the lock without a criterion. With ``chosen``
    nothing is told that is not about these criteria.
    """
    kinds = [name for name in (*TOLD, *counted) if name in only]
    told = {KINDS[name].id: Severity.ERROR if name in counted else Severity.WARNING for name in kinds}
    for finding in _all(trace, coverage, gone, chosen):
        severity = told.get(finding.rule.id)
        if severity is not None:
            yield replace(finding, rule=replace(finding.rule, severity=severity))


def _all(
    trace: Trace, coverage: Iterable[Coverage], gone: Mapping[str, ReviewedSpec], chosen: Collection[str] | None
) -> Iterator[Diagnostic]:
    for each in coverage:
        if chosen is None or each.name in chosen:
            yield from _of(each)
            if each.unmet:
                yield _unmet(each, trace)
    if chosen is None:
        yield from _orphans(trace, gone)
        for row in trace.uncited:
            yield Diagnostic(row.place, UNCITED, f"{row.kind} {row.label} cites no requirement")


def _of(each: Coverage) -> Iterator[Diagnostic]:
    place = each.criterion.place
    if each.is_uncovered:
        yield Diagnostic(place, UNCOVERED, f"{each.name} {_why(each)}", _REMEDIES.get(each.verdict), _not_passed(each))
    elif each.verdict is Verdict.PARTLY and each.counts:
        yield Diagnostic(place, PARTLY, f"{each.name}: {counted_text(each.counts)}", related=_not_passed(each))
    if each.is_suspect:
        changed = each.review is Review.CHANGED
        message = "has another text than the one that was reviewed" if changed else "was never reviewed"
        hint = f'look at what answers to it, then: codegen trace accept {each.name} --reason "..."'
        if changed and len(each.suspects) > 1:
            hint += ", with --link for single ones"
        related = tuple((link.place, f"{link.name} {link.says}") for link in each.suspects)
        yield Diagnostic(place, SUSPECT, f"{each.name} {message}", hint, related)
    if each.is_unspecified:
        yield Diagnostic(place, UNSPECIFIED, f"{each.name} is cited by no row of the tables")


def _unmet(each: Coverage, trace: Trace) -> Diagnostic:
    """One finding of all that a criterion depends on and that is not shown, by detours too."""
    (first, verdict), *others = each.unmet
    direct = "" if first in each.depends_on else " by way of others"
    message = f"{each.name} depends{direct} on {unmet_text(first, verdict)}"
    related = tuple((trace.criteria[name][1].place, f"and on {unmet_text(name, other)}") for name, other in others)
    return Diagnostic(each.criterion.place, DEPENDENCY, message, None, related)


def unmet_text(name: str, verdict: Verdict) -> str:
    """``FR-1.2, which has failed``."""
    return f"{name}, {_UNMET[verdict]}"


def _why(each: Coverage) -> str:
    if each.verdict is Verdict.NO_TEST:
        return f"has no test{_of_the_whole(each)}"
    counts = counted_text(each.counts or Counts())
    return f"has failed: {counts}" if each.verdict is Verdict.FAILED else f"is shown by no test: {counts}"


def _of_the_whole(each: Coverage) -> str:
    """Tests that name the document leave open which criterion they show."""
    whole = each.requirement.id
    return (
        f"; {each.whole_tests} of {whole} as a whole do not say which criterion they show" if each.whole_tests else ""
    )


def _not_passed(each: Coverage) -> tuple[tuple[Place, str], ...]:
    """Tests written by hand that did not pass; those of a suite have no place in the specification."""
    return tuple(
        (tested.test.place, f"{tested.test.name}: {counted_text(tested.counts)}")
        for tested in each.tests
        if tested.test.place and tested.counts and tested.counts.passed < tested.counts.cases
    )


def counted_text(counts: Counts) -> str:
    """``12 passed, 2 skipped, 1 without a result``; without what there is none of."""
    parts = [
        (counts.passed, "passed"),
        (counts.failed, "failed"),
        (counts.skipped, "skipped"),
        (counts.stale, "of another specification"),
        (counts.missing, "without a result"),
    ]
    return ", ".join(f"{number} {what}" for number, what in parts if number) or "no case"


def _orphans(trace: Trace, gone: Mapping[str, ReviewedSpec]) -> Iterator[Diagnostic]:
    known = [*trace.names, *trace.criteria]
    for test in trace.tests:
        if test.place is not None and trace.called(test.criterion) is None:
            written = test.written or test.criterion
            message = f"{test.name} shows {written}, which no document has"
            yield Diagnostic(test.place, ORPHANED, message, did_you_mean(written, known))
    for name, kept in gone.items():
        hint = f'codegen trace accept {name} --reason "..." removes the line'
        yield Diagnostic(kept.place, ORPHANED, f"the lock has {name}, which no document has", hint)


def told_of_results(path: str, found: Iterable[TestResult], results: Results, trace: Trace) -> Iterator[Diagnostic]:
    """Yield what is wrong with the results in a file: modules that could not be collected, results of tests by hand
    that are of another specification, and results that do not say of which.
    """
    found = tuple(found)
    for each in found:
        if each.uncollected:
            yield Diagnostic(each.place, UNCOLLECTED_RESULTS, f"the tests of {each.uncollected} could not be collected")
    own = hand_written_results(found, trace)
    outdated = sum(results.is_stale(each) for each in own)
    undated = sum(each.specification is None for each in own)
    of_hand = "results of tests written by hand" if outdated + undated != 1 else "result of a test written by hand"
    if outdated:
        message = f"{outdated} {of_hand}: made with another specification"
        yield Diagnostic(Place(path), OUTDATED_RESULTS, message, "run these tests again")
    if undated:
        message = f"{undated} {of_hand}: no word of the specification"
        yield Diagnostic(Place(path), UNDATED_RESULTS, message, "pytest -p codegen.pytest_plugin notes it")
    lost = len(undated_results_of_suites(found, trace))
    if lost:
        message = (
            f"{lost} {'result' if lost == 1 else 'results'} of a generated suite: the property codegen-inputs is gone"
        )
        hint = "give the file that pytest --junit-xml=FILE wrote, not what another tool has made of it"
        yield Diagnostic(Place(path), UNDATED_RESULTS, message, hint)
