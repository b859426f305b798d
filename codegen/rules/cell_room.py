"""Packs with more cells than a message has room for."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import EachBinding, PopulatedMessage, System
from codegen.source import Place

RULE = Rule(
    "values-beyond-message",
    "An instance has more values of a quantity, such as the cells of a pack, than a message has elements for. The "
    "values of a pack go out together or not at all, so that this message never carries them: what is split beside "
    "them goes out, or unknown. A message with pages takes any number.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every message whose fields take a value for each element, without pages."""
    for message in system.messages:
        rooms = {binding.source.path: binding for binding in message.bindings if isinstance(binding, EachBinding)}
        for binding in rooms.values():
            if binding.room is not None and not binding.is_paged:
                yield from _beyond(system, message, binding, binding.room)


def _beyond(system: System, message: PopulatedMessage, binding: EachBinding, room: int) -> Iterator[Diagnostic]:
    source = binding.source
    several = len(source.elements or ()) > 1
    reported: set[Place] = set()
    for number, count in enumerate(source.elements or ()):
        place = system.spec.board.fact_place(source.component, number, source.spec.elements or "")
        if count <= room or place in reported:
            continue
        reported.add(place)
        owner = f"{source.component} {number + 1}" if several else source.component
        instead = next((each.fallback for each in message.bindings if isinstance(each, EachBinding)), None)
        sent = f"{instead.source.path} is sent instead" if instead else "they are sent as unknown"
        text = f"{owner} has {count} {source.name}, and {message.name} has room for {room}: {sent}"
        related = ((binding.covers.answer.place, "the field is answered here"),)
        yield Diagnostic(place, RULE, text, None, related)
