"""What is known about the board of a project: its pins as sets of numbers."""

import re
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.measure import read_amount
from codegen.model.board_model import MOST_BITS, BoardModel, BoardModelSpec, Converter, I2c, Uart
from codegen.model.unit import unit_named
from codegen.source import Place

BAD_BOARD = Rule(
    "bad-board",
    "A description of a board contradicts itself: pins are GPIO numbers such as 0..22, 26..28, those of the converter "
    f"of the UARTs and of the I2C buses are among them, a count has 8 to {MOST_BITS} bits, its reference is above 0 V, "
    "and the expression that opens an input has {gpio} in it.",
)
_RUN = re.compile(r"(\d{1,3})(?:\.\.(\d{1,3}))?")


def resolve_board_model(spec: BoardModelSpec | None, report: Report) -> BoardModel | None:
    """The pins, the converter and the UARTs; None where nothing is known, or after findings."""
    if spec is None:
        return None
    found = Report()
    pins = _pins(spec.pins, spec.at("pins"), found)
    taken = {number: what for key, what in spec.taken.items() for number in _pins(key, spec.at(f"taken.{key}"), found)}
    uarts = {}
    for key, uart in spec.uarts.items():
        if not key.isdecimal():
            found.add(BAD_BOARD, uart.place, f"{key} is not the number of a UART")
            continue
        uarts[int(key)] = Uart(
            _among(pins, _pins(uart.tx, uart.at("tx"), found), uart.at("tx"), found),
            _among(pins, _pins(uart.rx, uart.at("rx"), found), uart.at("rx"), found),
        )
    buses = {}
    for key, bus in spec.i2c.items():
        if not key.isdecimal():
            found.add(BAD_BOARD, bus.place, f"{key} is not the number of an I2C bus")
            continue
        buses[int(key)] = I2c(
            _among(pins, _pins(bus.sda, bus.at("sda"), found), bus.at("sda"), found),
            _among(pins, _pins(bus.scl, bus.at("scl"), found), bus.at("scl"), found),
        )
    adc = _converter(spec, pins, found)
    _among(pins, frozenset(taken), spec.at("taken"), found)
    report.extend(found)
    return None if found.has_errors else BoardModel(spec.name, pins, taken, adc, uarts, buses, spec)


def _converter(spec: BoardModelSpec, pins: frozenset[int], report: Report) -> Converter | None:
    written = spec.adc
    if written is None:
        return None
    reference = read_amount(written.reference, unit_named("V"), written.at("reference"), report) or Fraction(0)
    if reference <= 0:
        report.add(BAD_BOARD, written.at("reference"), f"the reference of {spec.name} is not above 0 V")
    if not 8 <= written.bits <= MOST_BITS:
        report.add(BAD_BOARD, written.at("bits"), f"a count has {written.bits} bits, not 8 to {MOST_BITS}")
    if "{gpio}" not in written.opened:
        report.add(BAD_BOARD, written.at("opened"), "{gpio} is missing: every input would be the same")
    inputs = _among(pins, _pins(written.pins, written.at("pins"), report), written.at("pins"), report)
    return Converter(inputs, written.bits, reference, written.opened)


def _pins(text: str, place: Place, report: Report) -> frozenset[int]:
    """The numbers of ``0..22, 26``."""
    numbers: set[int] = set()
    for part in text.split(","):
        match = _RUN.fullmatch(part.strip())
        if match is None:
            report.add(BAD_BOARD, place, f"{part.strip()!r} is no GPIO number", "write 0..22, 26..28")
            continue
        numbers |= set(range(int(match[1]), int(match[2] or match[1]) + 1))
    return frozenset(numbers)


def _among(pins: frozenset[int], found: frozenset[int], place: Place, report: Report) -> frozenset[int]:
    for number in sorted(found - pins):
        report.add(BAD_BOARD, place, f"GPIO {number} is none of the pins")
    return found
