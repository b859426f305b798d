"""View of vehicle.py, and of the modules around it: the program as a whole, the storage and what failsafes do."""

from codegen.frozen import dataclass
from codegen.model.clock import SYSTEM_TIME
from codegen.model.program import LinkKind, Program
from codegen.model.program_spec import ActionSpec
from codegen.model.system import System
from codegen.model.vehicle import Parameter
from codegen.targets.firmware.failsafe import FailsafeView, failsafe_families, failsafe_views
from codegen.targets.firmware.main_loop import CallView, JobView, call_views, job_views
from codegen.targets.firmware.receiving import call_name, received_beside
from codegen.targets.imports import import_lines
from codegen.targets.naming import class_names, parameter_attribute, prose


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
    """What is called of the user's vehicle each time that a message has set quantities."""

    name: str
    message: str
    citation: str


@dataclass(frozen=True, slots=True)
class ProgramView:
    """What the templates of the program need to know. Periods are in us or ms as their names say.

    ``force`` is None where nothing can be armed, ``measure_us`` where the user's code is not asked to measure.
    ``order`` are the parts of a pass, ``calls`` those with a period of their own. ``received`` are the classes of the
    messages that are received beside those of the services, ``connecting`` the statements that make a connection and
    let others take what it receives.
    """

    imports: tuple[str, ...]
    control_us: int
    control_hz: str
    links_us: int
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
    system_parameter: str | None
    component_parameter: str | None
    failsafes: tuple[FailsafeView, ...]
    families: tuple[str, ...]
    actions: tuple[ActionView, ...]
    order: tuple[str, ...]
    calls: tuple[CallView, ...]
    jobs: tuple[JobView, ...]
    has_ports: bool
    has_usb: bool
    has_sources: bool
    received: tuple[str, ...]
    connecting: tuple[str, ...]
    received_calls: tuple[CallOnReceiving, ...]
    cited: dict[str, str]


def program_view(system: System, program: Program) -> ProgramView:
    """The view of the whole program."""
    failsafes = failsafe_views(program)
    jobs = job_views(system, program, failsafes)
    can_arm = program.spec.arming is not None
    return ProgramView(
        imports=_imports(system, program, failsafes),
        control_us=program.control_us,
        control_hz=program.spec.control.rate,
        links_us=program.links_us,
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
        system_parameter=_attribute(system.system_parameter),
        component_parameter=_attribute(system.component_parameter),
        silence_ms=program.silence_ms,
        failsafes=failsafes,
        families=failsafe_families(program),
        actions=tuple(_action(action) for action in program.actions),
        order=("control", *(("readings with their failsafes", "arming checks") if can_arm else ("readings",)), "links"),
        calls=call_views(system, program, jobs),
        jobs=jobs,
        has_ports=bool(system.links),
        has_sources=bool(system.polled),
        received=_received(system, program),
        connecting=_connecting(system, program),
        received_calls=tuple(
            CallOnReceiving(call_name(table), table.title, str(table.citation))
            for table in system.receptions
            if table.spec.call
        ),
        has_usb=any(link.kind is LinkKind.USB for link in system.links),
        cited={name: str(program.cited.get(name, "")) for name in ("control", "storage", "arming", "services")},
    )


def _imports(system: System, program: Program, failsafes: tuple[FailsafeView, ...]) -> tuple[str, ...]:
    modules = ["asyncio", "gc", "machine", "time", *(["dialect"] if program.spec.arming else [])]
    modules += ["messages"] if program.takes_time else []
    names = [
        ("board", "Board"),
        ("connection", "Connection"),
        *(("failsafe", failsafe.class_name) for failsafe in failsafes),
        ("guard", "Guard"),
        ("micropython", "const"),
        ("parameters", "Parameters"),
        ("scheduler", "Scheduler"),
        *([("sources", "Sources")] if system.polled else []),
        ("services", "receivable"),
        *([("clock_service", "follow_time")] if program.takes_time else []),
        *([("receiving", "receive_into")] if system.receptions else []),
        *([("receiving", "KINDS")] if received_beside(system) else []),
        ("state", "SystemState"),
        ("storage", "Storage"),
        ("streams", "Streams"),
        ("streams", "open_link"),
        *([] if system.system_parameter else [("streams", "SYSTEM_ID")]),
        ("texts", "Texts"),
    ]
    return import_lines(modules, names)


def _received(system: System, program: Program) -> tuple[str, ...]:
    """The classes of the messages that a link receives beside those that the services answer."""
    classes = class_names(wire.name for wire in system.wires)
    time = [f"messages.{classes[SYSTEM_TIME]}"] if program.takes_time else []
    return (*time, *(["*KINDS"] if received_beside(system) else []))


def _connecting(system: System, program: Program) -> tuple[str, ...]:
    """How what makes a connection begins, and what goes on with it."""
    taking = ["follow_time(connection, self.state.clock)"] if program.takes_time else []
    taking += ["receive_into(connection, self)"] if system.receptions else []
    return ("connection =", *taking, "return connection") if taking else ("return",)


def _attribute(parameter: Parameter | None) -> str | None:
    return parameter_attribute(parameter.name) if parameter else None


def _action(action: ActionSpec) -> ActionView:
    return ActionView(
        value=action.value,
        call=action.call,
        doc=prose(action.doc),
        mode=action.mode,
        disarm=action.disarm,
        statements=_statements(action),
    )


def _statements(action: ActionSpec) -> tuple[str, ...]:
    call = f"self.{action.call}()"
    mode = [] if action.mode is None else [f"self.state.vehicle.mode_number = {action.mode}"]
    if not action.disarm:
        return (*mode, call)
    comment = "a fault in the user's code does not keep the motors turning"
    return (*mode, "try:", f"    {call}", f"finally:  # {comment}", "    self.disarm(force=True)")


def dialect_text(program: Program) -> str:
    """The module dialect.py: the numbers of the dialect that the program uses."""
    lines = [f"{name} = {value}" for name, value in program.constants.items()]
    return '"""Numbers of the dialect that the program uses."""\n\n' + "\n".join(lines) + "\n"
