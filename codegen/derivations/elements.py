"""How many values a quantity has that is a list: one for each of what a fact of the component counts."""

from codegen.derivations.surroundings import Surroundings
from codegen.diagnostics import Rule

BAD_ELEMENTS = Rule(
    "bad-elements",
    "A quantity with elements has one number for each of what a fact of its component counts: board.yaml states the "
    "fact for every instance, a whole number from 1 to 255. Nothing measures or estimates it, and it starts unknown.",
)


def resolve_elements(around: Surroundings) -> tuple[int, ...] | None:
    """How many values the quantity has, by instance; None for a single value, or after a finding."""
    spec = around.spec
    if spec.elements is None:
        return None
    written = [key for key in ("boolean", "enum", "initial") if getattr(spec, key) not in (None, False)]
    written += [each.KEY for each in spec.derivations if each.is_named]
    if written:
        message = f"a quantity with elements has numbers that other code sets, and no {written[0]}"
        around.bad(written[0], message, BAD_ELEMENTS)
        return None
    return around.counted(spec.elements, "elements", BAD_ELEMENTS)
