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
)

_AT = pattern(
    r"(?: \(#?\d{1,5}\))?,?(?: (?:is|are|stays?|goes out|comes))?(?: (?:sent|streamed))?(?: in \w+)? (?:at|with) "
    r"(?P<rate>\d{1,4}(?:\.\d{1,3})?) ?Hz\b"
)
_OTHERWISE = pattern(
    r"\b(?:if|when|would|could|asks?|asked|up to|at most|instead|from|bytes?|receives?)\b", re.IGNORECASE
)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every rate directly behind a message that the project sends."""
    rates = reading.reference.rates
    for passage, mentions in reading.passages_with_messages() if rates else ():
        for mention in mentions if passage.kind is not PassageKind.ROW else ():
            found = _AT.match(passage.text, mention.end)
            own = rates.get(mention.name, ())
            low, high = passage.sentence(mention.start, mention.end)
            if found is None or not own or _OTHERWISE.search(passage.text, low, high):
                continue
            if Fraction(found["rate"]) not in own:
                shown = " or ".join(f"{decimal(each)} Hz" for each in own)
                text = f"{mention.name} is sent at {shown}, not {found['rate']} Hz"
                place = passage.place_at(found.start("rate"))
                yield reading.found(RATE, place, f"{mention.name} at {found['rate']} Hz", text)
