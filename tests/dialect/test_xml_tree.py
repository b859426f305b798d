"""Reading XML: exact places, honest messages, and nothing that a hostile file can get out of it."""

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.xml_tree import XmlElement, parse_xml, place_of, read_xml
from codegen.source import Place

Write = Callable[..., str]


def located(root: XmlElement) -> list[tuple[str, int, int]]:
    return [(root.tag, root.line, root.column), *(place for child in root.children for place in located(child))]


def parsed(text: str) -> XmlElement:
    report = Report()
    root = parse_xml(text, "/d.xml", report)
    assert root is not None, list(report)
    return root


def found(path: str, asked_at: Place | None = None) -> list[tuple[str, str, int, int]]:
    """Rule, file name, line and column of all findings."""
    report = Report()
    assert read_xml(path, DISK, report, asked_at) is None
    assert all(one.rule.unreadable for one in report)
    assert report.exit_code == 2
    return [(one.rule.id, Path(one.place.file).name, one.place.line, one.place.column) for one in report]


def test_an_element_stands_where_its_tag_opens() -> None:
    """libxml2 gives the line where a start tag ends, which for a field over several lines is the wrong one."""
    root = parsed('<a>\n  <b\n    x="1"\n    y="2"\n  >\n<c\n/></b> <d/>\n</a>')
    assert located(root) == [("a", 1, 1), ("b", 2, 3), ("c", 6, 1), ("d", 7, 8)]
    assert place_of(root.children[0], "/d.xml") == Place("/d.xml", 2, 3)


def test_lines_above_65535_are_kept() -> None:
    """libxml2 stores 16 bits and guesses beyond."""
    root = parsed("<a>" + "\n" * 70000 + "<b/><c>\n</c></a>")
    assert located(root) == [("a", 1, 1), ("b", 70001, 1), ("c", 70001, 5)]


def test_tags_in_comments_cdata_and_instructions_do_not_shift_places() -> None:
    """Only real start tags count."""
    root = parsed('<?xml version="1.0"?><!-- <x> --><a><!-- <b> \n--><![CDATA[<b>\n]]><?pi <b>?><b/></a>')
    assert located(root) == [("a", 1, 34), ("b", 3, 14)]


def test_text_is_the_elements_own() -> None:
    """Text around children, comments and CDATA belongs to the element; entities that XML itself knows are read."""
    root = parsed("<a>x<b>no</b>y<!-- no -->z<![CDATA[<w>]]>&lt;&#65;</a>")
    assert root.text == "xyz<w><A"


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_every_line_end_counts_once(line_end: str) -> None:
    """Files come from Windows too."""
    assert located(parsed(line_end.join(["<a>", "", " <b/>", "</a>"]))) == [("a", 1, 1), ("b", 3, 2)]


def test_columns_count_characters(write: Write) -> None:
    """Not bytes, and without the byte order mark."""
    report = Report()
    for encoding in ("utf-8", "utf-8-sig", "utf-16"):
        root = read_xml(write("<a>äöü€<b/></a>".encode(encoding)), DISK, report)
        assert root is not None
        assert located(root) == [("a", 1, 1), ("b", 1, 8)]
    assert list(report) == []


def test_declared_encodings_are_read(write: Write) -> None:
    """Latin-1 occurs in the field."""
    report = Report()
    root = read_xml(write('<?xml version="1.0" encoding="ISO-8859-1"?><a>ä</a>'.encode("latin-1")), DISK, report)
    assert root is not None
    assert root.text == "ä"


@pytest.mark.parametrize(
    ("content", "rule", "line", "column"),
    [
        (b"", "xml-syntax", 1, 1),
        (b" \n ", "xml-syntax", 1, 1),
        (b"no xml", "xml-syntax", 1, 1),
        (b"<a>\n<b>\n</a>\n</c>", "xml-syntax", 3, 5),
        (b"<a>\n <b x=1>\n</b></a>", "xml-syntax", 2, 7),
        (b"<a>\n <b>& </b></a>", "xml-syntax", 2, 6),
        (b"<a>\n", "xml-syntax", 2, 1),
        (b"<a/>\n<b/>", "xml-syntax", 2, 1),
        (b'<a>\n<b x="1" x="2"/></a>', "xml-syntax", 2, 15),
        (b"<a>&undeclared;</a>", "xml-syntax", 1, 16),
        (b"<a>" * 300 + b"</a>" * 300, "xml-syntax", 1, 771),
        (b"<a>\n\xc3\xa4\xff</a>", "file-not-utf8", 2, 2),
        (b'<?xml version="1.0" encoding="bogus"?><a/>', "xml-encoding", 1, 1),
        (b'<?xml version="1.0" encoding="utf-16"?><a/>', "xml-encoding", 1, 1),
        (b'<?xml version="1.0" encoding="unicode_escape"?><a>\\q</a>', "xml-encoding", 1, 1),
        (b'<?xml version="1.0" encoding="us-ascii"?>\n<a>\xff</a>', "xml-encoding", 2, 4),
        (b"\xff\xfe<\x00a", "xml-encoding", 1, 2),
    ],
)
def test_broken_files(content: bytes, rule: str, line: int, column: int, write: Write) -> None:
    """One finding at the first wrong character; exit code 2."""
    assert found(write(content)) == [(rule, "d.xml", line, column)]


