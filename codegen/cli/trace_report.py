"""The report of ``codegen trace``."""

import argparse
import sys
from collections.abc import Sequence

from codegen.cli.findings import FORMATS, findings_text, print_findings
from codegen.cli.progress import working
from codegen.commands.trace import Refused, chosen_criteria, read_trace, read_trace_lock, shared_modules
from codegen.diagnostics import Diagnostic, Report
from codegen.emit.file import write_file
from codegen.model.system import System
from codegen.project.systems import NO_FOLDER_OF_TESTS, project_folder
from codegen.source import shown_path
from codegen.trace.coverage import coverage_of
from codegen.trace.findings import trace_findings
from codegen.trace.link import suspects
from codegen.trace.lock import gone, reviews
from codegen.trace.results import with_links_of
from codegen.trace.text import summary_text, tree_text
from codegen.trace.view import TraceView, only, trace_view


def report_trace(arguments: argparse.Namespace, project: str, systems: Sequence[System], reading: Report) -> int:
    """Print or write the report, then the findings where there is room for them; return the exit code.

    ``reading`` is what was found when the specification was read: of documents and of folders of tests it is told here,
    too, since what is not read there is missing from the trace.
    """
    report = Report()
    report.extend(each for each in reading if each.rule is NO_FOLDER_OF_TESTS or _is_of_document(each))
    with working("reading documents and tests"):
        trace = read_trace(systems, report, shared=shared_modules(systems))
    lock = read_trace_lock(project, report)
    suspect = suspects(trace, lock)  # links that only results tell cannot be accepted, as accept knows no results
    results = None
    if arguments.results is not None:
        from codegen.commands.results import with_results

        trace, results = with_results(arguments.results, trace, systems, report)
        trace = with_links_of(trace, results)
    if report.exit_code == 2:  # nothing could be said of what is in a file that cannot be read
        print_findings(report)
        return report.exit_code
    chosen = chosen_criteria(arguments.names, trace)
    if isinstance(chosen, Refused):
        print(f"codegen trace: {chosen.why}", file=sys.stderr)
        return 2
    coverage = coverage_of(trace, reviews(trace, lock), suspect, results)
    about = chosen if arguments.names else None
    report.extend(trace_findings(trace, coverage, gone(trace, lock), arguments.fail_on, about))
    files = None if arguments.results is None else [shown_path(path) for path in arguments.results]
    folder = project_folder(systems)
    view = trace_view(systems[0].spec.project.project, folder, trace, coverage, report, files)
    view = view if about is None else only(view, about)
    text = _text(arguments.format, view, report, is_tree=about is not None, changed=arguments.last_change)
    if arguments.out is None:
        print(text, end="")
    else:
        written = Report()
        if not write_file(arguments.out, text, written):
            print_findings(written)
            return written.exit_code
    if arguments.format == "text" or arguments.out is not None:
        print_findings(report)
    return report.exit_code


def _is_of_document(finding: Diagnostic) -> bool:
    return finding.place.file.lower().endswith((".md", ".markdown"))


def _text(form: str, view: TraceView, report: Report, *, is_tree: bool, changed: str | None) -> str:
    if form in FORMATS and form != "text":
        found = findings_text(report, form)
        return f"{found}\n" if found else ""
    if form in ("needs", "reqif"):  # what one form alone needs is imported for it
        from codegen.trace.exchange import exchange_of

        if form == "needs":
            from codegen.trace.needs import needs_json

            return needs_json(exchange_of(view))
        from codegen.trace.reqif import NEVER, reqif_xml

        return reqif_xml(exchange_of(view), changed or NEVER)
    if form in ("html", "markdown"):
        from codegen.trace.page import trace_markdown, trace_report

        return trace_report(view) if form == "html" else trace_markdown(view)
    return tree_text(view) if is_tree else summary_text(view)
