"""The pages of the shipped programs and of the test projects, with the systems that they show."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from lxml import html

from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.pipeline import read_systems
from codegen.targets.documents import render_documents
from codegen.targets.pages import render_pages

ROOT = Path(__file__).parents[2]
PROJECTS = {
    "shipped": ROOT / "specs",
    **{name: ROOT / "tests/projects" / name / "specs" for name in ("minimal", "radio_rover", "two_batteries")},
}


@dataclass(frozen=True)
class Program:
    """A program with its files below the output folder of its project."""

    system: System
    pages: Mapping[str, str]
    folder: str

    def page(self, name: str) -> html.HtmlElement:
        """A page as a tree, by its path below docs/."""
        return html.document_fromstring(self.pages[str(PurePosixPath(self.folder) / "docs" / name)])


def programs_of(folder: Path) -> list[Program]:
    """The programs of the project whose specification lies in a folder."""
    report = Report()
    systems = read_systems(str(folder / "codegen.yaml"), report)
    assert not report.has_errors, [finding.message for finding in report]
    return [
        Program(
            system,
            {str(PurePosixPath(system.spec.program) / path): text for path, text in render_pages(system).items()},
            system.spec.program,
        )
        for system in systems
    ]


def site(program: Program) -> dict[str, str]:
    """The pages with the other files that they lead to."""
    documents = {
        str(PurePosixPath(program.folder) / path): text for path, text in render_documents(program.system).items()
    }
    return {**program.pages, **documents}
