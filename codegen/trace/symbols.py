"""The generated symbols of each part of the specification, by the names that the targets give them.

A constant of a message is written where its payload is prefilled, a live value where it is built; a quantity is an
attribute of the state and, with a unit, a property for people.
"""

from collections.abc import Iterable, Iterator

from codegen.frozen import dataclass
from codegen.model.answers.answer import Answer
from codegen.model.command import Command
from codegen.model.failsafe import Failsafe
from codegen.model.program import BoardLink, LinkKind
from codegen.model.quantities.source_kind import Source
from codegen.model.reception import ReceivedField, Reception
from codegen.model.system import PopulatedMessage, System
from codegen.model.vehicle import Component, Parameter, Quantity, Reading, Stream
from codegen.targets.firmware.messages.receiving import call_name
from codegen.targets.naming import (
    builder_name,
    class_names,
    encoder_name,
    failsafe_function,
    parameter_attribute,
    state_class,
    writer_name,
)
from codegen.targets.receiver.view import ReceiverView, receiver_view
from codegen.trace.graph import Symbol

INPUTS = "firmware/adc_inputs.py"
BOARD = "firmware/board.py"
FAILSAFE = "firmware/failsafe.py"
MESSAGES = "firmware/messages.py"
PARAMETERS = "firmware/parameters.py"
STATE = "firmware/state.py"
SOURCES = "firmware/sources.py"
STREAMS = "firmware/streams.py"
RECEIVING = "firmware/receiving_plain.py"
PAYLOADS = "firmware/telemetry_plain.py"
TELEMETRY = "firmware/telemetry.py"
VEHICLE = "firmware/vehicle.py"

PROGRAM = {
    "control": ((VEHICLE, "Vehicle.run_pass"), ("firmware/scheduler.py", "Scheduler")),
    "storage": ((VEHICLE, "Vehicle._save_step"), ("firmware/storage.py", "Storage")),
    "arming": ((VEHICLE, "Vehicle.arm"), (VEHICLE, "Vehicle.arming_problem"), (VEHICLE, "Vehicle.halt_motors")),
    "services": (
        ("firmware/services.py", "Services"),
        ("firmware/commands.py", "Commands"),
        ("firmware/parameter_service.py", "ParameterService"),
    ),
    "measure": ((VEHICLE, "Vehicle.measure"),),
    "watchdog": (("firmware/watchdog.py", "watch"), ("firmware/watchdog.py", "reset_reason")),
}
"""The parts of the program by their keys in vehicle.yaml: their modules are copied or rendered as a whole."""

_PORTS = {
    LinkKind.UART: ("firmware/serial_port.py", "open_uart"),
    LinkKind.USB: ("firmware/serial_port.py", "open_usb"),
    LinkKind.UDP: ("firmware/udp_port.py", "UdpPort"),
    LinkKind.TCP_SERVER: ("firmware/tcp_server.py", "TcpServer"),
    LinkKind.TCP_CLIENT: ("firmware/tcp_client.py", "TcpClient"),
}