def test_files_that_are_none(tmp_path: Path) -> None:
    """Reported where the file is asked for, or at the file itself where nobody asks."""
    asked_at = Place(str(tmp_path / "codegen.yaml"), 4, 10)
    assert found(str(tmp_path / "missing.xml"), asked_at) == [("file-not-found", "codegen.yaml", 4, 10)]
    assert found(str(tmp_path / "missing.xml")) == [("file-not-found", "missing.xml", 1, 1)]
    assert found(str(tmp_path), asked_at) == [("file-not-readable", "codegen.yaml", 4, 10)]
    assert found("/dev/zero", asked_at) == [("file-not-readable", "codegen.yaml", 4, 10)]


LAUGHS = "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 10))


@pytest.mark.parametrize(
    ("content", "line", "column"),
    [
        ('<!DOCTYPE a SYSTEM "http://example.invalid/a.dtd"><a/>', 1, 1),
        ("<?xml version='1.0'?>\n<!-- c -->\n <!DOCTYPE a><a/>", 3, 2),
        ('<!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/hostname">]><a>&x;</a>', 1, 1),
        ('<!DOCTYPE a [<!ENTITY % x SYSTEM "file:///etc/hostname"> %x;]><a/>', 1, 1),
        (f'<!DOCTYPE a [<!ENTITY l0 "ha">{LAUGHS}]><a b="&l9;">&l9;</a>', 1, 1),
        ('\ufeff\ufeff<!DOCTYPE a [<!ENTITY x "y">]><a b="&x;"/>', 1, 2),
    ],
)
def test_document_types_are_refused(content: str, line: int, column: int, write: Write) -> None:
    """External entities, a DTD and a billion laughs: refused before anything is parsed, so at once."""
    begun = time.monotonic()
    assert found(write(content)) == [("xml-doctype", "d.xml", line, column)]
    assert time.monotonic() - begun < 1


def test_utf16_does_not_hide_a_document_type(write: Write) -> None:
    """The check is made on text, not on bytes."""
    assert found(write('<!DOCTYPE a [<!ENTITY x "y">]><a>&x;</a>'.encode("utf-16"))) == [("xml-doctype", "d.xml", 1, 1)]


def test_a_document_type_in_a_comment_is_none() -> None:
    """Nor in text: only a declaration counts."""
    assert parsed("<!-- <!DOCTYPE a> --><a><![CDATA[<!DOCTYPE a>]]></a>").tag == "a"


def test_xinclude_is_not_followed() -> None:
    """An element like any other."""
    root = parsed('<a xmlns:i="http://www.w3.org/2001/XInclude"><i:include href="/etc/hostname" parse="text"/></a>')
    assert root.text == ""
    assert root.children[0].text == ""


@pytest.mark.parametrize("unit", ["<!--", "<!-- -->", "<?p ?>", " ", "<![CDATA[", "<a ", "<!-- -->\n<?", "&a;"])
def test_no_file_takes_more_time_than_its_size_deserves(unit: str) -> None:
    """A prologue that never ends is walked over once."""
    begun = time.monotonic()
    parse_xml(unit * 100_000, "/d.xml", Report())
    assert time.monotonic() - begun < 2


MARKUP = st.sampled_from(
    ["<a>", "</a>", "<a/>", "<!--", "-->", "<![CDATA[", "]]>", "<?p", "?>", "\n", "x", "&amp;", '"', "é"]
)


@given(st.one_of(st.text(), st.lists(MARKUP, max_size=15).map("".join)))
def test_no_text_raises_and_places_are_start_tags(text: str) -> None:
    """Either one finding, or a tree of which every element stands at a "<"."""
    for written in (text, f"<a>{text}</a>"):
        report = Report()
        root = parse_xml(written, "/d.xml", report)
        assert (root is None) == bool(list(report))
        if root is not None:
            lines = written.replace("\r\n", "\n").replace("\r", "\n").split("\n")
            for tag, line, column in located(root):
                assert lines[line - 1][column - 1 :].startswith(f"<{tag}")


@given(st.binary())
def test_no_bytes_raise(data: bytes) -> None:
    """The file is made anew for each example, next to nothing else."""
    with tempfile.NamedTemporaryFile(suffix=".xml") as file:
        file.write(data)
        file.flush()
        report = Report()
        assert (read_xml(file.name, DISK, report) is None) == bool(list(report))
