"""Archives that are damaged or hostile: each is read as far as it is a release, or said to be none."""

import io
import tarfile
import zipfile
from pathlib import Path

import pytest

from codegen.cli import main

XML = (
    '<mavlink><messages><message id="7" name="M"><description>d</description>'
    '<field type="uint8_t" name="a">d</field></message></messages></mavlink>'
)
INSIDE = "pymavlink/dialects/v20/common.xml"


def zipped(file: Path, *names: str, method: int = zipfile.ZIP_DEFLATED) -> Path:
    with zipfile.ZipFile(file, "w", method) as archive:
        for name in names:
            archive.writestr(name, XML)
    return file


def compared(base: Path, head: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    code = main(["diff", str(base), str(head)])
    captured = capsys.readouterr()
    return code, captured.out, captured.err


@pytest.mark.parametrize("name", [f"/{INSIDE}", f"../../{INSIDE}", f"a/../../{INSIDE}"])
def test_what_lies_outside_of_an_archive_is_not_read(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Neither from the disk, where such a name points, nor for ever."""
    good = zipped(tmp_path / "good.whl", INSIDE)
    bad = zipped(tmp_path / "bad.whl", name)
    with tarfile.open(tmp_path / "bad.tar.gz", "w:gz") as archive:
        member = tarfile.TarInfo(name)
        member.size = len(XML)
        archive.addfile(member, io.BytesIO(XML.encode()))
    for file in (bad, tmp_path / "bad.tar.gz"):
        code, out, err = compared(file, good, capsys)
        assert (code, out) == (2, "")
        assert err == f"codegen diff: {file} holds neither a project nor the dialects of a pymavlink\n"
    both = zipped(tmp_path / "both.whl", INSIDE, name)
    assert compared(both, good, capsys) == (0, "", "")


@pytest.mark.parametrize("method", [zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_every_damage_is_told(method: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good = zipped(tmp_path / "good.whl", INSIDE, method=method)
    assert compared(good, good, capsys) == (0, "", "")
    content = bytearray(good.read_bytes())
    for index in range(80, 110):
        content[index] ^= 0x55
    bad = tmp_path / "bad.whl"
    bad.write_bytes(content)
    assert compared(bad, good, capsys) == (2, "", "codegen diff: bad.whl is no archive that can be read\n")


def test_links_of_an_archive_lead_nowhere(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "links.tar.gz"
    with tarfile.open(file, "w:gz") as archive:
        for kind, name in ((tarfile.SYMTYPE, INSIDE), (tarfile.LNKTYPE, INSIDE.replace("common", "minimal"))):
            member = tarfile.TarInfo(f"p/{name}")
            member.type, member.linkname = kind, "/etc/hostname"
            archive.addfile(member)
    code, _, err = compared(file, file, capsys)
    assert (code, "holds neither" in err) == (2, True)
