"""ADR-00018 lists what two documents state about batteries: each row is met by tests that exist, or answered."""

import ast
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from codegen.decode.requirement import decode_requirement
from codegen.diagnostics import Report
from codegen.load.markdown import parse_markdown

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "specs" / "requirements"
SUITE, COMMON = ROOT / "generated" / "tests", ROOT / "generated" / "common" / "tests"
DOCUMENT = FOLDER / "ADR-00018-battery-protocol-statements.md"

ROW = re.compile(r"\| (\d+) \| ((?:RFC|Page) \d.*?) \| (.+) \| (met|answered): (.+) \|")
TARGET = re.compile(r"(?m)^\[([\w.-]+)\]: (\S+)$")
NAME = re.compile(r"\[([\w.-]+)\](?![(:])")
CRITERION = re.compile(r"\bN?FR-\d{5}(?:\.\d+)?")


def faults(text: str) -> Iterator[str]:
    """Yield the faults of the document, in words."""
    body, targets = TARGET.sub("", text), dict(TARGET.findall(text))
    tables = [line for line in body.split("## Statements")[1].splitlines() if re.match(r"\| \d", line)]
    rows = [found for line in tables if (found := ROW.fullmatch(line))]
    for line in tables:
        if not ROW.fullmatch(line):
            yield f"neither met nor answered: {line}"
    for number, row in enumerate(rows, 1):
        if row[1] != str(number):
            yield f"not numbered on: {row[1]}"
        if row[4] == "met" and not (CRITERION.search(row[5]) and NAME.search(row[5])):
            yield f"met by nothing: {row[1]}"
        if row[4] == "answered" and len(CRITERION.sub("", NAME.sub("", row[5])).split()) < 3:
            yield f"no reason: {row[1]}"
    yield from (f"no such row: {number}" for number in re.findall(r"\brow (\d+)", body) if int(number) > len(rows))
    cited = {criterion for row in rows for criterion in CRITERION.findall(row[0])}
    yield from (f"no such criterion: {criterion}" for criterion in sorted(cited - criteria_of_documents()))
    names = {name for row in rows for name in NAME.findall(row[0])}
    yield from (f"no file for {name}" for name in sorted(names - targets.keys()))
    yield from (f"named nowhere: {name}" for name in sorted(targets.keys() - names))
    for name in sorted(names & targets.keys()):
        if not has(targets[name], name):
            yield f"{targets[name]} has no {name}"
    counts = f"{sum(row[4] == 'answered' for row in rows)} of {len(rows)} rows"
    if counts not in body:
        yield f"not counted: {counts}"


@cache
def criteria_of_documents() -> frozenset[str]:
    """Ids of all documents, and their criteria as FR-00072.4."""
    found = set()
    for path in FOLDER.glob("*.md"):
        requirement = decode_requirement(parse_markdown(path.read_text(), str(path)), Report())
        assert requirement is not None
        found |= {requirement.id} | {f"{requirement.id}.{criterion.number}" for criterion in requirement.criteria}
    return frozenset(found)


def has(target: str, name: str) -> bool:
    """Return whether a file has a test, a check that some test runs, or a case of the generated suite of that name."""
    path = (FOLDER / target).resolve()
    if not path.is_file():
        return False
    if path.suffix == ".json":
        return any(case["name"] == name for case in json.loads(path.read_text())["messages"])
    module = ast.parse(path.read_text())
    if path.name.startswith("test_"):
        return name.startswith("test_") and any(getattr(node, "name", None) == name for node in module.body)
    lists = [node for node in module.body if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "CHECKS"]
    run = {node.id for listed in lists for node in ast.walk(listed) if isinstance(node, ast.Name)}
    folders = [path.parent, *([SUITE] if path.parent == COMMON else [])]
    callers = "\n".join(caller.read_text() for folder in folders for caller in folder.glob("test_*.py"))
    is_run = f'"{path.name}"' in callers or (path.name.endswith("_checks.py") and '*_checks.py"' in callers)
    return is_run and name in run


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")
def test_each_statement_is_met_or_answered() -> None:
    """Rows, criteria and tests hold together; see the other test for what would be found."""
    assert list(faults(DOCUMENT.read_text())) == []


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")
def test_the_tests_that_are_named_are_collected() -> None:
    """pytest itself says so."""
    named = {(FOLDER / target).resolve().relative_to(ROOT): name for name, target in targets_of_tests()}
    command = [sys.executable, "-m", "pytest", "--collect-only", "-p", "no:cacheprovider", "-p", "no:xdist"]
    done = subprocess.run([*command, *map(str, named)], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-3000:]
    collected = {line.partition("[")[0] for line in done.stdout.splitlines()}
    wanted = {f"{(FOLDER / target).resolve().relative_to(ROOT)}::{name}" for name, target in targets_of_tests()}
    assert wanted
    assert wanted <= collected, wanted - collected


def targets_of_tests() -> list[tuple[str, str]]:
    """The names of tests, as against checks and cases, and where they are."""
    return [found for found in TARGET.findall(DOCUMENT.read_text()) if "/test_" in found[1]]


@pytest.mark.parametrize(
    ("old", "new", "found"),
    [
        ("| answered: nothing is stated. |", "| we shall see. |", "neither met nor answered: "),
        ("| answered: nothing is stated. |", "| met: nothing is stated. |", "met by nothing: "),
        ("| answered: nothing is stated. |", "| answered: no. |", "no reason: "),
        ("| answered: nothing is stated. |", "| answered: see row 999 of this. |", "no such row: 999"),
        ("| 2 | RFC 15", "| 3 | RFC 15", "not numbered on: 3"),
        ("met: FR-00072.1, [test_layout], ", "met: FR-00072.77, [test_layout], ", "no such criterion: FR-00072.77"),
        ("[test_layout]: ../../tests/", "[test_layout]: ../../test/", "test_overlay_frames.py has no test_layout"),
        ("[told_besides]", "[told_always]", "generated/common/tests/announcement_checks.py has no told_always"),
        ("[systems_are_apart], ", "", "named nowhere: systems_are_apart"),
        ("[told_besides]: ", "[told_never]: ", "no file for told_besides"),
        ("[SYS_STATUS.current_battery-unknown]", "[SYS_STATUS.current-unknown]", "has no SYS_STATUS.current-unknown"),
        (" rows are answered", " of them are answered", "not counted: "),
    ],
)
def test_what_would_be_found(old: str, new: str, found: str) -> None:
    """A row without an answer, names that do not exist, criteria that no test shows."""
    text = DOCUMENT.read_text()
    assert old in text
    assert any(found in fault for fault in faults(text.replace(old, new))), list(faults(text.replace(old, new)))
