"""The results of tests and boards, as far as they are about a project."""

from collections.abc import Sequence

from codegen.commands.bench import bench_inputs_of
from codegen.decode.bench_record import decode_bench
from codegen.decode.junit import decode_junit
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.system import System
from codegen.model.test_record import TestResult
from codegen.source import Place
from codegen.trace.bench import check_conditions, with_bench
from codegen.trace.findings import UNRELATED_RESULTS, told_of_results
from codegen.trace.generated_tests import inputs_of
from codegen.trace.graph import Trace
from codegen.trace.results import Results, results_of, unrelated


def with_results(
    files: Sequence[str], trace: Trace, systems: Sequence[System], report: Report
) -> tuple[Trace, Results]:
    """Return the trace with boards as tests, and the results of all files; what cannot be read leaves a finding."""
    by_file: dict[str, Sequence[TestResult]] = {}
    records = []
    for path in files:
        if path.endswith(".json"):
            records.append(decode_bench(path, DISK, report))
            continue
        decoded = decode_junit(path, DISK, report)
        if decoded is not None and unrelated(decoded, trace):
            report.add(
                UNRELATED_RESULTS,
                Place(path),
                "none of its results is about this project",
                hint="give what pytest --junit-xml=FILE wrote in this project",
            )
        by_file[path] = decoded or ()
    measured: Sequence[TestResult] = ()
    if records:
        check_conditions(trace.requirements, report)
        trace, measured = with_bench(trace, [each for each in records if each], bench_inputs_of(systems), report)
    found = [each for listed in by_file.values() for each in listed]
    results = results_of([*found, *measured], trace.tests, inputs_of(systems))
    for path, listed in by_file.items():
        report.extend(told_of_results(path, listed, results, trace))
    return trace, results
