"""A correction of the project gives a field or a parameter another unit than the dialect states."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.findings.fingerprint import fingerprint
from codegen.model.dialect.dialect import AttributeCorrection, Standing
from codegen.model.dialect.literals import exact_number
from codegen.model.system import System
from codegen.model.units.unit import Unit, conversion, ratio, shortly
from codegen.source import Place

RULE = Rule(
    "corrected-unit",
    "A correction replaces a unit or a multiplier that the dialect states, or takes it away. Whoever receives the "
    "message or sends the command goes by the dialect, and reads another value than is meant. Where the dialect is "
    "wrong, and those whom the vehicle talks to know that, waive this finding with the reason.",
    Severity.WARNING,
    remedy="leave the attribute out of the correction, or waive the finding in waivers.yaml, with the reason",
)
_STATED = ("units", "multiplier")


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each correction of a message or a command that no overlay of the project adds."""
    added = {message.name for message in system.dialect.added_messages()}
    told: set[tuple[Place, str]] = set()
    for each in system.dialect.corrections:
        if each.is_shipped or each.standing is not Standing.APPLIED or each.owner in added:
            continue
        if each.attribute not in _STATED or not each.before or _is_alike(each):
            continue
        if (each.place, each.attribute) not in told:  # one may be of many fields
            told.add((each.place, each.attribute))
            yield _finding(each, system)


def _is_alike(each: AttributeCorrection) -> bool:
    """Return whether both texts say the same."""
    if each.attribute == "multiplier":
        return exact_number(each.text) == exact_number(each.before or "")
    new, old = Unit.parse(each.text), Unit.parse(each.before)
    found = conversion(new, old) if new and old else None
    return found is not None and found.factor == 1 and found.offset == 0


def _finding(each: AttributeCorrection, system: System) -> Diagnostic:
    message = system.dialect.messages.get(each.owner)
    field = message.field(each.part) if message else None
    target = f"{each.owner}.{each.part}" if field else f"{each.owner} {each.part}"
    becomes = f"{each.text!r} takes the place of it" if each.text else "the correction takes it away"
    related = ((field.definition.place, "the dialect states it here"),) if field else ()
    text = f"{target}: the dialect says {each.attribute} {each.before!r}, and {becomes}{_off(each)}"
    about = f"{target} {each.attribute} {each.before} {each.text}"
    return Diagnostic(each.place, RULE, text, None, related, fingerprint(RULE.id, each.place.file, about))


def _off(each: AttributeCorrection) -> str:
    """Return how much that is off to who goes by the dialect; nothing where it is no factor."""
    new, old = Unit.parse(each.text), Unit.parse(each.before)
    if each.attribute != "units" or new is None or old is None:
        return ""
    factor = ratio(new, old)
    if factor is None:
        return "" if conversion(new, old) is not None else f", which is {new.a_kind} and not {old.a_kind}"
    return f": to others it is {shortly(1 / factor)} times as much"
