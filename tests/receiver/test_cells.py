"""Cells: how single values are told from a pack's voltage, and how pages become one list."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from projects import BIN, HERE, ROOT, run

from codegen.answers.each.answer import EachAnswer
from codegen.answers.page import PageAnswer
from codegen.answers.split import SplitAnswer
from codegen.diagnostics import Report
from codegen.model.answers.answer import Answer, Elements
from codegen.model.answers.scaling import Scaling
from codegen.model.system import System
from codegen.project.systems import read_system


@pytest.mark.requirement("FR-00075.1")
@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_cells_of_views(interpreter: str, generated: Callable[[str], Path]) -> None:
    """The script's assertions hold on both interpreters."""
    assert BIN.exists()
    assert run(interpreter, HERE / "cell_checks.py", [generated("shipped") / "receiver"]) == "done\n"


@pytest.fixture(scope="module")
def system() -> System:
    """The shipped specification."""
    found = read_system(str(ROOT / "specs" / "codegen.yaml"), Report())
    assert found is not None
    return found


def split_into(system: System, field: str) -> SplitAnswer:
    """Return the answer that fills an array of BATTERY_STATUS with the voltage, or would."""
    message = next(message for message in system.messages if message.name == "BATTERY_STATUS")
    voltages = next(answer for answer in message.answers if answer.covers.field.name == "voltages")
    if isinstance(voltages, EachAnswer):
        voltages = voltages.fallback or voltages
    assert isinstance(voltages, SplitAnswer)
    wire = message.wire.field(field)
    assert wire is not None
    covers = Elements(wire, 0, wire.count, voltages.covers.written, voltages.covers.citation)
    return replace(voltages, covers=covers)


def each(split: SplitAnswer, first: int, unknown: int, *, is_paged: bool, has_sum: bool) -> EachAnswer:
    """One value for each element of a field."""
    return EachAnswer(
        covers=split.covers,
        source=split.source,
        first=first,
        scaling=Scaling(Fraction(1), split.scaling.rounding, Fraction(1), Fraction(65534)),
        unknown=unknown,
        is_paged=is_paged,
        fallback=split if has_sum else None,
    )


def expressions(answers: tuple[Answer, ...]) -> dict[str, str]:
    """The expression of each reading."""
    return {reading.name: reading.expression for answer in answers for reading in answer.joint_readings(answers)}


def test_fields_follow_one_another(system: System) -> None:
    """Cells from 10 on stand in the second field, whichever comes first on the wire."""
    first, rest = split_into(system, "voltages"), split_into(system, "voltages_ext")
    answers = (each(rest, 10, 0, is_paged=False, has_sum=False), each(first, 0, 65535, is_paged=False, has_sum=False))
    values = 'values_of(raw("voltages"), 0, 10, 65535, 1, 1000) + values_of(raw("voltages_ext"), 0, 4, 0, 1, 1000)'
    assert expressions(answers) == {"voltage": f"single({values}, None)"}


def test_pages_are_numbered(system: System) -> None:
    """A page says where its values belong; single ones may be unknown."""
    split = split_into(system, "voltages")
    index = split_into(system, "voltages_ext").covers
    answers = (PageAnswer(index, 10), each(split, 0, 0, is_paged=True, has_sum=False))
    wanted = 'page(get("voltages_ext"), values_of(raw("voltages"), 0, 10, 0, 1, 1000, keep=True))'
    assert expressions(answers) == {"voltage": wanted}
