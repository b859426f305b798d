"""Records the blocks of a module that are reached: a copy of it sets a byte for each, in memory of all processes.

It costs a few hundredths of the time of a run; a tracer, such as that of coverage, costs more than the run itself.
What a program sets that a test ends by force is there as well.
"""

import ast
from collections.abc import Sequence

MODULE = "codegen_marks"
"""The module that marked ones import; it lies in the folder above codegen."""
VARIABLE = "CODEGEN_MARKS"
"""The environment variable that names the file of the bytes."""
_NAME = "_marks_of_blocks"
"""The name of the bytes in marked modules: none of them has one like that."""
_NESTED = ast.If | ast.For | ast.While | ast.With | ast.Try | ast.Match
_DEFINED = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef


class Marker:
    """Marks modules one after another; ``blocks`` has by the number of a byte the file and the lines of its block."""

    def __init__(self) -> None:
        self.blocks: list[tuple[str, list[int]]] = []

    def marked(self, file: str, text: str) -> str:
        """Return the text of a module that sets a byte where a block begins, and behind each statement with a body.

        What is run when the module is imported has one byte in all.
        """
        tree = ast.parse(text)
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                node.body = self._block(file, node.body)
        imported = [line for each in _at_import(tree.body) for line in _head(each)]
        tree.body[_first(tree.body) : _first(tree.body)] = [
            *ast.parse(f"from {MODULE} import marks as {_NAME}").body,
            self._mark(file, imported),
        ]
        return ast.unparse(ast.fix_missing_locations(tree))

    def _block(self, file: str, body: Sequence[ast.stmt]) -> list[ast.stmt]:
        first = _first(body)
        made, lines = list(body[:first]), list[int]()
        if first < len(body):
            made.append(self._mark(file, lines))
        for number, each in enumerate(body[first:], first + 1):
            lines += _head(each)
            made.append(each)
            if isinstance(each, _NESTED):
                self._inner(file, each)
                if number < len(body):
                    lines = []
                    made.append(self._mark(file, lines))
        return made

    def _inner(self, file: str, node: ast.stmt) -> None:
        """Mark the blocks of a statement."""
        for part in (node, *getattr(node, "handlers", ()), *getattr(node, "cases", ())):
            for name in ("body", "orelse", "finalbody"):
                if body := getattr(part, name, None):
                    setattr(part, name, self._block(file, body))

    def _mark(self, file: str, lines: list[int]) -> ast.stmt:
        """Return the statement that marks a block, to whose lines more may be added."""
        self.blocks.append((file, lines))
        return ast.parse(f"{_NAME}[{len(self.blocks) - 1}] = 1").body[0]


def module(size: int) -> str:
    """Return the text of the module that marked ones import: the bytes of the file that the environment names."""
    return (
        "import mmap\nimport os\n\n"
        f'if "{VARIABLE}" in os.environ:\n'
        f'    with open(os.environ["{VARIABLE}"], "r+b") as file:\n'
        "        marks = mmap.mmap(file.fileno(), 0)\n"
        f"else:\n    marks = bytearray({size})\n"
    )


def _first(body: Sequence[ast.stmt]) -> int:
    """Return where statements can be put in: behind the docstring, and imports from the future."""
    first = 0
    for number, each in enumerate(body):
        is_docstring = number == 0 and isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
        if not is_docstring and not (isinstance(each, ast.ImportFrom) and each.module == "__future__"):
            break
        first = number + 1
    return first


def _at_import(body: Sequence[ast.stmt]) -> list[ast.stmt]:
    """Return the statements that run when a module is imported."""
    found = list[ast.stmt]()
    for each in body:
        found.append(each)
        if isinstance(each, _NESTED | ast.ClassDef):
            for part in (each, *getattr(each, "handlers", ())):
                for name in ("body", "orelse", "finalbody"):
                    found += _at_import(getattr(part, name, ()))
    return found


def _head(node: ast.stmt) -> range:
    """Return the lines of a statement, of one with a body those above it; a decorator is above its function."""
    if not isinstance(node, _NESTED | _DEFINED):
        return range(node.lineno, (node.end_lineno or node.lineno) + 1)
    parts = (*getattr(node, "cases", ()), node)
    body = parts[0].body
    first = body[0].lineno if body else node.lineno + 1
    return range(node.lineno, max(first, node.lineno + 1))
