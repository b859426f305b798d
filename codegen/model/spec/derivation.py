"""Derivations as written: the keys of ``state.yaml`` that belong to each kind.

They stand among the keys of the quantity (see ``flattened``); what they resolve to is in ``codegen/derivations/``.
"""

from collections.abc import Mapping
from fractions import Fraction
from typing import ClassVar

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, Verbatim, described
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class DerivationSpec(Written):
    """The source of a value as written: the keys of one derivation, beside those that every quantity has.

    ``KEY`` is the one that names the derivation. ``GIVES_BOOLEAN``: for a boolean, or for a number.
    ``LOOKS_AT_QUANTITY``: what ``KEY`` names may be a quantity of the component.
    """

    KEY: ClassVar[str]
    GIVES_BOOLEAN: ClassVar[bool] = False
    LOOKS_AT_QUANTITY: ClassVar[bool] = True

    @property
    def is_named(self) -> bool:
        """Return whether the derivation's own key is written; its further keys say nothing without that one."""
        return getattr(self, self.KEY) is not None

    @property
    def has_readings(self) -> bool:
        """Return whether readings are taken, which can fail and grow old."""
        return False

    @property
    def has_limit(self) -> bool:
        """Return whether the derivation compares with a limit, which may be stated for one part, such as a cell."""
        return False


@dataclass(frozen=True, slots=True, kw_only=True)
class WhileKnownSpec(DerivationSpec):
    """A boolean that is true while another quantity is known."""

    KEY = "while_known"
    GIVES_BOOLEAN = True

    while_known: str = described("For a boolean: true while this quantity of the same component is known.")


