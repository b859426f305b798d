"""The section of docs/conformance.md about population."""

import importlib
from collections.abc import Callable, Collection, Sequence

from population.comparing import Outcome
from population.fields import Message, read_messages
from population.running import FORMS
from population.whole import INCLUDED, KNOWN, LARGEST, included

TEXT = """## Population

Every field of every message of {largest}, with those of {included}, is answered from a quantity of a unit that fits, in
projects that are written as a user would (`benchmarks/population/`), from the XML as pymavlink reads it. Their firmware
is built, and run in three forms: {forms}. pymavlink decodes each frame, and each value is compared
with what was set, by exact arithmetic: whole numbers exactly, floats with the nearest one. pymavlink packs these values
into the same bytes. `tests/population/` does so with a choice of messages in which every type, sentinel, unit,
multiplier, limit and kind of enum occurs.

{table}

{count} values were compared in each form, in {frames} frames; in {withheld} cases nothing had to go out, and
nothing did. {differences}

{varies}

{unsaid}

A limit of a quantity between two steps of a field is rounded as the values are, one of the table is the step inside. A
number that would read as the sentinel goes out as the step beside it; the entry of an enum that is the sentinel goes
out as it is.
"""


VARIES = {
    "the answer": "numbers, texts, enums, bitmasks as numbers and by booleans, both clocks, lists, element by element",
    "its unit": "that of the field, another one (deg for degE7, km/h for m/s), with the dialect's multiplier",
    "what is kept": "whole steps of the field, finer ones with each rounding, floats, thousandths for them",
    "its limits": "those of the type, of the dialect (`minValue`), and `min` and `max` of quantity and table",
    "unknown": "the sentinel, by `invalid` or by the dialect's words, `initial`, `send: while_known`",
    "what is set": "through both attributes: the ends, beside and far beyond them, None, NaN, infinities, denormals,"
    " the sentinel, random values; nothing for more than a second (`stale_after`)",
}
"""The properties that are drawn by lot for each element of each field."""


def section(outcome: Outcome, table: Callable[[Sequence[Sequence[str]], Sequence[int]], str]) -> str:
    """The text; ``table`` makes a table of Markdown of rows."""
    messages = read_messages(LARGEST, importlib.import_module(f"pymavlink.dialects.v20.{LARGEST}"))
    head = ["dialect", "messages", "fields", "proven", "texts", "refused", "values", "frames", "withheld"]
    rows = [_row(INCLUDED, included(messages), messages, outcome), _row(LARGEST, messages, messages, outcome)]
    lines = [f"- {label}: `{rule}`" for label, rule in sorted(KNOWN.items())]
    return TEXT.format(
        largest=LARGEST,
        included=INCLUDED,
        forms=", ".join(FORMS),
        table=table([head, *rows], (0,)),
        varies=table([["what varies", "in which ways"], *([key, text] for key, text in VARIES.items())], (0, 1)),
        count=f"{sum(outcome.values.values()):,}",
        frames=f"{sum(outcome.frames.values()):,}",
        withheld=f"{sum(outcome.withheld.values()):,}",
        differences="\n".join(["These differ:", "", *(f"- {each}" for each in outcome.differences)])
        if outcome.differences
        else "Nothing differs.",
        unsaid="\n".join(["No quantity answers:", "", *lines])
        if lines
        else "There is no field that no quantity answers.",
    )


def _row(dialect: str, names: Collection[str], messages: dict[str, Message], outcome: Outcome) -> list[str]:
    """A field of several elements is proven when all of them are."""
    fields = [field for name in names for field in messages[name].fields]
    labels = [(f"{field.message}.{field.name}", field) for field in fields]
    unsaid = {label.partition("[")[0] for label in outcome.refused}
    texts = sum(label in outcome.texts for label, _ in labels)
    refused = sum(label in unsaid for label, _ in labels)
    proven = {label.partition("[")[0] for label in outcome.proven} - unsaid
    numbers = (
        len(names),
        len(fields),
        sum(label in proven for label, _ in labels),
        texts,
        refused,
        *(sum(counts[name] for name in names) for counts in (outcome.values, outcome.frames, outcome.withheld)),
    )
    return [dialect, *(f"{number:,}" for number in numbers)]
