"""Small faults that can be put into a Python module, one at a time: a mutant is what the tests should notice."""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass

COMPARED = {
    ast.Lt: ("<", "<="),
    ast.LtE: ("<=", "<"),
    ast.Gt: (">", ">="),
    ast.GtE: (">=", ">"),
    ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="),
    ast.Is: ("is", "is not"),
    ast.IsNot: ("is not", "is"),
    ast.In: ("in", "not in"),
    ast.NotIn: ("not in", "in"),
}
COMPUTED = {
    ast.Add: ("+", "-"),
    ast.Sub: ("-", "+"),
    ast.Mult: ("*", "//"),
    ast.FloorDiv: ("//", "*"),
    ast.Div: ("/", "*"),
    ast.Mod: ("%", "+"),
    ast.LShift: ("<<", ">>"),
    ast.RShift: (">>", "<<"),
    ast.BitAnd: ("&", "|"),
    ast.BitOr: ("|", "&"),
    ast.BitXor: ("^", "&"),
}


@dataclass(frozen=True)
class Mutant:
    """The text from ``start`` to ``end`` of a file (in characters) becomes ``new``; ``line`` is where it begins."""

    file: str
    line: int
    start: int
    end: int
    old: str
    new: str

    def applied(self, text: str) -> str:
        """The text of the file with the fault in it."""
        assert text[self.start : self.end] == self.old
        return text[: self.start] + self.new + text[self.end :]

    def line_in(self, text: str) -> str:
        """The line of the file in which the fault begins, without what is only space at its ends."""
        return text.splitlines()[self.line - 1].strip()

    def shown(self, text: str) -> str:
        """The line with the fault, for people."""
        return f"{self.file}:{self.line}: {self.line_in(text)}   [{self.old.splitlines()[0]} -> {self.new}]"


def mutants_of(file: str, text: str) -> list[Mutant]:
    """All of a module, in the order of its text; none in annotations, decorators, defaults of types, or docstrings.

    Neither are what only type checkers see, and whether ``zip`` checks lengths that are the same. A function that says
    ``-> bool`` does not return None in place of False: type checkers see that, and who asks ``if`` does not. Neither
    does one of the module's own, with a name that begins with "_", that nobody asks for more than whether it is true.
    """
    tree = ast.parse(text)
    maker = _Maker(file, text, _asked_for_truth(tree))
    maker.visit(tree)
    return sorted(set(maker.found), key=lambda each: (each.start, each.new))


def _asked_for_truth(tree: ast.Module) -> frozenset[str]:
    """Return the names that begin with "_" and that are only ever called where nothing but truth is asked for."""
    asked = {id(call.func) for node in ast.walk(tree) for test in _tests(node) for call in _judged(test)}
    named: dict[str, bool] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Name | ast.Attribute):
            name = node.id if isinstance(node, ast.Name) else node.attr
            named[name] = named.get(name, True) and id(node) in asked
    return frozenset(name for name, is_asked in named.items() if is_asked and name.startswith("_"))


def _tests(node: ast.AST) -> list[ast.expr]:
    """Return the parts of a node that it only asks whether they are true."""
    if isinstance(node, ast.If | ast.While | ast.IfExp | ast.Assert):
        return [node.test]
    if isinstance(node, ast.comprehension):
        return node.ifs
    return [node.operand] if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not) else []


def _judged(test: ast.expr) -> Iterator[ast.Call]:
    """Yield the calls whose truth is that of an expression, or a part of it."""
    if isinstance(test, ast.Call):
        yield test
    elif isinstance(test, ast.BoolOp):
        for each in test.values:
            yield from _judged(each)
    elif isinstance(test, ast.IfExp):
        yield from _judged(test.body)
        yield from _judged(test.orelse)


