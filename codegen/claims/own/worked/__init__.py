"""Worked examples, recomputed from the specification and from the numbers beside each other.

Each module here with a function ``check`` knows one kind of them: a pure function from the examples of a document to
findings. A number is judged only where its row or its sentence says what it is of; all others are left alone, and
``codegen.claims.own.worked.listing`` finds out which these are.
"""

from collections.abc import Iterator

from codegen.claims.own.worked.examples import read_examples
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic
from codegen.rules.checks import checks_in


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every worked example of a document."""
    examples = read_examples(reading)
    if examples.tables or examples.texts:
        for each in checks_in(__name__):
            yield from each(examples)