@dataclass(frozen=True, slots=True)
class Symbols:
    """The symbols of one system; files lie below the output folder, those of a further program below its name."""

    system: System
    classes: dict[str, str]
    receiver: ReceiverView | None

    def message(self, message: PopulatedMessage) -> tuple[Symbol, ...]:
        """Return its class, its builder, and the function of the receiver that reads it."""
        found = [(MESSAGES, self.classes[message.wire.name]), (TELEMETRY, builder_name(message))]
        return self._all([*found, *self._read_by_receiver(message)])

    def field(self, message: PopulatedMessage, answer: Answer) -> tuple[Symbol, ...]:
        """Return where its value is written, and the quantities of the state and the parameters that it reads."""
        found = [(TELEMETRY, builder_name(message)), (PAYLOADS, writer_name(message))]
        for quantity in answer.quantities:
            found += self._quantity(quantity)
        for parameter in answer.parameters:
            found += self._parameter(parameter)
        return self._all([*found, *self._read_by_receiver(message)])

    def reception(self, table: Reception) -> tuple[Symbol, ...]:
        """Return its class, the function that takes it, and the method that is called then."""
        found = [(MESSAGES, self.classes[table.wire.name]), (RECEIVING, f"take_{table.name.lower()}")]
        return self._all([*found, *([(VEHICLE, f"Vehicle.{call_name(table)}")] if table.spec.call else [])])

    def received(self, table: Reception, taken: ReceivedField) -> tuple[Symbol, ...]:
        """Return what takes it, and the quantity."""
        return self._all([(RECEIVING, f"take_{table.name.lower()}"), *self._quantity(taken.quantity)])

    def parameter(self, parameter: Parameter) -> tuple[Symbol, ...]:
        """Return its attribute, and those of its family."""
        return self._all(self._parameter(parameter))

    def stream(self, stream: Stream) -> tuple[Symbol, ...]:
        """Return what sends its messages."""
        sent = [message for message in self.system.messages if message.stream is stream]
        return self._all([(STREAMS, "Streams"), *((TELEMETRY, encoder_name(message)) for message in sent)])

    def generations(self) -> tuple[Symbol, ...]:
        """Return what knows which generation is chosen."""
        return self._all([(STREAMS, "_GENERATIONS"), (STREAMS, "Streams._is_chosen")])

    def link(self, link: BoardLink) -> tuple[Symbol, ...]:
        """Return what opens it."""
        return self._all([(BOARD, "Board.open_ports"), _PORTS[link.kind]])

    def readings(self, readings: Iterable[Reading]) -> tuple[Symbol, ...]:
        """Return what reads the ADC."""
        return self._all(
            (INPUTS, "AdcInputs.read") if reading.is_first else (_module(reading), "connect") for reading in readings
        )

    def sensor(self, source: Source) -> tuple[Symbol, ...]:
        """Return what keeps and loses what it gives."""
        name = source.name
        return self._all([(SOURCES, f"_keep_{name}"), (SOURCES, f"_lose_{name}"), (SOURCES, "Sources")])

    def component(self, component: Component) -> tuple[Symbol, ...]:
        """Return its class, and its update where it is measured."""
        found = [(STATE, state_class(component.name))]
        if any(quantity.derivation.conversion for quantity in component.quantities.values()):
            found.append((STATE, f"SystemState.update_{component.name}"))
        return self._all(found)

    def quantity(self, quantity: Quantity) -> tuple[Symbol, ...]:
        """Return its attribute and its property; of a measured one also the function that converts counts."""
        return self._all(self._quantity(quantity))

    def failsafe(self, failsafe: Failsafe) -> tuple[Symbol, ...]:
        """Return what makes it, and the class of all."""
        return self._all([(FAILSAFE, failsafe_function(failsafe.name)), (FAILSAFE, "Failsafe")])

    def part_of_program(self, name: str) -> tuple[Symbol, ...]:
        """The modules of one part of the program, by its key in vehicle.yaml."""
        program = self.system.program
        if name == "access" and program is not None and program.access is not None:
            signed = [("firmware/access.py", "Access")] if program.access.signed else []
            listed = [("firmware/listed_stations.py", "ListedStations")] if program.access.listed else []
            return self._all([*signed, *listed])
        return self._all(PROGRAM.get(name, ()))

    def command(self, command: Command) -> tuple[Symbol, ...]:
        """The method that does it, and what looks at its parameters."""
        method = command.spec.method
        ends = ("_progress", "_cancel") if command.spec.long else ()
        found = [(VEHICLE, f"Vehicle.{method}{end}") for end in ("", *ends)]
        found += [("firmware/command_table.py", "COMMANDS"), ("firmware/own_commands.py", "OwnCommands")]
        return self._all([*found, *([("firmware/long_commands.py", "LongCommands")] if command.spec.long else [])])

    def mode(self) -> tuple[Symbol, ...]:
        """Return what changes modes."""
        return self._all([(VEHICLE, "Vehicle.MODES"), (VEHICLE, "Vehicle.set_mode")])

    def whole_receiver(self) -> tuple[Symbol, ...]:
        """The class of the receiver."""
        view = self.receiver
        return self._all([(f"receiver/{view.module}.py", view.views_class)] if view else [])

    def _read_by_receiver(self, message: PopulatedMessage) -> Iterator[tuple[str, str]]:
        for reader in self.receiver.readers if self.receiver else ():
            if self.receiver and reader.name == message.wire.name:
                yield f"receiver/{self.receiver.module}.py", reader.function

    def _parameter(self, parameter: Parameter) -> list[tuple[str, str]]:
        names = parameter.siblings or (parameter.name,)
        return [(PARAMETERS, f"Parameters.{parameter_attribute(name)}") for name in names]

    def _quantity(self, quantity: Quantity) -> list[tuple[str, str]]:
        owner = state_class(quantity.component)
        stored = quantity.name if quantity.is_computed else quantity.attribute
        found = [(STATE, f"{owner}.{name}") for name in dict.fromkeys((stored, quantity.name))]
        if quantity.derivation.conversion is not None:
            for reading in self.system.readings():
                if reading.quantity is quantity and reading.is_first:
                    found.append((STATE, f"{owner}.{quantity.name}_from_adc"))
                    found += [(STATE, f"{owner}.set_count")] if reading.is_plain else []
                elif reading.quantity is quantity:
                    found += [(_module(reading), f"{quantity.name}_from_adc"), (_module(reading), "behind")]
        return found

    def _all(self, found: Iterable[tuple[str, str]]) -> tuple[Symbol, ...]:
        program = self.system.spec.program
        below = f"{program}/" if program else ""
        return tuple(dict.fromkeys(Symbol(f"{below}{file}", name) for file, name in found))


def _module(reading: Reading) -> str:
    """The module of a reading behind the first of its component."""
    return f"firmware/{reading.name}.py"


def symbols_of(system: System) -> Symbols:
    """The symbols of a system."""
    receiver = receiver_view(system, system.receiver) if system.receiver else None
    return Symbols(system, class_names(wire.name for wire in system.wires), receiver)
