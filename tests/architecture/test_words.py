"""No word of one vehicle decides anything in the generator: what it knows of batteries or rovers, specs/ say."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CODEGEN, TEMPLATES = ROOT / "codegen", ROOT / "templates"
OWN = ("codegen/sources/", "codegen/boards/", "codegen/corrections/", "templates/start/")
"""The places for such words: drivers of sensors, boards, corrections about batteries, projects to begin with."""

WORDS = re.compile(
    r"batter(?:y|ies)|batt\d?|rovers?|voltages?|chemistr(?:y|ies)|lipo|lion|discharge[ds]?|discharging|cells?|packs"
)
"""Whole words, in lower case, that only one vehicle or one kind of part gives a meaning; a volt is a unit."""
PARTS = re.compile(r"[A-Z]?[a-z]+\d?|[A-Z]+(?![a-z])\d?")
"""The words of a name, however they are joined: batt_volt, BatteryState, BATT2_MONITOR."""

ALLOWED = {
    "codegen/model/units/unit_table.py": ({"voltage"}, "the dimension that is measured in V: physics"),
    "codegen/claims/known_names.py": (
        {"voltage", "batt", "battery"},
        "words of the dialects' names, and short for them",
    ),
    "codegen/claims/statements/quantities.py": ({"voltage"}, "what is measured in V: physics"),
    **{
        f"codegen/claims/statements/{name}.py": ({"cell", "cells"}, "everyday words for elements of arrays")
        for name in ("absent", "unknown")
    },
    "codegen/diff/judging/words.py": (
        {"voltage", "battery", "batt", "discharge"},
        "English in the dialects' own descriptions: abbreviations, and words that exclude each other",
    ),
    **{
        name: ({"cell", "cells"}, "cells of the tables of Markdown, of pages and of printed tables")
        for name in (
            *("codegen/targets/pages/program.py", "templates/pages/program.html.j2"),
            *("codegen/claims/cast.py", "codegen/claims/field_notes.py", "codegen/claims/statements/entries.py"),
            *("codegen/claims/statements/entry_names.py",),
            *("codegen/claims/parts/aligned.py", "codegen/claims/parts/cells.py", "codegen/claims/parts/code_spans.py"),
            *("codegen/claims/parts/spans.py", "codegen/claims/number_columns.py"),
            *("codegen/claims/statements/fields.py", "codegen/claims/statements/units.py"),
            *("codegen/claims/own/parameters.py", "codegen/claims/own/rate_column.py"),
            "codegen/claims/statements/lengths.py",
            *("codegen/claims/statements/values/unfilled.py", "codegen/claims/weighed/numbers.py"),
            "codegen/claims/weighed/entities/lengths.py",
            *("codegen/claims/statements/tables.py", "codegen/claims/statements/columns/rows.py"),
            *("codegen/claims/statements/meaning.py", "codegen/claims/own/worked/examples.py"),
            *("codegen/explain/story.py", "codegen/explain/receptions.py", "codegen/explain/text.py"),
            *("codegen/importing/answer.py", "codegen/importing/columns.py", "codegen/importing/comparison.py"),
            *("codegen/importing/declared.py", "codegen/importing/number.py", "codegen/importing/proposal.py"),
            *("codegen/importing/quantity.py", "codegen/importing/stated.py", "codegen/importing/value.py"),
            *("codegen/load/markdown_table.py", "codegen/targets/pages/byte_map.py", "codegen/trace/view.py"),
            *("templates/trace/trace.md.j2",),
        )
    },
}
"""By file the words that have another meaning there, and which."""
TOLD = ("described", "Rule")
"""Functions that are called with texts for people: keys and rules, whose examples are documentation."""


def words_of(text: str) -> Iterator[str]:
    """The words of one vehicle in a name or a text."""
    for part in PARTS.findall(text):
        if WORDS.fullmatch(part.lower()):
            yield part.lower()


def strings_for_people(tree: ast.AST) -> set[int]:
    """The constants that are documentation: docstrings, and texts of keys and rules beside their ids and defaults."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            found.add(id(node.value))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in TOLD:
            told = node.args[1:2] if node.func.id == "Rule" else node.args[:1]
            found |= {id(inner) for each in told for inner in ast.walk(each)}
    return found


