"""One program as a simulation runs it: where it lies, what it finds, and what is recorded of it."""

import errno
import hashlib
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any

from codegen.frozen import dataclass
from codegen.loop.load import TrafficLoad, traffic_load
from codegen.model.listening import bridged_link, deaf_links, spoken_cable
from codegen.model.program_folders import ProgramFolders
from codegen.model.scenario import Event, Scenario, Stretch, course_data, event_data
from codegen.model.system import System
from codegen.sim.address import LinkEnd
from codegen.sim.guards import Guard, guards
from codegen.sim.line import Line, Watched, lines_of, watched
from codegen.sim.told import Telling

MODULE = "app"
"""The module of the user's code where no other is named."""

SCRIPT = "sim.py"
"""The mock that runs the firmware of a simulation."""


@dataclass(frozen=True, slots=True)
class SimulatedProgram:
    """A program that runs: ``name`` is what it is called, ``key`` its name in the scenario, None for the vehicle's own.

    Its modules lie in ``folders``. ``files`` and ``chunk`` are those of its storage, in which ``parameters`` are before
    it starts. ``stretches`` are its boards, one after the other. ``code`` is the file with the user's code, which the
    program imports as ``module``.
    ``messages`` are the names of those of its dialect by number, ``telling`` knows which of them tell of quantities,
    ``lines`` are these; ``watched`` are quantities of its state, ``actions`` the methods that failsafes call.
    ``mocked`` are the modules that stand in for what its sensors are connected to, ``left_out`` those of the user's
    sensors where no code of the user runs, each with the class of the vehicle if it is the module of that, too.
    ``load`` predicts how busy its board is, or says why nothing does. ``restart_cause`` is what its board tells after
    a restart. ``ends`` are those of its links over TCP, by their names: its servers listen on this computer alone, its
    clients connect to who gets its UDP. ``deaf`` are the names of those that take nothing of what the scenario sends,
    since nobody signs it, ``bridge`` is the cable in whose place UDP stands on a board without a network, ``spoken``
    the one by which the scenario speaks where the network takes nothing.
    """

    name: str
    key: str | None
    folders: ProgramFolders
    stretches: tuple[Stretch, ...]
    seed: int = 1
    files: tuple[str, ...] = ()
    chunk: int = 64
    parameters: Mapping[str, float] = field(default_factory=dict)
    events: tuple[Event, ...] = ()
    module: str = MODULE
    code: str | None = None
    messages: Mapping[int, str] = field(default_factory=dict)
    telling: Telling = field(default_factory=Telling)
    lines: tuple[Line, ...] = ()
    watched: tuple[Watched, ...] = ()
    actions: tuple[str, ...] = ()
    guards: tuple[Guard, ...] = ()
    mocked: tuple[str, ...] = ()
    left_out: tuple[tuple[str, str | None], ...] = ()
    load: TrafficLoad | str = ""
    restart_cause: int | None = None
    ends: Mapping[str, LinkEnd] = field(default_factory=dict)
    deaf: tuple[str, ...] = ()
    bridge: str | None = None
    spoken: str | None = None

    @property
    def paths(self) -> tuple[str, ...]:
        """The folders of its modules, in the order in which they are looked for."""
        return self.folders.of("firmware", "mocks")

    @property
    def script(self) -> str:
        """The file that is started. OSError if it is not there."""
        path = self.folders.find("mocks", SCRIPT)
        if path is None:
            raise FileNotFoundError(
                errno.ENOENT, os.strerror(errno.ENOENT), os.path.join(self.folders.own, "mocks", SCRIPT)
            )
        return path

    @property
    def folder(self) -> str:
        """The folder of its board below the folder that --flash names."""
        return self.key or ""

    def settings(self, stretch: Stretch, *, is_first_start: bool) -> dict[str, Any]:
        """Return what the mocks have to know about one board; times are those of the scenario."""
        stores = is_first_start and bool(self.parameters)
        store = {"files": self.files, "chunk": self.chunk, "parameters": dict(self.parameters)} if stores else None
        # Each course has noise of its own, and the first the one that the scenario's seed alone makes.
        seed = self.seed + 16 * (stretch.number - 1)
        return {
            "courses": [course_data(course, seed + number) for number, course in enumerate(stretch.courses)],
            "events": [data for event in self.events if (data := event_data(event)) is not None],
            "deaf": self.deaf,
            "bridge": self.bridge,
            "spoken": self.spoken,
            "unique_id": unique_id(self.key or "", stretch.number),
            "told": self.telling.ids,
            "watched": [[each.label, each.component, each.instance, each.name, each.ages] for each in self.watched],
            "actions": self.actions,
            "mocked": self.mocked,
            "left_out": self.left_out,
            "store": store,
            "reset_cause": None if is_first_start else self.restart_cause,
        }


