"""View of streams.py: which messages go out at which rate."""

from dataclasses import dataclass
from fractions import Fraction

from codegen.model.system import PopulatedMessage, System
from codegen.model.unit import decimal
from codegen.model.vehicle import Stream
from codegen.targets.naming import builder_name, instance_expression, parameter_attribute


@dataclass(frozen=True, slots=True)
class SentView:
    """A message; each of its instances is sent, where ``enabled`` (an expression of the state) is true."""

    id: int
    name: str
    function: str
    instances: int
    at_first: int
    enabled: str | None


@dataclass(frozen=True, slots=True)
class StreamView:
    """A stream: its period, ``period_numerator / period_denominator`` ms, is fixed, or a parameter sets the rate.

    The rate in Hz is then ``steps * numerator / denominator``; ``minimum``, ``default`` and ``maximum`` are in steps.
    ``data_stream`` is the number by which REQUEST_DATA_STREAM asks for it, and ``fastest_hz`` what it can ask for.
    """

    index: int
    name: str
    identifier: str
    comment: str
    citation: str
    period_numerator: int
    period_denominator: int
    sent_in_40_s: int
    parameter: str | None
    parameter_name: str
    numerator: int
    denominator: int
    minimum: int
    default: int
    maximum: int
    data_stream: int | None
    fastest_hz: int
    messages: tuple[SentView, ...]


@dataclass(frozen=True, slots=True)
class StreamsView:
    """The module: who the vehicle is on the link, its streams and its messages, with a literal for each table."""

    system_id: int
    system_parameter: str
    component_id: int
    component_name: str
    component_parameter: str
    version: int
    longest: int
    streams: tuple[StreamView, ...]
    messages: tuple[SentView, ...]
    parameters: tuple[str, ...]
    ids: str
    stream_of: str
    shortest_us: str
    data_streams: str
    fastest_hz: str


def streams_view(system: System) -> StreamsView:
    """The view of the whole module: the messages of the streams in their order, then those sent on request."""
    project = system.spec.project
    streams = stream_views(system)
    asked = tuple(_sent(message, system) for message in system.messages if message.stream is None)
    messages = tuple(message for stream in streams for message in stream.messages) + asked
    places = [stream.index for stream in streams for _ in stream.messages] + [None] * len(asked)
    shortest = {stream.index: 1000000 // stream.fastest_hz for stream in streams}
    on_request = round(1000000 / system.program.fastest) if system.program else 0
    parameters = [stream.parameter for stream in streams if stream.parameter]
    return StreamsView(
        system_id=system.system_id,
        system_parameter=system.system_parameter.name if system.system_parameter else "",
        component_id=system.component_id,
        component_name=project.component_id,
        component_parameter=system.component_parameter.name if system.component_parameter else "",
        version=project.protocol,
        longest=max((wire.length for wire in system.sent), default=1),
        streams=streams,
        messages=messages,
        parameters=tuple(f"parameters.{name}" for name in parameters),
        ids=_tuple([message.id for message in messages]),
        stream_of=_tuple(places),
        shortest_us=_tuple([on_request if place is None else shortest[place] for place in places]),
        data_streams=_tuple([stream.data_stream for stream in streams]),
        fastest_hz=_tuple([stream.fastest_hz for stream in streams]),
    )


def _tuple(values: list[int] | list[int | None]) -> str:
    return str(tuple(values))


def stream_views(system: System) -> tuple[StreamView, ...]:
    """The streams that have messages, in the order of streams.yaml."""
    used = [stream for stream in system.streams.values() if any(each.stream is stream for each in system.messages)]
    return tuple(_stream(index, stream, system) for index, stream in enumerate(used))


def _stream(index: int, stream: Stream, system: System) -> StreamView:
    parameter, rate = stream.parameter, stream.rate
    step = parameter.step if parameter else Fraction(1)
    period = 1000 / rate if rate else Fraction(0)
    sets = f"{parameter.name} sets the rate" if parameter else f"{decimal(rate or Fraction(0))} Hz"
    return StreamView(
        index=index,
        name=stream.name,
        identifier=stream.name.lower(),
        comment=f"{stream.name}: {sets}",
        citation=str(stream.citation or ""),
        period_numerator=period.numerator,
        period_denominator=period.denominator,
        sent_in_40_s=round(40 * rate) if rate else 0,
        parameter=parameter_attribute(parameter.name) if parameter else None,
        parameter_name=parameter.name if parameter else "",
        numerator=step.numerator,
        denominator=step.denominator,
        minimum=parameter.minimum if parameter else 0,
        default=parameter.default if parameter else 0,
        maximum=parameter.maximum if parameter else 0,
        data_stream=stream.data_stream,
        fastest_hz=max(1, int(stream.fastest)),
        messages=tuple(_sent(message, system) for message in system.messages if message.stream is stream),
    )


def _sent(message: PopulatedMessage, system: System) -> SentView:
    component = message.component
    enabled = None
    if component is not None and component.enabled is not None:
        enabled = f"{instance_expression(component, is_for_each=True)}.{component.enabled.name}"
    return SentView(
        message.wire.id,
        message.name,
        builder_name(message),
        message.instances,
        _enabled_at_first(message, system),
        enabled,
    )


def _enabled_at_first(message: PopulatedMessage, system: System) -> int:
    """How many instances are reported while every parameter has its default."""
    switch = message.component.enabled if message.component else None
    if switch is None or switch.enabled_by is None:
        return message.instances
    names = switch.enabled_by.siblings or (switch.enabled_by.name,) * message.instances
    return sum(system.parameters[name].default != 0 for name in names)
