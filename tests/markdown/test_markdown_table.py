"""Tables of Markdown documents: cells with their places, and everything that parsers damage without a word."""

import random
from pathlib import Path

import pytest
from markdown_it import MarkdownIt

from codegen.load.markdown_blocks import read_inline
from codegen.load.markdown_table import Table, parse_tables

ROOT = Path(__file__).parents[2]


def tables(text: str) -> tuple[Table, ...]:
    return parse_tables(text, "page.md").tables


def texts(table: Table) -> list[list[str]]:
    return [[cell.text for cell in row.cells] for row in (table.header, *table.rows)]


def findings(text: str) -> list[tuple[str, int, int]]:
    return [(found.rule.id, found.place.line, found.place.column) for found in parse_tables(text, "page.md").findings]


def test_a_cell_knows_its_place_its_text_and_its_code() -> None:
    (table,) = tables(
        "# A\n\n## B\n\nValues:\n\n| Field | Source |\n| :-- | --: |\n"
        r"| voltages\[0] | `{flags: [A \| B]}` |" + "\n|  a \\* b|  |\n"
    )
    assert table.headings == ("A", "B")
    assert table.lead == "Values:"
    first, second = table.rows
    assert [cell.text for cell in first.cells] == ["voltages[0]", "{flags: [A | B]}"]
    assert first.cells[1].codes == ("{flags: [A | B]}",)
    assert [(cell.place.line, cell.place.column) for cell in first.cells] == [(9, 3), (9, 18)]
    assert [cell.text for cell in second.cells] == ["a * b", ""]
    assert second.cells[0].place.column == 4


@pytest.mark.parametrize(
    ("text", "line", "column"),
    [
        ("- item\n\n  | a | b |\n  | - | - |\n  | 1 | 2 |\n", 5, 5),
        ("1. one\n   - | a | b |\n     | - | - |\n     | 1 | 2 |\n", 4, 8),
        ("> | a | b |\n> | - | - |\n> | 1 | 2 |\n", 3, 5),
        ("text\nmore text\n| a | b |\n| - | - |\n| 1 | 2 |\n", 5, 3),
        ("a | b |\n---|---|\n1 | 2 |\n", 3, 1),
        ("a | b\n:-: | -\n  1 | 2\n", 3, 3),
        ("| a | b |\r\n| - | - |\r\n| 1 | 2 |\r\n", 3, 3),
        ("| a | b |\n| - | - |\n| 1 | 2 |\n---\n", 3, 3),
    ],
)
def test_tables_are_found_wherever_they_stand(text: str, line: int, column: int) -> None:
    (table,) = tables(text)
    assert texts(table) == [["a", "b"], ["1", "2"]]
    assert (table.rows[0].cells[0].place.line, table.rows[0].cells[0].place.column) == (line, column)
    assert findings(text) == []


@pytest.mark.parametrize(
    "text",
    [
        "```\n| a | b |\n| - | - |\n```\n",
        "    | a | b |\n    | - | - |\n",
        "<!--\n| a | b |\n| - | - |\n-->\n",
        "either a | b or\nc | d\n",
        "|x| is a norm\n|y| is one\n",
        "one line | of text\n",
    ],
)
def test_what_is_no_table_is_left_alone(text: str) -> None:
    assert tables(text) == ()
    assert findings(text) == []


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("| a | b |\n| - |\n| 1 | 2 |", [("table-delimiter", 2, 1)]),
        ("| a | b |\n| - | - | - |\n| 1 | 2 |", [("table-delimiter", 2, 1)]),
        ("| a | b |\n| - | — |\n| 1 | 2 |", [("table-delimiter", 2, 7)]),
        ("| a | b |\n|---+---|\n| 1 | 2 |", [("table-delimiter", 2, 2)]),
        ("| a | b |\n| 1 | 2 |", [("table-delimiter", 1, 1)]),
        ("| a | b |\n\n| - | - |\n| 1 | 2 |", [("table-delimiter", 3, 1)]),
        ("| a | b |\n| - | - |\n| 1 |", [("table-cell-missing", 3, 1)]),
        ("| a | b |\n| - | - |\n| 1 | 2 | 3 | 4 |", [("table-cell-surplus", 3, 11)]),
        ("| a | b |\n| - | - |\n| 1 | `x | y` |", [("table-bar-in-code", 3, 10)]),
        ("| a | b |\n| - | - |\n| `x | y` |", [("table-bar-in-code", 3, 6)]),
        ("| a | b |\n| - | - |\n| 1 | 2 |\nmore\ntext", [("table-with-text", 4, 1)]),
        ("| a | b |\n| - | - |\n| 1 | 2 |\n| c | d |\n| - | - |\n| 3 | 4 |", [("table-run-together", 4, 1)]),
        ("- | a | b |\n  | - | - |\n  | 1 |", [("table-cell-missing", 3, 3)]),
    ],
)
def test_damage_is_reported_at_its_place(text: str, found: list[tuple[str, int, int]]) -> None:
    assert findings(text) == found


