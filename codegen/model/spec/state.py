"""``state.yaml``: the state of the vehicle, its components and their quantities, as written."""

from collections.abc import Mapping
from fractions import Fraction
from typing import TypeVar

from codegen.frozen import dataclass
from codegen.model.spec.derivation import DerivationSpec, WrittenDerivation
from codegen.model.spec.described import Amount, described, flattened
from codegen.source import Written

_Kind = TypeVar("_Kind", bound=DerivationSpec)


@dataclass(frozen=True, slots=True, kw_only=True)
class QuantitySpec(Written):
    """One quantity of the vehicle state, kept by the firmware as an integer of ``stored`` units."""

    doc: str = described("What the quantity is, for people.")
    overlay: str | None = described(
        "Overlay for which the quantity is there, as codegen.yaml names it; without that overlay there is none of it.",
        default=None,
    )
    called: str | None = described(
        "What texts say of it when the vehicle is not armed, as in: below minimum arming capacity. Default: its name.",
        default=None,
    )
    unit: str | None = described("Unit that people and documents use (V, A, %); absent for pure numbers.", default=None)
    stored: str | None = described("Unit of one integer step in the firmware (mV, cA). Default: unit.", default=None)
    enum: str | None = described("Enum of the dialect whose values the quantity takes.", default=None)
    text: int | None = described(
        "The quantity is a text, of which so many bytes are kept, 1 to 255, in UTF-8 and cut at a character.",
        default=None,
    )
    boolean: bool = described("True for a yes/no quantity; it can only decide flags.", default=False)
    min: Fraction | None = described("Smallest value, in unit.", default=None)
    max: Fraction | None = described("Largest value, in unit.", default=None)
    initial: str | bool | Fraction | None = described(
        "Value until it is set, and in messages whenever it is set to unknown: a number, an enum entry, a boolean or a "
        "text. Without it the quantity starts unknown.",
        default=None,
    )
    elements: str | Fraction | None = described(
        "A list, in which single values can be unknown: so many values, or one for each of what this fact of the "
        "component counts, such as cells.",
        default=None,
    )
    derivations: tuple[WrittenDerivation, ...] = flattened()
    reaches: str | None = described(
        "What it reaches in use: an amount, such as 25.2 V, or a fact of the component. An ADC that shows less at full "
        "scale is warned about.",
        default=None,
    )
    per: str | None = described(
        "A fact of the component that counts something, such as cells: the limit, warn_above or what reaches names is "
        "for one of them, and the number of each instance multiplies it. A warn_above is rounded to the unit that the "
        "quantity is stored in.",
        default=None,
    )
    restarts_with: str | None = described(
        "The quantity of the same component that counts returns: with each of them this one begins anew. A sum is 0 "
        "again if it was known, what has an initial value has that; anything else is unknown as soon as it is gone.",
        default=None,
    )
    invalid_after: int | None = described("Failed readings in a row after which it is unknown.", default=None)
    stale_after: Amount | None = described(
        "Age after which the last reading, or what code or a message has set, is unknown, such as 1 s.", default=None
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: multiplier, rounding, warn_above, invalid_after, stale_after, "
        "set_stale_after, restarting_stale_after, calibration, gaps, estimate, slope, returns.",
        default_factory=dict,
    )

    ASPECTS = (
        "multiplier",
        "rounding",
        "warn_above",
        "invalid_after",
        "stale_after",
        "set_stale_after",
        "restarting_stale_after",
        "calibration",
        "gaps",
        "estimate",
        "slope",
        "returns",
    )

    def written(self, kind: type[_Kind]) -> _Kind | None:
        """Return what is written of one kind of derivation; None where nothing is."""
        return next((each for each in self.derivations if isinstance(each, kind)), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class ComponentSpec(Written):
    """A part of the vehicle state with its quantities; board.yaml says which instances of it exist."""

    doc: str = described("What the component is, for people.")
    first_number: str | None = described(
        "Parameter with the number that messages give its first instance; without one that is 0.", default=None
    )
    update_rate: Amount | None = described("How often its readings are taken, such as 10 Hz.", default=None)
    quantities: Mapping[str, QuantitySpec] = described("The quantities by name.")
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: robustness, steady, scenarios, mock, rate, order, allocation, reported, off, "
        "several, own_parameters, own_readings, own_messages, own_failsafe.",
        default_factory=dict,
    )

    ASPECTS = (
        "robustness",
        "steady",
        "scenarios",
        "mock",
        "rate",
        "order",
        "allocation",
        "reported",
        "off",
        "several",
        "own_parameters",
        "own_readings",
        "own_messages",
        "own_failsafe",
    )

    def is_written(self, quantity: str) -> bool:
        """Return whether a quantity of that name is written, be it in a way that could not be read."""
        return f"quantities.{quantity}" in self.places


@dataclass(frozen=True, slots=True, kw_only=True)
class StateSpec(Written):
    """``state.yaml``: the vehicle state."""

    components: Mapping[str, ComponentSpec] = described("The components by name.")

    def has_written(self, component: str) -> bool:
        """Return whether a component of that name is written, be it in a way that could not be read."""
        return f"components.{component}" in self.places

    def is_written(self, component: str, quantity: str) -> bool:
        """Return the same for ``component.quantity``."""
        read = self.components.get(component)
        return self.has_written(component) if read is None else read.is_written(quantity)
