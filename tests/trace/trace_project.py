"""A small project for the trace: one message, four criteria, one file of tests by hand."""

from dataclasses import dataclass
from pathlib import Path

from codegen.cli import main
from codegen.commands.trace import read_trace
from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_systems
from codegen.trace.graph import Trace

MINIMAL = Path(__file__).resolve().parents[1] / "projects" / "minimal" / "specs"

DOCUMENT = """# FR-1 | A heartbeat

## Metadata

- Status: Draft
- Aliases: FR-old

## Acceptance Criteria

1. It beats once a second.
2. Its `custom_mode` is **7**, which
   nobody reads.
3. It is heard at 10 m.
4. Nobody has written a test for this.

## What a host cannot show

- Criteria 3 and 4: the radio. On the bench, walk 10 m.
"""

TEST = """import pytest


@pytest.mark.requirement("FR-1.1", "FR-old.3")
@pytest.mark.parametrize("n", [1, 2])
def test_beats(n):
    assert n < 3


class TestMode:
    pytestmark = pytest.mark.requirement("FR-1.2")

    def test_seven(self):
        pass
"""


@dataclass(frozen=True)
class Project:
    """A project in a folder of its own."""

    folder: Path

    @property
    def file(self) -> str:
        """The path of codegen.yaml."""
        return str(self.folder / "specs" / "codegen.yaml")

    @property
    def lock(self) -> Path:
        """The lock file."""
        return self.folder / "specs" / "trace.lock.yaml"

    @property
    def document(self) -> Path:
        """The one document."""
        return self.folder / "specs" / "requirements" / "FR-1.md"

    @property
    def tests(self) -> Path:
        """The tests by hand."""
        return self.folder / "tests" / "test_beat.py"

    def trace(self) -> tuple[Trace, tuple[System, ...]]:
        """The graph, and what it was made of."""
        report = Report()
        systems = read_systems(self.file, report)
        assert not report.has_errors, [found.message for found in report]
        return read_trace(systems, report), systems

    def run(self, *arguments: str) -> int:
        """The exit code of codegen trace."""
        return main(["trace", "--project", self.file, *arguments])

    def change(self, old: str, new: str) -> None:
        """Edit the document."""
        text = self.document.read_text()
        assert text.count(old) == 1
        self.document.write_text(text.replace(old, new))
