"""Pulses at a digital input, such as those of a flow meter, of a wheel or of a remote control."""

from collections.abc import Iterator
from enum import StrEnum
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.measure import read_time
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.quantities.device import Device, Exact, Shown
from codegen.model.quantities.source_kind import Output, PinUse, Polling, Source, SourceFact
from codegen.model.spec.described import Amount, described
from codegen.model.spec.source import SourceSpec
from codegen.model.units.unit import NUMBER, unit_named
from codegen.sources.kind import Around, KindOfSource

OUTPUTS = (
    Output("count", NUMBER, 0, SMALL_INT_MAX, "Pulses since the start."),
    Output("frequency", unit_named("mHz"), 0, 100000000, "How often they come."),
    Output("width", unit_named("us"), 1, 1000000, "How long the last one was."),
)


class Pull(StrEnum):
    """The resistor at an input."""

    UP = "up"
    DOWN = "down"
    NONE = "none"


@dataclass(frozen=True, slots=True, kw_only=True)
class PulseSpec(SourceSpec):
    """Pulses at a digital input."""

    gpio: int = described("GPIO number of the pin.")
    pull: Pull = described("The board's own resistor at the pin.", default=Pull.NONE)
    gate: Amount | None = described(
        "Time without a pulse after which the frequency is 0. At most 60 s; default: 2 s.", default=None
    )


@dataclass(frozen=True, slots=True)
class PulseInput(Source):
    """A pulse input at a pin of the board, one of ``choices``."""

    polling: Polling
    gpio: int
    pull: Pull
    gate_ms: int
    choices: frozenset[int]

    @property
    def outputs(self) -> tuple[Output, ...]:
        return OUTPUTS

    @property
    def module(self) -> str:
        return "pulse"

    @property
    def modules(self) -> tuple[str, ...]:
        return ("pulse/firmware/pulse.py",)

    @property
    def mocks(self) -> tuple[str, ...]:
        return ("pulse/mocks/mock_pulse.py",)

    @property
    def tests(self) -> tuple[str, ...]:
        return ("pulse/tests/pulse_device.py",)

    def device(self, number: int) -> Device:
        return Device("pulse_device", {"gpio": self.gpio}, tuple(_shown(number)))

    @property
    def opened(self) -> str:
        pull = "" if self.pull is Pull.NONE else f", machine.Pin.PULL_{self.pull.upper()}"
        return f"Pulse(lambda: machine.Pin({self.gpio}, machine.Pin.IN{pull}), {self.gate_ms})"

    @property
    def cause(self) -> str:
        return f"GPIO {self.gpio} does not work"

    def pins(self) -> Iterator[PinUse]:
        yield PinUse(self.gpio, "gpio", self.choices)

    def facts(self) -> Iterator[SourceFact]:
        yield SourceFact("pin", f"GPIO {self.gpio}, pull {self.pull}", "gpio")
        yield SourceFact("gate", f"{self.gate_ms} ms", "gate", asks=False)

    def words(self) -> str:
        return f"pulses at GPIO {self.gpio}"


_PERIODS_US = (4000, 3125, 2500, 2000, 1600, 1250, 1000, 800)
"""Times from one pulse to the next, each of which makes whole millihertz."""


def _shown(number: int) -> Iterator[Shown]:
    """Pulses in two bursts, between which it is asked: the frequency is that of the second one alone."""
    count = 0
    for scene in range(2):
        period = _PERIODS_US[(number + 3 * scene) % len(_PERIODS_US)]
        high, bursts = period * (number % 3 + 1) // 5, (3 + number % 5 + scene, 7 + number % 11)
        count += sum(bursts)
        yield Shown(
            {"high_us": high, "low_us": period - high, "bursts": list(bursts)},
            {
                "count": Exact(Fraction(count), NUMBER),
                "frequency": Exact(Fraction(1000000, period), unit_named("Hz")),
                "width": Exact(Fraction(high, 1000000), unit_named("s")),
            },
        )


def resolve_pulse(spec: PulseSpec, polling: Polling, around: Around) -> PulseInput | None:
    """The pin; None after a finding."""
    board = around.known_board("its pin")
    gate = 2000
    if spec.gate is not None:
        gate = read_time(spec.gate, unit_named("ms"), spec.at("gate"), around.report) or 0
        around.failed = around.failed or not gate
        around.within("gate", gate, 1, 60000)
    if board is None:
        return None
    around.pin("gpio", spec.gpio, board.free, "a pin", board)
    return PulseInput(polling, spec.gpio, spec.pull, gate, board.free)


PULSE = KindOfSource("pulse", PulseSpec, resolve_pulse, "10 Hz")
