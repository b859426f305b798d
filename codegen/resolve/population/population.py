"""One population table: its message, and an answer of its kind for every element."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from codegen.answers import KINDS
from codegen.answers.kind import POINTLESS_KEY
from codegen.answers.pages import find_pages
from codegen.answers.scope import Scope
from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.model.answers.answer import Answer, Elements
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.population import PopulationSpec, Send
from codegen.model.spec.spec import Requirement, Spec
from codegen.model.system import PopulatedMessage
from codegen.model.vehicle import Component, Parameter, Stream
from codegen.resolve.citation import cite, cite_aspects
from codegen.resolve.population.elements import answered_elements
from codegen.resolve.population.generations import resolve_on_change
from codegen.resolve.population.represent import resolve_representations
from codegen.resolve.quantities.component import find_component
from codegen.resolve.quantities.quantity import LONGEST_NAME
from codegen.resolve.scope import ResolvedScope

UNKNOWN_MESSAGE = Rule(
    "unknown-message",
    "A population table is for a message that the dialect does not have.",
    remedy="name a message of the dialect, or define it in an overlay",
)
BAD_TABLE_NAME = Rule(
    "bad-table-name",
    "The name that a population table gives itself with 'as' is that of its builder, its page and its tests, and "
    "stands for it wherever the specification names a message. It begins with a lower-case letter, goes on with "
    "lower-case letters, digits and underscores, and nothing else is called so: no message of the dialect, no "
    "component, no stream.",
)
UNKNOWN_STREAM = Rule(
    "unknown-stream",
    "A population table names a stream that streams.yaml does not have.",
    remedy="write it in streams.yaml: streams: {NAME: {rate: 1 Hz}}",
)
UNKNOWN_COMPONENT = Rule(
    "unknown-component",
    "A table names a component that state.yaml does not have.",
    remedy="write it in state.yaml: components: {name: ...}",
)

_POINTLESS = {
    "from": "says nothing without each",
    "per": "says nothing without board",
    **dict.fromkeys(("split", "min", "max", "rounding"), "says nothing about what is not read as a number"),
}
"""The message about a key that shapes answers of other kinds only."""
_BESIDE = {"from": "each", "per": "board"}
"""The keys beside which such a key says something, where these are not state and parameter."""


@dataclass(frozen=True, slots=True)
class Parts:
    """The resolved parts of a vehicle that tables refer to, by name; ``requirements`` by their ids."""

    spec: Spec
    dialect: Dialect
    parameters: Mapping[str, Parameter]
    components: Mapping[str, Component]
    streams: Mapping[str, Stream]
    requirements: Mapping[str, Requirement]


def resolve_message(population: PopulationSpec, parts: Parts, report: Report) -> PopulatedMessage | None:
    """The message of a table; None after a finding without which nothing can be said of it."""
    wire = parts.dialect.messages.get(population.message)
    if wire is None:
        hint = did_you_mean(population.message, parts.dialect.messages)
        place = population.at("message")
        report.add(UNKNOWN_MESSAGE, place, f"{parts.dialect.name} has no message {population.message}", hint)
    _check_name(population, parts, report)
    citation = cite(population.requirement, population.at("requirement"), parts.requirements, report)
    stream = _stream(population, parts, report)
    component = None
    if population.for_each is not None:
        name, place = population.for_each, population.at("for_each")
        component = find_component(name, parts.components, parts.spec.state, UNKNOWN_COMPONENT, place, report)
    on_change = resolve_on_change(population, component, parts.spec, parts.components, report)
    if wire is None or citation is None:
        return None
    elements = answered_elements(population, wire, citation, parts.requirements, report)
    scope = _scope(population, component, elements, parts, report)
    bound = [_bind(covers, scope) for covers in elements]
    answers = [answer for answer in bound if answer is not None]
    withheld = any(answer.withheld_for for answer in answers)
    if population.send is Send.WHILE_KNOWN and not withheld and len(answers) == len(elements):
        text = "send: while_known says nothing: each field can say unknown, or is always known"
        report.add(POINTLESS_KEY, population.at("send"), text, "leave it out")
    represents = resolve_representations(
        population, answers, parts.components, parts.spec.state, parts.spec.parameters, parts.parameters, report
    )
    if stream is None and population.stream is not None:
        return None
    return PopulatedMessage(
        wire=wire,
        answers=tuple(answers),
        stream=stream,
        component=component,
        citation=citation,
        population=population,
        represents=represents,
        aspects=cite_aspects(population, parts.requirements, report),
        on_connection=population.on_connection,
        on_change=on_change,
        pages=scope.pages.count if scope.pages else 1,
    )


def _check_name(population: PopulationSpec, parts: Parts, report: Report) -> None:
    """Say what is wrong with a name of the table's own, where it has one."""
    name = population.named
    if name is None:
        return
    problem, hint = None, None
    if not re.fullmatch(rf"[a-z][a-z0-9_]{{0,{LONGEST_NAME - 1}}}", name):
        problem, hint = "is no name of a table", "write it like 'position' or 'wind_speed'"
    elif name.upper() == population.message:
        problem = "says nothing: a table is called like its message anyway"
        hint = "leave it out, or choose another name"
    elif name.upper() in parts.dialect.messages:
        problem = f"is the name of another message, {name.upper()}"
    elif name in parts.spec.state.components:
        problem = "is the name of a component of the state"
    elif name in parts.spec.streams.streams:
        problem = "is the name of a stream"
    if problem is not None:
        report.add(BAD_TABLE_NAME, population.at("as"), f"{name!r} {problem}", hint or "choose another name")


def _stream(population: PopulationSpec, parts: Parts, report: Report) -> Stream | None:
    stream = parts.streams.get(population.stream or "")
    written = parts.spec.streams.places
    if population.stream is not None and stream is None and f"streams.{population.stream}" not in written:
        hint = did_you_mean(population.stream, parts.streams)
        report.add(UNKNOWN_STREAM, population.at("stream"), f"there is no stream {population.stream}", hint)
    if population.stream is None and parts.spec.vehicle is None:
        message = f"{population.message} belongs to no stream, and nothing answers requests"
        report.add(UNKNOWN_STREAM, population.place, message, "name a stream, or describe the program in vehicle.yaml")
    return stream


def _scope(
    population: PopulationSpec, component: Component | None, elements: Sequence[Elements], parts: Parts, report: Report
) -> Scope:
    scope = ResolvedScope(
        population=population,
        board=parts.spec.board,
        dialect=parts.dialect,
        components=parts.components,
        component=component,
        elements=elements,
        pages=None,
        report=report,
        spec=parts.spec,
        parameters=parts.parameters,
    )
    return replace(scope, pages=find_pages(scope))


def _bind(covers: Elements, scope: Scope) -> Answer | None:
    """The answer, bound by its kind; None after a finding."""
    kind = next(kind for kind in KINDS if kind.is_meant(covers.written, scope))
    for key, words in _POINTLESS.items():
        if key in covers.written.places and key not in kind.SHAPED_BY:
            hint = f"leave {key} out, or answer with {_BESIDE.get(key, 'state or parameter')}"
            scope.report.add(POINTLESS_KEY, covers.written.at(key), f"{key} {words}", hint)
    return kind.bind(covers, scope)
