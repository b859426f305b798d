"""The tests of a project that say what they show, read once: while a file is as it was, so are the marks in it."""

from collections.abc import Sequence
from typing import cast

from codegen.decode.decoded import decoded
from codegen.diagnostics import Report
from codegen.load.files import Files
from codegen.load.marked_tests import files_of_tests, has_marks, marked_tests
from codegen.model.test_record import MarkedTest
from codegen.tool.cache import entry, keep_object, kept_object
from codegen.tool.digest import tool_digest


def read_tests_below(folders: Sequence[str], files: Files, report: Report) -> list[MarkedTest]:
    """The marked tests of the files in folders (absolute paths) and below; a finding is about a file that says nothing.

    Of a revision, whose files never change, an earlier run may have read all.
    """
    versions = [files.version_of(folder) for folder in folders]
    if not versions or not all(versions):
        return _read(folders, files, report)
    name = entry("tests", tool_digest(), *versions, *folders)
    known = kept_object(name)
    if known is not None:
        return cast(list[MarkedTest], known)
    found = Report()
    tests = _read(folders, files, found)
    report.extend(found)
    if not list(found) and versions == [files.version_of(folder) for folder in folders]:
        keep_object(name, tests)
    return tests


def _read(folders: Sequence[str], files: Files, report: Report) -> list[MarkedTest]:
    paths = files_of_tests(folders, files, report)
    return [test for path in paths for test in read_marked_tests(path, files, report)]


def read_marked_tests(path: str, files: Files, report: Report) -> list[MarkedTest]:
    """The tests of a file that are marked; a file that cannot be read has none, after a finding where it has marks."""
    data = files.read_bytes(path, Report())
    if data is None or not has_marks(data):
        return []
    return decoded("marked tests", data, path, lambda found: marked_tests(data, path, found), report) or []
