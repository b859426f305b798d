"""Compares measurements on a board with the limits that documents state.

Under "What a host cannot show" a document says with which measure of ``codegen bench`` a criterion is met:
``- Criterion 11: ... On the bench: `frame.mean_us < 100`.``
"""

import operator
import re
from collections.abc import Callable, Iterable, Mapping, Sequence

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.frozen import dataclass
from codegen.model.bench_record import MEASURES, BenchRecord
from codegen.model.spec.spec import HostLimit, Requirement
from codegen.model.test_record import Outcome, TestResult
from codegen.source import shown_path
from codegen.trace.findings import UNRELATED_RESULTS
from codegen.trace.graph import Test, Trace, linked

NO_MEASURE = Rule(
    "bench-measure",
    "A document compares a measure that codegen bench does not have: docs/bench.md lists them.",
    Severity.WARNING,
    remedy="name one that docs/bench.md lists",
)

_GROUPS = "|".join(sorted({name.partition(".")[0] for name in MEASURES}))
_CONDITION = re.compile(rf"\b((?:{_GROUPS})\.[a-z_]+) (<=|>=|<|>|=) (\d+(?:\.\d+)?)")
_COMPARED: Mapping[str, Callable[[float, float], bool]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "=": operator.eq,
}


@dataclass(frozen=True, slots=True)
class Condition:
    """One comparison as it is written, of one measure with a number."""

    text: str
    measure: str
    sign: str
    number: float

    def outcome(self, record: BenchRecord) -> Outcome:
        """Return whether a board has met it; skipped where it was not measured."""
        value = record.measures.get(self.measure)
        if value is None:
            return Outcome.SKIPPED
        return Outcome.PASSED if _COMPARED[self.sign](value, self.number) else Outcome.FAILED


def conditions_of(limit: HostLimit) -> tuple[Condition, ...]:
    """The comparisons that an item names, measures that nobody knows included."""
    return tuple(Condition(each[0], each[1], each[2], float(each[3])) for each in _CONDITION.finditer(limit.text))


def check_conditions(requirements: Iterable[Requirement], report: Report) -> None:
    """Report measures that there are not."""
    for requirement in requirements:
        for limit in requirement.host_limits:
            for each in conditions_of(limit):
                if each.measure not in MEASURES:
                    hint = did_you_mean(each.measure, MEASURES)
                    report.add(NO_MEASURE, limit.place, f"codegen bench has no {each.measure}", hint or None)


def with_bench(
    trace: Trace, records: Sequence[BenchRecord], inputs: Mapping[tuple[str, str], str], report: Report
) -> tuple[Trace, tuple[TestResult, ...]]:
    """The graph with a test for each board and criterion, and their results.

    ``inputs`` has by project and program the hash of the specification as it is now: a record of another one is stale.
    """
    tests: list[Test] = []
    found: list[TestResult] = []
    for record in records:
        current = inputs.get((record.project, record.program))
        if current is None:
            name = f"{record.project} {record.program}".strip()
            report.add(
                UNRELATED_RESULTS,
                record.place,
                f"it is about {name}, which this project has not",
                hint="give the record of a bench of this project",
            )
            continue
        path = shown_path(record.place.file).replace("\\", "/")
        function = f"codegen bench on {record.board}"
        for name, conditions in _asked(trace).items():
            tests.append(Test(path, function, name, tuple(each.text for each in conditions), inputs=current))
            for each in conditions:
                case = f"{function}[{each.text}]"
                outcome = each.outcome(record)
                module = path.replace("/", ".")
                found.append(TestResult(module, case, outcome, (name,), record.inputs, record.place))
        if not tests:
            report.add(
                UNRELATED_RESULTS,
                record.place,
                "no document names a measure of codegen bench",
                hint="name one of docs/bench.md, with a limit, under 'What a host cannot show'",
            )
    if not tests:
        return trace, ()
    return linked(trace.requirements, (*trace.rows, *trace.uncited), (*trace.tests, *tests)), tuple(found)


def _asked(trace: Trace) -> dict[str, list[Condition]]:
    """Return by criterion the conditions that a board has to show."""
    asked: dict[str, list[Condition]] = {}
    for requirement in trace.requirements:
        for limit in requirement.host_limits:
            known = [each for each in conditions_of(limit) if each.measure in MEASURES]
            for name in (f"{requirement.id}.{number}" for number in limit.numbers):
                if known and name in trace.criteria:
                    asked.setdefault(name, []).extend(known)
    return asked
