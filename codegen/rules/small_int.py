"""Integers of the steady path stay below 2**30, above which 32-bit MicroPython allocates."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.answer import Answer
from codegen.model.conversion import Conversion
from codegen.model.storage import SMALL_INT_MAX
from codegen.model.system import System
from codegen.model.vehicle import Parameter, Quantity

RULE = Rule(
    "allocating-arithmetic",
    "An intermediate result of a conversion can pass 2**30 - 1. It would still be right, but 32-bit boards allocate "
    "memory for it, and the steady telemetry cycle must not. Make the parameter's step or the stored unit coarser.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every conversion from counts, and every scaling of a populated field."""
    for _, quantity, conversion in system.measured():
        yield from _conversion(quantity, conversion)
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


def _scalings(answer: Answer) -> Iterator[Diagnostic]:
    for scaling in answer.scalings:
        if scaling.worst > SMALL_INT_MAX:
            yield Diagnostic(
                answer.covers.written.place,
                RULE,
                f"{answer.covers.label}: the scaling by {scaling.factor} reaches {scaling.worst}",
                "limit the value with min and max, or keep the quantity in the unit of the field",
            )
