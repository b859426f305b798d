"""An attribute that the user's code sets is one that its component has: unknown-attribute."""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diagnostics import Report
from codegen.load.state_stores import Stored, state_stores
from codegen.model.quantities.reach import reaches
from codegen.project.systems import read_systems
from codegen.rules.unknown_attribute import known_attributes
from codegen.targets.firmware.state.attribute import attributes
from codegen.targets.firmware.words import word_layout

ROOT = Path(__file__).resolve().parents[2]
BOAT = ROOT / "examples" / "boat"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("state.gimbal.headng = 5", [("gimbal", "headng", 1, 14)]),
        ("self.state.gimbal[0].headng += 5", [("gimbal", "headng", 1, 22)]),
        (
            "def f(self):\n    g = self.state.gimbal\n    g.headng, g.other = 1, 2",
            [("gimbal", "headng", 3, 7), ("gimbal", "other", 3, 17)],
        ),
        ("g = vehicle.state.gimbal[1]\ndef f():\n    g.headng = 1", [("gimbal", "headng", 3, 7)]),
        ("class A:\n    def f(self, state):\n        state.gimbal.headng = 1", [("gimbal", "headng", 3, 22)]),
        ("x = state.gimbal.headng", []),
        ("g = state.gimbal\ng = other()\ng.headng = 1", []),
        ("def f(g):\n    g = state.gimbal\n    g.headng = 1", []),
        ("for g in state.gimbal:\n    g.headng = 1", []),
        ("g = state.gimbal\ndef f(g):\n    g.headng = 1", []),
        ("g = state.gimbal\ndef f():\n    global g\n    g = 3\ndef h():\n    g.headng = 1", []),
        ("state.phase = 1\nself.gimbal.headng = 1\nself.headng = 2", []),
        ("no python", []),
    ],
)
def test_what_is_set_is_found_where_it_is_sure(text: str, expected: list[tuple[str, str, int, int]]) -> None:
    """Through the state, or a name that stands for a component and for nothing else."""
    assert state_stores(text).stored == tuple(Stored(*each) for each in expected)


def test_a_misspelt_attribute_is_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """In the module of the program, or in one that it imports; the nearest name is in the hint."""
    shutil.copytree(BOAT, tmp_path / "boat", ignore=shutil.ignore_patterns("generated"))
    monkeypatch.chdir(tmp_path / "boat")
    report = Report()
    (system,) = read_systems("specs/codegen.yaml", report)
    assert list(report) == []
    component, quantity = next(
        (each, one) for each in system.components.values() for one in each.quantities.values() if len(one.attribute) > 6
    )
    assert system.program is not None
    app = Path(f"{system.program.module}.py")
    own = f"import farther\n\n\ndef f(state):\n    state.{component.name}.{quantity.attribute} = 1\n"
    own += f"    state.{component.name}._mine = 1\n"
    app.write_text(app.read_text() + own)
    wrong = quantity.attribute[:3] + quantity.attribute[4:]
    Path("farther.py").write_text("def f(state):\n    pass\n")
    assert main(["check"]) == 0
    capsys.readouterr()
    Path("farther.py").write_text(f"def f(state):\n    state.{component.name}.{wrong} = 1\n")
    assert main(["check"]) == 1
    said = capsys.readouterr().out
    assert (
        f"farther.py:2:{12 + len(component.name)}: error unknown-attribute: state.{component.name} has no {wrong}"
        in said
    )
    assert f"hint: did you mean {quantity.attribute}" in said


@pytest.mark.parametrize("folder", ["", "examples/boat", "tests/projects/wide_values", "tests/projects/received"])
def test_each_attribute_of_the_firmware_is_known(folder: str) -> None:
    """What the classes of the state have can be set."""
    for system in read_systems(str(ROOT / folder / "specs" / "codegen.yaml"), Report()):
        layout = word_layout(system)
        for component in system.components.values():
            at_once, lines = attributes(component, layout.blocks[component.name], reaches(system))
            names = [name for each in at_once for name in each.name.split(", ")]
            names += [name for each in lines for name in each.names]
            names = [name for name in names if not name.startswith("_")]
            assert set(names) - known_attributes(component) <= {"number", "failures", "expires_ms"}
