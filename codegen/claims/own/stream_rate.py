"""Rates at which a project's own documents say that its messages are sent: "HEARTBEAT is sent at 1 Hz"."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import PassageKind
from codegen.model.units.unit import decimal
from codegen.pattern import pattern

RATE = Rule(
    "claim-rate",
    "A document says that a message is sent at another rate than its stream has at first. Correct the one that is out "
    "of date.",
    remedy="write the rate of the stream, or change it in streams.yaml",
)

_ID = r"(?: \(#?\d{1,5}\))?,?"
_HOW = "(?: (?:always|normally|periodically|regularly|continuously))?"
_SENT = (
    r"(?P<sent>(?: (?:shall|must|will|should|has to|have to|is to|are to))?"
    rf"(?: (?:be|is|are|stays?|remains?|goes|go|comes?))?{_HOW}"
    rf"(?: (?:sent|streamed|transmitted|emitted|broadcast|published|repeated))?(?: out)?{_HOW})"
)
_TELLS = r"(?P<tells> (?:carries|tells|reports|gives|contains)(?: [a-z`_.]+){1,6}?)"
_WHERE = (
    r"(?: (?:in|on|over|by|to|via|through) (?:(?:the|each|every|all) )?"
    r"[\w.-]+(?: (?:link|port|stream|station))?){0,2}?,?"
)
_LEAST = r"(?P<least> at least)?"
_AT = pattern(
    rf"{_ID}(?:{_SENT}|{_TELLS}){_WHERE} (?:at|with)(?: (?:an?|the) (?:\w+ )?(?:rate|frequency) of)?{_LEAST} "
    r"(?P<rate>\d{1,4}(?:\.\d{1,3})?) ?Hz\b"
)
_EVERY = pattern(
    rf"{_ID}(?:{_SENT}|{_TELLS}){_WHERE}{_LEAST} "
    r"(?P<said>(?P<times>once|twice|\d{1,4} times) (?:per|an?|each|every) (?P<per>second|minute|hour)"
    r"|(?:every|each) (?:(?P<number>\d{1,5}(?:\.\d{1,3})?|two|three|four|five|ten) ?)?"
    r"(?P<unit>ms|milliseconds?|s|seconds?|minutes?|min|hours?))\b"
)
_SENDS = pattern(r"\b(?:sends?|streams?|transmits?|emits?|broadcasts?|publish(?:es)?|repeats?) (?:an?|the)? ?[`*]*$")
_COUNTS = {"once": 1, "twice": 2}
_NUMBERS = {"two": 2, "three": 3, "four": 4, "five": 5, "ten": 10}
_SECONDS = {"m": 60, "h": 3600, "s": 1}
_OTHERWISE = pattern(
    r"\b(?:if|when|would|could|asks?|asked|up to|at most|instead|from|bytes?|receives?)\b", re.IGNORECASE
)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every rate directly behind a message that the project sends."""
    rates = reading.reference.rates
    for passage, mentions in reading.passages_with_messages() if rates else ():
        for mention in mentions if passage.kind is not PassageKind.ROW else ():
            own = rates.get(mention.name, ())
            low, high = passage.sentence(mention.start, mention.end)
            found = _stated(passage.text, mention.start, mention.end) if own else None
            rate = _rate(found) if found is not None else None
            if found is None or rate is None or _OTHERWISE.search(passage.text, low, high):
                continue
            if (max(own) < rate) if found["least"] else (rate not in own):
                shown = " or ".join(f"{decimal(each)} Hz" for each in own)
                said = f"{decimal(rate)} Hz" if rate == round(rate, 3) else found["said"]
                text = f"{mention.name} is sent at {shown}, {'less than' if found['least'] else 'not'} {said}"
                place = passage.place_at(found.start("said" if "said" in found.re.groupindex else "rate"))
                yield reading.found(RATE, place, f"{mention.name} at {said}", text)


def _stated(text: str, start: int, end: int) -> "re.Match[str] | None":
    """Return the rate behind a name: in Hz, or how often, where something is said to be sent."""
    if (found := _AT.match(text, end)) is not None:
        return found
    found = _EVERY.match(text, end)
    if found is None or found["sent"] or found["tells"] or _SENDS.search(text, max(0, start - 30), start):
        return found
    return None


def _rate(found: "re.Match[str]") -> Fraction | None:
    """Return in Hz what "3 Hz", "twice per minute" and "every 500 ms" are; None for no rate."""
    if "rate" in found.re.groupindex:
        return Fraction(found["rate"])
    if found["times"]:
        many = _COUNTS.get(found["times"].lower()) or int(found["times"].split()[0])
        return Fraction(many, _SECONDS[found["per"][0]])
    written = found["number"]
    number = Fraction(1) if written is None else Fraction(_NUMBERS.get(written, 0) or written)
    unit = Fraction(1, 1000) if found["unit"].startswith(("ms", "mill")) else Fraction(_SECONDS[found["unit"][0]])
    return 1 / (number * unit) if number else None
