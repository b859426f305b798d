"""Generated suites that were red though the project was right: fast links, ids, many instances, texts at the start."""

from pathlib import Path

import pytest
from generated_suite import suite_is_green
from in_process import build, codegen

VEHICLE = """\
control: {{rate: {rate} Hz, links: {rate} Hz, report_every: 10 s}}
storage: {{files: [parameters.0, parameters.1], chunk: 64, step_limit: 10 ms}}
services: {{fastest: 10 Hz}}
watchdog: {{timeout: 2 s}}
"""
STATUS = """\
components:
  vehicle:
    doc: The board.
    quantities:
      status: {doc: What it does., enum: MAV_STATE, initial: MAV_STATE_ACTIVE}
"""
VALUE = """\
message: NAMED_VALUE_FLOAT
as: {name}
requirement: FR-1.2
stream: {stream}
send: while_known
fields:
  time_boot_ms: {{clock: boot}}
  name: {{constant: {name}}}
  value: {{state: imu.{name}}}
"""
FAST = {
    "specs/codegen.yaml": "project: fast\ndialect: common\nsystem_id: 7\n",
    "specs/vehicle.yaml": VEHICLE.format(rate=200),
    "specs/parameters.yaml": """\
encoding: bytewise
parameters:
  FAST: {doc: A rate., unit: Hz, default: 200, min: 0, max: 200, step: 0.1}
  SLOW: {doc: A rate., unit: Hz, default: 0.1, min: 0, max: 200, step: 0.1}
""",
    "specs/streams.yaml": """\
streams:
  PRESENCE: {doc: That it is there., rate: 1 Hz, requirement: FR-1.1}
  FAST: {doc: What is fast., parameter: FAST, requirement: FR-1.2}
  SLOW: {doc: What is slow., parameter: SLOW, requirement: FR-1.2}
""",
    "specs/state.yaml": STATUS
    + """\
  imu:
    doc: How it moves.
    quantities:
      x: {doc: One., stale_after: 50 ms}
      y: {doc: One., min: -100, max: 100, stale_after: 30 ms}
      z: {doc: One.}
      q: {doc: One.}
""",
    "specs/messages/x.yaml": """\
message: DEBUG_VECT
requirement: FR-1.2
stream: FAST
send: while_known
fields: {time_usec: {clock: boot}, name: {constant: moves}, x: {state: imu.x}, y: {constant: 0}, z: {constant: 0}}
""",
    **{f"specs/messages/{name}.yaml": VALUE.format(name=name, stream="SLOW") for name in "yzq"},
}
"""Four messages at up to 200 Hz, which is more than its link carries, and the ids of a station that tests know."""

SEVERAL = {
    "specs/codegen.yaml": "project: several\ndialect: ardupilotmega\n",
    "specs/vehicle.yaml": VEHICLE.format(rate=50)
    + """\
failsafes:
  damp:
    watches: hull.humid
    levels: {wet: {above: 60 %, text: "It is damp: {value:.1} %"}}
    when: always
    latch: false
    hysteresis: 5 %
    health: bad
    requirement: FR-1.2
""",
    "specs/parameters.yaml": """\
encoding: bytewise
parameters:
  S1_PIN: {doc: A pin., type: int8, default: 26, min: 26, max: 28, step: 1, for_each: store, reboot: true}
  S1_ON: {doc: A switch., type: uint8, default: 1, min: 0, max: 1, step: 1, for_each: sonar, reboot: true}
""",
    "specs/board.yaml": """\
board: pico_2
links: {cable: {usb: true}, radio: {uart: 0, tx: 0, rx: 1, baud: 57600}}
instances:
  store: [{prefix: S1_}, {prefix: S2_, defaults: {S2_PIN: 27}}, {prefix: S3_, defaults: {S3_PIN: 28}}]
  sonar: [{prefix: S1_}, {prefix: S2_, defaults: {S2_ON: 0}}, {prefix: S3_}]
sources:
  pack: {driver: adc, pin: S1_PIN, multiplier: 5, samples: 2, rate: 4 Hz}
  one: {driver: user, class: sonar.Sonar, unit: m, stored: mm, min: 0, max: 40, rate: 10 Hz}
  two: {driver: user, class: sonar.Sonar, unit: m, stored: mm, min: 0, max: 40, rate: 10 Hz}
  three: {driver: user, class: sonar.Sonar, unit: m, stored: mm, min: 0, max: 40, rate: 10 Hz}
""",
    "sonar.py": "class Sonar:\n    def read(self):\n        return None\n",
    "specs/streams.yaml": """\
streams:
  PRESENCE: {doc: That it is there., rate: 1 Hz, requirement: FR-1.1}
  DEPTH: {doc: What is measured., rate: 0.1 Hz, requirement: FR-1.2}
""",
    "specs/state.yaml": STATUS
    + """\
  store:
    doc: A store.
    quantities:
      voltage: {doc: Its voltage., unit: V, stored: mV, source: pack, stale_after: 1 s}
  sonar:
    doc: What is below.
    quantities:
      is_on: {doc: Whether it is used., boolean: true, enabled_by: S1_ON}
      range: {doc: How far it is., unit: m, source: [one, two, three], stale_after: 1 s}
  hull:
    doc: What is inside.
    quantities:
      humid: {doc: How damp it is., unit: "%", stored: d%, min: 0, max: 100, stale_after: 5 s}
      bad: {doc: How bad it is., min: 0, max: 3, initial: 0}
""",
    "specs/messages/range.yaml": """\
message: RANGEFINDER
requirement: FR-1.2
stream: DEPTH
represents: {sonar: {lowest: range}}
send: while_known
fields: {distance: {state: sonar.range}, voltage: unknown}
""",
}
"""Three instances that each say something at the start, one of which stands for all, and a failsafe with a health."""

CHECKS = {
    "ids": (FAST, "test_program.py", "answers_are_for_who_asks"),
    "withheld at 200 Hz": (FAST, "test_program.py", "withheld_messages_are_rejected_for_now"),
    "a full port": (FAST, "test_program.py", "full_port_delays_but_does_not_reorder"),
    "as fast as can be asked": (FAST, "test_program.py", "steady_cycle_allocates_nothing"),
    "short ages": (FAST, "test_counterparts.py", "steps or times"),
    "texts at the start": (SEVERAL, "test_program.py", "numbers_as_floats_are_refused or another_type_is_refused"),
    "the lowest of several": (SEVERAL, "test_behaviour.py", "withheld"),
    "texts of a health": (SEVERAL, "test_program.py", "a_level_stays_or_is_over"),
}


@pytest.fixture(scope="module")
def projects(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """Both of them, built."""
    folders = {}
    for files in (FAST, SEVERAL):
        folder = folders[id(files)] = tmp_path_factory.mktemp("right")
        codegen(folder, "init", "--dialect", "common", "--board", "pico_2")
        for path in ("app.py", "specs/messages/level.yaml", "specs/scenarios.yaml"):
            (folder / path).unlink()
        for path, text in files.items():
            (folder / path).write_text(text)
        build(folder)
    return folders


@pytest.mark.parametrize(("files", "module", "only"), CHECKS.values(), ids=list(CHECKS))
def test_the_suite_is_green(projects: dict[int, Path], files: dict[str, str], module: str, only: str) -> None:
    """What is right is not called wrong."""
    suite_is_green(projects[id(files)], f"generated/tests/{module}", only=only)
