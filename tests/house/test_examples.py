"""Files for other repositories: hooks and workflows name commands that exist, and ask for no more than they need."""

import re
import shlex
import subprocess
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import yaml

from codegen.cli.parser import parser_for
from codegen.model.quantities.divider import divider, ohms

ROOT = Path(__file__).parents[2]
WORKFLOWS = sorted((ROOT / "examples").glob("*.yml"))
HOOKS = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text())


def read(name: str) -> dict[Any, Any]:
    """A workflow; YAML 1.1 takes the key ``on`` for true."""
    found = yaml.safe_load((ROOT / "examples" / name).read_text())
    assert isinstance(found, dict)
    return found


def scripts(workflow: dict[Any, Any]) -> list[str]:
    return [step["run"] for job in workflow["jobs"].values() for step in job["steps"] if "run" in step]


def commands(text: str) -> list[list[str]]:
    """The arguments of every call of codegen in a shell script."""
    calls = re.findall(r"^\s*(?:- run: )?codegen ([^|>\n]*)", text, re.MULTILINE)
    return [shlex.split(call) for call in calls]


@pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
def test_hooks_run_commands_that_there_are(hook: dict[str, Any]) -> None:
    program, *argv = shlex.split(hook["entry"])
    assert program == "codegen"
    assert callable(parser_for(argv).parse_args(argv).run)
    assert hook["language"] == "python"
    assert hook["pass_filenames"] is False
    assert re.search(hook["files"], "specs/messages/heartbeat.yaml")
    assert re.search(hook["files"], "codegen.yaml")
    assert not re.search(hook["files"], "src/main.py")


def test_workflows_run_commands_that_there_are() -> None:
    found = [argv for path in WORKFLOWS for script in scripts(read(path.name)) for argv in commands(script)]
    found += commands((ROOT / "docs" / "other-repositories.md").read_text())
    assert {argv[0] for argv in found} == {"check", "build", "diff"}
    assert len(found) >= 7
    for argv in found:
        assert callable(parser_for(argv).parse_args(argv).run)


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.stem)
def test_scripts_are_shell(path: Path) -> None:
    for script in scripts(read(path.name)):
        assert subprocess.run(["bash", "-n"], input=script, text=True, check=False, timeout=20).returncode == 0


def test_what_a_fork_can_change_has_no_rights() -> None:
    review = read("specification-review.yml")
    assert set(review[True]) == {"pull_request"}
    assert review["permissions"] == {}
    assert review["jobs"]["review"]["permissions"] == {"contents": "read"}
    scanning = review["jobs"]["scanning"]
    assert "head.repo.full_name == github.repository" in scanning["if"]
    assert scanning["permissions"] == {"contents": "read", "security-events": "write"}
    checkouts = [
        step["with"] for job in review["jobs"].values() for step in job["steps"] if "checkout" in step.get("uses", "")
    ]
    assert all(options["persist-credentials"] is False for options in checkouts)
    assert any(options.get("fetch-depth") == 2 for options in checkouts), "HEAD^1 has to be there"


def test_what_has_rights_runs_nothing_of_a_fork() -> None:
    comment = read("specification-comment.yml")
    assert set(comment[True]) == {"workflow_run"}
    assert comment[True]["workflow_run"]["workflows"] == [read("specification-review.yml")["name"]]
    assert comment["permissions"] == {}
    assert comment["jobs"]["comment"]["permissions"] == {"actions": "read", "pull-requests": "write"}
    assert "checkout" not in str(comment)
    for path in WORKFLOWS:
        assert all("${{" not in script for script in scripts(read(path.name))), "names reach the shell as variables"


def test_dividers_of_the_rover_page_are_those_that_codegen_draws() -> None:
    """The table of docs/rover.md: resistors, multiplier and full scale by the number of cells."""
    rows = re.findall(
        r"^\| (\d) cells \| ([\d.]+) V \| (.*?) over (.*?) \| ([\d.]+) \| ([\d.]+) V \|$",
        (ROOT / "docs/rover.md").read_text(),
        re.MULTILINE,
    )
    assert [int(row[0]) for row in rows] == [3, 4]
    for cells, full, upper, lower, multiplier, shown in rows:
        found = divider(Fraction(multiplier))
        assert found is not None
        assert (ohms(found.upper), ohms(found.lower)) == (upper, lower)
        assert float(full) == pytest.approx(4.2 * int(cells))
        assert float(shown) == pytest.approx(3.3 * float(multiplier), abs=0.006)
        assert Fraction(full) / found.ratio < Fraction("3.3")
    assert f"BATT_VOLT_MULT: {rows[1][4]}" in (ROOT / "docs/rover.md").read_text()
