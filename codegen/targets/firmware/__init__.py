"""The MicroPython firmware: what the specification decides is rendered, the rest is copied as it is."""

from codegen.model.dialect.dialect import WireMessage
from codegen.model.program import LinkKind, Program
from codegen.model.system import System
from codegen.render.rendered import rendered
from codegen.targets.codec.layout import message_files
from codegen.targets.codec.runtime import MACHINE_CODE, has_doubles, runtime_files, with_doubles
from codegen.targets.firmware.failsafes.failsafe import failsafe_views
from codegen.targets.firmware.messages.message_function import functions_view
from codegen.targets.firmware.messages.receiving import receiving_view
from codegen.targets.firmware.messages.streams import streams_view
from codegen.targets.firmware.messages.telemetry import telemetry_view
from codegen.targets.firmware.numbers import places, with_numbers
from codegen.targets.firmware.program.absences import absences_view
from codegen.targets.firmware.program.commands import command_table_view
from codegen.targets.firmware.program.parameters import parameter_views
from codegen.targets.firmware.program.program import dialect_text, program_view
from codegen.targets.firmware.readings.board import board_view
from codegen.targets.firmware.readings.further import further_module_view
from codegen.targets.firmware.readings.reading_view import readings_view
from codegen.targets.firmware.readings.sources import sources_view
from codegen.targets.firmware.state.attribute import VIEWS
from codegen.targets.firmware.state.state import state_view
from codegen.targets.firmware.words import Layout, word_layout
from codegen.targets.naming import prose
from codegen.targets.origin import Origin, copied_files, headed, origin_of, origin_of_text, specification_file
from codegen.targets.source_files import source_files
from codegen.tool.template_files import copied, plain_files

_PROGRAM = "firmware/program"
_PARAMETERS = "parameter_service.py"


def render_firmware(system: System) -> dict[str, str]:
    """The files below ``firmware/``: the telemetry, and the program around it where there is one."""
    board, state = specification_file(system, "board.yaml"), specification_file(system, "state.yaml")
    parameters = specification_file(system, "parameters.yaml")
    project = system.spec.project.place.file
    streams = specification_file(system, "streams.yaml")
    tables = [message.population.place.file for message in system.messages]
    wires = [message.wire for message in system.messages]
    written = [project, *tables, state, board, parameters]
    layout = word_layout(system)
    view = state_view(system, layout)
    machine_code = system.spec.project.machine_code
    plain = functions_view(system, layout, machine_code=False)
    views: dict[str, tuple[object, list[str], list[WireMessage]]] = {
        "board.py": (board_view(system), [board, state, parameters], []),
        "parameters.py": (parameter_views(system), [parameters], []),
        "state.py": (view, [state, board, parameters], []),
        "streams.py": (streams_view(system), [project, streams, parameters, *tables], []),
        "telemetry.py": (telemetry_view(system), written, wires),
        "telemetry_plain.py": (plain, written, wires),
    }
    templates: dict[str, str] = {}
    if view.is_measured:
        for name, (template, taken) in _reading_views(system, layout).items():
            views[name] = (taken, [state, board, parameters], [])
            templates[name] = template
        for suffix in ("plain", *(["viper"] if machine_code else [])):
            views[f"samples_{suffix}.py"] = (board_view(system), [board, state], [])
    if system.polled:
        views["sources.py"] = (sources_view(system, layout), [board, state], [])
    if machine_code:
        fast = functions_view(system, layout, machine_code=True)
        views["telemetry_viper.py"] = (fast, written, wires)
    further = [*([MACHINE_CODE] if machine_code else []), *(["signing"] if system.signs else [])]
    files = {**copied_files("firmware"), **runtime_files("firmware/", system.wires, *further)}
    listens = any(source.silence_ms is not None for source in system.polled)
    optional = {
        "curve": any(reading.is_estimated_from for reading in system.readings()),
        "adc_faults": view.is_measured,
        "adc_inputs": view.is_measured,
        "reading_turns": view.is_measured,
        "floats_plain": plain.puts_floats,
        "floats_viper": plain.puts_floats and machine_code,
        "reals_plain": plain.puts_reals,
        "reals_viper": plain.puts_reals and machine_code,
        **{name: name in view.modules for name in VIEWS.values()},
        "clock_viper": plain.ticks and machine_code,
        "polling": bool(system.polled),
        "listening": listens,
        "scan_viper": machine_code,
        "turns_plain": bool(system.polled),
        "turns_viper": bool(system.polled) and machine_code,
    }
    for name, is_used in optional.items():
        if not is_used:
            del files[f"firmware/{name}.py"]
    if "wide" in view.modules and has_doubles(system.wires):
        text = with_doubles(copied("firmware/wide.py"))
        files["firmware/wide.py"] = headed(text, origin_of_text("templates/firmware/wide.py", text))
    origin = origin_of(system, tables, system.wires)
    files |= message_files("firmware/", system.wires, system.dialect.version, origin)
    for name, (shown, paths, messages) in views.items():
        text = rendered(f"firmware/{templates.get(name, name)}.j2", shown)
        files[f"firmware/{name}"] = headed(text, origin_of(system, paths, messages))
    return files | source_files(system, "firmware") | _program_files(system, layout)


