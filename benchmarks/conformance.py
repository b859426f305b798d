"""Compares the codec of every dialect that pymavlink ships with pymavlink, message by message, on MicroPython.

tests/codec/conformance_cases.py makes the cases, tests/codec/conformance_run.py runs them with tests/codec/conform.py.
Then what tables populate is compared, every field of every message: benchmarks/population/.
"""
# ruff: noqa: T201, S603 - a command: it prints, and it starts the MicroPython that comes with the dependencies

import argparse
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pymavlink

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "conformance.md"
sys.path.insert(0, str(ROOT / "tests" / "codec"))

import conformance_run as conformance  # noqa: E402 - the tests are no package
from conformance_oracle import read_dialect  # noqa: E402 - as above
from population.comparing import Outcome  # noqa: E402 - as above
from population.section import section  # noqa: E402 - as above
from population.whole import prove_all  # noqa: E402 - as above

from codegen.load.files import DISK  # noqa: E402 - as above
from codegen.load.shipped import shipped_dialect_names  # noqa: E402 - as above

KINDS = {
    "random": "any bit pattern of whole numbers and floats (one NaN), any text",
    "zeros at the end": "the same, with zeros from a random field or element on",
    "all minimum": "the smallest value in every field",
    "all maximum": "the largest value in every field",
    "all zero": "nothing but zeros, of which MAVLink 2 sends one byte",
    "special floats": "NaN, infinities, -0.0, the ends of the denormal and of the normal numbers, next to 1",
    "empty text": "text of no character",
    "short text": "text that NUL follows",
    "full text": "text without a NUL",
    "text beyond ASCII": "bytes from 128 to 255",
    "text with NUL inside": "bytes after the end of the text",
    "unknown fields": "`set(name, None)` in every field that has a sentinel, `get(name)` is None again",
    "unknown elements": "None for some elements of arrays",
    "new message": "a message that nobody has written to",
    "live": "whole numbers through `live=`, fields and single elements, out and in",
    "any bits": "payloads of random bits, decoded",
    "every truncated length": "payloads (written to `wire`) with every number of zeros at the end, out and in",
    "zeros left in": "frames that were not truncated, decoded",
    "no extensions": "MAVLink 2 frames without extension fields, decoded",
    "extensions in MAVLink 1": "MAVLink 1 frames with extension fields, as pymavlink's v20 modules send them, decoded",
    "newer extensions": "frames with more bytes than the message has, decoded",
    "signed": "frames with a signature that nobody checks, decoded",
    "wrong checksums": "streams: frames among garbage, unknown messages, unknown flags and wrong checksums",
    "wrong lengths": "streams: the same with frames that state a wrong length",
    "damaged frames": "damaged frames with an id or a length that looks like the start of a frame",
    "class": "id, CRC_EXTRA, lengths, fields; refusals of None without a sentinel and of ids above 255 in MAVLink 1",
    "enum entries": "names and values of enum entries",
}
"""The kinds of cases, described; the order is that of the page."""


@dataclass
class Row:
    """The result of comparing a dialect."""

    name: str
    messages: int = 0
    outcome: conformance.Outcome = field(default_factory=conformance.Outcome)
    made: tuple[str, ...] = ()

    @property
    def cells(self) -> list[str]:
        """The row of the table."""
        counts = self.outcome.counts
        out, received, first = (counts.get(kind, 0) for kind in ("encode", "decode", "v1"))
        result = "equal" if not self.outcome.different else f"{self.outcome.different} differences"
        return [self.name, *(f"{number:,}" for number in (self.messages, out + received, out, received, first)), result]


HEAD = ["dialect", "messages", "frames", "encoded", "decoded", "of them MAVLink 1", "result"]


BOARD = {"forms": ("plain",), "interpreter": conformance.MICROPYTHON32, "modules": (conformance.SINGLE_FLOATS,)}
"""The stand-in for a board: words of 32 bits without machine code, and floats of 32 bits where struct is asked."""

WITH_DOUBLES = ("common", "python_array_test", "test")
"""The dialects that state messages with fields of type double."""


