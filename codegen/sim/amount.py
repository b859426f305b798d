"""Times and numbers as people read them."""

import math


def seconds(milliseconds: float) -> str:
    """A time as people read it: ``12.3 s``."""
    return f"{milliseconds / 1000:.1f} s"


def amount(value: float | None, unit: str, digits: int | None = None) -> str:
    """A number with its unit: ``12.34 V``; ``digits`` behind the point, else as many as say something."""
    if value is None:
        return "unknown"
    shown = f"{value:.{9}g}" if digits is None else f"{value:.{digits}f}"
    return f"{shown} {unit}".rstrip()


def digits_of(step: float) -> int:
    """Return how many digits behind the point show steps of a size: 1 for 0.2, 2 for 0.05."""
    return max(0, math.ceil(-math.log10(step) - 1e-9)) if step > 0 else 0