def simulated_programs(
    scenario: Scenario, systems: Sequence[System], folders: Mapping[str, ProgramFolders], code: str | None
) -> tuple[SimulatedProgram, ...]:
    """The programs of a scenario, the vehicle's own first; ``folders`` are where each lies, by its name.

    ``systems`` are the programs of the project, the vehicle's own first; ``code`` is the file with the user's code.
    """
    main, *others = systems
    known = {system.spec.program: system for system in others}
    programs = [_program(main, None, scenario, scenario.parameters, folders[""], code)]
    for beside in scenario.beside:
        system = known[beside.program]
        programs.append(_program(system, beside.program, scenario, beside.parameters, folders[beside.program], None))
    return tuple(programs)


def _program(
    system: System,
    key: str | None,
    scenario: Scenario,
    parameters: Mapping[str, float],
    folders: ProgramFolders,
    code: str | None,
) -> SimulatedProgram:
    program = system.program
    storage = program.spec.storage if program else None
    return SimulatedProgram(
        name=key or system.spec.project.project,
        key=key,
        folders=folders,
        stretches=scenario.stretches(key),
        seed=scenario.seed if key is None else scenario.seed + _number(key),
        files=() if storage is None else tuple(storage.files),
        chunk=64 if storage is None else storage.chunk,
        parameters=parameters,
        events=scenario.events if key is None else (),
        module=program.module if program else MODULE,
        code=code,
        messages={wire.id: name for name, wire in system.dialect.messages.items()},
        telling=Telling(system.messages),
        lines=lines_of(system, scenario, key),
        watched=watched(system, scenario.expected if key is None else ()),
        actions=tuple(dict.fromkeys(action.call for action in program.actions)) if program else (),
        guards=guards(system),
        mocked=tuple(_mocked(system)),
        left_out=() if code else tuple(_left_out(system)),
        load=traffic_load(system),
        ends=dict(_ends(system)),
        restart_cause=program.watchdog.board.spec.restart if program and program.watchdog else None,
        deaf=deaf_links(system),
        bridge=bridged_link(system),
        spoken=spoken_cable(system),
    )


def _ends(system: System) -> Iterator[tuple[str, LinkEnd]]:
    for link in system.links:
        if link.spec.tcp_server is not None:
            yield link.name, LinkEnd("127.0.0.1", link.spec.tcp_server)
        elif link.spec.tcp_client is not None:
            yield link.name, LinkEnd(None, link.spec.tcp_client)


def _left_out(system: System) -> Iterator[tuple[str, str | None]]:
    """Yield the modules of the user's sensors, each with the class of the user's vehicle that stands in it, or None."""
    program = system.program
    for module in dict.fromkeys(each.imported for each in system.polled if each.imported):
        yield module, program.class_name if program and program.module == module else None


def _mocked(system: System) -> Iterator[str]:
    """The modules among the mocks of its sensors that are not about courses, each once."""
    paths = dict.fromkeys(path for source in system.polled for path in source.mocks)
    names = (os.path.basename(path).removesuffix(".py") for path in paths)
    return (name for name in names if not name.startswith("sim_"))


def unique_id(key: str, number: int) -> str:
    """The 8 bytes, in hex, that no other board has; the same with each run."""
    return hashlib.sha256(f"{key}/{number}".encode()).hexdigest()[:16]


def _number(key: str) -> int:
    """A number that programs of different names hardly share."""
    return int(hashlib.sha256(key.encode()).hexdigest()[:4], 16)
