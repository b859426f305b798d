"""The steady path takes no more instructions than is stored: what makes it slower is seen at once, on any computer."""

import shutil
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import cost
import pytest
import results
from figure import Figure

STORED = {figure.key: figure for figure in results.read(results.FOLDER / "cost.json").figures}
MORE = 1.03
LAYOUTS = sorted(cost.LAYOUTS, key=lambda layout: min(layout, max(cost.LAYOUTS) - layout))
"""Those at both ends first: what one name more leaves in the same places is counted alike."""

Counted = Callable[[str, int], list[Figure]]


@pytest.fixture(scope="module")
def counted(tmp_path_factory: pytest.TempPathFactory) -> Counted:
    """The figures of a script in one layout, counted once."""
    folder = tmp_path_factory.mktemp("cost")
    return cache(lambda script, layout: cost.counted(script, folder, [layout]))


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
    if shutil.which("valgrind") and cost.problem():
        pytest.skip(cost.problem())  # another processor; make test says so
    lowest: dict[str, float] = {}
    for layout in LAYOUTS:
        figures = counted(script, layout)
        assert all(figure.value for figure in figures), figures[0].note
        for figure in figures:
            lowest[figure.key] = min(figure.value, lowest.get(figure.key, figure.value))
        more = [
            f"{STORED[key].measure}: {value:.0f} instructions, stored are {STORED[key].value:.0f}"
            for key, value in lowest.items()
            if value > MORE * STORED[key].value
        ]
        if not more:
            return
    pytest.fail("\n".join([*more, f"stored with MicroPython {results.read_versions()['MicroPython']}"]))


def test_a_field_of_more_bits_takes_at_most_150_instructions_more(counted: Counted) -> None:
    """Than one of 16, in machine code from the state to the frame, the checksum of its bytes included."""
    if shutil.which("valgrind") and cost.problem():
        pytest.skip(cost.problem())
    figures = counted("fields", LAYOUTS[0])
    assert len(figures) == 5
    for figure in figures:
        assert figure.value, figure.note
        assert 0 < figure.value <= figure.most == 150, figure.measure


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
