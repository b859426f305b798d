# Generated from templates/firmware/conversion.py: do not edit.
# Inputs: 9173becf7787567a
"""Exact steps between what people set, what the state keeps and what goes out.

Only to_steps(), for people and tests, works with floats. Everything else is integer arithmetic, which allocates
nothing as long as it stays below 2 ** 30.
"""

LARGEST = 1073741823  # the largest integer that 32-bit boards keep without allocating


def to_steps(value, numerator, denominator, high=LARGEST):
    """Return a number as whole steps of numerator / denominator each, or None for None, NaN and infinity: unknown.

    A half is rounded away from zero; what is beyond -high or high is left to whoever limits it.
    """
    if value is None or value - value != 0:  # of NaN and infinity that is NaN
        return None
    steps = value * numerator
    if denominator != 1:
        steps = steps / denominator
    if -high <= steps <= high:
        whole = int(steps)
        if whole == steps:  # no float is made of a whole number, which may have more digits
            return whole
        return int(steps + 0.5) if steps >= 0 else -int(0.5 - steps)
    return steps


def limited(value, low, high):
    """Return the value, or the limit that it passes."""
    if value < low:
        return low
    if value > high:
        return high
    return value
