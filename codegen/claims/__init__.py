"""Claims of documents, recomputed: one module for each kind, a pure function from a reading to its findings.

A module with a function ``check`` that lies here, or in ``own``, is run; nothing lists it.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from codegen.claims import own
from codegen.claims.own.worked.examples import EXAMPLE
from codegen.claims.reading import Reading, merged
from codegen.claims.rules import as_sure
from codegen.diagnostics import Diagnostic
from codegen.rules.checks import checks_in

LIKELY = "likely, not certain"
"""The mark of a finding whose claim was read from the words around it; its rule is then a warning and says why."""


def of_dialect(reading: Reading, *, with_weighed: bool = True) -> tuple[Diagnostic, ...]:
    """Return the findings for claims about messages, fields and entries against the dialect; some occur repeatedly.

    Besides what rules find there is what weighs enough by all that stands around it, which is likely only; and what a
    rule reads as likely is left out where that weighs too little.
    """
    found = [finding for check in checks_in(__name__) for finding in check(reading)]
    kept = tuple(_borne_out(reading, found)) if found else ()
    if with_weighed:
        kept = _weighed(reading, found, kept)
    if not kept:
        return ()
    from codegen.claims.copied import is_copied
    from codegen.claims.doubted import told

    return tuple(told(reading, [each for each in kept if not is_copied(reading, each)]))


def _weighed(reading: Reading, found: Iterable[Diagnostic], kept: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The findings that are kept, without those that weigh too little, and others at places of which no rule speaks."""
    from codegen.claims.parts.spans import spans

    if not spans(reading):
        return tuple(kept)
    from codegen.claims.weighed.likely import is_kept, likely, weighed
    from codegen.claims.weighed.weights import stored_weights

    those, least = weighed(reading), stored_weights().least
    return (*(each for each in kept if is_kept(those, each, least)), *likely(those, found))


def _borne_out(reading: Reading, found: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """The findings about what the document itself says; those that its structure does not bear out are likely only."""
    from codegen.claims.elsewhere import is_elsewhere
    from codegen.claims.evidence import FIRM, evidence_of

    for finding in found:
        if not is_elsewhere(reading, finding):
            is_likely = finding.is_error and evidence_of(reading, finding) not in FIRM
            yield replace(finding, rule=as_sure(finding.rule, is_sure=False)) if is_likely else finding


def of_project(reading: Reading) -> tuple[Diagnostic, ...]:
    """Return the findings for claims about the project against its specification; some occur repeatedly."""
    return tuple(finding for check in checks_in(own.__name__) for finding in check(reading))


def check_claims(reading: Reading, is_judged: Callable[[int], bool] = lambda _: True) -> list[Diagnostic]:
    """Return the findings for the judged lines of a document, in the document's order."""
    return settled(reading, (*of_dialect(reading), *of_project(reading)), is_judged)


def settled(
    reading: Reading, found: Iterable[Diagnostic], is_judged: Callable[[int], bool] = lambda _: True
) -> list[Diagnostic]:
    """Each claim that was found wrong once, with the places that repeat it.

    Of a number that another rule tells already, nothing is said as part of a worked example.
    """
    quoted = reading.quoted_as_wrong
    judged = (each for each in found if each.place.line not in quoted and is_judged(each.place.line))
    told = merged({(each.place.line, each.rule.id, each.message): each for each in judged}.values())
    others = {
        place for each in told if each.rule is not EXAMPLE for place in (each.place, *(at for at, _ in each.related))
    }
    told = [each for each in told if each.rule is not EXAMPLE or each.place not in others]
    once = list({(finding.place, finding.rule.id): finding for finding in reversed(told)}.values())[::-1]
    return [_with_sureness(finding) for finding in once]


def _with_sureness(finding: Diagnostic) -> Diagnostic:
    """A finding that is not certain says so; only certain ones are errors."""
    if finding.is_error or finding.waived is not None:
        return finding
    return replace(finding, message=f"{finding.message} ({LIKELY})")
