"""The imports of a module, and which of them are run whenever it is loaded: by its source, it is never imported."""

import ast
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache

from codegen.frozen import dataclass

_CAUGHT = {"ImportError", "ModuleNotFoundError", "Exception", "BaseException"}
_TYPING = "TYPE_CHECKING"


@dataclass(frozen=True, slots=True)
class Import:
    """``module`` is absolute, with its dots; ``line`` and ``column`` are where it stands, from 1 on.

    ``names`` are what is taken from it, each of which may be a module, too. ``is_sure``: it is run whenever its module
    is, and not only in a call or in a branch.
    """

    module: str
    names: tuple[str, ...]
    line: int
    column: int
    is_sure: bool


def imports_of(text: str, package: str = "") -> list[Import]:
    """Return all imports of a module in a ``package``, wherever they stand; none of a text that Python cannot read."""
    tree = _tree(text)
    return [] if tree is None else [each for node in ast.walk(tree) for each in _imports(node, package, is_sure=False)]


def needed_imports(
    text: str, is_there: Callable[[str], bool], package: str = "", *, is_main: bool = False
) -> list[Import]:
    """Return the imports that a module cannot do without, where ``is_there`` says of a module with dots whether it is.

    That is not those in a branch for another Python, nor what is tried, and what stands for it where it fails, as long
    as one of them is there. ``is_main``: it is the module that the board starts.
    """
    tree = _tree(text)
    return [] if tree is None else list(_Needed(is_there, package, is_main).of(tree.body, is_sure=True))


@lru_cache(maxsize=256)
def _tree(text: str) -> ast.Module | None:
    try:
        return ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):  # MicroPython's compiler says what is wrong with it
        return None


class _Needed:
    """The way through a module."""

    def __init__(self, is_there: Callable[[str], bool], package: str, is_main: bool) -> None:
        self._is_there = is_there
        self._package = package
        self._is_main = is_main

    def of(self, body: Iterable[ast.stmt], *, is_sure: bool) -> Iterator[Import]:
        """Yield what some statements need."""
        for each in body:
            if isinstance(each, ast.Try):
                yield from self._tried(each, is_sure=is_sure)
            elif isinstance(each, ast.If):
                yield from self._branched(each, is_sure=is_sure)
            elif isinstance(each, ast.ClassDef | ast.With):
                yield from self.of(each.body, is_sure=is_sure)
            elif isinstance(
                each, ast.FunctionDef | ast.AsyncFunctionDef | ast.For | ast.AsyncFor | ast.While | ast.AsyncWith
            ):
                yield from self.of([*each.body, *getattr(each, "orelse", [])], is_sure=False)
            else:
                for node in ast.walk(each):
                    yield from _imports(node, self._package, is_sure=is_sure)

    def _tried(self, statement: ast.Try, *, is_sure: bool) -> Iterator[Import]:
        tried = list(self.of(statement.body, is_sure=is_sure))
        caught = [handler for handler in statement.handlers if _catches(handler)]
        missing = [each for each in tried if not self._is_there(each.module)]
        if caught and missing:
            yield from (each for each in tried if each not in missing)
            yield from self.of(caught[0].body, is_sure=is_sure)
        else:
            yield from tried
            yield from self.of(statement.orelse, is_sure=is_sure)
        others = [handler for handler in statement.handlers if handler not in caught]
        yield from self.of([each for handler in others for each in handler.body], is_sure=False)
        yield from self.of(statement.finalbody, is_sure=is_sure)

    def _branched(self, statement: ast.If, *, is_sure: bool) -> Iterator[Import]:
        verdict = self._verdict(statement.test)
        if verdict is None:
            yield from self.of([*statement.body, *statement.orelse], is_sure=False)
        else:
            yield from self.of(statement.body if verdict else statement.orelse, is_sure=is_sure)

    def _verdict(self, test: ast.expr) -> bool | None:
        """Return what a condition is on a board; None where it cannot be known."""
        if isinstance(test, ast.Constant):
            return bool(test.value)
        if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
            verdict = self._verdict(test.operand)
            return None if verdict is None else not verdict
        words = ast.unparse(test)
        if words == _TYPING or words.endswith(f".{_TYPING}"):
            return False
        if isinstance(test, ast.Compare) and len(test.ops) == 1 and isinstance(test.ops[0], ast.Eq | ast.NotEq):
            sides = {ast.unparse(test.left), ast.unparse(test.comparators[0])}
            is_equal = isinstance(test.ops[0], ast.Eq)
            if "__name__" in sides:
                return is_equal == self._is_main if "'__main__'" in sides else None
            if sides & {"sys.implementation.name", "implementation.name"}:
                return is_equal == ("'micropython'" in sides)
        return None


def _catches(handler: ast.ExceptHandler) -> bool:
    """Return whether a handler is run where a module is not there."""
    if handler.type is None:
        return True
    kinds = handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type]
    return any(isinstance(kind, ast.Name) and kind.id in _CAUGHT for kind in kinds)


def _imports(node: ast.AST, package: str, *, is_sure: bool) -> Iterator[Import]:
    """Yield what one node imports: a statement, or a call of __import__ with a text."""
    if isinstance(node, ast.Import):
        for alias in node.names:
            yield Import(alias.name, (), node.lineno, node.col_offset + 1, is_sure)
    elif isinstance(node, ast.ImportFrom):
        above = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
        module = ".".join([*above, *([node.module] if node.module else [])])
        if module:
            yield Import(module, tuple(alias.name for alias in node.names), node.lineno, node.col_offset + 1, is_sure)
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "__import__":
        first = node.args[0] if node.args else None
        if isinstance(first, ast.Constant) and isinstance(first.value, str) and first.value:
            yield Import(first.value, (), node.lineno, node.col_offset + 1, is_sure)
