"""Requirement documents by id and alias, and the citations of them in the tables."""

from collections.abc import Mapping, Sequence
from typing import Protocol

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.model.spec.spec import Requirement
from codegen.model.vehicle import Citation
from codegen.pattern import pattern
from codegen.source import Place

UNKNOWN_REQUIREMENT = Rule(
    "unknown-requirement",
    "A table cites a requirement or a criterion that no document in requirements/ has. "
    "Cite an existing one as ID or ID.number; older ids work where the document lists them as aliases.",
    remedy="write its document in requirements, or cite one that is there as ID or ID.number",
)
WITHDRAWN_REQUIREMENT = Rule(
    "withdrawn-requirement",
    "A table cites a document whose status says that it does not hold any more: withdrawn, rejected, superseded, "
    "replaced, obsolete, deprecated, retired, removed, void, no longer valid and the like, in its first words. What "
    "the row says has nobody left who asks for it, and a trace would show it as covered. Cite the document that came "
    "after, or take the row out.",
    Severity.WARNING,
    remedy="cite the document that came after, or take the row out",
)
_NO_LONGER = pattern(
    r"(?i)[\W_]*(?:~~[^~]*~~\W*)?(?:withdrawn|rejected|superseded|obsolete|deprecated|retired|cancell?ed|deleted|removed"
    r"|replaced|revoked|repealed|abandoned|dropped|discontinued|expired|archived|void|invalid|no longer|not valid)\b"
)
UNKNOWN_ASPECT = Rule(
    "unknown-aspect",
    "criteria names an aspect that the record does not have, so no test would carry the criterion.",
    remedy="leave it out: what is written there has no aspects",
)


def index_requirements(requirements: Sequence[Requirement]) -> dict[str, Requirement]:
    """Every document under its id and its aliases; the first one wins (repetitions are reported when decoding)."""
    index: dict[str, Requirement] = {}
    for requirement in requirements:
        for name in (requirement.id, *requirement.aliases):
            index.setdefault(name, requirement)
    return index


def cite(text: str, place: Place, index: Mapping[str, Requirement], report: Report) -> Citation | None:
    """The citation written as ``FR-00068`` or ``FR-00068.3``; None, with a finding, if there is no such thing."""
    name, dot, number = text.partition(".")
    requirement = index.get(name)
    if requirement is None:
        report.add(UNKNOWN_REQUIREMENT, place, f"no requirement document is called {name}", did_you_mean(name, index))
        return None
    if _NO_LONGER.match(requirement.status):
        related = [(requirement.place, f"{requirement.id} is here")]
        report.add(
            WITHDRAWN_REQUIREMENT, place, f"the status of {requirement.id} is {requirement.status}", None, related
        )
    if not dot:
        return Citation(requirement, None)
    for criterion in requirement.criteria:
        if str(criterion.number) == number:
            return Citation(requirement, criterion)
    report.add(
        UNKNOWN_REQUIREMENT,
        place,
        f"{requirement.id} has no criterion {number or '(empty)'}",
        f"its criteria are 1 to {len(requirement.criteria)}" if requirement.criteria else "it has no criteria",
        [(requirement.place, f"{requirement.id} is here")],
    )
    return None


def cite_optional(text: str | None, place: Place, index: Mapping[str, Requirement], report: Report) -> Citation | None:
    """Return a citation, like :func:`cite`; None, without a finding, where nothing is cited."""
    return None if text is None else cite(text, place, index, report)


class _WithAspects(Protocol):
    """A record that names criteria for single aspects of it."""

    @property
    def ASPECTS(self) -> tuple[str, ...]: ...  # noqa: N802  a constant of each such class

    @property
    def criteria(self) -> Mapping[str, str]: ...

    def at(self, key: str) -> Place: ...


def cite_aspects(spec: _WithAspects, index: Mapping[str, Requirement], report: Report) -> dict[str, Citation]:
    """The criteria that a record gives for single aspects of it."""
    cited = {}
    for aspect, text in spec.criteria.items():
        place = spec.at(f"criteria.{aspect}")
        if aspect not in spec.ASPECTS:
            report.add(UNKNOWN_ASPECT, place, f"there is no aspect {aspect}", did_you_mean(aspect, spec.ASPECTS))
            continue
        citation = cite(text, place, index, report)
        if citation is not None:
            cited[aspect] = citation
    return cited
