"""One quantity of the vehicle state: its integer representation, limits and conversion from ADC counts."""

import keyword
import re
from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.measure import UNIT_MISMATCH, find_unit, read_time
from codegen.model.dialect import Dialect, EnumDefinition
from codegen.model.spec import Requirement, Spec
from codegen.model.state_spec import QuantitySpec
from codegen.model.unit import NUMBER, UNITS, Unit
from codegen.model.vehicle import SMALL_INT_MAX, AdcChannel, Conversion, Instance, Parameter, Quantity, QuantityKind
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.derived import resolve_estimate, resolve_trend
from codegen.resolve.following import count_cells, resolve_elements, resolve_following
from codegen.resolve.vehicle import find_parameter

BAD_QUANTITY = Rule(
    "bad-quantity",
    "A quantity of the state contradicts itself: names are lower-case identifiers, a boolean or an enum has no unit "
    "and no limits, min <= initial <= max, and every limit fits a small integer of MicroPython in stored units.",
)
UNKNOWN_ADC = Rule("unknown-adc", "A quantity names an ADC channel that board.yaml does not have.")
UNKNOWN_ENUM = Rule("unknown-enum", "A table names an enum that the dialect does not have.")
UNKNOWN_ENTRY = Rule("unknown-enum-entry", "A table names an entry that the enum of the dialect does not have.")

_IDENTIFIER = re.compile(r"[a-z][a-z0-9_]*")
# Names that the generated code uses itself, beside Python's own.
_RESERVED_QUANTITIES = {
    "instance",
    "number",
    "failures",
    "expires_ms",
    "warned_ms",
    "warn_above",
    "expire",
    "set_count",
    "forget",
    "keep",
    "gone",
    "has_returned",
}
_SUFFIX = {"%": "pct", "d%": "dpct", "c%": "cpct"}


def is_name(name: str) -> bool:
    """Whether the generated code can use a name as it is."""
    return bool(_IDENTIFIER.fullmatch(name)) and not keyword.iskeyword(name)


