"""The modules of a program: those that are always loaded together, and names that they ask each other for."""

import ast
from collections.abc import Iterable, Iterator, Mapping

from codegen.emit.global_names import bound_at_top, outside_functions, seen_in
from codegen.emit.private_names import Module, read_module, sources_of, words
from codegen.frozen import dataclass

_ITS_OWN = frozenset({"globals", "locals", "exec", "eval", "__file__", "__name__"})
"""Names by which modules look at themselves: in a bundle they would be those of the bundle."""


@dataclass(frozen=True, slots=True)
class Program:
    """The modules of a program by their names, and those of others that can be read.

    ``loaded`` are those that become parts of bundles, in the order in which they are loaded, ``alone`` what stays as it
    is. ``asked`` has the names that modules are asked for as attributes, "*" for any, ``fixed`` those of them that are
    looked for at run time under these names. ``named`` are the words of all other modules.
    """

    modules: Mapping[str, Module]
    others: tuple[Module, ...]
    loaded: tuple[str, ...]
    alone: frozenset[str]
    asked: Mapping[str, frozenset[str]]
    fixed: Mapping[str, frozenset[str]]
    named: frozenset[str]


def read_program(texts: Mapping[str, str], started: str, others: Iterable[str]) -> Program:
    """Return a program of the texts of its modules."""
    modules = {name: read_module(text) for name, text in texts.items()}
    others = list(others)
    readable = tuple(filter(None, (_readable(text) for text in others)))
    loaded = _loaded(modules, read_module(started))
    alone = _alone(modules, readable)
    asked: dict[str, set[str]] = {}
    fixed: dict[str, set[str]] = {}
    for name, module in (*modules.items(), ("", read_module(started))):
        at_top = modules_asked_by(module) if name in loaded and name not in alone else {}
        for alias, source, attribute in _attributes(module):
            asked.setdefault(source, set()).add(attribute)
            if at_top.get(alias) not in loaded or source in alone or attribute == "*":
                fixed.setdefault(source, set()).add(attribute)
    named = frozenset(word for text in others for word in words(text))
    return Program(modules, readable, tuple(loaded), frozenset(alone), _frozen(asked), _frozen(fixed), named)


def _frozen(found: Mapping[str, set[str]]) -> dict[str, frozenset[str]]:
    return {name: frozenset(each) for name, each in found.items()}


def modules_asked_by(module: Module) -> dict[str, str]:
    """Return the modules that a module asks for attributes and does nothing else with, by what it calls them."""
    at_top = [each for node in module.tree.body if isinstance(node, ast.Import) for each in node.names]
    found = {each.asname or each.name: each.name for each in at_top}
    seen = seen_in(module.tree)
    # What it asks for stands beside it later: a function must have nothing of that name.
    whole = {name for name, _, attribute in _attributes(module) if attribute == "*" or attribute in seen.own}
    return {name: source for name, source in found.items() if name not in seen.own | whole}


def _readable(text: str) -> Module | None:
    try:
        return read_module(text)
    except SyntaxError:
        return None


def _attributes(module: Module) -> Iterator[tuple[str, str, str]]:
    """Yield what a module calls others, these, and the names that it asks them for, "*" where it may be any."""
    of = {name: source for name, (source, original) in module.imports.items() if not original}
    asked = {id(node.value) for node in module.nodes if isinstance(node, ast.Attribute)}
    for node in module.nodes:
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in of:
            yield node.value.id, of[node.value.id], node.attr
        elif isinstance(node, ast.Name) and node.id in of and id(node) not in asked:
            yield node.id, of[node.id], "*"


def _loaded(modules: Mapping[str, Module], started: Module) -> list[str]:
    """Return what is loaded whenever the program is, in its order, and what may be with it."""
    found: dict[str, None] = {}

    def load(name: str) -> None:
        if name in modules and name not in begun:
            begun.add(name)
            for node in outside_functions(modules[name].tree.body):
                for source in sources_of(node):
                    load(source)
            found[name] = None

    begun = set[str]()
    for node in started.nodes:
        for source in sources_of(node):
            load(source)
    return list(found)


def _perhaps(module: Module) -> Iterator[str]:
    """Yield what a module imports under a condition: where it is refused, there is another one."""
    always = set(module.tree.body)
    for node in outside_functions(module.tree.body):
        if node not in always:
            yield from sources_of(node)


def _alone(modules: Mapping[str, Module], others: Iterable[Module]) -> set[str]:
    """Return the modules that stay as they are."""
    found = {name for name, module in modules.items() if _is_alone(module)}
    for module in (*modules.values(), *others):
        of = {name: source for name, (source, original) in module.imports.items() if not original}
        for node in module.nodes:
            if isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Load):
                found.update(of[each.id] for each in (node.value,) if isinstance(each, ast.Name) and each.id in of)
        found.update(source for source, original in module.imports.values() if original == "*")
        found.update(_perhaps(module))
    return found


def _is_alone(module: Module) -> bool:
    looks_at_itself = any(isinstance(node, ast.Name) and node.id in _ITS_OWN for node in module.nodes)
    has_machine_code = not module.names.isdisjoint({"native", "viper"})
    is_dotted = any("." in source for source, _ in module.imports.values())
    is_conditional = any(True for _ in _perhaps(module))
    if looks_at_itself or has_machine_code or is_dotted or is_conditional or "*" in module.imports:
        return True
    declared = {name for node in module.nodes if isinstance(node, ast.Global) for name in node.names}
    if any(name[0] != "_" for name in declared) or any(name[:2] == "__" for name in bound_at_top(module.tree)):
        return True
    try:
        module.written  # noqa: B018  which may not be possible
    except ValueError:  # an f-string that this Python cannot write
        return True
    return False
