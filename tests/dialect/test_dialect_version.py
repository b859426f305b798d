"""A project that states its release of pymavlink is told of another one, once, and how to see what differs."""

from importlib import metadata
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.load.files import DISK, Files
from codegen.load.shipped import dialects_in, shipped_dialect_path
from codegen.project.systems import read_systems

INSTALLED = f"pymavlink {metadata.version('pymavlink')}"


@pytest.fixture
def project(tmp_path: Path) -> Path:
    specs = Path(__file__).parents[1] / "projects" / "boat" / "specs"
    for path in specs.rglob("*.*"):
        copy = tmp_path / path.relative_to(specs)
        copy.parent.mkdir(exist_ok=True)
        copy.write_text(path.read_text())
    return tmp_path / "codegen.yaml"


def found(project: Path, stated: str, files: Files = DISK) -> list[tuple[str, str, str | None]]:
    """Return the findings; the project is read where there are none."""
    project.write_text(f"project: boat\ndialect: ardupilotmega\ndialect_version: {stated}\n")
    report = Report()
    systems = read_systems(str(project), report, files)
    assert bool(systems) is not report.has_errors
    return [(one.rule.id, one.message, one.hint) for one in report]


def test_the_release_that_is_stated_is_none_to_tell(project: Path) -> None:
    assert found(project, INSTALLED) == []


def test_another_release_is_one_finding(project: Path) -> None:
    """The consequences are not told beside it."""
    ((rule, message, hint),) = found(project, "pymavlink 2.4.49")
    assert rule == "other-dialect-version"
    assert message == f"{INSTALLED} is installed, not pymavlink 2.4.49"
    assert "pip download --no-deps pymavlink==2.4.49" in (hint or "")
    assert ".whl:ardupilotmega ardupilotmega" in (hint or "")
    assert f"dialect_version: {INSTALLED}" in (hint or "")
    assert "--base-pymavlink" in (hint or ""), "the review of the commit that states another release"


def test_a_release_that_is_given_is_compared_as_it_is(project: Path) -> None:
    """`codegen diff --base-pymavlink` reads the project with another release on purpose."""
    path = shipped_dialect_path("ardupilotmega", DISK)
    assert path is not None
    files = DISK.with_dialects(dialects_in(str(Path(path).parent), DISK, Report()))
    assert found(project, "pymavlink 2.4.49", files) == []
