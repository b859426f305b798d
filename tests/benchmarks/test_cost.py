"""The steady path takes no more instructions than is stored: what makes it slower is seen at once, on any computer."""

import shutil
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import cost
import pytest
import results

STORED = {figure.key: figure for figure in results.read(results.FOLDER / "cost.json").figures}
MORE = 1.03
LAYOUTS = sorted(cost.LAYOUTS, key=lambda layout: min(layout, max(cost.LAYOUTS) - layout))
"""Those at both ends first: what one name more leaves in the same places is counted alike."""

Counted = Callable[[str, int, bool], cost.Counts]


@pytest.fixture(scope="module")
def counted(tmp_path_factory: pytest.TempPathFactory) -> Counted:
    """The counts of a script in one layout, of sources or of compiled modules, counted once."""
    if shutil.which("valgrind") and cost.problem():
        pytest.skip(cost.problem())  # another processor; make test says so
    assert not cost.problem(), cost.problem()
    folder = tmp_path_factory.mktemp("cost")

    @cache
    def counts(script: str, layout: int, is_compiled: bool) -> cost.Counts:
        modules = cost.modules_of(script, folder)
        if is_compiled:
            modules = [cost.compiled(modules, folder / f"{script}_compiled")]
        return cost.instructions(f"cost_{script}.py", layout, modules, folder)

    return counts


def tries(script: str) -> list[tuple[int, bool]]:
    """Return the layouts that are tried, each with whether modules are compiled: first what is quickest and may do."""
    from_sources = [(layout, False) for layout in LAYOUTS]
    return from_sources if script in ("codec", "loop") else [(LAYOUTS[0], True), *from_sources]


def test_every_workload_is_stored() -> None:
    """None was left out when the figures were stored, and none could not be counted."""
    assert list(STORED) == [workload.key for workload in cost.WORKLOADS]
    assert all(figure.value for figure in STORED.values())


OF_DRAFTS = pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")
"""The drafts with which the stored figures of the firmware were counted."""


@pytest.mark.parametrize(
    "script", [pytest.param(each, marks=OF_DRAFTS if each == "firmware" else ()) for each in cost.SCRIPTS]
)
def test_instructions_are_not_more_than_stored(script: str, counted: Counted) -> None:
    """Up to 3 % more are none; else the change is to be mended, or `make benchmarks` stores the new figure."""
    counts: list[cost.Counts] = []
    for layout, is_compiled in tries(script):
        counts.append(counted(script, layout, is_compiled))
        more = [
            f"{figure.measure}: {figure.value:.0f} instructions, stored are {STORED[figure.key].value:.0f}"
            for figure in cost.figures_of(script, counts)
            if figure.value > MORE * STORED[figure.key].value
        ]
        if not more:
            return
    pytest.fail("\n".join([*more, f"stored with MicroPython {results.read_versions()['MicroPython']}"]))


def test_a_field_of_more_bits_takes_at_most_150_instructions_more(counted: Counted) -> None:
    """Than one of 16, in machine code from the state to the frame, the checksum of its bytes included."""
    figures = cost.figures_of("fields", [counted("fields", *tries("fields")[0])])
    assert len(figures) == 5
    for figure in figures:
        assert 0 < figure.value <= figure.most == 150, figure.measure


@pytest.fixture(scope="module")
def received(counted: Counted) -> dict[str, float]:
    """What messages take that set quantities, without the loop around it; each workload said that they were taken."""
    costs, said = counted("received", *tries("received")[0])
    assert set(said.values()) == {1}
    assert len(said) == len(costs) - 1 == 9
    return {name: value - costs["nothing"] for name, value in costs.items()}


@pytest.mark.parametrize("message", ["stick", "fix"])
def test_taking_a_message_takes_at_most_three_times_what_parsing_takes(
    received: dict[str, float], message: str
) -> None:
    """From the bytes of a frame to the words of the state: MANUAL_CONTROL into three, GPS_INPUT into eight."""
    parsed, taken = received[f"{message}_parsed"], received[f"{message}_taken"]
    assert 1000 < parsed < taken <= 3 * parsed


def test_a_further_table_for_a_message_takes_less_than_parsing_it(received: dict[str, float]) -> None:
    """Of which the conditions are not met."""
    assert 0 < received["both_taken"] - received["fix_taken"] < received["fix_parsed"]


@pytest.mark.requirement("FR-00068.11")
@pytest.mark.parametrize("key", ["battery_status", "sys_status", "v2", "cells"])
def test_message_takes_less_than_100_us_by_the_prediction(key: str) -> None:
    """The stored instructions, which the count above may exceed a little, at the most cycles that each takes."""
    _, most = cost.cycles(MORE * STORED[key].value)
    assert most / cost.MEGAHERTZ < 100


@pytest.mark.requirement("NFR-00060.1")
def test_reading_nominally_takes_10_to_50_us_by_the_prediction() -> None:
    """The stored instructions, which the count above may exceed a little, and five calls of the converter."""
    likely, _ = cost.cycles(MORE * STORED["reading"].value)
    assert 10 <= likely / cost.MEGAHERTZ + cost.CONVERSIONS_US <= 50


def test_a_figure_that_could_not_be_counted_says_why(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Without valgrind nothing is guessed and nothing is taken as counted."""
    monkeypatch.setattr(cost.shutil, "which", lambda _name: None)
    found = cost.counted("codec", tmp_path)
    assert found
    assert all(figure.value is None and "valgrind" in figure.note for figure in found)
    assert all("not measured: valgrind is missing" in figure.shown for figure in found)


def test_prediction_of_a_board() -> None:
    """Instructions become cycles by the two factors that the page names."""
    assert cost.cycles(1000) == (1340, 1900)
    assert replace(next(iter(STORED.values())), value=3001, most=3000).verdict == "not met"
