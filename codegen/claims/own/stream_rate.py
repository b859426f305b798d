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

_AT = pattern(
    r"(?: \(#?\d{1,5}\))?,?(?: (?:is|are|stays?|goes out|comes))?(?: (?:sent|streamed))?(?: in \w+)? (?:at|with) "
    r"(?P<rate>\d{1,4}(?:\.\d{1,3})?) ?Hz\b"
)
_EVERY = pattern(
    r"(?: \(#?\d{1,5}\))?,? (?:(?:is|are) (?:sent|streamed)|goes out|go out|comes|is to be sent)(?: out)? "
    r"(?P<said>(?P<times>once|twice|\d{1,4} times) (?:per|an?|each|every) (?P<per>second|minute|hour)"
    r"|every (?:(?P<number>\d{1,5}(?:\.\d{1,3})?|two|three|four|five|ten) ?)?(?P<unit>ms|milliseconds?|s|seconds?"
    r"|minutes?|min|hours?))\b"
)
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
            found = _AT.match(passage.text, mention.end)
            rate = Fraction(found["rate"]) if found is not None else None
            if found is None and (found := _EVERY.match(passage.text, mention.end)) is not None:
                rate = _rate(found)
            own = rates.get(mention.name, ())
            low, high = passage.sentence(mention.start, mention.end)
            if found is None or rate is None or not own or _OTHERWISE.search(passage.text, low, high):
                continue
            if rate not in own:
                shown = " or ".join(f"{decimal(each)} Hz" for each in own)
                said = f"{decimal(rate)} Hz" if rate == round(rate, 3) else found["said"]
                text = f"{mention.name} is sent at {shown}, not {said}"
                place = passage.place_at(found.start("said" if "said" in found.re.groupindex else "rate"))
                yield reading.found(RATE, place, f"{mention.name} at {said}", text)


def _rate(found: "re.Match[str]") -> Fraction | None:
    """Return in Hz what "twice per minute" and "every 500 ms" are; None for no rate."""
    if found["times"]:
        many = _COUNTS.get(found["times"].lower()) or int(found["times"].split()[0])
        return Fraction(many, _SECONDS[found["per"][0]])
    written = found["number"]
    number = Fraction(1) if written is None else Fraction(_NUMBERS.get(written, 0) or written)
    unit = Fraction(1, 1000) if found["unit"].startswith(("ms", "mill")) else Fraction(_SECONDS[found["unit"][0]])
    return 1 / (number * unit) if number else None
