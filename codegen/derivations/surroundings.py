"""The input of a derivation while it is resolved: the quantity that it belongs to, and the specification around it."""

import dataclasses
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.measure import read_time
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import Dialect, WireField
from codegen.model.quantities.source_kind import Output, Source
from codegen.model.spec.derivation import SourcedSpec
from codegen.model.spec.receive import ReceiveSpec
from codegen.model.spec.spec import Spec
from codegen.model.spec.state import QuantitySpec
from codegen.model.units.unit import NUMBER, Unit, ratio, unit_named
from codegen.model.vehicle import AdcChannel, Instance, Parameter, QuantityKind
from codegen.source import Place

BAD_QUANTITY = Rule(
    "bad-quantity",
    "A quantity of the state contradicts itself: names are lower-case identifiers, a boolean, an enum or a text has "
    "no unit and no limits, a text keeps 1 to 255 bytes, min <= initial <= max, and every limit fits a small integer "
    "of MicroPython in stored units.",
    remedy="write what a number, a boolean, an enum or a text takes, with min <= initial <= max",
)
UNKNOWN_SOURCE = Rule(
    "unknown-source",
    "A quantity names a sensor, or a number that a sensor gives, which board.yaml does not have. Sensors stand there "
    "under sources, by name; of one that gives several numbers each is named with a point: gps.latitude.",
    remedy="write it in board.yaml under sources",
)
UNKNOWN_QUANTITY = Rule(
    "unknown-quantity",
    "A table names a quantity that state.yaml does not have.",
    remedy="write it in state.yaml under the quantities of its component",
)
MOST_COUNTED = 255


@dataclass(frozen=True, slots=True)
class Kept:
    """The storage of a quantity: the fields of ``Quantity`` that are known before its derivation."""

    kind: QuantityKind
    unit: Unit
    stored: Unit
    steps: Fraction
    storage: Storage
    minimum: int | Fraction
    maximum: int | Fraction
    initial: int | Fraction | str | None


