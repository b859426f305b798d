"""An output folder, and a build of it as the command does one."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.emit.findings import report_refusals, report_strays
from codegen.emit.plan import Plan, plan_output
from codegen.emit.write import Outcome, write_output


@dataclass(frozen=True)
class Build:
    """The result of one build: ``rules`` are (rule id, path below the folder) of all findings, ordered by path."""

    report: Report
    plan: Plan | None
    outcome: Outcome | None
    folder: Path

    @property
    def rules(self) -> list[tuple[str, str]]:
        return [(found.rule.id, Path(found.place.file).relative_to(self.folder).as_posix()) for found in self.report]

    @property
    def code(self) -> int:
        return self.report.exit_code


Builder = Callable[..., Build]


@pytest.fixture
def output(tmp_path: Path) -> Path:
    """The output folder, not made yet."""
    return tmp_path / "generated"


@pytest.fixture
def build(output: Path) -> Builder:
    """Builds ``rendered`` into the output folder."""

    def run(rendered: Mapping[str, str], **flags: Any) -> Build:
        report = Report()
        outcome = None
        plan = plan_output(rendered, str(output), report, **flags)
        if plan is not None:
            report_refusals(plan, report)
            report_strays(plan, report)
            if not report.has_errors:
                outcome = write_output(plan, report)
        return Build(report, plan, outcome, output)

    return run


@pytest.fixture
def tree(output: Path) -> Callable[[], dict[str, bytes]]:
    """Reads the output folder: the content of every file by its path, the manifest aside."""

    def read() -> dict[str, bytes]:
        files = (path for path in sorted(output.rglob("*")) if path.is_file() and path.name != "manifest.json")
        return {path.relative_to(output).as_posix(): path.read_bytes() for path in files}

    return read