def _reading_views(system: System, layout: Layout) -> dict[str, tuple[str, object]]:
    """The modules that take readings, each with its template: those of the first ones together, of others alone."""
    found: dict[str, tuple[str, object]] = {}
    suffixes = ("plain", *(["viper"] if system.spec.project.machine_code else []))
    board = board_view(system)
    modules = {"state": [reading for reading in system.readings() if reading.is_first]}
    modules |= {reading.name: [reading] for reading in system.readings() if not reading.is_first}
    for name, readings in modules.items():
        samplers = () if name == "state" else tuple(each for each in board.readers if each.component == name)
        for suffix in suffixes:
            taken = readings_view(layout, readings, samplers, machine_code=suffix == "viper")
            found[f"{name}_{suffix}.py"] = f"state_{suffix}.py", taken
        if samplers:
            found[f"{name}.py"] = "further_reading.py", further_module_view(readings[0], board, system, layout)
    return found


def _program_files(system: System, layout: Layout) -> dict[str, str]:
    program = system.program
    if program is None:
        return {}
    takes_long = any(command.spec.long for command in program.commands)
    kinds = {link.kind for link in system.links}
    has_server, has_client = LinkKind.TCP_SERVER in kinds, LinkKind.TCP_CLIENT in kinds
    optional = {
        "tcp_server": has_server,
        "tcp_client": has_client,
        **dict.fromkeys(("tcp_port", "tcp_peer", "tcp_stations"), has_server or has_client),
        "clock_service": program.takes_time,
        "heard": program.takes_time or bool(system.receptions) or bool(program.commands),
        "reception": bool(system.receptions),
        **dict.fromkeys(("wholes_plain", "wholes_viper"), False),
        "own_commands": bool(program.commands),
        "long_commands": takes_long,
        "command_cancel": program.cancels,
        "mode_service": bool(program.modes),
        "set_mode": program.changes_modes_by_message,
        "twins": system.component_parameter is not None,
        "bytewise": system.is_bytewise,
        "access": program.access is not None and bool(program.access.signed),
        "key_service": program.access is not None and bool(program.access.spec.setup),
        "listed_stations": program.access is not None and bool(program.access.listed),
    }
    plain = [name for name in plain_files(_PROGRAM) if optional.get(name.removesuffix(".py"), True)]
    files = {f"firmware/{name}": _program_file(system, program, name, copied(f"{_PROGRAM}/{name}")) for name in plain}
    files |= _receiving_files(system, layout) if system.receptions else {}
    paths = [specification_file(system, f"{name}.yaml") for name in ("vehicle", "state", "parameters", "board")]
    paths.append(system.spec.project.place.file)
    failsafes = failsafe_views(system, program, layout)
    view = program_view(system, program, failsafes, layout)
    vehicle = specification_file(system, "vehicle.yaml")
    commands = specification_file(system, "commands.yaml")
    if program.commands:
        paths.append(commands)
    read = {
        "main.py": (view, [vehicle]),
        "vehicle.py": (view, paths),
        "commands.py": (view, [vehicle]),
        **({"absences.py": (absences_view(program.absences), [vehicle])} if program.absences else {}),
        **({"failsafe.py": (failsafes, paths)} if failsafes else {}),
        **({"watchdog.py": (view.watchdog, [vehicle])} if view.watchdog else {}),
        **({"command_table.py": (command_table_view(program), [commands])} if program.commands else {}),
    }
    for name, (shown, sources) in read.items():
        text = with_numbers(rendered(f"{_PROGRAM}/{name}.j2", shown), _numbers(program))
        wires = _absent(program) if name == "absences.py" else program.services
        files[f"firmware/{name}"] = headed(text, origin_of(system, sources, wires))
    service = rendered(f"{_PROGRAM}/{_PARAMETERS}.j2", view)  # alike in programs with other parameters
    files[f"firmware/{_PARAMETERS}"] = _program_file(system, program, f"{_PARAMETERS}.j2", service)
    origin = origin_of(system, [vehicle], program.services)
    files["firmware/dialect.py"] = headed(dialect_text(program), origin)
    return files


def _receiving_files(system: System, layout: Layout) -> dict[str, str]:
    """Return what puts messages that arrive into the state."""
    view = receiving_view(system, layout)
    forms = ["plain", *(["viper"] if system.spec.project.machine_code else [])]
    names = ["receiving.py", *(f"receiving_{form}.py" for form in forms)]
    tables = [table.spec.place.file for table in system.receptions]
    wires = [table.wire for table in system.receptions]
    origin = origin_of(system, [*tables, specification_file(system, "state.yaml")], wires)
    files = {f"firmware/{name}": headed(rendered(f"{_PROGRAM}/{name}.j2", view), origin) for name in names}
    for name in (f"wholes_{form}.py" for form in forms if view.makes_wholes):
        path = f"{_PROGRAM}/{name}"
        files[f"firmware/{name}"] = headed(copied(path), origin_of_text(f"templates/{path}", copied(path)))
    return files


def _program_file(system: System, program: Program, name: str, written: str) -> str:
    """A file of the program as it is ``written`` in a template, but for the numbers of the dialect."""
    text = with_numbers(written, _numbers(program))
    origin = origin_of_text(f"templates/{_PROGRAM}/{name}", text)
    if text != written:
        origin = Origin((*origin.sources, f"dialect {prose(system.dialect.name)}"), origin.digest)
    return headed(text, origin)


def _numbers(program: Program) -> dict[str, int]:
    """Return what the program's modules take from the dialect."""
    return {**program.constants, **places((*program.services, *_absent(program)))}


def _absent(program: Program) -> tuple[WireMessage, ...]:
    """The messages about what the vehicle does not have: questions and answers."""
    return tuple(wire for absence in program.absences for wire in (absence.question, absence.answer))
