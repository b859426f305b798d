"""Results that depend on files read meanwhile are kept for as long as these are as they were."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from codegen.decode import decoded, marked_tests
from codegen.decode.decoded import decoded_with_includes, with_files_read
from codegen.decode.marked_tests import read_tests_below
from codegen.diagnostics import Report, Rule, Severity
from codegen.findings import catalogue
from codegen.findings.catalogue import rule_catalogue, rule_ids
from codegen.load.files import DISK, Files, asked_once
from codegen.source import Place
from codegen.tool import cache


def later_run() -> None:
    """Write what is new, and forget what this process knows of the folder."""
    cache.write_new()
    cache.cache_folder.cache_clear()
    cache._new.clear()


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A cache of the test's own."""
    monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache"))
    later_run()
    yield tmp_path / "cache"
    later_run()


class Asked:
    """A function that reads files, and counts how often it is asked."""

    def __init__(self, *paths: Path) -> None:
        self.paths = paths
        self.count = 0

    def __call__(self, files: Files) -> list[str | None]:
        self.count += 1
        return [files.read_text(str(path), Report()) for path in self.paths]


def found(ask: Callable[[Files], list[str | None]], inputs: object = "one") -> list[str | None]:
    made = with_files_read(inputs, ask, {}, DISK)
    later_run()
    return made


def test_it_is_asked_again_where_a_file_differs_comes_or_goes(tmp_path: Path) -> None:
    there, absent = tmp_path / "there", tmp_path / "absent"
    there.write_text("1")
    ask = Asked(there, absent)
    assert found(ask) == found(ask) == ["1", None]
    assert ask.count == 1
    there.write_text("2")
    assert found(ask) == found(ask) == ["2", None]
    absent.write_text("3")
    assert found(ask) == found(ask) == ["2", "3"]
    absent.unlink()
    assert found(ask) == ["2", None]
    assert ask.count == 4


