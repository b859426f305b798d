"""View of vehicle.py, and of the modules around it: the program as a whole, the storage and what failsafes do."""

from collections.abc import Iterator, Sequence

from codegen.frozen import dataclass
from codegen.loop.pass_share import jobs_of_a_pass, messages_of_a_pass, parts_links
from codegen.model.program import LinkKind, Program, is_set_by_program
from codegen.model.spec.program import ActionSpec
from codegen.model.system import System
from codegen.model.vehicle import Parameter
from codegen.targets.firmware.failsafes.acting import check_statements, choosing_statements
from codegen.targets.firmware.failsafes.failsafe import FailsafesView, FailsafeView
from codegen.targets.firmware.messages.receiving import call_name, received_beside
from codegen.targets.firmware.messages.sending import number_at
from codegen.targets.firmware.program.commands import MethodView, ModeView, method_views, mode_statements, mode_views
from codegen.targets.firmware.program.main_loop import CallView, JobView, call_views, job_views, own_words
from codegen.targets.firmware.program.watchdog import WatchdogView, watchdog_view
from codegen.targets.firmware.program.watching import watched, watching
from codegen.targets.firmware.words import ConstantView, Layout, aged_words
from codegen.targets.imports import import_lines, one_by_one, tuple_text
from codegen.targets.naming import class_names, parameter_attribute, prose

_STARTS = {
    True: ("self._in_force = 0  # the action", "self._asked = None  # parameters.changes when it was chosen"),
    False: ("self._reached = None  # the failsafe that has reached the highest level just now",),
}
"""The first statements of the choice of actions, with and without a priority."""
_READINGS = {True: "readings with their failsafes", False: "readings"}
_INDENT = " " * 8
"""Of the statements in a method."""


@dataclass(frozen=True, slots=True)
class ActionView:
    """A call of the vehicle that a failsafe makes, and the statements that it takes to make it."""

    value: int
    call: str
    doc: str
    mode: int | None
    disarm: bool
    statements: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class CallOnReceiving:
    """A method of the user's vehicle that is called each time that a message has set quantities."""

    name: str
    message: str
    citation: str


@dataclass(frozen=True, slots=True)
class AnsweredView:
    """A command that every program answers, and the method of commands.py that does."""

    name: str
    method: str


@dataclass(frozen=True, slots=True)
class ProgramView:
    """The data for the templates of the program. Periods are in us or ms as their names say.

    ``force`` is None where nothing can be armed, ``measure_us`` where the user's code is not asked to measure.
    ``order`` are the parts of a pass, ``calls`` those with a period of their own. ``connecting`` are the
    statements that make the connection of a port. ``commands`` are those that commands.py answers, ``methods`` those of
    the vehicle that do the commands of the project. ``numbered``: a message tells which instance it is about.
    ``is_bytewise``: parameters go over the wire as the bytes of their types.
    """

    imports: tuple[str, ...]
    control_us: int
    control_hz: str
    links_us: int
    checks_us: int
    links_hz: str
    report_ms: int
    step_limit_us: int
    files: tuple[str, ...]
    chunk: int
    force: int | None
    measure_us: int | None
    measure_hz: str
    module: str
    class_name: str
    silence_ms: int
    sets_status: bool
    failsafes: tuple[FailsafeView, ...]
    words: tuple[ConstantView, ...]
    failsafe_lists: tuple[str, ...]
    checked: str
    everything: str
    priority: tuple[int, ...]
    checking: tuple[str, ...]
    choosing: tuple[str, ...]
    actions: tuple[ActionView, ...]
    order: tuple[str, ...]
    calls: tuple[CallView, ...]
    jobs: tuple[JobView, ...]
    messages_of_a_pass: int
    jobs_of_a_pass: int
    parts_links: bool
    has_ports: bool
    has_usb: bool
    has_sources: bool
    connecting: tuple[str, ...]
    access: str
    keeping: str
    watchdog: WatchdogView | None
    running: str
    received_calls: tuple[CallOnReceiving, ...]
    commands: tuple[AnsweredView, ...]
    methods: tuple[MethodView, ...]
    takes_long: bool
    numbered: bool
    is_bytewise: bool
    forgets: bool
    modes: tuple[ModeView, ...]
    mode_statements: tuple[str, ...]
    cited: dict[str, str]


