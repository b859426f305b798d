# ruff: noqa: T201  what is printed is the answer
"""Checks libraries that pymavlink generates of a dialect against that dialect: nothing in them is wrong, until it is.

    python benchmarks/claims_libraries.py [--seed N] [--faults N] [LANGUAGE...]

Each file of a library is a document with one block of code. Everything in it was made from the XML, so each finding
is a false one; descriptions that name what there is not (MAV_BATTERY_CHARGE_STATE_FAILE) are the dialect's own.
Then faults are put into files that are drawn by lot, one at a time: another number, type or unit. Printed are the
findings without a fault, and of how many faults the line is found, for each kind.
"""

import argparse
import contextlib
import io
import os
import random
import re
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import measure
from pymavlink.generator import mavgen

from codegen.claims import of_dialect, settled
from codegen.claims.reading import Reference, read_document
from codegen.commands.documents import dialect_reference
from codegen.diagnostics import Diagnostic, Report

LARGEST = 300_000
"""Characters of a file: what is larger has all messages of the dialect in it."""
_FENCES = {".h": "c", ".hpp": "cpp", ".java": "java", ".swift": "swift", ".m": "objc", ".ts": "ts"}
_TYPE = r"(?P<old>u?int\d+_t|float)"


@dataclass(frozen=True)
class Kind:
    """A kind of faults: what it is called, and a line with what is changed."""

    name: str
    line: str


KINDS = {
    "C++11": (
        Kind("id", r"#define MAVLINK_MSG_ID_[A-Z]\w+ (?P<old>\d+)$"),
        Kind("length", r"#define MAVLINK_MSG_ID_\w+_LEN (?P<old>\d+)$"),
        Kind("CRC_EXTRA", r"#define MAVLINK_MSG_ID_\w+_CRC (?P<old>\d+)$"),
        Kind("type", rf"^ {_TYPE} \w+(?:\[\d+\])?; /\*<"),
        Kind("unit", r"^ \S+ \w+(?:\[\d+\])?; /\*< \[(?P<old>\w+)\]"),
        Kind("number of elements", r"^ \S+ \w+\[(?P<old>\d+)\]; /\*<"),
        Kind("id, in a class", r"MSG_ID = (?P<old>\d+);"),
        Kind("length, in a class", r"LENGTH = (?P<old>\d+);"),
        Kind("CRC_EXTRA, in a class", r"CRC_EXTRA = (?P<old>\d+);"),
        Kind("offset", r"// offset: (?P<old>\d+)$"),
    ),
    "Java": (
        Kind("id", r"MAVLINK_MSG_ID_[A-Z]\w+ = (?P<old>\d+);"),
        Kind("length", r"MAVLINK_MSG_LENGTH = (?P<old>\d+);"),
        Kind("unit", r'@Units\("(?P<old>\w+)"\)'),
        Kind("entry of an enum", r"^   public static final int (?!\w+_ENUM_END )[A-Z]\w+ = (?P<old>\d+);"),
    ),
    "TypeScript": (
        Kind("id", r"_message_id: number = (?P<old>\d+);"),
        Kind("CRC_EXTRA", r"_crc_extra: number = (?P<old>\d+);"),
        Kind("entry of an enum", r"^\t(?!\w+_ENUM_END )[A-Z][A-Z0-9_]+ = (?P<old>\d+),"),
        Kind("type", rf"^// [a-z]\w* [^()]* {_TYPE}$"),
    ),
    "ObjC": (),
    "Swift": (),
}
_TYPES = ("uint8_t", "uint16_t", "uint32_t", "int16_t", "int32_t", "float")
_UNITS = ("mV", "cA", "degE7", "m", "mm", "cdeg", "deg", "rad", "ms", "us")


@dataclass(frozen=True)
class Document:
    """A file of a library as a document."""

    path: str
    text: str


@cache
def reference(dialect: str = "common") -> Reference:
    """Return the dialect that documents are compared with."""
    found = dialect_reference(dialect, Report())
    assert found is not None
    return found


def library(xml: Path, language: str, folder: Path) -> tuple[Document, ...]:
    """Return the files that pymavlink writes of an XML file in a language, as documents."""
    out = folder / language
    out.mkdir(parents=True)
    options = mavgen.Opts(str(out), wire_protocol="2.0", language=language)
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        mavgen.mavgen(options, [str(xml)])
    return tuple(
        Document(str(path.relative_to(folder)), f"# {path.name}\n\n```{_FENCES[path.suffix]}\n{text}\n```\n")
        for path in sorted(out.rglob("*"))
        if path.suffix in _FENCES and len(text := path.read_text(encoding="utf-8")) < LARGEST
    )


@cache
def findings(document: Document) -> tuple[Diagnostic, ...]:
    """Return what is found in a document."""
    reading = read_document(document.text, document.path, reference())
    return tuple(settled(reading, of_dialect(reading)))


def faulty(documents: Sequence[Document], kind: Kind, count: int, rng: random.Random) -> Iterator[tuple[Document, int]]:
    """Yield documents with a fault each, one for each file at most, and the line of it."""
    form = re.compile(kind.line, re.MULTILINE)
    pool = [each for each in documents if form.search(each.text)]
    for document in rng.sample(pool, min(count, len(pool))):
        found = rng.choice(list(form.finditer(document.text)))
        start, end = found.span("old")
        text = document.text[:start] + _other(found["old"], rng) + document.text[end:]
        yield Document(document.path, text), text.count("\n", 0, start) + 1


def _other(old: str, rng: random.Random) -> str:
    if old.isdigit():
        return str(int(old) + rng.choice((1, 2, 7, 10)))
    return rng.choice([each for each in (_TYPES if old in _TYPES else _UNITS) if each != old])


def is_found(document: Document, line: int) -> bool:
    """Return whether anything is found in a line."""
    return any(line in (each.place.line, *(at.line for at, _ in each.related)) for each in findings(document))


def main(arguments: Sequence[str]) -> None:
    """Print the findings of each language, and of how many faults the line is found."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("languages", metavar="LANGUAGE", nargs="*", help=", ".join(KINDS))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--faults", type=int, default=20, help="of each kind")
    asked = parser.parse_args(arguments)
    rng = random.Random(asked.seed)  # noqa: S311  which faults are drawn is no secret
    xml = Path(measure.dialect())
    with tempfile.TemporaryDirectory() as folder:
        for language in asked.languages or KINDS:
            documents = library(xml, language, Path(folder))
            told = [each for document in documents for each in findings(document)]
            print(f"{language}: {len(told)} findings in {len(documents)} files")
            for each in told:
                print(f"  {os.path.relpath(each.place.file)}:{each.place.line}: {each.message}")
            for kind in KINDS[language]:
                drawn = [is_found(*each) for each in faulty(documents, kind, asked.faults, rng)]
                print(f"  {kind.name}: {sum(drawn)} of {len(drawn)} faults found")


if __name__ == "__main__":
    main(sys.argv[1:])
