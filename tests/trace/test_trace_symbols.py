"""The graph names what is generated: symbols that the modules have, and tests that pytest collects."""

import ast
import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from generated_suite import ALONE

from codegen.commands.build import render_systems
from codegen.commands.trace import read_trace
from codegen.diagnostics import Report
from codegen.project.systems import read_systems
from codegen.trace.graph import Trace, reached

ROOT = Path(__file__).resolve().parents[2]
PROJECTS = [ROOT, *sorted((ROOT / "tests" / "projects").glob("*/"))]
PROJECTS = [folder for folder in PROJECTS if (folder / "specs").is_dir()]


@cache
def project(folder: Path) -> tuple[Trace, dict[str, str]]:
    """The graph of a project and what is generated for it."""
    report = Report()
    systems = read_systems(str(folder / "specs" / "codegen.yaml"), report)
    assert not report.has_errors
    output = render_systems(systems)
    return read_trace(systems, report, shared=output.shared), dict(output.files)


def names_of(text: str) -> set[str]:
    """Return the names that a module defines: functions, classes, constants, of classes methods and attributes of self.

    Also what it passes on from others, in the faster of two forms: what it imports of modules called so.
    """
    found = set()
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            found.add(node.name)
        if isinstance(node, ast.Assign):
            found |= {target.id for target in node.targets if isinstance(target, ast.Name)}
        for part in node.body if isinstance(node, ast.Try) else (node,):
            if isinstance(part, ast.ImportFrom) and str(part.module).endswith(("_viper", "_plain")):
                found |= {each.name for each in part.names}
        if isinstance(node, ast.ClassDef):  # views of the state's words
            views = [each for each in node.body if isinstance(each, ast.Assign)]
            parts = [part for each in views for target in each.targets for part in ast.walk(target)]
            found |= {f"{node.name}.{part.id}" for part in parts if isinstance(part, ast.Name)}
            lines = [each.value for each in views if ast.unparse(each.targets[0]) == "VIEWS"]
            words = [word for line in lines for word in str(ast.literal_eval(line)).split()]
            found |= {f"{node.name}.{word.removesuffix(':')}" for word in words if word.endswith(":")}
        for inner in ast.walk(node) if isinstance(node, ast.ClassDef) else ():
            match inner:
                case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name):
                    found.add(f"{node.name}.{name}")
                case ast.Attribute(value=ast.Name(id="self"), attr=name, ctx=ast.Store()):
                    found.add(f"{node.name}.{name}")
    return found


@pytest.mark.parametrize("folder", PROJECTS, ids=lambda folder: folder.name)
def test_every_row_names_what_is_generated(folder: Path) -> None:
    """Names come from what generates them: one that is spelt otherwise there is missing here.

    What a table states comes out somewhere; what it cites exists, or the specification would not resolve.
    """
    trace, files = project(folder)
    known = {path: names_of(text) for path, text in files.items() if path.endswith(".py")}
    named = {symbol for row in trace.rows for symbol in row.symbols}
    assert named
    assert [symbol for symbol in sorted(named) if symbol.name not in known.get(symbol.file, ())] == []
    assert [row.label for row in trace.rows if not row.symbols] == []
    assert [row for row in trace.uncited if row.criterion] == []
    assert [row.label for row in trace.rows if trace.called(row.criterion) != row.criterion] == []


@pytest.mark.parametrize("folder", PROJECTS, ids=lambda folder: folder.name)
def test_every_generated_check_is_run(folder: Path) -> None:
    """A check that a script defines is in its CHECKS, or asked by others; pytest collects those called test."""
    scripts = {path: text for path, text in project(folder)[1].items() if "\nCHECKS = " in text}
    assert scripts
    for path, text in scripts.items():
        script = ast.parse(text)
        defined = {node.name for node in script.body if isinstance(node, ast.FunctionDef)}
        used = {node.id for node in ast.walk(script) if isinstance(node, ast.Name)}
        assert {name for name in defined - used if not name.startswith("test_")} == set(), path


def test_every_generated_test_is_collected() -> None:
    """pytest's own names, case by case; and what it collects beside them shows no criterion."""
    options = ["--collect-only", "-q", "-p", "no:cacheprovider", "-c", os.devnull, "--rootdir", "."]
    command = [sys.executable, "-m", "pytest", *options, "generated/tests"]
    done = subprocess.run(command, cwd=ROOT, env=ALONE, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    collected = {line for line in done.stdout.splitlines() if "::" in line}
    trace, _ = project(ROOT)
    tests = [test for test in trace.tests if test.file.startswith("generated/tests/")]
    cases = {f"{test.name}[{case}]" for test in tests for case in test.cases}
    cases |= {test.name for test in tests if not test.cases and f"{test.name}" in collected}
    functions = {test.name for test in tests if not test.cases}
    assert len(cases) > 1000
    assert cases - collected == set()
    assert functions - {name.partition("[")[0] for name in collected} == set()
    rest = {name for name in collected - cases if name.partition("[")[0] not in functions}
    shows = [name for name in rest if "FR-" in name and "test_every_field_is_expected" not in name]
    assert shows == []


def test_what_a_field_reaches() -> None:
    """The way of one field: its criterion, the builder and the state that it reads, the tests of its message."""
    found = reached(project(ROOT)[0], "BATTERY_STATUS.voltages")
    assert found.criteria == ("FR-00068.3",)
    symbols = set(map(str, found.symbols))
    assert {"firmware/telemetry.py: build_battery_status", "firmware/state.py: BatteryState.voltage_mv"} <= symbols
    assert "smart_battery/firmware/telemetry.py: build_battery_status" in symbols
    assert {test.about for test in found.tests} <= {"", "BATTERY_STATUS"}
    cases = [case for test in found.tests for case in test.cases]
    assert "cpython-BATTERY_STATUS.voltages-fallback-unknown-FR-00068.3" in cases


def test_a_message_reaches_what_its_fields_reach() -> None:
    trace = project(ROOT)[0]
    whole = reached(trace, "BATTERY_STATUS")
    for name in ("BATTERY_STATUS.voltages", "BATTERY_STATUS.id", "BATTERY_STATUS.current_battery"):
        part = reached(trace, name)
        assert set(part.criteria) <= set(whole.criteria)
        assert set(part.symbols) <= set(whole.symbols)
        assert set(part.tests) <= set(whole.tests)
    assert reached(trace, "BATTERY_STATU") == reached(trace, "")


def test_what_a_parameter_reaches() -> None:
    """Of a family every member; its tests are those of its criterion, whatever message they are about."""
    found = reached(project(ROOT)[0], "BATT_LOW_VOLT")
    assert [symbol.name for symbol in found.symbols] == ["Parameters.batt2_low_volt", "Parameters.batt_low_volt"]
    assert found.criteria == ("FR-00020.1",)
    assert any("low_after_the_timer" in case for test in found.tests for case in test.cases)
