"""Fields by which receivers tell instances apart."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import Binding, InstanceBinding, PartBinding, System

RULE = Rule(
    "same-instance",
    "A message is sent for several instances of a component, but the field that the dialect marks as the instance is "
    "the same in all of them: receivers would take them for one. Answer it with state: component.instance.",
)


def _tells_apart(binding: Binding) -> bool:
    if isinstance(binding, PartBinding):
        return len({part.values for part in binding.values}) == len(binding.values)
    return isinstance(binding, InstanceBinding)


def check(system: System) -> Iterator[Diagnostic]:
    """The instance fields of every message that exists more than once."""
    for message in system.messages:
        if message.component is None or message.instances == 1:
            continue
        for binding in message.bindings:
            if binding.covers.field.definition.is_instance and not _tells_apart(binding):
                yield Diagnostic(
                    binding.covers.answer.place,
                    RULE,
                    f"{message.instances} {message.name} messages have the same {binding.covers.field.name}",
                    f"write {{state: {message.component.name}.instance}}",
                    ((binding.covers.field.definition.place, "the dialect marks it as the instance here"),),
                )
