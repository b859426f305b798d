"""Makes one module of several, and leaves what others find in those: they may be imported as before."""

import ast
import builtins
from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping
from functools import lru_cache
from itertools import chain, count

from codegen.emit.bundles import Bundle, bundles_of, fixed_names, numbers_of
from codegen.emit.global_names import FUNCTIONS, GlobalNames, bound_at_top, seen_in, tree_of
from codegen.emit.private_names import Module, constant_of
from codegen.emit.program import Program, modules_asked_by, read_program
from codegen.emit.redirected import Places, Redirection, import_of, redirected
from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Bundled:
    """The texts of modules by their names, that of main.py, and what short names stand for, by modules."""

    texts: Mapping[str, str]
    started: str
    names: Mapping[str, Mapping[str, str]]


def bundled(
    texts: Mapping[str, str], started: str, names: Mapping[str, Mapping[str, str]], others: Iterable[str]
) -> Bundled:
    """Return a program with bundles in place of modules that are always loaded together.

    ``names`` are what short names stand for in modules, ``others`` the texts of the program's other modules. In place
    of a module that is part of a bundle there is one that imports from there what has a name for others.
    """
    others = list(others)
    program = read_program(texts, started, others)
    bundles = bundles_of(program)
    inside = {module: bundle.name for bundle in bundles for module in bundle.modules}
    places = Places(inside, {}, {name: numbers_of(program, name) for name in inside})
    heads = dict[str, list[ast.stmt]]()
    for bundle in bundles:  # each imports from those before it
        naming = _Naming(program, bundle, places)
        heads |= {name: list(naming.head(name)) for name in bundle.modules}
        places = Places(inside, {**places.names, **naming.names}, places.numbers)
    made, found = dict(texts), dict(names)
    for bundle in bundles:
        tree = ast.Module(
            [each for name in bundle.modules for each in (*heads[name], *_body(program, name, places))], []
        )
        made[bundle.name] = f"{ast.unparse(ast.fix_missing_locations(tree))}\n"
        found[bundle.name] = _stands_for(bundle, places, names, program)
    for name, text in texts.items():
        made[name] = (
            _left(program.modules[name], name, places, program.named) if name in inside else redirected(text, places)
        )
        if name in inside:
            found.pop(name, None)
    return Bundled(made, redirected(started, places), found)


class _Naming:
    """Finds names for what is at the top level of a bundle, ``names`` by its modules, and what it imports."""

    def __init__(self, program: Program, bundle: Bundle, places: Places) -> None:
        self.names: dict[str, dict[str, str]] = {}
        self._program, self._bundle, self._places = program, bundle, places
        self._imported: dict[tuple[str, str], str] = {}
        self._own: dict[str, frozenset[str]] = {}
        self._taken = {"const", "micropython", "native", "viper", *dir(builtins)}
        for name in bundle.modules:
            tree = program.modules[name].tree
            seen = seen_in(tree)
            self._own[name] = seen.own
            self._taken |= seen.own | (seen.used - bound_at_top(tree)) | fixed_names(program, name)
        nodes = [node for name in bundle.modules for node in program.modules[name].nodes]
        functions = (node.name for node in nodes if isinstance(node, FUNCTIONS) and not isinstance(node, ast.Lambda))
        self._taken |= {name for name in functions if name[0] != "_"}
        asked = Counter(node.attr for node in nodes if isinstance(node, ast.Attribute))
        self._spare = chain((name for name, _ in asked.most_common()), (f"_{number}" for number in count()))

    def head(self, module: str) -> Iterator[ast.stmt]:
        """Yield what stands in place of a module's imports; afterwards its names are known."""
        tree = self._program.modules[module].tree
        names = self.names[module] = {}
        beside = modules_asked_by(self._program.modules[module])
        for node in tree.body:
            if isinstance(node, (ast.Import, ast.ImportFrom)):
                yield from self._imports(node, names, beside, self._own[module])
        fixed, numbers = fixed_names(self._program, module), self._places.numbers[module]
        constants = {constant_of(node) for node in tree.body}
        for name in sorted(bound_at_top(tree) - names.keys() - beside.keys()):
            if name in numbers:
                names[name] = _number(module, name)
                yield _constant(names[name], numbers[name])
            elif name in constants and name[0] == "_":
                names[name] = f"{name}_{module}"  # there is no such name where it is compiled
            else:
                names[name] = name if name in fixed else self._new()

    def _imports(
        self, node: ast.Import | ast.ImportFrom, names: dict[str, str], beside: Container[str], own: Container[str]
    ) -> Iterator[ast.stmt]:
        for each in node.names:
            source, wanted = (each.name, "") if isinstance(node, ast.Import) else (node.module or "", each.name)
            name = each.asname or each.name
            if wanted in self._places.numbers.get(source, {}):
                names[name] = _number(source, wanted)
                if source not in self._bundle.modules and (source, wanted) not in self._imported:
                    self._imported[source, wanted] = names[name]
                    yield _constant(names[name], self._places.numbers[source][wanted])
                continue
            if source in self._bundle.modules and wanted:
                names[name] = self.names[source][wanted]
                if names[name] in own:  # a function has something else of that name
                    called, names[name] = names[name], self._new()
                    yield from ast.parse(f"{names[name]} = {called}").body
                continue
            if source in self._bundle.modules and name in beside:
                continue  # what it asks that module for is at hand
            if source in self._places.bundles:
                wanted = self._places.names[source][wanted] if wanted else ""
                source = self._places.bundles[source]
            if (source, wanted) not in self._imported:
                self._imported[source, wanted] = self._free(wanted or name)
                yield import_of(source, wanted, self._imported[source, wanted])
            names[name] = self._imported[source, wanted]

    def _free(self, name: str) -> str:
        if name in self._taken:
            return self._new()
        self._taken.add(name)
        return name

    def _new(self) -> str:
        name = next(each for each in self._spare if each not in self._taken)
        self._taken.add(name)
        return name


