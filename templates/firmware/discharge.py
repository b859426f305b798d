"""The charge that a voltage stands for, by the discharge curve of a battery at rest."""


def percent(curve, steps):
    """Return the charge in %, 0 to 100, straight between the points (steps, %) of a rising curve."""
    low = curve[0]
    if steps <= low[0]:
        return low[1]
    for high in curve:
        if steps < high[0]:
            span = high[0] - low[0]
            return low[1] + ((steps - low[0]) * (high[1] - low[1]) + span // 2) // span
        low = high
    return low[1]
