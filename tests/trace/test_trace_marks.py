"""Marks of tests with their criteria: every form that pytest knows, read without running anything."""

import shutil
from pathlib import Path

import pytest
from trace_project import Project

from codegen.cli import main
from codegen.decode.marked_tests import read_marked_tests
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.marked_tests import files_of_tests

FORMS = """
import pytest
from pytest import mark

pytestmark = [pytest.mark.slow, pytest.mark.requirement("A-1.1")]


@mark.requirement("A-1.2", "A-1.3")
async def test_decorated(): ...


@pytest.mark.parametrize("n", [pytest.param(1, marks=mark.requirement("A-1.4")), 2])
def test_single_parameter(n): ...


@pytest.mark.requirement(*NAMES, "A-1." + "5", 7, other="A-1.6")
def test_computed(): ...


@pytest.mark.requirement("A-1.7")
def helper(): ...


@pytest.mark.requirement("A-1.8")
class TestGroup:
    @pytest.mark.requirement("A-1.9")
    def test_method(self): ...

    class TestInner:
        pytestmark = pytest.mark.requirement("A-1.10")

        def test_deep(self): ...


class Group:
    @pytest.mark.requirement("A-1.11")
    def test_not_collected(self): ...
"""


def found(text: str, folder: Path) -> list[tuple[str, str]]:
    path = folder / "test_it.py"
    path.write_text(text)
    report = Report()
    tests = read_marked_tests(str(path), DISK, report)
    assert list(report) == []
    lines = text.splitlines()
    for test in tests:
        assert lines[test.place.line - 1][test.place.column - 1 :].startswith(f'"{test.shows}"')
    return [(test.function, test.shows) for test in tests]


def test_every_form(tmp_path: Path) -> None:
    """Of the module, of a function, of one parameter, of a class and what is in it; what is computed is left out."""
    assert found(FORMS, tmp_path) == [
        ("test_decorated", "A-1.1"),
        ("test_decorated", "A-1.2"),
        ("test_decorated", "A-1.3"),
        ("test_single_parameter", "A-1.1"),
        ("test_single_parameter", "A-1.4"),
        ("test_computed", "A-1.1"),
        ("TestGroup::test_method", "A-1.1"),
        ("TestGroup::test_method", "A-1.8"),
        ("TestGroup::test_method", "A-1.9"),
        ("TestGroup::TestInner::test_deep", "A-1.1"),
        ("TestGroup::TestInner::test_deep", "A-1.8"),
        ("TestGroup::TestInner::test_deep", "A-1.10"),
    ]


CLASSES = """
import unittest
from unittest import TestCase
import other


@mark.requirement("A-1.1")
class Base:
    pytestmark = mark.requirement("A-1.2")

    @mark.requirement("A-1.3")
    def test_inherited(self): ...

    @mark.requirement("A-1.4")
    def test_overridden(self): ...

    class TestInner:
        @mark.requirement("A-1.5")
        def test_deep(self): ...


class TestOne(Base):
    def test_overridden(self): ...


class Group(unittest.TestCase):
    @mark.requirement("A-1.6")
    def test_of_unittest(self): ...


class Further(Group, TestCase):
    @mark.requirement("A-1.7")
    def test_more(self): ...


class TestLoop(TestLoop, other.Base):
    @mark.requirement("A-1.8")
    def test_loop(self): ...
"""


def test_classes_inherit_tests_and_those_of_unittest_have_any_name(tmp_path: Path) -> None:
    """Pytest collects them so: under the name of the class that inherits, with the marks of its bases."""
    assert found(CLASSES, tmp_path) == [
        ("TestOne::test_overridden", "A-1.1"),
        ("TestOne::test_overridden", "A-1.2"),
        ("TestOne::test_inherited", "A-1.1"),
        ("TestOne::test_inherited", "A-1.2"),
        ("TestOne::test_inherited", "A-1.3"),
        ("TestOne::TestInner::test_deep", "A-1.1"),
        ("TestOne::TestInner::test_deep", "A-1.2"),
        ("TestOne::TestInner::test_deep", "A-1.5"),
        ("Group::test_of_unittest", "A-1.6"),
        ("Further::test_more", "A-1.7"),
        ("Further::test_of_unittest", "A-1.6"),
        ("TestLoop::test_loop", "A-1.8"),
    ]


@pytest.mark.parametrize(
    "data",
    [
        b"@x.requirement('A')\ndef test_(:\n",
        b"@x.requirement('A')\ndef test_(a, a): ...",
        b"return x.requirement(1)",
        b"x.requirement(\xff)",
        b"x.requirement(\0)",
        b"x.requirement(" * 500,
    ],
)
def test_a_file_that_is_no_python_is_a_warning(data: bytes, tmp_path: Path) -> None:
    path = tmp_path / "test_it.py"
    path.write_bytes(data)
    report = Report()
    assert read_marked_tests(str(path), DISK, report) == []
    assert [finding.rule.id for finding in report] == ["test-syntax"]
    assert report.exit_code == 0


def test_files_without_a_mark_are_not_parsed(tmp_path: Path) -> None:
    """Broken or not: they say nothing."""
    (tmp_path / "test_it.py").write_bytes(b"def (\xff")
    report = Report()
    assert read_marked_tests(str(tmp_path / "test_it.py"), DISK, report) == []
    assert list(report) == []


def test_a_folder_that_cannot_be_listed_is_none_without_tests(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulated, because the superuser may list everything."""

    def refuse(_folder: str) -> list[str]:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("os.listdir", refuse)
    report = Report()
    assert files_of_tests([str(tmp_path)], DISK, report) == []
    ((rule, place),) = [(finding.rule.id, finding.place.file) for finding in report]
    assert (rule, place) == ("file-not-readable", str(tmp_path))


def test_which_files_are_looked_at(tmp_path: Path) -> None:
    """Python files in the folders and below, each once, but nothing hidden and no caches; a folder may be missing."""
    for name in ("b/test_b.py", "test_a.py", ".hidden/test_c.py", "__pycache__/test_d.py", ".test_e.py", "notes.txt"):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.touch()
    folders = [str(tmp_path), str(tmp_path / "b"), str(tmp_path / "missing")]
    report = Report()
    assert [Path(path).name for path in files_of_tests(folders, DISK, report)] == ["test_b.py", "test_a.py"]
    assert list(report) == []


@pytest.mark.parametrize("command", ["check", "trace"])
def test_a_folder_that_the_project_names_and_that_is_not_there(
    command: str, project: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    """A misspelt one has no tests, and nothing else would say so; the default may be missing."""
    settings = Path(project.file)
    settings.write_text(settings.read_text() + "tests: [../nope, ../tests, ../tests/test_beat.py]\n")
    main([command, "--project", project.file])
    said = capsys.readouterr().out
    line = len(settings.read_text().splitlines())
    found = [each for each in said.splitlines() if "no-folder-of-tests" in each]
    assert found == [
        f"specs/codegen.yaml:{line}:{column}: warning no-folder-of-tests: there is no folder {name}"
        for column, name in ((9, "../nope"), (28, "../tests/test_beat.py"))
    ]
    settings.write_text(settings.read_text().replace("tests: [", "# tests: ["))
    shutil.rmtree(project.tests.parent)
    main([command, "--project", project.file])
    assert "no-folder-of-tests" not in capsys.readouterr().out