class _Maker(ast.NodeVisitor):
    def __init__(self, file: str, text: str, predicates: frozenset[str]) -> None:
        self.found: list[Mutant] = []
        self._predicates = predicates
        self._file = file
        self._text = text
        self._lines = text.splitlines(keepends=True)
        self._is_predicate = False
        self._starts = [0]
        for line in self._lines:
            self._starts.append(self._starts[-1] + len(line))

    def _at(self, line: int, column: int) -> int:
        """The offset in characters; ast counts columns in bytes of UTF-8."""
        return self._starts[line - 1] + len(self._lines[line - 1].encode()[:column].decode())

    def _span(self, node: ast.AST) -> tuple[int, int]:
        return self._at(node.lineno, node.col_offset), self._at(node.end_lineno, node.end_col_offset)  # type: ignore[attr-defined]

    def _put(self, start: int, end: int, new: str) -> None:
        line = self._text.count("\n", 0, start) + 1
        self.found.append(Mutant(self._file, line, start, end, self._text[start:end], new))

    def _operator(self, left: ast.AST, right: ast.AST, old: str, new: str) -> None:
        """Replace the operator between two operands; parentheses may lie between, comments do not."""
        start, end = self._span(left)[1], self._span(right)[0]
        pattern = r"\b" + old.replace(" ", r"\s+") + r"\b" if old[0].isalpha() else re.escape(old)
        match = re.search(pattern, self._text[start:end])
        if match is not None:
            self._put(start + match.start(), start + match.end(), new)

    def visit_Compare(self, node: ast.Compare) -> None:
        operands = [node.left, *node.comparators]
        for left, operator, right in zip(operands, node.ops, operands[1:], strict=False):
            self._operator(left, right, *COMPARED[type(operator)])
        self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> None:
        is_text = any(
            isinstance(each, ast.Constant) and isinstance(each.value, str) for each in (node.left, node.right)
        )
        if type(node.op) in COMPUTED and not is_text:
            self._operator(node.left, node.right, *COMPUTED[type(node.op)])
        self.generic_visit(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> None:
        old, new = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
        for left, right in zip(node.values, node.values[1:], strict=False):
            self._operator(left, right, old, new)
        self.generic_visit(node)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> None:
        start, end = self._span(node)
        sign = re.match(r"not\s+|-", self._text[start:end])
        if sign is not None:
            self._put(start, start + sign.end(), "")
        self.generic_visit(node)

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        swapped = {ast.Add: ("+=", "-="), ast.Sub: ("-=", "+=")}.get(type(node.op))
        if swapped is not None:
            self._operator(node.target, node.value, *swapped)
        self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        if isinstance(node.value, bool):
            self._put(*self._span(node), str(not node.value))
        elif isinstance(node.value, int):
            self._put(*self._span(node), str(node.value + 1))

    def visit_Return(self, node: ast.Return) -> None:
        value = node.value.value if isinstance(node.value, ast.Constant) else node.value
        if value is not None and not (value is False and self._is_predicate):
            assert node.value is not None
            self._put(*self._span(node.value), "None")
        self.generic_visit(node)

    def visit_If(self, node: ast.If) -> None:
        if isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            return
        start, end = self._span(node.test)
        self._put(start, end, f"not ({' '.join(self._text[start:end].split())})")
        self.generic_visit(node)

    def visit_Expr(self, node: ast.Expr) -> None:
        if isinstance(node.value, ast.Call):
            self._put(*self._span(node), "pass")
        if not isinstance(node.value, ast.Constant):  # a docstring
            self.generic_visit(node)

    def visit_Assign(self, node: ast.Assign) -> None:
        target = node.targets[0]
        if isinstance(target, ast.Attribute | ast.Subscript):
            self._put(*self._span(node), "pass")
        self.generic_visit(node)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value is not None:
            self.visit(node.value)

    def visit_keyword(self, node: ast.keyword) -> None:
        if node.arg != "strict":
            self.visit(node.value)

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        for each in node.body:
            self.visit(each)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        says_bool = isinstance(node.returns, ast.Name) and node.returns.id == "bool"
        outer, self._is_predicate = self._is_predicate, says_bool or node.name in self._predicates
        for each in [*node.args.defaults, *filter(None, node.args.kw_defaults), *node.body]:
            self.visit(each)
        self._is_predicate = outer
