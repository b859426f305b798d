"""The rows of the specification: every record of the tables that cites a requirement or a criterion."""

from collections.abc import Iterable, Iterator, Mapping

from codegen.model.code.clock import CLOCK
from codegen.model.system import System
from codegen.model.vehicle import Citation, Cited, Parameter
from codegen.source import Place, Written
from codegen.trace.graph import Kind, Row, Symbol
from codegen.trace.symbols import Symbols, symbols_of


def rows_of(systems: Iterable[System]) -> tuple[Row, ...]:
    """The rows of a project and of its further programs in the order of their files.

    What several programs make of one record is one row, with the symbols of all of them. A record that cites nothing,
    and of which no aspect does, is a row with an empty criterion; a quantity may leave that to its component, or to
    the table of the message that sets it.
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
    yield from _receptions(system, symbols)
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
        yield from _aspects(Kind.GENERATIONS, name, generations.aspects, generations.spec, symbols.generations())
    yield from _program(system, symbols)
    if system.receiver is not None:
        receiver = system.receiver
        name = receiver.component.name
        yield from _whole(Kind.RECEIVER, name, receiver.citation, receiver.spec, symbols.whole_receiver())
        yield from _aspects(Kind.RECEIVER, name, receiver.aspects, receiver.spec, symbols.whole_receiver())


def _messages(system: System, symbols: Symbols) -> Iterator[Row]:
    for message in system.messages:
        found = symbols.message(message)
        yield from _whole(Kind.MESSAGE, message.name, message.citation, message.population, found)
        yield from _aspects(Kind.MESSAGE, message.name, message.aspects, message.population, found)
        for answer in message.answers:
            covers = answer.covers
            name = f"{message.name}.{covers.field.name}"
            part = covers.label.removeprefix(covers.field.name)
            place = covers.written.place
            yield Row(Kind.FIELD, name, part, str(covers.citation), place, symbols.field(message, answer))


def _receptions(system: System, symbols: Symbols) -> Iterator[Row]:
    for table in system.receptions:
        yield from _cited(Kind.RECEIVED, table.name, table, table.spec, symbols.reception(table))
        for taken in table.fields:
            name = f"{table.name}.{taken.field.name}"
            part = taken.label.removeprefix(taken.field.name)
            found = symbols.received(table, taken)
            yield Row(Kind.RECEIVED_FIELD, name, part, str(taken.citation), taken.spec.place, found)


def _state(system: System, symbols: Symbols) -> Iterator[Row]:
    for component in system.components.values():
        if component.name == CLOCK:
            continue  # the firmware's own: fields ask for it
        found = symbols.component(component)
        yield from _cited(Kind.COMPONENT, component.name, component, component.spec, found)
        for quantity in component.quantities.values():
            is_asked_elsewhere = component.citation is not None or quantity.derivation.is_received
            if quantity.citation is None and not quantity.aspects and is_asked_elsewhere:
                continue
            yield from _cited(Kind.QUANTITY, quantity.path, quantity, quantity.spec, symbols.quantity(quantity))


def _board(system: System, symbols: Symbols) -> Iterator[Row]:
    for channel in system.channels.values():
        read = [reading for reading in system.readings() if reading.conversion.channel is channel]
        yield from _cited(Kind.ADC, channel.name, channel, channel.spec, symbols.readings(read))
    for source in system.sources.values():
        polling = source.polling
        yield from _cited(Kind.SENSOR, source.name, polling, polling.spec, symbols.sensor(source))
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
        "access": program.spec.access,
        "watchdog": program.spec.watchdog,
        "measure": program.spec.code,
    }
    for name, citation in program.cited.items():
        yield from _whole(Kind.PROGRAM, name, citation, written[name] or program.spec, symbols.part_of_program(name))
    for name, aspects in program.aspects.items():
        section = written[name] or program.spec
        yield from _aspects(Kind.PROGRAM, name, aspects, section, symbols.part_of_program(name))
    for failsafe in program.failsafes:
        found = symbols.failsafe(failsafe)
        yield from _whole(Kind.FAILSAFE, failsafe.name, failsafe.citation, failsafe.spec, found)
        yield from _aspects(Kind.FAILSAFE, failsafe.name, failsafe.aspects, failsafe.spec, found)
        for level in failsafe.levels:
            if level.citation is not None:
                used = [*found, *_attributes(level.parameters, symbols)]
                place = level.spec.place
                yield Row(Kind.FAILSAFE, failsafe.name, level.name, str(level.citation), place, tuple(used))
    for command in program.commands:
        found = symbols.command(command)
        yield from _whole(Kind.COMMAND, command.name, command.citation, command.spec, found)
        yield from _aspects(Kind.COMMAND, command.name, command.aspects, command.spec, found)
    for mode in program.modes:
        yield from _whole(Kind.MODE, mode.name, mode.citation, mode.spec, symbols.mode())


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
    yield from _aspects(kind, name, cited.aspects, written, symbols)


def _aspects(
    kind: Kind, name: str, aspects: Mapping[str, Citation], written: Written, symbols: tuple[Symbol, ...]
) -> Iterator[Row]:
    for aspect, citation in aspects.items():
        yield Row(kind, name, aspect, str(citation), written.at(f"criteria.{aspect}"), symbols)
