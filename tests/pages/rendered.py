"""The pages of the shipped programs and of the test projects, with the systems that they show."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from lxml import html

from codegen.commands.build import render_systems
from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_systems

ROOT = Path(__file__).parents[2]
PROJECTS = {
    "shipped": ROOT / "specs",
    **{name: ROOT / "tests/projects" / name / "specs" for name in ("minimal", "radio_rover", "two_batteries")},
}


@dataclass(frozen=True)
class Program:
    """A program with its documents, by their paths below the output folder of its project."""

    system: System
    documents: Mapping[str, str]
    folder: str

    @property
    def pages(self) -> dict[str, str]:
        """The documents that browsers open."""
        return {path: text for path, text in self.documents.items() if path.endswith(".html")}

    def page(self, name: str) -> html.HtmlElement:
        """A page as a tree, by its path below docs/."""
        return html.document_fromstring(unbroken(self.pages[str(PurePosixPath(self.folder) / "docs" / name)]))


def unbroken(page: str) -> str:
    """A page without what says where its names may break and what stays whole: words as people read them."""
    return re.sub('<wbr>|<span class="whole">(.*?)</span>', r"\1", page)


def programs_of(folder: Path) -> list[Program]:
    """The programs of the project whose specification lies in a folder, each with what a build writes to its docs/."""
    report = Report()
    systems = read_systems(str(folder / "codegen.yaml"), report)
    assert not report.has_errors, [finding.message for finding in report]
    files = render_systems(systems).files
    return [
        Program(
            system,
            {path: text for path, text in files.items() if PurePosixPath(system.spec.program, "docs") in parents(path)},
            system.spec.program,
        )
        for system in systems
    ]


def parents(path: str) -> list[PurePosixPath]:
    """The folders that a file lies in, at any depth."""
    return list(PurePosixPath(path).parents)
