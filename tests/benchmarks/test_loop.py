"""Whole passes of the rover take what the model of the main loop says, as far as instructions can be counted."""

import shutil
from collections.abc import Mapping

import cost
import loop
import pytest
import results
from loop_plan import Plan
from whole_program import module_folders

from codegen.loop.costs import measured_costs
from codegen.loop.parts import Part, Work

TOLERANCE = 0.15


@pytest.fixture(scope="module")
def counted(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, tuple[int, int]]:
    """Of each pass the instructions that were counted, and those of the model."""
    if shutil.which("valgrind") and cost.problem():
        pytest.skip(cost.problem())
    system = loop.system_of(results.ROOT)
    assert system.program is not None
    plan = Plan(system, system.program)
    plan.count_passes()
    plan.count_messages()
    folder = tmp_path_factory.mktemp("loop")
    modules = cost.compiled(module_folders(results.ROOT / "generated", "firmware", "mocks"), folder / "compiled")
    rows = {row.name: row for row in loop.rows_of("rover", plan, [modules], folder)}
    costs = measured_costs()
    found = {name: (row.instructions, costs.instructions(row.work)) for name, row in rows.items()}
    sent = [found[name] for name in rows if name.startswith("message ")]
    assert len(sent) == len({message.wire.id for message in system.messages})
    found["messages"] = tuple(sum(each) for each in zip(*sent, strict=True))
    return found


@pytest.mark.parametrize("name", ["control", "links", "job battery", "job reminder", "messages"])
def test_a_pass_takes_what_the_model_says(counted: Mapping[str, tuple[int, int]], name: str) -> None:
    """Else `python benchmarks/loop.py` measures the parts anew."""
    measured, told = counted[name]
    assert measured > 1000
    assert abs(told / measured - 1) <= TOLERANCE, f"{name}: {measured} instructions were counted, {told} are stored"


def test_least_squares_find_costs_that_are_there() -> None:
    """Rows made of known costs give these back, and a part that would cost less than nothing costs nothing."""
    works = [Work({Part.FRAME: 1, Part.BYTE: size}) for size in (10, 20, 50)]
    exact = [(work, 100 + 3 * work[Part.BYTE], 100 + 3 * work[Part.BYTE]) for work in works]
    found = loop.least_squares(exact, (Part.FRAME, Part.BYTE, Part.VALUE))
    assert found[Part.FRAME] == pytest.approx(100)
    assert found[Part.BYTE] == pytest.approx(3)
    assert found[Part.VALUE] == 0
    less = [(work, 200 - work[Part.BYTE], 200) for work in works]
    found = loop.least_squares(less, (Part.FRAME, Part.BYTE))
    assert found[Part.BYTE] == 0
    assert 150 < found[Part.FRAME] < 200


def test_costs_of_each_stage_are_those_that_fit_its_rows() -> None:
    """The known costs of earlier stages are taken off; the error is the largest of a row."""
    rows = [loop.Row("p", "control", "control", Work({Part.PASS: 1}), 1000)]
    for jobs, calls in ((1, 1), (2, 1), (3, 2), (5, 2)):
        work = Work({Part.PASS: 1, Part.JOBS: 1, Part.JOB: jobs, Part.CALL: calls})
        rows.append(loop.Row("p", str(jobs), "empty jobs", work, 1000 + 50 + 10 * jobs + 5 * calls))
    costs, fits = loop.fitted(rows, loop.STAGES[:2])
    assert {part: round(value) for part, value in costs.items()} == {
        Part.PASS: 1000,
        Part.JOBS: 50,
        Part.JOB: 10,
        Part.CALL: 5,
    }
    assert [(fit["rows"], fit["error"]) for fit in fits] == [(1, 0), (4, 0)]