@dataclass(frozen=True, slots=True, kw_only=True)
class EnabledBySpec(DerivationSpec):
    """A boolean that a parameter switches."""

    KEY = "enabled_by"
    GIVES_BOOLEAN = True

    enabled_by: str = described(
        "For a boolean: true while this parameter is not 0. What is measured in the component, and its own messages, "
        "are left out while it is false."
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class FollowsSpec(DerivationSpec):
    """A boolean that follows a limit."""

    KEY = "follows"
    GIVES_BOOLEAN = True

    follows: str | None = described(
        "For a boolean: true while this quantity of the same component is at least, or below, a limit; false while it "
        "is unknown.",
        default=None,
    )
    at_least: Fraction | str | None = described(
        "For follows: the smallest value that makes it true, in its unit, or a fact of the component.",
        default=None,
    )
    below: Fraction | str | None = described(
        "For follows: it is true below this value, in its unit, or below a fact of the component, such as 66 A. With "
        "at_least, too, it is true from that one on and below this one.",
        default=None,
    )

    @property
    def has_limit(self) -> bool:
        """Return whether the limit is compared with a quantity that the boolean follows."""
        return self.follows is not None


@dataclass(frozen=True, slots=True, kw_only=True)
class LowestSpec(DerivationSpec):
    """The lowest value of a list."""

    KEY = "lowest_of"

    lowest_of: str = described(
        "The list of the same component, such as the voltages of cells, whose lowest value this is: with each reading "
        "the lowest of those that are known."
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class HighestSpec(DerivationSpec):
    """The highest value of a list."""

    KEY = "highest_of"

    highest_of: str = described("The same for the highest value of a list.")


@dataclass(frozen=True, slots=True, kw_only=True)
class CountsReturnsSpec(DerivationSpec):
    """A number that counts returns."""

    KEY = "counts_returns_of"

    counts_returns_of: str = described(
        "For a number: it counts up when this boolean of the same component, which follows a measured quantity, was "
        "true and a reading shows that it is no longer."
    )
    back_from: Fraction | None = described(
        "With counts_returns_of a boolean that is true below a limit: only a reading of this value, in the same unit "
        "and times the same per, shows that it is back. Readings in between change nothing.",
        default=None,
    )
    restarting_stale_after: Amount | None = described(
        "With counts_returns_of: for how long code is believed that sets what restarts with it, such as 5 s after it "
        "has set any of that. What is counted of a reading is not forgotten while that is taken.",
        default=None,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class TrendSpec(DerivationSpec):
    """The change of another quantity."""

    KEY = "trend_of"

    trend_of: str | None = described(
        "The quantity of the same component whose change per second this is.", default=None
    )
    window: Amount | None = described("For a trend: the time that it looks back, such as 4 s.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class EstimateSpec(DerivationSpec):
    """An estimate from a measured quantity."""

    KEY = "estimate_from"

    estimate_from: str = described(
        "The measured quantity of the same component from which this one is estimated: a charge from a voltage, a "
        "content from a level. Without it the quantity is unknown until something sets it."
    )
    curve: str | None = described("For estimate_from: the curve of board.yaml by which it is estimated.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredSpec(DerivationSpec):
    """A measurement by an ADC."""

    KEY = "adc"

    adc: str | None = described("ADC channel of the board that measures it.", default=None)
    multiplier: Verbatim | None = described(
        "What the voltage at the ADC pin is multiplied with: a parameter, or an amount such as 17 A/V.", default=None
    )
    offset: str | None = described(
        "What is taken from the voltage at the ADC pin before that: a parameter in V, or an amount such as 0.5 V.",
        default=None,
    )
    prefers: str | None = described(
        "A list of the same component, such as the voltages of cells: while all of its values are known their sum is "
        "the value, whatever the ADC reads, and whether it can be read.",
        default=None,
    )
    set_at: Mapping[str, Fraction] = described(
        "A parameter and the value at which the quantity is not measured, but set by code, for what another system "
        "measures, such as BATT_MONITOR: 29. The parameter is used after a restart.",
        default_factory=dict,
    )
    set_stale_after: Amount | None = described(
        "With set_at: for how long a value is believed after code has set it, such as 5 s. Then it is unknown, and "
        "with it what restarts when something else is put in its place.",
        default=None,
    )
    warn_above: Fraction | None = described("Log a warning above this value, in unit.", default=None)
    warn_every: Amount | None = described("Shortest time between two such warnings, such as 10 s.", default=None)

    @property
    def has_readings(self) -> bool:
        """Return whether a key of the ADC is written, so that readings are taken."""
        return self.adc is not None or self.multiplier is not None or self.offset is not None

    @property
    def has_limit(self) -> bool:
        """Return whether a limit is stated above which a warning is logged."""
        return self.warn_above is not None


@dataclass(frozen=True, slots=True, kw_only=True)
class IntegralSpec(DerivationSpec):
    """A sum over time."""

    KEY = "integral_of"

    integral_of: str | None = described(
        "The measured quantity of the same component of which this is the sum over time, such as a current.",
        default=None,
    )
    times: str | None = described(
        "For an integral: another measured quantity that it is multiplied with, such as the voltage for an energy.",
        default=None,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class LeftSpec(DerivationSpec):
    """The rest of a full store after a sum."""

    KEY = "left_of"
    LOOKS_AT_QUANTITY = False

    left_of: str | None = described(
        "The parameter with the size of a full store of which this is left, in its unit or in %.", default=None
    )
    after: str | None = described(
        "For left_of: the integral of the same component that is taken from it.", default=None
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class LastsSpec(DerivationSpec):
    """The time that a rest lasts."""

    KEY = "lasts"

    lasts: str | None = described(
        "The quantity of the same component, left of something, of which this is the time until nothing is left.",
        default=None,
    )
    drawn: str | None = described("For lasts: the measured quantity that is taken from it.", key="at", default=None)
    over: Amount | None = described("For lasts: the time over which that is smoothed, such as 10 s.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class SourcedSpec(DerivationSpec):
    """An output of a sensor."""

    KEY = "source"
    LOOKS_AT_QUANTITY = False

    source: str | tuple[str, ...] = described(
        "The sensor of board.yaml that gives it: its name, or NAME.OUTPUT where it gives several numbers; for a "
        "component with several instances a list, with one for each."
    )

    @property
    def has_readings(self) -> bool:
        """A sensor is asked, which can fail."""
        return True


WrittenDerivation = (
    WhileKnownSpec
    | EnabledBySpec
    | FollowsSpec
    | LowestSpec
    | HighestSpec
    | CountsReturnsSpec
    | TrendSpec
    | EstimateSpec
    | MeasuredSpec
    | IntegralSpec
    | LeftSpec
    | LastsSpec
    | SourcedSpec
)
"""Every derivation that can be written; a quantity with none of them is set by code."""
