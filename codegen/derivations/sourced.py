"""The derivation from a sensor: its output in the steps of the quantity, by an exact factor."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.measure import UNCARRIED_CONVERSION, UNIT_MISMATCH, obstacle
from codegen.model.answers.step import Step
from codegen.model.code.storage import Storage
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.quantities.source_kind import Output, Source
from codegen.model.spec.derivation import SourcedSpec
from codegen.model.units.unit import decimal, ratio
from codegen.model.vehicle import Quantity, QuantityKind

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_SOURCED = Rule(
    "bad-sourced",
    "A sensor gives single numbers: a quantity with source is a number or an enum, without elements, one for each "
    "instance of its component. A number that needs more than a small integer is kept as it comes, in its own steps; "
    "others are scaled by whole numbers of at most 30 bits.",
)
_LARGEST = 2**29


@dataclass(frozen=True, slots=True)
class Given:
    """The output of one sensor for one instance: ``factor`` stored steps are one step of the ``output``."""

    source: str
    output: Output
    factor: Fraction

    @property
    def name(self) -> str:
        """``gps.latitude``, or the name of a sensor that gives one number."""
        return f"{self.source}.{self.output.name}" if self.output.name else self.source


@dataclass(frozen=True, slots=True)
class Sourced(Derivation):
    """Given by sensors, by instance."""

    given: tuple[Given, ...]

    @property
    def ages_alone(self) -> bool:
        return True

    @property
    def gives(self) -> tuple[tuple[str, Output, Fraction], ...]:
        return tuple((each.source, each.output, each.factor) for each in self.given)

    def simulated(
        self, quantity: Quantity, instance: int, system: "System", parameters: Mapping[str, float]
    ) -> SimulatedInput | None:
        given = self.given[instance]
        return system.sources[given.source].simulated(given.output, quantity.steps / given.factor)

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        for number, each in enumerate(self.given, 1):
            place = f" of {number}" if len(self.given) > 1 else ""
            unit = each.output.unit.name
            scaled = "" if each.factor == 1 else f" * {each.factor}"
            text = f"{each.name} in {unit or 'numbers'}{scaled}, {each.output.low}..{each.output.high}"
            yield DerivationFact(f"given by{place}", text, "source")

    def words(self, quantity: Quantity) -> str:
        return f"given by {' and '.join(dict.fromkeys(each.name for each in self.given))}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        for each in self.given:
            source = system.sources[each.source]
            yield "sensor", f"{each.name}: {source.words()}"
            low, high = each.output.low, each.output.high
            yield "plausible", f"{low} to {high} {each.output.unit.name}".rstrip()

    def way(self, quantity: Quantity, system: "System") -> Iterator[Step]:
        for each in self.given:
            source = system.sources[each.source]
            polling = source.polling
            every = f"every {decimal(Fraction(polling.period_us, 1000))} ms"
            yield Step("sensor", f"{each.name}: {source.words()}", (every,), polling.criteria("rate"))
        first = self.given[0]
        if first.factor != 1:
            text = f"* {first.factor}, to the nearest {quantity.stored.name}".rstrip()
            yield Step("conversion", text, (), quantity.criteria("rounding"))


def resolve_sourced(written: SourcedSpec, kept: Kept, around: Surroundings) -> Sourced | None:
    """Return what gives it; None after a finding."""
    _check(kept, around)
    if around.failed:
        return None
    given = [_given(source, output, kept, around) for source, output in around.outputs()]
    if not given or None in given or around.failed:
        return None
    return Sourced(tuple(each for each in given if each is not None))


def _check(kept: Kept, around: Surroundings) -> None:
    spec, name = around.spec, around.name
    if kept.kind not in (QuantityKind.NUMBER, QuantityKind.ENUM):
        around.bad(
            "source",
            f"{name} is a {kept.kind.value} quantity, and a sensor gives numbers",
            BAD_SOURCED,
            hint="leave out source, or make it a number",
        )
    if spec.stale_after is not None and spec.initial is not None:
        message = f"{name} has an initial value in place of unknown, so stale_after says nothing"
        around.bad("stale_after", message, hint="leave out one of them")


def _given(source: Source, output: Output, kept: Kept, around: Surroundings) -> Given | None:
    factor = ratio(output.unit, kept.stored)
    if factor is None:
        why = obstacle(output.unit, kept.stored)
        message = f"{output.name or source.name} is in {output.unit.name or 'numbers'}, not in {kept.stored.name}"
        rule = UNCARRIED_CONVERSION if why else UNIT_MISMATCH
        around.bad(
            "source",
            f"{message}: {why}" if why else message,
            rule,
            hint=f"unit: {output.unit.name}" if output.unit.name else "leave unit and stored out",
        )
        return None
    is_copied = factor == 1 and output.storage is kept.storage
    if not is_copied and not output.storage is kept.storage is Storage.SMALL:
        name, unit = output.name or source.name, output.unit.name
        if output.storage is Storage.SMALL:
            message = (
                f"{name} * {factor} needs numbers of more than 30 bits: it goes from {output.low} to {output.high}"
            )
            around.bad("source", message, BAD_SOURCED, f"say what is plausible: min and max of {name} in board.yaml")
            return None
        message = f"{name} needs {output.storage.words} words in steps of {unit or 1}, and cannot be scaled"
        around.bad("source", message, BAD_SOURCED, f"keep {around.name} as it comes, without stored, min and max")
        return None
    if factor.numerator * factor.denominator >= _LARGEST:
        message = f"{output.name or source.name} * {factor} needs numbers of more than 30 bits"
        around.bad("source", message, BAD_SOURCED, f"stored: {output.unit.name}")
        return None
    return Given(source.name, output, factor)
