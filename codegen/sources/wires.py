"""The connections of sensors: UARTs and I2C buses of the board."""

from collections.abc import Iterator
from typing import Protocol

from codegen.frozen import dataclass
from codegen.measure import read_amount
from codegen.model.board_model import shown_pins
from codegen.model.quantities.source_kind import PinUse
from codegen.model.spec.described import Amount
from codegen.model.units.unit import unit_named
from codegen.sources.kind import BAD_SOURCE, Around

USUAL_CLOCK = "400 kHz"
"""The clock of an I2C bus where nobody says another one."""


class SerialKeys(Protocol):
    """The keys that say which UART."""

    @property
    def uart(self) -> int: ...
    @property
    def tx(self) -> int: ...
    @property
    def rx(self) -> int: ...


class BusKeys(Protocol):
    """The keys that say which I2C bus."""

    @property
    def i2c(self) -> int: ...
    @property
    def sda(self) -> int: ...
    @property
    def scl(self) -> int: ...


@dataclass(frozen=True, slots=True)
class Serial:
    """A UART: ``opened`` is the expression that opens it, and the choices are the pins that could be taken."""

    number: int
    baud: int
    tx: int
    rx: int
    outputs: frozenset[int]
    inputs: frozenset[int]
    opened: str

    @property
    def port(self) -> str:
        """Return what it takes as a whole."""
        return f"UART {self.number}"

    def pins(self) -> Iterator[PinUse]:
        """Yield both of its pins."""
        yield PinUse(self.tx, "tx", self.outputs)
        yield PinUse(self.rx, "rx", self.inputs)


@dataclass(frozen=True, slots=True)
class Bus:
    """An I2C bus: ``opened`` is the expression that opens it, and ``frequency`` its clock in Hz."""

    number: int
    frequency: int
    sda: int
    scl: int
    data: frozenset[int]
    clocks: frozenset[int]
    opened: str

    def pins(self) -> Iterator[PinUse]:
        """Yield both of its lines, to which several may be connected."""
        yield PinUse(self.sda, "sda", self.data, f"SDA of I2C {self.number}")
        yield PinUse(self.scl, "scl", self.clocks, f"SCL of I2C {self.number}")


def serial(spec: SerialKeys, baud: int, size: int, around: Around) -> Serial | None:
    """The UART; None after a finding."""
    board = around.known_board(f"UART {spec.uart}")
    if board is None:
        return None
    uart = board.uarts.get(spec.uart)
    if uart is None:
        numbers = f"UART {shown_pins(frozenset(board.uarts))}" if board.uarts else "no UART"
        around.bad(
            "uart",
            f"the {board.name} has {numbers} for sensors, and no UART {spec.uart}",
            hint=f"uart: {min(board.uarts)}" if board.uarts else "take a board with a UART, or a sensor without",
        )
        return None
    around.within("baud", baud, 300, 3000000)
    around.within("buffer", size, 64, 65536)
    around.pin("tx", spec.tx, uart.tx, f"tx of UART {spec.uart}", board)
    around.pin("rx", spec.rx, uart.rx, f"rx of UART {spec.uart}", board)
    pins = f"tx=machine.Pin({spec.tx}), rx=machine.Pin({spec.rx}), " if board.tells_uart_pins else ""
    opened = f"machine.UART({spec.uart}, baudrate={baud}, {pins}timeout=0, rxbuf={size})"
    return Serial(spec.uart, baud, spec.tx, spec.rx, uart.tx & board.free, uart.rx & board.free, opened)


def clock(written: Amount | str | None, usual: str, around: Around, key: str = "frequency") -> int:
    """Return the clock of an I2C bus in Hz, as written at a key, or as usual; 0 after a finding."""
    place = around.spec.at(key)
    frequency = read_amount(written or usual, unit_named("Hz"), place, around.report)
    if frequency is None or frequency.denominator != 1 or not 10000 <= frequency <= 1000000:
        around.failed = True
        if frequency is not None:
            message = f"{written or usual} is no clock of 10 kHz to 1 MHz"
            around.report.add(BAD_SOURCE, place, message, f"frequency: {USUAL_CLOCK}")
        return 0
    return int(frequency)


def bus(spec: BusKeys, frequency: int, around: Around) -> Bus | None:
    """The I2C bus; None after a finding."""
    board = around.known_board(f"I2C {spec.i2c}")
    if board is None:
        return None
    found = board.i2c.get(spec.i2c)
    if found is None:
        numbers = f"I2C {shown_pins(frozenset(board.i2c))}" if board.i2c else "no I2C"
        around.bad(
            "i2c",
            f"the {board.name} has {numbers}, and no I2C {spec.i2c}",
            hint=f"i2c: {min(board.i2c)}" if board.i2c else "take a board with I2C, or a sensor without",
        )
        return None
    around.pin("sda", spec.sda, found.sda, f"sda of I2C {spec.i2c}", board)
    around.pin("scl", spec.scl, found.scl, f"scl of I2C {spec.i2c}", board)
    pins = f", sda=machine.Pin({spec.sda}), scl=machine.Pin({spec.scl})" if board.tells_i2c_pins else ""
    opened = f"machine.I2C({spec.i2c}{pins}, freq={frequency})"
    return Bus(spec.i2c, frequency, spec.sda, spec.scl, found.sda & board.free, found.scl & board.free, opened)
