"""The results of tests and boards, as far as they are about a project."""

import os
from collections.abc import Sequence

from codegen.commands.bench import bench_inputs_of
from codegen.commands.trace import folders_of_tests
from codegen.decode.bench_record import decode_bench
from codegen.decode.junit import decode_junit
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.marked_tests import files_of_tests
from codegen.model.system import System
from codegen.model.test_record import TestResult
from codegen.source import Place
from codegen.trace.bench import check_conditions, with_bench
from codegen.trace.findings import LOST_TESTS, UNRELATED_RESULTS, told_of_results
from codegen.trace.generated_tests import inputs_of
from codegen.trace.graph import Trace
from codegen.trace.results import Results, files_that_are_gone, results_of, unrelated


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
    folders = [folder for folder in folders_of_tests(systems) if DISK.is_folder(folder)]
    names = {os.path.basename(each) for each in files_of_tests(folders, DISK, Report())} if by_file else set()
    below = [os.path.basename(folder) for folder in folders]
    for path, listed in by_file.items():
        report.extend(told_of_results(path, listed, results, trace))
        for gone in files_that_are_gone(listed, trace, below, names):
            hint = "run the tests again, and give the file that is written then"
            report.add(LOST_TESTS, Place(path), f"there is no {gone} any more, and its results count", hint)
    return trace, results
