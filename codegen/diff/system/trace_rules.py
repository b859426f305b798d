"""The kinds of change of requirements and of what answers to them."""

from codegen.diagnostics import Severity
from codegen.diff.change import Area, ChangeRule


def _trace(name: str, explanation: str, severity: Severity = Severity.WARNING) -> ChangeRule:
    return ChangeRule(name, explanation, severity, area=Area.TRACE)


REQUIREMENT_ADDED = _trace("requirement-added", "A requirement document is new, and with it criteria to be met.")
REQUIREMENT_REMOVED = _trace(
    "requirement-removed", "A requirement document is gone: what answered to it stands without a reason."
)
REQUIREMENT_TEXT = _trace(
    "requirement-text-changed",
    "The text of a criterion, or the title of a document, has changed: what answers to it has to be looked at again.",
)
REQUIREMENT_STATUS = _trace(
    "requirement-status-changed",
    "A document has another status, other aliases or links, or another id with the old one as an alias.",
)
CRITERION_ADDED = _trace("criterion-added", "A requirement has a criterion more.")
CRITERION_REMOVED = _trace(
    "criterion-removed", "A requirement has a criterion less: what answered to it stands without a reason."
)
UNCOVERED = _trace(
    "criterion-uncovered",
    "A criterion that something in the specification answered to is answered by nothing any more.",
    Severity.ERROR,
)
UNTESTED = _trace(
    "criterion-untested",
    "A criterion that a test showed is shown by none any more.",
    Severity.ERROR,
)
ORPHANED = _trace(
    "citation-orphaned",
    "A test, or a row of a table, names a criterion that was removed or renumbered: it shows something that nobody "
    "asks for, or something else than it did.",
    Severity.ERROR,
)
COVERED = _trace("criterion-covered", "A criterion that nothing answered to is answered now.")
CITATION = _trace("citation-changed", "A part of the specification answers to another requirement or criterion.")
DOCUMENT = ChangeRule(
    "document-text-changed",
    "A requirement document says something else outside its criteria: in its rationale, its tables, its examples.",
    Severity.WARNING,
    area=Area.DOCUMENTATION,
)
DOC = ChangeRule(
    "doc-changed",
    "What the specification says for people about one of its parts has changed.",
    Severity.WARNING,
    area=Area.DOCUMENTATION,
)
