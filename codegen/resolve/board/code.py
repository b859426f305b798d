"""Looks at the Python that a description of a board has, which goes into the firmware as it is written."""

import ast
import builtins
from collections.abc import Iterator

_KNOWN = frozenset(("machine", *dir(builtins)))
"""The names that the code finds: generated modules import machine before it."""


def faults_in(
    statements: tuple[str, ...], placeholder: str, *, is_expression: bool = False
) -> Iterator[tuple[str, str]]:
    """Yield what is wrong with each of ``statements``, of which a name that an earlier one gives is known.

    Pairs of the statement, and what it is or has, for a message. ``placeholder`` stands for a number: ``{gpio}``.
    """
    known = set(_KNOWN)
    for code in statements:
        try:
            tree = ast.parse(code.replace(placeholder, "1"), mode="eval" if is_expression else "exec")
        except (SyntaxError, ValueError) as fault:  # a ValueError where it has a NUL
            reason = fault.msg if isinstance(fault, SyntaxError) else fault
            yield code, f"is no {'expression' if is_expression else 'statement'} of Python: {reason}"
            continue
        known |= _given(tree)
        for name in dict.fromkeys(_used(tree)):
            if name not in known:
                yield code, f"has the name {name}, which nothing gives; known are machine and {placeholder}"


def _used(tree: ast.AST) -> Iterator[str]:
    return (each.id for each in ast.walk(tree) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load))


def _given(tree: ast.AST) -> set[str]:
    """The names that code assigns, imports, defines or takes as arguments."""
    given = {each.id for each in ast.walk(tree) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)}
    for each in ast.walk(tree):
        if isinstance(each, ast.Import | ast.ImportFrom):
            given |= {alias.asname or alias.name.partition(".")[0] for alias in each.names}
        elif isinstance(each, ast.arg):
            given.add(each.arg)
        elif isinstance(each, ast.FunctionDef | ast.ClassDef):
            given.add(each.name)
    return given
