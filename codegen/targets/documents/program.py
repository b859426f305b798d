"""The review document's part about the program: streams, links, main loop, failsafes and their actions."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.failsafe import Failsafe, FailsafeLevel
from codegen.model.program import BoardLink, LinkKind, Program
from codegen.model.spec.failsafe import Watching
from codegen.model.spec.program import ActionSpec
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Parameter, Stream
from codegen.summaries.fields import in_table
from codegen.targets.documents.commands import CommandLine, ModeLine, command_lines, mode_lines


@dataclass(frozen=True, slots=True)
class StreamRow:
    """A stream: what sets its rate, its limit, how it is asked for, and what goes out with it."""

    name: str
    rate: str
    fastest: str
    data_stream: str
    messages: str
    criterion: str


@dataclass(frozen=True, slots=True)
class LinkRow:
    """A link to ground stations."""

    name: str
    over: str
    details: str
    criterion: str


@dataclass(frozen=True, slots=True)
class LoopRow:
    """Something that the main loop does again and again."""

    job: str
    period: str
    criterion: str


@dataclass(frozen=True, slots=True)
class LevelRow:
    """A level of a failsafe, with the defaults of its parameters."""

    watched: str
    level: str
    when: str
    after: str
    action: str
    criterion: str


@dataclass(frozen=True, slots=True)
class ActionRow:
    """The row of an action that failsafes can take."""

    value: int
    call: str
    mode: str
    disarms: str
    doc: str


@dataclass(frozen=True, slots=True)
class ProgramSection:
    """The main loop, the failsafes, commands and modes, and ``notes``: sentences about arming, storage and services."""

    loop: tuple[LoopRow, ...]
    levels: tuple[LevelRow, ...]
    actions: tuple[ActionRow, ...]
    commands: tuple[CommandLine, ...]
    modes: tuple[ModeLine, ...]
    notes: tuple[str, ...]


def stream_rows(system: System) -> tuple[StreamRow, ...]:
    """The streams in the order of streams.yaml."""
    return tuple(_stream(stream, system) for stream in system.streams.values())


def _stream(stream: Stream, system: System) -> StreamRow:
    parameter = stream.parameter
    rate = (
        f"{decimal(stream.rate or Fraction(0))} Hz" if parameter is None else f"{parameter.name}, {_default(parameter)}"
    )
    return StreamRow(
        name=stream.name,
        rate=rate,
        fastest=f"{decimal(stream.fastest)} Hz",
        data_stream=stream.spec.data_stream or "",
        messages=", ".join(message.name for message in system.messages if message.stream is stream),
        criterion=str(stream.citation or ""),
    )


def link_rows(system: System) -> tuple[LinkRow, ...]:
    """The links in the order of board.yaml."""
    return tuple(
        LinkRow(link.name, link.kind.words, _details(link) + _obeys(link, system), str(link.citation or ""))
        for link in system.links
    )


def _obeys(link: BoardLink, system: System) -> str:
    """Whom a link obeys, where that is not everybody."""
    access = system.program.access if system.program else None
    if access is None or link.name not in (*access.signed, *access.listed):
        return ""
    return "; signed" if link.name in access.signed else f"; listed: {', '.join(map(str, access.spec.stations))}"


def _details(link: BoardLink) -> str:
    spec = link.spec
    if link.kind is LinkKind.UART:
        return f"UART {spec.uart}, GPIO {spec.tx} out and {spec.rx} in, {spec.baud} baud, {spec.buffer} bytes wait"
    if link.kind is LinkKind.USB:
        return f"{spec.buffer} bytes wait"
    wifi = f"; {spec.credentials} wins; Wi-Fi is tried every {link.retry_ms} ms"
    given_up = f"; closed after {link.timeout_ms} ms of silence"
    if link.kind is LinkKind.TCP_SERVER:
        return f"at port {spec.tcp_server}, {spec.tcp_backlog} wait{given_up}{wifi}"
    if link.kind is LinkKind.TCP_CLIENT:
        again = f"; again after {link.retry_ms} ms and longer pauses"
        return f"to {spec.to} port {spec.tcp_client}{again}{given_up}{wifi}"
    local = f", from port {spec.local_port}" if spec.local_port else ""
    return f"to {spec.to} port {spec.udp}{local}{wifi}"


def program_section(system: System) -> ProgramSection | None:
    """The program; None for a project that has none."""
    program = system.program
    if program is None:
        return None
    spec = program.spec
    cited = {name: f" ({citation})" for name, citation in program.cited.items()}
    loop = [LoopRow("control", f"{program.control_us} us", str(program.cited.get("control", "")))]
    for name, quantity, _ in system.measured():
        component = system.components[name]
        period = f"{component.read_every_ms} ms"
        loop.append(LoopRow(f"readings of {quantity.path}", period, str(component.citation or "")))
    loop.append(LoopRow("links", f"{program.links_us} us", str(program.cited.get("services", ""))))
    loop.append(LoopRow("report of missed slots", f"{program.report_ms} ms", str(program.cited.get("control", ""))))
    files = " and ".join(f"`{name}`" for name in spec.storage.files)
    notes = [
        f"Parameters are saved in turns in {files}, {spec.storage.chunk} bytes in a step{cited.get('storage', '')}.",
        f"A step of a save that takes longer than {spec.storage.step_limit} is warned about.",
        f"A command arms past the checks with {spec.arming.force}{cited.get('arming', '')}."
        if spec.arming
        else "There is nothing to arm: the command for it is unknown, and parameters are saved at any time.",
        f"Messages without a stream are sent at most at {decimal(program.fastest)} Hz{cited.get('services', '')}.",
        f"A ground station that was silent for {program.silence_ms} ms is told anew what is sent on connection.",
        f"The system id is {system.system_id}{_default_of(system.system_parameter)}.",
        *_priority(program),
        *(
            [f"The component id is {system.component_id}{_default_of(system.component_parameter)}."]
            if system.component_parameter
            else []
        ),
    ]
    return ProgramSection(
        loop=tuple(loop),
        levels=tuple(row for failsafe in program.failsafes for row in _levels(failsafe)),
        actions=tuple(_action(action) for action in program.actions),
        commands=command_lines(program),
        modes=mode_lines(program.modes),
        notes=(*notes, *(sentence for failsafe in program.failsafes for sentence in _sentences(failsafe))),
    )


def _priority(program: Program) -> list[str]:
    """The sentence about failsafes that are up at once."""
    if not program.priority:
        return []
    calls = ", then ".join(f"`{action.call}`" for action in program.priority)
    return [f"Of the actions that failsafes ask for while they are up, the most severe holds: {calls}."]


def _default_of(parameter: Parameter | None) -> str:
    return f", the default of {parameter.name}" if parameter else ""


def _levels(failsafe: Failsafe) -> list[LevelRow]:
    return [
        LevelRow(
            watched=(condition.quantity.path if condition.quantity else failsafe.watched),
            level=f"{level.number} {level.name}",
            when=f"{condition.sense.value} {condition.limit.default_words if condition.limit else ''}".rstrip(),
            after=condition.after.default_words if condition.after else "at once",
            action=_chosen(level),
            criterion=str(level.citation or failsafe.citation),
        )
        for level in failsafe.levels
        for condition in level.conditions
    ]


def _chosen(level: FailsafeLevel) -> str:
    if level.action is None:
        return "a text"
    if isinstance(level.action, Parameter):
        return f"{level.action.name}, {_default(level.action)}"
    return f"`{level.action.call}`"


def _sentences(failsafe: Failsafe) -> list[str]:
    watched, spec = failsafe.watched, failsafe.spec
    found = [
        f"The failsafe of {watched} looks {'at all times' if spec.when is Watching.ALWAYS else 'while armed'}; a level "
        + ("stays until the next start." if spec.latch else "is over once nothing of it holds."),
    ]
    for condition in failsafe.to_arm:
        limit = condition.limit.default_words if condition.limit else ""
        off = ", which 0 switches off" if condition.limit and condition.limit.is_off_at_zero else ""
        path = condition.quantity.path if condition.quantity else watched
        found.append(f"The vehicle is not armed while {path} is {condition.sense.value} {limit}".rstrip() + f"{off}.")
    if not spec.arming:
        found.append("It does not keep the vehicle from being armed.")
    if failsafe.enabled_by is not None:
        found.append(f"{failsafe.enabled_by.name}, {_default(failsafe.enabled_by)}, switches it off with 0.")
    if failsafe.believed_above is not None and failsafe.quantity is not None:
        unit = failsafe.quantity.stored.name
        found.append(f"A {watched} of {failsafe.believed_above} {unit} or less counts as unknown for its levels.")
    if failsafe.health is not None:
        last = failsafe.levels[-1].name
        found.append(
            f"{failsafe.health.path} is 0 while {watched} is good, else the number of the level whose condition holds, "
            f"and that of {last} while it is unknown."
        )
    if failsafe.level is not None:
        found.append(f"{failsafe.level.path} is the number of the level that was reached.")
    texts = dict.fromkeys(level.text.written for level in failsafe.levels)
    found.append(f"It says {' or '.join(f'`{text}`' for text in texts)}.")
    return found


def _action(action: ActionSpec) -> ActionRow:
    mode = "" if action.mode is None else str(action.mode)
    return ActionRow(action.value, action.call, mode, "yes" if action.disarm else "", in_table(action.doc))


def _default(parameter: Parameter) -> str:
    """``10.5 V by default``."""
    unit = f" {parameter.unit.name}" if parameter.unit.name else ""
    return f"{decimal(parameter.default * parameter.step)}{unit} by default"
