"""What is made of each project is what was made of it before, but for changes that somebody has looked at.

generated/ shows what a change of the generator does to the rover and the smart battery. The other projects have what
these do not: without this, a fault that only they show would be seen by nobody who does not run their suites.
"""

import pytest
from project_outputs import COMMITTED, PLACES, ROOT, STORED, digests, rendered, stored

from codegen.commands.build import render_systems
from codegen.diagnostics import Report
from codegen.project.systems import read_systems


@pytest.mark.parametrize("project", sorted(PLACES))
def test_what_is_made_is_what_was_made_before(project: str) -> None:
    """Byte for byte: a change that is meant is stored by `python tests/emit/project_outputs.py`."""
    made, before = digests(rendered(project)), stored()[project]
    other = sorted(path for path in made.keys() | before.keys() if made.get(path) != before.get(path))
    assert not other, f"{project} is made otherwise; compare both, then run tests/emit/project_outputs.py"


def test_nothing_is_stored_of_what_there_is_not() -> None:
    """A project that is gone leaves no digests, and no project is without."""
    assert stored().keys() == PLACES.keys()
    assert all(stored().values())
    assert STORED.read_text(encoding="utf-8").endswith("}\n")


def test_what_is_committed_is_what_is_made() -> None:
    """`codegen build` has been run after the last change: the tests of generated/ judge this generator's output."""
    made = render_systems(read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())).files
    other = [path for path, text in made.items() if (COMMITTED[0] / path).read_text(encoding="utf-8") != text]
    assert made
    assert not other, "codegen build"
