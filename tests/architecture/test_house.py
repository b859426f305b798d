"""CONTRIBUTING shows the house as it is: each folder with what its package says of itself, and what stands on what.

Run as a program, it prints the tree for CONTRIBUTING.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "codegen"

LOOSE = {
    "__init__",
    "__main__",
    "pytest_plugin",
    "conflict",
    "diagnostics",
    "frozen",
    "measure",
    "once",
    "pattern",
    "source",
}
"""The modules at the root: where runs begin, what projects name in their settings, and what every stage stands on."""

OTHERS = {
    "boards": "Kinds of boards, a file each: pins, converters, ports.",
    "corrections": "Corrections that every project gets, by dialect.",
}
"""Folders without modules."""

MOST = 24
"""Modules that a folder may have beside one another: of more, a newcomer no longer finds one."""

LARGER = {
    "answers": "one for each kind of answer",
    "claims": "one for each kind of claim",
    "cli": "one for each command, and what they share",
    "derivations": "one for each kind of derivation",
    "rules": "one for each rule",
}
"""Folders with more, which are of one kind, and of which."""


def folders(of: Path = PACKAGE) -> Iterator[Path]:
    """Yield the folders of the package, each before those in it, without those of MicroPython."""
    for path in sorted(of.iterdir()):
        is_sensor = path.parent.parent == PACKAGE / "sources"
        if path.is_dir() and path.name != "__pycache__" and not is_sensor and any(path.rglob("*.*")):
            yield path
            yield from folders(path)


def said(part: Path) -> str:
    """Return the first line of what a package or a module says of itself."""
    path = part / "__init__.py" if part.is_dir() else part
    words = ast.get_docstring(ast.parse(path.read_text())) if path.exists() else OTHERS.get(part.name)
    assert words, f"{part.relative_to(ROOT)} says nothing of itself"
    return words.split("\n", 1)[0]


def tree() -> str:
    """Return the tree: a line for each folder, then the loose modules."""
    lines = [("codegen/", said(PACKAGE))]
    for folder in folders():
        depth = len(folder.relative_to(PACKAGE).parts)
        lines.append((f"{'  ' * depth}{folder.name}/", said(folder)))
    lines += [(f"  {name}.py", said(PACKAGE / f"{name}.py")) for name in sorted(LOOSE - {"__init__"})]
    width = max(len(name) for name, _ in lines)
    return "".join(f"{name:<{width}}  {words}\n" for name, words in lines)


def drawn() -> list[list[str]]:
    """Return the parts that CONTRIBUTING draws, line by line from the top."""
    page = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    drawing = page.partition("\n## The house\n")[2].partition("```text\n")[2].partition("```")[0]
    parts = {path.name.removesuffix(".py") for path in PACKAGE.iterdir()}
    return [[word for word in re.findall(r"\w+", line) if word in parts] for line in drawing.splitlines()]


def test_the_tree_of_contributing_is_that_of_the_package() -> None:
    assert f"```text\n{tree()}```" in (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"), f"it would be\n{tree()}"


def test_nothing_lies_loose_at_the_root() -> None:
    assert {path.stem for path in PACKAGE.glob("*.py")} == LOOSE


def test_a_folder_can_be_looked_over() -> None:
    """A folder with many modules that are not of one kind is a room in which nobody finds anything."""
    for folder in folders():
        count = len({path.stem for path in folder.glob("*.py")} - {"__init__"})
        name = folder.relative_to(PACKAGE).as_posix()
        assert count <= MOST or name in LARGER, f"{name} has {count} modules"


def test_what_is_drawn_above_stands_on_what_is_drawn_below() -> None:
    """Each part is drawn once, and imports only what is drawn on a lower line."""
    from test_architecture import MAY_IMPORT  # noqa: PLC0415  this file is a program, too

    lines = drawn()
    height = {part: -number for number, line in enumerate(lines) for part in line}
    assert sorted(height) == sorted(part for line in lines for part in line), "a part is drawn twice"
    assert set(height) >= set(MAY_IMPORT) - {"__main__", "pytest_plugin"}
    for part, own in height.items():
        for below in MAY_IMPORT.get(part, ()):
            assert height[below] < own, f"{part} imports {below}, which is not drawn below it"


if __name__ == "__main__":
    print(tree(), end="")  # noqa: T201
