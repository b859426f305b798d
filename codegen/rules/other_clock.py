"""Clocks in fields that count from another time, by their names or by the words of the dialect."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.dialect import FieldDefinition
from codegen.model.spec.population import Clock
from codegen.model.system import System
from codegen.pattern import pattern

RULE = Rule(
    "other-clock",
    "The name of a field says from when it counts, such as time_boot_ms, and the table answers it with the other "
    "clock. Receivers take the number for what the field is called: a date for the time since the start, which even "
    "wraps where the field has 32 bits, or the start of the vehicle for the first days of 1970.",
)
BY_WORDS = Rule(
    "other-clock-in-words",
    "The words of a field say from when it counts, such as 'time since system boot' or 'since UNIX epoch', and the "
    "table answers it with another clock. Where they allow both, each is right. No clock counts from 1980 or 2019, as "
    "those of GPS and of some identifiers do: keep such a time in a quantity. Waive it where the words mislead.",
    Severity.WARNING,
)
_BOOT = r"\b(?:re)?boot(?:ed)?\b"
_UNIX = r"\b(?:unix|linuxtime|1970)\b|\b1\.1\.1970"
_OTHER = r"\b(?:01/01/2019|1980)\b"


def check(system: System) -> Iterator[Diagnostic]:
    """Every answer with a clock."""
    for message in system.messages:
        for answer in message.answers:
            clock, field = answer.covers.written.clock, answer.covers.field.definition
            if clock is None:
                continue
            by_name, by_words = _named(field), _stated(field)
            what = f"{message.name}.{answer.covers.label}"
            place, related = answer.covers.written.at("clock"), ((field.place, "the dialect says so here"),)
            if by_name is not None:
                if by_name is not clock:
                    right, wrong = _words(by_name), _words(clock)
                    text = f"{what} counts from {right}, as its name says, and clock: {clock} from {wrong}"
                    yield Diagnostic(place, RULE, text, f"write {{clock: {by_name}}}", related)
            elif by_words and clock.value not in by_words:
                text = f"{what} is {_shortened(field.description)!r}, and clock: {clock} counts from {_words(clock)}"
                other = next((each for each in Clock if each.value in by_words), None)
                hint = f"write {{clock: {other}}}" if other else "keep it in a quantity: {state: component.quantity}"
                yield Diagnostic(place, BY_WORDS, text, hint, related)


def _named(field: FieldDefinition) -> Clock | None:
    """Return the clock that the name of a field says, None for none."""
    parts = field.name.lower().split("_")
    return Clock.BOOT if "boot" in parts else Clock.UNIX if "unix" in parts else None


def _stated(field: FieldDefinition) -> frozenset[str]:
    """Return the clocks that the words of a field allow, by their names, and "other"; none where they say nothing."""
    words = field.description.lower()
    ways = {"boot": _BOOT, "other": _OTHER, "unix": _UNIX}
    found = {name for name, way in ways.items() if pattern(way).search(words)}
    return frozenset(found - {"unix"} if "other" in found else found)


def _words(clock: Clock) -> str:
    return "the start" if clock is Clock.BOOT else "1970"


def _shortened(words: str) -> str:
    first = words.partition(". ")[0].rstrip(".")
    return first if len(first) <= 80 else f"{first[:77]}..."