def _number(module: str, name: str) -> str:
    return f"_public_{name}_{module}"


def _constant(name: str, value: str) -> ast.stmt:
    return ast.parse(f"{name} = const({value})").body[0]


def _body(program: Program, name: str, places: Places) -> Iterator[ast.stmt]:
    """Yield the statements of a module but its imports, with the names that they have in a bundle."""
    asked = modules_asked_by(program.modules[name])
    attributes = {each: places.names[source] for each, source in asked.items() if source in places.bundles}
    beside = {each for each, source in asked.items() if places.bundles.get(source) == places.bundles[name]}
    change, redirection = GlobalNames(places.names[name], attributes, beside), Redirection(places)
    for node in tree_of(program.modules[name]).body:
        is_import = isinstance(node, (ast.Import, ast.ImportFrom))
        is_text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        target = node.targets[0] if isinstance(node, ast.Assign) else None
        is_number = isinstance(target, ast.Name) and target.id in places.numbers[name]
        if not (is_import or is_text or is_number):
            yield redirection.visit(change.visit(node))


def _stands_for(
    bundle: Bundle, places: Places, names: Mapping[str, Mapping[str, str]], program: Program
) -> dict[str, str]:
    """Return what short names stand for in a bundle: in each of its modules something else."""
    found = dict[str, list[str]]()
    for name in bundle.modules:
        before, module = names.get(name, {}), program.modules[name]
        own = {
            each: new
            for each, new in places.names[name].items()
            if each not in module.imports.keys() | places.numbers[name]
        }
        attributes = {node.attr for node in module.nodes if isinstance(node, ast.Attribute)}
        for each, new in own.items():
            if (new != each or _is_short(new)) and not _is_constant(module, each):
                found.setdefault(new, []).append(f"{name}.{before.get(each, each)}")
        for short, each in before.items():
            if short not in own or short in attributes:
                found.setdefault(short, []).append(f"{name}.{each}")
    return {short: "|".join(sorted(set(each))) for short, each in sorted(found.items())}


def _left(module: Module, name: str, places: Places, asked: Container[str]) -> str:
    """Return the text of what a module leaves: imports of what it made, and of what it imported and others ask for."""
    statements = list[ast.stmt]()
    for each, new in places.names[name].items():
        source, original = module.imports.get(each, (name, each))
        if each in asked if each in module.imports else not (_is_short(each) or _is_constant(module, each)):
            if original in places.numbers.get(source, {}):
                statements += ast.parse(f"{each} = {places.numbers[source][original]}").body
            else:
                statements.append(import_of(places.bundles[name], new, each))
    return "".join(f"{ast.unparse(each)}\n" for each in statements)


def _is_constant(module: Module, name: str) -> bool:
    """Return whether a name is one that only the compiler knows."""
    return name[0] == "_" and name in _constants(module.tree)


@lru_cache(maxsize=256)
def _constants(tree: ast.Module) -> frozenset[str | None]:
    """Return the names of the constants of a module."""
    return frozenset(map(constant_of, tree.body))


def _is_short(name: str) -> bool:
    return name[0] == "_" and name[1:].isdigit()