class QuantityResolver:
    """Resolves one quantity; every problem of it is reported before it is given up."""

    def __init__(self, component: str, name: str, spec: QuantitySpec, whole: Spec, report: Report) -> None:
        self.component = component
        self.name = name
        self.spec = spec
        self.whole = whole
        self.report = report
        self.failed = False

    def _bad(self, key: str, message: str, rule: Rule = BAD_QUANTITY, hint: str | None = None) -> None:
        self.report.add(rule, self.spec.at(key), message, hint)
        self.failed = True

    def resolve(
        self,
        dialect: Dialect,
        parts: tuple[Instance, ...],
        channels: Mapping[str, AdcChannel],
        parameters: Mapping[str, Parameter],
        index: Mapping[str, Requirement],
        period_ms: int | None,
    ) -> Quantity | None:
        spec = self.spec
        citation = cite_optional(spec.requirement, spec.at("requirement"), index, self.report)
        self._check()
        kind = self._kind()
        enum = self._enum(dialect)
        unit = find_unit(spec.unit, spec.at("unit"), self.report)
        stored = unit if spec.stored is None else find_unit(spec.stored, spec.at("stored"), self.report)
        if unit is None or stored is None:
            return None
        steps = unit.to(stored)
        if steps is None:
            self._bad("stored", f"{unit.name} cannot be kept in {stored.name}", UNIT_MISMATCH)
            return None
        minimum, maximum = self._limits(steps, enum)
        initial = self._initial(kind, enum, steps)
        if initial is not None and not minimum <= initial <= maximum:
            self._bad("initial", f"initial of {self.name} is not between its limits")
        conversion = self._conversion(channels, parameters, stored)
        warn_above = self._warn_above(steps, parts)
        stale_after, warn_every = self._time("stale_after", spec.stale_after), self._time("warn_every", spec.warn_every)
        trend = resolve_trend(spec, stored, period_ms, self.whole.state.components[self.component], self.report)
        estimate = resolve_estimate(spec, self.component, parts, self.whole, dialect, self.report)
        facts = tuple(part.facts for part in parts)
        elements = resolve_elements(spec, self.component, facts, self.report)
        others = self.whole.state.components[self.component].quantities
        follows = resolve_following(spec, self.component, others, facts, self.report)
        if self.failed or (elements is None) != (spec.elements is None) or (follows is None) != (spec.follows is None):
            return None
        return Quantity(
            component=self.component,
            name=self.name,
            attribute=_attribute(self.name, kind, stored),
            kind=kind,
            unit=unit,
            stored=stored,
            steps=steps,
            minimum=minimum,
            maximum=maximum,
            initial=initial,
            while_known=spec.while_known,
            enabled_by=self._enabled_by(parameters),
            follows=follows,
            elements=elements,
            trend=trend,
            estimate=estimate,
            enum=enum,
            conversion=conversion,
            warn_above=warn_above,
            warn_every_ms=warn_every,
            stale_after_ms=stale_after,
            spec=spec,
            citation=citation,
            aspects=cite_aspects(spec, index, self.report),
        )

    def _check(self) -> None:
        """What can be told without the rest of the specification."""
        if not is_name(self.name) or self.name in _RESERVED_QUANTITIES:
            self._bad("", f"{self.name} cannot be the name of a quantity", hint="choose another name")
        invalid_after = self.spec.invalid_after
        if invalid_after is not None and not 1 <= invalid_after <= 1000:
            self._bad("invalid_after", f"invalid_after of {self.name} is {invalid_after}, not 1 to 1000")

    def _time(self, key: str, written: str | None) -> int | None:
        return None if written is None else read_time(written, UNITS["ms"], self.spec.at(key), self.report)

    def _enabled_by(self, parameters: Mapping[str, Parameter]) -> Parameter | None:
        spec = self.spec
        if spec.enabled_by is None:
            return None
        return find_parameter(spec.enabled_by, spec.at("enabled_by"), self.whole.parameters, parameters, self.report)

    def _kind(self) -> QuantityKind:
        spec = self.spec
        kind = QuantityKind.NUMBER
        if spec.boolean:
            kind = QuantityKind.BOOLEAN
        elif spec.enum is not None:
            kind = QuantityKind.ENUM
        if kind is not QuantityKind.NUMBER:
            for key in ("unit", "stored", "min", "max", "adc", "multiplier", "warn_above"):
                if getattr(spec, key) is not None:
                    self._bad(key, f"{self.name} is a {kind.value} quantity and cannot have {key}")
        following = {key: getattr(spec, key) for key in ("while_known", "enabled_by", "follows") if getattr(spec, key)}
        for key, followed in following.items():
            if not spec.boolean or spec.initial is not None:
                self._bad(key, f"{self.name} follows {followed}: it is a boolean without initial")
        if len(following) > 1:
            self._bad(list(following)[1], f"{self.name} follows either a quantity or a parameter")
        if spec.boolean and spec.enum is not None:
            self._bad("enum", f"{self.name} cannot be both a boolean and an enum")
        return kind

    def _enum(self, dialect: Dialect) -> EnumDefinition | None:
        name = self.spec.enum
        if name is None:
            return None
        enum = dialect.enums.get(name)
        if enum is None:
            self._bad("enum", f"the dialect has no enum {name}", UNKNOWN_ENUM, did_you_mean(name, dialect.enums))
        return enum

    def _in_steps(self, key: str, value: Fraction, steps: Fraction) -> int:
        scaled = value * steps
        if scaled.denominator != 1:
            self._bad(key, f"{key} of {self.name} is not a whole number of stored units")
        elif abs(scaled) > SMALL_INT_MAX:
            self._bad(key, f"{key} of {self.name} is beyond a small integer in stored units")
        return int(scaled)

    def _warn_above(self, steps: Fraction, parts: tuple[Instance, ...]) -> tuple[int, ...] | None:
        """The value above which a warning is logged, by instance."""
        written = self.spec.warn_above
        if written is None:
            return None
        if not self.spec.per_cell:
            return (self._in_steps("warn_above", written, steps),) * len(parts)
        facts = tuple(part.facts for part in parts)
        counts = count_cells(self.component, facts, self.spec.at("per_cell"), self.report)
        if counts is None:
            self.failed = True
            return None
        return tuple(
            self._in_steps("warn_above", Fraction(round(written * count * steps)), Fraction(1)) for count in counts
        )

    def _limits(self, steps: Fraction, enum: EnumDefinition | None) -> tuple[int, int]:
        """The smallest and the largest value in stored units: of an enum those of its entries."""
        if enum is not None and enum.entries:
            values = [entry.value for entry in enum.entries]
            return (0, SMALL_INT_MAX) if enum.is_bitmask else (min(values), min(SMALL_INT_MAX, max(values)))
        spec = self.spec
        minimum = -SMALL_INT_MAX if spec.min is None else self._in_steps("min", spec.min, steps)
        maximum = SMALL_INT_MAX if spec.max is None else self._in_steps("max", spec.max, steps)
        if minimum > maximum:
            self._bad("max", f"max of {self.name} is below its min")
        return minimum, maximum

    def _initial(self, kind: QuantityKind, enum: EnumDefinition | None, steps: Fraction) -> int | None:
        written = self.spec.initial
        if kind is QuantityKind.BOOLEAN:
            follows = self.spec.while_known or self.spec.enabled_by or self.spec.follows
            if follows is None and not isinstance(written, bool):
                self._bad("initial", f"the boolean {self.name} needs initial: true or false")
            return int(written is True)
        if written is None:
            return None
        if isinstance(written, bool) or (kind is QuantityKind.NUMBER) != isinstance(written, Fraction):
            wanted = "a number" if kind is QuantityKind.NUMBER else "an entry of its enum"
            self._bad("initial", f"initial of {self.name} is not {wanted}")
            return None
        if isinstance(written, Fraction):
            return self._in_steps("initial", written, steps)
        entry = enum.entry(written) if enum else None
        if enum is not None and entry is None:
            names = [entry.name for entry in enum.entries]
            self._bad("initial", f"{enum.name} has no entry {written}", UNKNOWN_ENTRY, did_you_mean(written, names))
        return entry.value if entry else None

    def _conversion(
        self, channels: Mapping[str, AdcChannel], parameters: Mapping[str, Parameter], stored: Unit
    ) -> Conversion | None:
        spec = self.spec
        if spec.adc is None and spec.multiplier is None:
            for key in ("warn_above", "warn_every", "invalid_after", "stale_after"):
                if getattr(spec, key) is not None:
                    self._bad(key, f"{self.name} has no adc, so {key} says nothing")
            return None
        if spec.adc is None or spec.multiplier is None:
            self._bad("adc" if spec.adc else "multiplier", f"{self.name} needs both adc and multiplier, or neither")
            return None
        channel = channels.get(spec.adc)
        if channel is None and f"adc.{spec.adc}" not in self.whole.board.places:
            hint = did_you_mean(spec.adc, channels)
            self._bad("adc", f"board.yaml has no ADC channel {spec.adc}", UNKNOWN_ADC, hint)
        place, written = spec.at("multiplier"), self.whole.parameters
        multiplier = find_parameter(spec.multiplier, place, written, parameters, self.report)
        factor = UNITS["V"].to(stored)
        if factor is None:
            self._bad("adc", f"an ADC measures a voltage, {self.name} is a {stored.dimension}", UNIT_MISMATCH)
        if channel is None or multiplier is None or factor is None:
            self.failed = True  # without them there is no conversion; whatever is wrong with them was reported
            return None
        if multiplier.unit is not NUMBER or multiplier.minimum < 0:
            self._bad("multiplier", f"{multiplier.name} is not a pure number that is never negative", UNIT_MISMATCH)
        exact = channel.reference / channel.full_scale * multiplier.step * factor
        return Conversion(channel, multiplier, exact.numerator, exact.denominator)


def _attribute(name: str, kind: QuantityKind, stored: Unit) -> str:
    """The firmware's name of the integer: a number without a unit has a suffix, too, so that its name can check it."""
    suffix = _SUFFIX.get(stored.name) or re.sub(r"[^a-z0-9]+", "_", stored.name.lower()).strip("_")
    if kind is QuantityKind.NUMBER:
        return f"{name}_{suffix or 'number'}"
    return name
