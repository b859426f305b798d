"""Settings of lists: all values of one at once, through the same one of both attributes."""

import math
import random
from collections.abc import Iterator, Sequence

from population.answer import Answer
from population.settings import LEAVE, STORED, Setting, kept, lots

FEW = 6
"""Values of a list that are unknown on their own; all would take too long."""


def together(answers: Sequence[Answer], settings: Sequence[Setting], dice: random.Random) -> list[Setting]:
    """The settings, where those of each list fit each other; a list of which one value is set is set as a whole."""
    found = list(settings)
    for places in lists(answers):
        if all(found[at] == LEAVE for at in places):
            continue
        for at in places:
            found[at] = lots(answers[at], dice) if found[at] == LEAVE else found[at]
        if any(found[at].how == STORED for at in places):
            for at in places:
                found[at] = _stored(answers[at], found[at])
    return found


def lists(answers: Sequence[Answer]) -> Iterator[range]:
    """Yield the places of the values of each list."""
    for at, each in enumerate(answers):
        if each.listed and each.at == 0:
            yield range(at, at + each.listed)


def alone(answers: Sequence[Answer], dice: random.Random) -> list[int]:
    """The answers that are to be unknown while all others are known: those that hide others, or the message."""
    hiding = [at for at, each in enumerate(answers) if each.withholds or each.hides_all]
    listed = {at for places in lists(answers) for at in set(places) - set(dice.sample(places, min(FEW, len(places))))}
    return [at for at in hiding if at not in listed]


def _stored(answer: Answer, setting: Setting) -> Setting:
    """The same in what is kept."""
    value = setting.value
    if setting.how == STORED:
        return setting
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return Setting(STORED, None)
    steps = kept(answer, setting)
    assert steps is not None
    return Setting(STORED, int(max(-(1 << 62), min((1 << 64) - 1, steps))))
