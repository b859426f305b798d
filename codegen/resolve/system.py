"""Puts the resolved system together from a dialect and a specification."""

import os
from collections.abc import Mapping

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.dialect import Dialect
from codegen.model.population_spec import FieldAnswer, PopulationSpec
from codegen.model.spec import Requirement, Spec
from codegen.model.system import Binding, Elements, PopulatedMessage, SplitBinding, System
from codegen.model.vehicle import Component, Parameter, Stream
from codegen.resolve.citation import cite, index_requirements
from codegen.resolve.constant import bind_constant
from codegen.resolve.each import BAD_EACH, Pages, bind_each, bind_page, find_pages, with_room
from codegen.resolve.elements import answered_elements
from codegen.resolve.families import ParameterFamilies
from codegen.resolve.fixed import bind_entry, bind_fact, bind_flags, bind_unknown, bind_version, find_quantity
from codegen.resolve.generations import resolve_generations, resolve_on_change
from codegen.resolve.instances import resolve_instances
from codegen.resolve.links import resolve_links
from codegen.resolve.live import bind_instance, bind_live
from codegen.resolve.program import resolve_program
from codegen.resolve.quantity import UNKNOWN_ENTRY
from codegen.resolve.receiver import resolve_receiver
from codegen.resolve.represent import resolve_representations
from codegen.resolve.state import resolve_components
from codegen.resolve.vehicle import find_parameter, resolve_channels, resolve_parameters, resolve_streams
from codegen.source import Place

BAD_PROJECT = Rule(
    "bad-project",
    "codegen.yaml sets a value that cannot be: system and component id are 1 to 255, and those of the parameters that "
    "set them, the protocol is 1 or 2, and the output goes to a folder of its own.",
)
UNKNOWN_MESSAGE = Rule("unknown-message", "A population table is for a message that the dialect does not have.")
UNKNOWN_STREAM = Rule("unknown-stream", "A population table names a stream that streams.yaml does not have.")
UNKNOWN_COMPONENT = Rule("unknown-component", "A table names a component that state.yaml does not have.")
POINTLESS_KEY = Rule(
    "pointless-key",
    "split, min, max and rounding shape a value that is read at run time. Beside a constant, an enum entry, flags or "
    "unknown they would have no effect: remove them, or answer with state or parameter.",
)
BAD_INSTANCE = Rule(
    "bad-instance",
    "Only a message that is sent for_each component can carry the number of the instance, and of that component.",
)


def resolve_system(spec: Spec, dialect: Dialect, report: Report) -> System:
    """Everything linked; what could not be resolved is left out and reported."""
    index = index_requirements(spec.requirements)
    instances = resolve_instances(spec, report)
    parameters = resolve_parameters(spec.parameters, ParameterFamilies(spec, instances, report), index, report)
    channels = resolve_channels(spec.board, spec.parameters, parameters, index, report)
    streams = resolve_streams(spec, dialect, parameters, index, report)
    components = resolve_components(spec, dialect, instances, channels, parameters, index, report)
    binder = _Binder(spec, dialect, components, parameters, report)
    messages = [
        message
        for population in spec.populations
        if (message := _resolve_message(population, binder, streams, index)) is not None
    ]
    generations = resolve_generations(spec, messages, components, parameters, index, report)
    _check_output(spec, report)
    system_id, system_parameter = _system_id(spec, parameters, report)
    component_id = _component_id(spec, dialect, report)
    program = None
    if spec.vehicle is not None:
        program = resolve_program(spec.vehicle, spec.parameters, parameters, components, dialect, index, report)
    receiver = None
    if spec.receiver is not None:
        receiver = resolve_receiver(spec.receiver, components, messages, index, report)
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
        messages=tuple(sorted(messages, key=lambda message: message.wire.id)),
        links=resolve_links(spec.board, index, report),
        program=program,
        requirements=index,
        generations=generations,
        receiver=receiver,
    )


