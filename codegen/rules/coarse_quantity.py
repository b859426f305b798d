"""Quantities that are kept more coarsely than a field could tell them, without a word in the table."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.system import System
from codegen.model.vehicle import Quantity, QuantityKind

RULE = Rule(
    "coarse-quantity",
    "A quantity is kept in whole units, since the table says no other 'stored' unit, and a field carries finer steps: "
    "what lies between is rounded away. Write 'stored' to say how finely it is kept, even where whole units are meant. "
    "A quantity that goes out in float fields alone, and that nothing compares, is kept as a float.",
    Severity.WARNING,
    remedy="write stored: with a finer unit, or with the unit itself if that is meant",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every field that carries a quantity which is kept in whole units, without 'stored'."""
    for message in system.messages:
        for answer in message.answers:
            for quantity in answer.carried:
                if _is_coarse(answer, quantity):
                    covers = answer.covers
                    units = covers.field.definition.units
                    finer = f"a {covers.field.type.name}{f' in {units}' if units else ''}"
                    whole = f"whole {quantity.stored.name}" if quantity.stored.name else "whole numbers"
                    yield Diagnostic(
                        quantity.spec.place,
                        RULE,
                        f"{quantity.path} is kept in {whole}, and {message.name}.{covers.label} is {finer}",
                        f"stored: {quantity.unit.name}, if whole units are meant" if quantity.unit.name else None,
                        ((covers.written.place, f"{covers.label} takes it here"),),
                    )


def _is_coarse(answer: Answer, quantity: Quantity) -> bool:
    if quantity.kind is not QuantityKind.NUMBER or quantity.spec.stored is not None or quantity.storage.is_float:
        return False
    if quantity.derivation is not None and quantity.derivation.gives:
        return False  # a sensor gives these steps: nothing lies between them
    return not answer.covers.field.type.is_integer or any(scaling.factor > 1 for scaling in answer.scalings)
