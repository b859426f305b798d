"""A parameter that a message carries goes out as it is: what PARAM_SET accepts, the field can carry."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.reach import smallest_and_largest
from codegen.model.system import System

RULE = Rule(
    "parameter-beyond-field",
    "A parameter can be set to what the field does not carry that it goes out in: it would be limited without a word. "
    "Narrow the range of the parameter, or give the field a 'min' or 'max' of its own in its table, which says that it "
    "is limited on purpose.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every field that a parameter is scaled into."""
    for message in system.messages:
        for answer in message.answers:
            written = answer.covers.written
            if written.parameter is None or not answer.scalings or not answer.parameters:
                continue
            parameter = answer.parameters[0]
            low, high = smallest_and_largest(answer, answer.scalings[0])
            is_below = written.min is None and parameter.minimum < low
            is_above = written.max is None and parameter.maximum > high
            if is_below or is_above:
                end, limit = (parameter.minimum, low) if is_below else (parameter.maximum, high)
                unit = parameter.unit.name
                shown = f"{float(end * parameter.step):g} {unit}".rstrip()
                yield Diagnostic(
                    written.at("parameter"),
                    RULE,
                    f"{parameter.name} can be {shown}, {answer.covers.label} carries no "
                    f"{'less' if is_below else 'more'} than {float(limit * parameter.step):g}",
                    None,
                    ((parameter.spec.place, f"{parameter.name} is declared here"),),
                )
