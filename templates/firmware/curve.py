"""The value that a reading stands for, by a curve of measured points."""


def value_at(curve, steps):
    """Return the value at a reading, straight between the points (steps, value) of a curve, rising by their steps."""
    at = 0  # a loop over the points themselves would need so many places that MicroPython takes them from the heap
    while at < len(curve) and steps >= curve[at][0]:
        at += 1
    if at == 0 or at == len(curve):
        return curve[at - 1 if at else 0][1]
    return _between(curve[at - 1], curve[at], steps)


def _between(low, high, steps):
    span = high[0] - low[0]
    return low[1] + ((steps - low[0]) * (high[1] - low[1]) + span // 2) // span
