"""Dependencies point one way, and only the command line talks to the terminal."""

import ast
import importlib
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path

import pytest

import codegen
from codegen.answers import KINDS
from codegen.answers.kind import KindOfAnswer

PACKAGE = Path(codegen.__file__).parent

GROUND = {"conflict", "frozen", "once", "pattern", "source", "diagnostics"}
READING = {"load", "decode", "resolve", "rules"}

MAY_IMPORT: dict[str, set[str]] = {
    "frozen": set(),
    "once": set(),
    "pattern": {"tool"},
    "conflict": {"pattern"},
    "source": {"frozen"},
    "diagnostics": {"frozen", "source"},
    "model": {"frozen", "once", "source"},
    "tool": set(),
    "loop": {"model", *GROUND},
    "memory": {"model", *GROUND},
    "measure": {"model", *GROUND},
    "findings": {"tool", "model", *GROUND},
    "answers": {"measure", "model", *GROUND},
    "derivations": {"measure", "model", *GROUND},
    "sources": {"measure", "model", *GROUND},
    "load": {"model", *GROUND},
    "decode": {"load", "sources", "tool", "model", *GROUND},
    "resolve": {"answers", "derivations", "sources", "measure", "model", *GROUND},
    "rules": {"findings", "loop", "measure", "memory", "model", *GROUND},
    "summaries": {"model", *GROUND},
    "render": {"tool"},
    "emit": {"tool", *GROUND},
    "project": {"findings", *READING, "tool", "model", *GROUND},
    "targets": {"loop", "memory", "summaries", "render", "resolve", "sources", "derivations", "tool", "model", *GROUND},
    "deploy": {"emit", "load", "memory", "tool", "model", *GROUND},
    "sim": {"loop", "render", "model", *GROUND},
    "exchanged": {*READING, "model", *GROUND},
    "importing": {"load", "decode", "measure", "resolve", "model", *GROUND},
    "claims": {"findings", *READING, "model", *GROUND},
    "trace": {"findings", "summaries", "targets", "render", "model", *GROUND},
    "explain": {"findings", "load", "loop", "memory", "summaries", "targets", "model", *GROUND},
    "diff": {"findings", "loop", "project", "summaries", "trace", "render", *READING, "model", *GROUND},
    "commands": {
        "claims",
        "deploy",
        "diff",
        "emit",
        "exchanged",
        "explain",
        "findings",
        "importing",
        "project",
        "sim",
        "targets",
        "tool",
        "trace",
        *READING,
        "model",
        *GROUND,
    },
    "cli": {
        "commands",
        "claims",
        "deploy",
        "diff",
        "emit",
        "exchanged",
        "explain",
        "findings",
        "importing",
        "project",
        "sim",
        "targets",
        "tool",
        "trace",
        *READING,
        "model",
        *GROUND,
    },
    "pytest_plugin": {"project", "model"},
    "__main__": {"cli"},
}
"""Part of the package (a folder or a module of its own) -> the other parts that it may import."""

KNOW_KINDS = {
    "resolve.population.population": {"answers", "answers.kind", "answers.pages", "answers.scope"},
    "resolve.scope": {"answers.scope"},
    "resolve.receptions.taken_field": {"answers.fitting"},
    "resolve.receptions.taken_range": {"answers.halves", "answers.limits"},
}
"""The imports from ``answers`` outside of it: the stages ask ``model.answer.Answer`` and know no kind."""

VAGUE = {"util", "utils", "helper", "helpers", "manager", "managers", "core", "common", "misc", "base"}

ON_THE_BOARD = {"firmware", "mocks", "tests"}
"""Folders of kinds of sensors with MicroPython, which is no part of codegen."""

MODULES = sorted(
    path
    for path in PACKAGE.rglob("*.py")
    if path.parent.name not in ON_THE_BOARD or not path.is_relative_to(PACKAGE / "sources")
)

parsed = cache(ast.parse)
"""Several tests look at each module."""