def compare(name: str, rounds: int, seed: int, **where: Any) -> tuple[Row, set[str]]:
    """Compare a whole dialect in both forms of the frames, or where the keywords say; tell its messages, too."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        dialect = read_dialect(name, folder)
        outcome = conformance.compare(dialect, folder, dialect.messages, rounds, seed=seed, **where)
    facts = {repr((message.description, message.fields)) for message in dialect.messages}
    return Row(name, len(dialect.messages), outcome, dialect.made), facts


def total(rows: Sequence[Row]) -> Row:
    """All rows together."""
    counts: Counter[str] = Counter()
    for row in rows:
        counts.update(row.outcome.counts)
    outcome = conformance.Outcome(dict(counts), [], sum(row.outcome.different for row in rows))
    return Row("all of them", sum(row.messages for row in rows), outcome)


def table(lines: Sequence[Sequence[str]], left: Sequence[int] = (0, 6)) -> str:
    """A table of Markdown, its columns as wide as they have to be."""
    widths = [max(len(line[column]) for line in lines) for column in range(len(lines[0]))]

    def row(line: Sequence[str]) -> str:
        cells = (
            text.ljust(width) if column in left else text.rjust(width)
            for column, (text, width) in enumerate(zip(line, widths, strict=True))
        )
        return f"| {' | '.join(cells)} |"

    rule = ["-" * width if column in left else "-" * (width - 1) + ":" for column, width in enumerate(widths)]
    return "\n".join([row(lines[0]), f"| {' | '.join(rule)} |", *(row(line) for line in lines[1:])])


def micropython_version() -> str:
    """The version of the MicroPython that runs the codec."""
    code = "import sys; print('.'.join(str(part) for part in sys.implementation[1][:3]), sys.implementation[1][3])"
    asked = [str(conformance.MICROPYTHON), "-c", code]
    done = subprocess.run(asked, capture_output=True, text=True, check=True)
    return "-".join(done.stdout.split())


PAGE_TEXT = """# Conformance

<!-- Written by benchmarks/conformance.py (make conformance); a change by hand is lost with the next run. -->

Every message of every dialect that pymavlink {pymavlink} ships goes through the codec that `codegen codec --messages
all` makes of it, under MicroPython {micropython} (unix port), and is compared with pymavlink byte for byte, frames
with what `pack()` makes and values with what `decode()` reads. These are {messages} messages in {dialects} dialects,
{distinct} of them different.

    make conformance

runs `benchmarks/conformance.py --write`: {rounds} rounds of random values from a fixed seed. It writes this page, and
fails if anything differs. `tests/codec/test_conformance.py` compares every different message once, with every kind of
case.

