"""The MicroPython firmware: what the specification decides is rendered, the rest is copied as it is."""

from codegen.model.system import System
from codegen.render import render_template
from codegen.targets.codec.layout import messages_text
from codegen.targets.codec.runtime import MACHINE_CODE, runtime_files
from codegen.targets.firmware.board import board_view
from codegen.targets.firmware.parameters import parameter_views
from codegen.targets.firmware.state import state_view
from codegen.targets.firmware.streams import streams_view
from codegen.targets.firmware.telemetry import telemetry_view
from codegen.targets.origin import copied_files, headed, origin_of, specification_file


def render_firmware(system: System) -> dict[str, str]:
    """The files below ``firmware/``."""
    board, state = specification_file(system, "board.yaml"), specification_file(system, "state.yaml")
    parameters = specification_file(system, "parameters.yaml")
    project = system.spec.project.place.file
    streams = specification_file(system, "streams.yaml")
    tables = [message.population.place.file for message in system.messages]
    wires = [message.wire for message in system.messages]
    rendered = {
        "board.py": (board_view(system), [board, state], []),
        "parameters.py": (parameter_views(system), [parameters], []),
        "state.py": (state_view(system), [state, board, parameters], []),
        "streams.py": (streams_view(system), [project, streams, parameters, *tables], []),
        "telemetry.py": (telemetry_view(system), [project, *tables, state, board, parameters], wires),
    }
    accelerated = [MACHINE_CODE] if system.spec.project.machine_code else []
    files = {**copied_files("firmware"), **runtime_files("firmware/", *accelerated)}
    files["firmware/messages.py"] = headed(
        messages_text(wires, system.dialect.version), origin_of(system, tables, wires)
    )
    for name, (view, paths, messages) in rendered.items():
        text = render_template(f"firmware/{name}.j2", view)
        files[f"firmware/{name}"] = headed(text, origin_of(system, paths, messages))
    return files
