"""Resolves the kind of board of a project: its pins as sets of numbers."""

from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.measure import read_amount, read_time
from codegen.model.board_model import (
    MOST_BITS,
    BoardModel,
    BoardModelSpec,
    Converter,
    I2c,
    Memory,
    Timing,
    Uart,
    shown_pins,
)
from codegen.model.board_watchdog import BoardWatchdog, BoardWatchdogSpec
from codegen.model.units.unit import decimal, unit_named
from codegen.pattern import pattern
from codegen.resolve.board.code import faults_in
from codegen.source import Place

MOST_GPIO = 127
"""The last GPIO number that a board may have: eight ports of sixteen pins, the most of MicroPython's boards."""
MOST_PORT = 10
"""The last number of a UART or of a bus. Source: UART 10 of the largest boards of MicroPython's stm32 port."""
MOST_VOLTS = 100

BAD_BOARD = Rule(
    "bad-board",
    f"A description of a board contradicts itself: pins are GPIO numbers such as 0..22, 26..28, up to {MOST_GPIO}; "
    "those of the converter, the UARTs and the I2C buses are among them; a UART and a bus have a number from 0 to "
    f"{MOST_PORT}, a count has 8 to {MOST_BITS} bits, its reference is above 0 V and {MOST_VOLTS} V at most, the "
    "expression that opens an input has {gpio} in it, and its clock runs, with some cycles for each instruction. There "
    "is a heap, of which Wi-Fi takes a part, and a file system that holds something. The "
    "shortest timeout of a watchdog is not above its longest, and causes of a reset are numbers of "
    "machine.reset_cause().",
    remedy="write Python as the board's MicroPython runs it",
)
_RUN = pattern(r"([0-9]{1,9})(?:\.\.([0-9]{1,9}))?")


def resolve_board_model(spec: BoardModelSpec | None, report: Report) -> BoardModel | None:
    """The pins, the converter and the UARTs; None where nothing is known, or after findings."""
    if spec is None:
        return None
    found = Report()
    pins = _pins(spec.pins, spec.at("pins"), found)
    known = None if found.has_errors else pins  # of what is wrong itself nothing else is held to be beyond it
    taken = {number: what for key, what in spec.taken.items() for number in _pins(key, spec.at(f"taken.{key}"), found)}
    labels = {pin: text for key, text in spec.labels.items() for pin in _pins(key, spec.at(f"labels.{key}"), found)}
    uarts = {}
    for key, uart in spec.uarts.items():
        number = _number(key, "uarts", uart.place, found)
        if number is not None:
            uarts[number] = Uart(
                _among(known, _pins(uart.tx, uart.at("tx"), found), uart.at("tx"), found),
                _among(known, _pins(uart.rx, uart.at("rx"), found), uart.at("rx"), found),
            )
    buses = {}
    for key, bus in spec.i2c.items():
        number = _number(key, "i2c", bus.place, found)
        if number is not None:
            buses[number] = I2c(
                _among(known, _pins(bus.sda, bus.at("sda"), found), bus.at("sda"), found),
                _among(known, _pins(bus.scl, bus.at("scl"), found), bus.at("scl"), found),
            )
    adc = _converter(spec, known, found)
    timing = _timing(spec, found)
    memory = _memory(spec, found)
    watchdog = None if spec.watchdog is None else _watchdog(spec.watchdog, found)
    _among(known, frozenset(taken), spec.at("taken"), found)
    _among(known, frozenset(labels), spec.at("labels"), found)
    report.extend(found)
    if found.has_errors:
        return None
    return BoardModel(spec.name, pins, taken, labels, adc, uarts, buses, watchdog, spec, timing, memory)


def _number(key: str, section: str, place: Place, report: Report) -> int | None:
    """The number of a UART or of a bus; None after a finding."""
    what = {"uarts": "UART", "i2c": "I2C bus"}[section]
    hint = f"{section}: has an entry for each, by its number in machine.{'UART' if section == 'uarts' else 'I2C'}()"
    if not key.isdecimal() or not key.isascii() or key != str(int(key[:9])):
        report.add(BAD_BOARD, place, f"{key} is not the number of {'a UART' if what == 'UART' else 'an I2C bus'}", hint)
        return None
    if int(key) > MOST_PORT:
        report.add(BAD_BOARD, place, f"{what} {key} is beyond 0 to {MOST_PORT}", hint)
        return None
    return int(key)


def _converter(spec: BoardModelSpec, pins: frozenset[int] | None, report: Report) -> Converter | None:
    written = spec.adc
    if written is None:
        return None
    reference = read_amount(written.reference, unit_named("V"), written.at("reference"), report)
    if reference is not None and not 0 < reference <= MOST_VOLTS:
        message = f"the reference of {spec.name} is not above 0 V and {MOST_VOLTS} V at most"
        report.add(BAD_BOARD, written.at("reference"), message, "reference: 3.3 V")
    if not 8 <= written.bits <= MOST_BITS:
        message = f"a count has {written.bits} bits, not 8 to {MOST_BITS}"
        hint = f"bits: {MOST_BITS}; what read_u16() gives is shifted to so many" if written.bits > MOST_BITS else None
        report.add(BAD_BOARD, written.at("bits"), message, hint or f"bits: {MOST_BITS}")
    if "{gpio}" not in written.opened:
        hint = "opened: machine.ADC(machine.Pin({gpio}))"
        report.add(BAD_BOARD, written.at("opened"), "{gpio} is missing: every input would be the same", hint)
    for code, fault in faults_in((written.opened,), "{gpio}", is_expression=True):
        report.add(BAD_BOARD, written.at("opened"), f"opened {fault}", code)
    inputs = _among(pins, _pins(written.pins, written.at("pins"), report), written.at("pins"), report)
    return Converter(inputs, written.bits, reference or Fraction(0), written.opened)


