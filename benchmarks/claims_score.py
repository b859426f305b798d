# ruff: noqa: T201  what is printed is the answer
"""Scores the checker of documents: precision and recall on the documents of tests/claims/corpus.

    python benchmarks/claims_score.py [--wrong] [--kinds] [--evidence] [--store] FOLDER...

A folder is one of tests/claims/corpus. The README of the corpus says how it is counted.
--wrong lists what was missed and what was found wrongly.
--evidence tells by what findings stand on how many are right.
--store keeps all findings in the folder, as tests compare them: a change of the checker shows there what it does.
"""

import argparse
import re
import sys
from collections.abc import Iterable, Iterator, Sized
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from codegen.claims import of_dialect, settled
from codegen.claims.evidence import FIRM, Evidence, evidence_of
from codegen.claims.reading import Reference, read_document
from codegen.commands.documents import check_documents, dialect_reference
from codegen.diagnostics import Diagnostic, Report

CORPUS = Path(__file__).resolve().parents[1] / "tests" / "claims" / "corpus"
FOLDERS = sorted(path.parent.name for path in CORPUS.glob("*/labels.yaml"))
DIALECT = "ardupilotmega"


Fault = dict[str, Any]
"""A label: line, kind, message, field, claimed, dialect, sure."""


@dataclass(frozen=True)
class Score:
    """The score of some documents: findings that are right, those that are wrong, faults found and all faults.

    ``surely_found`` are the faults that certain findings find, ``told`` the right findings that say what is right.
    """

    right: int
    wrong: int
    found: int
    faults: int
    sure: int
    sure_and_right: int
    surely_found: int
    told: int

    @property
    def precision(self) -> float:
        """The share of the findings that are right."""
        return self.right / (self.right + self.wrong) if self.right + self.wrong else 1.0

    @property
    def recall(self) -> float:
        """The share of the faults that are found."""
        return self.found / self.faults if self.faults else 1.0

    def __str__(self) -> str:
        """Return both, with the numbers that they are of."""
        findings = self.right + self.wrong
        sure = 100 * self.sure_and_right / self.sure if self.sure else 100.0
        return (
            f"precision {100 * self.precision:.1f} % ({self.right} of {findings}), "
            f"recall {100 * self.recall:.1f} % ({self.found} of {self.faults}), "
            f"of the sure findings {sure:.1f} % are right ({self.sure_and_right} of {self.sure}), "
            f"and they find {100 * self.surely_found / self.faults if self.faults else 100:.1f} % of the faults"
        )


@cache
def findings_of(path: Path) -> tuple[Diagnostic, ...]:
    """Return what `codegen check` finds in a document, compared with the dialect."""
    report = Report()
    check_documents([str(path)], reference(), report)
    return tuple(report)


@cache
def rules_find(path: Path) -> tuple[Diagnostic, ...]:
    """Return what the rules alone find in a document, without what is weighed."""
    reading = read_document(path.read_text(), str(path), reference())
    return tuple(settled(reading, of_dialect(reading, with_weighed=False)))


def told(folder: str) -> str:
    """Return all findings of the documents of a folder, a line for each: its place, its rule and what it says."""
    lines = []
    for path, _ in documents(folder):
        for each in findings_of(path):
            hint = f" ({each.hint})" if each.hint else ""
            related = "".join(f" [{place.line}:{place.column} {text}]" for place, text in each.related)
            where = f"{path.name}:{each.place.line}:{each.place.column}"
            lines.append(f"{where}: {each.rule.standing} {each.rule.id}: {each.message}{hint}{related}\n")
    return "".join(lines)


def stored(folder: str) -> Path:
    """Return the file that keeps what was found in a folder."""
    return CORPUS / folder / "findings.txt"


@cache
def reference() -> Reference:
    """Return the dialect of the corpus, without a project."""
    found = dialect_reference(DIALECT, Report())
    assert found is not None
    return found


def is_about(finding: Diagnostic, fault: Fault) -> bool:
    """Return whether a finding names the line of a fault, and its message, its field or the entry that was meant."""
    lines = {finding.place.line, *(place.line for place, _ in finding.related)}
    names = [name for name in (fault["message"], fault["field"], fault["claimed"]) if name]
    names += [fault["dialect"].partition("=")[0]] if fault["kind"].startswith("enum") else []
    said = finding.message + (finding.hint or "")
    return fault["line"] in lines and any(name in said for name in names)


def judged(
    findings: Iterable[Diagnostic], faults: list[Fault]
) -> tuple[list[Diagnostic], list[Diagnostic], list[Fault]]:
    """Return the findings that are right, those that are wrong, and the faults that were found.

    Each finding finds one fault, first one of its own field, and with it those of the same kind and field on its line.
    """
    right, wrong, found = [], [], []
    for finding in findings:
        about = [fault for fault in faults if is_about(finding, fault)]
        if not about:
            wrong.append(finding)
            continue
        right.append(finding)
        new = [fault for fault in about if fault not in found]
        named = [fault for fault in new if fault["field"] and fault["field"] in finding.message]
        for first in (named or new)[:1]:
            same = [each for each in new if (each["kind"], each["field"]) == (first["kind"], first["field"])]
            found += [first, *(each for each in same if each is not first and each["line"] == first["line"])]
    return right, wrong, found