def program_view(system: System, program: Program, whole: FailsafesView | None, layout: Layout) -> ProgramView:
    """The view of the whole program; ``whole`` has its failsafes."""
    failsafes = whole.failsafes if whole else ()
    jobs = job_views(system, program, failsafes)
    can_arm = program.spec.arming is not None
    sets_status = can_arm or (bool(failsafes) and is_set_by_program(system.components.get("vehicle"), "status"))
    told = own_words(system, program)
    recovers = whole is not None and whole.has_recovery
    return ProgramView(
        imports=_imports(system, program, failsafes, sets_status=sets_status),
        control_us=program.control_us,
        control_hz=program.spec.control.rate,
        links_us=program.links_us,
        checks_us=program.checks_us,
        links_hz=program.spec.control.links,
        report_ms=program.report_ms,
        step_limit_us=program.step_limit_us,
        files=program.spec.storage.files,
        chunk=program.spec.storage.chunk,
        force=program.spec.arming.force if program.spec.arming else None,
        measure_us=program.measure_us,
        measure_hz=(program.spec.code.measure or "") if program.spec.code else "",
        module=program.module,
        class_name=program.class_name,
        silence_ms=program.silence_ms,
        sets_status=sets_status,
        failsafes=failsafes,
        words=layout.constants("vehicle", told, in_array=False) if told else (),
        failsafe_lists=(
            *_failsafe_lists(failsafes),
            *(_STARTS[bool(program.priority)] if failsafes else ()),
        ),
        checked=_checked(failsafes),
        everything=_everything(failsafes),
        priority=tuple(action.value for action in program.priority),
        checking=check_statements(program, recovers=recovers, sets_status=sets_status),
        choosing=choosing_statements(program, _everything(failsafes), recovers=recovers, sets_status=sets_status),
        actions=tuple(_action(action, has_modes=bool(program.modes)) for action in program.actions),
        order=("control", _READINGS[bool(failsafes)], *(["arming checks"] if can_arm else []), "links"),
        calls=call_views(system, program, jobs),
        jobs=jobs,
        messages_of_a_pass=messages_of_a_pass(program),
        jobs_of_a_pass=jobs_of_a_pass(system, program),
        parts_links=parts_links(system, program),
        has_ports=bool(system.links),
        has_sources=bool(system.polled),
        received_calls=tuple(
            CallOnReceiving(call_name(table), table.title, str(table.citation))
            for table in system.receptions
            if table.spec.call
        ),
        has_usb=any(link.kind is LinkKind.USB for link in system.links),
        connecting=_connecting(system, program),
        access=_access(program),
        keeping=_keeping(program),
        watchdog=watchdog_view(program),
        running=_running(program),
        commands=tuple(AnsweredView(each.name, each.method) for each in program.built_in if each.method),
        methods=method_views(program),
        takes_long=_takes_long(program),
        forgets=bool(tuple(aged_words(layout))),
        is_bytewise=system.is_bytewise,
        numbered=any(number_at(message) is not None for message in system.messages),
        modes=mode_views(program.modes),
        mode_statements=mode_statements(program.modes),
        cited={
            **{name: str(program.cited.get(name, "")) for name in ("control", "storage", "arming", "services")},
            "standing": str(program.aspects.get("services", {}).get("standing", "")),
        },
    )


