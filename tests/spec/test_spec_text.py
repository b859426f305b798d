"""Reading files: whatever lies at a path, the result is text or a diagnostic with a place, never an exception."""

import os
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.load import files as files_module
from codegen.load.files import DISK
from codegen.load.text import decode_text
from codegen.source import Place


def read_text(path: str, report: Report, asked_at: Place | None = None) -> str | None:
    """The two steps of reading, one after the other, as the decoder takes them."""
    data = DISK.read_bytes(path, report, asked_at)
    return None if data is None else decode_text(data, path, report)


def found(report: Report) -> list[tuple[str, str, int, int]]:
    return [(d.rule.id, os.path.basename(d.place.file), d.place.line, d.place.column) for d in report]


def test_text_comes_without_its_byte_order_mark_and_with_its_line_ends(tmp_path: Path) -> None:
    path = tmp_path / "a.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: \xc2\xb0\r\nb: 1\n")
    report = Report()
    assert read_text(str(path), report) == "a: °\r\nb: 1\n"
    assert found(report) == []


@pytest.mark.parametrize(
    ("data", "line", "column"),
    [
        (b"\xff", 1, 1),
        (b"abc\n\xc2\xb0\xfe", 2, 2),
        (b"a\r\nb\rc\xe4", 3, 2),
        (b"\xef\xbb\xbfab\xff", 1, 3),
        (b"a: \xc3", 1, 4),
        (b"\xff\xfea\x00", 1, 1),
        (b"\xed\xa0\x80", 1, 1),
    ],
)
def test_a_byte_that_is_not_utf8_is_named_by_line_and_column(
    tmp_path: Path, data: bytes, line: int, column: int
) -> None:
    """Columns count characters, as editors do, whatever the line ends are."""
    path = tmp_path / "a.yaml"
    path.write_bytes(data)
    report = Report()
    assert read_text(str(path), report) is None
    assert found(report) == [("file-not-utf8", "a.yaml", line, column)]
    assert report.exit_code == 2


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("a: 1\n<<<<<<< HEAD\nb: 1\n=======\nb: 2\n>>>>>>> other\n", 2),
        ("\ufeff<<<<<<< HEAD\r\nb: 1\r\n=======\r\n>>>>>>> other\r\n", 1),
        ("x\r\n<<<<<<< HEAD\r\nb: 1\r\n=======\r\n>>>>>>> other", 2),
        ("<<<<<<< ours\n1\n||||||| base\n0\n=======\n2\n>>>>>>> theirs\n", 1),
        ("1. Text\n   <<<<<<< HEAD\n   1\n   =======\n   2\n   >>>>>>> other\n", None),
        ("Title\n=======\n\n<<<<<<< is what git writes\n", None),
        ("<<<<<<< a\n>>>>>>> b\n", None),
    ],
)
def test_an_open_conflict_of_a_merge_is_not_read(text: str, line: int | None) -> None:
    """Both sides would be in a requirement, or in a table; what only tells of markers is text."""
    report = Report()
    read = decode_text(text.encode(), "a.md", report)
    if line is None:
        assert (read, found(report)) == (text.removeprefix("\ufeff"), [])
    else:
        assert (read, found(report)) == (None, [("open-conflict", "a.md", line, 1)])
        assert report.exit_code == 2


def test_what_is_no_readable_file_is_reported_where_it_is_asked_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "file").write_text("x")
    asked_at = Place(str(tmp_path / "codegen.yaml"), 5, 15)
    for name, rule in (
        ("missing.yaml", "file-not-found"),
        ("file/below", "file-not-found"),
        (".", "file-not-readable"),
        ("pipe", "file-not-readable"),
        ("nul\0", "file-not-readable"),
        ("x" * 5000, "file-not-readable"),
    ):
        report = Report()
        assert read_text(str(tmp_path / name), report, asked_at) is None
        assert found(report) == [(rule, "codegen.yaml", 5, 15)], name
        assert report.exit_code == 2


def test_without_someone_who_asks_the_file_itself_is_the_place(tmp_path: Path) -> None:
    report = Report()
    assert read_text(str(tmp_path / "missing.yaml"), report) is None
    assert found(report) == [("file-not-found", "missing.yaml", 1, 1)]


def test_a_file_without_permission_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulated, because the superuser may read everything."""

    def refuse(*_: object) -> None:
        raise PermissionError(13, "Permission denied")

    (tmp_path / "a.yaml").write_text("a")
    monkeypatch.setattr("builtins.open", refuse)
    report = Report()
    assert read_text(str(tmp_path / "a.yaml"), report) is None
    assert found(report) == [("file-not-readable", "a.yaml", 1, 1)]


def test_a_file_beyond_the_limit_is_not_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(files_module, "MAX_BYTES", 10)
    for size, rules in ((10, []), (11, [("file-too-large", "a.yaml", 1, 1)])):
        (tmp_path / "a.yaml").write_text("x" * size)
        report = Report()
        read_text(str(tmp_path / "a.yaml"), report)
        assert found(report) == rules
