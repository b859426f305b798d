"""Fields by which receivers tell instances apart."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import System

RULE = Rule(
    "same-instance",
    "A message is sent for several instances of a component, but the field that the dialect marks as the instance is "
    "the same in all of them: receivers would take them for one. Answer it with state: component.instance.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """The instance fields of every message that exists more than once."""
    for message in system.messages:
        if message.component is None or message.instances == 1:
            continue
        for answer in message.answers:
            if answer.covers.field.definition.is_instance and not answer.tells_apart:
                yield Diagnostic(
                    answer.covers.written.place,
                    RULE,
                    f"{message.instances} {message.name} messages have the same {answer.covers.field.name}",
                    f"write {{state: {message.component.name}.instance}}",
                    ((answer.covers.field.definition.place, "the dialect marks it as the instance here"),),
                )
