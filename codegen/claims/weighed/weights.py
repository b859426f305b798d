"""The weights of traits: ``weights.json``, which benchmarks/claims_weights.py computes from the corpus."""

import json
import math
import os
from collections.abc import Collection, Mapping
from functools import cache

from codegen.frozen import dataclass

FILE = os.path.join(os.path.dirname(__file__), "weights.json")


@dataclass(frozen=True, slots=True)
class Weights:
    """The logarithm of the odds that each trait adds, and the least likelihood of a finding.

    ``least`` is the least likelihood of what a rule reads as likely.
    """

    of: Mapping[str, float]
    threshold: float
    least: float


@cache
def stored_weights() -> Weights:
    """Return the weights that were computed."""
    with open(FILE, encoding="utf-8") as file:
        content = json.load(file)
    return Weights(content["weights"], content["threshold"], content["least"])


def named(kind: str, traits: Collection[str]) -> list[str]:
    """Return the names of the weights for a candidate: one for its kind, two for each of its traits."""
    return [kind, *traits, *(f"{kind}: {trait}" for trait in traits)]


def likelihood(weights: Mapping[str, float], kind: str, traits: Collection[str]) -> float:
    """Return how likely a candidate is a fault, from 0 to 1."""
    return 1 / (1 + math.exp(-sum(weights.get(name, 0.0) for name in named(kind, traits))))
