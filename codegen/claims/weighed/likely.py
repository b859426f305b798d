"""Findings that are likely by all that stands around them, at places of which no rule says anything."""

from collections.abc import Iterable, Iterator

from codegen.claims.reading import Reading
from codegen.claims.weighed.candidates import Candidate, candidates
from codegen.claims.weighed.weights import likelihood, stored_weights
from codegen.diagnostics import Diagnostic


def likely(reading: Reading, told: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield the findings that weigh enough, the likeliest of each place and each field; none of what is told."""
    weights = stored_weights()
    weighed = ((likelihood(weights.of, each.kind, each.traits), each) for each in candidates(reading))
    enough = [(weight, each) for weight, each in weighed if weight >= weights.threshold]
    yield from (each.finding for each in chosen(enough, told)) if enough else ()


def chosen(weighed: Iterable[tuple[float, Candidate]], told: Iterable[Diagnostic]) -> Iterator[Candidate]:
    """Yield of candidates with their weights the first one of each place, and of each field in a line."""
    known = list(told)
    taken: set[object] = set()
    for _, each in sorted(weighed, key=lambda one: (-one[0], one[1].finding.place)):
        place = each.finding.place
        keys = {(place.line, each.field), place}
        if not keys & taken and not any(_is_about(finding, each) for finding in known):
            yield each
        taken |= keys


def _is_about(finding: Diagnostic, candidate: Candidate) -> bool:
    """Return whether a finding is at the place of a candidate, or in its line about its field."""
    place = candidate.finding.place
    if finding.place == place:
        return True
    lines = {finding.place.line, *(at.line for at, _ in finding.related)}
    return place.line in lines and candidate.field in f"{finding.message} {finding.hint or ''}"
