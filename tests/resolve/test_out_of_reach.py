"""A threshold that no value can be beyond is told: what waits for it would sleep for ever."""

import shutil
from pathlib import Path

import pytest
from edited_project import edited

from codegen.diagnostics import Severity
from codegen.rules import out_of_reach

BUOY = Path(__file__).resolve().parents[1] / "projects" / "moored_buoy" / "specs"
EMPTY = "empty: {below: BUOY_EMPTY,"
COLD = "cold: {below: 1 degC,"
HUMID = "      humidity:"
SET = "type: {enum: MAV_TYPE_ONBOARD_CONTROLLER}"

RECEIVES = """receive: HYGROMETER_SENSOR
from: any
requirement: FR-701.3
fields:
  temperature: {state: sea.warmth, max: 30 degC}
"""

Changes = tuple[tuple[str, str, str], ...]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A buoy with an accumulator, 0 to 16.5 V at an ADC, and a sea of -5 to 40 degC that code tells."""
    shutil.copytree(BUOY, tmp_path / "specs")
    return tmp_path / "specs"


def told(folder: Path, *changes: tuple[str, str, str]) -> list[tuple[str, str]]:
    """Return the ids and messages of the rules that are about reach, after changes."""
    _, found = edited(folder, *changes)
    own = {out_of_reach.RULE, out_of_reach.BY_DEFAULT, out_of_reach.KNOWN_FOR_EVER}
    assert not [each for each in found if each.rule not in own and each.rule.severity is Severity.ERROR]
    assert all(each.hint for each in found if each.rule in own)
    return [(each.rule.id, each.message) for each in found if each.rule in own]


REACHED = [
    (("vehicle.yaml", EMPTY, "empty: {above: 16.4 V,"),),
    (("vehicle.yaml", COLD, "cold: {below: -4.99 degC,"),),
    (("vehicle.yaml", COLD, "cold: {above: 39.99 degC,"),),
    (("state.yaml", HUMID, "      ice: {doc: ., boolean: true, follows: warmth, below: -4.99}\n      humidity:"),),
    (("state.yaml", HUMID, "      hot: {doc: ., boolean: true, follows: warmth, at_least: 40}\n      humidity:"),),
    (("parameters.yaml", "BUOY_EMPTY: {doc: Voltage at which all lights go out., unit: V, default: 10,",
      "BUOY_EMPTY: {doc: Voltage at which all lights go out., unit: V, default: 0,"),),
]  # fmt: skip


@pytest.mark.parametrize("changes", [(), *REACHED], ids=range(len(REACHED) + 1))
def test_a_threshold_within_reach_is_one(folder: Path, changes: Changes) -> None:
    """One step within the ends, and a default of 0 that switches off."""
    assert told(folder, *changes) == []


BEYOND = [
    (("vehicle.yaml", EMPTY, "empty: {above: 16.5 V,"), "store.charge is never above 16.5 V: it goes from 0 to 16.5 V"),
    (("vehicle.yaml", COLD, "cold: {below: -5 degC,"), "sea.warmth is never below -5 degC: it goes from -5 to 40 degC"),
    (("vehicle.yaml", COLD, "cold: {above: 40 degC,"), "sea.warmth is never above 40 degC: it goes from -5 to 40 degC"),
    (
        ("state.yaml", HUMID, "      ice: {doc: ., boolean: true, follows: warmth, below: -5}\n      humidity:"),
        "sea.warmth is never below -5 degC: it goes from -5 to 40 degC",
    ),
    (
        ("state.yaml", HUMID, "      hot: {doc: ., boolean: true, follows: warmth, at_least: 40.01}\n      humidity:"),
        "sea.warmth is never above 40.01 degC: it goes from -5 to 40 degC",
    ),
]


@pytest.mark.parametrize(("change", "message"), BEYOND, ids=range(len(BEYOND)))
def test_a_threshold_beyond_the_ends_is_an_error(folder: Path, change: tuple[str, str, str], message: str) -> None:
    """Of failsafes and of booleans, on either side; an ADC ends at its full scale."""
    assert told(folder, change) == [("threshold-out-of-reach", message)]


def test_a_parameter_is_one_where_no_value_of_it_is_reached(folder: Path) -> None:
    """Its whole range beyond is an error, its default alone a warning."""
    whole = ("vehicle.yaml", "low: {below: BUOY_LOW,", "low: {above: BUOY_LOW,")
    default = "BUOY_LOW: {doc: Least voltage of the accumulator., unit: V, default: 11, min: 0, max: 16, step: 0.1,"
    other = default.replace("default: 11, min: 0, max: 16", "default: 18, min: 0, max: 20")
    assert told(
        folder, whole, ("vehicle.yaml", EMPTY, "empty: {above: 12 V,"), ("parameters.yaml", default, other)
    ) == [
        (
            "default-out-of-reach",
            "store.charge is never above BUOY_LOW, 18 V by default: it goes from 0 to 16.5 V",
        )
    ]
    beyond = other.replace("default: 18, min: 0", "default: 18, min: 17")
    assert told(folder, ("parameters.yaml", other, beyond)) == [
        ("threshold-out-of-reach", "store.charge is never above BUOY_LOW: it goes from 0 to 16.5 V")
    ]


def test_what_a_table_takes_is_the_end(folder: Path) -> None:
    """What is received beyond 30 degC is left out: a failsafe above that sleeps, and nothing makes it unknown."""
    (folder / "receives").mkdir()
    (folder / "receives" / "hygrometer.yaml").write_text(RECEIVES)
    (folder / "messages" / "hygrometer_sensor.yaml").unlink()
    stays = ("state.yaml", "min: -5, max: 40, stale_after: 5 s}", "min: -5, max: 40}")
    warmer = ("vehicle.yaml", COLD, "cold: {above: 30 degC,")
    assert told(folder, stays, warmer) == [
        ("threshold-out-of-reach", "sea.warmth is never above 30 degC: it goes from -5 to 30 degC"),
        ("known-for-ever", "sea.warmth is never unknown again once a message has set it"),
    ]
    assert told(folder, (stays[0], stays[2], stays[1]), (warmer[0], warmer[2], COLD)) == []


def test_a_message_that_says_so_does_not_tell_of_silence(folder: Path) -> None:
    """Who waits until what arrives is unknown waits for the sender to fall silent, too, which nothing notices."""
    (folder / "receives").mkdir()
    (folder / "receives" / "hygrometer.yaml").write_text(RECEIVES.replace("max: 30 degC", "unknown: [0]"))
    (folder / "messages" / "hygrometer_sensor.yaml").unlink()
    stays = ("state.yaml", "min: -5, max: 40, stale_after: 5 s}", "min: -5, max: 40}")
    says = "sea.warmth is never unknown again once a message has set it, unless another one says so"
    assert told(folder, stays) == [("known-for-ever", says)]
    assert told(folder, (stays[0], stays[2], stays[1])) == []


@pytest.mark.parametrize(
    ("threshold", "ends"),
    [("above: 16.5 V", "0 to 16.5 V"), ("above: 16.4 V", None), ("above: 40 V", "0 to 16.5 V"), ("below: 1 V", None)],
)
def test_what_an_adc_shows_by_default_is_the_end(folder: Path, threshold: str, ends: str | None) -> None:
    """A multiplier that is a parameter can be set so that a threshold is within reach; until then nothing happens."""
    first = "  BUOY_LOW: "
    factor = "  BUOY_MULT: {doc: D., default: 5, min: 1, max: 20, step: 0.1, reboot: true, requirement: FR-701.2}\n"
    changes = (
        ("board.yaml", "multiplier: 5", "multiplier: BUOY_MULT"),
        ("parameters.yaml", first, f"{factor}{first}"),
        ("vehicle.yaml", EMPTY, f"empty: {{{threshold},"),
    )
    message = f"store.charge is never {threshold.replace(':', '')} by the defaults of what it is measured with"
    found = [("default-out-of-reach", f"{message}: it goes from {ends}")] if ends else []
    assert told(folder, *changes) == found