def test_it_is_asked_again_for_other_inputs_by_another_codegen_and_with_other_dialects(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ask = Asked(tmp_path / "absent")
    found(ask)
    found(ask, "other")
    assert ask.count == 2
    monkeypatch.setattr(decoded, "shipped_dialect_names", lambda _files: ("own",))
    found(ask)
    assert ask.count == 3
    monkeypatch.setattr(decoded, "tool_digest", lambda: "another")
    found(ask)
    found(ask)
    assert ask.count == 4


WARNING = Rule("odd-word", "A word is odd.", Severity.WARNING)


def decoding(made: str | None, *, is_odd: bool) -> tuple[Callable[[Report], str | None], list[Report]]:
    """A decoder that returns ``made`` and may have something to report, and where it was asked to report it."""
    asked: list[Report] = []

    def decode(report: Report) -> str | None:
        asked.append(report)
        if is_odd:
            report.add(WARNING, Place("file", 1, 1), "odd")
        return made

    return decode, asked


@pytest.mark.parametrize(
    ("made", "is_odd", "times"), [("good", False, 1), ("good", True, 2), (None, False, 2), (None, True, 2)]
)
def test_what_is_decoded_is_kept_where_there_is_nothing_to_report(made: str | None, is_odd: bool, times: int) -> None:
    """Else it would be told in the first run alone; both ways of decoding hand it to whoever asks."""
    decode, asked = decoding(made, is_odd=is_odd)
    for _ in range(2):
        report, other = Report(), Report()
        assert decoded.decoded("kind", "content", "path", decode, report) == made
        stated, digest = decoded_with_includes("kind", "input", lambda _, new: decode(new), DISK, other)
        assert stated == made
        assert bool(digest) is (made is not None and not is_odd)
        assert [finding.message for finding in (*report, *other)] == ["odd"] * (2 * is_odd)
        later_run()
    assert len(asked) == 2 * times


def test_what_is_decoded_is_that_of_the_kind_the_content_and_the_path() -> None:
    """Places name the path, and a file can be read as several kinds."""
    ways = [("kind", "content", "path"), ("other", "content", "path"), ("kind", "other", "path"),
            ("kind", "content", "other")]  # fmt: skip
    for _ in range(2):
        made = [decoded.decoded(*way, lambda _, way=way: way, Report()) for way in ways]
        assert made == ways
        later_run()


def test_files_that_were_read_for_somebody_else_count_as_well(tmp_path: Path) -> None:
    """Two documents are compared with one dialect, which is read once: an edit of it concerns both."""
    file = tmp_path / "file"

    def texts() -> tuple[list[str | None], list[str | None]]:
        shared = asked_once(Asked(file))
        return with_files_read("one", shared, {}, DISK), with_files_read("other", shared, {}, DISK)

    for text in ("1", "2"):
        file.write_text(text)
        assert texts() == ([text], [text])
        later_run()


def test_what_was_compared_before_counts_for_whoever_notes(tmp_path: Path) -> None:
    """A file that ``seen`` has is not read again, and is one that the answer depends on all the same."""
    file = tmp_path / "file"
    file.write_text("1")
    ask, seen = Asked(file), dict[str, str]()
    for _ in range(3):
        noting, read = DISK.noting()
        assert with_files_read("one", ask, seen, noting) == ["1"]
        assert str(file) in read
        later_run()
    assert ask.count == 1


def test_who_notes_inside_of_another_note_notes_for_both(tmp_path: Path) -> None:
    """Reads of the outer files are none of the inner notes, also while nothing was read yet."""
    first, second = tmp_path / "first", tmp_path / "second"
    for file in (first, second):
        file.write_text("1")
    outer_files, outer = DISK.noting()
    inner_files, inner = outer_files.noting()
    outer_files.read_text(str(first), Report())
    assert inner == {}
    inner_files.read_text(str(second), Report())
    assert (list(outer), list(inner)) == ([str(first), str(second)], [str(second)])


class Revision:
    """A tree with one file of tests."""

    folder = None

    def __init__(self, version: str, text: str) -> None:
        self.version, self.text, self.count = version, text, 0

    def holds(self, path: str) -> bool:
        return path == "test_it.py"

    def read(self, _path: str) -> bytes:
        self.count += 1
        return self.text.encode()

    def names(self, folder: str) -> tuple[str, ...] | None:
        return None if folder else ("test_it.py",)


MARKED = '@pytest.mark.requirement("FR-1.{}")\ndef test_it(): ...\n'


def shown(root: Path, tree: Revision) -> list[str]:
    tests = read_tests_below([str(root)], DISK.with_tree(str(root), tree), Report())
    later_run()
    return [test.shows for test in tests]


def test_the_tests_of_a_revision_are_read_once(tmp_path: Path) -> None:
    root = tmp_path / "HEAD~1:"
    first, other, unknown = (Revision(*each) for each in (("a", MARKED.format(1)), ("b", MARKED.format(2)), ("", "")))
    assert shown(root, first) == shown(root, first) == ["FR-1.1"]
    assert first.count == 1
    assert shown(root, other) == ["FR-1.2"]
    unknown.text = MARKED.format(3)
    assert shown(root, unknown) == ["FR-1.3"]
    unknown.text = MARKED.format(4)
    assert shown(root, unknown) == ["FR-1.4"]


def test_what_could_not_be_read_as_a_whole_is_not_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Git that ends on the way hands out nothing: next time it may."""
    tree = Revision("a", "")
    monkeypatch.setattr(marked_tests, "_read", lambda *_: setattr(tree, "version", "") or [])
    assert shown(tmp_path / "HEAD~1:", tree) == []
    monkeypatch.undo()
    monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache"))
    tree.version, tree.text = "a", MARKED.format(1)
    assert shown(tmp_path / "HEAD~1:", tree) == ["FR-1.1"]


def test_a_file_of_tests_is_read_again_where_it_differs(tmp_path: Path) -> None:
    file = tmp_path / "tests" / "test_it.py"
    file.parent.mkdir()
    for number in (1, 1, 2):
        file.write_text(MARKED.format(number))
        assert [test.shows for test in read_tests_below([str(file.parent)], DISK, Report())] == [f"FR-1.{number}"]
        later_run()


def test_a_later_run_knows_the_ids_of_all_rules_and_of_those_about_documents(monkeypatch: pytest.MonkeyPatch) -> None:
    parts = ("codegen.claims", "codegen")
    for part in parts:
        assert rule_ids(part) == tuple(rule_catalogue(part))
    later_run()
    known = [rule_ids(part) for part in parts]
    assert known == [tuple(rule_catalogue(part)) for part in parts]
    assert set(known[0]) < set(known[1])
    monkeypatch.setattr(catalogue, "tool_digest", lambda: "another")
    monkeypatch.setattr(catalogue, "rule_catalogue", lambda _: {"new-rule": None})
    assert rule_ids() == ("new-rule",)