def _check_output(spec: Spec, report: Report) -> None:
    project = spec.project
    output = os.path.normpath(os.path.join(spec.folder, project.output))
    if os.path.commonpath([output, spec.folder]) == output:
        message = f"the output folder {project.output} is, or contains, the folder of the specification"
        report.add(BAD_PROJECT, project.at("output"), message, "give the output a folder of its own: ../generated")
    if project.protocol not in (1, 2):
        report.add(BAD_PROJECT, project.at("protocol"), f"protocol {project.protocol} is not 1 or 2")


def _system_id(spec: Spec, parameters: Mapping[str, Parameter], report: Report) -> tuple[int, Parameter | None]:
    """The system id, and the parameter that sets it, of which it is the default."""
    written = spec.project.system_id
    if spec.vehicle is None or spec.vehicle.system_id is None:
        if not 1 <= written <= 255:
            report.add(BAD_PROJECT, spec.project.at("system_id"), f"system id {written} is not 1 to 255")
        return written, None
    place = spec.vehicle.at("system_id")
    if "system_id" in spec.project.places:
        message = "the system id is stated here, and vehicle.yaml has a parameter for it"
        report.add(BAD_PROJECT, spec.project.at("system_id"), message, related=[(place, "the parameter is named here")])
    parameter = find_parameter(spec.vehicle.system_id, place, spec.parameters, parameters, report)
    if parameter is None:
        return 1, None
    _check_id(parameter, place, "system", report)
    return parameter.default, parameter


def _check_id(parameter: Parameter, place: Place, kind: str, report: Report) -> None:
    if parameter.step != 1 or parameter.minimum < 1 or parameter.maximum > 255:
        related = [(parameter.spec.at("max"), f"{parameter.name} is declared here")]
        report.add(BAD_PROJECT, place, f"{parameter.name} is not a {kind} id from 1 to 255", related=related)


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
        report.add(BAD_PROJECT, parameter.spec.at("default"), message, related=related)
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
        report.add(BAD_PROJECT, spec.project.at("component_id"), f"{name} ({entry.value}) is no source of messages")
    return entry.value


def _resolve_message(
    population: PopulationSpec, binder: "_Binder", streams: Mapping[str, Stream], index: Mapping[str, Requirement]
) -> PopulatedMessage | None:
    report = binder.report
    wire = binder.dialect.messages.get(population.message)
    if wire is None:
        hint = did_you_mean(population.message, binder.dialect.messages)
        place = population.at("message")
        report.add(UNKNOWN_MESSAGE, place, f"{binder.dialect.name} has no message {population.message}", hint)
    citation = cite(population.requirement, population.at("requirement"), index, report)
    stream = streams.get(population.stream or "")
    written = binder.spec.streams.places
    if population.stream is not None and stream is None and f"streams.{population.stream}" not in written:
        hint = did_you_mean(population.stream, streams)
        report.add(UNKNOWN_STREAM, population.at("stream"), f"there is no stream {population.stream}", hint)
    if population.stream is None and binder.spec.vehicle is None:
        message = f"{population.message} belongs to no stream, and nothing answers requests"
        report.add(UNKNOWN_STREAM, population.place, message, "name a stream, or describe the program in vehicle.yaml")
    component = None
    if population.for_each is not None:
        component = binder.components.get(population.for_each)
        if component is None:
            hint = did_you_mean(population.for_each, binder.components)
            place = population.at("for_each")
            report.add(UNKNOWN_COMPONENT, place, f"the state has no component {population.for_each}", hint)
    on_change = resolve_on_change(population, component, binder.spec, binder.components, report)
    if wire is None or citation is None:
        return None
    elements = answered_elements(population, wire, citation, index, report)
    state = binder.spec.state
    pages = find_pages(population, elements, binder.components, state, report)
    bound = (binder.bind(covers, component, population, pages) for covers in elements)
    bindings = with_room((binding for binding in bound if binding is not None), report)
    written_parameters = binder.spec.parameters
    represents = resolve_representations(
        population, bindings, binder.components, state, written_parameters, binder.parameters, report
    )
    if stream is None and population.stream is not None:
        return None
    return PopulatedMessage(
        wire=wire,
        bindings=tuple(bindings),
        stream=stream,
        component=component,
        citation=citation,
        population=population,
        represents=represents,
        on_connection=population.on_connection,
        on_change=on_change,
        pages=pages.count if pages else 1,
    )


