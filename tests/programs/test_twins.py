"""Two smart batteries as they come from the bench, with the same ids, on one link."""

import json
from functools import cache
from pathlib import Path

import pytest
from generated_suite import suite_is_green
from test_battery_protocol import built
from test_smart_battery import PATHS, ROOT, run

CHIPS = {"first...": 52000, "second..": 48000}
TEXT = "COMPID_BATT 180 is in use by another: change one"


@cache
def sent(chip: str, choice: int, other: str | None = None) -> str:
    """Return the frames of a battery in 90 s, in which it hears those of another one; `choice` is BATT_REPORT."""
    given = sent(other, choice) if other else ""
    return run("cpython", PATHS, "twin_frames.py", chip, str(CHIPS[chip]), str(choice), given=given)


def merged(*frames: str) -> str:
    """The frames of both in the order of time; at the same time one is before the other."""
    lines = [line for each in frames for line in each.splitlines()]
    return "\n".join(sorted(lines, key=lambda line: int(line.split()[0])))


@pytest.mark.requirement("FR-00075.10")
@pytest.mark.parametrize(("choice", "interpreter"), [(0, "cpython"), (1, "micropython"), (2, "cpython")])
def test_a_receiver_tells_of_both(choice: int, interpreter: str) -> None:
    """No swap is left, and it is contested as soon as a number is heard again, until the end."""
    given = merged(*(sent(chip, choice) for chip in CHIPS))
    seen = json.loads(run(interpreter, [str(ROOT / "generated" / "receiver")], "twin_seen.py", given=given))
    assert len(seen) > 80
    serials = ", ".join(chip.encode().hex() for chip in CHIPS)
    assert seen[30:] == [[0, f"reported by several as component 180: serial numbers {serials}"]] * len(seen[30:])
    assert max(swaps for swaps, _ in seen) <= 1


@pytest.mark.requirement("FR-00075.8", "FR-00075.10")
@pytest.mark.parametrize("choice", [0, 1, 2])
def test_one_after_the_other_is_one_swap(choice: int) -> None:
    """Also while the first one's frames come late, in part, or twice."""
    first, second = (sent(chip, choice).splitlines() for chip in CHIPS)
    twice = [line for number, line in enumerate(first) for _ in range(number % 3)]
    later = [f"{95000 + int(line.split()[0])} {line.split()[1]}" for line in second]
    given = "\n".join(twice + later)
    seen = json.loads(run("cpython", [str(ROOT / "generated" / "receiver")], "twin_seen.py", given=given))
    assert seen[-80:] == [[1, None]] * 80
    assert [0, None] in seen
    assert all(contest is None for _, contest in seen)


@pytest.mark.requirement("FR-00074.10")
def test_each_tells_of_the_other() -> None:
    """Though they started at the same moment and count their frames alike: each has another chip."""
    for chip, other in (tuple(CHIPS), tuple(CHIPS)[::-1]):
        texts = [line.split()[0] for line in sent(chip, 0, other).splitlines() if TEXT.encode().hex() in line]
        assert len(texts) == 3, texts
        assert int(texts[0]) < 25000


PARAMETER = """\
parameters:
  OWN_COMPONENT: {doc: Component id., type: int16, default: 1, min: 1, max: 255, step: 1, reboot: true}
"""
CHIP = "serial_number: {board: unique_id}"


@pytest.mark.parametrize("told", [[], [("specs/messages/battery_info.yaml", "serial_number: unknown", CHIP)]])
def test_any_program_whose_component_id_can_be_set(told: list[tuple[str, str, str]], tmp_path: Path) -> None:
    """The rover with such a parameter, without a number of its chip and with one: its batteries have fixed numbers."""
    ids = "system_id: SYSID_THISMAV\n"
    built(
        tmp_path,
        ("specs/vehicle.yaml", ids, f"{ids}component_id: OWN_COMPONENT\n"),
        ("specs/parameters.yaml", "parameters:\n", PARAMETER),
        *told,
    )
    vehicle = (tmp_path / "generated" / "firmware" / "vehicle.py").read_text()
    kinds = "((372, 58, 32, 44),)" if told else "()"
    assert f'watch_twins(connection, self.texts, "OWN_COMPONENT", {kinds})' in vehicle
    suite_is_green(tmp_path, "generated/tests/test_program.py", only="twin")
