"""One figure of a benchmark: a value, what it is compared with, and whether it is what was aimed at."""

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Figure:
    """One result: `measure` against `against` is `value` `unit`; a target says how much it may be at `most` or `least`.

    A value of None could not be measured here; `note` then says why.
    """

    key: str
    measure: str
    against: str
    value: float | None
    unit: str = "times"
    most: float | None = None
    least: float | None = None
    note: str = ""

    @property
    def target(self) -> str:
        """The target in words, or nothing."""
        if self.most is not None:
            return "0" if self.most == 0 else f"<= {number(self.most)}"
        return "" if self.least is None else f">= {number(self.least)}"

    @property
    def is_met(self) -> bool | None:
        """Return whether the target is met, None without a target or without a value."""
        if self.value is None or not self.target:
            return None
        return self.value <= self.most if self.most is not None else self.value >= (self.least or 0)

    @property
    def shown(self) -> str:
        """The value with its unit."""
        return f"not measured: {self.note}" if self.value is None else f"{number(self.value)} {self.unit}"

    @property
    def verdict(self) -> str:
        """Return in words whether the target was met."""
        return {True: "met", False: "not met", None: ""}[self.is_met]


def number(value: float) -> str:
    """A number with as many digits as a benchmark can vouch for."""
    if value == 0 or abs(value) >= 100:
        return f"{value:.0f}"
    return f"{value:.1f}" if abs(value) >= 10 else f"{value:.2f}" if abs(value) >= 0.1 else f"{value:.2g}"


def ratio(of: float | None, to: float | None) -> float | None:
    """One value over another; None where one of the contestants is missing."""
    return None if of is None or to is None else of / to


def table(figures: Iterable[Figure]) -> str:
    """Figures as columns of text."""
    rows = [("measure", "against", "value", "target", "")]
    rows += [(one.measure, one.against, one.shown, one.target, one.verdict) for one in figures]
    widths = [max(len(row[column]) for row in rows) for column in range(5)]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows]
    return "\n".join(lines)