`make conformance` then switches through the drafts that `specs/codegen.yaml` can list
([CONTRIBUTING.md](../CONTRIBUTING.md#tests)): with each, `benchmarks/alternatives.py` builds, checks, traces and
simulates a copy of the project, and runs all tests that are not about another draft.

{table}

All of it is done twice, with machine code (`frames_viper.py`) and without (`frames_plain.py`); the numbers are those of
both together.

Most boards have words and floats of 32 bits. Dialects with doubles, which are more than these floats, are compared once
more on a MicroPython with such words, whose `struct` reads and writes doubles by way of such floats, as that of a board
does. What is no such float goes out by `doubles.set_ratio()` and is compared with `doubles.ratio()`
([codec.md](codec.md#doubles)):

{board}

## What is compared

Encoded: fields are set by name with `set()`, and the frame has to be that of pymavlink. Decoded: a frame of pymavlink
arrives in two pieces; `raw()` of every field has to be what pymavlink reads (NaN is NaN), `wire` the payload with zeros
up to its full length, and sequence number, system and component those of the frame. MAVLink 1 is compared with
pymavlink's modules for MAVLink 1, since those for MAVLink 2 send extension fields in it.

{kinds}

In the streams, {refused} frames had to be passed over and counted: unknown ones, those with incompatible flags that
nobody knows, and damaged ones.

## What could not be done

{undone}

Where pymavlink is no yardstick:

- It knows nothing of sentinels: what `invalid` says is read from the XML by pymavlink's parser and given to `pack()`.
- It sends one NaN only; others arrive in payloads of random bits, where `wire` and that it is NaN are compared.
- It does not look for frames within what it took for one. Behind a length that is too long it loses frames that the
  codec finds: these streams are compared with the frames that they were made of. So are the counters.
- A damaged frame whose id or length is 253 or 254 looks like two beginnings of a frame. It comes on its own, and has to
  count as one error at least.

No dialect has ids above 65535: the third byte of an id comes up in unknown messages only.

No board was compared; what stands in for one has floats of 64 bits outside of `struct`.

{population}"""


def page(rows: Sequence[Row], board: Sequence[Row], distinct: int, rounds: int, population: Outcome) -> str:
    """docs/conformance.md."""
    together = total(rows)
    counts = together.outcome.counts
    kinds = [["kind of case", "number", "what it is"]]
    kinds += [[kind, f"{counts[kind]:,}", text] for kind, text in KINDS.items()]
    return PAGE_TEXT.format(
        pymavlink=pymavlink.__version__,
        micropython=micropython_version(),
        messages=f"{together.messages:,}",
        dialects=len(rows),
        distinct=distinct,
        rounds=rounds,
        table=table([HEAD, *(row.cells for row in rows), together.cells]),
        board=table([HEAD, *(row.cells for row in board)]),
        kinds=table(kinds, left=(0, 2)),
        refused=f"{counts['refused']:,}",
        undone=_undone([*rows, *board]),
        population=section(population, table),
    )


def _undone(rows: Sequence[Row]) -> str:
    """Return as text the differences, and the comparisons with modules that pymavlink does not bring."""
    differences = [f"- {row.name}: {difference}" for row in rows for difference in row.outcome.differences]
    made = [f"- {reason}" for row in rows for reason in row.made]
    if differences:
        text = "\n".join(["These differ:", "", *differences])
    else:
        text = "No dialect and no message is left out, and nothing differs."
    if made:
        return "\n".join([text, "", "Modules of pymavlink that had to be made from its XML, and why:", "", *made])
    return text + "\nAll modules that pymavlink brings are what it makes of its XML, so that none had to be made anew."


def main() -> int:
    """Compare, print, and write the page if that is asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=2, metavar="N", help="how many random values of each kind (2)")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="other random values (1)")
    parser.add_argument("--dialects", metavar="A,B", help="only these dialects")
    parser.add_argument("--population", action="store_true", help="only what tables populate")
    parser.add_argument("--write", action="store_true", help=f"write {PAGE.relative_to(ROOT)}")
    arguments = parser.parse_args()
    names = shipped_dialect_names(DISK)
    if arguments.population:
        if arguments.write or arguments.dialects:
            parser.error("--population is for itself")
        return 1 if _populated(arguments.seed, arguments.rounds).differences else 0
    if arguments.dialects:
        if arguments.write:
            parser.error("--write needs all dialects")
        chosen = arguments.dialects.split(",")
        if unknown := [name for name in chosen if name not in names]:
            parser.error(f"pymavlink ships no dialect {', '.join(unknown)}")
        names = tuple(chosen)
    rows, board = [], []
    distinct: set[str] = set()
    for name in names:
        row, facts = compare(name, arguments.rounds, arguments.seed)
        rows.append(row)
        distinct |= facts
        tell(name, row)
        if name in WITH_DOUBLES:
            board.append(compare(name, arguments.rounds, arguments.seed, **BOARD)[0])
            tell(f"{name}, 32 bits", board[-1])
    together = total(rows)
    print(f"\n{table([HEAD, *(row.cells for row in rows), together.cells])}\n\n{len(distinct)} different messages")
    if arguments.dialects:
        return 1 if together.outcome.different else 0
    population = _populated(arguments.seed, arguments.rounds)
    if arguments.write:
        PAGE.parent.mkdir(exist_ok=True)
        PAGE.write_text(page(rows, board, len(distinct), arguments.rounds, population), encoding="utf-8")
    return 1 if together.outcome.different or total(board).outcome.different or population.differences else 0


def tell(name: str, row: Row) -> None:
    """Print what a comparison brought."""
    print(f"{name}: {row.messages} messages, {row.cells[-1]}", flush=True)
    for difference in row.outcome.differences:
        print(f"    {difference}", flush=True)


def _populated(seed: int, rounds: int) -> Outcome:
    """Prove the population of every message; say so, and what differs."""
    outcome = prove_all(seed, 5 * rounds, lambda line: print(line, flush=True))
    for difference in outcome.differences:
        print(f"    {difference}")
    print(f"\n{section(outcome, table)}")
    return outcome


if __name__ == "__main__":
    sys.exit(main())
