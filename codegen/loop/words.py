"""The budget of the main loop in words, as the page and ``codegen explain`` tell it."""

from collections.abc import Iterator

from codegen.loop.budget import LoopBudget, Slot, Took
from codegen.loop.jobs import Job
from codegen.model.units.unit import decimal

NOT_COUNTED = (
    "Messages are due all at once at the start, when a ground station appears, and where their periods meet.",
    "Not counted: control() and what else is code of yours, the driver of a port (sockets and Wi-Fi, a UART), the "
    "device of a sensor, saving, collecting garbage, misses of the flash cache, and asyncio between two passes.",
)
"""Sentences on what comes on top of the prediction."""


COLUMNS = ("slot", "a second", "likely us", "at most us", "left to control()")
COLUMNS_WITHOUT_TIMES = ("slot", "a second", "instructions", "", "")
"""The columns in each row of the table of slots."""


def rows(budget: LoopBudget) -> Iterator[tuple[str, ...]]:
    """Return the rows of the table of slots; those without a rate tell what may come on top of the one before."""
    for slot in budget.slots:
        yield _row(slot.words, rate_words(slot), slot.quiet, budget)
        if slot.serves:
            yield _row("and all messages due", "", slot.busy, budget)
    fullest = max(budget.slots, key=lambda slot: slot.most.instructions)
    yield _row(f"{fullest.words}, everything on", "", fullest.most, budget)


def _row(words: str, rate: str, took: Took, budget: LoopBudget) -> tuple[str, ...]:
    if took.likely_us is None or took.most_us is None:
        return words, rate, str(took.instructions), "", ""
    return words, rate, str(round(took.likely_us)), str(round(took.most_us)), left_words(took, budget)


def job_words(job: Job) -> str:
    """Return ``links are served, every 10 ms``."""
    whole_s = job.period_us >= 1000000
    every = f"{job.period_us / 1000000:g} s" if whole_s else f"{job.period_us / 1000:g} ms"
    return f"{job.words}, every {every}"


def us_words(took: Took) -> str:
    """Return ``556 to 789 us``, or instructions where no time is known."""
    if took.likely_us is None or took.most_us is None:
        return f"{took.instructions} instructions"
    return f"{round(took.likely_us)} to {round(took.most_us)} us"


def left_words(took: Took, budget: LoopBudget) -> str:
    """Return what is left to control(), ``1944 us, 1711 at least``; nothing where no time is known."""
    left = budget.left_us(took)
    if left is None:
        return ""
    likely, least = (round(each) for each in left)
    if likely < 0:
        return f"nothing: {-likely} us too long"
    return f"{likely} us" + (f", {least} at least" if least >= 0 else ", perhaps nothing")


def rate_words(slot: Slot) -> str:
    """Return how often a slot comes in a second."""
    return f"{decimal(slot.rate)}" if slot.rate.denominator in (1, 2, 5, 10) else f"{float(slot.rate):.2f}"


def load_words(budget: LoopBudget) -> str:
    """Return how much of the board the loop takes."""
    what = "with one station on each link and the rates of the parameters' defaults"
    load = budget.load
    if load.likely_us is None or load.most_us is None:
        return f"In a second the loop takes {load.instructions} instructions, {what}."
    likely, most = (f"{float(each) / 10000:.1f} %" for each in (load.likely_us, load.most_us))
    return f"The loop takes {likely} of the board, {most} at most, {what}."


def source_words(budget: LoopBudget) -> str:
    """Return where the figures come from, and how well they fit."""
    error = max(fit.error for fit in budget.costs.fits)
    counted = "instructions of MicroPython's unix port on x86-64, counted part by part; what was counted is told with"
    text = f"Predicted from {counted} an error of {error * 100:.0f} % at most."
    timing = budget.timing
    if timing is None:
        return text
    return (
        f"{text} For each of them {decimal(timing.cycles)} cycles are likely, {decimal(timing.most_cycles)} the most, "
        f"at {decimal(timing.megahertz)} MHz."
    )
