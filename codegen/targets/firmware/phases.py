"""When each sensor has its first turn: so that no pass of the main loop takes two slow ones where it can be avoided."""

from collections.abc import Iterable, Sequence

from codegen.model.source_kind import Source

_MOST_PHASES = 400
"""So many phases are tried at most: those of 1 Hz in a loop of 400 Hz."""
_PASSES = 4000
"""So many passes are looked at."""


def spread(sources: Sequence[Source], pass_us: int, busy: Iterable[tuple[int, int]]) -> dict[str, int]:
    """The phase of each sensor by name, in us: a whole number of passes, below its period.

    ``busy`` has period and phase of the other jobs that take long. Those that may take longest choose first.
    """
    taken = [0] * _PASSES
    for period_us, phase_us in busy:
        _take(taken, _passes(period_us, phase_us, pass_us))
    phases = {}
    for source in sorted(sources, key=lambda each: -(each.polling.limit_us or 0)):
        period_us = source.polling.period_us
        met, best = None, 0
        for phase_us in range(0, min(period_us, _MOST_PHASES * pass_us), pass_us):
            others = sum(taken[at] for at in _passes(period_us, phase_us, pass_us))
            if met is None or others < met:
                met, best = others, phase_us
            if not met:
                break
        phases[source.name] = best
        _take(taken, _passes(period_us, best, pass_us))
    return phases


def _passes(period_us: int, phase_us: int, pass_us: int) -> Iterable[int]:
    """The numbers of the passes in which a job runs: the first ones after it is due."""
    turns = range(phase_us, _PASSES * pass_us, period_us)
    return {-(-due_us // pass_us) for due_us in turns if -(-due_us // pass_us) < _PASSES}


def _take(taken: list[int], passes: Iterable[int]) -> None:
    for at in passes:
        taken[at] += 1
