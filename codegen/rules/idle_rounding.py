"""Roundings of tables that round nothing: what they are given was rounded before, or is a float."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.findings.fingerprint import fingerprint
from codegen.model.answers.answer import Answer
from codegen.model.reception import ReceivedField
from codegen.model.spec.population import Rounding
from codegen.model.system import System

RULE = Rule(
    "idle-rounding",
    "A table says down, up or toward_zero where nothing is rounded: a float field carries what lies between, and where "
    "each step that is kept is a whole number of the field's, a value was rounded when it was kept, to the nearest "
    "step. So it is with what is received and kept in steps that the field's are whole numbers of, or as a float.",
    Severity.WARNING,
    remedy="leave it out, or keep the value more finely (stored, or step of a parameter)",
)
_HINT = "leave it out"


def check(system: System) -> Iterator[Diagnostic]:
    """Every field that is sent or received with a rounding of its own."""
    for message in system.messages:
        for answer in message.answers:
            if answer.covers.written.rounding is not Rounding.NEAREST:
                yield from _sent(answer, message.name)
    for table in system.receptions:
        for taken in table.fields:
            if taken.spec.rounding is not Rounding.NEAREST:
                yield from _received(taken, table.wire.name)


def _sent(answer: Answer, message: str) -> Iterator[Diagnostic]:
    """Yield the rounding of a field that carries whatever is kept as it is."""
    covers, factors = answer.covers, [scaling.factor for scaling in answer.scalings]
    is_float = not covers.field.type.is_integer
    if not factors or not (is_float or all(factor.denominator == 1 for factor in factors)):
        return
    paths = [*(each.path for each in answer.quantities), *(each.path for each in answer.parameters)]
    names = " and ".join(dict.fromkeys(paths))
    why = f"it is a {covers.field.type.name}" if is_float else f"each step of {names} is a whole number there"
    hint = _HINT if is_float else f"{_HINT}, or keep {names} more finely"
    place, text = covers.written.at("rounding"), f"nothing is rounded in {message}.{covers.label}: {why}"
    yield Diagnostic(place, RULE, text, hint, fingerprint=fingerprint(RULE.id, place.file, covers.label))


def _received(taken: ReceivedField, message: str) -> Iterator[Diagnostic]:
    """Yield the rounding of a field that is kept as it comes."""
    is_float = taken.quantity.storage.is_float
    if not is_float and taken.factor.denominator != 1:
        return
    why = "kept as a float" if is_float else "a whole number of the steps that are kept"
    place, text = taken.spec.at("rounding"), f"nothing is rounded of {message}.{taken.label}: it is {why}"
    yield Diagnostic(place, RULE, text, _HINT, fingerprint=fingerprint(RULE.id, place.file, taken.label))
