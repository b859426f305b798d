"""Reads the dependencies in the text of a criterion: ``(depends on FR-00070.3, criteria 1 and 2)``.

Parentheses that say anything else are prose; those that begin with a criterion and go on otherwise are a finding.
"""

import re

from codegen.diagnostics import Report, Rule
from codegen.pattern import pattern
from codegen.source import Place

CRITERION_DEPENDS = Rule(
    "criterion-depends",
    "A criterion says in parentheses that it depends on others, and what stands there is no list of criteria. Name "
    "each as ID.number, or those of the same document as criterion 2, criteria 2 and 3, separated by commas and 'and'.",
)

_ID = r"[A-Z]+-[0-9a-z]+"
_CLAUSE = pattern(rf"\(depends on ((?:{_ID}|criteri(?:on|a) \d)[^()]*)\)", re.IGNORECASE)
_PART = pattern(rf"\s*(?:,|\band\b|, and\b)?\s*(?:({_ID}(?:\.\d+)?)|criteri(?:on|a) (\d+)|(\d+))(?=,|\s|$)")


def dependencies_of(text: str, document: str, place: Place, report: Report) -> tuple[str, ...]:
    """The names that the plain ``text`` of a criterion gives, in its order, once each; ``document`` is its own id.

    Names are as written, with aliases, and of a criterion of the same document ``FR-00070.2``; whether there is such a
    criterion is not looked at.
    """
    found: dict[str, None] = {}
    for clause in _CLAUSE.finditer(text):
        names, rest = _names(clause[1], document)
        found.update(dict.fromkeys(names))
        if rest:
            message = f"{rest!r} is no criterion to depend on"
            report.add(CRITERION_DEPENDS, place, message, "write (depends on FR-1.2, FR-1.3 and criterion 4)")
    return tuple(found)


def _names(clause: str, document: str) -> tuple[list[str], str]:
    """The names of a clause, and what is left of it where it is no list any more."""
    names: list[str] = []
    at, is_own = 0, False
    while at < len(clause):
        part = _PART.match(clause, at)
        is_further = part is not None and part[3] is not None
        if part is None or (is_further and not is_own) or (names and not re.match(r"\s*(?:,|and\b)", clause[at:])):
            return names, clause[at:].strip(" ,")
        is_own = part[1] is None
        names.append(part[1] or f"{document}.{part[2] or part[3]}")
        at = part.end()
    return names, ""
