"""Every format says the same of every kind of comparison, and the exit code agrees with it."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest

from codegen.cli import main

XML = '<mavlink><messages><message id="7" name="M"><description>d</description>{}</message></messages></mavlink>'
FIELD = '<field type="{}" name="a" units="{}">{}</field>'

SIDES = {
    "none": FIELD.format("uint8_t", "m", "height"),
    "harmless": FIELD.format("uint8_t", "m", "Height."),
    "person": FIELD.format("uint8_t", "m/s", "height"),
    "breaking": FIELD.format("uint8_t", "cm", "height"),
    "errors": FIELD.format("uint88_t", "cm", "height") + FIELD.format("uint99_t", "m", "b").replace('"a"', '"b"'),
}
"""New versions of a message with one field, uint8_t in m."""

CODES = {"none": 0, "harmless": 0, "person": 1, "breaking": 1, "errors": 1}
"""The exit codes without further options."""


def levels_of_xml(out: str) -> list[str]:
    cases = ElementTree.fromstring(out).iter("testcase")  # noqa: S314  our own
    return [
        "error" if case.find("failure") is not None else "warning"
        for case in cases
        if case.get("classname") != "codegen"
    ]


LEVELS: dict[str, Callable[[str], list[str]]] = {
    "text": lambda out: re.findall(r"^\S+: (error|warning) ", out, re.MULTILINE),
    "json": lambda out: [
        *("error" for _ in json.loads(out)["errors"]),
        *(change["severity"] for change in json.loads(out)["changes"]),
    ],
    "github": lambda out: re.findall(r"^::(error|warning) ", out, re.MULTILINE),
    "sarif": lambda out: [result["level"] for result in json.loads(out)["runs"][0]["results"]],
    "junit": levels_of_xml,
    "gitlab": lambda out: [{"major": "error", "minor": "warning"}[issue["severity"]] for issue in json.loads(out)],
    "markdown": lambda out: [
        "error" if re.search(r"breaking\*\* ·|a person\*\* ·|^> - ", line) else "warning"
        for line in out.splitlines()
        if re.match(r"- |> - ", line)
    ],
    "html": lambda out: [
        *("error" for _ in re.findall(r"<p>[^\n]*new\.xml:\d+:\d+: ", re.sub("<wbr>", "", out))),
        *("error" if "-row" in row else "warning" for row in re.findall(r"<tr data-tags[^>]*>", out)),
    ],
}
"""The severities of all findings in a report of each format, as its readers see them."""


@pytest.fixture
def compared(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """The comparison of the message with one of ``SIDES``."""

    def command(side: str, form: str, *more: str) -> tuple[int, str, str]:
        (tmp_path / "old.xml").write_text(XML.format(SIDES["none"]))
        (tmp_path / "new.xml").write_text(XML.format(SIDES[side]))
        code = main(["diff", str(tmp_path / "old.xml"), str(tmp_path / "new.xml"), "--format", form, *more])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return command


@pytest.mark.parametrize("form", LEVELS)
@pytest.mark.parametrize("side", SIDES)
def test_findings_and_exit_code_agree(side: str, form: str, compared: Callable[..., tuple[int, str, str]]) -> None:
    code, out, err = compared(side, form)
    assert code == CODES[side]
    levels = LEVELS[form](out + err if form == "text" else out) if out or form == "text" else []
    expected = {"none": [], "harmless": ["warning"], "person": ["error"], "breaking": ["error"]}.get(side)
    if expected is not None:
        assert levels == expected
    else:
        assert levels.count("error") >= 2
        said = re.sub("<[^>]*>", "", (err if form == "text" else out).replace("\\", ""))
        assert "uint88_t" in said
        assert "uint99_t" in said


@pytest.mark.parametrize("form", LEVELS)
def test_what_never_fails_says_why_it_does(form: str, compared: Callable[..., tuple[int, str, str]]) -> None:
    """A side with errors may hide anything; only who says so passes over it."""
    for side in SIDES:
        code, _, err = compared(side, form, "--fail-on", "never")
        assert code == (1 if side == "errors" else 0)
        assert ("the exit code is 1, whatever --fail-on says: " in err) is (side == "errors")
    assert compared("errors", form, "--fail-on", "never", "--allow-errors")[0] == 0
