"""A correction of the project gives a number of a field or of an enum another meaning than the dialect states."""

import re
from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.findings.fingerprint import fingerprint
from codegen.model.dialect.dialect import AttributeCorrection, Dialect, Standing
from codegen.model.dialect.literals import named_number, same_number
from codegen.model.system import System
from codegen.source import Place

RULE = Rule(
    "corrected-meaning",
    "A correction replaces, or takes away, what the dialect states for unknown (invalid), the enum of a field or a "
    "parameter, or the number of an enum's entry. Whoever receives the message or sends the command goes by the "
    "dialect, and reads something else. Where the dialect is wrong, and those whom the vehicle talks to know that, "
    "waive this finding with the reason.",
    Severity.WARNING,
    remedy="leave the attribute out of the correction, or waive the finding in waivers.yaml, with the reason",
)
_STATED = ("invalid", "enum", "value")


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each correction of a message, a command or an entry that no file of the project adds."""
    dialect = system.dialect
    told: set[tuple[Place, str]] = set()
    for each in dialect.corrections:
        if each.is_shipped or each.standing is not Standing.APPLIED or each.attribute not in _STATED:
            continue
        place = _stated_at(each, dialect)
        if place is None or place.file in dialect.overlays or not each.before or _is_alike(each.text, each.before):
            continue
        if (each.place, each.attribute) not in told:  # one may be of many fields
            told.add((each.place, each.attribute))
            yield _finding(each, place)


def _stated_at(each: AttributeCorrection, dialect: Dialect) -> Place | None:
    """Return where the dialect states it: at a field, or at an entry of an enum."""
    message = dialect.messages.get(each.owner)
    if message is not None:
        field = message.field(each.part)
        return field.definition.place if field else None
    enum = dialect.enums.get(each.owner if each.attribute == "value" else "MAV_CMD")
    entry = enum.entry(each.part if each.attribute == "value" else each.owner) if enum else None
    return entry.place if entry else None


def _is_alike(new: str, old: str) -> bool:
    """Return whether both texts say the same, such as 65535 and UINT16_MAX."""
    parts = [re.split(r"([\[\],:])", text.replace(" ", "")) for text in (new, old)]
    return len(parts[0]) == len(parts[1]) and all(map(_is_same, *parts))


def _is_same(one: str, other: str) -> bool:
    number = named_number(one)
    return one == other or (number is not None and same_number(number, named_number(other)))


def _finding(each: AttributeCorrection, place: Place) -> Diagnostic:
    target = each.part if each.attribute == "value" else f"{each.owner}.{each.part}"
    becomes = f"{each.text!r} takes the place of it" if each.text else "the correction takes it away"
    text = f"{target}: the dialect says {each.attribute} {each.before!r}, and {becomes}"
    about = f"{target} {each.attribute} {each.before} {each.text}"
    related = ((place, "the dialect states it here"),)
    return Diagnostic(each.place, RULE, text, None, related, fingerprint(RULE.id, each.place.file, about))
