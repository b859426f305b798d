"""The budget of the main loop follows from the specification, and says what the generated program does."""

import re
import shutil
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from codegen.commands.build import render_systems
from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.loop.budget import LoopBudget, Slot, loop_budget, why_not_predicted
from codegen.loop.costs import measured_costs
from codegen.loop.frames import busiest_works, due_work, streamed
from codegen.loop.grid import slot_kinds
from codegen.loop.jobs import Job, loop_jobs
from codegen.loop.load import traffic_load
from codegen.loop.parts import Part, Work
from codegen.loop.pass_share import jobs_of_a_pass, messages_of_a_pass
from codegen.loop.shares import GROUPS, shares
from codegen.loop.words import rows
from codegen.model.system import System
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]
ROVER = ROOT / "specs"
BOAT = ROOT / "examples" / "boat" / "specs"
PROJECTS = ROOT / "tests" / "projects"
WITH_PROGRAM = ("commanded", "guarded", "named_tables", "radio_rover", "received", "sensors", "watched_boat")


def systems_of(specs: Path) -> tuple[System, ...]:
    """The programs of a project."""
    report = Report()
    systems = read_systems(str(specs / "codegen.yaml"), report)
    assert systems, list(report)
    return systems


def budget_of(specs: Path) -> LoopBudget:
    """The budget of the first program of a project."""
    budget = loop_budget(systems_of(specs)[0])
    assert budget is not None
    return budget


def slot_of(budget: LoopBudget, words: str) -> Slot:
    """The slot in which these jobs are due."""
    return next(slot for slot in budget.slots if slot.words == words)


@pytest.mark.parametrize("specs", [ROVER, BOAT, *(PROJECTS / name / "specs" for name in WITH_PROGRAM)], ids=str)
def test_jobs_are_those_of_the_generated_program(specs: Path) -> None:
    """In their order, with their names and periods, of each program of a project."""
    systems = systems_of(specs)
    files = render_systems(systems).files
    for system in systems:
        program = system.program
        assert program is not None
        folder = f"{system.spec.program}/" if system.spec.program else ""
        text = files[f"{folder}firmware/vehicle.py"]
        constants = {name: int(value) for name, value in re.findall(r"(?m)^(\w+_US) = (\d+)", text)}
        called = re.findall(r'scheduler\.every\((\w+), [\w.]+, "(\w+)"\)', text)
        every = [(name, constants[period] if period in constants else int(period)) for period, name in called]
        assert [(job.name, job.period_us) for job in loop_jobs(system, program)] == every


def test_what_a_pass_does_is_what_the_firmware_has() -> None:
    """Numbers of vehicle.py, and one of connection.py: a message for each 2.5 ms of a slot, and one job of four."""
    text = (ROOT / "templates" / "firmware" / "program" / "connection.py").read_text()
    [most_heard] = re.findall(r"_MESSAGES = const\((\d+)\)", text)
    for specs, folder, messages, jobs in ((ROVER, "", 1, 1), (ROVER, "smart_battery/", 8, 6)):
        systems = systems_of(specs)
        system = systems[1 if folder else 0]
        assert system.program is not None
        vehicle = render_systems(systems).files[f"{folder}firmware/vehicle.py"]
        assert re.findall(r"MESSAGES = (\d+)", vehicle) == [str(messages_of_a_pass(system.program))] == [str(messages)]
        assert (
            re.findall(r"_JOBS = const\((\d+)\)", vehicle)
            == [str(jobs_of_a_pass(system, system.program))]
            == [str(jobs)]
        )
        heard = [work[Part.HEARD] for work in busiest_works(system, system.program)]
        assert heard == list(range(min(messages, int(most_heard)) + 1))


def test_slots_are_counted_on_the_grid() -> None:
    """Of 400 passes in a second 100 serve links, 10 others read the battery, and so on; together they are all."""
    budget = budget_of(ROVER)
    assert {slot.words: slot.rate for slot in budget.slots} == {
        "control alone": 400 - 100 - 10 - 1 - Fraction(1, 10),
        "links": 100,
        "battery": 10,
        "reminder": 1,
        "report": Fraction(1, 10),
    }
    boat = budget_of(BOAT)
    assert sum(slot.rate for slot in boat.slots) == Fraction(1000000, boat.control_us) == 50


