"""Programs start and run in the heap that is stored as their budget, counted in words of a board."""

from pathlib import Path

import heap
import pytest
import results

ROOT = Path(__file__).resolve().parents[2]
STORED = {figure.key: figure.value for figure in results.read(results.FOLDER / "heap.json").figures}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The rover and what it runs with."""
    made = tmp_path_factory.mktemp("heap")
    heap.prepare(made)
    return made


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")  # what is stored was measured with these
@pytest.mark.parametrize("form", heap.FORMS)
def test_program_runs_in_the_heap_that_is_stored(folder: Path, form: str) -> None:
    """From its start through a simulated minute; the next two heaps, in which it has to run as well, are not tried.

    What it has in use is at most 3 % more than what is stored, or 1.5 KB: the collector finds what looks like a
    reference on the stack, and may keep a table that is garbage in one heap and not in another.
    """
    used = heap.in_use(folder, form, int(STORED[f"smallest_{form}"]))
    assert used, "make benchmarks stores what it takes now"
    for moment, count in used.items():
        stored = STORED[f"{moment}_{form}"]
        assert count <= max(1.03 * stored, stored + 1536), moment


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")
def test_what_is_asked_for_rarely_finds_room(folder: Path) -> None:
    """Modules that are loaded then, in the heap that is stored for it; nothing of it reads names of fields."""
    assert heap.in_use(folder, "mpy", int(STORED["rarely_mpy"]), heap.RARELY)


def test_boat_runs_in_the_heap_that_is_stored(tmp_path: Path) -> None:
    """From .mpy files, from its start through a simulated minute, and with what is asked for rarely."""
    heap.prepare_boat(tmp_path)
    used = heap.in_use(tmp_path, "mpy", int(STORED["boat_smallest_mpy"]))
    assert used, "make benchmarks stores what it takes now"
    for moment, count in used.items():
        assert count <= 1.03 * STORED[f"boat_{moment}_mpy"], moment
    assert heap.in_use(tmp_path, "mpy", int(STORED["boat_rarely_mpy"]), heap.RARELY)


@pytest.mark.requirement("FR-00071.4")
def test_stored_heap_with_machine_code_is_not_more_than_132_kb() -> None:
    """From .mpy files, as a board has them; that the program does run in as much is tested above."""
    code = results.read(results.FOLDER / "heap_modules.json").figures
    more = next(figure.value for figure in code if figure.key == "machine_code")
    assert more is not None
    assert STORED["smallest_mpy"] + more / 1024 <= 132


def test_only_what_no_board_has_lies_beside(folder: Path) -> None:
    """The mocks, and the script without the second that the interpreter itself takes."""
    assert heap.beside(folder) == STORED["beside"]
    script = (folder / heap.SCRIPT).stat().st_size
    assert STORED["mocks_mpy"] <= 1024 * (heap.beside(folder) + 1) <= STORED["mocks_mpy"] + script


@pytest.mark.parametrize("form", heap.FORMS)
def test_too_small_a_heap_is_noticed(folder: Path, form: str) -> None:
    """The memory in use after the program's start does not fit into a smaller heap: its limit holds."""
    assert heap.in_use(folder, form, int(STORED[f"started_{form}"]) // 1024) is None


def test_pages_tell_the_heap_that_is_stored() -> None:
    """People read there whether the program fits."""
    deploy = (ROOT / "docs" / "deploy.md").read_text()
    for form, words in (("source", "by hand"), ("mpy", "`.mpy` files"), ("rom", "in a ROMFS")):
        rover, boat = (int(STORED[f"{prefix}smallest_{form}"]) for prefix in ("", "boat_"))
        assert f"{words} | {rover} KB | {boat} KB |" in deploy
    page = (ROOT / "docs" / "rover.md").read_text()
    assert f"From a ROMFS it takes {int(STORED['smallest_rom'])} KB" in page
    assert f"{int(STORED['smallest_mpy'])} KB from `.mpy` files without machine code" in page
