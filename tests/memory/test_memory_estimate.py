"""A program that does not find room on its board is told, with what takes how much; one that does is not."""

import json
import re
import shutil
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from in_process import codegen

from codegen.diagnostics import Report
from codegen.memory.costs import measured_costs
from codegen.memory.estimate import ACCURACY, GROUPS, SHARE, Estimate, memory_estimate
from codegen.memory.parts import Part, counted
from codegen.model.system import System
from codegen.project.systems import read_systems
from codegen.rules import larger_than_memory, little_memory_left

ROOT = Path(__file__).resolve().parents[2]
NETWORKED = ROOT / "tests" / "projects" / "networked"
PARAMETER = "type: uint8, default: 1, min: 0, max: 100, step: 1, requirement: FR-701.1"
RULES = (larger_than_memory.RULE, little_memory_left.RULE)


def read(specs: Path) -> tuple[System, list[str]]:
    """The first program of a project, and what the two rules find in all of them."""
    report = Report()
    systems = read_systems(str(specs / "codegen.yaml"), report)
    return systems[0], [f"{each.rule.id}: {each.message}" for each in report if each.rule in RULES]


def estimated(specs: Path) -> Estimate:
    """The estimate of the first program of a project."""
    estimate = memory_estimate(read(specs)[0])
    assert estimate is not None
    return estimate


@pytest.fixture
def specs(tmp_path: Path) -> Path:
    """A project for a Pico W, 189,440 bytes, with three links."""
    shutil.copytree(NETWORKED / "specs", tmp_path / "specs")
    return tmp_path / "specs"


def with_parameters(specs: Path, count: int) -> None:
    """Give a project so many parameters more."""
    lines = [f"  LAB_P{number}: {{doc: P., {PARAMETER}}}\n" for number in range(count)]
    path = specs / "parameters.yaml"
    path.write_text(path.read_text().rstrip("\n") + "\n" + "".join(lines))


def on_board(specs: Path, memory: str) -> None:
    """Put a project onto a board of its own, which is a Pico W with another memory, or with none that is known."""
    shipped = (ROOT / "codegen" / "boards" / "pico_w.yaml").read_text()
    (specs / "boards").mkdir()
    (specs / "boards" / "own.yaml").write_text(shipped[: shipped.index("\nmemory:") + 1] + memory)
    path = specs / "board.yaml"
    path.write_text(path.read_text().replace("board: pico_w", "board: own"))


def memory(heap: int, more: str = "") -> str:
    """The memory of a board with a heap of so many bytes."""
    return f"memory: {{heap: {heap} bytes, {more}source: a prompt}}\n"


def test_each_part_is_in_one_group() -> None:
    """So the shares are the whole: none is told twice, and none is left out."""
    parts = [part for group in GROUPS.values() for part in group]
    assert sorted(parts) == sorted(Part)
    estimate = estimated(ROOT / "specs")
    assert abs(sum(share for _, share in estimate.shares) - estimate.bytes) <= len(GROUPS)
    assert [share for _, share in estimate.shares] == sorted((share for _, share in estimate.shares), reverse=True)


def test_every_part_that_is_counted_was_measured() -> None:
    """A part that was added and not measured would take nothing."""
    written = json.loads((ROOT / "codegen" / "memory" / "costs.json").read_text())
    assert set(written["plain"]) == set(Part)
    assert all(set(costs) == set(Part) for costs in written["machine_code"].values())
    assert measured_costs().error < ACCURACY


@pytest.mark.parametrize("project", [ROOT, ROOT / "examples" / "boat", NETWORKED], ids=lambda path: path.name)
def test_shipped_projects_find_room(project: Path) -> None:
    """With all their programs, and without a word."""
    assert read(project / "specs")[1] == []


def test_counts_are_those_of_the_specification(specs: Path) -> None:
    """Each parameter takes as much as the one before it."""
    before, few = estimated(specs), read(specs)[0]
    with_parameters(specs, 100)
    after, many = estimated(specs), read(specs)[0]
    assert few.program is not None
    assert many.program is not None
    assert counted(many, many.program)[Part.PARAMETER] == counted(few, few.program)[Part.PARAMETER] + 100
    assert round(100 * measured_costs().plain[Part.PARAMETER]) == after.bytes - before.bytes


def test_machine_code_counts_where_there_is_some(specs: Path) -> None:
    """By the architecture of the board; of one that nobody measured the most that is known."""
    system, _ = read(specs)
    with_code = memory_estimate(system)
    plain = memory_estimate(
        replace(system, spec=replace(system.spec, project=replace(system.spec.project, machine_code=False)))
    )
    assert with_code is not None
    assert plain is not None
    assert plain.machine_code == 0
    assert with_code.bytes - with_code.machine_code == plain.bytes
    most = measured_costs().more("another")
    assert all(most[part] >= costs[part] for costs in measured_costs().machine_code.values() for part in Part)


@pytest.mark.parametrize(("more", "rules"), [(1, []), (0, ["little-memory-left"])])
def test_share_of_the_heap_that_may_be_taken(specs: Path, more: int, rules: list[str]) -> None:
    """To the byte: four fifths of the heap are not too much yet."""
    least = int(Fraction(estimated(specs).bytes) / SHARE)
    on_board(specs, memory(least + more))
    assert [each.partition(":")[0] for each in read(specs)[1]] == rules


