"""Puts the resolved system together from a dialect and a specification."""

import os
from collections.abc import Mapping

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.dialect.dialect import Dialect
from codegen.model.program_folders import SPECIFICATION_FOLDERS
from codegen.model.spec.population import Clock
from codegen.model.spec.spec import Spec
from codegen.model.system import System
from codegen.model.units.unit import NUMBER
from codegen.model.vehicle import Parameter
from codegen.resolve.board.links import resolve_links
from codegen.resolve.board.model import resolve_board_model
from codegen.resolve.board.sources import resolve_sources
from codegen.resolve.citation import index_requirements
from codegen.resolve.commands.commands import NO_PROGRAM_FOR_COMMANDS
from codegen.resolve.families import ParameterFamilies
from codegen.resolve.in_force import said_start, unsaid_start
from codegen.resolve.instances import resolve_instances
from codegen.resolve.population.generations import resolve_generations
from codegen.resolve.population.population import Parts, resolve_message
from codegen.resolve.program.access import resolve_access
from codegen.resolve.program.program import resolve_program
from codegen.resolve.program.receiver import resolve_receiver
from codegen.resolve.program.watchdog import resolve_watchdog
from codegen.resolve.quantities.kept import UNKNOWN_ENTRY
from codegen.resolve.quantities.state import resolve_components
from codegen.resolve.receptions.receives import resolve_reception
from codegen.resolve.streams import resolve_streams
from codegen.resolve.vehicle import find_parameter, resolve_channels, resolve_parameters
from codegen.source import Place, shown_path

BAD_PROJECT = Rule(
    "bad-project",
    "codegen.yaml sets a value that cannot be: system and component id are 1 to 255, and so are the parameters that "
    "set them, which have no unit and say reboot: true, as they are looked at when the board starts; the protocol is "
    "1 or 2, and the output goes to a folder of its own in the project, with none of the specification in it, and not "
    "to one of git.",
)


def resolve_system(spec: Spec, dialect: Dialect, report: Report) -> System:
    """Return the system with everything linked; parts that could not be resolved are left out and reported."""
    index = index_requirements(spec.requirements)
    instances = resolve_instances(spec, report)
    parameters = resolve_parameters(spec.parameters, ParameterFamilies(spec, instances, report), index, report)
    board = resolve_board_model(spec.board_model, report)
    channels = resolve_channels(spec.board, board, spec.parameters, parameters, index, report)
    streams = resolve_streams(spec, dialect, parameters, index, report)
    sources = resolve_sources(spec, board, index, report)
    components = resolve_components(spec, dialect, instances, channels, sources, parameters, index, report)
    parts = Parts(spec, dialect, parameters, components, streams, index)
    messages = [
        message
        for population in spec.populations
        if (message := resolve_message(population, parts, report)) is not None
    ]
    receptions = [
        reception for table in spec.receives if (reception := resolve_reception(table, parts, report)) is not None
    ]
    generations = resolve_generations(spec, messages, components, parameters, index, report)
    _check_output(spec, report)
    system_id, system_parameter = _system_id(spec, parameters, report)
    component_id = _component_id(spec, dialect, report)
    program = None
    if spec.vehicle is not None:
        tables = (answer.clock for population in spec.populations for answer in population.fields.values())
        program = resolve_program(
            spec.vehicle,
            spec.parameters,
            parameters,
            components,
            spec.state,
            dialect,
            index,
            report,
            commands=spec.commands,
            access=resolve_access(spec, spec.vehicle, dialect, index, report),
            watchdog=resolve_watchdog(spec, spec.vehicle, board, index, report),
            takes_time=Clock.UNIX in tables,
            component_id=1 if component_id is None else component_id,
            received=frozenset(reception.wire.name for reception in receptions),
        )
    elif spec.commands is not None:
        report.add(
            NO_PROGRAM_FOR_COMMANDS,
            spec.commands.place,
            "there is no program that could do commands",
            "write vehicle.yaml",
        )
    receiver = None
    if spec.receiver is not None:
        receiver = resolve_receiver(spec.receiver, components, spec.state, messages, index, dialect, report)
    return System(
        spec=spec,
        dialect=dialect,
        system_id=system_id,
        system_parameter=system_parameter,
        component_id=1 if component_id is None else component_id,
        component_parameter=_component_parameter(spec, component_id, parameters, report),
        channels=channels,
        parameters=parameters,
        components=components,
        streams=streams,
        messages=tuple(sorted(messages, key=lambda message: (message.wire.id, message.name))),
        board=board,
        links=resolve_links(spec.board, board, index, report),
        program=program,
        requirements=index,
        generations=generations,
        receiver=receiver,
        sources=sources,
        receptions=tuple(sorted(receptions, key=lambda reception: (reception.wire.id, reception.name))),
    )


def _check_output(spec: Spec, report: Report) -> None:
    project = spec.project
    output = os.path.normpath(os.path.join(spec.folder, project.output))
    if os.path.commonpath([output, spec.folder]) == output:
        message = f"the output folder {project.output} is, or contains, the folder of the specification"
        report.add(BAD_PROJECT, project.at("output"), message, "give the output a folder of its own: ../generated")
    if not spec.program:
        _check_output_folder(output, spec, report)
    allowed = (os.path.dirname(spec.folder), *(os.path.join(spec.folder, each) for each in project.outside))
    if not any(_is_in(os.path.realpath(output), os.path.realpath(each)) for each in allowed):
        message = f"the output folder {project.output} lies outside of the project"
        hint = f"if it is meant, list it in codegen.yaml: outside: [{project.output}]"
        report.add(BAD_PROJECT, project.at("output"), message, hint)
    if project.protocol not in (1, 2):
        report.add(
            BAD_PROJECT, project.at("protocol"), f"protocol {project.protocol} is not 1 or 2", hint="protocol: 2"
        )


