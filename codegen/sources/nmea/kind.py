"""A receiver of satellites that speaks NMEA 0183 on a UART: GGA, RMC, GSA and VTG."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from codegen.diagnostics import Rule, Severity
from codegen.frozen import dataclass
from codegen.measure import read_rate, read_time
from codegen.model.quantities.device import Device
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.quantities.source_kind import Output, PinUse, Polling, Source, SourceFact
from codegen.model.spec.described import Amount, described
from codegen.model.spec.source import SourceSpec
from codegen.model.units.unit import NUMBER, unit_named
from codegen.sources.kind import Around, KindOfSource
from codegen.sources.nmea.shown import shown
from codegen.sources.wires import Serial, serial

_HUNDREDTHS = replace(NUMBER, name="steps of 1E-2", scale=Fraction(1, 100))
_DEGREES = unit_named("degE7")
OUTPUTS = (
    Output("fix", NUMBER, 0, 6, "Kind of fix, as GPS_FIX_TYPE."),
    Output("satellites", NUMBER, 0, 99, "Satellites in use."),
    Output("latitude", _DEGREES, -900000000, 900000000, "To the north."),
    Output("longitude", _DEGREES, -1800000000, 1800000000, "To the east."),
    Output("altitude", unit_named("mm"), -1000000, 90000000, "Above mean sea level."),
    Output("speed", unit_named("cm/s"), 0, 60000, "Over ground."),
    Output("course", unit_named("cdeg"), 0, 35999, "Over ground, from true north."),
    Output("hdop", _HUNDREDTHS, 0, 9998, "Dilution of precision in the plane."),
    Output("vdop", _HUNDREDTHS, 0, 9998, "Dilution of precision in height."),
)
"""Its outputs, in the order of the driver's values."""

CROWDED_RECEIVER = Rule(
    "crowded-receiver",
    "The line of a receiver of satellites is too slow for the sentences that receivers send of each fix, 280 bytes of "
    "GGA, RMC, GSA and VTG: some come late, cut or not at all. Take a faster line, or fewer fixes; a receiver that is "
    "set up to send fewer sentences is right.",
    Severity.WARNING,
)

SAID = {
    "fail": "the receiver says nothing",
    "absent": "the UART is absent",
    "garbled": "lines arrive garbled",
    "stuck": "the receiver says what it said",
}
"""Its faults in a simulation."""

_BUFFER = 512
_MOST_BUFFER = 65536
_PIECE = 128  # bytes that a turn takes, as the driver has it, where no more come
_OFF = 20  # a fix is late by at most this part of the time between two: clocks differ, and lines take their time
_SENTENCE, _SENTENCES = (
    70,
    280,
)  # bytes: the shortest that has a place, RMC, and all four that a receiver sends of a fix
_BAUDS = (4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600)
_MODULES = ("nmea", "nmea_plain", "nmea_viper", "sentences_plain", "sentences_viper")


@dataclass(frozen=True, slots=True, kw_only=True)
class NmeaSpec(SourceSpec):
    """A receiver of satellites on a UART."""

    uart: int = described("Number of the UART.")
    tx: int = described("GPIO number of the UART's output.")
    rx: int = described("GPIO number of the UART's input.")
    baud: int = described("Bits per second.", default=9600)
    buffer: int | None = described(
        "Bytes that wait between two turns. Default: 512, or what comes in the time of two turns.", default=None
    )
    fixes: Amount = described("How often the receiver gives a fix, such as 5 Hz.", default=Amount("1 Hz"))
    silence: Amount | None = described("Time without a line after which it has failed. Default: 3 s.", default=None)


