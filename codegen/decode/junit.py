"""Results of tests in JUnit's XML, as pytest and many other tools write them."""

from collections.abc import Iterator

from codegen.diagnostics import Report, Rule
from codegen.load.files import Files
from codegen.load.xml_tree import XmlElement, place_of, read_xml
from codegen.model.test_record import SPECIFICATION_PROPERTY, Outcome, TestResult

JUNIT_FORMAT = Rule(
    "junit-format",
    "A file of results has no <testsuites> or <testsuite> at its root. Give the file that pytest --junit-xml=FILE, or "
    "another tool that knows JUnit's format, has written.",
    unreadable=True,
    remedy="give the file that pytest --junit-xml=FILE has written",
)

MAX_BYTES = 200_000_000
"""Largest file of results that is read, in bytes: they hold what failed tests have printed."""

_BAD = ("failure", "error")
_UNCOLLECTED = "collection failure"
"""Message of the error that pytest writes for a module that it could not import, as a case without a class."""


def decode_junit(path: str, files: Files, report: Report) -> tuple[TestResult, ...] | None:
    """The results of a file in its order; None, after a finding, where it cannot be read."""
    root = read_xml(path, files, report, most=MAX_BYTES)
    if root is None:
        return None
    if root.tag not in ("testsuites", "testsuite"):
        report.add(JUNIT_FORMAT, place_of(root, path), f"<{root.tag}> is not what results of tests begin with")
        return None
    return tuple(_results(root, path))


def _results(element: XmlElement, path: str) -> Iterator[TestResult]:
    for child in element.children:
        if child.tag == "testsuite":
            yield from _results(child, path)
        elif child.tag == "testcase":
            yield _result(child, path)


def _result(case: XmlElement, path: str) -> TestResult:
    tags = {child.tag for child in case.children}
    outcome = Outcome.PASSED
    if not tags.isdisjoint(_BAD):
        outcome = Outcome.FAILED
    elif "skipped" in tags:
        outcome = Outcome.SKIPPED
    properties = [
        (one.attributes.get("name", ""), one.attributes.get("value", ""))
        for child in case.children
        if child.tag == "properties"
        for one in child.children
    ]
    name = case.attributes.get("name", "")
    said = [child.attributes.get("message") for child in case.children if child.tag == "error"]
    return TestResult(
        module=case.attributes.get("classname", ""),
        name=name,
        outcome=outcome,
        shows=tuple(dict.fromkeys(value for name, value in properties if name == "requirement")),
        inputs=next((value for name, value in properties if name == "codegen-inputs"), None),
        place=place_of(case, path),
        specification=next((value for name, value in properties if name == SPECIFICATION_PROPERTY), None),
        uncollected=name if _UNCOLLECTED in said else "",
    )