def _check_output_folder(output: str, spec: Spec, report: Report) -> None:
    """Report an output folder (an absolute path) in which, or around which, files of others lie."""
    written, place = spec.project.output, spec.project.at("output")
    own = "give the output a folder of its own: ../generated"
    programs = (os.path.dirname(os.path.join(spec.folder, path)) for path in spec.project.programs.values())
    for folder in (
        *(os.path.join(spec.folder, name) for name in SPECIFICATION_FOLDERS),
        *map(os.path.normpath, programs),
    ):
        if not _is_in(spec.folder, output) and (_is_in(output, folder) or _is_in(folder, output)):
            message = (
                f"the output folder {written} is, lies in or contains {shown_path(folder)}, from which codegen reads"
            )
            report.add(BAD_PROJECT, place, message, own)
            break
    if ".git" in os.path.relpath(output, spec.folder).split(os.sep):
        report.add(BAD_PROJECT, place, f"the output folder {written} is, or lies in, a folder of git", own)
    if "\\" in written:
        message = f"the output folder {written} has a backslash, which is a letter of a name where codegen may run"
        report.add(BAD_PROJECT, place, message, f"output: {written.replace(chr(92), '/')}")


def _is_in(path: str, folder: str) -> bool:
    return os.path.commonpath([path, folder]) == folder


def _system_id(spec: Spec, parameters: Mapping[str, Parameter], report: Report) -> tuple[int, Parameter | None]:
    """The system id, and the parameter that sets it, of which it is the default."""
    written = spec.project.system_id
    if spec.vehicle is None or spec.vehicle.system_id is None:
        if not 1 <= written <= 255:
            report.add(
                BAD_PROJECT, spec.project.at("system_id"), f"system id {written} is not 1 to 255", hint="system_id: 1"
            )
        return written, None
    place = spec.vehicle.at("system_id")
    if "system_id" in spec.project.places:
        message = "the system id is stated here, and vehicle.yaml has a parameter for it"
        report.add(
            BAD_PROJECT,
            spec.project.at("system_id"),
            message,
            related=[(place, "the parameter is named here")],
            hint="leave out one of them",
        )
    parameter = find_parameter(spec.vehicle.system_id, place, spec.parameters, parameters, report)
    if parameter is None:
        return 1, None
    _check_id(parameter, place, "system", report)
    return parameter.default, parameter


def _check_id(parameter: Parameter, place: Place, kind: str, report: Report) -> None:
    if parameter.step != 1 or parameter.minimum < 1 or parameter.maximum > 255:
        related = [(parameter.spec.at("max"), f"{parameter.name} is declared here")]
        report.add(
            BAD_PROJECT,
            place,
            f"{parameter.name} is not a {kind} id from 1 to 255",
            related=related,
            hint=f"give {parameter.name} min: 1, max: 255 and step: 1",
        )
    elif parameter.unit is not NUMBER:
        related = [(parameter.spec.at("unit"), f"{parameter.name} is declared here")]
        message = f"{parameter.name} is in {parameter.unit.name}, and a {kind} id is a number without a unit"
        report.add(BAD_PROJECT, place, message, f"take unit: {parameter.unit.name} out at {parameter.name}", related)
    elif not parameter.spec.reboot:
        report.add(BAD_PROJECT, place, unsaid_start(parameter), said_start(parameter))


def _component_parameter(
    spec: Spec, component_id: int | None, parameters: Mapping[str, Parameter], report: Report
) -> Parameter | None:
    """The parameter that sets the component id, where the project has one."""
    if spec.vehicle is None or spec.vehicle.component_id is None:
        return None
    place = spec.vehicle.at("component_id")
    parameter = find_parameter(spec.vehicle.component_id, place, spec.parameters, parameters, report)
    if parameter is None:
        return None
    _check_id(parameter, place, "component", report)
    if component_id is not None and parameter.default != component_id:
        message = f"the default of {parameter.name} is not {spec.project.component_id} ({component_id})"
        related = [(spec.project.at("component_id"), "the project's own component id")]
        report.add(BAD_PROJECT, parameter.spec.at("default"), message, related=related, hint=f"default: {component_id}")
    return parameter


def _component_id(spec: Spec, dialect: Dialect, report: Report) -> int | None:
    """The number of the project's component id; None after a finding."""
    name, enum = spec.project.component_id, dialect.enums.get("MAV_COMPONENT")
    entry = enum.entry(name) if enum else None
    if entry is None:
        names = [entry.name for entry in enum.entries] if enum else []
        report.add(
            UNKNOWN_ENTRY,
            spec.project.at("component_id"),
            f"MAV_COMPONENT has no entry {name}",
            did_you_mean(name, names),
        )
        return None
    if not 1 <= entry.value <= 255:
        report.add(
            BAD_PROJECT,
            spec.project.at("component_id"),
            f"{name} ({entry.value}) is no source of messages",
            hint="name an entry of MAV_COMPONENT from 1 to 255, such as MAV_COMP_ID_AUTOPILOT1",
        )
    return entry.value
