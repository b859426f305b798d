"""Findings that are likely by all that stands around them, and those of rules that are not."""

from collections.abc import Iterable, Iterator, Sequence

from codegen.claims.reading import Reading
from codegen.claims.weighed.candidates import Candidate, candidates
from codegen.claims.weighed.weights import likelihood, stored_weights
from codegen.diagnostics import Diagnostic

Weighed = Sequence[tuple[float, Candidate]]
"""Candidates with their likelihoods."""


def weighed(reading: Reading) -> Weighed:
    """Return the candidates of a document with their likelihoods."""
    weights = stored_weights().of
    return [(likelihood(weights, each.kind, each.traits), each) for each in candidates(reading)]


def likely(those: Weighed, told: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield the findings that weigh enough, the likeliest of each place and each field; none of what is told."""
    enough = [each for each in those if each[0] >= stored_weights().threshold]
    yield from (each.finding for each in chosen(enough, told)) if enough else ()


def chosen(those: Iterable[tuple[float, Candidate]], told: Iterable[Diagnostic]) -> Iterator[Candidate]:
    """Yield of candidates with their weights the first one of each place, and of each field in a line."""
    known = list(told)
    taken: set[object] = set()
    for _, each in sorted(those, key=lambda one: (-one[0], one[1].finding.place)):
        place = each.finding.place
        keys = {(place.line, _name(each)), place}
        if not keys & taken and not any(_is_about(finding, each) for finding in known):
            yield each
        taken |= keys


def is_kept(those: Weighed, finding: Diagnostic, least: float) -> bool:
    """Return whether a finding of a rule is told: a likely one is not where all that stands around it is against it.

    Compared are candidates for the same statement, first of all at its place; if there is none, the rule is believed.
    """
    if finding.is_error:
        return True
    same = [(weight, each) for weight, each in those if _is_same(finding, each)]
    there = [weight for weight, each in same if each.finding.place == finding.place]
    found = there or [weight for weight, each in same if not each.kind.endswith(" of none")]
    return not found or max(found) >= least


def _is_same(finding: Diagnostic, candidate: Candidate) -> bool:
    """Return whether a finding and a candidate are of one rule, about one thing, in one line."""
    other = candidate.finding
    if (finding.rule.id, finding.place.line) != (other.rule.id, other.place.line):
        return False
    return _name(candidate) in finding.message


def _name(candidate: Candidate) -> str:
    return candidate.field or candidate.message


def _is_about(finding: Diagnostic, candidate: Candidate) -> bool:
    """Return whether a finding is at the place of a candidate, or in its line about its field."""
    place = candidate.finding.place
    if finding.place == place:
        return True
    lines = {finding.place.line, *(at.line for at, _ in finding.related)}
    return place.line in lines and _name(candidate) in f"{finding.message} {finding.hint or ''}"
