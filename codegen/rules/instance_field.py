"""Fields by which receivers tell instances apart."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.dialect import Kind
from codegen.model.system import PopulatedMessage, System

RULE = Rule(
    "same-instance",
    "A message is sent for several instances of a component, but the field that the dialect marks as the instance is "
    "the same in all of them: receivers would take them for one. Answer it with state: component.instance.",
)
CAN_CHANGE = Rule(
    "instance-that-changes",
    "The field that the dialect marks as the instance goes out as a quantity that can become another number. To a "
    "receiver each number is another instance: what was one sensor is several, each seen for a while. Write one "
    "number, or the instance of a component. Waive it where the quantity is set once, when the board starts.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """The instance fields of every message that exists more than once, and those of all that follow a quantity."""
    for message in system.messages:
        yield from _changing(message)
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


def _changing(message: PopulatedMessage) -> Iterator[Diagnostic]:
    """Yield each number that tells instances apart and follows a quantity of the state; a name may be a text of it."""
    for answer in message.answers:
        field = answer.covers.field
        is_number = field.definition.is_instance and field.type.kind is not Kind.CHAR
        if is_number and answer.carried and not answer.tells_apart:
            path = answer.carried[0].path
            yield Diagnostic(
                answer.covers.written.at("state"),
                CAN_CHANGE,
                f"{message.name}.{field.name} tells instances apart, and {path} can become another number",
                f"write one number, such as {{constant: 0}}, or {{state: {path.partition('.')[0]}.instance}}",
                ((field.definition.place, "the dialect marks it as the instance here"),),
            )
