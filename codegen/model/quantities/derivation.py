"""The interface of derivations (``codegen/derivations/``): the questions of the stages about the source of a value."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

from codegen.model.answers.step import Step
from codegen.model.quantities.simulated import SimulatedInput

if TYPE_CHECKING:
    from fractions import Fraction

    from codegen.model.answers.known import Known, Stored
    from codegen.model.quantities.conversion import Conversion
    from codegen.model.quantities.source_kind import Output
    from codegen.model.quantities.summed import Lasting, Rest, Sum
    from codegen.model.quantities.trust import Threshold
    from codegen.model.system import System
    from codegen.model.vehicle import Parameter, Quantity, Represented


class DerivationFact(NamedTuple):
    """One attribute of a derivation, as text that differs exactly where the attribute does.

    ``key`` is the key of ``state.yaml`` that decides it. ``is_trust``: it says which values are believed, and not where
    they come from.
    """

    attribute: str
    text: str
    key: str
    is_trust: bool = False


class Derivation(ABC):
    """The source of the value of a quantity. Every kind is a frozen dataclass in a module of its own.

    Quantities are passed to the methods that need one, since a derivation belongs to one and does not know it. What
    most kinds have in common is answered here.
    """

    __slots__ = ()

    # the state

    @property
    def follows(self) -> str | None:
        """The quantity of the component that decides over a boolean each time that it is read; None: it is stored."""
        return None

    @property
    def sources(self) -> tuple[str, ...]:
        """The quantities of the component that it is computed from."""
        return ()

    @property
    def is_set_by_code(self) -> bool:
        """Return whether code of the vehicle sets it, and nothing else does."""
        return False

    @property
    def ages_alone(self) -> bool:
        """Return whether its age counts from when it was set itself, and not from the last reading of its component."""
        return self.is_set_by_code or self.is_received

    @property
    def is_received(self) -> bool:
        """Return whether a message that arrives sets it, and nothing else does."""
        return False

    @property
    def conversion(self) -> "Conversion | None":
        """Return how it comes from the counts of an ADC; None where it does not."""
        return None

    @property
    def prefers(self) -> str | None:
        """The list of the component whose sum comes before what is measured, while all of it is known."""
        return None

    @property
    def extreme_of(self) -> str | None:
        """The list of the component of which it is the lowest value, or the highest."""
        return None

    @property
    def is_of_lowest(self) -> bool:
        """Return whether the quantity is the lowest value of a list."""
        return False

    @property
    def threshold(self) -> "Threshold | None":
        """Return the threshold above which a warning is logged."""
        return None

    @property
    def represented(self) -> "Represented | None":
        """Return where code sets what is measured elsewhere."""
        return None

    @property
    def switch(self) -> "Parameter | None":
        """The parameter that switches the component on and off by it."""
        return None

    @property
    def counts_time(self) -> bool:
        """Return whether the firmware counts it by the ticks of the board."""
        return False

    @property
    def counts(self) -> str | None:
        """The boolean of the component whose end it counts."""
        return None

    @property
    def restarts_with(self) -> str | None:
        """The quantity of the component that counts returns and with each of them sets this one back."""
        return None

    # the firmware

    @property
    def own_limits(self) -> tuple[int, ...]:
        """The limits that it compares with, by instance, in stored units."""
        return ()

    @property
    def is_true_below(self) -> bool:
        """Return whether a boolean is true below those limits, and not from them on."""
        return False

    @property
    def own_floors(self) -> tuple[int, ...]:
        """Return what a value has to reach beside, by instance, in stored units; none where nothing."""
        return ()

    @property
    def back_from(self) -> tuple[int, ...]:
        """Return what a reading has to reach to be a return, by instance, in stored
        units; none where the end is one.
        """
        return ()

    @property
    def set_stale_ms(self) -> int | None:
        """Return how many ms values set by code are believed of quantities that begin anew with it; None: for ever."""
        return None

    @property
    def kept_readings(self) -> int:
        """Return how many readings are kept for it."""
        return 0

    @property
    def curves_by_instance(self) -> tuple[tuple[tuple[int, int], ...], ...]:
        """The points (stored steps of what is measured, value), rising, by which each reading sets it."""
        return ()

    @property
    def sums(self) -> "Sum | None":
        """Return the sum over time that the quantity is; None where it is no sum."""
        return None

    @property
    def remains(self) -> "Rest | None":
        """Return the remainder that the quantity is, a whole less a sum over time; None where it is none."""
        return None

    @property
    def lasts(self) -> "Lasting | None":
        """Return what lasts so long, at what; None where it is no time of that kind."""
        return None

    @property
    def gives(self) -> "tuple[tuple[str, Output, Fraction], ...]":
        """Return by instance the sensor, its output and the stored steps in one step of that; nothing without one."""
        return ()

    @property
    def ages_with(self) -> str | None:
        """Return what a sensor gives to the component and with which it is forgotten; None where there is nothing."""
        return None

    @property
    def comes_of_readings(self) -> bool:
        """Return whether a reading gives it, so that it is unknown once that is not believed any longer."""
        return self.conversion is not None

    def holds(self, limit: str, floor: str) -> str:
        """The condition on ``value``, what is stored of the one that it follows; the limits are expressions."""
        raise NotImplementedError(f"{self} follows nothing")

    def attribute(self, place: str, own: str, own_floor: str) -> str:
        """The view of words that it is: ``place`` is the word that it follows, the others are the instance's limits."""
        raise NotImplementedError(f"{self} follows nothing")

    def names(self, quantity: "Quantity") -> tuple[str, ...]:
        """Names that it takes in the firmware, beside those that every quantity takes."""
        return ()

    def uses(self, quantity: "Quantity") -> Iterator[tuple["Parameter", str]]:
        """The parameters that it reads, each with what it decides, in words."""
        return iter(())

    # expected values

    def value(self, quantity: "Quantity", known: "Known", instance: int) -> "Stored":
        """Return what the quantity is in a state: what is stored, or what it follows from."""
        return known[quantity.path]

    def deciding(self, instance: int, plain: "Stored") -> Mapping[str, "Stored"]:
        """Values for tests of a boolean, or of what it follows, by what comes of them: set, clear, unknown.

        ``plain`` is any value that is known.
        """
        return {"set": 1, "clear": 0}

    @property
    def differs_by_instance(self) -> bool:
        """Return whether the limits that decide over a boolean differ between instances."""
        return False

    # the simulation

    def simulated(
        self, quantity: "Quantity", instance: int, system: "System", parameters: Mapping[str, float]
    ) -> SimulatedInput | None:
        """Return how what is true of an instance of it, from 0, reaches the firmware; None where the firmware makes it
        itself.

        ``parameters`` are those that differ from their defaults.
        """
        return None

    # words

    @abstractmethod
    def facts(self, quantity: "Quantity") -> Iterator[DerivationFact]:
        """Return what two versions of it are compared by: every attribute of it."""

    @abstractmethod
    def words(self, quantity: "Quantity") -> str:
        """Return what gives the quantity its value, in a line for documents and pages."""

    @abstractmethod
    def story(self, quantity: "Quantity", system: "System") -> Iterator[tuple[str, str]]:
        """The same for ``codegen explain``, which has more room: rows with a title."""

    def way(self, quantity: "Quantity", system: "System") -> Iterator[Step]:
        """The steps from the source to the value in the state."""
        yield Step("source", self.words(quantity), (), quantity.criteria())
