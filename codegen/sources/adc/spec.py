"""An input of the board's converter, as written among the sensors of ``board.yaml``."""

from collections.abc import Mapping
from fractions import Fraction
from typing import ClassVar

from codegen.frozen import dataclass
from codegen.model.spec.board import AdcSpec
from codegen.model.spec.described import Amount, Verbatim, described
from codegen.model.spec.source import SourceSpec


@dataclass(frozen=True, slots=True, kw_only=True)
class AdcSourceSpec(SourceSpec):
    """An input of the board's converter: one number, of any dimension, for each instance of a component."""

    ASPECTS: ClassVar[tuple[str, ...]] = tuple("limit" if each == "read_limit" else each for each in AdcSpec.ASPECTS)
    ONE_OF: ClassVar[tuple[str, ...]] = AdcSpec.ONE_OF

    gpio: int | None = described("GPIO number of the pin.", default=None)
    pin: str | None = described(
        "Parameter that has the GPIO number of the pin; its default is used first.", default=None
    )
    multiplier: Verbatim | None = described(
        "What the voltage at the pin is multiplied with: a parameter, or an amount such as 17 A/V. It may stand at the "
        "quantity instead.",
        default=None,
    )
    offset: str | None = described(
        "What is taken from the voltage at the pin before that: a parameter in V, or an amount such as 0.5 V.",
        default=None,
    )
    when: Mapping[str, Fraction] = described(
        "A parameter and the value at which it is read, such as BATT_MONITOR: 4; without it, it always is. "
        "The parameter is used after a restart.",
        default_factory=dict,
    )
    bits: int | None = described("Resolution of one count. Default: that of the board.", default=None)
    reference: Amount | None = described(
        "Voltage of full scale, such as 3.3 V. Default: that of the board.", default=None
    )
    samples: int = described("Readings whose mean is one reading.", default=1)
