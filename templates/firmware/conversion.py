"""Exact steps between what people set, what the state keeps and what goes out.

Only to_steps(), for people and tests, works with floats. Everything else is integer arithmetic, which allocates
nothing as long as it stays below 2 ** 30.
"""

LARGEST = 1073741823  # the largest integer that 32-bit boards keep without allocating


def to_steps(value, numerator, denominator=1):
    """Return a number as whole steps of numerator / denominator each, or None for None and NaN: unknown.

    A half is rounded away from zero; what is too large, infinity too, becomes the largest integer of the state.
    """
    if value is None or value != value:  # noqa: PLR0124  only NaN differs from itself
        return None
    steps = value * numerator / denominator
    if steps >= LARGEST:
        return LARGEST
    if steps <= -LARGEST:
        return -LARGEST
    return int(steps + 0.5) if steps >= 0 else -int(0.5 - steps)


def limited(value, low, high):
    """Return the value, or the limit that it passes."""
    if value < low:
        return low
    if value > high:
        return high
    return value


def nearest(value, numerator, denominator):
    """Return value * numerator / denominator, a half away from zero."""
    if value < 0:
        return -((denominator // 2 - value * numerator) // denominator)
    return (value * numerator + denominator // 2) // denominator


def down(value, numerator, denominator):
    """Return value * numerator / denominator, toward minus infinity."""
    return value * numerator // denominator


def up(value, numerator, denominator):
    """Return value * numerator / denominator, toward plus infinity."""
    return -(-value * numerator // denominator)


def toward_zero(value, numerator, denominator):
    """Return value * numerator / denominator without its fraction."""
    if value < 0:
        return -(-value * numerator // denominator)
    return value * numerator // denominator


def product(first, second, numerator, denominator):
    """Return first * second * numerator / denominator for positive numbers, rounded to nearest.

    The product of all three may pass 2 ** 30; that of the first two must not.
    """
    both = first * second
    return both // denominator * numerator + (both % denominator * numerator + denominator // 2) // denominator


def complete(values, room):
    """Return whether there are values, no more than there is room for, and all of them are known."""
    return 0 < len(values) <= room and None not in values


def spill(live, index, cells, value, most, unused):
    """Spread a value over live cells that hold up to `most` each; cells that are not reached get `unused`.

    None, the unknown value, reaches no cell, 0 the first one.
    """
    cells += index
    while index < cells:
        if value is None:
            live[index] = unused
        elif value > most:
            live[index] = most
            value -= most
        else:
            live[index] = value
            value = None
        index += 1
