"""The page and the drawing of what is connected to the board: each pin in use, with the parts between."""

from collections.abc import Iterable, Sequence
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.connections import Connection, connections
from codegen.model.quantities.conversion import factors_by_instance
from codegen.model.quantities.divider import Divider, divider, ohms
from codegen.model.quantities.full_scale import largest, most_in_use
from codegen.model.system import System
from codegen.model.units.unit import decimal, ratio, unit_named
from codegen.targets.origin import Origin
from codegen.targets.pages.navigation import WIRING_PAGE, Navigation, navigation

_TOP = 36
_PLAIN_HEIGHT, _DIVIDER_HEIGHT = 58, 132
_LETTER = 6.9
"""Widths and heights of the drawing, and of a letter in it, in its own units."""
_PART_X = 420
_OTHER_END = {"tx": "RX", "rx": "TX"}


@dataclass(frozen=True, slots=True)
class WireView:
    """A pin with what is connected to it, ``y`` from the top; ``upper`` and ``lower`` are the resistors of a divider.

    ``label`` is what the board calls the pin, ``limits`` what may be connected, ``notes`` which parameter or key
    decides the pin, and by which it is off by default; such a wire ``rests``.
    """

    y: int
    gpio: int
    label: str
    title: str
    limits: str
    notes: str
    rests: bool
    criterion: str
    upper: str = ""
    lower: str = ""
    ratio: str = ""

    @property
    def end(self) -> int:
        """Return where the next one begins."""
        return self.y + (_DIVIDER_HEIGHT if self.upper else _PLAIN_HEIGHT)

    @property
    def divider(self) -> str:
        """``15 kΩ over 5.1 kΩ``; empty where nothing is divided."""
        return f"{self.upper} over {self.lower}" if self.upper else ""


@dataclass(frozen=True, slots=True)
class WiringView:
    """The drawing: ``width`` and ``height`` of it; ``reference`` are the volts of the converter, empty without one."""

    project: str
    board: str
    origin: Origin
    navigation: Navigation
    width: int
    height: int
    reference: str
    wires: tuple[WireView, ...]
    alternatives: bool
    divided: bool
    has_bus: bool
    summary: str


def wiring_view(system: System, origin: Origin) -> WiringView:
    """The view of both, of a system that is wired."""
    assert system.board is not None
    found = sorted(connections(system), key=lambda each: (each.gpio, each.rests))
    wires = tuple(_wires(found, system))
    texts = [text for wire in wires for text in (wire.title, wire.limits, wire.notes)]
    gpios = [wire.gpio for wire in wires]
    adc = system.board.adc
    return WiringView(
        project=system.spec.project.project,
        board=system.board.name,
        origin=origin,
        navigation=navigation(system, WIRING_PAGE),
        width=round(_PART_X + 40 + _LETTER * max(map(len, texts))),
        height=wires[-1].end + 12,
        reference="" if adc is None else decimal(adc.reference),
        wires=wires,
        alternatives=len(set(gpios)) < len(gpios),
        divided=any(wire.upper for wire in wires),
        has_bus=any(each.bus for each in found),
        summary="; ".join(f"GPIO {wire.gpio}: {wire.title}" for wire in wires),
    )


def _wires(found: Sequence[Connection], system: System) -> Iterable[WireView]:
    y = _TOP
    for each in found:
        wire = _wire(each, system, y)
        yield wire
        y = wire.end


def _wire(each: Connection, system: System, y: int) -> WireView:
    assert system.board is not None
    reading = each.reading
    parts = _divider(each, system)
    return WireView(
        y=y,
        gpio=each.gpio,
        label=system.board.labels.get(each.gpio, ""),
        title=_title(each),
        limits=_limits(each, system),
        notes=", ".join(
            text for text in (_decided_by(each), f"off by the default of {each.switch}" if each.rests else "") if text
        ),
        rests=each.rests,
        criterion="" if reading is None else reading.conversion.channel.cited("pin"),
        upper="" if parts is None else ohms(parts.upper),
        lower="" if parts is None else ohms(parts.lower),
        ratio="" if parts is None else f"{float(parts.ratio):.2f}",
    )


def _decided_by(each: Connection) -> str:
    """The parameter, or the key of board.yaml, that says the pin."""
    return each.parameter if each.reading is not None else f"{each.parameter} of board.yaml"


def _title(each: Connection) -> str:
    """``level of tank 1``, ``RX of radio``, ``SDA of I2C 0``: what is at the other end of the wire."""
    reading = each.reading
    if reading is not None:
        several = reading.component.instances > 1
        return f"{reading.quantity.name} of {reading.component.name}{f' {each.instance + 1}' if several else ''}"
    if each.bus:
        return each.bus
    end = _OTHER_END.get(each.parameter)
    return f"{end} of {each.device}" if end else each.device


def _limits(each: Connection, system: System) -> str:
    """Return what it reaches in use, and what the converter shows of it by the
    default of its multiplier; who shares a bus.
    """
    reading = each.reading
    if reading is None:
        return ", ".join(_sharing(each.bus, system)) if each.bus else ""
    conversion, quantity = reading.conversion, reading.quantity
    if conversion.offset is not None:
        return f"its output, up to {decimal(conversion.channel.reference)} V"
    unit = f" {quantity.unit.name}".rstrip()
    shown = f"shown up to {float(_shown(each, system)):.4g}{unit}"
    most = most_in_use(quantity, reading.component.parts[each.instance])
    return shown if most is None else f"up to {decimal(most)}{unit}, {shown}"


def _sharing(bus: str, system: System) -> list[str]:
    """The sensors that are connected to a line of a bus."""
    return [name for name, source in system.sources.items() if any(pin.shared == bus for pin in source.pins())]


def _shown(each: Connection, system: System) -> Fraction:
    """Return what the converter shows at full scale, in the unit of the quantity."""
    assert each.reading is not None
    conversion, component = each.reading.conversion, each.reading.component
    multipliers = factors_by_instance(conversion.multiplier, system.parameters, component.instances)
    return largest(conversion, multipliers[each.instance], each.reading.quantity)


def _divider(each: Connection, system: System) -> Divider | None:
    """The resistors before an input that measures volts; None where it measures anything else, or all of them."""
    reading = each.reading
    if reading is None or reading.conversion.offset is not None:
        return None
    volts = ratio(reading.quantity.unit, unit_named("V"))
    return None if volts is None else divider(_shown(each, system) * volts / reading.conversion.channel.reference)
