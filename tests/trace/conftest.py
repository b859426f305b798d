"""A small project for the trace, and files of results."""

import shutil
from collections.abc import Callable
from pathlib import Path
from xml.sax.saxutils import quoteattr

import pytest
from trace_project import DOCUMENT, MINIMAL, TEST, Project


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Project:
    """The project, in the working directory."""
    shutil.copytree(MINIMAL, tmp_path / "specs")
    made = Project(tmp_path)
    made.document.write_text(DOCUMENT)
    table = tmp_path / "specs" / "messages" / "heartbeat.yaml"
    text = table.read_text().replace("requirement: FR-1\n", "requirement: FR-1.1\n")
    table.write_text(text.replace("{constant: 7}", "{constant: 7, requirement: FR-1.2}"))
    made.tests.parent.mkdir()
    made.tests.write_text(TEST)
    monkeypatch.chdir(tmp_path)
    return made


@pytest.fixture
def junit(tmp_path: Path) -> Callable[..., str]:
    """Write a file of results: cases are (module, name, outcome, criteria, inputs); the path of the file.

    With ``specification`` what was not made of any inputs says that it was run with that.
    """

    def write(
        name: str, *cases: tuple[str, str, str, tuple[str, ...], str | None], specification: str | None = None
    ) -> str:
        parts = ['<?xml version="1.0"?><testsuites><testsuite name="pytest">']
        for module, test, outcome, shows, inputs in cases:
            told = [("requirement", one) for one in shows] + ([("codegen-inputs", inputs)] if inputs else [])
            told += [("codegen-specification", specification)] if specification and not inputs else []
            properties = "".join(f"<property name={quoteattr(key)} value={quoteattr(one)}/>" for key, one in told)
            inside = "" if outcome == "passed" else f'<{outcome} message="m">long</{outcome}>'
            parts.append(f"<testcase classname={quoteattr(module)} name={quoteattr(test)} time='0.1'>")
            parts.append(f"{f'<properties>{properties}</properties>' if told else ''}{inside}</testcase>")
        path = tmp_path / name
        path.write_text("".join([*parts, "</testsuite></testsuites>"]))
        return str(path)

    return write
