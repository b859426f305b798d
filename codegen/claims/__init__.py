"""Claims of documents, recomputed: one module for each kind, a pure function from a reading to its findings."""

from collections.abc import Callable, Iterator

from codegen.claims import (
    arithmetic,
    cast,
    declaration,
    identifier,
    layout,
    limit,
    proposed,
    rate,
    sentinel,
    size,
    structure,
    truncation,
)
from codegen.claims.reading import Reading, merged
from codegen.diagnostics import Diagnostic

CLAIMS: tuple[Callable[[Reading], Iterator[Diagnostic]], ...] = (
    arithmetic.check,
    cast.check,
    declaration.check,
    identifier.check,
    layout.check,
    limit.check,
    proposed.check,
    rate.check,
    sentinel.check,
    size.check,
    structure.check,
    truncation.check,
)
"""The checks in the order of their names. To add one, write its module and list it here."""


def check_claims(reading: Reading) -> list[Diagnostic]:
    """What is wrong in a document, in its order; each claim once, with the places that repeat it."""
    return merged(finding for check in CLAIMS for finding in check(reading))
