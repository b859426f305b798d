"""Each fault that is left out of a score is one that can be drawn, where it is left out, and says why."""

from pathlib import Path

import equivalents
import pytest
import yaml
from equivalents import Fault, fault_of, faults_of, is_listed, listed
from mutants import mutants_of
from mutation import PROGRAMS, firmware_of
from results import ROOT

from codegen.commands.build import render_systems
from codegen.diagnostics import Report
from codegen.project.systems import read_systems

ENTRIES = yaml.safe_load(equivalents.LIST.read_text(encoding="utf-8"))


def faults(texts: dict[str, str]) -> set[Fault]:
    found = {fault for name, text in texts.items() for _, fault in faults_of(name, text)}
    return found | {fault._replace(within="") for fault in found}


@pytest.mark.parametrize("program", PROGRAMS)
def test_every_entry_of_a_firmware_is_a_fault_there(program: str) -> None:
    texts = firmware_of(program)
    assert {fault for fault in listed(texts, program) if fault.module in texts} <= faults(texts)


def test_every_form_of_a_line_is_that_of_a_fault() -> None:
    """In some firmware: not every program has all of them. That of the boat is not committed, and made for this."""
    systems = read_systems(str(ROOT / "examples" / "boat" / "specs" / "codegen.yaml"), Report())
    assert systems
    made = render_systems(systems).files
    boat = {Path(path).name: text for path, text in dict(made).items() if path.startswith("firmware/")}
    texts = [boat, *(firmware_of(program) for program in PROGRAMS if program != "boat")]
    forms = [entry for entry in ENTRIES if "like" in entry]
    assert [entry["like"] for entry in forms if not any(any(equivalents._alike(entry, each)) for each in texts)] == []


def test_a_form_is_about_the_only_line_below(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "equivalents.yaml"
    entry = {
        "module": "a.py",
        "like": r"if (\w+) < (\w+):",
        "body": r"\1 = \2",
        "old": "<",
        "new": "<=",
        "reason": "So.",
    }
    path.write_text(yaml.safe_dump([entry]))
    monkeypatch.setattr(equivalents, "LIST", path)
    limit, other = "if x < 1:\n    x = 1\n", "if y < 1:\n    y = 0\n"
    more = "if z < 1:\n    z = 1\n    x = 2\n"
    assert listed({"a.py": limit + other + more + "x = 0\n"}) == {Fault("a.py", "if x < 1:", "<", "<=")}
    assert listed({"b.py": limit + other}) == set()


def test_a_form_is_about_the_functions_that_it_names(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "equivalents.yaml"
    entry = {"module": "a.py", "like": ".*", "within": "f|A.g", "old": r"\d", "new": r"\d", "reason": "So."}
    path.write_text(yaml.safe_dump([entry]))
    monkeypatch.setattr(equivalents, "LIST", path)
    text = "x = 1\ndef f():\n    y = 2\ndef g():\n    y = 3\n"
    assert listed({"a.py": text}) == {Fault("a.py", "y = 2", "2", "3", "f")}


def test_every_entry_of_the_generator_is_a_fault_there() -> None:
    names = sorted({entry["module"] for entry in ENTRIES if "codegen/" in entry["module"]})
    known = faults({name: (ROOT / name).read_text(encoding="utf-8") for name in names})
    assert {fault for fault in listed({}) if "/" in fault.module} <= known


def test_an_entry_of_other_programs_does_not_count(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "equivalents.yaml"
    entry = {"module": "a.py", "line": "x = 1", "old": 1, "new": 2, "reason": "So it is."}
    path.write_text(yaml.safe_dump([entry, {**entry, "line": "y = 1", "programs": ["boat"]}]))
    monkeypatch.setattr(equivalents, "LIST", path)
    texts = {"a.py": "x = 1\n"}
    assert listed(texts, "rover") == {Fault("a.py", "x = 1", "1", "2")}
    with pytest.raises(SystemExit, match="y = 1"):
        listed(texts, "boat")


def test_an_entry_about_a_function_says_nothing_about_others() -> None:
    text = "def f():\n    x = 1\n\n\ndef g():\n    x = 1\n"
    in_f, in_g = (fault_of(mutant, text) for mutant in mutants_of("a.py", text))
    assert (in_f.within, in_g.within) == ("f", "g")
    assert [is_listed(each, {in_f}) for each in (in_f, in_g)] == [True, False]
    assert [is_listed(each, {in_f._replace(within="")}) for each in (in_f, in_g)] == [True, True]


def test_every_entry_has_a_reason() -> None:
    assert all(entry["reason"].endswith(".") and len(entry["reason"]) > 20 for entry in ENTRIES)
