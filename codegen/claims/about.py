"""The messages that the headings and the passages around a place in a text name."""

from collections.abc import Iterator

from codegen.claims.reading import Reading, between
from codegen.frozen import dataclass
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once


@dataclass(frozen=True, slots=True)
class Surroundings:
    """The messages that the headings around a passage name, the nearest first, and those of its section before it."""

    headings: tuple[WireMessage, ...]
    earlier: tuple[WireMessage, ...]

    @property
    def first(self) -> WireMessage | None:
        """The message that the passage is about if it names none."""
        return next(iter((*self.headings, *self.earlier)), None)


@once
def surroundings(reading: Reading) -> tuple[tuple[Passage | CodeBlock, Surroundings], ...]:
    """Each part of a document with what stands around it."""
    return tuple(_surroundings(reading))


def _surroundings(reading: Reading) -> Iterator[tuple[Passage | CodeBlock, Surroundings]]:
    open_headings: list[tuple[int, tuple[WireMessage, ...]]] = []
    earlier: dict[str, WireMessage] = {}
    only = {name for _, name in reading.sightings}
    alone = (reading.messages[next(iter(only))],) if len(only) == 1 else ()
    for part in reading.prose.parts:
        if isinstance(part, Passage) and part.kind is PassageKind.HEADING:
            named = reading.named(part)
            open_headings = [each for each in open_headings if each[0] < part.level]
            open_headings.append((part.level, named if len(named) == 1 else ()))
            earlier = {}
        headings = tuple(message for _, named in reversed(open_headings) for message in named)
        others = () if earlier else alone
        yield part, Surroundings(headings, (*reversed(earlier.values()), *others))
        for message in reversed(reading.named(part)) if isinstance(part, Passage) else ():
            earlier.pop(message.name, None)
            earlier[message.name] = message


def message_about(reading: Reading, passage: Passage, around: Surroundings, start: int, end: int) -> WireMessage | None:
    """The message that a statement is about: the only one of its sentence, of its passage, of the heading."""
    mentions = reading.mentioned(passage)
    low, high = passage.sentence(start, end)
    beside = {mention.name for mention in between(mentions, low, high)}
    if beside:
        return reading.messages[beside.pop()] if len(beside) == 1 else None
    inside = reading.named(passage)
    if inside:
        return inside[0] if len(inside) == 1 else None
    return around.headings[0] if around.headings else around.earlier[0] if len(around.earlier) == 1 else None
