"""Subjects of the board, its links, the streams on them, and the identity of the vehicle."""

from collections.abc import Iterator

from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.subject import Fact, Subject, amount, citations, cited
from codegen.diff.system.trace_rules import CITATION, DOC
from codegen.model.program import BoardLink
from codegen.model.quantities.source_kind import Source, SourceFact
from codegen.model.system import Generations, System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import AdcChannel, Parameter, Stream

_CONNECTED = "whether what is connected was changed with it"
_COUNTED = "whether the ADC still gives the same counts"
_FAILED = "whether it has failed when it is silent for so long"


def board_subjects(system: System) -> Iterator[Subject]:
    """Identity, ADC channels, sensors, links, streams, generations."""
    yield _identity(system)
    yield from (_channel(channel) for channel in system.channels.values())
    yield from (_sensor(source) for source in system.sources.values())
    yield from (_link(link) for link in system.links)
    yield from (_stream(stream) for stream in system.streams.values())
    yield from (_generations(generations) for generations in system.generations)


def _identity(system: System) -> Subject:
    project = system.spec.project
    board = system.spec.board
    adc = system.board.adc if system.board else None
    facts = (
        Fact("system id", _number(system.system_id, system.system_parameter), rules.IDENTITY, project.at("system_id")),
        Fact(
            "component id",
            _number(system.component_id, system.component_parameter),
            rules.IDENTITY,
            project.at("component_id"),
        ),
        Fact("MAVLink", str(project.protocol), rules.IDENTITY, project.at("protocol")),
        Fact("machine code", "yes" if project.machine_code else "no", rules.PROGRAM, project.at("machine_code")),
        Fact("board", system.board_name, rules.PROGRAM, board.at("board"), doubt=_CONNECTED),
        Fact("inputs of the ADC", adc.opened if adc else "none", rules.PROGRAM, board.at("board"), doubt=_COUNTED),
        Fact("speed of the board", _speed(system), rules.PROGRAM, board.at("board")),
        Fact("memory of the board", _memory(system), rules.PROGRAM, board.at("board")),
        Fact("name", project.project, DOC, project.at("project")),
    )
    name = system.spec.program or "project"
    return Subject(name, project.project, rules.IDENTITY, rules.IDENTITY, project.place, facts)


def _speed(system: System) -> str:
    """Return what times are predicted with; empty where nobody has measured it."""
    timing = system.board.timing if system.board else None
    if timing is None:
        return ""
    cycles = f"{decimal(timing.cycles)} to {decimal(timing.most_cycles)} cycles"
    return f"{cycles} of {amount(timing.megahertz, 'MHz')}, a conversion in {amount(timing.conversion_us, 'us')}"


def _memory(system: System) -> str:
    """Return what programs find room in; empty where nobody knows."""
    memory = system.board.memory if system.board else None
    if memory is None:
        return ""
    wifi = f", {memory.wifi} less with Wi-Fi on" if memory.wifi else ""
    files = "" if memory.files is None else f", {memory.files} bytes of files"
    return f"{memory.heap} bytes of heap{wifi}{files}"


def _number(number: int, parameter: Parameter | None) -> str:
    return f"{number}, default of {parameter.name}" if parameter else str(number)


def _when(channel: AdcChannel) -> str:
    if channel.when is None:
        return "always"
    parameter, steps = channel.when
    return f"while {parameter.name} is {amount(steps * parameter.step, parameter.unit.name)}"


def _channel(channel: AdcChannel) -> Subject:
    spec = channel.spec
    pin = f"GPIO of {channel.pin.name}, {channel.gpio} at first" if channel.pin else f"GPIO {channel.gpio}"
    facts = (
        Fact("pin", pin, rules.CHANNEL, spec.at("gpio")),
        Fact("resolution", f"{channel.bits} bits, {channel.full_scale} at full scale", rules.CHANNEL, spec.at("bits")),
        Fact("reference", amount(channel.reference, "V"), rules.CHANNEL, spec.at("reference")),
        Fact("read", _when(channel), rules.CHANNEL, spec.at("when"), doubt="whether it is to be read just then"),
        Fact("samples", str(channel.samples), rules.CHANNEL, spec.at("samples")),
        Fact("time for a mean", amount(channel.read_limit_us, "us"), rules.CHANNEL, spec.at("read_limit")),
        Fact("answers to", ", ".join(cited(channel.citation, channel.aspects)), CITATION, spec.at("requirement")),
    )
    return Subject(
        name=f"adc.{channel.name}",
        says=pin,
        added=rules.CHANNEL,
        removed=rules.CHANNEL,
        place=spec.place,
        facts=facts,
        cited=cited(channel.citation, channel.aspects),
        row=channel.name,
    )


