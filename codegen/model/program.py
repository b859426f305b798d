"""The program that the board runs around the telemetry, resolved."""

from collections.abc import Mapping
from enum import Enum
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.absence import Absence
from codegen.model.access import Access
from codegen.model.code.clock import SYSTEM_TIME
from codegen.model.command import BUILT_IN, BuiltInCommand, Command, Mode, Needs
from codegen.model.dialect.dialect import WireMessage
from codegen.model.failsafe import Failsafe
from codegen.model.spec.access import SETUP_SIGNING
from codegen.model.spec.board import LinkSpec
from codegen.model.spec.program import ActionSpec, VehicleSpec
from codegen.model.spec.spec import ParameterEncoding
from codegen.model.vehicle import Citation, Component, Quantity
from codegen.model.watchdog import Watchdog


class LinkKind(Enum):
    """The kind of a link to ground stations."""

    UART = "uart"
    USB = "usb"
    UDP = "udp"
    TCP_SERVER = "tcp_server"
    TCP_CLIENT = "tcp_client"

    @property
    def words(self) -> str:
        """Return its name for people."""
        return self.value.upper() if self.value in ("uart", "usb", "udp") else self.value.replace("tcp_", "TCP ")

    @property
    def is_wireless(self) -> bool:
        """Return whether it needs Wi-Fi."""
        return self in (LinkKind.UDP, LinkKind.TCP_SERVER, LinkKind.TCP_CLIENT)


VEHICLE_QUANTITIES = {"armed": "boolean", "ready": "boolean", "status": "enum", "mode": "number", "load": "number"}
"""Quantities that the program writes into the component ``vehicle`` of the state, with the kind that each must have.

A program that cannot be armed writes the load, the status and the mode where the state has them so.
"""

RECEIVED = (
    "HEARTBEAT",
    "PING",
    "PARAM_REQUEST_READ",
    "PARAM_REQUEST_LIST",
    "PARAM_SET",
    "REQUEST_DATA_STREAM",
    "COMMAND_INT",
    "COMMAND_LONG",
    "FILE_TRANSFER_PROTOCOL",
)
"""The messages that the services receive, in the order in which links are given them."""
SENT = ("PING", "PARAM_VALUE", "COMMAND_ACK", "MESSAGE_INTERVAL", "STATUSTEXT", "PARAM_ERROR")
"""The messages that the services send; of FILE_TRANSFER_PROTOCOL they send a short beginning only."""


COMMAND_CANCEL = "COMMAND_CANCEL"
"""The message that ends a command that takes long."""
SET_MODE = "SET_MODE"
"""The message that MAV_CMD_DO_SET_MODE supersedes."""

_NOT_OF_ALL = (SYSTEM_TIME, SET_MODE, COMMAND_CANCEL, SETUP_SIGNING)


def is_set_by_program(vehicle: Component | None, name: str) -> bool:
    """Return whether a quantity of the component ``vehicle`` is one that the program writes."""
    quantity = vehicle.quantities.get(name) if vehicle and vehicle.instances == 1 else None
    return quantity is not None and can_be_set_as(quantity, name)


def can_be_set_as(quantity: Quantity, name: str) -> bool:
    """Return whether a quantity is of the kind that the one of that name has, and nothing else sets it."""
    return quantity.kind.value == VEHICLE_QUANTITIES[name] and quantity.derivation.is_set_by_code


@dataclass(frozen=True, slots=True)
class BoardLink:
    """A link of the board.

    ``retry_ms`` is the time between two attempts to join the Wi-Fi, 0 for other links, ``timeout_ms`` that after which
    a TCP connection is given up.
    """

    name: str
    kind: LinkKind
    retry_ms: int
    spec: LinkSpec
    citation: Citation | None
    timeout_ms: int = 0


@dataclass(frozen=True, slots=True)
class Program:
    """The program of a board: main loop, storage, arming, failsafes, services. Periods are in us and ms.

    ``services`` are the messages of the dialect that the services receive and send, ``sent`` the names of those that
    they send; ``constants`` are the entries of its enums that the program uses, by name; ``fastest`` is the highest
    rate in Hz of messages without a stream, ``silence_ms`` the time without a HEARTBEAT after which a ground station
    is gone. ``module`` and ``class_name`` are those of the user's code, which is asked to measure every ``measure_us``,
    or not at all: None. ``cited`` and ``aspects`` are what is cited by the sections of vehicle.yaml, as a whole and for
    single aspects. ``commands`` are those of the project, ``modes`` those that are declared.
    ``priority`` are the actions, the most severe first, or none where each failsafe acts for itself. ``access`` is None
    where every link is open, ``watchdog`` where nothing resets a loop that stands still. ``absences`` are the questions
    about what it does not have. ``encoding`` is how values of parameters go over the wire.
    """

    control_us: int
    links_us: int
    checks_us: int
    report_ms: int
    step_limit_us: int
    failsafes: tuple[Failsafe, ...]
    actions: tuple[ActionSpec, ...]
    services: tuple[WireMessage, ...]
    sent: tuple[str, ...]
    constants: Mapping[str, int]
    fastest: Fraction
    module: str
    class_name: str
    measure_us: int | None
    silence_ms: int
    cited: Mapping[str, Citation]
    aspects: Mapping[str, Mapping[str, Citation]]
    spec: VehicleSpec
    commands: tuple[Command, ...] = ()
    modes: tuple[Mode, ...] = ()
    priority: tuple[ActionSpec, ...] = ()
    access: Access | None = None
    watchdog: Watchdog | None = None
    absences: tuple[Absence, ...] = ()
    encoding: ParameterEncoding = ParameterEncoding.C_CAST

    @property
    def built_in(self) -> tuple[BuiltInCommand, ...]:
        """The commands that it answers by itself."""
        has = {Needs.NOTHING: True, Needs.ARMING: self.spec.arming is not None, Needs.MODES: bool(self.modes)}
        return tuple(command for command in BUILT_IN if has[command.needs])

    def looks_with_readings(self, failsafe: Failsafe) -> bool:
        """Return whether a failsafe looks in each pass in which its component is read.

        All others look every ``checks_us``, also those whose component is read less often than that: something else of
        it may be set meanwhile, and a time may end.
        """
        component = failsafe.component
        return failsafe.quantity is not None and component is not None and self.reads_often(component)

    def reads_often(self, component: Component) -> bool:
        """Return whether the ADC reads a component, and at least once in ``checks_us``."""
        return component.readings != () and component.read_every_ms * 1000 <= self.checks_us

    @property
    def cancels(self) -> bool:
        """Return whether COMMAND_CANCEL ends what takes long: not every dialect has it."""
        return any(message.name == COMMAND_CANCEL for message in self.services)

    @property
    def changes_modes_by_message(self) -> bool:
        """Return whether SET_MODE changes the mode, too: not every dialect has it any more."""
        return any(message.name == SET_MODE for message in self.services)

    @property
    def received_besides(self) -> tuple[str, ...]:
        """The messages that the services of this program receive, and not those of every program."""
        return tuple(each.name for each in self.services if each.name in _NOT_OF_ALL)

    @property
    def takes_time(self) -> bool:
        """Return whether a ground station's SYSTEM_TIME sets the time since 1970."""
        return any(message.name == SYSTEM_TIME for message in self.services)
