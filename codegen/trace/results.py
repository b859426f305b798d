"""Results of tests meet the graph: how often each test passed, and what is too old to show anything.

A test of a generated suite says of which specification it was made, one written by hand with which it was run; a
result of another one is stale. Of one test in several files all results count: one that failed is not made good by
another.
"""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from codegen.frozen import dataclass
from codegen.model.test_record import Outcome, TestResult
from codegen.trace.graph import Test, Trace, linked


@dataclass(frozen=True, slots=True)
class Counts:
    """The outcomes of a test's cases; ``missing`` are those without a result."""

    passed: int = 0
    failed: int = 0
    skipped: int = 0
    stale: int = 0
    missing: int = 0

    def __add__(self, other: "Counts") -> "Counts":
        """The sum."""
        return Counts(
            self.passed + other.passed,
            self.failed + other.failed,
            self.skipped + other.skipped,
            self.stale + other.stale,
            self.missing + other.missing,
        )

    @property
    def cases(self) -> int:
        """Return how many there are."""
        return self.passed + self.failed + self.skipped + self.stale + self.missing


@dataclass(frozen=True, slots=True)
class Results:
    """The results of one or several files, by module and by the name of the test without its parameters.

    ``uncollected`` are the modules that could not even be imported: each of their tests ended with an error.
    ``current`` are the hashes of the suites as they are generated now, ``specification`` is that of all of them for
    tests written by hand.
    """

    modules: Mapping[str, Mapping[str, Sequence[TestResult]]]
    current: Collection[str]
    specification: str
    uncollected: Collection[str] = ()

    def is_stale(self, result: TestResult, *, of_suite: bool = False) -> bool:
        """Return whether a result is of another specification.

        What does not say of which counts as of this one, but not the result of a generated suite, which always says it:
        a tool has left that out, and nobody knows how old the result is.
        """
        if result.inputs is not None:
            return result.inputs not in self.current
        return result.specification not in ((self.specification,) if of_suite else (None, self.specification))


def results_of(found: Iterable[TestResult], tests: Iterable[Test], specification: str) -> Results:
    """The results in order to be looked up for tests."""
    modules: dict[str, dict[str, list[TestResult]]] = defaultdict(lambda: defaultdict(list))
    uncollected = set()
    for result in found:
        if result.uncollected:
            uncollected.add(result.uncollected)
        else:
            modules[result.module][result.name.partition("[")[0]].append(result)
    return Results(modules, {test.inputs for test in tests if test.inputs}, specification, uncollected)


def counts_of(test: Test, results: Results) -> Counts:
    """Return how the cases of a test went; of a module that could not be collected all have failed."""
    if any(_is_module(module, _dotted(test.file)) for module in results.uncollected):
        return Counts(failed=max(1, len(test.cases)))
    by_case: dict[str, list[TestResult]] = {}
    for result in _about(test, results):
        by_case.setdefault(_case(result), []).append(result)
    if not test.cases:
        return (
            sum((_judged(test, listed, results) for listed in by_case.values()), Counts())
            if by_case
            else Counts(missing=1)
        )
    return sum((_judged(test, by_case.get(case, ()), results) for case in test.cases), Counts())


def with_links_of(trace: Trace, results: Results) -> Trace:
    """The graph with the links that only results tell: of tests whose marks are computed, or that lie elsewhere."""
    known: dict[tuple[str, str], list[Test]] = defaultdict(list)
    for test in trace.tests:
        known[test.function.rpartition("::")[2], test.criterion].append(test)
    found: dict[tuple[str, str, str], Test] = {}
    for module, functions in results.modules.items():
        for function, listed in functions.items():
            for result in listed:
                for name in result.shows if result.inputs is None else ():
                    criterion = trace.called(name) or name
                    if not any(_is_in(module, test) for test in known[function, criterion]):
                        file, owner = _file_and_class(module)
                        further = Test(file, f"{owner}{function}", criterion, place=result.place, written=name)
                        found.setdefault((module, function, criterion), further)
    if not found:
        return trace
    return linked(trace.requirements, (*trace.rows, *trace.uncited), (*trace.tests, *found.values()))


