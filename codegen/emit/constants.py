"""Private tuples, texts and numbers that never change become constants where modules are compiled.

MicroPython puts a constant where it is used: a private one has no place among the names of its module, and is not
looked up there.
"""

import ast
from collections.abc import Collection, Iterable, Iterator, Mapping
from io import StringIO

from codegen.emit.private_names import Module, bound_by, constant_of, private_names, read_module


def with_constants(texts: Mapping[str, str], others: Iterable[str]) -> dict[str, str]:
    """Return modules, by their names, with constants; ``others`` are the texts of the program's other modules."""
    modules = {name: read_module(text) for name, text in texts.items()}
    elsewhere = {name for module in modules.values() for name in _asked_of_modules(module)}
    names = private_names(modules, others).keys() - elsewhere
    return {name: _written(text, modules[name], names) for name, text in texts.items()}


def _written(text: str, module: Module, names: Collection[str]) -> str:
    if module.names & {"native", "viper"}:  # machine code has its own ways with objects
        return text
    lines = list(StringIO(text))
    known: set[str] = set()
    for node in module.tree.body:
        name = _name_of(node)
        if constant_of(node) is not None:
            known.add(name)
        elif name in names and _is_told_whole(node, known) and _is_set_once(name, node, module):
            first, last = node.lineno - 1, (node.end_lineno or node.lineno) - 1
            lines[last] = f"{lines[last].encode()[: node.end_col_offset].decode()})\n"
            lines[first] = lines[first].replace(" = ", " = const(", 1)
            known.add(name)
    return "".join(lines)


def _asked_of_modules(module: Module) -> Iterator[str]:
    """Yield the names that a module may ask another one for."""
    for node in module.nodes:
        if isinstance(node, ast.Attribute):
            yield node.attr
        elif isinstance(node, ast.alias):
            yield node.name


def _name_of(node: ast.stmt) -> str:
    """Return the name that a statement gives to a value, "" for every other statement."""
    target = node.targets[0] if isinstance(node, ast.Assign) and len(node.targets) == 1 else None
    return target.id if isinstance(target, ast.Name) else ""


def _is_told_whole(node: ast.stmt, known: Collection[str]) -> bool:
    """Return whether the compiler can tell the value of an assignment, which has parentheses if it is a tuple."""
    value = node.value if isinstance(node, ast.Assign) else None
    if isinstance(value, ast.Tuple) and value.elts:
        first = value.elts[0]
        return (value.lineno, value.col_offset) < (first.lineno, first.col_offset) and _is_told(value, known)
    return isinstance(value, ast.Constant) and value.value is not None and _is_told(value, known)


def _is_told(value: ast.expr, known: Collection[str]) -> bool:
    if isinstance(value, ast.Tuple):
        return bool(value.elts) and all(_is_told(each, known) for each in value.elts)
    if isinstance(value, ast.UnaryOp):
        return isinstance(value.op, ast.USub) and isinstance(value.operand, ast.Constant)
    if isinstance(value, ast.Name):
        return value.id in known
    return isinstance(value, ast.Constant) and type(value.value) in (int, str, bytes, type(None))


def _is_set_once(name: str, node: ast.stmt, module: Module) -> bool:
    """Return whether nothing else gives a value to a name, and whether it is used behind its assignment only."""
    times = sum(each == name for other in module.nodes for each in bound_by(other))
    uses = [other for other in module.nodes if isinstance(other, ast.Name) and other.id == name]
    return times == 1 and all(
        other.lineno > (node.end_lineno or 0) for other in uses if isinstance(other.ctx, ast.Load)
    )
