"""A kind of board: its pins, converters and ports, from ``codegen/boards/*.yaml`` or the project's own folder."""

from collections.abc import Mapping
from enum import StrEnum
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.board_watchdog import BoardWatchdog, BoardWatchdogSpec
from codegen.model.spec.described import Amount, Verbatim, described
from codegen.source import Written

MOST_BITS = 12
"""Bits of the widest converter: a mean of samples that have more would not be a small integer of every port."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ConverterSpec(Written):
    """The analog-to-digital converter of a board."""

    pins: Verbatim = described("GPIO numbers that it measures, such as 26..28, 32.")
    bits: int = described("Resolution of one count.")
    reference: Amount = described("Voltage of full scale, such as 3.3 V.")
    opened: str = described("The Python expression that opens an input; {gpio} stands for the number of its pin.")


@dataclass(frozen=True, slots=True, kw_only=True)
class UartSpec(Written):
    """One UART of a board."""

    tx: Verbatim = described("GPIO numbers that can be its output, such as 0, 12, 16.")
    rx: Verbatim = described("GPIO numbers that can be its input.")


@dataclass(frozen=True, slots=True, kw_only=True)
class I2cSpec(Written):
    """One I2C bus of a board."""

    sda: Verbatim = described("GPIO numbers that can be its data, such as 0, 4, 8.")
    scl: Verbatim = described("GPIO numbers that can be its clock.")


@dataclass(frozen=True, slots=True, kw_only=True)
class TimingSpec(Written):
    """The speed of a board, for the prediction of how long a pass of the main loop takes."""

    clock: Amount = described("How fast the processor runs under MicroPython, such as 150 MHz.")
    cycles: Fraction = described(
        "Cycles that it takes for an instruction that is counted with MicroPython's unix port on x86-64: likely."
    )
    most_cycles: Fraction = described("The same, at most.")
    conversion: Amount = described("What one read_u16() of the converter takes, such as 4.6 us.")
    source: str = described("Where this was measured.")


@dataclass(frozen=True, slots=True, kw_only=True)
class MemorySpec(Written):
    """The memory of a board, for the estimate of whether a program finds room."""

    heap: Amount = described(
        "What its MicroPython leaves to programs, as gc.mem_free() says after the start, such as 185 KiB."
    )
    wifi: Amount | None = described(
        "What of it is no longer there once Wi-Fi is on, where both have their memory of the same RAM.", default=None
    )
    files: Amount | None = described("How large its file system is, such as 848 KiB.", default=None)
    source: str = described("Where this is stated, or how it was measured.")


class UartPins(StrEnum):
    """The pins of a UART, or of an I2C bus: chosen when it is opened, or fixed by the board."""

    CHOSEN = "chosen"
    FIXED = "fixed"


class Architecture(StrEnum):
    """The architectures that mpy-cross knows, in the order of their numbers in .mpy files."""

    BYTECODE = "bytecode"
    X86 = "x86"
    X64 = "x64"
    ARMV6 = "armv6"
    ARMV6M = "armv6m"
    ARMV7M = "armv7m"
    ARMV7EM = "armv7em"
    ARMV7EMSP = "armv7emsp"
    ARMV7EMDP = "armv7emdp"
    XTENSA = "xtensa"
    XTENSAWIN = "xtensawin"
    RV32IMC = "rv32imc"
    RV64IMC = "rv64imc"


@dataclass(frozen=True, slots=True, kw_only=True)
class BoardModelSpec(Written):
    """A kind of board, as its YAML file states it."""

    name: str = described("Name of the board, for people.")
    mcu: str = described("Name of the microcontroller.")
    source: str = described("Where all of this is stated: datasheets, and the documentation of its MicroPython.")
    architecture: Architecture = described("What mpy-cross compiles machine code for, such as armv7emsp.")
    pins: Verbatim = described("GPIO numbers that exist, such as 0..22, 26..28.")
    taken: Mapping[str, str] = described(
        "GPIO numbers that the board needs for itself, each with what for.", default_factory=dict
    )
    labels: Mapping[str, str] = described(
        "What is printed beside a pin, or its number on the header, by GPIO number: pin 31.", default_factory=dict
    )
    adc: ConverterSpec | None = described("Its converter.", default=None)
    uarts: Mapping[str, UartSpec] = described("UARTs by number.", default_factory=dict)
    uart_pins: UartPins = described(
        "chosen: tx and rx are told to machine.UART; fixed: each UART has its own.", default=UartPins.CHOSEN
    )
    i2c: Mapping[str, I2cSpec] = described("I2C buses by number.", default_factory=dict)
    i2c_pins: UartPins = described(
        "chosen: sda and scl are told to machine.I2C; fixed: each bus has its own.", default=UartPins.CHOSEN
    )
    watchdog: BoardWatchdogSpec | None = described("Its watchdog. Without it it has none.", default=None)
    usb: bool = described("True: MicroPython's prompt is on a USB port, which can be a link.")
    wifi: bool = described("True: the board has Wi-Fi.")
    timing: TimingSpec | None = described(
        "How fast it is. Without it, nothing is predicted of the time that the firmware takes.", default=None
    )
    memory: MemorySpec | None = described(
        "How much memory programs have. Without it, nothing is said of whether one finds room.", default=None
    )


@dataclass(frozen=True, slots=True)
class Converter:
    """The converter: the GPIO numbers that it measures, the bits of a count, the volts of full scale.

    ``opened`` is the Python expression that opens an input, with ``{gpio}`` for the number of its pin.
    """

    pins: frozenset[int]
    bits: int
    reference: Fraction
    opened: str


@dataclass(frozen=True, slots=True)
class Uart:
    """The GPIO numbers that can be the output and the input of a UART."""

    tx: frozenset[int]
    rx: frozenset[int]


@dataclass(frozen=True, slots=True)
class I2c:
    """The GPIO numbers that can be the data and the clock of an I2C bus."""

    sda: frozenset[int]
    scl: frozenset[int]


@dataclass(frozen=True, slots=True)
class Timing:
    """The speed of a board: MHz, cycles for an instruction counted on x86-64, us for a conversion of its converter."""

    megahertz: Fraction
    cycles: Fraction
    most_cycles: Fraction
    conversion_us: Fraction


@dataclass(frozen=True, slots=True)
class Memory:
    """The memory of a board in bytes: the heap that programs have, what Wi-Fi takes of it, and the file system.

    ``files`` is None where nobody knows.
    """

    heap: int
    wifi: int
    files: int | None


@dataclass(frozen=True, slots=True)
class BoardModel:
    """A kind of board, resolved: ``taken`` are the GPIO numbers that it needs for itself, with what for.

    ``labels`` are what people find at a pin, by GPIO number.
    """

    name: str
    pins: frozenset[int]
    taken: Mapping[int, str]
    labels: Mapping[int, str]
    adc: Converter | None
    uarts: Mapping[int, Uart]
    i2c: Mapping[int, I2c]
    watchdog: BoardWatchdog | None
    spec: BoardModelSpec
    timing: Timing | None = None
    memory: Memory | None = None

    @property
    def free(self) -> frozenset[int]:
        """The GPIO numbers that a project may use."""
        return self.pins - self.taken.keys()

    @property
    def tells_uart_pins(self) -> bool:
        """Return whether the pins of a UART are arguments when it is opened."""
        return self.spec.uart_pins is UartPins.CHOSEN

    @property
    def tells_i2c_pins(self) -> bool:
        """Return whether the pins of an I2C bus are arguments when it is opened."""
        return self.spec.i2c_pins is UartPins.CHOSEN


def no_such_pin(what: str, gpio: int, choices: frozenset[int], board: BoardModel, key: str) -> tuple[str, str | None]:
    """Return why a GPIO number is none of ``choices`` that the board leaves, and as a hint ``key`` with the nearest."""
    left = choices & board.free
    taken = f": the {board.name} needs it for {board.taken[gpio]}" if gpio in board.taken else ""
    near = min(left, key=lambda pin: (abs(pin - gpio), pin), default=None)
    hint = None if near is None else f"{key}: {near}"
    if not left:
        return f"the {board.name} leaves no GPIO for {what}", "take another of these, or another board"
    return f"{what} is GPIO {shown_pins(left)} on the {board.name}, not {gpio}{taken}", hint


def shown_pins(pins: frozenset[int]) -> str:
    """``26 to 28 and 32``, in the order of the numbers."""
    runs: list[list[int]] = []
    for pin in sorted(pins):
        if runs and runs[-1][-1] == pin - 1:
            runs[-1].append(pin)
        else:
            runs.append([pin])
    words = [word for run in runs for word in ([f"{run[0]} to {run[-1]}"] if len(run) > 2 else map(str, run))]
    return ", ".join(words[:-1]) + " and " + words[-1] if len(words) > 1 else "".join(words)
