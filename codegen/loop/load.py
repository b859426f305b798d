"""The load of the board that follows from what really went out and came in, as a simulation counts it."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.loop.budget import loop_budget, why_not_predicted
from codegen.loop.frames import message_work
from codegen.loop.parts import Part, Work
from codegen.loop.rates import looks_a_second
from codegen.model.system import System

HEARTBEAT_SIZE = 21
"""Bytes of the frame of a HEARTBEAT: what arrives is counted as so many of them."""


@dataclass(frozen=True, slots=True)
class TrafficLoad:
    """The likely time on the board in us: ``base`` for a second without a frame, ``byte`` for each byte that goes out.

    ``frames`` are the frames by the name of their message, without their bytes, ``frame`` is one of another message;
    ``heard`` is a byte that arrives.
    """

    base: Fraction
    frames: Mapping[str, Fraction]
    frame: Fraction
    byte: Fraction
    heard: Fraction

    def share(self, frames: Mapping[str, int | Fraction], size: int, received: int, length_ms: int) -> Fraction:
        """Return the share of the time that passes take, in which so many frames and bytes went out and arrived."""
        sent = sum(count * self.frames.get(name, self.frame) for name, count in frames.items())
        taken = sent + size * self.byte + received * self.heard
        return (self.base + taken * 1000 / max(length_ms, 1)) / 1000000


def traffic_load(system: System) -> TrafficLoad | str:
    """Return the load of a program's board, or why none is predicted."""
    budget = loop_budget(system)
    if system.program is None or budget is None or budget.timing is None or budget.base.likely_us is None:
        return why_not_predicted(system)

    def likely(work: Work) -> Fraction:
        return budget.took(work).likely_us or Fraction(0)

    looked = Work({Part.STREAMS: 1, Part.TABLE: len(system.messages), Part.ENDING: 1})
    frames: dict[str, Fraction] = {}
    for message in system.messages:
        work = message_work(message, system, most=True)
        each = likely(Work({**work, Part.BYTE: 0})) / max(work[Part.FRAME], 1)
        frames[message.wire.name] = max(each, frames.get(message.wire.name, each))
    return TrafficLoad(
        base=budget.base.likely_us + looks_a_second(system, system.program) * likely(looked),
        frames=frames,
        frame=likely(Work({Part.MESSAGE: 1, Part.FRAME: 1})),
        byte=likely(Work({Part.BYTE: 1})),
        heard=likely(Work({Part.HEARD: 1})) / HEARTBEAT_SIZE,
    )