@pytest.mark.parametrize(("less", "rule"), [(0, "little-memory-left"), (1, "larger-than-memory")])
def test_what_cannot_fit_is_an_error(specs: Path, less: int, rule: str) -> None:
    """As soon as the heap is smaller than the least that the program takes, and no sooner."""
    on_board(specs, memory(estimated(specs).least - less))
    assert [each.partition(":")[0] for each in read(specs)[1]] == [rule]


def test_wifi_takes_its_part(specs: Path) -> None:
    """Of a board where both have their memory of the same RAM, and only where a link needs Wi-Fi."""
    on_board(specs, memory(200_000, "wifi: 150000 bytes, "))
    assert [each.partition(":")[0] for each in read(specs)[1]] == ["larger-than-memory"]
    estimate = estimated(specs)
    assert estimate.heap == 50_000
    links = "links:\n  radio: {uart: 1, tx: 4, rx: 5, baud: 57600}\n"
    (specs / "board.yaml").write_text(f"board: own\n{links}")
    vehicle = specs / "vehicle.yaml"
    vehicle.write_text(vehicle.read_text().partition("access:")[0])
    assert estimated(specs).heap == 200_000


def test_nothing_is_said_of_a_board_whose_memory_nobody_knows(specs: Path) -> None:
    """A project's own board may have any."""
    on_board(specs, "")
    with_parameters(specs, 3000)
    assert read(specs)[1] == []
    assert estimated(specs).heap is None


def test_a_large_project_is_refused_with_what_takes_how_much(specs: Path) -> None:
    """By check and by build, which writes nothing; the finding says how much there is, and what can be done."""
    with_parameters(specs, 3000)
    for command in ("check", "build"):
        done = codegen(specs.parent, command)
        said = done.stdout
        assert done.returncode == 1
        found = re.search(
            r"board\.yaml:1:8: error larger-than-memory: the program takes some (\d+) KB of heap once it has started, "
            r"and the Raspberry Pi Pico W \(RP2040\) has 185 KB\n(.*)",
            said,
        )
        assert found, said
        assert int(found[1]) == round(estimated(specs).bytes / 1024)
        assert re.search(r"parameters \d+ KB, links 3\d KB, .*machine_code: false takes 9 KB less, fewer tables", said)
    assert not (specs.parent / "generated").exists()


def waived(specs: Path, rule: str, day: str) -> None:
    """Waive what a rule finds."""
    report = Report()
    read_systems(str(specs / "codegen.yaml"), report)
    [found] = {each.fingerprint for each in report if each.rule.id == rule}
    (specs / "waivers.yaml").write_text(
        f"waivers:\n  - {{id: W-1, rule: {rule}, document: board.yaml, fingerprint: {found}, reason: It is frozen., "
        f"owner: Ada, expires: {day}}}\n"
    )


def test_who_installs_it_otherwise_waives_it(specs: Path) -> None:
    """Check and build go on then, until the day has come; the fingerprint holds whatever else is added."""
    on_board(specs, memory(60_000))
    waived(specs, "larger-than-memory", "2999-01-01")
    with_parameters(specs, 10)
    for command in ("check", "build"):
        done = codegen(specs.parent, command)
        assert done.returncode == 0, done.stdout
        assert "error larger-than-memory" not in done.stdout
    waivers = specs / "waivers.yaml"
    waivers.write_text(waivers.read_text().replace("2999-01-01", "2026-01-01"))
    assert codegen(specs.parent, "build").returncode == 1


def test_explain_and_the_page_tell_it(specs: Path) -> None:
    """In the same words: how much, of how much, and its parts."""
    estimate = estimated(specs)
    said = codegen(specs.parent, "explain", "heap").stdout
    words = f"The program takes {round(estimate.bytes / 1024)} KB of the heap once it has started"
    assert words in " ".join(said.split())
    assert codegen(specs.parent, "build").returncode == 0
    page = (specs.parent / "generated" / "docs" / "program.html").read_text()
    assert words in page
    for name, share in estimate.shares:
        if share >= 1024:
            assert re.search(rf"{name} +{round(share / 1024)} KB", said)
            assert re.search(rf"{name}</\w+>\s*<td[^>]*>{round(share / 1024)} KB", page)


@pytest.mark.parametrize(("files", "code"), [(20, 1), (200, 0)])
def test_files_that_the_board_does_not_hold_are_not_written(specs: Path, files: int, code: int) -> None:
    """Known once they are compiled; a deploy asks the board itself."""
    on_board(specs, memory(189_440, f"files: {files} KiB, "))
    done = codegen(specs.parent, "build", "--mpy", "bytecode")
    assert done.returncode == code, done.stdout
    words = (
        r"board\.yaml:1:8: error board-full: its files take \d\d KB, and the file system of the Raspberry .* has 20\n"
    )
    assert bool(re.search(words, done.stdout)) == bool(code)
    assert (specs.parent / "build" / "bytecode" / "main.py").exists() != bool(code)