def _imports(
    system: System, program: Program, failsafes: tuple[FailsafeView, ...], *, sets_status: bool
) -> tuple[str, ...]:
    dialect = ["dialect"] if sets_status else []
    modules = ["asyncio", "gc", "machine", *(["messages"] if program.received_besides else []), *dialect]
    modules += ["watchdog"] if program.watchdog else []
    access = program.access
    names = [
        *([("access", "Access")] if access and access.signed else []),
        *([("key_service", "take_keys")] if access and access.spec.setup else []),
        ("board", "Board"),
        *_answering(system, program).items(),
        ("connection", "Connection"),
        *(("failsafe", failsafe.attribute) for failsafe in failsafes),
        ("guard", "Guard"),
        *([("long_commands", "LongCommands")] if _takes_long(program) else []),
        *([("listed_stations", "admit_only")] if access and access.listed else []),
        ("micropython", "const"),
        ("parameters", "Parameters"),
        ("scheduler", "AGAIN"),
        ("scheduler", "Scheduler"),
        *([("sources", "Sources")] if system.polled else []),
        ("services", "receivable"),
        *([("receiving", "KINDS")] if received_beside(system) else []),
        ("state", "SystemState"),
        ("storage", "Storage"),
        ("streams", "Streams"),
        ("streams", "open_link"),
        *([] if system.system_parameter else [("streams", "SYSTEM_ID")]),
        ("texts", "Texts"),
        *(("time", name) for name in ("ticks_diff", "ticks_ms", "ticks_us")),
        *([("twins", "watch_twins")] if system.component_parameter else []),
    ]
    if watched(system):
        modules.append("messages")
    return import_lines(modules, names)


def _answering(system: System, program: Program) -> dict[str, str]:
    """The functions that let a connection answer more than every program does, by their modules."""
    return {
        **({"clock_service": "follow_time"} if program.takes_time else {}),
        **({"receiving": "receive_into"} if system.receptions else {}),
        **({"own_commands": "answer_commands"} if program.commands else {}),
        **({"command_cancel": "answer_cancel"} if program.cancels else {}),
        **({"mode_service": "answer_modes"} if program.modes else {}),
        **({"set_mode": "answer_set_mode"} if program.changes_modes_by_message else {}),
    }


def _failsafe_lists(failsafes: tuple[FailsafeView, ...]) -> Iterator[str]:
    """The statements that make the lists of failsafes: of each its instances, all, and those that arming asks."""
    for failsafe in failsafes:
        yield f"self.{failsafe.attribute} = {failsafe.attribute}(self)"
    if len(failsafes) > 1:
        yield f"self._failsafes = {_all(failsafes)}"
    asked = [failsafe for failsafe in failsafes if failsafe.has_arming]
    if asked and len(asked) < len(failsafes):
        yield "# Those that are asked before arming."
        yield f"self._before_arming = {_all(asked)}"


def _all(failsafes: Sequence[FailsafeView]) -> str:
    lists = [f"self.{failsafe.attribute}" for failsafe in failsafes]
    if len(lists) < 3:
        return " + ".join(lists)
    return "(\n            " + "\n            + ".join(lists) + "\n        )"


def _checked(failsafes: tuple[FailsafeView, ...]) -> str:
    """The list of those that arming asks; nothing where there are none."""
    asked = sum(failsafe.has_arming for failsafe in failsafes)
    if not asked:
        return ""
    return _everything(failsafes) if asked == len(failsafes) else "self._before_arming"


def _everything(failsafes: tuple[FailsafeView, ...]) -> str:
    """The list of all of them."""
    return f"self.{failsafes[0].attribute}" if len(failsafes) == 1 else "self._failsafes"


def _connecting(system: System, program: Program) -> tuple[str, ...]:
    """The statements that return the connection of a port, with all that it answers."""
    ids = [f"self.parameters.{_attribute(system.system_parameter)}" if system.system_parameter else "SYSTEM_ID"]
    if system.component_parameter:
        ids.append(f"self.parameters.{_attribute(system.component_parameter)}")
    if system.signs:
        ids.append("signing=self.access.signing(port.name)")
    given = ["port", f"receivable({', '.join(_received(system, program))})", *ids]
    link = [line.removeprefix(_INDENT) for line in one_by_one(f"{_INDENT}link = open_link", given)]
    connection = "Connection(self, port, link, lambda budget: Streams(self.state, link, budget))"
    answering = [
        f"{name}(connection, {'self.state.clock' if module == 'clock_service' else 'self'})"
        for module, name in _answering(system, program).items()
    ]
    absent = tuple(absence.question.id for absence in program.absences)
    answering += [f"connection.services.expect({absent})"] if absent else []
    answering += [*watching(system, program), *_admitting(program)]
    if not answering:
        return (*link, f"return {connection}")
    return (*link, f"connection = {connection}", *answering, "return connection")


