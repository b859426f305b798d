"""Integers of the steady path stay below 2**30, above which 32-bit MicroPython allocates."""

import math
from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.answers.answer import Answer
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.quantities.basis import Basis
from codegen.model.quantities.conversion import Conversion, factors_by_instance
from codegen.model.quantities.summed import RADIX
from codegen.model.system import System
from codegen.model.vehicle import Parameter, Quantity

RULE = Rule(
    "allocating-arithmetic",
    "An intermediate result of a conversion can pass 2**30 - 1. It would still be right, but 32-bit boards allocate "
    "memory for it, and the steady telemetry cycle must not. Make the parameter's step or the stored unit coarser.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every conversion from counts, and every scaling of a populated field."""
    for reading in system.readings():
        yield from _conversion(reading.quantity, reading.conversion)
        yield from _sums(reading, system)
    for component in system.components.values():
        for basis in component.counted_on:
            yield from _sums(basis, system)
    for message in system.messages:
        for answer in message.answers:
            if answer.covers.field.type.is_integer:
                yield from _scalings(answer)


def _conversion(quantity: Quantity, conversion: Conversion) -> Iterator[Diagnostic]:
    multiplier, denominator = conversion.multiplier, conversion.denominator
    largest = max(abs(multiplier.minimum), abs(multiplier.maximum))
    products = [(conversion.channel.full_scale * largest, conversion.numerator)]
    if conversion.offset is not None:
        most = max(abs(conversion.offset.minimum), abs(conversion.offset.maximum))
        products.append((most * largest, conversion.offset_numerator))
    # A remainder is less than the denominator, and than the product itself where that is never negative.
    rest = sum(
        (denominator if multiplier.minimum < 0 or conversion.offset else min(denominator, both + 1)) * abs(numerator)
        for both, numerator in products
    )
    whole = sum((both // denominator + 1) * abs(numerator) for both, numerator in products)
    worst = max(*(both for both, _ in products), rest + denominator // 2, whole)
    if worst > SMALL_INT_MAX:
        related = []
        if isinstance(multiplier, Parameter):
            related.append((multiplier.spec.at("step"), f"{multiplier.name} is declared here"))
        yield Diagnostic(
            quantity.spec.at("multiplier"),
            RULE,
            f"{quantity.path}: the conversion from counts reaches {worst}",
            f"make the step of {multiplier.name} coarser, or its max smaller",
            tuple(related),
        )


def _sums(reading: Basis, system: System) -> Iterator[Diagnostic]:
    """Yield what is counted of what is measured: its product with a time, and what is left with a factor."""
    quantities = reading.component.quantities
    most = _largest(reading.quantity, system)
    stale_ms = reading.quantity.trust.stale_after_ms or 0
    for quantity in quantities.values():
        found, rest, lasting = quantity.derivation.sums, quantity.derivation.remains, quantity.derivation.lasts
        worst = 0
        if found is not None and found.of == reading.quantity.name:
            worst = most * stale_ms + found.parts // (RADIX * RADIX if found.times else 1)
            if found.times is not None and found.times in quantities:
                high = _largest(quantities[found.times], system)
                worst = max(
                    worst, (most * stale_ms // RADIX**2 + 2) * high + found.parts // RADIX, RADIX * high + RADIX**3
                )
        if rest is not None and quantity in reading.given:
            worst = rest.full.maximum * rest.steps * ((rest.share or 1) + 1)
        if lasting is not None and quantity in reading.given:
            left = quantities.get(lasting.left)
            first, second = lasting.factors(left.derivation.remains if left else None)
            worst = max(
                most * lasting.smooth_steps * (lasting.readings + 1), _largest_left(left) * first, most * second
            )
        if worst > SMALL_INT_MAX:
            hint = "a shorter stale_after, a smaller max of its parameters or of its sensor, or a coarser unit"
            yield Diagnostic(quantity.spec.place, RULE, f"{quantity.path}: counting it reaches {worst}", hint)


def _largest(quantity: Quantity, system: System) -> int:
    """The largest magnitude of what is measured, over all instances."""
    conversion, count = quantity.derivation.conversion, system.components[quantity.component].instances
    if conversion is None:
        ends = (end * factor for _, output, factor in quantity.derivation.gives for end in (output.low, output.high))
        return max(math.ceil(abs(end)) for end in ends)
    offset = conversion.offset
    offsets = factors_by_instance(offset, system.parameters, count) if offset else (None,) * count
    multipliers = factors_by_instance(conversion.multiplier, system.parameters, count)
    both_ends = [conversion.ends(*both) for both in zip(multipliers, offsets, strict=True)]
    return max(abs(end) for both in both_ends for end in both)


def _largest_left(quantity: Quantity | None) -> int:
    """The most that can be left; nothing where what is wrong with it was reported."""
    rest = quantity.derivation.remains if quantity else None
    return rest.full.maximum * rest.steps if rest else 0


def _scalings(answer: Answer) -> Iterator[Diagnostic]:
    for scaling in answer.scalings:
        if scaling.worst > SMALL_INT_MAX:
            yield Diagnostic(
                answer.covers.written.place,
                RULE,
                f"{answer.covers.label}: the scaling by {scaling.factor} reaches {scaling.worst}",
                "limit the value with min and max, or keep the quantity in the unit of the field",
            )
