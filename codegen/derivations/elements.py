"""The number of values of a quantity that is a list: written in the table, or one for each thing that a fact counts."""

from codegen.derivations.surroundings import MOST_COUNTED, Surroundings
from codegen.diagnostics import Rule
from codegen.model.units.unit import decimal

BAD_ELEMENTS = Rule(
    "bad-elements",
    "A quantity with elements is a list of numbers: so many as elements says, a whole number from 1 to 255, or one for "
    "each of what a fact of its component counts, which board.yaml states for every instance. Nothing measures or "
    "estimates it. Where a fact counts them, it starts unknown.",
    remedy="write elements: and a whole number from 1 to 255, or the name of a fact that counts them",
)


def resolve_elements(around: Surroundings) -> tuple[int, ...] | None:
    """Return how many values the quantity has, by instance; None for a single value, or after a finding."""
    spec = around.spec
    if spec.elements is None:
        return None
    is_row = not isinstance(spec.elements, str)
    keys = ("boolean", "enum") if is_row else ("boolean", "enum", "initial")
    written = [key for key in keys if getattr(spec, key) not in (None, False)]
    written += [each.KEY for each in spec.derivations if each.is_named]
    if written:
        message = f"a quantity with elements has numbers that other code sets, and no {written[0]}"
        around.bad(written[0], message, BAD_ELEMENTS, hint=f"leave out {written[0]}, or elements")
        return None
    if isinstance(spec.elements, str):
        return around.counted(spec.elements, "elements", BAD_ELEMENTS)
    if spec.elements.denominator != 1 or not 1 <= spec.elements <= MOST_COUNTED:
        message = f"elements of {around.name} is {decimal(spec.elements)}, not a whole number from 1 to {MOST_COUNTED}"
        around.bad(
            "elements",
            message,
            BAD_ELEMENTS,
            hint=f"elements: 1 to {MOST_COUNTED}, or the name of a fact that counts them",
        )
        return None
    return (int(spec.elements),) * len(around.parts)
