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

_ID = r"(?: \((?:#|ID:? ?#?|id |message )?\d{1,8}(?:, ?[^()]{1,40})?\))?,?"
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
_HZ = r"(?P<rate>\d{1,4}(?:\.\d{1,3}|,\d{1,2}(?!\d))?) ?Hz\b"
_AT = pattern(
    rf"{_ID}(?:{_SENT}|{_TELLS}){_WHERE} (?:at|with)(?: (?:an?|the) (?:\w+ )?(?:rate|frequency) of)?{_LEAST} {_HZ}"
)
_IS = pattern(rf"{_ID}(?:(?: rate| frequency)(?: is| of|:| =)?|:|,| =| \() ?{_HZ}(?=[.,;)]| \(|$)")
_RATE_OF = pattern(r"\b(?:rate|frequency) of (?:the )?[`*]*$", re.IGNORECASE)
_IS_AT = pattern(rf"{_ID}[`*]*(?: (?:is|shall be|must be|has to be)|:| =) {_HZ}")
_NUMBERS = {
    "one": 1,
    "two": 2,
    "three": 3,
    "four": 4,
    "five": 5,
    "six": 6,
    "seven": 7,
    "eight": 8,
    "nine": 9,
    "ten": 10,
    "twelve": 12,
    "fifteen": 15,
    "twenty": 20,
    "thirty": 30,
    "fifty": 50,
}
_WORDS = "|".join(_NUMBERS)
_TIMES = (
    rf"(?P<times>once|twice|(?:\d{{1,4}}|{_WORDS}) times) (?:per|an?|each|every) (?P<per>second|minute|hour)"
    rf"|(?:every|each) (?:(?P<number>\d{{1,5}}(?:\.\d{{1,3}}|,\d{{1,2}}(?!\d))?|{_WORDS}) ?)?"
    r"(?P<unit>ms|milliseconds?|s|seconds?|minutes?|min|hours?)"
)
_PERIOD = (
    r"(?:with|at|in) (?:an?|the)? ?(?:\w+ )?(?:period|interval)s? of "
    rf"(?P<period>\d{{1,5}}(?:\.\d{{1,3}}|,\d{{1,2}}(?!\d))?|{_WORDS}) ?"
    r"(?P<period_unit>ms|milliseconds?|s|seconds?|minutes?|min|hours?)"
)
_EVERY = pattern(rf"{_ID}(?:{_SENT}|{_TELLS}){_WHERE}{_LEAST} (?P<said>{_TIMES}|{_PERIOD})\b")
_SENDS = pattern(r"\b(?:sends?|streams?|transmits?|emits?|broadcasts?|publish(?:es)?|repeats?) (?:an?|the)? ?[`*]*$")
_AHEAD = pattern(
    rf"(?:^|[.;:] )(?P<said>(?P<least>)?(?i:at {_HZ}|{_TIMES}|{_PERIOD})),? (?:the |an? )?(?:message )?[`*]*$"
)
_THEN_SENT = pattern(
    rf"{_ID}[`*]* (?:(?:shall|must|will|should|has to|is to) (?:be )?)?"
    r"(?:is |are )?(?:sent|streamed|transmitted|emitted|broadcast|published|goes out)\b"
)
_COUNTS = {"once": 1, "twice": 2}
SECONDS = {"m": 60, "h": 3600, "s": 1}
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
            groups = found.groupdict()
            if (max(own) < rate) if groups.get("least") else (rate not in own):
                shown = " or ".join(f"{decimal(each)} Hz" for each in own)
                said = f"{decimal(rate)} Hz" if rate == round(rate, 3) else found["said"]
                text = f"{mention.name} is sent at {shown}, {'less than' if groups.get('least') else 'not'} {said}"
                place = passage.place_at(found.start("said" if groups.get("said") else "rate"))
                yield reading.found(RATE, place, f"{mention.name} at {said}", text)


def _stated(text: str, start: int, end: int) -> "re.Match[str] | None":
    """Return the rate behind a name, or in front of it: in Hz, or how often, where something is said to be sent."""
    for form in (_AT, _IS):
        if (found := form.match(text, end)) is not None:
            return found
    low = max(0, start - 80)
    if _RATE_OF.search(text, low, start) and (found := _IS_AT.match(text, end)) is not None:
        return found
    if (found := _AHEAD.search(text, low, start)) is not None and _THEN_SENT.match(text, end):
        return found
    found = _EVERY.match(text, end)
    if found is None or found["sent"] or found["tells"] or _SENDS.search(text, max(0, start - 30), start):
        return found
    return None


def _rate(found: "re.Match[str]") -> Fraction | None:
    """Return in Hz what "3 Hz", "twice per minute" and "every 500 ms" are; None for no rate."""
    said = found.groupdict()
    if said.get("rate"):
        return _number(said["rate"])
    if said["times"]:
        word = said["times"].lower()
        return Fraction(_COUNTS.get(word) or _number(word.split()[0]), SECONDS[said["per"][0].lower()])
    written, named = said["period"] or said["number"], (said["period_unit"] or said["unit"]).lower()
    return rate_of(Fraction(1) if written is None else _number(written), named)


def rate_of(number: Fraction, unit: str) -> Fraction | None:
    """Return in Hz what comes once in a time, such as 500 ms, 2 s or 1 min; None for no time."""
    seconds = Fraction(1, 1000) if unit.startswith(("ms", "mill")) else Fraction(SECONDS[unit[0]])
    return 1 / (number * seconds) if number else None


def _number(written: str) -> Fraction:
    return Fraction(_NUMBERS.get(written.lower()) or written.replace(",", "."))
