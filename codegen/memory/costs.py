"""The heap that each part of a program takes: ``costs.json``, which benchmarks/memory.py measures and writes."""

import json
import os
from collections.abc import Mapping
from fractions import Fraction
from functools import cache

from codegen.frozen import dataclass
from codegen.memory.parts import Counts, Part

FILE = os.path.join(os.path.dirname(__file__), "costs.json")

Bytes = Mapping[Part, Fraction]
"""Bytes for each part."""


@dataclass(frozen=True, slots=True)
class Costs:
    """Bytes of each part in plain Python, and what machine code takes more, by the architecture.

    ``error`` is the largest of the ``programs`` that they were fitted to, as a share of what each takes.
    """

    plain: Bytes
    machine_code: Mapping[str, Bytes]
    error: Fraction
    programs: int

    def more(self, architecture: str) -> Bytes:
        """Return what machine code takes more; of an architecture that was not measured the most that is known."""
        known = self.machine_code.get(architecture)
        return known or {part: max(each[part] for each in self.machine_code.values()) for part in Part}


def bytes_of(costs: Bytes, counts: Counts) -> int:
    """Return the bytes that so many parts take."""
    return round(sum((costs[part] * count for part, count in counts.items()), Fraction(0)))


@cache
def measured_costs() -> Costs:
    """Return the costs that were measured."""
    with open(FILE, encoding="utf-8") as file:
        content = json.load(file)
    return Costs(
        _of_parts(content["plain"]),
        {architecture: _of_parts(costs) for architecture, costs in content["machine_code"].items()},
        Fraction(str(content["error"])),
        content["programs"],
    )


def _of_parts(written: Mapping[str, float]) -> Bytes:
    return {part: Fraction(str(written.get(part.value, 0))) for part in Part}  # one that is new waits to be measured