def name_of(path: Path) -> str:
    """The dotted name of a module below the package, without the package: ``emit.plan``."""
    return ".".join(path.relative_to(PACKAGE).with_suffix("").parts).removesuffix("__init__").rstrip(".")


def part_of(name: str) -> str:
    return name.split(".", maxsplit=1)[0]


def imported(text: str, name: str, *, is_package: bool = False) -> set[str]:
    """The parts of codegen that a module imports, at its top or anywhere in it."""
    return {part_of(found) for found in _imported_names(parsed(text), name, is_package)} - {""}


def _imported_names(tree: ast.AST, name: str, is_package: bool) -> Iterator[str]:
    """The dotted names below codegen; what is imported from the package itself may be a part or a value of it."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name.removeprefix("codegen.") for alias in node.names if alias.name[:8] == "codegen.")
        elif isinstance(node, ast.ImportFrom):
            absolute = node.module or ""
            if node.level:
                parents = f"codegen.{name}".split(".")
                parents = parents[: len(parents) - node.level + is_package]
                absolute = ".".join([*parents, *([node.module] if node.module else [])])
            if absolute == "codegen":
                yield from (alias.name for alias in node.names if alias.name != "__version__")
            elif absolute.startswith("codegen."):
                yield absolute.removeprefix("codegen.")


def outcries(text: str) -> list[str]:
    """The places where a module prints, reads the keyboard, ends the program, or takes a stream to do so."""
    found = []
    for node in ast.walk(parsed(text)):
        match node:
            case ast.Call(func=ast.Name(id="print" | "input" | "exit" | "quit" | "breakpoint" as called)):
                found.append(f"{node.lineno}: {called}()")
            case ast.Attribute(
                value=ast.Name(id="sys"), attr="exit" | "stdout" | "stderr" | "__stdout__" | "__stderr__" as taken
            ):
                found.append(f"{node.lineno}: sys.{taken}")
            case ast.Attribute(value=ast.Name(id="os"), attr="_exit" | "abort" as taken):
                found.append(f"{node.lineno}: os.{taken}")
            case ast.ImportFrom(module="sys", names=names):
                found.extend(f"{node.lineno}: from sys import {name.name}" for name in names if name.name == "exit")
            case ast.Name(id="SystemExit"):
                found.append(f"{node.lineno}: SystemExit")
    return found


def held_by_every_module(check: Callable[[Path], None]) -> Callable[[], None]:
    """One test that holds every module to a rule, and names those that break it."""

    def test() -> None:
        broken = []
        for path in MODULES:
            try:
                check(path)
            except AssertionError as problem:
                broken.append(f"{name_of(path)}: {problem}")
        assert not broken, "\n".join(broken)

    test.__name__, test.__doc__ = check.__name__, check.__doc__
    return test


@held_by_every_module
def test_a_module_imports_only_what_lies_below_it(path: Path) -> None:
    name = name_of(path)
    if not name:
        assert imported(path.read_text(), name, is_package=True) == set(), "the package itself imports none of it"
        return
    part = part_of(name)
    assert part in MAY_IMPORT, f"{part} is new: give it a place in MAY_IMPORT"
    forbidden = imported(path.read_text(), name, is_package=path.name == "__init__.py") - MAY_IMPORT[part] - {part}
    assert not forbidden, f"codegen.{name} must not import {', '.join(sorted(forbidden))}"


@held_by_every_module
def test_no_stage_knows_a_kind_of_answer(path: Path) -> None:
    """A stage that asks what kind an answer is of has to be changed for each further kind."""
    name = name_of(path)
    if part_of(name) != "answers":
        used = {
            found for found in _imported_names(parsed(path.read_text()), name, False) if part_of(found) == "answers"
        }
        assert used <= KNOW_KINDS.get(name, set())


def test_a_kind_of_answer_is_registered() -> None:
    """A kind that is written and not registered could not be used, and nobody would be told."""
    for path in (PACKAGE / "answers").rglob("*.py"):
        importlib.import_module(f"codegen.{name_of(path)}")
    direct = KindOfAnswer.__subclasses__()
    written = {kind.__qualname__ for kind in (*direct, *(below for kind in direct for below in kind.__subclasses__()))}
    assert written == {kind.__qualname__ for kind in KINDS}
    assert len(written) == len(KINDS) >= 9


def test_the_allowed_directions_have_no_circle() -> None:
    """Whatever is added to the table: no part may come back to itself through others."""
    settled: set[str] = set()
    while len(settled) < len(MAY_IMPORT):
        ready = {part for part, below in MAY_IMPORT.items() if part not in settled and below <= settled}
        assert ready, f"a circle among {sorted(set(MAY_IMPORT) - settled)}"
        settled |= ready


@held_by_every_module
def test_only_the_command_line_prints_and_exits(path: Path) -> None:
    """Stages return values and report findings, so that tests, editors and other programs can call them."""
    if part_of(name_of(path)) not in ("cli", "__main__"):
        assert outcries(path.read_text()) == []


@held_by_every_module
def test_a_module_is_called_what_it_is_about(path: Path) -> None:
    assert not VAGUE & set(name_of(path).split("."))


@held_by_every_module
def test_frozen_classes_are_those_that_are_made_soon(path: Path) -> None:
    """Those of the standard library would take half the time of all imports: see codegen/frozen.py."""
    tree = parsed(path.read_text())
    imports = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.module == "dataclasses"]
    takes_another = any(alias.name == "dataclass" for node in imports for alias in node.names)
    assert name_of(path) == "frozen" or not (takes_another and "(frozen=True" in path.read_text())


def test_modules_stay_small() -> None:
    """One idea a module: none above 400 lines, and three of four below 200."""
    sizes = sorted(((len(path.read_text().splitlines()), name_of(path)) for path in MODULES), reverse=True)
    shown = "\n".join(f"{size:5} {name}" for size, name in sizes[:15])
    assert sizes[0][0] <= 400, f"too large:\n{shown}"
    assert sum(size < 200 for size, _ in sizes) >= 0.75 * len(sizes), f"too many large ones:\n{shown}"


@pytest.mark.parametrize(
    ("text", "name", "parts"),
    [
        ("from codegen.load.text import read", "model.spec.spec", {"load"}),
        ("import codegen.load.text as t", "model.spec.spec", {"load"}),
        ("from codegen import pipeline, __version__", "cli.build", {"pipeline"}),
        ("def f():\n    from codegen.decode import spec", "targets.mocks", {"decode"}),
        ("from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from codegen.decode import x", "t", {"decode"}),
        ("from ..decode.spec import x", "targets.mocks", {"decode"}),
        ("from .naming import x", "targets.mocks", {"targets"}),
        ("import os\nfrom codegenerator import x", "targets.mocks", set()),
    ],
)
def test_imports_are_found_however_they_are_written(text: str, name: str, parts: set[str]) -> None:
    """A check that finds nothing protects nothing."""
    assert imported(text, name) == parts


def test_relative_imports_of_a_package_count_from_itself() -> None:
    assert imported("from .mocks import x", "targets", is_package=True) == {"targets"}
    assert imported("from ..decode import x", "targets", is_package=True) == {"decode"}


@pytest.mark.parametrize(
    "text",
    ["print('x')", "import sys\nsys.exit(1)", "import sys as s\nraise SystemExit", "from sys import exit", "input()",
     "import sys\nsys.stderr.write('x')", "import os\nos._exit(1)"],
)  # fmt: skip
def test_printing_and_exits_are_found_however_they_are_written(text: str) -> None:
    assert outcries(text)


def test_a_method_that_is_called_like_them_is_none() -> None:
    assert outcries("page.print()\nself.exit = 3\nfoo(stdout=1)") == []
