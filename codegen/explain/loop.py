"""The budget of the main loop, for codegen explain: what is left to control() in each slot, and what takes the rest."""

from collections.abc import Iterator
from textwrap import fill

from codegen.explain.text import columns
from codegen.loop.budget import LoopBudget, loop_budget, why_not_predicted
from codegen.loop.shares import shares
from codegen.loop.words import (
    COLUMNS,
    COLUMNS_WITHOUT_TIMES,
    NOT_COUNTED,
    job_words,
    load_words,
    rows,
    source_words,
    us_words,
)
from codegen.model.system import System

_WIDTH = 100


def loop_story(system: System) -> str:
    """Return the budget of a program as text; why there is none, where there is none."""
    budget = loop_budget(system)
    if budget is None or system.program is None:
        return f"main loop: nothing is predicted; {why_not_predicted(system)}\n"
    period = f"control() is called every {budget.control_us} us"
    lines = [f"main loop on {system.board_name}: {period}", ""]
    if budget.timing is None:
        lines += [fill(f"No times: {why_not_predicted(system)}.", _WIDTH), ""]
    lines += columns(list(_table(budget)))
    lines += ["", *columns([(job.name, job_words(job)) for job in budget.jobs])]
    lines += ["", fill(load_words(budget), _WIDTH)]
    slot = budget.longest
    lines += ["", f"What takes the longest slot ({slot.words}; all messages due):"]
    lines += columns([(name, us_words(took), share) for name, took, share in shares(slot, budget)])
    lines += ["", *_besides(budget), "", *(fill(text, _WIDTH) for text in (*NOT_COUNTED, source_words(budget)))]
    return "\n".join(lines) + "\n"


def _table(budget: LoopBudget) -> Iterator[tuple[str, ...]]:
    yield COLUMNS if budget.timing else COLUMNS_WITHOUT_TIMES
    for row in rows(budget):
        yield f"  {row[0]}" if row[1] == "" else row[0], *row[1:]


def _besides(budget: LoopBudget) -> Iterator[str]:
    yield f"each further station of a link takes {us_words(budget.station)} more where its link has something to do"
    yield f"each message that arrives, as a HEARTBEAT, takes {us_words(budget.heard)} more"
