"""The rows of the specification: every record of the tables that cites a requirement or a criterion."""

from collections.abc import Iterable, Iterator, Mapping

from codegen.model.clock import CLOCK
from codegen.model.system import System
from codegen.model.vehicle import Citation, Cited, Parameter
from codegen.source import Place, Written
from codegen.trace.graph import Kind, Row, Symbol
from codegen.trace.symbols import Symbols, symbols_of


def rows_of(systems: Iterable[System]) -> tuple[Row, ...]:
    """The rows of a project and of its further programs in the order of their files.

    What several programs make of one record is one row, with the symbols of all of them. A record that cites nothing,
    and of which no aspect does, is a row with an empty criterion; a quantity may leave that to its component.
    """
    united: dict[tuple[Kind, str, str, str, Place], dict[Symbol, None]] = {}
    for system in systems:
        for row in _rows(system):
            key = (row.kind, row.name, row.part, row.criterion, row.place)
            united.setdefault(key, {}).update(dict.fromkeys(row.symbols))
    rows = [Row(*key, tuple(symbols)) for key, symbols in united.items()]
    return tuple(sorted(rows, key=lambda row: (row.place, row.kind, row.name, row.part)))


def _rows(system: System) -> Iterator[Row]:
    symbols = symbols_of(system)
    yield from _messages(system, symbols)
    yield from _state(system, symbols)
    yield from _board(system, symbols)
    for name, parameter in system.parameters.items():
        if not parameter.siblings or name == parameter.siblings[0]:
            yield from _whole(Kind.PARAMETER, name, parameter.citation, parameter.spec, symbols.parameter(parameter))
    for stream in system.streams.values():
        yield from _whole(Kind.STREAM, stream.name, stream.citation, stream.spec, symbols.stream(stream))
    for generations in system.generations:
        name = generations.component.name
        yield from _whole(Kind.GENERATIONS, name, generations.citation, generations.spec, symbols.generations())
    yield from _program(system, symbols)
    if system.receiver is not None:
        receiver = system.receiver
        name = receiver.component.name
        yield from _whole(Kind.RECEIVER, name, receiver.citation, receiver.spec, symbols.whole_receiver())


def _messages(system: System, symbols: Symbols) -> Iterator[Row]:
    for message in system.messages:
        yield from _whole(Kind.MESSAGE, message.name, message.citation, message.population, symbols.message(message))
        for answer in message.answers:
            covers = answer.covers
            name = f"{message.name}.{covers.field.name}"
            part = covers.label.removeprefix(covers.field.name)
            place = covers.written.place
            yield Row(Kind.FIELD, name, part, str(covers.citation), place, symbols.field(message, answer))


def _state(system: System, symbols: Symbols) -> Iterator[Row]:
    for component in system.components.values():
        if component.name == CLOCK:
            continue  # the firmware's own: fields ask for it
        found = symbols.component(component)
        yield from _cited(Kind.COMPONENT, component.name, component, component.spec, found)
        for quantity in component.quantities.values():
            if quantity.citation is None and not quantity.aspects and component.citation is not None:
                continue
            yield from _cited(Kind.QUANTITY, quantity.path, quantity, quantity.spec, symbols.quantity(quantity))


def _board(system: System, symbols: Symbols) -> Iterator[Row]:
    for channel in system.channels.values():
        read = [reading for reading in system.readings() if reading.conversion.channel is channel]
        yield from _cited(Kind.ADC, channel.name, channel, channel.spec, symbols.readings(read))
    for link in system.links:
        yield from _whole(Kind.LINK, link.name, link.citation, link.spec, symbols.link(link))


def _program(system: System, symbols: Symbols) -> Iterator[Row]:
    program = system.program
    if program is None:
        return
    written: Mapping[str, Written | None] = {
        "control": program.spec.control,
        "storage": program.spec.storage,
        "arming": program.spec.arming,
        "services": program.spec.services,
        "measure": program.spec.code,
    }
    for name, citation in program.cited.items():
        yield from _whole(Kind.PROGRAM, name, citation, written[name] or program.spec, symbols.part_of_program(name))
    for failsafe in program.failsafes:
        name = failsafe.component.name
        found = symbols.failsafe(failsafe.component)
        yield from _whole(Kind.FAILSAFE, name, failsafe.citation, failsafe.spec, found)
        for part, level, spec in (
            ("low", failsafe.low, failsafe.spec.low),
            ("critical", failsafe.critical, failsafe.spec.critical),
        ):
            if level.citation is not None:
                used = [*found, *_attributes((level.below, level.action), symbols)]
                yield Row(Kind.FAILSAFE, name, part, str(level.citation), spec.place, tuple(used))


def _attributes(parameters: Iterable[Parameter], symbols: Symbols) -> Iterator[Symbol]:
    for parameter in parameters:
        yield from symbols.parameter(parameter)


def _whole(
    kind: Kind, name: str, citation: Citation | None, written: Written, symbols: tuple[Symbol, ...]
) -> Iterator[Row]:
    yield Row(kind, name, "", str(citation or ""), written.place, symbols)


def _cited(kind: Kind, name: str, cited: Cited, written: Written, symbols: tuple[Symbol, ...]) -> Iterator[Row]:
    if cited.citation is not None or not cited.aspects:
        yield from _whole(kind, name, cited.citation, written, symbols)
    for aspect, citation in cited.aspects.items():
        yield Row(kind, name, aspect, str(citation), written.at(f"criteria.{aspect}"), symbols)
