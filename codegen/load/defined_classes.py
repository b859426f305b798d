"""The classes that a module of Python defines, found in its source: how each is made, and what can be called of it."""

import ast
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from codegen.model.spec.python_class import PythonClass, Signature

_FUNCTION = (ast.FunctionDef, ast.AsyncFunctionDef)
_KEPT = ("native", "viper")
"""Decorators of MicroPython under which a function takes the same arguments."""


def defined_classes(tree: ast.Module) -> Mapping[str, PythonClass]:
    """Return by name those whose every detail stands at the outermost level of the module, and nowhere else."""
    found: dict[str, PythonClass] = {}
    bound = Counter(_bound(tree.body))
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and bound[node.name] == 1:
            found[node.name] = _class(node, found)
    return found


def _bound(body: Iterable[ast.stmt]) -> Iterator[str]:
    """Yield each name as often as the module binds it."""
    for statement in body:
        if isinstance(statement, (*_FUNCTION, ast.ClassDef)):
            yield statement.name
            continue
        for node in ast.walk(statement):
            match node:
                case ast.Name(ctx=ast.Store() | ast.Del()):
                    yield node.id
                case ast.ClassDef() | ast.FunctionDef() | ast.AsyncFunctionDef():
                    yield node.name
                case ast.alias():
                    yield node.asname or node.name.partition(".")[0]
                case ast.Attribute(value=ast.Name(id=name), ctx=ast.Store()):
                    yield from (name, name)  # a class that is changed from outside


def _class(node: ast.ClassDef, known: Mapping[str, PythonClass]) -> PythonClass:
    methods: dict[str, Signature | None] = {}
    attributes: set[str] = set()
    lengths: dict[str, int] = {}
    is_open = bool(node.keywords or node.decorator_list)
    for base in reversed(node.bases):
        own = known.get(base.id) if isinstance(base, ast.Name) else None
        if own is not None:
            methods |= own.methods
            attributes |= own.attributes
            lengths |= own.lengths
        is_open = is_open or (own.is_open if own else not (isinstance(base, ast.Name) and base.id == "object"))
    for statement in node.body:
        if isinstance(statement, _FUNCTION):
            methods[statement.name] = _signature(statement)
            attributes.add(statement.name)
        else:
            for each in ast.walk(statement):
                names = _names(each)
                methods |= dict.fromkeys(names)  # it may be called, however
                attributes.update(names)
        taken = set(_of_objects(statement))
        methods |= dict.fromkeys(taken)
        attributes |= taken
    opening = {"__new__", "__getattr__", "__getattribute__"} & attributes
    used = {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
    used |= {each.attr for each in ast.walk(node) if isinstance(each, ast.Attribute)}
    is_open = is_open or bool(opening) or bool(used & {"setattr", "__dict__", "exec", "locals"})
    made = Counter(_changed(node))
    lengths = {name: length for name, length in lengths.items() if not made[name]}
    lengths |= {name: length for name, length in _lengths(node) if made[name] == 1}
    return PythonClass(node.lineno, methods, frozenset(attributes), is_open, lengths)


def _changed(node: ast.ClassDef) -> Iterator[str]:
    """Yield each attribute as often as it is stored, and that of which a method is called, which may add to it."""
    for each in ast.walk(node):
        match each:
            case ast.Attribute(attr=name, ctx=ast.Store() | ast.Del()):
                yield name
            case ast.Call(func=ast.Attribute(value=ast.Attribute(attr=name))):
                yield from (name, name)


def _lengths(node: ast.ClassDef) -> Iterator[tuple[str, int]]:
    """Yield the attributes of objects that are made as an array or a list of a length that stands there."""
    for each in ast.walk(node):
        match each:
            case ast.Assign(targets=[ast.Attribute(value=ast.Name(id="self"), attr=name)], value=value):
                length = _length(value)
                if length is not None:
                    yield name, length


def _length(value: ast.expr) -> int | None:
    """Return how many elements an expression has, where it shows that."""
    match value:
        case ast.Call(func=ast.Name(id="array") | ast.Attribute(attr="array"), args=[_, inner], keywords=[]):
            return _length(inner)
        case ast.List(elts=elements) | ast.Tuple(elts=elements):
            return None if any(isinstance(each, ast.Starred) for each in elements) else len(elements)
        case (
            ast.BinOp(left=inner, op=ast.Mult(), right=ast.Constant(value=int(times)))
            | ast.BinOp(left=ast.Constant(value=int(times)), op=ast.Mult(), right=inner)
        ):
            length = _length(inner)
            return None if length is None else length * times
    return None


def _names(node: ast.AST) -> tuple[str, ...]:
    """The names that a node binds in the body of a class."""
    match node:
        case ast.Name(ctx=ast.Store()):
            return (node.id,)
        case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
            return (node.name,)
        case ast.alias():
            return (node.asname or node.name,)
    return ()


def _of_objects(statement: ast.stmt) -> Iterator[str]:
    """Yield the attributes that a function in the body of a class stores into any object: its own is the first."""
    if isinstance(statement, _FUNCTION):
        for node in ast.walk(statement):
            if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
                yield node.attr


def _signature(node: ast.FunctionDef | ast.AsyncFunctionDef) -> Signature | None:
    """Return what a method takes; None where a decorator may change that."""
    if any(not (isinstance(each, ast.Attribute) and each.attr in _KEPT) for each in node.decorator_list):
        return None
    given = node.args
    places = [each.arg for each in (*given.posonlyargs, *given.args)]
    only = [each.arg for each in given.posonlyargs]
    if not places and given.vararg is None:
        return None  # not even the object
    without = len(places) - len(given.defaults)
    required = [name for at, name in enumerate(places) if 0 < at < without]
    required += [each.arg for each, default in zip(given.kwonlyargs, given.kw_defaults, strict=True) if default is None]
    keyed = frozenset((*places[1:], *(each.arg for each in given.kwonlyargs))) - set(only)
    return Signature(tuple(places[1:]), keyed, tuple(required), given.vararg is not None, given.kwarg is not None)