def test_what_is_due_in_each_slot_is_done_in_each() -> None:
    """As the scheduler has it: where more is due than a slot has jobs, what would lose a turn does not wait."""
    [_, slow] = systems_of(ROVER)
    assert slow.program is not None
    most = jobs_of_a_pass(slow, slow.program)
    often = slow.program.control_us
    periods = [10 * often] * (most + 2) + [often, 2 * often]
    jobs = tuple(Job(f"{number}", "", us, Work(), Work()) for number, us in enumerate(periods))
    found = {tuple(job.name for job in due): rate for due, rate in slot_kinds(jobs, slow, slow.program)}
    last = f"{most + 2}"
    assert all(last in due for due in found), found
    assert {len(due) for due in found} == {most + 1, 4, 1, 2}, "the others wait for the next slot"


def test_what_is_not_due_with_control_is_done_in_the_next_slot() -> None:
    """As the scheduler has it: a job whose time has come since the pass before, with whatever else is due then."""
    [rover, *_] = systems_of(ROVER)
    assert rover.program is not None
    program = replace(rover.program, control_us=2500)
    jobs = tuple(Job(f"{us}", "", us, Work(), Work()) for us in (10000, 7000, 35000))
    assert jobs_of_a_pass(rover, program) == 1
    found = {tuple(job.name for job in due): rate for due, rate in slot_kinds(jobs, rover, program)}
    assert set(found) == {(), ("10000",), ("7000",), ("35000",)}, "each in a slot of its own"
    [_, slow] = systems_of(ROVER)
    assert slow.program is not None
    assert slow.program.control_us == 50000
    jobs = tuple(Job(f"{us}", "", 20 * us, Work(), Work()) for us in (10000, 7000, 35000))
    assert jobs_of_a_pass(slow, slow.program) >= len(jobs)
    found = {tuple(job.name for job in due): rate for due, rate in slot_kinds(jobs, slow, slow.program)}
    expected: dict[tuple[str, ...], Fraction] = {}
    for now_us in range(0, 700000, 50000):
        due = tuple(job.name for job in jobs if now_us // job.period_us != (now_us - 50000) // job.period_us)
        expected[due] = expected.get(due, Fraction(0)) + Fraction(1000000, 700000)
    assert found == expected
    assert ("10000", "7000", "35000") in found


def test_times_follow_from_the_costs_and_the_board() -> None:
    """1.34 cycles of 150 MHz for each instruction, 1.9 at most, and 4.6 us for each conversion."""
    budget = budget_of(ROVER)
    costs = measured_costs().parts
    alone = slot_of(budget, "control alone")
    assert alone.quiet.instructions == alone.most.instructions == costs[Part.PASS]
    assert alone.quiet.likely_us == Fraction("1.34") * costs[Part.PASS] / 150
    assert alone.quiet.most_us == Fraction("1.9") * costs[Part.PASS] / 150
    links, battery = slot_of(budget, "links"), slot_of(budget, "battery")
    assert links.quiet.instructions - alone.quiet.instructions == sum(
        count * costs[part] for part, count in {Part.JOBS: 1, Part.JOB: 4, Part.CALL: 1, Part.LINK: 1}.items()
    )
    assert battery.quiet.likely_us is not None
    more = battery.quiet.likely_us - Fraction("1.34") * battery.quiet.instructions / 150
    assert more == 5 * Fraction("4.6"), "five samples of the battery that is on"
    assert links.quiet.instructions < links.busy.instructions < links.most.instructions
    left = budget.left_us(battery.quiet)
    assert left == (2500 - battery.quiet.likely_us, 2500 - (battery.quiet.most_us or 0))


def test_the_last_row_is_the_slot_that_takes_longest_with_everything_on() -> None:
    """It is not the one that takes longest by default: instances that are off are read in another one."""
    budget = budget_of(ROVER)
    *_, (words, rate, likely_us, _, _) = rows(budget)
    assert (words, rate) == ("battery, everything on", "")
    assert likely_us == str(round(max(slot.most.likely_us or 0 for slot in budget.slots)))
    assert slot_of(budget, "battery").most.instructions > slot_of(budget, "links").most.instructions


def test_what_is_due_at_once_are_the_messages_of_the_streams() -> None:
    """Those of the chosen generation, of what is switched on; of all that there are no more than a pass sends."""
    [rover, *_] = systems_of(ROVER)
    assert [message.name for message in streamed(rover)] == [
        "HEARTBEAT",
        "SYS_STATUS",
        "BATTERY_STATUS",
        "SMART_BATTERY_INFO",
    ]
    assert rover.program is not None
    slow = replace(rover.program, control_us=50000)
    for program, one, all_of_them in ((rover.program, 1, 1), (slow, 4, 8)):
        due, most = due_work(rover, program), due_work(rover, program, most=True)
        assert (due[Part.MESSAGE], due[Part.FRAME], due[Part.TABLE]) == (one, one, 9)
        assert (most[Part.MESSAGE], most[Part.TABLE]) == (all_of_them, 9)
        assert most[Part.FRAME] > due[Part.FRAME]


def test_the_load_is_the_sum_over_a_second() -> None:
    """The sum has the slots without messages, and as many frames as there are."""
    budget = budget_of(ROVER)
    slots = sum(slot.rate * slot.quiet.instructions for slot in budget.slots)
    assert budget.base.instructions == pytest.approx(float(slots), rel=1e-3)
    assert budget.base.instructions < budget.load.instructions


def test_the_shares_of_a_slot_are_all_of_it() -> None:
    """Every part is in one group, and the groups of a slot take what the slot takes."""
    parts = [part for group in GROUPS.values() for part in group]
    assert sorted(parts) == sorted(Part)
    for specs in (ROVER, BOAT):
        budget = budget_of(specs)
        slot = budget.longest
        taken = sum(took.instructions for _, took, _ in shares(slot, budget))
        assert taken == slot.busy.instructions


def test_each_part_has_a_cost() -> None:
    """But conversions, which are a time of the board; what was fitted fits to a quarter."""
    costs = measured_costs()
    assert set(costs.parts) == set(Part) - {Part.CONVERSION}
    assert all(cost >= 0 for cost in costs.parts.values())
    assert costs.instructions(Work({Part.CONVERSION: 3})) == 0
    assert all(fit.rows and 0 <= fit.error < 1 / 4 for fit in costs.fits)


def test_no_time_is_guessed() -> None:
    """Of a board that nobody measured, of plain Python, and without a program."""
    [boat] = systems_of(BOAT)
    budget = loop_budget(boat)
    assert budget is not None
    assert budget.longest.busy.likely_us is None
    assert budget.left_us(budget.longest.busy) is None
    assert (
        why_not_predicted(boat) == "nobody has measured how many cycles the ESP32-S3 takes for what the firmware does"
    )
    assert traffic_load(boat) == why_not_predicted(boat)
    for name, why in (("radio_rover", "machine_code is false"), ("minimal", "vehicle.yaml is missing")):
        [system] = systems_of(PROJECTS / name / "specs")
        assert loop_budget(system) is None
        assert why in why_not_predicted(system)


def test_the_load_of_traffic_is_that_of_its_frames() -> None:
    """At the default rates it is that of the budget; twice the frames take twice as much more."""
    [rover, *_] = systems_of(ROVER)
    budget, load = loop_budget(rover), traffic_load(rover)
    assert budget is not None
    assert budget.load.likely_us is not None
    assert not isinstance(load, str)
    idle = load.share({}, 0, 0, 1000)
    one, two = (load.share({"HEARTBEAT": count}, 21 * count, 0, 1000) for count in (1, 2))
    assert idle < one
    assert two - idle == 2 * (one - idle)
    assert load.share({"HEARTBEAT": 1}, 21, 21, 1000) > one
    sent = {message.wire.name: 1 for message in streamed(rover) if message.stream and message.stream.name != "INFO"}
    share = load.share(sent, 120, 0, 1000)
    assert float(share) == pytest.approx(float(budget.load.likely_us) / 1e6, rel=0.02)


def test_diff_tells_that_the_longest_slot_takes_longer(tmp_path: Path) -> None:
    """In tenths of ms, with all messages due: where more samples are taken, and not where only a text is another."""
    specs = Path(shutil.copytree(ROVER, tmp_path / "specs"))
    board = specs / "board.yaml"
    written = board.read_text().replace("samples: 5", "samples: 20")  # so that the slot of the battery is the longest
    board.write_text(written)
    before = systems_of(specs)
    board.write_text(written.replace("generic_LiPo-3300", "generic_LiPo-3301"))
    assert "longest slot" not in told_between(before, systems_of(specs))
    board.write_text(written.replace("samples: 20", "samples: 60"))
    told = told_between(before, systems_of(specs))
    old, new = re.findall(r"longest slot takes, predicted ([\d.]+) ms", told)
    # 40 conversions more, and as many samples.
    more_us = 40 * (Fraction("4.6") + Fraction("1.34") * measured_costs().parts[Part.SAMPLE] / 150)
    assert float(new) - float(old) == pytest.approx(float(more_us) / 1000, abs=0.11)


def told_between(before: tuple[System, ...], after: tuple[System, ...]) -> str:
    """Return the changes that diff tells, a line for each."""
    changes = compare_systems(before, after).changes
    return "\n".join(f"{change.old} -> {change.new}" for change in changes)
