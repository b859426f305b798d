"""The command line in front of a pipeline whose findings and files a test decides."""

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace

import pytest

from codegen.cli import main
from codegen.commands import document_findings
from codegen.diagnostics import Report, Rule
from codegen.findings.catalogue import rule_catalogue
from codegen.source import Place
from codegen.targets.shared_files import Output


@dataclass
class Pipeline:
    """A stand-in for the pipeline; ``findings`` are (rule, line, message), ``fault`` is raised on reading."""

    folder: Path
    files: dict[str, str] = field(default_factory=lambda: {"a.py": "1\n", "b/b.py": "1\n"})
    findings: list[tuple[Rule, int, str]] = field(default_factory=list)
    fault: BaseException | None = None
    is_readable: bool = True
    projects: list[str] = field(default_factory=list)

    def __getattr__(self, name: str) -> Callable[..., None]:
        """Stand in for what commands import and these tests never call."""
        if name.startswith("__"):
            raise AttributeError(name)

        def called(*_arguments: object) -> None:
            raise AssertionError(f"{name} is called, for which nothing stands in")

        return called

    def read_systems(self, project_file: str, report: Report) -> tuple[SimpleNamespace, ...]:
        self.projects.append(project_file)
        if self.fault is not None:
            raise self.fault
        for rule, line, message in self.findings:
            report.add(rule, Place(project_file, line), message)
        return (SimpleNamespace(spec=SimpleNamespace(program="")),) if self.is_readable else ()

    def check_scenarios(self, _project_file: str, _system: object, _report: Report) -> None:
        """There are no scenarios."""

    def read_trace_lock(self, _project_file: str, _report: Report) -> None:
        """There is no lock file."""

    def render_systems(self, _systems: object) -> Output:
        return Output(self.files, {}, ())

    def files_read(self, _systems: object) -> set[str]:
        return set()

    def folders_read(self, _systems: object) -> list[str]:
        return []

    def what_is_made(self, _systems: object) -> list[str]:
        return []

    def output_folder(self, _system: object) -> str:
        return str(self.folder)


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project folder, which is the working directory."""
    (tmp_path / "specs").mkdir()
    (tmp_path / "specs" / "codegen.yaml").write_text("")
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CODEGEN_DEBUG", raising=False)
    return tmp_path


@pytest.fixture
def pipeline(project: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Pipeline]:
    """Stands in for what reads and renders; a catalogue of rules that was made meanwhile lacks the real ones."""
    fake = Pipeline(project / "generated")
    for part in ("project.systems", "commands.build", "commands.drift", "commands.trace"):
        monkeypatch.setitem(sys.modules, f"codegen.{part}", fake)
    monkeypatch.setattr(document_findings, "check_project_documents", lambda *_: [])  # nothing is claimed
    monkeypatch.setattr("codegen.emit.stamp.keep", lambda *_: None)  # what is rendered changes here without a file
    yield fake
    rule_catalogue.cache_clear()


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """Runs one command line: exit code, stdout and stderr."""

    def command(*argv: str) -> tuple[int, str, str]:
        code = main(list(argv))
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return command
