"""View of streams.py: which messages go out at which rate."""

from collections.abc import Iterable
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.spec.spec import Generation
from codegen.model.system import Generations, PopulatedMessage, System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Stream
from codegen.targets.firmware.messages.announcements import AnnouncementView, announcements
from codegen.targets.firmware.messages.sending import SentView, WayView, payload_lengths, read_places, sent_view, ways
from codegen.targets.firmware.words import word_layout
from codegen.targets.imports import either_import, one_by_one
from codegen.targets.naming import parameter_attribute

_ROOM = 100
"""Columns of a literal in one line; what it is called stands before it."""
_LONGEST_INTERVAL_BITS = 21
"""Milliseconds of the longest interval that a ground station can ask for, 2 ** 30 us, have so many and one less."""


@dataclass(frozen=True, slots=True)
class StreamView:
    """A stream: its period, ``period_numerator / period_denominator`` ms, is fixed, or a parameter sets the rate.

    The rate in Hz is then ``steps * numerator / denominator``; ``minimum``, ``default`` and ``maximum`` are in steps.
    ``data_stream`` is the number by which REQUEST_DATA_STREAM asks for it, and ``fastest_hz`` what it can ask for in
    whole Hz: 0 where it may go less often than once in a second only.
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
class PeriodView:
    """Streams of one rate; ``condition`` is what their indexes are, behind their variable.

    The period in ms is ``numerator / denominator``, which are expressions.
    """

    numerator: str
    denominator: str
    condition: str
    comment: str


@dataclass(frozen=True, slots=True)
class StreamsView:
    """The module: who the vehicle is on the link, its streams and its messages, with a literal for each table.

    ``component`` is the name of a link's component id. ``chosen`` are the bits of the generations that parameters
    choose, below the lines of ``choosing``; ``or_not_chosen`` goes behind another reason not to stream a message.
    Nothing is due in more than 2 ** ``furthest_bits`` ms. ``is_seldom`` says whether a stream stays below 1 Hz,
    ``keeps_own`` whether one goes so seldom that nothing else can be asked for.
    """

    imports: tuple[str, ...]
    telemetry: str  # the module that it is, and what streams call it; without machine code nothing stands between
    system_id: int
    system_parameter: str
    component_id: int
    component_name: str
    component_parameter: str
    component: str
    version: int
    longest: int
    lengths: str
    streams: tuple[StreamView, ...]
    periods: tuple[PeriodView, ...]
    furthest_bits: int
    messages: tuple[SentView, ...]
    ways: tuple[WayView, ...]
    withheld: tuple[SentView, ...]
    tells: str
    parameters: tuple[str, ...]
    parameter_steps: tuple[str, ...]
    ids: str
    stream_of: str
    shortest_us: str
    data_streams: str
    fastest_hz: str
    is_seldom: bool
    keeps_own: bool
    number_at: str
    numbered: bool
    generation_of: str
    chosen: str
    choosing: tuple[str, ...]
    or_not_chosen: str
    announced: AnnouncementView | None
    has_program: bool
    signs: bool
    places: tuple[str, ...]


def streams_view(system: System) -> StreamsView:
    """The view of the whole module: the messages of the streams in their order, then those sent on request."""
    project = system.spec.project
    streams = stream_views(system)
    asked = tuple(_sent(message, system) for message in system.messages if message.stream is None)
    messages = tuple(message for stream in streams for message in stream.messages) + asked
    places = [stream.index for stream in streams for _ in stream.messages] + [None] * len(asked)
    parameters = [stream.parameter for stream in streams if stream.parameter]
    return StreamsView(
        imports=either_import("scan", ["LATE", "LOOK_MS", "take_due"], machine_code=project.machine_code),
        telemetry="telemetry" if project.machine_code else "telemetry_plain as telemetry",
        system_id=system.system_id,
        system_parameter=system.system_parameter.name if system.system_parameter else "",
        component_id=system.component_id,
        component_name=project.component_id,
        component_parameter=system.component_parameter.name if system.component_parameter else "",
        component="component_id" if system.component_parameter else "COMPONENT_ID",
        version=project.protocol,
        longest=max((wire.length for wire in system.sent), default=1),
        lengths=_names(map(str, payload_lengths(system))),
        streams=streams,
        periods=_periods(streams),
        furthest_bits=max([_LONGEST_INTERVAL_BITS, *(_slowest_ms(stream).bit_length() for stream in streams)]),
        messages=messages,
        ways=ways(messages),
        withheld=tuple(message for message in messages if message.tells),
        tells=_names(each.tells or "None" for each in messages),
        parameters=tuple(parameters),
        parameter_steps=tuple(
            one_by_one("        return ", (f"parameters.{name}" for name in parameters), brackets="[]")
        ),
        ids=_tuple([message.id for message in messages]),
        stream_of=_tuple(places),
        shortest_us=_tuple([message.shortest_us for message in messages]),
        data_streams=_tuple([stream.data_stream for stream in streams]),
        fastest_hz=_tuple([stream.fastest_hz for stream in streams]),
        keeps_own=any(message.shortest_us < 0 for message in messages),
        is_seldom=any(stream.fastest_hz == 0 for stream in streams),
        number_at=_tuple([message.number_at for message in messages]),
        numbered=system.program is not None and any(message.number_at is not None for message in messages),
        generation_of=_generation_of(messages, system) if system.generations else "",
        chosen=_chosen(system),
        choosing=_choosing_lines(system),
        or_not_chosen=" or not self._is_chosen(index)" if system.generations else "",
        announced=announcements(messages, system, word_layout(system)),
        has_program=system.program is not None,
        signs=system.signs,
        places=read_places(system.messages, word_layout(system)),
    )


def _slowest_ms(stream: StreamView) -> int:
    """Return the longest period of a stream that is not off, in whole milliseconds."""
    if stream.parameter:
        return 1000 * stream.denominator // (max(stream.minimum, 1) * stream.numerator)
    return stream.period_numerator // stream.period_denominator


def _periods(streams: tuple[StreamView, ...]) -> tuple[PeriodView, ...]:
    """The streams by what sets their rate, in their order: some share a parameter."""
    alike: dict[object, list[StreamView]] = {}
    for stream in streams:
        alike.setdefault(stream.parameter or (stream.period_numerator, stream.period_denominator), []).append(stream)
    return tuple(_period(group) for group in alike.values())


def _period(group: list[StreamView]) -> PeriodView:
    """Return what is said of streams that have their rate in common."""
    first, indexes = group[0], ", ".join(str(each.index) for each in group)
    names = ", ".join([*(each.name for each in group[:-1]), group[-1].comment])
    cited = ", ".join(sorted({each.citation for each in group if each.citation}))
    times = f" * {first.numerator}" if first.numerator != 1 else ""
    steps = f"self._state.parameters.{first.parameter}{times}"
    return PeriodView(
        numerator=str(1000 * first.denominator if first.parameter else first.period_numerator),
        denominator=steps if first.parameter else str(first.period_denominator),
        condition=f"== {first.index}" if len(group) == 1 else f"in ({indexes})",
        comment=f"{names} ({cited})" if cited else names,
    )


def _generation_of(messages: tuple[SentView, ...], system: System) -> str:
    """Bits of a message: 1 old, 2 new, shifted where several parameters choose; 3 is in any case, 0 on request."""
    return _tuple([_generation_bits(message.name, system) for message in messages])


def _generation_bits(name: str, system: System) -> int:
    for generations in system.generations:
        if name not in generations.names(Generation.BOTH):
            continue
        if generations.send is not None:
            return 3 if name in generations.names(generations.send) else 0
        return (1 if name in generations.old else 2) << 2 * _choosing(system).index(generations)
    return 3


def _choosing(system: System) -> list[Generations]:
    return [generations for generations in system.generations if generations.parameter is not None]


def _chosen(system: System) -> str:
    """The bits that the parameters choose, as an expression; "" where none does."""
    terms = []
    for place, generations in enumerate(_choosing(system)):
        assert generations.parameter is not None
        name = f"parameters.{parameter_attribute(generations.parameter.name)}"
        terms.append(f"({name} + 1 << {2 * place})" if place else f"({name} + 1)")
    return f"({' | '.join(terms)})" if len(terms) > 1 else "".join(terms)


def _choosing_lines(system: System) -> tuple[str, ...]:
    """Return what stands above the bits that the parameters choose; nothing where none does."""
    comments = [
        f"# {generations.parameter.name if generations.parameter else ''} is 0 for the old ones, 1 for the new ones, "
        f"2 for both{f' ({generations.citation})' if generations.citation else ''}"
        for generations in _choosing(system)
    ]
    return ("parameters = self._state.parameters", *comments) if comments else ()


def _sent(message: PopulatedMessage, system: System) -> SentView:
    return sent_view(message, system, never=_generation_bits(message.name, system) == 0)


def _names(names: Iterable[str]) -> str:
    """A tuple of names, in one line if it has room beside what it is called."""
    listed = list(names)
    line = f"({', '.join(listed)}{',' * (len(listed) == 1)})"
    return line if len(line) <= _ROOM else "(\n" + "".join(f"    {name},\n" for name in listed) + ")"


def _tuple(values: list[int] | list[int | None]) -> str:
    return _names(str(value) for value in values)


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
        fastest_hz=int(stream.fastest),
        messages=tuple(_sent(message, system) for message in system.messages if message.stream is stream),
    )
