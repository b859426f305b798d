"""View of vehicle.py, and of the modules around it: the main loop, the storage and what failsafes do."""

from codegen.frozen import dataclass
from codegen.model.program import LinkKind, Program
from codegen.model.program_spec import ActionSpec
from codegen.model.system import System
from codegen.model.vehicle import Parameter
from codegen.targets.firmware.failsafe import FailsafeView, failsafe_families, failsafe_views
from codegen.targets.naming import parameter_attribute, prose


@dataclass(frozen=True, slots=True)
class ActionView:
    """A call of the vehicle that a failsafe makes."""

    value: int
    call: str
    doc: str
    mode: int | None
    disarm: bool


@dataclass(frozen=True, slots=True)
class JobView:
    """A component that is measured, in which period, with its failsafe, if it has one."""

    component: str
    period_us: int
    citation: str
    failsafe: FailsafeView | None


@dataclass(frozen=True, slots=True)
class ProgramView:
    """What the templates of the program need to know. Periods are in us or ms as their names say.

    ``force`` is None where nothing can be armed, ``measure_us`` where the user's code is not asked to measure.
    """

    control_us: int
    control_hz: str
    links_us: int
    links_hz: str
    report_ms: int
    step_limit_us: int
    files: tuple[str, ...]
    chunk: int
    force: int | None
    has_load: bool
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
    jobs: tuple[JobView, ...]
    has_ports: bool
    has_usb: bool
    cited: dict[str, str]


def program_view(system: System, program: Program) -> ProgramView:
    """The view of the whole program."""
    failsafes = failsafe_views(program)
    watched = {failsafe.component: failsafe for failsafe in failsafes}
    return ProgramView(
        control_us=program.control_us,
        control_hz=program.spec.control.rate,
        links_us=program.links_us,
        links_hz=program.spec.control.links,
        report_ms=program.report_ms,
        step_limit_us=program.step_limit_us,
        files=program.spec.storage.files,
        chunk=program.spec.storage.chunk,
        force=program.spec.arming.force if program.spec.arming else None,
        has_load=program.spec.arming is not None or _has_load(system),
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
        jobs=tuple(
            JobView(
                component=name,
                period_us=(system.components[name].period_ms or 100) * 1000,
                citation=str(system.components[name].citation or ""),
                failsafe=watched.get(name),
            )
            for name, _, _ in system.measured()
        ),
        has_ports=bool(system.links),
        has_usb=any(link.kind is LinkKind.USB for link in system.links),
        cited={
            name: str(program.cited.get(name, "")) for name in ("control", "storage", "arming", "services", "measure")
        },
    )


def _attribute(parameter: Parameter | None) -> str | None:
    return parameter_attribute(parameter.name) if parameter else None


def _has_load(system: System) -> bool:
    """Whether the state asks for the load of the main loop, in the form in which the program tells it."""
    load = system.quantity("vehicle.load")
    return load is not None and load.attribute == "load_dpct" and system.components["vehicle"].instances == 1


def _action(action: ActionSpec) -> ActionView:
    return ActionView(action.value, action.call, prose(action.doc), action.mode, action.disarm)


def dialect_text(program: Program) -> str:
    """The module dialect.py: the numbers of the dialect that the program uses."""
    lines = [f"{name} = {value}" for name, value in program.constants.items()]
    return '"""Numbers of the dialect that the program uses."""\n\n' + "\n".join(lines) + "\n"
