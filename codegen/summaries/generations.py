"""The cost of generations of messages, in words: for explain and for the review documents."""

from codegen.frozen import dataclass
from codegen.model.price import Range, chosen, default_rate, frame_size, message_price, price, total
from codegen.model.spec.spec import Generation
from codegen.model.system import Generations, PopulatedMessage, System
from codegen.model.units.unit import decimal
from codegen.summaries.fields import in_table

COUNTED = (
    "Counted are whole MAVLink 2 frames without a signature: 12 bytes and the payload, without the zeros at its end. A "
    "range is what the state can make of it. Answers to requests, and what is sent on connection or on a change, come "
    "on top."
)
COUNTED_V1 = (
    "Counted are whole MAVLink 1 frames: 8 bytes and the payload. Answers to requests, and what is sent on connection "
    "or on a change, come on top."
)


@dataclass(frozen=True, slots=True)
class ChoiceRow:
    """A choice: bytes per second for each instance, and for all that are on by default."""

    choice: str
    by_instance: tuple[str, ...]
    whole: str
    messages: str


@dataclass(frozen=True, slots=True)
class FrameRow:
    """A message of a generation: its rate, and the bytes of a frame about each instance."""

    message: str
    generation: str
    rate: str
    by_instance: tuple[str, ...]
    sent_at_once: str


@dataclass(frozen=True, slots=True)
class GenerationTable:
    """Everything about the generations of one component's messages; ``on`` is how many instances are on by default."""

    component: str
    chosen_by: str
    doc: str
    citation: str
    instances: tuple[str, ...]
    on: str
    choices: tuple[ChoiceRow, ...]
    frames: tuple[FrameRow, ...]
    counted: str


def generation_tables(system: System) -> tuple[GenerationTable, ...]:
    """A table for each entry of streams.yaml."""
    return tuple(_table(generations, system) for generations in system.generations)


def _table(generations: Generations, system: System) -> GenerationTable:
    component = generations.component
    messages = chosen(generations, Generation.BOTH, system)
    on = max((sum(message_price(message, system).is_on) for message in messages), default=0)
    count = component.instances
    return GenerationTable(
        component=component.name,
        chosen_by=_chosen_by(generations),
        doc=in_table(generations.spec.doc.strip()),
        citation=str(generations.citation or ""),
        instances=tuple(f"{component.name} {number + 1}" for number in range(count)),
        on=f"in all, {on} of {count} on" if count > 1 else "in all",
        choices=tuple(_choice(generations, choice, system) for choice in Generation),
        frames=tuple(_frames(message, generations, system) for message in messages),
        counted=COUNTED if system.spec.project.protocol == 2 else COUNTED_V1,
    )


def _chosen_by(generations: Generations) -> str:
    parameter, default = generations.parameter, generations.default
    if parameter is None:
        return f"{default.value}, for good"
    values = ", ".join(f"{value} {choice.value}" for value, choice in enumerate(Generation))
    return f"{parameter.name}: {values}; {default.value} by default"


def _choice(generations: Generations, choice: Generation, system: System) -> ChoiceRow:
    messages = chosen(generations, choice, system)
    found = [message_price(message, system).by_instance for message in messages]
    return ChoiceRow(
        choice=choice.value,
        by_instance=tuple(
            str(total(_of(ranges, instance) for ranges in found)) for instance in range(generations.component.instances)
        ),
        whole=str(price(generations, choice, system)),
        messages=", ".join(message.name for message in messages),
    )


def _of(ranges: tuple[Range, ...], instance: int) -> Range:
    """The price about an instance; a message that is sent once is about the first."""
    return ranges[instance] if instance < len(ranges) else total(())


def _frames(message: PopulatedMessage, generations: Generations, system: System) -> FrameRow:
    rate = default_rate(message)
    pages = f", {message.pages} pages" if message.pages > 1 else ""
    return FrameRow(
        message=message.name,
        generation=(Generation.OLD if message.name in generations.old else Generation.NEW).value,
        rate=f"{decimal(rate)} Hz{pages}" if rate else "on request",
        by_instance=tuple(
            str(frame_size(message, instance, system.spec.project.protocol)) for instance in range(message.instances)
        ),
        sent_at_once=sent_at_once(message),
    )


def sent_at_once(message: PopulatedMessage) -> str:
    """Return what announces a message: ``on connection and when battery.swaps changes``."""
    reasons = ["on connection"] if message.on_connection else []
    reasons += [f"when {message.on_change.path} changes"] if message.on_change else []
    return " and ".join(reasons)
