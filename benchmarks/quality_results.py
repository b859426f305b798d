"""What the commands about tests have found, stored for docs/quality.md: benchmarks/results/quality.json."""

import json
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
