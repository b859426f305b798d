"""Stores the results of the commands about tests for docs/quality.md: benchmarks/results/quality.json."""

import json
from collections.abc import Mapping
from typing import Any

from results import FOLDER

FILE = FOLDER / "quality.json"

Found = dict[str, Any]


def read() -> dict[str, dict[str, Found]]:
    """Return what is stored, by the command and by what it was given: a seed, a program."""
    found: dict[str, dict[str, Found]] = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    return found


def store(command: str, given: str, found: Found) -> None:
    """Put what a command has found in place of what it found before, given the same."""
    known = read()
    known.setdefault(command, {})[given] = found
    FILE.write_text(json.dumps(known, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def left_by(command: str, given: str, drawing: Mapping[str, object]) -> list[list[str]]:
    """Return the faults that the stored run has not noticed; one of other faults says nothing about these."""
    stored = read().get(command, {}).get(given, {})
    if any(stored.get(key) != value for key, value in drawing.items()):
        raise SystemExit("the stored run drew other faults, or from other sources: try all of them")
    return [list(each) for each in stored["left"]]
