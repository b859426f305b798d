"""A checkout of git under Windows, with CRLF, is the same specification and the same output."""

import codecs
from pathlib import Path

import pytest
from as_written import compiled_as_written
from in_process import codegen

TEXT = {".py", ".yaml", ".xml", ".md", ".json", ".html"}


def check_out_with_crlf(folder: Path) -> int:
    """Give each text below a folder the line ends of Windows; how many there are."""
    paths = [path for path in folder.rglob("*") if path.suffix in TEXT and path.is_file()]
    for path in paths:
        path.write_bytes(b"\r\n".join(path.read_bytes().splitlines()) + b"\r\n")
    return len(paths)


@pytest.fixture
def boat(tmp_path: Path) -> Path:
    """A project with a document, a dialect of its own and tables, as it was built."""
    assert codegen(tmp_path, "init").returncode == 0
    (tmp_path / "own.xml").write_text("<mavlink>\n  <include>common.xml</include>\n</mavlink>\n")
    project = tmp_path / "specs" / "codegen.yaml"
    project.write_text(project.read_text().replace("dialect: common", "dialect: ../own.xml"))
    assert codegen(tmp_path, "build").returncode == 0
    return tmp_path


def test_a_checkout_with_crlf_is_neither_edited_nor_stale(boat: Path) -> None:
    """Alike whether specification, output, or both have CRLF; what was edited by hand in such a file is found."""
    assert check_out_with_crlf(boat / "specs") > 8
    (boat / "own.xml").write_bytes((boat / "own.xml").read_bytes().replace(b"\n", b"\r\n"))
    for _ in range(2):
        checked = codegen(boat, "build", "--check")
        assert (checked.returncode, checked.stdout) == (0, "")
        assert check_out_with_crlf(boat / "generated") > 40
    state = boat / "generated/firmware/state.py"
    content = state.read_bytes()
    assert b"\r\n" in content
    built = codegen(boat, "build")
    assert (built.returncode, built.stdout, state.read_bytes()) == (0, "", content)
    # A change of the specification replaces what belongs to it, and is not stopped by the rest.
    table = boat / "specs/messages/level.yaml"
    table.write_bytes(table.read_bytes().replace(b"constant: LEVEL", b"constant: TANK"))
    assert codegen(boat, "build").returncode == 0
    state.write_bytes(content + b"# mine\r\n")
    assert "edited-by-hand" in codegen(boat, "build").stdout


def test_a_byte_order_mark_makes_nothing_stale(boat: Path) -> None:
    """Some editors of Windows write one at the beginning of each text: of YAML, of documents, and of dialects."""
    paths = [path for path in (*(boat / "specs").rglob("*"), boat / "own.xml") if path.suffix in TEXT]
    assert {path.suffix for path in paths} == {".yaml", ".md", ".xml"}
    for path in paths:
        path.write_bytes(codecs.BOM_UTF8 + path.read_bytes())
    checked = codegen(boat, "build", "--check")
    assert (checked.returncode, checked.stdout) == (0, "")
    assert codegen(boat, "check").returncode == 0


def test_compiled_files_are_compared_to_the_byte(boat: Path) -> None:
    """In machine code a CR is no line end."""
    with compiled_as_written():
        assert codegen(boat, "build", "--mpy", "armv6m").returncode == 0
        assert codegen(boat, "build", "--mpy", "armv6m", "--check").returncode == 0
        compiled = next(path for path in (boat / "build/armv6m").glob("*.mpy") if b"\n" in path.read_bytes())
        compiled.write_bytes(compiled.read_bytes().replace(b"\n", b"\r\n"))
        assert codegen(boat, "build", "--mpy", "armv6m", "--check").returncode == 1


def test_no_two_files_differ_only_in_their_case(boat: Path) -> None:
    """Windows and macOS would take them for one; nor is there a link, which git makes a text of there."""
    paths = [path for path in boat.rglob("*") if ".codegen" not in path.parts]
    assert len({str(path).casefold() for path in paths}) == len(paths)
    assert not any(path.is_symlink() for path in paths)