def test_a_damaged_table_is_read_all_the_same() -> None:
    (table,) = tables("| a | b |\n| - |\n| 1 | 2 |\n")
    assert not table.is_shown
    assert texts(table) == [["a", "b"], ["1", "2"]]
    first, second = tables("a | b\n-|-\n1 | 2\nc | d\n-|-\n3 | 4\n\n")
    assert texts(first) == [["a", "b"], ["1", "2"]]
    assert texts(second) == [["c", "d"], ["3", "4"]]


def test_escapes_and_code_marks_are_no_damage() -> None:
    text = "| a | b |\n| - | - |\n| x \\| y | `p \\| q` |\n| ``a`b`` | `c` |\n| it`s | o`clock |\n"
    assert findings(text) == []
    assert texts(tables(text)[0])[1] == ["x | y", "p | q"]


LINES = (
    *("| a | b |", "| a | b | c |", "a | b", "| - | - |", "| :-: | -- | --: |", "-|-", "|-|", "text", "", "> quote"),
    *("| `x \\| y` | z |", "| 1 |", "| 1 | 2 | 3 |", "- item", "  | a | b |", "  | - | - |", "# head", "| \\* | _e_ |"),
    *("```", "---", "||", "| | |"),
)


def test_what_renderers_show_is_what_is_read() -> None:
    """The oracle is markdown-it's own table rule: header and rows of every table that it shows, filled up and cut."""
    renderer = MarkdownIt("commonmark").enable("table")
    dice = random.Random(6)
    compared = 0
    for _ in range(1500):
        text = "\n".join(dice.choices(LINES, k=dice.randint(3, 8))) + "\n"
        shown = [
            table
            for table in _rendered(renderer, text)
            if len(table[0]) > 1 and set(table[0]) - {"-", "--", ":-:", "--:"}
        ]
        read = [table for table in tables(text) if table.is_shown]
        for expected in shown:
            matching = [table for table in read if texts(table)[0] == expected[0]]
            assert matching, f"{text}\nis shown with {expected}, and {read} is read"
            # What is read otherwise on purpose: text below a table, tables run together, rows outside of their item.
            if not any(word in text for word in ("text", "item", ">")) and not _run_together(text):
                assert expected in [[_fitted(row, len(expected[0])) for row in texts(table)] for table in matching], (
                    text
                )
                compared += 1
    assert compared > 90


def _run_together(text: str) -> bool:
    return any(rule == "table-run-together" for rule, _, _ in findings(text))


def _fitted(row: list[str], width: int) -> list[str]:
    return (row + [""] * width)[:width]


def _rendered(renderer: MarkdownIt, text: str) -> list[list[list[str]]]:
    found: list[list[list[str]]] = []
    for index, token in enumerate(tokens := renderer.parse(text)):
        if token.type == "table_open":
            found.append([])
        elif token.type == "tr_open":
            found[-1].append([])
        elif token.type in ("th_open", "td_open"):
            found[-1][-1].append(read_inline(tokens[index + 1].content).text)
    return found


def test_the_shipped_documents_have_whole_tables() -> None:
    for path in [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("specs/requirements/*.md")]:
        assert parse_tables(path.read_text(encoding="utf-8"), str(path)).findings == (), path


def test_a_large_document_is_read_in_time() -> None:
    """A megabyte takes about a second; quadratic reading would take minutes."""
    row = "| voltages\\[0] | `{state: battery.voltage}` | text with `code` and more |\n"
    text = "| a | b | c |\n| - | - | - |\n" + row * 12000 + "\n" + "| " * 20000 + "\n" + "`|" * 20000 + "\n"
    (table,) = tables(text)
    assert len(table.rows) == 12000
