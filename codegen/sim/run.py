"""A whole simulation: the firmware is started, followed, and started again when it restarts the board."""

import json
import os
import re
import signal
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass

from codegen.model.scenario import Scenario, scenario_data
from codegen.sim.address import Address, free_port
from codegen.sim.flash import flash_folder, rover_folder
from codegen.sim.process import EXIT_RESET, Console, FirmwareProcess, Item, Runtime
from codegen.sim.record import Happening, Kind, Recording
from codegen.source import shown_path

SCRIPT = "sim.py"
SILENCE_S = 30.0
"""Seconds without a sign of the firmware after which it is given up."""
_SHORT_MS = 100
_MOST_SHORT_RUNS = 5
_TURN_S = 0.2


@dataclass(frozen=True, slots=True)
class Simulation:
    """What is run: ``duration_ms`` None is without end, ``speed`` 0 as fast as it can.

    ``gpios`` are the pins of the battery's ADC inputs, ``reference_mv`` is what their full scale stands for.
    """

    scenario: Scenario
    duration_ms: int | None
    speed: float
    runtime: Runtime
    interpreter: str
    firmware: str
    mocks: str
    to: Address
    flash: str | None
    rover: str | None
    gpios: tuple[int, ...]
    reference_mv: int


Watch = Callable[[Recording, Happening | None], None]
"""Called with each happening, and with None several times a second."""


def simulate(simulation: Simulation, recording: Recording, watch: Watch, silence_s: float = SILENCE_S) -> None:
    """Run the firmware until its time is over, it fails, or KeyboardInterrupt; ``recording`` says how it went.

    OSError: a folder or file of the user cannot be used, or the interpreter cannot be started.
    """
    with (
        flash_folder(simulation.flash, simulation.to, free_port()) as flash,
        rover_folder(simulation.rover) as rover,
        tempfile.TemporaryDirectory(prefix="codegen-sim-") as work,
    ):
        settings = os.path.join(work, "settings.json")
        paths = [simulation.firmware, simulation.mocks, *rover]
        short_runs = 0
        while True:
            started_ms = recording.at_ms
            _write_settings(simulation, settings, started_ms)
            script = os.path.join(simulation.mocks, SCRIPT)
            process = FirmwareProcess(simulation.runtime, simulation.interpreter, paths, flash, script, settings)
            try:
                is_reset = _follow(process, recording, watch, silence_s)
            except KeyboardInterrupt:
                recording.was_interrupted = True
                for item in process.interrupt():
                    _take(item, recording, watch)
                return
            finally:
                process.close()
            if not is_reset:
                return
            watch(recording, recording.add(Kind.REBOOT, "The board restarted"))
            short_runs = short_runs + 1 if recording.at_ms - started_ms < _SHORT_MS else 0
            if short_runs == _MOST_SHORT_RUNS:
                recording.problem = "the firmware restarts the board over and over"
                return


def _write_settings(simulation: Simulation, path: str, start_ms: int) -> None:
    scenario = simulation.scenario
    settings = {
        "scenario": scenario_data({scenario.name: scenario})[scenario.name],
        "reference_mv": simulation.reference_mv,
        "gpios": simulation.gpios,
        "start_ms": start_ms,
        "duration_ms": simulation.duration_ms,
        "speed": simulation.speed,
    }
    with open(path, "w", encoding="utf-8") as file:
        json.dump(settings, file)


def _follow(process: FirmwareProcess, recording: Recording, watch: Watch, silence_s: float) -> bool:
    """Take in what the process says until it ends; whether it ended with a reset of the board."""
    recording.reason = ""
    heard_s = time.monotonic()
    while not process.is_over:
        items = process.read(_TURN_S)
        for item in items:
            _take(item, recording, watch)
        watch(recording, None)
        now_s = time.monotonic()
        heard_s = now_s if items else heard_s
        if now_s - heard_s > silence_s:
            recording.problem = f"the firmware does not let time pass any more ({silence_s:g} s without a sign of it)"
            return False
    code = process.wait()
    if code == EXIT_RESET and recording.reason == "reset":
        return True
    if code or recording.reason != "over":
        complaints = recording.traceback or list(process.complaints)
        recording.problem = _problem(code, complaints)
        recording.add(Kind.STOPPED, recording.problem)
        for line in complaints:
            recording.add(Kind.CONSOLE, line)
    return False


def _take(item: Item, recording: Recording, watch: Watch) -> None:
    happening = recording.add(Kind.CONSOLE, item.text) if isinstance(item, Console) else recording.take(item)
    if happening is not None:
        watch(recording, happening)


def _problem(code: int, complaints: list[str]) -> str:
    """Why the firmware ended, from its exit code and its traceback, or what it wrote to stderr."""
    if code == 0:
        return "the firmware's main() returned"
    if code < 0:
        return f"the firmware was ended by a signal: {signal.strsignal(-code)}"
    lines = [line.strip() for line in complaints if line.strip()]
    what = lines[-1] if lines else f"exit code {code}"
    places = re.findall(r'File "(.+?)", line (\d+)', "\n".join(lines))
    where = f" ({shown_path(places[-1][0])}:{places[-1][1]})" if places else ""
    return f"the firmware stopped: {what}{where}"