class _Binder:
    """Binds the answers of the tables to their sources."""

    def __init__(
        self,
        spec: Spec,
        dialect: Dialect,
        components: Mapping[str, Component],
        parameters: Mapping[str, Parameter],
        report: Report,
    ) -> None:
        self.spec = spec
        self.dialect = dialect
        self.components = components
        self.parameters = parameters
        self.report = report

    def bind(
        self, covers: Elements, component: Component | None, population: PopulationSpec, pages: Pages | None
    ) -> Binding | None:
        """The binding of one answer, or None with a finding."""
        answer, report = covers.answer, self.report
        self._report_pointless(answer)
        if answer.each is not None:
            return self._bind_each(covers, answer.each, component, pages)
        if answer.page is not None:
            return bind_page(covers, pages, population.pages is not None, report)
        if answer.state is not None:
            return self._bind_state(covers, answer.state, component)
        if answer.parameter is not None:
            return self._bind_parameter(covers, answer.parameter)
        if answer.board is not None:
            return bind_fact(covers, answer.board, component, self.components, self.spec, self.dialect, report)
        if answer.enum is not None:
            return bind_entry(covers, answer.enum, "enum", self.dialect, report)
        if answer.flags is not None:
            return bind_flags(covers, answer.flags, self.dialect, self.components, self.spec.state, report)
        if answer.constant is not None:
            return bind_constant(covers, answer.constant, "constant", report)
        if answer.dialect is not None:
            return bind_version(covers, answer.dialect, self.dialect, report)
        return bind_unknown(covers, report)

    def _report_pointless(self, answer: FieldAnswer) -> None:
        if "from" in answer.places and answer.each is None:
            self.report.add(POINTLESS_KEY, answer.at("from"), "from says nothing without each")
        if "per_cell" in answer.places and answer.board is None:
            self.report.add(POINTLESS_KEY, answer.at("per_cell"), "per_cell says nothing without board")
        if answer.each is not None and answer.state is None and "split" in answer.places:
            self.report.add(POINTLESS_KEY, answer.at("split"), "split says nothing without state beside each")
        if answer.state is not None or answer.each is not None or answer.parameter is not None:
            return
        for key in ("split", "min", "max", "rounding"):
            if key in answer.places:
                self.report.add(POINTLESS_KEY, answer.at(key), f"{key} says nothing about a value that is known now")

    def _bind_state(self, covers: Elements, path: str, component: Component | None) -> Binding | None:
        place = covers.answer.at("state")
        owner, _, name = path.partition(".")
        if name == "instance" and owner in self.components:
            if component is None or component.name != owner:
                self.report.add(BAD_INSTANCE, place, f"the message is not sent for each {owner}", f"for_each: {owner}")
                return None
            return bind_instance(covers, component, self.report)
        quantity = find_quantity(path, self.components, self.spec.state, place, self.report)
        return None if quantity is None else bind_live(covers, quantity, "state", self.report)

    def _bind_each(
        self, covers: Elements, path: str, component: Component | None, pages: Pages | None
    ) -> Binding | None:
        answer = covers.answer
        quantity = find_quantity(path, self.components, self.spec.state, answer.at("each"), self.report)
        fallback = None
        if answer.state is not None:
            if not answer.split:
                self.report.add(
                    BAD_EACH, answer.at("state"), "state beside each is what is split instead", "split: true"
                )
                return None
            fallback = self._bind_state(covers, answer.state, component)
        if quantity is None or (answer.state is not None and not isinstance(fallback, SplitBinding)):
            return None
        is_paged = pages is not None and pages.quantity is quantity
        split = fallback if isinstance(fallback, SplitBinding) else None
        return bind_each(covers, quantity, split, is_paged, self.report)

    def _bind_parameter(self, covers: Elements, name: str) -> Binding | None:
        place = covers.answer.at("parameter")
        parameter = find_parameter(name, place, self.spec.parameters, self.parameters, self.report)
        if parameter is None:
            return None
        return bind_live(covers, parameter, "parameter", self.report)