def _timing(spec: BoardModelSpec, report: Report) -> Timing | None:
    written = spec.timing
    if written is None:
        return None
    clock = read_amount(written.clock, unit_named("MHz"), written.at("clock"), report)
    conversion = read_amount(written.conversion, unit_named("us"), written.at("conversion"), report)
    if clock is not None and clock <= 0:
        report.add(BAD_BOARD, written.at("clock"), f"the clock of {spec.name} stands still", "clock: 150 MHz")
    if conversion is not None and conversion < 0:
        report.add(BAD_BOARD, written.at("conversion"), "a conversion takes less than no time", "conversion: 4.6 us")
    if written.cycles <= 0:
        report.add(BAD_BOARD, written.at("cycles"), "an instruction takes some cycles", "cycles: 1.34")
    elif written.most_cycles < written.cycles:
        hint = f"most_cycles: is cycles: or more, {decimal(written.cycles)}"
        report.add(BAD_BOARD, written.at("most_cycles"), "at most is less than likely", hint)
    return Timing(clock or Fraction(1), written.cycles, written.most_cycles, conversion or Fraction(0))


def _memory(spec: BoardModelSpec, report: Report) -> Memory | None:
    written = spec.memory
    if written is None:
        return None
    heap = _bytes(written.heap, written.at("heap"), report)
    wifi = _bytes(written.wifi, written.at("wifi"), report)
    files = _bytes(written.files, written.at("files"), report)
    if heap is not None and heap <= 0:
        report.add(BAD_BOARD, written.at("heap"), f"the {spec.name} has no heap", "heap: 185 KiB")
    elif heap is not None and wifi is not None and not 0 <= wifi < heap:
        message = f"Wi-Fi takes {written.wifi} of a heap of {written.heap}"
        report.add(BAD_BOARD, written.at("wifi"), message, "wifi: is what it takes of heap:, or is left out")
    if files is not None and files <= 0:
        report.add(BAD_BOARD, written.at("files"), f"the {spec.name} holds no files", "files: 848 KiB")
    return Memory(heap or 1, wifi or 0, files)


def _bytes(text: str | None, place: Place, report: Report) -> int | None:
    """Return an amount in whole bytes; None where nothing is said, or after a finding."""
    amount = None if text is None else read_amount(text, unit_named("bytes"), place, report)
    return None if amount is None else int(amount)


def _watchdog(spec: BoardWatchdogSpec, report: Report) -> BoardWatchdog:
    """Return the watchdog of a board: its timeouts, and the causes of resets in words."""
    shortest = read_time(spec.shortest, unit_named("ms"), spec.at("shortest"), report)
    longest = None if spec.longest is None else read_time(spec.longest, unit_named("ms"), spec.at("longest"), report)
    if shortest is not None and longest is not None and shortest > longest:
        report.add(
            BAD_BOARD,
            spec.at("shortest"),
            f"the shortest timeout, {spec.shortest}, is above the longest",
            hint="swap them",
        )
    causes = {spec.restart: "a restart"}
    for key, words in spec.causes.items():
        if key.isdecimal() and key.isascii() and len(key) < 4:
            causes[int(key)] = words
        else:
            place = spec.at(f"causes.{key}")
            report.add(BAD_BOARD, place, f"{key} is no number of machine.reset_cause()", "causes: {1: power on}")
    _check_code(spec, report)
    if not spec.hold:
        hint = "hold: [what stops it, or has a timer feed it]"
        report.add(BAD_BOARD, spec.at("hold"), "a prompt would be reset as long as nothing holds the watchdog", hint)
    return BoardWatchdog(shortest or 1, longest, causes, spec)


def _check_code(spec: BoardWatchdogSpec, report: Report) -> None:
    for code, fault in faults_in((spec.caused,), "{period}", is_expression=True):
        report.add(BAD_BOARD, spec.at("caused"), f"caused {fault}", code)
    for code, fault in faults_in(spec.hold, "{period}"):
        report.add(BAD_BOARD, spec.at("hold"), f"hold {fault}", code)


def _pins(text: str, place: Place, report: Report) -> frozenset[int]:
    """The numbers of ``0..22, 26``."""
    numbers: set[int] = set()
    for part in text.split(","):
        match = _RUN.fullmatch(part.strip())
        if match is None:
            report.add(BAD_BOARD, place, f"{part.strip()!r} is no GPIO number", "write 0..22, 26..28")
            continue
        first, last = int(match[1]), int(match[2] or match[1])
        if last > MOST_GPIO:
            report.add(BAD_BOARD, place, f"GPIO {last} is beyond 0 to {MOST_GPIO}", "write 0..22, 26..28")
        elif first > last:
            report.add(BAD_BOARD, place, f"{part.strip()} has no number", f"write {last}..{first}")
        else:
            numbers |= set(range(first, last + 1))
    return frozenset(numbers)


def _among(pins: frozenset[int] | None, found: frozenset[int], place: Place, report: Report) -> frozenset[int]:
    """The numbers that were found; those that are none of ``pins`` are reported, where these are known."""
    beyond = frozenset() if pins is None else found - pins
    if pins is not None and beyond:
        message = f"GPIO {shown_pins(beyond)} {'is' if len(beyond) == 1 else 'are'} none of the pins"
        report.add(BAD_BOARD, place, message, f"pins: has {shown_pins(pins)}")
    return found
