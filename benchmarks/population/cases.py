"""The cases of a message: what is set, and what each field then has to say, by exact arithmetic.

A case sets some quantities, lets time pass, and sends the message. Nothing of the generator is asked: limits, rounding,
sentinels and ages are those that the tables of the project say (population/answers.py) and the documents explain.
"""

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache

from population.answer import STALE_S, Answer
from population.expected import Carried, carried
from population.listed import alone, lists, together
from population.settings import LEAVE, Setting, extremes, kept, lots

AGES_US = STALE_S * 900_000, STALE_S * 200_000
WAITS_US = 300_000, 0, 7


@dataclass(frozen=True)
class Case:
    """The settings before a message is sent, answer by answer; ``None`` is expected where it is withheld.

    ``before_us`` pass before that, ``age_us`` after it.
    """

    settings: tuple[Setting, ...]
    before_us: int
    age_us: int
    expected: tuple[Carried, ...] | None


@dataclass
class State:
    """The state of the vehicle according to the documents: stored values, and when each was set."""

    answers: Sequence[Answer]
    now_us: int = 0
    values: dict[int, Fraction | float | str | None] = field(default_factory=dict)
    set_us: dict[int, int] = field(default_factory=dict)

    def put(self, at: int, setting: Setting) -> None:
        """A setting that is not left out."""
        if setting != LEAVE:
            self.values[at], self.set_us[at] = kept(self.answers[at], setting), self.now_us

    def value(self, at: int) -> Fraction | float | str | None:
        """Return the value of an answer now; a clock goes on."""
        found, value = self.answers[at], self.values.get(at)
        age_us = self.now_us - self.set_us.get(at, 0)
        if found.kind == "clock" and isinstance(value, Fraction):
            return (Fraction(value) + age_us) % (1 << 64)
        return None if found.is_aging and age_us > STALE_S * 1_000_000 else value

    def expected(self) -> tuple[Carried, ...] | None:
        """Return the expected value of each field; None where the message is withheld."""
        values = [self.value(at) for at in range(len(self.answers))]
        pairs = list(zip(self.answers, values, strict=True))
        if any(value is None and each.withholds for each, value in pairs):
            return None
        found = [None if each.hides_all and value is None else carried(each, value) for each, value in pairs]
        for places in lists(self.answers):
            if any(found[at] is None for at in places):  # the first element speaks for all, behind it are zeros
                found[places[0]] = carried(self.answers[places[0]], None)
                found[places[1] : places[-1] + 1] = [Carried(0, 0)] * (len(places) - 1)
        return tuple(each for each in found if each is not None)


@lru_cache(maxsize=64)
def make_cases(answers: tuple[Answer, ...], seed: int, rounds: int) -> tuple[Case, ...]:
    """Return all cases of a message: the extremes of every field, random values, each unknown alone, and ages."""
    return tuple(_cases(answers, seed, rounds))


def _cases(answers: Sequence[Answer], seed: int, rounds: int) -> Iterator[Case]:
    dice = random.Random(f"{seed} {answers[0].field.message} cases")
    state = State(answers)
    known = [[setting for setting in extremes(each) if not _withholds(each, setting)] for each in answers]
    starts = [dice.randrange(len(settings)) for settings in known]

    def case(settings: Sequence[Setting], age_us: int = 0, before_us: int = 0) -> Case:
        state.now_us += before_us
        settings = together(answers, settings, dice)
        for at, setting in enumerate(settings):
            state.put(at, setting)
        state.now_us += age_us
        return Case(tuple(settings), before_us, age_us, state.expected())

    for turn in range(max(len(settings) for settings in known)):
        yield case([settings[(start + turn) % len(settings)] for settings, start in zip(known, starts, strict=True)])
    for turn in range(rounds):
        yield case([lots(each, dice) for each in answers], before_us=WAITS_US[turn % len(WAITS_US)])
    for at in alone(answers, dice):
        unknown = [setting for setting in extremes(answers[at]) if _withholds(answers[at], setting)]
        settings = [LEAVE] * len(answers)
        settings[at] = dice.choice(unknown)
        yield case(settings)
        settings[at] = lots(answers[at], dice)
        yield case(settings)
    if any(each.is_aging for each in answers):
        yield case([lots(each, dice) for each in answers], AGES_US[0])
        yield case([LEAVE] * len(answers), AGES_US[1])
        yield case([lots(each, dice) if each.is_aging and each.withholds else LEAVE for each in answers])
        yield case([lots(each, dice) if each.is_aging else LEAVE for each in answers])


def _withholds(answer: Answer, setting: Setting) -> bool:
    return (answer.withholds or answer.hides_all) and kept(answer, setting) is None
