"""References of a project's documents to criteria: "see FR-1.9", of which FR-1 has eight."""

from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.claims.ruled_out import PAST, words
from codegen.diagnostics import Diagnostic, Rule
from codegen.pattern import pattern

REFERENCE = Rule(
    "claim-reference",
    "A document refers to a criterion that its requirement document does not have, as criteria were renumbered or "
    "removed. Whoever follows it finds nothing, or, once there is one of that number, another thing.",
    remedy="write the number that the criterion has now, or leave the reference out",
)

_CITED = pattern(r"(?<![\w./-])(?P<id>[A-Z]+-[0-9a-z]+)\.(?P<number>\d{1,4})(?![\w-]|\.\d)")
_NO_LONGER = words(PAST, r"\bremoved\b", r"\bdeleted\b", r"\bgone\b", r"\bwithdrawn\b", r"\bformer\b", r"\bno longer\b")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every reference by id and number, in the text of a document, to what no program's documents have."""
    systems = reading.reference.systems
    for passage in reading.prose.passages if systems else ():
        for found in _CITED.finditer(passage.text):
            named = [each for system in systems if (each := system.requirements.get(found["id"])) is not None]
            numbers = sorted({criterion.number for each in named for criterion in each.criteria})
            low, high = passage.sentence(found.start(), found.end())
            if not numbers or int(found["number"]) in numbers or _NO_LONGER.search(passage.text, low, high):
                continue
            text = f"{found['id']} has no criterion {found['number']}"
            hint = f"its criteria are {numbers[0]} to {numbers[-1]}"
            yield reading.found(REFERENCE, passage.place_at(found.start()), found[0], text, hint)
