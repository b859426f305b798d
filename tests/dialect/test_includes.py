"""The files of a dialect, their order, and the findings about those that cannot be read."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.decode.dialect.files import decode_dialect_files
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path
from codegen.source import Place

Write = Callable[..., str]


def including(*paths: str) -> str:
    return "<mavlink>\n" + "".join(f"  <include>{path}</include>\n" for path in paths) + "</mavlink>"


def read(path: str, asked_at: Place | None = None) -> tuple[list[str], list[str]]:
    """Names of the files in the order read, and the findings as 'file:line:col rule'."""
    report = Report()
    files = decode_dialect_files(path, DISK, report, asked_at)
    assert all(os.path.isabs(file.path) for file in files)
    findings = [f"{Path(one.place.file).name}:{one.place.line}:{one.place.column} {one.rule.id}" for one in report]
    return [Path(file.path).name for file in files], findings


def test_shipped_order() -> None:
    """Included files come first, over all levels."""
    path = shipped_dialect_path("common", DISK)
    assert path is not None
    assert read(path) == (["minimal.xml", "standard.xml", "common.xml"], [])


def test_a_diamond_is_read_once(write: Write) -> None:
    """Two ways to the same file, also when one is written differently, are one file."""
    write(including(), "deep/base.xml")
    write(including("deep/base.xml"), "left.xml")
    write(including("./deep/../deep/base.xml"), "right.xml")
    assert read(write(including("left.xml", "right.xml"))) == (["base.xml", "left.xml", "right.xml", "d.xml"], [])


def test_a_link_is_the_file_that_it_leads_to(write: Write, tmp_path: Path) -> None:
    """Otherwise its messages would be there twice."""
    write(including(), "base.xml")
    (tmp_path / "link.xml").symlink_to(tmp_path / "base.xml")
    assert read(write(including("base.xml", "link.xml"))) == (["base.xml", "d.xml"], [])


def test_paths_are_relative_to_the_including_file(write: Write) -> None:
    """Not to the first file and not to the working directory."""
    write(including(), "x/y/low.xml")
    write(including("y/low.xml"), "x/mid.xml")
    assert read(write(including("x/mid.xml"))) == (["low.xml", "mid.xml", "d.xml"], [])


def test_cycles_are_no_error(write: Write) -> None:
    """Each file is read once, so files that include each other, or themselves, come to an end."""
    write(including("d.xml", "b.xml"), "b.xml")
    assert read(write(including("b.xml", "d.xml"))) == (["b.xml", "d.xml"], [])


def test_missing_and_broken_includes(write: Write, tmp_path: Path) -> None:
    """Missing: reported at the <include>, and the other files are still read. Broken: reported inside the file."""
    (tmp_path / "folder.xml").mkdir()
    write("<mavlink>\n<oops</mavlink>", "broken.xml")
    write("<html/>", "other.xml")
    write(including("missing_too.xml"), "good.xml")
    includes = ("missing.xml", "folder.xml", "broken.xml", "good.xml", "http://example.invalid/x.xml", "other.xml")
    assert read(write(including(*includes))) == (
        ["good.xml", "other.xml", "d.xml"],
        [
            "broken.xml:2:6 xml-syntax",
            "d.xml:2:3 file-not-found",
            "d.xml:3:3 file-not-readable",
            "d.xml:6:3 file-not-found",
            "good.xml:2:3 file-not-found",
            "other.xml:1:1 dialect-root",
        ],
    )


def test_the_dialect_itself_is_missing(tmp_path: Path) -> None:
    """Reported where the configuration names it."""
    asked_at = Place(str(tmp_path / "codegen.yaml"), 3, 10)
    assert read(str(tmp_path / "none.xml"), asked_at) == ([], ["codegen.yaml:3:10 file-not-found"])


def test_known_files_are_not_read_again(write: Write) -> None:
    """An overlay may include what the dialect includes."""
    write(including(), "base.xml")
    report = Report()
    files = decode_dialect_files(write(including("base.xml")), DISK, report)
    overlay = decode_dialect_files(write(including("base.xml"), "overlay.xml"), DISK, report, known=files)
    assert [Path(file.path).name for file in overlay] == ["overlay.xml"]


def test_a_long_chain_of_includes(write: Write) -> None:
    """The depth of includes is not that of Python's stack."""
    for number in range(1200):
        write(including(f"{number + 1}.xml") if number < 1199 else including(), f"{number}.xml")
    names, findings = read(write(including("0.xml")))
    assert (len(names), names[0], names[-1], findings) == (1201, "1199.xml", "d.xml", [])


def test_a_name_with_a_nul_is_a_finding() -> None:
    """No path may raise."""
    assert read("/tmp/a\0b.xml", Place("/c.yaml"))[1] == ["c.yaml:1:1 file-not-readable"]  # noqa: S108


