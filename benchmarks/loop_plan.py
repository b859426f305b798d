"""The plan for benchmarks/micropython/cost_passes.py in a project: the passes to count, and the work due in them."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from pymavlink.dialects.v20 import common

from codegen.loop.frames import due_work, heard_work, sent_together, streamed
from codegen.loop.grid import slots
from codegen.loop.jobs import LINKS, Job, loop_jobs
from codegen.loop.parts import Part, Work
from codegen.loop.pass_share import messages_of_a_pass
from codegen.model.program import LinkKind, Program
from codegen.model.system import System
from codegen.model.vehicle import QuantityKind

LOOK_US = 100000
"""No later streams look again at what they have; then a pass takes a little more."""
WARM_UP_US = 500000
_MOST_PASSES = 400
_FAR_US = 100000000
NOTHING = "nothing"
"""The name of what counting itself takes."""


@dataclass(frozen=True)
class Counted:
    """A count under a ``name``: some ``work``, beside that of the row called ``beyond``."""

    name: str
    of: str
    work: Work
    beyond: str = NOTHING


@dataclass
class Plan:
    """Collects the steps for one project, and what they count; ``now_us`` is the time of the next pass."""

    system: System
    program: Program
    steps: list[list[Any]] = field(default_factory=list)
    counted: list[Counted] = field(default_factory=list)
    now_us: int = 0
    quiet_us: int = 0  # since when all messages are switched off

    def __post_init__(self) -> None:
        """Begin with everything known that can be known, and with a ground station that is heard."""
        self.jobs: tuple[Job, ...] = loop_jobs(self.system, self.program)
        self.slot = slots(self.jobs, self.system, self.program)
        self.slots: list[frozenset[str]] = []
        self.datagrams = any(link.kind is LinkKind.UDP for link in self.system.links)
        kinds = {self.due_at(self.program.control_us * number) for number in range(1, 4000)}
        self.links_alone = min((kind for kind in kinds if LINKS in kind), key=len)
        self.has_control_alone = frozenset() in kinds
        self.steps += [["know", *known] for known in _knowable(self.system)]
        self.steps.append(["count_nothing", NOTHING])
        self.hear()
        self.go(WARM_UP_US)
        self.hear()
        self.go(WARM_UP_US + self.program.links_us + self.program.control_us)
        self.silence()

    def as_json(self) -> dict[str, Any]:
        """Return what the script reads."""
        return {"control_us": self.program.control_us, "datagrams": self.datagrams, "steps": self.steps}

    def due_at(self, now_us: int) -> frozenset[str]:
        """Return the names of the jobs that have their turn in the pass of a time, with the first pass at 0."""
        number = now_us // self.program.control_us
        while len(self.slots) <= number:
            self.slots.append(frozenset(job.name for job in next(self.slot)))
        return self.slots[number]

    def go(self, until_us: int) -> None:
        """Have all passes before a time."""
        self.steps.append(["go", until_us])
        self.now_us = max(self.now_us, -(-until_us // self.program.control_us) * self.program.control_us)

    def find(self, wanted: Callable[[frozenset[str]], bool]) -> int:
        """Return when the next pass is in which such jobs are due, and in which no streams look."""
        at_us = self.now_us
        while not wanted(self.due_at(at_us)) or self.looks_at(at_us):
            at_us += self.program.control_us
            if at_us > self.now_us + _FAR_US:
                raise SystemExit("no pass has only what is to be counted")
        return at_us

    def looks_at(self, at_us: int) -> bool:
        """Return whether streams look again in the pass of a time."""
        return LINKS in self.due_at(at_us) and (at_us - self.quiet_us) % LOOK_US < self.program.links_us

    def next_links(self) -> None:
        """Have all passes before the next one in which as little as possible is due beside links."""
        self.go(self.find(lambda due: due == self.links_alone))

    def hear(self, station: int = 1) -> None:
        """Let a HEARTBEAT of a ground station arrive."""
        sender = common.MAVLink(None, 255, 190)
        frame = sender.heartbeat_encode(common.MAV_TYPE_GCS, common.MAV_AUTOPILOT_INVALID, 0, 0, 0).pack(sender)
        self.steps.append(["arrive", list(frame), ["here", station] if self.datagrams else None])

    def intervals(self, interval_us: int) -> None:
        """Let all messages be sent in an interval: -1 for never, 0 for the rates of their streams."""
        for number in sorted({message.wire.id for message in self.system.messages}):
            self.steps.append(["interval", number, interval_us])

    def silence(self) -> None:
        """Switch all messages off, and have the pass in which that is noticed."""
        self.intervals(-1)
        while LINKS not in self.due_at(self.now_us):
            self.now_us += self.program.control_us
        self.quiet_us = self.now_us
        self.go(self.quiet_us + self.program.control_us)

    def count(self, name: str, of: str, work: Work, beyond: str = NOTHING) -> None:
        """Count the next pass."""
        self.steps.append(["count", name])
        self.counted.append(Counted(name, of, work, beyond))
        self.now_us += self.program.control_us

    def count_passes(self) -> None:
        """Count the pass of control alone, that of links, and one with each other job that is not due too seldom."""
        if self.has_control_alone:
            self.go(self.find(lambda due: not due))
            self.count("control", "control", self.pass_work(frozenset()))
        self.next_links()
        self.count("links", "links", self.pass_work(self.links_alone))
        for job in self.jobs:
            if job.name not in self.links_alone and job.period_us <= _MOST_PASSES * self.program.control_us:
                self.hear()
                self.go(self.now_us + self.program.links_us)
                at_us = self.find(lambda due, name=job.name: name in due)  # type: ignore[misc]
                self.go(at_us)
                self.count(f"job {job.name}", "jobs", self.pass_work(self.due_at(at_us)))

    def pass_work(self, due: frozenset[str]) -> Work:
        """Return what a pass takes in which jobs are due."""
        works = [job.work or Work() for job in self.jobs if job.name in due]
        looked = Work({Part.JOBS: 1, Part.JOB: len(self.jobs), Part.CALL: len(due)}) if due else Work()
        found = sum(works, Work({Part.PASS: 1}) + looked)
        if LINKS in due:
            found[Part.LINK] = 1  # the script opens one
        return found

    def count_jobs(self) -> None:
        """Count passes of jobs that do nothing."""
        period_us = self.program.control_us
        for number, (job_us, calls) in enumerate(((period_us, 1), (period_us, 2), (1 << 28, 2)), 1):
            self.steps.append(["job", job_us])
            self.go(self.now_us + self.program.control_us)
            self.go(self.find(lambda due: not due))
            looked = {Part.JOBS: 1, Part.JOB: len(self.jobs) + number, Part.CALL: calls}
            self.count(f"{number} empty jobs", "empty jobs", Work({Part.PASS: 1, **looked}))

    def count_messages(self) -> None:
        """Count passes in which one message is due, and one in which all of them are, where a pass sends so many."""
        for number in sorted({message.wire.id for message in self.system.messages}):
            tables = [message for message in self.system.messages if message.wire.id == number]
            self.look_around()
            self.next_links()
            self.steps.append(["interval", number, 1000000])
            self.count(f"message {number}", "frames", sent_together(tables, self.system, self.program), "links")
            self.steps.append(["interval", number, -1])
            self.silence()
        if messages_of_a_pass(self.program) < len(streamed(self.system)):
            return
        self.look_around()
        self.next_links()
        self.intervals(0)
        self.count("all messages", "frames", due_work(self.system, self.program), "links")
        self.silence()

    def look_around(self) -> None:
        """Have a pass in which a HEARTBEAT arrives: who is silent is looked for then, once a second."""
        self.next_links()
        self.hear()
        self.go(self.now_us + self.program.links_us)

    def count_heard(self) -> None:
        """Count a pass in which a HEARTBEAT arrives."""
        self.look_around()
        self.next_links()
        self.hear()
        self.count("heard", "heard", heard_work(self.program), "links")

    def count_stations(self) -> None:
        """Count the pass in which a message is due with two stations more; one with nothing to do asks none."""
        for station in (2, 3):
            self.hear(station)
            self.go(self.now_us + 2 * self.program.links_us)
        self.go(self.now_us + WARM_UP_US)
        self.silence()
        self.next_links()
        number = min(message.wire.id for message in self.system.messages)
        self.steps.append(["interval", number, 1000000])
        self.count("stations", "stations", Work({Part.STATION: 2}), f"message {number}")
        self.silence()

    def count_readings(self) -> None:
        """Count what it takes to read each component."""
        for job in self.jobs:
            component = self.system.components.get(job.name)
            if component is not None and component.readings and job.work is not None:
                parts = (Part.COMPONENT, Part.READING, Part.SAMPLE)
                work = Work({part: job.work[part] for part in parts})
                name = f"read {component.name}"
                self.steps.append(["count_call", name, ["state"], f"update_{component.name}", "board"])
                self.counted.append(Counted(name, "readings", work))


def _knowable(system: System) -> Iterator[list[Any]]:
    """The numbers that code can set, with a value of each."""
    for component in system.components.values():
        for quantity in component.quantities.values():
            if not quantity.derivation.is_set_by_code or quantity.kind is not QuantityKind.NUMBER or quantity.elements:
                continue
            steps = (int(quantity.minimum) + int(quantity.maximum)) // 2
            value = float(steps / quantity.steps)
            for number in range(component.instances):
                yield [component.name, number if component.instances > 1 else None, quantity.name, value]