def _sensor(source: Source) -> Subject:
    polling, spec = source.polling, source.polling.spec
    gives = ", ".join(f"{each.name} {each.low}..{each.high} {each.unit.name}".strip() for each in source.outputs)
    facts = (
        Fact("driver", spec.driver, rules.SENSOR, spec.at("driver"), doubt=_CONNECTED),
        *(
            Fact(fact.attribute, fact.text, rules.SENSOR, spec.at(fact.key), doubt=_asked(fact))
            for fact in source.facts()
        ),
        Fact("gives", gives, rules.SENSOR, spec.at("outputs")),
        Fact("asked every", amount(polling.period_us, "us"), rules.SENSOR, spec.at("rate")),
        Fact("time for a turn", amount(polling.limit_us, "us"), rules.SENSOR, spec.at("limit")),
        Fact("set up again after", amount(polling.retry_ms, "ms"), rules.SENSOR, spec.at("retry")),
        Fact("answers to", ", ".join(cited(polling.citation, polling.aspects)), CITATION, spec.at("requirement")),
        Fact("doc", spec.doc or "", DOC, spec.at("doc")),
    )
    return Subject(
        name=f"sensor {source.name}",
        says=source.words(),
        added=rules.SENSOR,
        removed=rules.SENSOR,
        place=spec.place,
        facts=facts,
        cited=cited(polling.citation, polling.aspects),
        row=source.name,
        doubt=f"whether nothing is to be measured by {source.name} any more",
    )


def _asked(fact: SourceFact) -> str:
    if fact.is_trust:
        return _FAILED
    return _CONNECTED if fact.asks else ""


def _link(link: BoardLink) -> Subject:
    spec = link.spec
    written = {
        "uart": spec.uart,
        "tx": spec.tx,
        "rx": spec.rx,
        "baud": spec.baud,
        "buffer": spec.buffer,
        "udp": spec.udp,
        "tcp_server": spec.tcp_server,
        "tcp_client": spec.tcp_client,
        "backlog": spec.tcp_backlog if spec.tcp_server is not None else None,
        "to": spec.to,
        "local_port": spec.local_port,
        "credentials": spec.credentials,
    }
    facts = (
        Fact("over", link.kind.value, rules.LINK, spec.place),
        *(
            Fact(name, "" if value is None else str(value), rules.LINK, spec.at(name))
            for name, value in written.items()
        ),
        Fact("tried again after", amount(link.retry_ms, "ms"), rules.LINK, spec.at("retry")),
        Fact("given up after", amount(link.timeout_ms, "ms"), rules.LINK, spec.at("timeout")),
        Fact("answers to", str(link.citation or ""), CITATION, spec.at("requirement")),
    )
    name, kind = f"link.{link.name}", link.kind.value
    return Subject(name, kind, rules.LINK, rules.LINK, spec.place, facts, cited(link.citation), row=link.name)


def _stream(stream: Stream) -> Subject:
    spec = stream.spec
    facts = (
        Fact("rate", _rate(stream), rules.STREAM_RATE, spec.at("rate" if stream.parameter is None else "parameter")),
        Fact("fastest", amount(stream.fastest, "Hz"), rules.STREAM_RATE, spec.at("fastest")),
        Fact(
            "asked for by",
            "" if stream.data_stream is None else f"{spec.data_stream} ({stream.data_stream})",
            rules.STREAM_RATE,
            spec.at("data_stream"),
        ),
        Fact("answers to", str(stream.citation or ""), CITATION, spec.at("requirement")),
        Fact("doc", spec.doc, DOC, spec.at("doc")),
    )
    name = f"stream {stream.name}"
    return Subject(
        name=name,
        says=_rate(stream),
        added=rules.STREAM_ADDED,
        removed=rules.STREAM_REMOVED,
        place=spec.place,
        facts=facts,
        cited=cited(stream.citation),
        row=stream.name,
    )


def _rate(stream: Stream) -> str:
    rate = amount(stream.default_rate, "Hz")
    return f"{rate}, default of {stream.parameter.name}" if stream.parameter else rate


def _generations(generations: Generations) -> Subject:
    spec = generations.spec
    parameter = generations.parameter
    chosen = f"{generations.default.value}, default of {parameter.name}" if parameter else generations.default.value
    facts = (
        Fact("old", ", ".join(generations.old), rules.GENERATIONS, spec.at("old")),
        Fact("new", ", ".join(generations.new), rules.GENERATIONS, spec.at("new")),
        Fact("sent", chosen, rules.GENERATIONS, spec.at("parameter" if parameter else "send")),
        Fact("fixed", generations.send.value if generations.send else "", rules.GENERATIONS, spec.at("send")),
        Fact("answers to", citations(generations.citation, generations.aspects), CITATION, spec.at("requirement")),
        Fact("doc", spec.doc, DOC, spec.at("doc")),
    )
    return Subject(
        name=f"generations of {generations.component.name}",
        says=chosen,
        added=rules.GENERATIONS,
        removed=rules.GENERATIONS,
        place=spec.place,
        facts=facts,
        cited=cited(generations.citation, generations.aspects),
        messages=(*generations.old, *generations.new),
        row=generations.component.name,
    )
