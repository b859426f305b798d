"""Tables that are written in HTML are read as those of Markdown, each character of a row of one line at its place."""

import pytest

from codegen.load.html_tables import tables_of
from codegen.load.markdown_blocks import parse_blocks
from codegen.load.markdown_table import parse_tables

ONE_LINE = """<table>
<tr><th>Field</th><th>Type</th></tr>
  <tr><td><code>voltages</code></td><td align="right">uint16_t|10</td></tr>
</table>"""
SEVERAL = """<TABLE>
<tr><th>Field</th>
    <th>Unit</th></tr>

<tr>
  <td>temperature</td>
  <td>
    <del>K</del>
    cdegC &amp; more
  </td>
</tr>
<tr><td>id</td></tr>
</table>
"""


def test_a_character_of_a_row_of_one_line_stands_where_it_did() -> None:
    ((first, delimiter, second),) = tables_of(ONE_LINE.split("\n"))
    lines = ONE_LINE.split("\n")
    assert delimiter.text == "|---|---|"
    for row, words in ((first, ("Field", "Type")), (second, ("voltages", "uint16_t"))):
        for word in words:
            assert row.column + row.text.index(word) == lines[row.line].index(word)
    found = parse_tables(ONE_LINE, "notes.md")
    ((cells,),) = [table.rows for table in found.tables]
    assert not found.findings
    assert [(cell.text, cell.codes) for cell in cells.cells] == [("voltages", ("voltages",)), ("uint16_t\u00a610", ())]
    assert [lines[cell.place.line - 1][cell.place.column - 1 :][:4] for cell in cells.cells] == [">vol", "uint"]


def test_rows_of_several_lines_go_on_behind_an_empty_one() -> None:
    """They stand where their first cell does; what is struck is not read, and a row that is short is filled up."""
    ((first, _, second, third),) = tables_of(SEVERAL.split("\n"))
    assert (first.text, first.line) == ("| Field | Unit |", 1)
    assert (second.text, second.line) == ("| temperature | cdegC &amp; more |", 5)
    assert (third.text, third.line) == ("| id |  |", 11)
    blocks = parse_blocks(f"# Title\n\n{SEVERAL}\nThe end.\n", "notes.md")
    assert [block.lines[0].text for block in blocks] == ["Title", "| Field | Unit |", "The end."]
    assert [line.place.line for line in blocks[1].lines] == [4, 4, 8, 14]


def test_nothing_is_read_of_other_html() -> None:
    assert parse_blocks("<div>\nvoltages is in V\n</div>\n", "notes.md") == ()
    assert [*tables_of(["<table></table>", "<tr><td>of no table"])] == []


@pytest.mark.parametrize("unit", ["<![", "<!--", "<a ", "</", "<td", "<?", "<table>", "<code>", "<tr><td>x", "<td a='"])
def test_what_is_no_html_is_read_at_once(unit: str) -> None:
    """A tag that does not end, and a comment that does not, is text: nothing fails, and nothing is looked for again."""
    for rows in tables_of(["<table><tr><td>" + unit * 5_000]):
        assert rows[0].text.startswith("|")
        assert sum(len(row.text) for row in rows) < 40_000


def test_a_comment_is_not_shown() -> None:
    ((first, *_),) = tables_of(["<table><tr><th>Field<!-- <td>K</td> --></th></tr></table>"])
    assert first.text.split() == ["|", "Field", "|"]


def test_a_table_that_nobody_can_mean_is_left_out() -> None:
    """Each row would be filled up to one of a thousand entries."""
    assert [*tables_of(["<table><tr>" + "<td>x" * 1_000, *["<tr><td>y"] * 100])] == []
