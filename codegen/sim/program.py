"""One program as a simulation runs it: where it lies, how its batteries are connected, and what it finds."""

import hashlib
import os
from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Any

from codegen.frozen import dataclass
from codegen.model.scenario import Event, Scenario, Stretch, battery_data, event_data
from codegen.model.system import System
from codegen.model.wiring import FIRST_PREFIX, BatteryInput, battery_inputs, first_number


@dataclass(frozen=True, slots=True)
class Connection:
    """How one battery is connected: the GPIO of each ADC input (None: there is none) and what its volts stand for.

    ``reference_mv`` is what full scale stands for, ``current_millionths`` are millionths of an ampere per volt.
    """

    gpio: int | None
    reference_mv: int
    prefix: str = FIRST_PREFIX
    current_gpio: int | None = None
    current_millionths: int = 1_000_000


@dataclass(frozen=True, slots=True)
class SimulatedProgram:
    """A program that runs: ``name`` is what it is called, ``key`` its name in the scenario, None for the vehicle's own.

    ``first_number`` is the parameter with the id of its first battery. ``files`` and ``chunk`` are those of its
    storage, in which ``parameters`` are before it starts. ``stretches`` are its boards, one after the other. ``rover``
    is the file with the user's code, which the program imports as ``module``.
    """

    name: str
    key: str | None
    firmware: str
    mocks: str
    connections: tuple[Connection, ...]
    stretches: tuple[Stretch, ...]
    seed: int = 1
    first_number: str | None = None
    files: tuple[str, ...] = ()
    chunk: int = 64
    parameters: Mapping[str, float] = field(default_factory=dict)
    events: tuple[Event, ...] = ()
    module: str = "rover"
    rover: str | None = None

    @property
    def folder(self) -> str:
        """The folder of its board below the folder that --flash names."""
        return self.key or ""

    def settings(self, stretch: Stretch, *, is_first_start: bool) -> dict[str, Any]:
        """What the mocks have to know about one board; times are those of the scenario."""
        stores = is_first_start and bool(self.parameters)
        store = {"files": self.files, "chunk": self.chunk, "parameters": dict(self.parameters)} if stores else None
        return {
            "batteries": self._batteries(stretch),
            "events": [data for event in self.events if (data := event_data(event)) is not None],
            "unique_id": unique_id(self.key or "", stretch.number),
            "instances": max(1, len(self.connections)),
            "first_number": self.first_number,
            "store": store,
        }

    def _batteries(self, stretch: Stretch) -> list[dict[str, Any]]:
        """The batteries of a board by instance; an instance that the scenario leaves out has none connected."""
        found = []
        for instance, battery in enumerate(stretch.batteries):
            connected = self.connections[instance] if instance < len(self.connections) else Connection(None, 3300)
            # Each battery has noise of its own, and the first the one that the scenario's seed alone makes.
            data = battery_data(battery, self.seed + instance + 16 * (stretch.number - 1))
            found.append(
                data
                | {
                    "gpio": connected.gpio,
                    "reference_mv": connected.reference_mv,
                    "current_gpio": connected.current_gpio,
                    "current_millionths": connected.current_millionths,
                }
            )
        return found


def simulated_programs(
    scenario: Scenario, systems: Sequence[System], folders: Mapping[str, str], rover: str | None
) -> tuple[SimulatedProgram, ...]:
    """The programs of a scenario, the vehicle's own first; ``folders`` are their output folders by their name.

    ``systems`` are the programs of the project, the vehicle's own first.
    """
    main, *others = systems
    known = {system.spec.program: system for system in others}
    programs = [_program(main, None, scenario, scenario.parameters, folders[""], rover)]
    for beside in scenario.beside:
        system = known[beside.program]
        programs.append(_program(system, beside.program, scenario, beside.parameters, folders[beside.program], None))
    return tuple(programs)


def _program(
    system: System,
    key: str | None,
    scenario: Scenario,
    parameters: Mapping[str, float],
    folder: str,
    rover: str | None,
) -> SimulatedProgram:
    storage = system.program.spec.storage if system.program else None
    return SimulatedProgram(
        name=key or system.spec.project.project,
        key=key,
        firmware=os.path.join(folder, "firmware"),
        mocks=os.path.join(folder, "mocks"),
        connections=tuple(_connection(entry, parameters) for entry in battery_inputs(system)),
        stretches=scenario.stretches(key),
        seed=scenario.seed if key is None else scenario.seed + _number(key),
        first_number=first_number(system),
        files=() if storage is None else tuple(storage.files),
        chunk=64 if storage is None else storage.chunk,
        parameters=parameters,
        events=scenario.events if key is None else (),
        module=system.program.module if system.program else "rover",
        rover=rover,
    )


def _connection(entry: BatteryInput, parameters: Mapping[str, float]) -> Connection:
    current = entry.current
    return Connection(
        gpio=entry.voltage.gpio_with(parameters),
        reference_mv=round(entry.voltage.reference * 1000),
        prefix=entry.prefix,
        current_gpio=None if current is None else current.gpio_with(parameters),
        current_millionths=1_000_000 if current is None else round(current.multiplier_with(parameters) * 1_000_000),
    )


def unique_id(key: str, number: int) -> str:
    """The 8 bytes, in hex, that no other board has; the same with each run."""
    return hashlib.sha256(f"{key}/{number}".encode()).hexdigest()[:16]


def _number(key: str) -> int:
    """A number that programs of different names hardly share."""
    return int(hashlib.sha256(key.encode()).hexdigest()[:4], 16)