def is_told(finding: Diagnostic, faults: Iterable[Fault]) -> bool:
    """Return whether a finding says what the dialect has in place of one of the faults that it is about."""
    said = f"{finding.message} {finding.hint or ''}"
    for fault in faults:
        first, mark, second = re.fullmatch(r"(.*?)(?:( < |=)(.*))?", str(fault["dialect"])).groups()  # type: ignore[union-attr]
        words = f"{first} {_MARKS[mark]} {second}" if mark else first
        if is_about(finding, fault) and re.search(rf"(?<![\w.]){re.escape(words)}(?:_t)?(?!\w)", said):
            return True
    return False


_MARKS = {"=": "is", " < ": "comes before"}
"""The words of findings for what labels write with signs: ``ENTRY=3``, ``roll < pitch``."""


@cache
def labels(folder: str) -> list[dict[str, Any]]:
    """Return what is written of each document of a folder, read by libyaml where there is one: nine times as fast."""
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    written: list[dict[str, Any]] = yaml.load((CORPUS / folder / "labels.yaml").read_text(), loader)  # noqa: S506
    return written


def documents(folder: str) -> Iterator[tuple[Path, list[Fault]]]:
    """Yield each document of a folder with its faults."""
    for entry in labels(folder):
        yield CORPUS / folder / entry["file"], entry["faults"]


def score(folders: Iterable[str], *, lists: bool = False) -> Score:
    """Return what came of all documents of some folders; `lists` prints what is not as it should be."""
    total = [0] * 8
    for folder in folders:
        for path, faults in documents(folder):
            right, wrong, found = judged(findings_of(path), faults)
            certain = [finding for finding in (*right, *wrong) if finding.is_error]
            parts: tuple[Sized, ...] = (
                right,
                wrong,
                found,
                faults,
                certain,
                [finding for finding in right if finding.is_error],
                judged(certain, faults)[2],
                [finding for finding in right if is_told(finding, faults)],
            )
            total = [a + b for a, b in zip(total, map(len, parts), strict=True)]
            for finding in wrong if lists else ():
                print(f"wrong   {folder}/{path.name}:{finding.place.line}: {finding.rule.id}: {finding.message}")
            for fault in faults if lists else ():
                if fault not in found:
                    what = f"{fault['message']}.{fault['field'] or ''} {fault['claimed']} for {fault['dialect']}"
                    print(f"missed  {folder}/{path.name}:{fault['line']}: {fault['kind']}: {what}")
    return Score(*total)


def by_evidence(folders: Iterable[str]) -> dict[Evidence, tuple[int, int]]:
    """Return by kind of evidence how many findings are right, and how many there are."""
    counted: dict[Evidence, tuple[int, int]] = {}
    for folder in folders:
        for path, faults in documents(folder):
            reading = read_document(path.read_text(), str(path), reference())
            right, wrong, _ = judged(findings_of(path), faults)
            for finding in (*right, *wrong):
                kind = evidence_of(reading, finding)
                some, all_of = counted.get(kind, (0, 0))
                counted[kind] = (some + (finding in right), all_of + 1)
    return counted


def kinds(folder: str) -> dict[str, tuple[int, int]]:
    """Return by kind of fault how many of a folder are found, and how many there are."""
    counted: dict[str, tuple[int, int]] = {}
    for path, faults in documents(folder):
        _, _, found = judged(findings_of(path), faults)
        for fault in faults:
            some, all_of = counted.get(fault["kind"], (0, 0))
            counted[fault["kind"]] = (some + (fault in found), all_of + 1)
    return dict(sorted(counted.items()))


def main() -> int:
    """Print the score of each folder."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", metavar="FOLDER", choices=FOLDERS)
    parser.add_argument("--wrong", action="store_true", help="list what was missed and what was found wrongly")
    parser.add_argument("--kinds", action="store_true", help="tell how many faults of each kind are found")
    parser.add_argument(
        "--evidence", action="store_true", help="tell how many findings of each kind of evidence are right"
    )
    parser.add_argument("--store", action="store_true", help="keep all findings in findings.txt of the folder")
    arguments = parser.parse_args()
    for folder in arguments.folders:
        if arguments.store:
            stored(folder).write_text(told(folder), encoding="utf-8", newline="")
        print(f"{folder}: {score([folder], lists=arguments.wrong)}")
        for kind, (found, faults) in kinds(folder).items() if arguments.kinds else ():
            print(f"  {kind:<16}{found:>3} of {faults}")
    if len(arguments.folders) > 1:
        print(f"all: {score(arguments.folders)}")
    if arguments.evidence:
        found_by = by_evidence(arguments.folders)
        for each in Evidence:
            right, total = found_by.get(each, (0, 0))
            print(f"  {each.value:<12}{'certain' if each in FIRM else 'likely':<9}{right:>4} of {total} right")
    return 0


if __name__ == "__main__":
    sys.exit(main())
