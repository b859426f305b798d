"""Faults in access of vehicle.yaml are reported at their places, with the right text to write there."""

import re
import shutil
from pathlib import Path

import pytest

from codegen.cli import main

SPECS = Path(__file__).resolve().parents[1] / "projects" / "guarded" / "specs"
LINKS = "links: {wifi: signed, cable: open, radio: listed}"


@pytest.mark.parametrize(
    ("written", "instead", "message", "hint"),
    [
        (LINKS, "links: {wifi: signed, cable: open}", "nothing says who may command the vehicle over radio", "radio: "),
        (LINKS, "links: {wifj: open, wifi: signed, cable: open, radio: listed}", "has no link wifj", "mean wifi?"),
        (LINKS, "links: {wifi: sined, cable: open, radio: listed}", "sined", "signed"),
        ("stations: [255, 254]", "stations: []", "a link is listed, and no station is", "stations: [255]"),
        ("stations: [255, 254]", "stations: [0, 255]", "0 is not a system id", ""),
        (LINKS, "links: {wifi: signed, cable: open, radio: open}", "no link asks for them", "listed"),
        ("setup: [cable]", "setup: [wifi]", "a key that comes over wifi is known to all", ""),
        ("setup: [cable]", "setup: [radio]", "radio is not open", "links: {radio: open}"),
        ("setup: [cable]", "setup: [cabel]", "has no link cabel", "mean cable?"),
        (LINKS, "links: {wifi: open, cable: open, radio: listed}", "there is no use for a key", ""),
    ],
)
def test_is_said_at_its_place(
    written: str, instead: str, message: str, hint: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In vehicle.yaml, at the key that is wrong, by the rule bad-access or by that of the choices."""
    specs = Path(shutil.copytree(SPECS, tmp_path / "specs"))
    path = specs / "vehicle.yaml"
    text = path.read_text()
    assert written in text
    path.write_text(text.replace(written, instead))
    assert main(["check", "--project", str(specs / "codegen.yaml")]) == 1
    found = [line for line in capsys.readouterr().out.splitlines() if message in line or (hint and hint in line)]
    assert any(re.search(r"vehicle\.yaml:[5-8]:\d+: error", each) and message in each for each in found), found
    assert any(hint in each for each in found), found


def test_signatures_need_mavlink_2(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """MAVLink 1 has none."""
    specs = Path(shutil.copytree(SPECS, tmp_path / "specs"))
    (specs / "codegen.yaml").write_text("project: guarded\ndialect: common\nprotocol: 1\n")
    assert main(["check", "--project", str(specs / "codegen.yaml")]) == 1
    assert "bad-access: wifi cannot be signed" in capsys.readouterr().out


def test_what_is_not_used_is_not_generated(tmp_path: Path) -> None:
    """Without access, and with what is listed only, nothing that signs is there."""
    specs = Path(shutil.copytree(SPECS, tmp_path / "specs"))
    path = specs / "vehicle.yaml"
    text = path.read_text()
    head, _, rest = text.partition("access:\n")
    _, _, code = rest.partition("code:")
    for access, there in (
        ("", set()),
        ("access: {links: {wifi: listed, cable: open, radio: open}, stations: [9]}\n", {"listed_stations.py"}),
        ("access: {links: {wifi: signed, cable: open, radio: open}}\n", {"access.py", "signing.py"}),
    ):
        path.write_text(f"{head}{access}code:{code}")
        assert main(["build", "--project", str(specs / "codegen.yaml"), "--clean"]) == 0
        names = {each.name for each in (tmp_path / "generated" / "firmware").iterdir()}
        assert names & {"access.py", "signing.py", "listed_stations.py", "key_service.py"} == there