def unrelated(found: Iterable[TestResult], trace: Trace) -> bool:
    """Return whether results say nothing about a project: none is of a test that is known, none names a criterion.

    Of a run that ended while tests were collected nothing is known.
    """
    found = tuple(found)
    if any(result.uncollected for result in found):
        return False
    known: dict[str, list[Test]] = defaultdict(list)
    for test in trace.tests:
        known[test.function.rpartition("::")[2]].append(test)
    for result in found:
        if result.inputs is None and any(trace.called(name) for name in result.shows):
            return False
        for test in known[result.name.partition("[")[0]]:
            if _is_in(result.module, test) and (not test.cases or _case(result) in test.cases):
                return False
    return True


def hand_written_results(found: Iterable[TestResult], trace: Trace) -> list[TestResult]:
    """Return the results of tests written by hand that say which criteria of the project they show."""
    return [each for each in found if each.inputs is None and any(trace.called(name) for name in each.shows)]


def files_that_are_gone(
    found: Iterable[TestResult], trace: Trace, folders: Collection[str], names: Collection[str]
) -> tuple[str, ...]:
    """Return the files of tests written by hand that have results, lie below one of ``folders``, and are not there.

    ``names`` are those of all files below these folders: pytest counts from the folder of its settings, so that a file
    of the same name elsewhere below them may be the one.
    """
    files = {_file_and_class(each.module)[0] for each in hand_written_results(found, trace) if each.module}
    return tuple(
        sorted(each for each in files if set(folders) & set(each.split("/")[:-1]) and each.split("/")[-1] not in names)
    )


def undated_results_of_suites(found: Iterable[TestResult], trace: Trace) -> list[TestResult]:
    """Return the results of generated suites that do not say of which specification they are."""
    suites: dict[str, list[Test]] = defaultdict(list)
    for test in trace.tests:
        if test.inputs:
            suites[test.function.rpartition("::")[2]].append(test)
    return [
        each
        for each in found
        if each.inputs is None
        and each.specification is None
        and any(_is_in(each.module, test) for test in suites[each.name.partition("[")[0]])
    ]


def _about(test: Test, results: Results) -> Iterator[TestResult]:
    """The results of a test; where results tell what they show, only those that show its criterion."""
    function = test.function.rpartition("::")[2]
    for module, functions in results.modules.items():
        if function in functions and _is_in(module, test):
            listed = functions[function]
            says = not test.inputs and any(result.shows for result in listed)
            for result in listed:
                if test.inputs and result.inputs in results.current and result.inputs != test.inputs:
                    continue  # of the suite of another program
                if not says or test.criterion in result.shows or test.written in result.shows:
                    yield result


def _judged(test: Test, listed: Sequence[TestResult], results: Results) -> Counts:
    """One case: what failed once has failed, and what is of another specification shows nothing."""
    if not listed:
        return Counts(missing=1)
    if any(results.is_stale(result, of_suite=bool(test.inputs)) for result in listed):
        return Counts(stale=1)
    outcomes = {result.outcome for result in listed}
    if Outcome.FAILED in outcomes:
        return Counts(failed=1)
    return Counts(passed=1) if Outcome.PASSED in outcomes else Counts(skipped=1)


def _case(result: TestResult) -> str:
    return result.name.partition("[")[2].removesuffix("]")


def _is_in(module: str, test: Test) -> bool:
    """Return whether a dotted name is that of a test's module: pytest counts from the
    folder of its settings, not of ours.
    """
    owner, _, _ = test.function.rpartition("::")
    return _is_module(module, _dotted(test.file) + (f".{owner.replace('::', '.')}" if owner else ""))


def _is_module(module: str, own: str) -> bool:
    return module == own or (bool(module) and (own.endswith(f".{module}") or module.endswith(f".{own}")))


def _dotted(file: str) -> str:
    """``tests.test_beat`` of ``tests/test_beat.py``."""
    return file.removesuffix(".py").replace("/", ".")


def _file_and_class(module: str) -> tuple[str, str]:
    """The file of a dotted name, ``tests/test_beat.py``, and ``TestMode::`` where classes stand behind the module.

    Files of tests are called test_... or ..._test; where none is, classes are what begins with a capital letter.
    """
    parts = module.split(".")
    files = [index for index, part in enumerate(parts) if part.startswith("test_") or part.endswith("_test")]
    if files:
        end = files[-1] + 1
    else:
        end = next((index for index, part in enumerate(parts) if part[:1].isupper() and index), len(parts))
    return f"{'/'.join(parts[:end])}.py", "".join(f"{part}::" for part in parts[end:])
