"""Findings as JUnit XML, which build servers show as results of tests."""

from collections.abc import Iterable
from xml.sax.saxutils import escape, quoteattr

from codegen.diagnostics import Diagnostic
from codegen.findings.text import counts, printable, repository_path


def findings_junit(findings: Iterable[Diagnostic], base: str | None = None) -> str:
    """One suite with a case for each finding: an error fails, a waived one is skipped, a warning passes and is told.

    Without findings there is one case that passes, since servers take an empty suite for a run that did not happen.
    ``base`` is the root of the repository, to which paths are relative.
    """
    findings = list(findings)
    errors, _, waived = counts(findings)
    cases = [_case(finding, base) for finding in findings] or ['<testcase classname="codegen" name="no findings"/>']
    head = f'<testsuite name="codegen" tests="{len(cases)}" failures="{errors}" errors="0" skipped="{waived}">'
    return "\n".join(
        ['<?xml version="1.0" encoding="utf-8"?>', "<testsuites>", head, *cases, "</testsuite>", "</testsuites>"]
    )


def _case(finding: Diagnostic, base: str | None) -> str:
    place = finding.place
    file = printable(repository_path(place.file, base)[0])
    message = printable(finding.message)
    name = f"{finding.rule.id} {file}:{place.line}:{place.column} {message}"
    opening = f"<testcase classname={quoteattr(finding.rule.id)} name={quoteattr(name)} file={quoteattr(file)}"
    opening += f' line="{place.line}">'
    lines = [f"{file}:{place.line}:{place.column}: {message}"]
    lines += [f"hint: {printable(finding.advice)}"] if finding.advice is not None else []
    lines += [
        f"{printable(repository_path(other.file, base)[0])}:{other.line}: {printable(said)}"
        for other, said in finding.related
    ]
    text = escape("\n".join(lines))
    if finding.waived is not None:
        return f"{opening}<skipped message={quoteattr(printable(finding.waived))}/></testcase>"
    if finding.is_error:
        failure = f"<failure type={quoteattr(finding.rule.id)} message={quoteattr(message)}>{text}</failure>"
        return f"{opening}{failure}</testcase>"
    return f"{opening}<system-out>{text}</system-out></testcase>"