@dataclasses.dataclass(slots=True)
class Surroundings:
    """A quantity ``name`` of ``component`` as written, with what the specification says elsewhere.

    ``carriers`` are the fields that carry its value as it is; ``is_compared``: something else looks at the value, too.
    ``received`` are the tables that set it from a message, each with the key of the field.

    ``parts`` are the instances of the component, ``period_ms`` the time between two of its updates, or None.
    ``find_parameter`` looks one up by its name, for what stands at a place; None after a finding.
    ``failed`` once something was found in the quantity itself, with which it cannot be resolved. ``found`` is what
    ``outputs`` has looked up.
    """

    component: str
    name: str
    spec: QuantitySpec
    parts: tuple[Instance, ...]
    period_ms: int | None
    channels: Mapping[str, AdcChannel]
    sources: Mapping[str, Source]
    find_parameter: Callable[[str, Place], Parameter | None]
    whole: Spec
    dialect: Dialect
    carriers: tuple[WireField, ...]
    is_compared: bool
    received: tuple[tuple[ReceiveSpec, str], ...]
    report: Report
    failed: bool = False
    found: tuple[tuple[Source, Output], ...] | None = None

    @property
    def others(self) -> Mapping[str, QuantitySpec]:
        """The quantities of the component as written, this one among them."""
        return self.whole.state.components[self.component].quantities

    def bad(
        self,
        key: str,
        message: str,
        rule: Rule = BAD_QUANTITY,
        hint: str | None = None,
        related: Iterable[tuple[Place, str]] = (),
    ) -> None:
        """Report something at a key of the quantity."""
        self.report.add(rule, self.spec.at(key), message, hint, related)
        self.failed = True

    def no_quantity(self, key: str, name: str, rule: Rule, among: Iterable[str] = ()) -> None:
        """Report that the component has no quantity called so; one that could not be read has been reported already.

        What may have been meant is one of ``among``, or of all.
        """
        self.failed = True
        if not self.whole.state.is_written(self.component, name):
            self.bad(key, f"there is no quantity {name}", rule, did_you_mean(name, list(among) or self.others))

    def time_ms(self, key: str, written: str | None) -> int | None:
        """A time in ms; None where none is written, or after a finding."""
        return None if written is None else read_time(written, unit_named("ms"), self.spec.at(key), self.report)

    def parameter(self, key: str, name: str) -> Parameter | None:
        """The parameter called so; None after a finding."""
        return self.find_parameter(name, self.spec.at(key))

    def in_steps(self, key: str, value: Fraction, steps: Fraction) -> int:
        """A value in stored units, which has to be a whole number of them."""
        scaled = value * steps
        if scaled.denominator != 1:
            self.bad(
                key,
                f"{key} of {self.name} is not a whole number of stored units",
                hint=f"round it, or keep {self.name} more finely: stored",
            )
        return int(scaled)

    @property
    def path(self) -> str:
        """``component.quantity``, as tables write it."""
        return f"{self.component}.{self.name}"

    @property
    def is_sourced(self) -> bool:
        """Return whether a sensor gives it."""
        return self.spec.written(SourcedSpec) is not None

    def outputs(self) -> tuple[tuple[Source, Output], ...]:
        """Return by instance the sensor that gives it, and the output; nothing without one, or after a finding."""
        if self.found is None:
            self.found = self._outputs()
        return self.found

    def _outputs(self) -> tuple[tuple[Source, Output], ...]:
        written = self.spec.written(SourcedSpec)
        if written is None:
            return ()
        names = (written.source,) if isinstance(written.source, str) else written.source
        if len(names) != len(self.parts):
            message = f"{self.component} has {len(self.parts)} instances, and {self.name} {len(names)} sources"
            each = ", ".join(f"{self.name}_{number}" for number, _ in enumerate(self.parts, 1))
            hint = f"a list has one for each: [{each}]"
            self.bad("source", message, UNKNOWN_SOURCE, hint)
            return ()
        found = [self._output(name) for name in names]
        return tuple(each for each in found if each is not None) if None not in found else ()

    def _output(self, name: str) -> tuple[Source, Output] | None:
        owner, _, part = name.partition(".")
        source = self.sources.get(owner)
        if source is None:
            if f"sources.{owner}" not in self.whole.board.places:  # else what is wrong with it has been reported
                given = [(one.name, output.name) for one in self.sources.values() for output in one.outputs]
                known = [f"{one}.{part}".rstrip(".") for one, part in given]
                hint = did_you_mean(name, known) or did_you_mean(owner, (*self.sources, *self.channels))
                self.bad("source", f"board.yaml has no sensor {owner}", UNKNOWN_SOURCE, hint)
            self.failed = True
            return None
        found = source.output(part)
        if found is not None:
            return source, found
        names = [output.name for output in source.outputs]
        if not names:  # the driver's own, each with a finding
            self.failed = True
            return None
        message = f"{owner} gives no {part}" if part else f"{owner} gives several numbers: {', '.join(names)}"
        hint = f"{owner}.{names[0]}"
        if names == [""]:
            hint = owner
        elif part and (near := did_you_mean(part, names)):
            hint = near
        self.bad("source", message, UNKNOWN_SOURCE, hint)
        return None

    def given_to(self, name: str) -> tuple[tuple[Source, Output], ...]:
        """Return by instance the sensor and the output that give another quantity of the component, as far as known.

        What is wrong with it is reported there.
        """
        written = self.others[name].written(SourcedSpec)
        if written is None:
            return ()
        names = (written.source,) if isinstance(written.source, str) else written.source
        given = []
        for each in names:
            owner, _, part = each.partition(".")
            source = self.sources.get(owner)
            output = source.output(part) if source is not None else None
            if source is not None and output is not None:
                given.append((source, output))
        return tuple(given)

    def unit_of(self, name: str) -> Unit | None:
        """Return the unit in which another number of the component is kept that something looks at.

        It is the one that is written, or that of its sensor's steps; None for one that does not exist, which is
        reported there.
        """
        written = self.others[name]
        spelt = written.stored or written.unit
        unit = NUMBER if spelt is None else Unit.parse(spelt)
        given = () if written.stored or unit is None else self.given_to(name)
        return given[0][1].unit if given and unit and ratio(unit, given[0][1].unit) is not None else unit

    def steps_of(self, name: str) -> Fraction | None:
        """Return how many steps of what is kept make one unit of another number; None for units that do not exist."""
        written, kept = self.others[name].unit, self.unit_of(name)
        unit = NUMBER if written is None else Unit.parse(written)
        return None if unit is None or kept is None else ratio(unit, kept)

    def counted(self, fact: str, key: str, rule: Rule) -> tuple[int, ...] | None:
        """A fact of board.yaml that counts something, by instance; None after a finding."""
        counts = []
        for number, part in enumerate(self.parts, 1):
            count = part.facts.get(fact)
            owner = self.component if len(self.parts) == 1 else f"{self.component} {number}"
            if count is None:
                hint = did_you_mean(fact, part.facts) or f"facts: {{{self.component}: {{{fact}: 3}}}}"
                self.bad(key, f"board.yaml does not state the fact {fact} of {owner}", rule, hint)
                return None
            if not isinstance(count, Fraction) or count.denominator != 1 or not 1 <= count <= MOST_COUNTED:
                message = f"{fact} of {owner} is {count}, not a whole number from 1 to {MOST_COUNTED}"
                self.bad(
                    key, message, rule, hint=f"state how many there are: facts: {{{self.component}: {{{fact}: 3}}}}"
                )
                return None
            counts.append(int(count))
        return tuple(counts)


SET_TWICE = Rule(
    "received-elsewhere",
    "A table of a received message sets a quantity that something else sets, too: another table, a reading, the clock, "
    "or another quantity from which it follows. Each quantity has one source.",
)


def told_origin(spec: QuantitySpec) -> str:
    """Return where a quantity is from, for people: ``set by code``, ``given by a sensor``, ``found by its lasts``."""
    written = next((each for each in spec.derivations if each.is_named), None)
    if isinstance(written, SourcedSpec):
        return "given by a sensor"
    return "set by code" if written is None else f"found by its {written.KEY}"
