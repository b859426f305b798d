# ruff: noqa: T201  what is printed is the answer
"""Weighs what stands around statements that no rule reads for certain: the weights of codegen/claims/weighed.

    python benchmarks/claims_weights.py [--store]

Candidates are all pairs of a field and something in its reach that contradicts the dialect, in the documents of
tests/claims/corpus; one is right where a fault of its kind and field is labelled in its line. Those in the documents of
this repository, and of claims_asides.yaml, which count less, are wrong. Their traits are weighed by
logistic regression. What is printed was weighed without the folders that it is told of, and without those of the same
writer: for some thresholds how many further faults are found, and how many of the further findings are right and
wrong, beside all that the rules find today. --store computes the weights from all folders and keeps them.
"""

import argparse
import json
import math
import sys
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from claims_phrasings import ASIDES, phrasings, twins
from claims_score import documents, is_about, judged, reference, rules_find
from phrasing.filling import reference as common

from codegen.claims.reading import read_document
from codegen.claims.weighed.candidates import Candidate, candidates
from codegen.claims.weighed.likely import chosen
from codegen.claims.weighed.weights import FILE, likelihood, named
from codegen.claims.weighed.words import MARK
from codegen.commands.documents import project_reference
from codegen.diagnostics import Diagnostic, Report
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[1]

WRITERS = (
    ("seen-1", "seen-2", "seen-3"), ("seen-4", "seen-5"), ("seen-6", "seen-7"), ("seen-8", "seen-9"),
    ("seen-10", "seen-11"), ("seen-12", "seen-13"), ("seen-14", "seen-15"), ("seen-16", "seen-17"),
    ("seen-18", "seen-19"), ("seen-20", "seen-21"), ("seen-22",), ("seen-23",), ("seen-24",), ("seen-25",),
)  # fmt: skip
"""Folders that are left out together: those of one writer, at least."""
OWN = "documents of this repository"
NO_CLAIMS = "sentences that are no claims"
_WITH_FAULTS = frozenset(("claims.md",))
"""Documents that quote what is wrong."""
RECENT = tuple(f"seen-{number}" for number in range(16, 26))
THRESHOLDS = (0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6, 0.55, 0.5, 0.4, 0.3)
THRESHOLD = 0.8
"""The least likelihood of a candidate that is told, from 0 to 1."""
LEAST = 0.004
"""The least likelihood of what a rule reads as likely."""
_KINDS: Mapping[str, frozenset[str]] = {
    "unit": frozenset(("unit", "multiplier", "other", "encoding", "encoded")),
    "type": frozenset(("type", "array-length", "array", "size", "length")),
    "length": frozenset(("array-length", "array", "length", "size", "type", "other", "payload")),
    "sentinel": frozenset(("sentinel", "value", "other", "enum-value")),
    "factor": frozenset(("multiplier", "unit", "encoded", "other")),
    "factor of none": frozenset(("multiplier", "unit", "encoded", "other")),
    "enum": frozenset(("enum-value", "enum", "enum-name", "other", "sentinel")),
    "sense": frozenset(("sign", "sense", "order", "other", "frame", "unit", "sentinel", "range")),
    "no field": frozenset(("no-field", "field-name", "name")),
    "range": frozenset(("range", "other")),
    "encoded": frozenset(("encoded", "example", "multiplier", "value", "other", "unit")),
    "place": frozenset(("offset", "order")),
    "extension": frozenset(("extension", "other")),
    "unit of none": frozenset(("unit", "multiplier", "other", "encoding")),
    "type of none": frozenset(("type", "size", "length")),
    "sentinel of none": frozenset(("sentinel", "value", "other")),
    "parameter unit": frozenset(("command", "unit", "other", "multiplier", "command-param", "param")),
    "parameter value": frozenset(("command", "enum-value", "enum", "other", "sign", "command-param", "param")),
    "parameter label": frozenset(("command", "command-param", "param", "other")),
    "length of none": frozenset(("array-length", "array", "length", "size", "other")),
    "special": frozenset(("sentinel", "value", "other", "enum-value", "range")),
    "no message": frozenset(("no-message", "message-name", "name")),
    "way": frozenset(("sign", "sense", "order", "other", "frame", "unit", "range", "meaning")),
    "id": frozenset(("id",)),
    "crc": frozenset(("crc", "crc-extra")),
    "size": frozenset(("payload", "frame", "length", "size", "other")),
    "meaning": frozenset(("enum-value", "enum", "enum-name", "other", "sentinel")),
}
"""The kinds of labels that a candidate of each kind is right for."""
_RIGHT_AND_TOLD = 0.5
"""The weight of a candidate that is right and that a rule tells of: there are many, and they are the easy ones."""
_OF_OWN_DOCUMENTS = 0.2
"""The weight of a candidate of this repository's documents, which are of one kind."""
_OF_ASIDES = 0.3
"""The weight of a candidate of a sentence that is no claim: each is there with several messages."""
_EACH = 3
"""The number of messages that fill such a sentence."""
_FOLDERS = 5
"""The least number of folders in which a word stands beside a candidate, for it to have a weight."""
_PENALTY = 3.0
"""The penalty for large weights."""
_ROUNDS = 80
_SMALLEST = 0.01
"""Weights below it are not kept."""

