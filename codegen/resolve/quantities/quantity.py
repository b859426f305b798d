"""One quantity of the vehicle state: how it is kept, its limits, and where its value comes from."""

import keyword
import re
from collections.abc import Mapping

from codegen.derivations import resolve_derivation
from codegen.derivations.counts_returns import check_restart
from codegen.derivations.elements import resolve_elements
from codegen.derivations.follows import BAD_FOLLOWING
from codegen.derivations.surroundings import BAD_QUANTITY, Kept, Surroundings
from codegen.diagnostics import did_you_mean
from codegen.measure import UNIT_MISMATCH, read_time
from codegen.model.quantities.derivation import Derivation
from codegen.model.quantities.trust import Trust
from codegen.model.spec.derivation import EstimateSpec, MeasuredSpec
from codegen.model.spec.spec import Requirement
from codegen.model.units.unit import Unit, read_measure, unit_named
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.pattern import pattern
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.quantities.kept import resolve_kept

_IDENTIFIER = pattern(r"[a-z][a-z0-9_]*")
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
    "words",
    "limited",
    "beyond",
    "tell",
}
_ESTIMATING = "estimate"
"""The method of a component in which something is estimated."""
LONGEST_NAME = 64
_SUFFIX = {"%": "pct", "d%": "dpct", "c%": "cpct"}


def is_name(name: str) -> bool:
    """Return whether the generated code can use a name as it is: MicroPython's have
    255 characters at most, with all parts.
    """
    return len(name) <= LONGEST_NAME and bool(_IDENTIFIER.fullmatch(name)) and not keyword.iskeyword(name)


def resolve_quantity(around: Surroundings, index: Mapping[str, Requirement]) -> Quantity | None:
    """The quantity; None after a finding. Every problem of it is reported before it is given up."""
    spec, report = around.spec, around.report
    citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
    _check(around)
    resolved = resolve_kept(around)
    if resolved is None:
        return None
    kept, enum = resolved
    derivation = resolve_derivation(kept, around)
    trust = _trust(derivation, around)
    elements = resolve_elements(around)
    check_restart(kept, around)
    if around.failed or derivation is None:
        return None
    return Quantity(
        component=around.component,
        name=around.name,
        attribute=_attribute(around.name, kept),
        kind=kept.kind,
        unit=kept.unit,
        stored=kept.stored,
        steps=kept.steps,
        storage=kept.storage,
        minimum=kept.minimum,
        maximum=kept.maximum,
        initial=kept.initial,
        enum=enum,
        elements=elements,
        derivation=derivation,
        trust=trust,
        spec=spec,
        citation=citation,
        aspects=cite_aspects(spec, index, report),
    )


def _trust(derivation: Derivation | None, around: Surroundings) -> Trust:
    """Return when it is no longer believed: as is written, or with the quantity that it is counted of."""
    basis = derivation.ages_with if derivation else None
    spec = around.spec if basis is None else around.others[basis]
    stale_ms = None
    if spec.stale_after is not None:
        stale_ms = read_time(spec.stale_after, unit_named("ms"), spec.at("stale_after"), around.report)
    return Trust(around.spec.invalid_after, stale_ms)


def _check(around: Surroundings) -> None:
    """Report what is wrong without a look at the rest of the specification."""
    spec, name = around.spec, around.name
    is_taken = name == _ESTIMATING and any(each.written(EstimateSpec) for each in around.others.values())
    if is_taken or not is_name(name) or name in _RESERVED_QUANTITIES:
        around.bad("", f"{name} cannot be the name of a quantity", hint="choose another name")
    if spec.invalid_after is not None and not 1 <= spec.invalid_after <= 1000:
        around.bad(
            "invalid_after", f"invalid_after of {name} is {spec.invalid_after}, not 1 to 1000", hint="invalid_after: 3"
        )
    if not any(written.has_readings for written in spec.derivations):
        if spec.invalid_after is not None:
            around.bad(
                "invalid_after",
                f"{name} has no adc and no source, so invalid_after says nothing",
                hint="leave it out, or say what measures it: adc or source",
            )
        if spec.stale_after is not None:
            _check_age(around)
    if spec.reaches is not None:
        _check_reach(around)
    if spec.per is not None and spec.reaches is None and not any(written.has_limit for written in spec.derivations):
        around.bad(
            "per", "per says nothing without a limit, such as that of follows", BAD_FOLLOWING, hint="leave it out"
        )


def _check_reach(around: Surroundings) -> None:
    """Report what it reaches, unless that is an amount in its unit, or such a fact of each instance."""
    written, unit = around.spec.reaches or "", Unit.parse(around.spec.unit or "")
    names = [written] if read_measure(written) else [part.facts.get(written) for part in around.parts]
    lacking = next((part for part, name in zip(around.parts, names, strict=False) if name is None), None)
    if lacking is not None:
        owner = around.component if len(around.parts) == 1 else f"{around.component} {lacking.number + 1}"
        hint = did_you_mean(written, lacking.facts) or f"facts: {{{around.component}: {{{written}: ...}}}}"
        around.bad("reaches", f"board.yaml does not state the fact {written} of {owner}", BAD_QUANTITY, hint)
    elif unit is not None:
        for name in names:
            measure = read_measure(str(name))
            if measure is None or measure.in_unit(unit) is None:
                around.bad(
                    "reaches",
                    f"{name} is no amount in {around.spec.unit}",
                    UNIT_MISMATCH,
                    hint=f"write an amount such as 5 {around.spec.unit}, or the name of a fact that is one",
                )
                return


def _check_age(around: Surroundings) -> None:
    """Report stale_after where it says nothing: only what code sets as a whole, and can be unknown, grows old."""
    spec, name = around.spec, around.name
    if any(written.is_named for written in spec.derivations):
        around.bad(
            "stale_after",
            f"{name} is not set by code, so stale_after says nothing",
            hint="leave it out: what it comes from says when it is unknown",
        )
    elif spec.boolean:
        around.bad(
            "stale_after",
            f"{name} is a boolean, which is never unknown, so stale_after says nothing",
            hint="leave it out, or make it a number",
        )
    elif spec.initial is not None and not isinstance(spec.elements, str):  # such a list has a finding of its own, below
        hint = "leave out one of them"
        around.bad(
            "stale_after", f"{name} has an initial value in place of unknown, so stale_after says nothing", hint=hint
        )
    elif isinstance(spec.elements, str) and not any(other.written(MeasuredSpec) for other in around.others.values()):
        text = f"{name} has elements, each of which is set by itself: without an adc no reading forgets them"
        around.bad("stale_after", text, hint="elements: 4 is a list that is set as a whole")


def _attribute(name: str, kept: Kept) -> str:
    """The firmware's name of what is kept: an integer has its unit as a suffix, so that its name can check it."""
    if kept.kind is not QuantityKind.NUMBER or (kept.storage.is_float and kept.stored == kept.unit):
        return name
    stored = kept.stored.name
    if stored.startswith("steps of "):
        return f"{name}_steps"
    suffix = _SUFFIX.get(stored) or re.sub(r"[^a-z0-9]+", "_", stored.lower()).strip("_")
    return f"{name}_{suffix or 'number'}"
