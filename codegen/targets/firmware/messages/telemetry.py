"""View of telemetry.py: the functions of each populated message, in the fastest form that an interpreter runs."""

from codegen.frozen import dataclass
from codegen.model.system import PopulatedMessage, System
from codegen.targets.imports import either_import, order
from codegen.targets.naming import builder_name, encoder_name, frame_name


@dataclass(frozen=True, slots=True)
class TelemetryView:
    """The module: the lines that import the functions."""

    imports: tuple[str, ...]


def telemetry_view(system: System) -> TelemetryView:
    """The view of the whole module."""
    names = [name for message in system.messages for name in _functions(message)]
    names.sort(key=order)
    return TelemetryView(either_import("telemetry", names, machine_code=system.spec.project.machine_code))


def _functions(message: PopulatedMessage) -> set[str]:
    return {builder_name(message), encoder_name(message), frame_name(message)}
