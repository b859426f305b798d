"""Docstrings are in the plain style: a noun phrase or a verb, and no relative clause for the reader to guess about."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("codegen", "templates", "benchmarks")

RELATIVE = ("What", "How", "Whether", "Who", "Where", "Which", "When", "Why", "That")
"""Words that begin a clause about something that is not named."""

PERHAPS = re.compile(rf"[\"']\W*(?:{'|'.join(RELATIVE)})\b")
"""Without such a text no docstring of a file begins so, and it need not be parsed."""

OPENING = re.compile(r'(?m)^[ \t]*"""\s*(\w+)')
"""The first word of a docstring in a template, which is no Python before it is rendered."""


def docstrings(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Yield the docstrings of modules, classes and functions, and the texts below constants, with their lines."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        for statement in body if isinstance(body, list) else ():
            match statement:
                case ast.Expr(value=ast.Constant(value=str(text)), lineno=line):
                    yield line, text


def first_words(path: Path) -> Iterator[tuple[int, str]]:
    """Yield the first word of each docstring of a Python file or a template, with its line."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        for line, docstring in docstrings(ast.parse(text)):
            yield line, (re.findall(r"\w+", docstring) or [""])[0]
    else:
        for found in OPENING.finditer(text):
            yield text.count("\n", 0, found.start(1)) + 1, found[1]


def sources() -> list[Path]:
    """Return the Python files and the templates in the folders."""
    return sorted(path for name in FOLDERS for ending in ("*.py", "*.j2") for path in (ROOT / name).rglob(ending))


def test_docstrings_name_their_subject() -> None:
    """A function says what it returns or does, a class and a module what they are."""
    paths = sources()
    assert len(paths) > 500, "the sources were not found"
    paths = [path for path in paths if PERHAPS.search(path.read_text(encoding="utf-8"))]
    found = [
        f"{path.relative_to(ROOT)}:{line}: {word} ..."
        for path in paths
        for line, word in first_words(path)
        if word in RELATIVE
    ]
    assert not found, "\n".join(["say what it is, or Return, Yield, the verb of what it does:", *found])


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("a.py", '"""What a module is."""\n', [(1, "What")]),
        (
            "a.py",
            'class A:\n    """Who may."""\n\n    def f(self):\n        """That of it."""\n',
            [(2, "Who"), (5, "That")],
        ),
        ("a.py", 'A = 1\n"""How many."""\n', [(2, "How")]),
        ("a.py", 'async def f():\n    r"""Whether."""\n', [(2, "Whether")]),
        ("a.py", 'A = "What is wrong"\nprint("""How""")\n', []),
        ("a.py.j2", '{% if x %}\ndef f():\n    """Where it is."""\n', [(3, "Where")]),
        ("a.py.j2", '"""\nWhich."""\n', [(2, "Which")]),
    ],
)
def test_first_words_are_found(name: str, text: str, words: list[tuple[int, str]], tmp_path: Path) -> None:
    """In docstrings of every kind and in texts below constants, with the line; strings that do something are none."""
    path = tmp_path / name
    path.write_text(text)
    assert sorted(first_words(path)) == words