Fault = dict[str, Any]


@dataclass(frozen=True)
class Example:
    """A candidate of the corpus: in which folder and document, and whether it is right, and told by a rule."""

    folder: str
    path: Path
    candidate: Candidate
    is_right: bool
    is_told: bool

    @property
    def names(self) -> list[str]:
        """The names of the weights that count for it."""
        return named(self.candidate.kind, self.candidate.traits)


def examples(folders: Iterable[str]) -> list[Example]:
    """Return all candidates of some folders."""
    found = []
    for folder in folders:
        for path, faults in documents(folder):
            told = rules_find(path)
            for each in candidates(read_document(path.read_text(), str(path), reference())):
                is_told = not list(chosen([(1.0, each)], told))
                found.append(Example(folder, path, each, _is_right(each, faults), is_told))
    return found


def of_own_documents() -> list[Example]:
    """Return the candidates in the documents of this repository, all of which are wrong: what they say is tested."""
    systems = read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())
    compared_with = project_reference(systems)
    assert compared_with is not None
    found = []
    folders = (ROOT / "docs", ROOT / "specs", ROOT / "generated" / "docs")
    for path in (ROOT / "README.md", *(path for folder in folders for path in sorted(folder.rglob("*.md")))):
        if path.name not in _WITH_FAULTS:
            for each in candidates(read_document(path.read_text(), str(path), compared_with)):
                found.append(Example(OWN, path, each, is_right=False, is_told=False))
    return found


def of_asides() -> list[Example]:
    """Return the candidates in sentences that are no claims, all of which are wrong."""
    found = []
    for kind in phrasings(ASIDES):
        for each in twins(kind, _EACH, path=ASIDES):
            for candidate in candidates(read_document(each.wrong, "/aside.md", common())):
                found.append(Example(NO_CLAIMS, ASIDES, candidate, is_right=False, is_told=False))
    return found


def without_rare_words(those: Iterable[Example], of: Iterable[Example]) -> list[Example]:
    """Return examples without the words that too few folders of others have beside a candidate."""
    folders: dict[str, set[str]] = {}
    for each in of:
        for trait in each.candidate.traits:
            folders.setdefault(trait, set()).add(each.folder)
    common_words = {trait for trait, where in folders.items() if len(where) >= _FOLDERS}

    def kept(one: Candidate) -> Candidate:
        return replace(one, traits=frozenset(t for t in one.traits if not t.startswith(MARK) or t in common_words))

    return [replace(each, candidate=kept(each.candidate)) for each in those]


def _is_right(candidate: Candidate, faults: Iterable[Fault]) -> bool:
    """Return whether a fault of the kind and the field of a candidate is labelled in its line."""
    return any(
        fault["line"] == candidate.finding.place.line
        and fault["kind"] in _KINDS[candidate.kind]
        and _is_of(candidate, fault)
        for fault in faults
    )


def _is_of(candidate: Candidate, fault: Fault) -> bool:
    if candidate.kind == "no field" and candidate.field in str(fault["claimed"]):
        return True
    if candidate.kind == "no message":
        return bool(fault["claimed"] and str(fault["claimed"]).strip("`") in candidate.finding.message)
    if candidate.kind.endswith(" of none") or candidate.kind == "parameter label":
        return bool(fault["message"] == candidate.message)
    if not candidate.field:
        return bool(fault["message"] == candidate.message)
    if not fault["field"]:
        return candidate.kind != "no field" and fault["message"] in (None, candidate.message)
    one, other = fault["field"].partition("[")[0], candidate.field
    return bool(one.startswith(other) or other.startswith(one))


