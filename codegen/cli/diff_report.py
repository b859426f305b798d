"""Printing a review in each of its formats."""

import sys
from collections.abc import Callable, Sequence
from dataclasses import replace

from codegen.cli.findings import findings_text, wants_colour
from codegen.diagnostics import Diagnostic
from codegen.diff.report.review import Review, as_finding, elsewhere_text, fault_findings, off_text
from codegen.findings.text import finding_text
from codegen.source import Place


def print_review(found: Review, form: str, on_disk: Callable[[str], str], told: Sequence[Diagnostic] = ()) -> None:
    """Print the report; for people nothing where nothing changed.

    ``on_disk`` returns of a path of either side that of the file of which it is a version. ``told`` is what is wrong
    with waivers and severities: a report that is not read beside stderr has it, too.
    """
    if form in ("json", "html", "markdown"):
        notes = (f"{each.place.shown()}: {each.rule.id}: {each.message}" for each in told)
        found = replace(found, notes=(*found.notes, *notes))
    if form == "json":
        from codegen.diff.report.as_json import review_json

        print(review_json(found))
    elif form == "html":
        from codegen.diff.report.page import review_page

        print(review_page(found), end="")
    elif form == "markdown":
        from codegen.diff.report.markdown import review_markdown

        print(review_markdown(found), end="")
    elif form in ("github", "sarif", "junit", "gitlab"):
        findings = [_in_work_tree(fault, on_disk) for fault in fault_findings(found)]
        findings += [_in_work_tree(as_finding(group), on_disk) for group in found.groups]
        findings += told
        text = findings_text(findings, form)
        if text:
            print(text)
    else:
        _print_text(found)


def _in_work_tree(finding: Diagnostic, on_disk: Callable[[str], str]) -> Diagnostic:
    """Return a finding whose place is in the work tree: what is gone is shown at the head of its file as it is.

    Services that take findings know no other version, nor lines of one.
    """
    file = on_disk(finding.place.file)
    if file == finding.place.file:
        return finding
    return replace(finding, place=Place(file), related=((finding.place, "it stood here"), *finding.related))


def _print_text(found: Review) -> None:
    is_coloured = wants_colour(sys.stdout)
    for group in found.groups:
        print(finding_text(as_finding(group), is_coloured=is_coloured))
    print(end="", flush=True)
    for fault in fault_findings(found):
        print(finding_text(fault), file=sys.stderr)
    for note in found.notes:
        print(f"note: {note}", file=sys.stderr)
    if not found.is_empty:
        print(f"{found.base} -> {found.head}: {found.head_line}", file=sys.stderr)
    if found.off:
        print(off_text(found.off)[:-1], file=sys.stderr)
    if found.elsewhere:
        print(f"{elsewhere_text(found.elsewhere)[:-1]} (see --all)", file=sys.stderr)
