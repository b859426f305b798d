"""The numbers that an answer reads when a message is built."""

from collections.abc import Iterator

from codegen.model.answers.answer import Answer
from codegen.model.answers.scaling import Scaling
from codegen.model.vehicle import Parameter, Quantity, QuantityKind


def live_numbers(answer: Answer) -> Iterator[tuple[Quantity | Parameter, Scaling]]:
    """Yield the quantities that are numbers, or the parameter, with the scaling of each."""
    sources: tuple[Quantity | Parameter, ...] = answer.carried or answer.parameters
    for source, scaling in zip(sources, answer.scalings, strict=False):
        if isinstance(source, Parameter) or source.kind is QuantityKind.NUMBER:
            yield source, scaling
