# ruff: noqa: T201  what is printed is the answer
"""Tests how general the checker of documents is: many ways to say a thing, of many messages, once right, once wrong.

    python benchmarks/claims_phrasings.py [--each N] [--seed N] [--missed] [KIND...]

Printed is by kind which share of the wrong ones is found, and how many of the right ones have a finding. At the end
come sentences that are no claims, though what they name is wrong: none of them is to have a finding.
The phrasings are in claims_phrasings.yaml, what is no claim in claims_asides.yaml; what they are filled with comes from
the dialect common.
"""

import argparse
import random
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import yaml
from phrasing import amounts, fields, frames, names
from phrasing.filling import Maker, reference

from codegen.claims import check_claims
from codegen.claims.reading import read_document
from codegen.commands.documents import with_other_dialects
from codegen.diagnostics import Diagnostic
from codegen.load.files import DISK

PHRASINGS = Path(__file__).with_suffix(".yaml")
ASIDES = PHRASINGS.with_name("claims_asides.yaml")


@dataclass(frozen=True)
class Twins:
    """One phrasing filled twice: a document that is right, and one that is wrong."""

    kind: str
    phrasing: str
    right: str
    wrong: str


def findings(text: str) -> list[Diagnostic]:
    """Return what is found in a text."""
    return check_claims(with_other_dialects(read_document(text, "/phrasing.md", reference()), DISK))


@cache
def phrasings(path: Path = PHRASINGS) -> Mapping[str, list[str]]:
    """Return all phrasings of a file by kind."""
    found: Mapping[str, list[str]] = yaml.safe_load(path.read_text())
    return found


MAKERS: Mapping[str, Maker] = {**fields.MAKERS, **amounts.MAKERS, **frames.MAKERS, **names.MAKERS}
"""By the kind of phrasing that each fills."""


def twins(kind: str, each: int, seed: int = 0, path: Path = PHRASINGS) -> Iterator[Twins]:
    """Yield each phrasing of a kind, filled so many times with messages that the seed chooses."""
    for phrasing in phrasings(path)[kind]:
        chance = random.Random(f"{seed} {phrasing}")  # noqa: S311  which messages fill it
        made = 0
        while made < each:
            fact = MAKERS[kind](chance)
            if fact is not None:
                made += 1
                yield Twins(kind, phrasing, phrasing.format(**fact[0]) + "\n", phrasing.format(**fact[1]) + "\n")


def main() -> int:
    """Print the shares, and what is missed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kinds", nargs="*", metavar="KIND", choices=[*MAKERS, []])
    parser.add_argument("--each", type=int, default=5, help="how many messages fill a phrasing")
    parser.add_argument("--seed", type=int, default=0, help="which messages fill them")
    parser.add_argument("--missed", action="store_true", help="list what is missed, and what is found wrongly")
    arguments = parser.parse_args()
    total = [0, 0, 0]
    for kind in arguments.kinds or MAKERS:
        missed: dict[str, list[str]] = {}
        false = []
        count = 0
        for each in twins(kind, arguments.each, arguments.seed):
            count += 1
            false += [(each.right, one) for one in findings(each.right)]
            if not findings(each.wrong):
                missed.setdefault(each.phrasing, []).append(each.wrong)
        found = count - sum(map(len, missed.values()))
        total = [total[0] + found, total[1] + count, total[2] + len(false)]
        print(f"{kind:<12} {found:>4} of {count:<4} found, {len(false)} findings on as many that are right")
        for phrasing, texts in missed.items() if arguments.missed else ():
            print(f"  missed {len(texts)} of {arguments.each}: {phrasing!r}\n      such as {texts[0]!r}")
        for text, one in false if arguments.missed else ():
            print(f"  false  {text!r}\n      {one.rule.id}: {one.message}")
    asides = [each.wrong for kind in phrasings(ASIDES) for each in twins(kind, arguments.each, arguments.seed, ASIDES)]
    taken = [(text, one) for text in asides if not arguments.kinds for one in findings(text)]
    for text, one in taken if arguments.missed else ():
        print(f"  no claim {text!r}\n      {one.rule.id}: {one.message}")
    share = 100 * total[0] / total[1]
    print(f"all: {total[0]} of {total[1]} found ({share:.1f} %), {total[2]} findings on as many that are right")
    if not arguments.kinds:
        print(f"no claims: {len(taken)} findings on {len(asides)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