def test_shipped_dialects_by_name() -> None:
    """Names are those of the XML files; what is not shipped has no path."""
    assert list(shipped_dialect_names(DISK)) == sorted(shipped_dialect_names(DISK))
    assert all(os.path.isfile(shipped_dialect_path(name, DISK) or "") for name in shipped_dialect_names(DISK))
    assert shipped_dialect_path("commn", DISK) is None
    assert shipped_dialect_path("../v20/common", DISK) is None


def test_finding_the_shipped_dialects_does_not_import_pymavlink() -> None:
    """Importing it takes longer than reading the XML, and the generator must not depend on its code."""
    program = (
        "import sys; from codegen.load.files import DISK; from codegen.load.shipped import shipped_dialect_path; "
        "assert shipped_dialect_path('common', DISK); "
        "assert not [name for name in sys.modules if name.startswith('pymavlink')]"
    )
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


@pytest.mark.parametrize("name", shipped_dialect_names(DISK))
def test_every_place_in_a_shipped_dialect_is_its_opening_tag(name: str) -> None:
    """Line and column of messages, fields, enums and entries, held against the text of the file."""
    path = shipped_dialect_path(name, DISK)
    assert path is not None
    for file in decode_dialect_files(path, DISK, Report()):
        lines = Path(file.path).read_text(encoding="utf-8").split("\n")
        definitions = [
            *(("message", message) for message in file.messages),
            *(("field", field) for message in file.messages for field in message.fields),
            *(("enum", enum) for enum in file.enums),
            *(("entry", entry) for enum in file.enums for entry in enum.entries),
        ]
        for tag, definition in definitions:
            opened = lines[definition.place.line - 1][definition.place.column - 1 :]
            assert opened.startswith(f"<{tag} "), definition.place
            assert f'name="{definition.name}"' in opened, definition.place


def test_a_file_that_is_read_again(write: Write) -> None:
    """It is reported again, with its place; and what changed in it counts, though it is as long as before."""
    path = write("<mavlink>\n  <version>x</version>\n</mavlink>")
    assert read(path) == read(path) == (["d.xml"], ["d.xml:2:3 dialect-version"])
    write("<mavlink>\n  <version>3</version>\n</mavlink>")
    assert read(path) == (["d.xml"], [])


def test_what_does_not_lie_beside_is_what_pymavlink_ships(write: Write) -> None:
    """A dialect of one's own needs no copy of common.xml; one that is there is the one that is meant."""
    path = write(including("common.xml"), "mine.xml")
    assert read(path) == (["minimal.xml", "standard.xml", "common.xml", "mine.xml"], [])
    files, noted = DISK.noting()
    decode_dialect_files(path, files, Report())
    beside = os.path.join(os.path.dirname(path), "common.xml")
    assert noted[beside] == ""  # what is kept for later runs holds only while there is none
    write(including(), "common.xml")
    assert read(path) == (["common.xml", "mine.xml"], [])
    assert read(write(including("comon.xml", "sub/common.xml"), "other.xml"))[1] == [
        "other.xml:2:3 file-not-found",
        "other.xml:3:3 file-not-found",
    ]


@pytest.mark.parametrize(
    "command", [("codec", "--dialect", "a.xml", "--messages", "all", "--out", "m"), ("diff", "a.xml", "common")]
)
@pytest.mark.parametrize("included", ["{}/passwd", "../passwd"])
def test_a_dialect_alone_includes_nothing_from_elsewhere(command, included, tmp_path, monkeypatch, capsys):
    """It may be somebody else's: what lies outside of its folder and the working directory is not read, nor quoted."""
    (tmp_path / "passwd").write_text("<mavlink><secret></mavlink>")
    folder = tmp_path / "here"
    folder.mkdir()
    (folder / "a.xml").write_text(f"<mavlink><include>{included.format(tmp_path)}</include></mavlink>")
    monkeypatch.chdir(folder)
    assert main(list(command)) in (1, 2)
    out = "".join(capsys.readouterr())
    assert "a.xml:1:10: error outside-project: " in out
    assert "secret" not in out


@pytest.mark.parametrize(
    ("included", "message", "hint"),
    [
        ("Minimal.xml", "Minimal.xml does not exist", "did you mean minimal.xml?"),
        ("comon.xml", "comon.xml does not exist", "did you mean common.xml"),
        ("https://x.org/a.xml", "https://x.org/a.xml is an address", "keep a copy beside this file"),
        ("my_own_things.xml", "my_own_things.xml does not exist", ""),
    ],
)
def test_what_may_be_meant_is_told(write: Write, included: str, message: str, hint: str) -> None:
    """A shipped dialect by nearly its name, and an address, of which only the end looked like a file's."""
    report = Report()
    decode_dialect_files(write(including(included)), DISK, report)
    (found,) = report
    assert message in found.message
    assert bool(found.hint) == bool(hint)
    assert hint in (found.hint or "")
