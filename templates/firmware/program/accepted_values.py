"""The words for what a parameter accepts; loaded when the first value is refused."""

from parameters import facts_of

_TEXT = 50  # characters of a STATUSTEXT


def refusal(parameters, name, value):
    """Return why a value is refused: "A: 99 is not 0 to 60", or "B: 5 is not 0, 4 or 9", as many as fit."""
    said = f"{name}: {value:g} is not "
    values = [f"{parameters.value(name, steps):g}" for steps in facts_of(name)[6:]]
    if not values:
        smallest, largest = parameters.limits(name)
        return said + f"{smallest:g} to {largest:g}"
    words = ", ".join(values[:-1]) + " or " + values[-1] if len(values) > 1 else values[0]
    kept = len(values) - 2
    while len(said) + len(words) > _TEXT and kept > 0:
        words = ", ".join(values[:kept]) + ", ... " + values[-1]
        kept -= 1
    return said + words