@dataclass(frozen=True, slots=True)
class NmeaReceiver(Source):
    """A receiver on a UART, which gives a fix every ``fix_us`` and has failed after ``silent_ms`` without a line."""

    polling: Polling
    line: Serial
    fix_us: int
    silent_ms: int

    @property
    def outputs(self) -> tuple[Output, ...]:
        return OUTPUTS

    @property
    def module(self) -> str:
        return "nmea"

    @property
    def modules(self) -> tuple[str, ...]:
        return tuple(f"nmea/firmware/{name}.py" for name in _MODULES)

    @property
    def clock_modules(self) -> tuple[str, ...]:
        return ("nmea/firmware/satellite_clock.py",)

    @property
    def opened(self) -> str:
        piece = brought(self.line.baud, self.polling) * 5 // 4  # a turn may be late
        return f"Nmea(lambda: {self.line.opened}{f', {piece}' if piece > _PIECE else ''})"

    @property
    def cause(self) -> str:
        return f"UART {self.line.number} does not work"

    @property
    def sets_clock(self) -> bool:
        return True

    @property
    def tells_new(self) -> bool:
        return True

    @property
    def renewed_us(self) -> int:
        return self.fix_us + self.fix_us // _OFF + self.polling.period_us

    @property
    def renewed_key(self) -> str:
        return "fixes"

    @property
    def silence_ms(self) -> int | None:
        return self.silent_ms

    def pins(self) -> Iterator[PinUse]:
        return self.line.pins()

    @property
    def port(self) -> str:
        return self.line.port

    @property
    def mocks(self) -> tuple[str, ...]:
        return ("nmea/mocks/sim_nmea.py",)

    @property
    def tests(self) -> tuple[str, ...]:
        return ("nmea/tests/nmea_driver.py", "nmea/tests/nmea_lines.py", "nmea/tests/nmea_device.py")

    def device(self, number: int) -> Device:
        return Device("nmea_device", {"uart": self.line.number}, tuple(shown(number)))

    def simulated(self, output: Output, steps: Fraction) -> SimulatedInput:
        settings = {"uart": self.line.number, "output": output.name, "steps": float(steps)}
        return SimulatedInput("nmea", settings, SAID)

    def facts(self) -> Iterator[SourceFact]:
        yield SourceFact("UART", self.line.opened, "uart")
        yield SourceFact("a fix", f"every {self.fix_us} us", "fixes", asks=False)
        yield SourceFact("silent after", f"{self.silent_ms} ms", "silence", is_trust=True)

    def words(self) -> str:
        return f"NMEA 0183 on UART {self.line.number}, {self.line.baud} bits per second"


def brought(baud: int, polling: Polling) -> int:
    """Return how many bytes a line of so many bits per second brings from one turn to the next at most."""
    return -(-baud * polling.period_us // 10000000)


def _check_line(spec: NmeaSpec, rate: Fraction, around: Around) -> None:
    """Report fixes of which the line cannot bring one sentence each, and those of which it cannot bring all."""
    sentence, every = _SENTENCE * 10 * rate, _SENTENCES * 10 * rate
    if spec.baud >= every:
        return
    wanted = next((baud for baud in _BAUDS if baud >= every), _BAUDS[-1])
    fewer = float(Fraction(spec.baud, 10 * _SENTENCES))
    hint = f"baud: {wanted}, as the receiver has to be set up, or fixes: {fewer:.2g} Hz"
    if spec.baud < sentence:
        needs = f"{_SENTENCE} bytes of one sentence each need {float(sentence):.7g} bits per second"
        around.bad("fixes", f"{spec.fixes} do not come over a line of {spec.baud} bits per second: {needs}", hint)
        return
    needs = f"GGA, RMC, GSA and VTG, {_SENTENCES} bytes, need {float(every):.7g}"
    message = f"{spec.fixes} over a line of {spec.baud} bits per second leave out sentences: {needs}"
    around.report.add(CROWDED_RECEIVER, spec.at("fixes"), message, hint)


def resolve_nmea(spec: NmeaSpec, polling: Polling, around: Around) -> NmeaReceiver | None:
    """The UART; None after a finding."""
    comes = brought(spec.baud, polling)
    size = max(_BUFFER, 2 * comes) if spec.buffer is None else spec.buffer
    if comes > _MOST_BUFFER // 2 or size < comes:
        message = f"{comes} bytes come between two turns at {spec.baud} bits per second, and {size} have room"
        key, more = ("rate", NMEA.rate) if comes > _MOST_BUFFER // 2 else ("buffer", f"{2 * comes}, or a higher rate")
        around.bad(key, message, hint=f"{key}: {more}")
        return None
    line = serial(spec, spec.baud, size, around)
    rate = read_rate(spec.fixes, spec.at("fixes"), around.report)
    silent = 3000
    if spec.silence is not None:
        silent = read_time(spec.silence, unit_named("ms"), spec.at("silence"), around.report) or 0
        around.failed = around.failed or not silent
    if line is None or rate is None:
        return None
    fix_us = round(1000000 / rate)
    _check_line(spec, rate, around)
    if silent * 1000 <= fix_us:
        message = f"it counts as failed after {silent} ms, before a fix comes every {fix_us // 1000} ms"
        around.bad("silence", message, hint=f"silence: {3 * fix_us // 1000} ms")
    return NmeaReceiver(polling, line, fix_us, silent)


NMEA = KindOfSource("nmea", NmeaSpec, resolve_nmea, "20 Hz")
