"""Bars of a chart, in percent of its width: what is surely there, and what may come on top."""

from collections.abc import Sequence
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.price import Range


@dataclass(frozen=True, slots=True)
class Bar:
    """One bar: ``low`` percent are surely there, ``more`` may come on top. ``label`` may lead to ``href``.

    ``value`` says the same as the bar in words. ``style`` is empty, ``idle`` or ``over``.
    """

    label: str
    href: str
    note: str
    value: str
    low: float
    more: float
    style: str


@dataclass(frozen=True, slots=True)
class Tick:
    """A line of the grid, at ``at`` percent."""

    at: float
    label: str


@dataclass(frozen=True, slots=True)
class Chart:
    """Bars over one scale."""

    id: str
    title: str
    doc: str
    unit: str
    ticks: tuple[Tick, ...]
    bars: tuple[Bar, ...]


@dataclass(frozen=True, slots=True)
class Amount:
    """An amount to show as a bar: ``amount`` in the unit of the chart."""

    label: str
    amount: Range
    value: str
    href: str = ""
    note: str = ""
    style: str = ""


def chart(name: str, title: str, doc: str, unit: str, amounts: Sequence[Amount], end: Fraction | None = None) -> Chart:
    """A chart that ends at a round number, or at ``end``; a bar that would be longer is cut there."""
    top = end or max((amount.amount.high for amount in amounts), default=Fraction(1)) or Fraction(1)
    step = _step(top)
    last = end or -(-top // step) * step
    ticks = [step * index for index in range(int(last / step) + 1)]
    return Chart(
        id=name,
        title=title,
        doc=doc,
        unit=unit,
        ticks=tuple(Tick(_percent(tick, last), f"{float(tick):g}") for tick in ticks),
        bars=tuple(
            Bar(
                label=amount.label,
                href=amount.href,
                note=amount.note,
                value=amount.value,
                low=_percent(amount.amount.low, last),
                more=round(_percent(amount.amount.high, last) - _percent(amount.amount.low, last), 2),
                style=amount.style,
            )
            for amount in amounts
        ),
    )


def _percent(value: Fraction, last: Fraction) -> float:
    return round(float(min(value / last, Fraction(1)) * 100), 2)


def _step(top: Fraction) -> Fraction:
    """The smallest of 1, 2, 5, 10, ... that makes at most four steps of ``top``: more would crowd a phone."""
    steps = (Fraction(base) * Fraction(10) ** power for power in range(-2, 12) for base in (1, 2, 5))
    return next((step for step in steps if top / step <= 4), top)
