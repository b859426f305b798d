"""Citations of requirement documents: one that does not hold any more is told where it is cited."""

import pytest

from codegen.diagnostics import Report
from codegen.model.spec.spec import Requirement
from codegen.resolve.citation import WITHDRAWN_REQUIREMENT, cite, index_requirements
from codegen.source import Place

TABLE, DOCUMENT = Place("heartbeat.yaml", 3, 1), Place("FR-7.md", 1, 1)


def told(status: str) -> list[tuple[str, str]]:
    """Return the rules and messages of a citation of a document with a status."""
    document = Requirement(
        place=DOCUMENT, id="FR-7", title="Beats", aliases=("FR-old",), status=status, links=(), criteria=()
    )
    report = Report()
    cited = cite("FR-old", TABLE, index_requirements([document]), report)
    assert cited is not None, "it is cited all the same"
    assert {each.place for each in report} <= {TABLE}
    return [(each.rule.id, each.message) for each in report]


@pytest.mark.parametrize(
    "status",
    [
        "Withdrawn",
        "superseded by FR-8",
        "Rejected, see FR-8",
        "OBSOLETE",
        "No longer valid",
        "Replaced by FR-8",
        "~~Approved~~ Removed",
        "Void",
    ],
)
def test_what_does_not_hold_any_more_is_told(status: str) -> None:
    assert told(status) == [("withdrawn-requirement", f"the status of FR-7 is {status}")]
    assert WITHDRAWN_REQUIREMENT.standing == "warning"


@pytest.mark.parametrize(
    "status",
    [
        "Approved",
        "Draft",
        "Accepted",
        "Proposed, supersedes FR-6",
        "~~Draft~~ Approved",
        "Valid; replaces FR-6",
        "Voidable",
        "",
    ],
)
def test_what_holds_or_may_come_to_hold_is_not(status: str) -> None:
    assert told(status) == []