def names_in(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Every name and every string that is no documentation, with its line."""
    for_people = strings_for_people(tree)
    for node in ast.walk(tree):
        line = getattr(node, "lineno", 0)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in for_people:
            yield line, node.value
        elif isinstance(node, ast.Name):
            yield line, node.id
        elif isinstance(node, ast.Attribute):
            yield line, node.attr
        elif isinstance(node, ast.FunctionDef | ast.ClassDef | ast.AsyncFunctionDef):
            yield line, node.name
        elif isinstance(node, ast.arg | ast.keyword) and node.arg is not None:
            yield line, node.arg
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield line, node.module
        elif isinstance(node, ast.alias):
            yield line, f"{node.name} {node.asname or ''}"


def names_in_template(text: str) -> Iterator[tuple[int, str]]:
    """Yield a template's output and questions by line: all but its comments and the documentation that it prints."""
    text = re.sub(
        r"\{#.*?#\}|<!--.*?-->|\"\"\".*?\"\"\"", lambda found: "\n" * found[0].count("\n"), text, flags=re.DOTALL
    )
    for number, line in enumerate(text.splitlines(), 1):
        yield number, re.sub(r"(^|\s)(#|//).*", "", line)


def found_in(path: Path) -> list[str]:
    """Places and words of one file."""
    name = path.relative_to(ROOT).as_posix()
    allowed, _ = ALLOWED.get(name, (set(), ""))
    text = path.read_text(encoding="utf-8")
    pieces = names_in(ast.parse(text)) if path.suffix == ".py" else names_in_template(text)
    return [
        f"{name}:{line}: {word} in {piece.strip()[:60]!r}"
        for line, piece in [(0, path.stem), *pieces]
        for word in words_of(piece)
        if word not in allowed
    ]


def files() -> list[Path]:
    """All of the generator and of its templates, but for where such words belong."""
    found = [*CODEGEN.rglob("*.py"), *(path for path in TEMPLATES.rglob("*") if path.suffix in (".py", ".j2", ".in"))]
    return sorted(path for path in found if not path.relative_to(ROOT).as_posix().startswith(OWN))


def test_no_word_of_one_vehicle_has_a_meaning() -> None:
    """Names, strings that decide something and names of files: the specification gives a vehicle its words."""
    paths = files()
    assert len(paths) > 400, "the generator was not found"
    assert not (found := [place for path in paths for place in found_in(path)]), "\n".join(found)


def test_each_exception_is_needed() -> None:
    """An exception that nothing needs any more is taken out, for it would hide the next word."""
    for name, (words, reason) in ALLOWED.items():
        text = (ROOT / name).read_text(encoding="utf-8").lower()
        assert reason
        assert any(word in text for word in words), f"{name} has none of {sorted(words)}"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("_of_packs = 1", ["packs"]),
        ("class BatteryState: pass", ["battery"]),
        ('HINT = "BATT2_VOLT_PIN"', ["batt2"]),
        ("def f(per_cell): return spec.low_volt", ["cell"]),
        ("from codegen.rules.cell_room import x as rover", ["cell", "rover"]),
        ('RULE = Rule("cell-beyond-adc", "A full cell.")', ["cell"]),
        ('a = described("Such as battery.voltage.", default="rover")', ["rover"]),
        ('"""A battery."""\na = pack_into(package, excellent, default)', []),
        ('f"{name} of a battery"', ["battery"]),
    ],
)
def test_words_are_found_in_whatever_stands_for_something(text: str, words: list[str]) -> None:
    """Names, defaults and ids of rules count; documentation and words that only begin like them do not."""
    found = [word for _, piece in names_in(ast.parse(text)) for word in words_of(piece)]
    assert sorted(found) == sorted(words)


def test_words_are_found_in_templates() -> None:
    """In what a template prints, not in its comments, nor in what it prints as documentation."""
    text = '{# a battery #}\n"""The rover."""\nx = {{ view.battery }}  # a pack\n'
    assert [(line, word) for line, piece in names_in_template(text) for word in words_of(piece)] == [(3, "battery")]
