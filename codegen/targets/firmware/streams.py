"""View of streams.py: which messages go out at which rate."""

from dataclasses import dataclass
from fractions import Fraction

from codegen.model.system import PopulatedMessage, Stream, System
from codegen.model.unit import decimal
from codegen.targets.naming import builder_name, parameter_attribute


@dataclass(frozen=True, slots=True)
class SentView:
    """A message of a stream; each of its instances is sent."""

    id: int
    name: str
    function: str
    instances: int


@dataclass(frozen=True, slots=True)
class StreamView:
    """A stream: either ``period_ms`` is fixed, or a parameter sets the rate.

    The rate in Hz is then ``steps * numerator / denominator``; ``minimum``, ``default`` and ``maximum`` are in steps.
    """

    name: str
    identifier: str
    comment: str
    citation: str
    period_ms: int | None
    sent_in_40_s: int
    parameter: str | None
    numerator: int
    denominator: int
    minimum: int
    default: int
    maximum: int
    messages: tuple[SentView, ...]


@dataclass(frozen=True, slots=True)
class StreamsView:
    """The module: who the vehicle is on the link, and its streams."""

    system_id: int
    component_id: int
    component_name: str
    version: int
    longest: int
    streams: tuple[StreamView, ...]


def streams_view(system: System) -> StreamsView:
    """The view of the whole module."""
    project = system.spec.project
    return StreamsView(
        system_id=system.system_id,
        component_id=system.component_id,
        component_name=project.component_id,
        version=project.protocol,
        longest=max((message.wire.length for message in system.messages), default=1),
        streams=stream_views(system),
    )


def stream_views(system: System) -> tuple[StreamView, ...]:
    """The streams that have messages, in the order of streams.yaml."""
    views = (_stream(stream, system) for stream in system.streams.values())
    return tuple(view for view in views if view.messages)


def _stream(stream: Stream, system: System) -> StreamView:
    parameter, rate = stream.parameter, stream.rate
    step = parameter.step if parameter else Fraction(1)
    sets = f"{parameter.name} sets the rate" if parameter else f"{decimal(rate or Fraction(0))} Hz"
    return StreamView(
        name=stream.name,
        identifier=stream.name.lower(),
        comment=f"{stream.name}: {sets}",
        citation=str(stream.citation or ""),
        period_ms=round(1000 / rate) if rate else None,
        sent_in_40_s=round(40 * rate) if rate else 0,
        parameter=parameter_attribute(parameter.name) if parameter else None,
        numerator=step.numerator,
        denominator=step.denominator,
        minimum=parameter.minimum if parameter else 0,
        default=parameter.default if parameter else 0,
        maximum=parameter.maximum if parameter else 0,
        messages=tuple(_sent(message) for message in system.messages if message.stream.name == stream.name),
    )


def _sent(message: PopulatedMessage) -> SentView:
    return SentView(message.wire.id, message.name, builder_name(message), message.instances)