def _admitting(program: Program) -> Iterator[str]:
    """The statements that let a connection hear listed stations only, or take the key of others."""
    access = program.access
    if access is not None and access.listed:
        yield f"if port.name in {tuple_text(access.listed)}:"
        yield f"    admit_only(connection, {tuple_text(access.spec.stations)})"
    if access is not None and access.spec.setup:
        yield f"if port.name in {tuple_text(access.spec.setup)}:"
        yield "    take_keys(connection, self)"


def _access(program: Program) -> str:
    """The statement that makes what signs links; nothing where none is signed."""
    access = program.access
    if access is None or not access.signed:
        return ""
    links = tuple_text(access.signed.items())
    return f'{_INDENT}self.access = Access("{access.spec.key}", {links}, self.texts)'


def _keeping(program: Program) -> str:
    """The lines of the task that keeps parameters by which it keeps timestamps, too."""
    if program.access is None or not program.access.signed:
        return ""
    call = "self.access.keep()"
    return (
        f"            if not self.is_armed:\n                {call}" if program.spec.arming else f"            {call}"
    )


def _running(program: Program) -> str:
    """The statements that run the vehicle until its program ends."""
    run = "asyncio.run(vehicle.run())"
    lines = [
        f"    {run}",
        *(
            [
                "except KeyboardInterrupt:  # somebody is at the prompt",
                "    from watchdog import hold  # noqa: PLC0415",
                "",
                "    hold()",
                "    raise",
            ]
            if program.watchdog
            else []
        ),
        *(["finally:", "    vehicle.halt_motors()"] if program.spec.arming else []),
    ]
    return "\n".join(f"    {line}" if line else "" for line in (["try:", *lines] if len(lines) > 1 else [run]))


def _received(system: System, program: Program) -> tuple[str, ...]:
    """The classes of the messages that a link receives beside those that the services of every program answer."""
    classes = class_names(wire.name for wire in system.wires)
    besides = [*program.received_besides, *(message.wire.name for message in watched(system))]
    own = [f"messages.{classes[name]}" for name in besides]
    return (*own, *(["*KINDS"] if received_beside(system) else []))


def _takes_long(program: Program) -> bool:
    return any(command.spec.long for command in program.commands)


def _attribute(parameter: Parameter) -> str:
    return parameter_attribute(parameter.name)


def _action(action: ActionSpec, *, has_modes: bool) -> ActionView:
    return ActionView(
        value=action.value,
        call=action.call,
        doc=prose(action.doc),
        mode=action.mode,
        disarm=action.disarm,
        statements=_statements(action, has_modes=has_modes),
    )


def _statements(action: ActionSpec, *, has_modes: bool) -> tuple[str, ...]:
    call = f"self.{action.call}()"
    enter = f"self._enter({action.mode})" if has_modes else f"self.state.vehicle.mode_number = {action.mode}"
    mode = [] if action.mode is None else [enter]
    if not action.disarm:
        return (*mode, call)
    comment = "a fault in the user's code does not keep the motors turning"
    return (*mode, "try:", f"    {call}", f"finally:  # {comment}", "    self.disarm(force=True)")


def dialect_text(program: Program) -> str:
    """The module dialect.py: the numbers of the dialect that the program uses."""
    lines = [f"{name} = {value}" for name, value in program.constants.items()]
    return '"""Numbers of the dialect that the program uses."""\n\n' + "\n".join(lines) + "\n"
