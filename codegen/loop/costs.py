"""The measured cost of each part of a pass: ``costs.json``, which benchmarks/loop.py writes."""

import json
import os
from collections.abc import Mapping
from functools import cache

from codegen.frozen import dataclass
from codegen.loop.parts import Part, Work

FILE = os.path.join(os.path.dirname(__file__), "costs.json")


@dataclass(frozen=True, slots=True)
class Fit:
    """The quality of fitted costs: the largest ``error``, as a share, among the ``rows`` of measurements."""

    of: str
    rows: int
    error: float


@dataclass(frozen=True, slots=True)
class Costs:
    """Instructions of MicroPython's unix port on x86-64 for each part, and the fits that they come from."""

    parts: Mapping[Part, int]
    fits: tuple[Fit, ...]
    micropython: str

    def instructions(self, work: Work) -> int:
        """Return the instructions that some work takes."""
        return sum(count * self.parts[part] for part, count in work.items() if part is not Part.CONVERSION)


@cache
def measured_costs() -> Costs:
    """Return the costs that were measured."""
    with open(FILE, encoding="utf-8") as file:
        content = json.load(file)
    parts = {Part(name): count for name, count in content["parts"].items()}
    fits = tuple(Fit(fit["of"], fit["rows"], fit["error"]) for fit in content["fits"])
    return Costs(parts, fits, content["micropython"])
