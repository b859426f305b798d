"""``board.yaml``: the board, what is connected to it, and its links."""

from collections.abc import Mapping
from fractions import Fraction
from typing import ClassVar, Literal

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, described
from codegen.model.spec.source import SourceSpec
from codegen.source import Place, Written


@dataclass(frozen=True, slots=True, kw_only=True)
class AdcSpec(Written):
    """One ADC channel."""

    gpio: int | None = described("GPIO number of the pin.", default=None)
    pin: str | None = described(
        "Parameter that has the GPIO number of the pin; its default is used first.", default=None
    )
    when: Mapping[str, Fraction] = described(
        "A parameter and the value at which the channel is read, such as BATT_MONITOR: 4; without it, it always is. "
        "The parameter is used after a restart.",
        default_factory=dict,
    )
    bits: int | None = described("Resolution of one count. Default: that of the board.", default=None)
    reference: Amount | None = described(
        "Voltage of full scale, such as 3.3 V. Default: that of the board.", default=None
    )
    samples: int = described("Readings whose mean is one reading of the channel.", default=1)
    read_limit: Amount | None = described(
        "Longest time that one mean may take, such as 2 ms; 1 s at most.", default=None
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: reference, samples, read_limit, failure, absence, pin, rate, monitor, first, "
        "when.",
        default_factory=dict,
    )

    ASPECTS = ("reference", "samples", "read_limit", "failure", "absence", "pin", "rate", "monitor", "first", "when")
    ONE_OF: ClassVar[tuple[str, ...]] = ("gpio", "pin")


@dataclass(frozen=True, slots=True, kw_only=True)
class LinkSpec(Written):
    """One link to ground stations: a serial port, the USB port, or over Wi-Fi UDP, a TCP server or a TCP client."""

    uart: int | None = described("Number of the UART.", default=None)
    usb: Literal[True] | None = described(
        "The USB port. MAVLink takes the place of the MicroPython prompt there.", default=None
    )
    udp: int | None = described("UDP port of the ground station.", default=None)
    tcp_server: int | None = described("TCP port of the vehicle, to which ground stations connect.", default=None)
    tcp_client: int | None = described("TCP port of the ground station, to which the vehicle connects.", default=None)
    tx: int | None = described("GPIO number of a UART's output.", default=None)
    rx: int | None = described("GPIO number of a UART's input.", default=None)
    baud: int | None = described("Bits per second of a UART.", default=None)
    buffer: int = described(
        "Bytes that wait for a slow UART or USB port; frames that do not fit are dropped.", default=1024
    )
    to: str | None = described(
        "Address that UDP datagrams go to until a ground station answers, such as 255.255.255.255 for everybody, or "
        "that a TCP client connects to.",
        default=None,
    )
    local_port: int = described("UDP port of the vehicle, of this link alone; 0 for any.", default=0)
    backlog: int | None = described("Connections that wait until a TCP server takes them. Default: 4.", default=None)
    timeout: Amount | None = described(
        "Time after which a TCP connection is closed over which no frame of a station came, or that took none, such "
        "as 30 s.",
        default=None,
    )
    credentials: str | None = described(
        "JSON file on the board with the Wi-Fi's ssid and password, the same for all links; host, port and local_port "
        "in it win over the values given here. Under the name of a link they stand for that link alone; those of a "
        "TCP link do, but for the host of a client.",
        default=None,
    )
    retry: Amount | None = described(
        "Time between two attempts to join the Wi-Fi, such as 5 s, and from a TCP client's first attempt to connect "
        "to the second; each further pause is twice as long, up to 16 times.",
        default=None,
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)

    ONE_OF: ClassVar[tuple[str, ...]] = ("uart", "usb", "udp", "tcp_server", "tcp_client")

    @property
    def is_tcp(self) -> bool:
        """Return whether it goes over TCP, at either end."""
        return self.tcp_server is not None or self.tcp_client is not None

    @property
    def tcp_backlog(self) -> int:
        """Return the number of connections that can wait until a TCP server takes them."""
        return 4 if self.backlog is None else self.backlog

    @property
    def is_wireless(self) -> bool:
        """Return whether it goes over Wi-Fi, where others may listen."""
        return self.uart is None and not self.usb


@dataclass(frozen=True, slots=True, kw_only=True)
class InstanceSpec(Written):
    """One of several instances of a component, such as one of two batteries."""

    prefix: str | None = described(
        "Front of the names of its parameters, such as BATT2_; the first one's is the front of the names in "
        "parameters.yaml.",
        default=None,
    )
    doc: str | None = described("What this one is, for people.", default=None)
    defaults: Mapping[str, Fraction] = described(
        "Defaults of its parameters where they differ from those of the first instance.", default_factory=dict
    )
    facts: Mapping[str, str | Fraction] = described(
        "Facts about it where they differ from those of the component.", default_factory=dict
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class CurveSpec(Written):
    """A curve: the values of a quantity by amounts of a measured one, straight between its points."""

    points: Mapping[str, Fraction] = described(
        "The value in the unit of the quantity, by the amount that is measured: {0.2 V: 0, 2.9 V: 40}.",
        default_factory=dict,
    )
    choice: str | None = described(
        "A fact of the component that decides which points count, such as chemistry; the points stand under by then.",
        default=None,
    )
    by: Mapping[str, Mapping[str, Fraction]] = described(
        "Points by what the fact of choice is: {MAV_BATTERY_TYPE_LIPO: {4.2 V: 100, 3.27 V: 0}}.", default_factory=dict
    )
    per: str | None = described(
        "A fact of the component that counts something, such as cells: the amounts are for one of them.", default=None
    )
    spare: bool = described(
        "true: it is kept for who estimates by it later; otherwise a curve that no quantity names is a warning.",
        default=False,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class BoardSpec(Written):
    """``board.yaml``: the board and what is connected to it."""

    board: str | None = described(
        "The board: a file of codegen/boards, or of the folder boards beside this one, without its ending (pico_2_w). "
        "Without it no pin is known, and nothing can be connected to one.",
        default=None,
    )
    adc: Mapping[str, AdcSpec] = described("ADC channels by name.", default_factory=dict)
    sources: Mapping[str, SourceSpec] = described("Sensors by name.", default_factory=dict)
    links: Mapping[str, LinkSpec] = described("Links to ground stations by name.", default_factory=dict)
    facts: Mapping[str, Mapping[str, str | Fraction]] = described(
        "Facts about the connected hardware by component: enum entries, numbers or amounts.", default_factory=dict
    )
    instances: Mapping[str, tuple[InstanceSpec, ...]] = described(
        "Which instances of a component there are, in the order of their numbers; without an entry there is one.",
        default_factory=dict,
    )
    curves: Mapping[str, CurveSpec] = described(
        "Curves by name: what a measured amount stands for, for quantities with estimate_from.", default_factory=dict
    )

    def fact_place(self, component: str, number: int, fact: str) -> Place:
        """Return where a fact of an instance is written: with the instance, or with the component."""
        written = self.instances.get(component, ())
        if number < len(written) and fact in written[number].facts:
            return written[number].at(f"facts.{fact}")
        return self.at(f"facts.{component}.{fact}")