def _counts(example: Example) -> float:
    """Return how much an example counts."""
    if example.folder in (OWN, NO_CLAIMS):
        return _OF_OWN_DOCUMENTS if example.folder == OWN else _OF_ASIDES
    return _RIGHT_AND_TOLD if example.is_right and example.is_told else 1.0


def weighed(those: Sequence[Example]) -> dict[str, float]:
    """Return the weights by logistic regression: steps grow as long as the slope keeps its sign (Rprop)."""
    index: dict[str, int] = {}
    rows = [[index.setdefault(name, len(index)) for name in sorted(each.names)] for each in those]
    count = [_counts(each) for each in those]
    weights, steps, last = [0.0] * len(index), [0.05] * len(index), [0.0] * len(index)
    for _ in range(_ROUNDS):
        slopes = [_PENALTY * weight for weight in weights]
        for row, of, each in zip(rows, count, those, strict=True):
            odds = sum(weights[at] for at in row)
            error = of * (1 / (1 + math.exp(-max(min(odds, 30.0), -30.0))) - each.is_right)
            for at in row:
                slopes[at] += error
        for at, slope in enumerate(slopes):
            turned = slope * last[at]
            if turned > 0:
                steps[at] = min(steps[at] * 1.2, 1.0)
            elif turned < 0:
                steps[at] *= 0.5
            last[at] = 0.0 if turned < 0 else slope
            weights[at] -= math.copysign(steps[at], last[at]) if last[at] else 0.0
    return {name: weights[at] for name, at in index.items()}


@dataclass(frozen=True)
class Gain:
    """The gain by further findings: faults that only they find, findings that are right, and those that are wrong."""

    found: int
    right: int
    wrong: int


def gain(
    weighted: Sequence[tuple[float, Example]], folders: Collection[str], told: Callable[[Path], Sequence[Diagnostic]]
) -> Gain:
    """Return what candidates with their likelihoods add to what is told of each document of some folders."""
    found = right = wrong = 0
    by_path: dict[Path, list[tuple[float, Candidate]]] = {}
    for likely, each in weighted:
        by_path.setdefault(each.path, []).append((likely, each.candidate))
    for folder in folders:
        for path, faults in documents(folder):
            before = told(path)
            further = [each.finding for each in chosen(by_path.get(path, ()), before)]
            found += len(judged([*before, *further], faults)[2]) - len(judged(before, faults)[2])
            are_right = [any(is_about(finding, fault) for fault in faults) for finding in further]
            right += sum(are_right)
            wrong += len(are_right) - sum(are_right)
    return Gain(found, right, wrong)


def main() -> int:
    """Print what carries over to folders that were left out, and store the weights from all of them if asked to."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--store", action="store_true", help="compute the weights from all folders and keep them")
    arguments = parser.parse_args()
    every = [folder for group in WRITERS for folder in group]
    those = examples(every)
    own, asides = of_own_documents(), of_asides()
    right = sum(each.is_right for each in those)
    print(f"{len(those)} candidates, {right} of them right; {len(own)} in {OWN}, {len(asides)} in {NO_CLAIMS}")
    own, asides, those = (without_rare_words(each, those) for each in (own, asides, those))
    left_out: list[tuple[float, Example]] = []
    for group in WRITERS:
        weights = weighed([*own, *asides, *(each for each in those if each.folder not in group)])
        left_out += [
            (likelihood(weights, each.candidate.kind, each.candidate.traits), each)
            for each in those
            if each.folder in group
        ]
    for title, folders in (("all folders", every), ("seen-16 to seen-25", RECENT)):
        faults = sum(len(faults) for folder in folders for _, faults in documents(folder))
        print(f"{title}, {faults} faults, each with weights from the others:")
        for threshold in THRESHOLDS:
            one = gain([each for each in left_out if each[0] >= threshold], folders, rules_find)
            print(f"  {threshold:.2f}: {one.found} more faults, {one.right} findings right, {one.wrong} wrong")
    weights = weighed([*asides, *those])
    told = sum(likelihood(weights, each.candidate.kind, each.candidate.traits) >= THRESHOLD for each in own)
    print(f"{OWN}, with weights from all folders: {told} wrong at {THRESHOLD:.2f}")
    if arguments.store:
        kept = {
            name: round(weight, 3)
            for name, weight in sorted(weighed([*own, *asides, *those]).items())
            if abs(weight) >= _SMALLEST
        }
        content = {"threshold": THRESHOLD, "least": LEAST, "weights": kept}
        Path(FILE).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
