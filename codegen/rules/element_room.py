"""Instances with more values than a message has room for."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.system import PopulatedMessage, System
from codegen.source import Place

RULE = Rule(
    "values-beyond-message",
    "An instance has more values of a quantity, such as those of cells, than a message has elements for. The "
    "values of an instance go out together or not at all, so that this message never carries them: what is split "
    "beside them goes out, or unknown. A message with pages takes any number.",
    Severity.WARNING,
    remedy="answer with pages, or take a message with more elements",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every message whose fields take a value for each element, without pages."""
    for message in system.messages:
        found = {answer.together.source.path: answer for answer in message.answers if answer.together is not None}
        for answer in found.values():
            yield from _beyond(system, message, answer)


def _beyond(system: System, message: PopulatedMessage, answer: Answer) -> Iterator[Diagnostic]:
    assert answer.together is not None
    source, room = answer.together.source, answer.together.room
    several = len(source.elements or ()) > 1
    reported: set[Place] = set()
    for number, count in enumerate(source.elements or ()):
        fact = source.spec.elements
        place = source.spec.at("elements")
        if isinstance(fact, str):
            place = system.spec.board.fact_place(source.component, number, fact)
        if count <= room or place in reported:
            continue
        reported.add(place)
        owner = f"{source.component} {number + 1}" if several else source.component
        others = (other.together.instead for other in message.answers if other.together is not None)
        instead = next((quantity for quantity in others if quantity is not None), None)
        sent = f"{instead.path} is sent instead" if instead else "they are sent as unknown"
        text = f"{owner} has {count} {source.name}, and {message.name} has room for {room}: {sent}"
        related = ((answer.covers.written.place, "the field is answered here"),)
        yield Diagnostic(place, RULE, text, None, related)
