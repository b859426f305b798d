"""The self-test of a program on the board that has it: times, heap, noise of the converter."""

import json
from collections.abc import Iterator, Mapping
from datetime import UTC, datetime
from hashlib import sha256

from codegen import __version__
from codegen.deploy.board import Board
from codegen.deploy.connection import Connection
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.bench_record import MEASURES, BenchRecord
from codegen.source import Place
from codegen.tool.template_files import copied

NOT_DEPLOYED = Rule(
    "not-deployed",
    "What is on the board is not what the specification makes now, so that nothing measured there would say anything "
    "about it. Run codegen deploy, then codegen bench.",
)

COUNT = 200
"""Number of times that each call is timed."""
_SLICE_MS = 2000
"""The time that the board runs on before it answers: mpremote waits for ten seconds at most."""
_SUMMED = ("heap.steady_bytes", "loop.missed_slots")
"""Measures that add up from slice to slice; of all others the largest counts."""


@dataclass(frozen=True, slots=True)
class Measured:
    """``measures`` by their names, ``details`` by name and what it is about, and what the board has told."""

    measures: Mapping[str, float]
    details: Mapping[str, Mapping[str, float]]
    told: tuple[str, ...]


def steps(facts: Mapping[str, object], seconds: float) -> Iterator[tuple[str, str]]:
    """Yield what is done, one after the other: a name for people, and the call."""
    yield "start", "begin()"
    for name in ("readings", "updates", "sets", "frames", "receptions"):
        yield name, f"{name}({COUNT})"
    if not facts["program"]:
        yield "heap", f"turns({COUNT})"
        return
    yield "settle", f"settle({_SLICE_MS})"
    left_ms = round(seconds * 1000)
    while left_ms > 0:
        yield "loop", f"steady({min(left_ms, _SLICE_MS)})"
        left_ms -= _SLICE_MS


def prepare_bench(connection: Connection, facts: Mapping[str, object]) -> None:
    """Let the board begin anew without its program, and bring what measures."""
    connection.begin_anew()
    connection.run(f"{copied('deploy/bench.py')}\nFACTS.update({dict(facts)!r})")


def measured(lines: Iterator[list[object]], seconds: float, *, has_loop: bool) -> Measured:
    """Sum up what the board has printed: ``[name, value]``, ``[name, about, value]`` or ``["", text]``."""
    found: dict[str, float] = {}
    details: dict[str, dict[str, float]] = {}
    told: list[str] = []
    for name, *rest in lines:
        if not name:
            told.append(str(rest[0]))
            continue
        value = round(float(str(rest[-1])), 3)
        if len(rest) > 1:
            details.setdefault(str(name), {})[str(rest[0])] = value
        before = found.get(str(name))
        if before is None:
            found[str(name)] = value
        else:
            found[str(name)] = before + value if name in _SUMMED else max(before, value)
    if has_loop:
        found["loop.seconds"] = seconds
    return Measured({name: found[name] for name in MEASURES if name in found}, details, tuple(told))


def firmware_digest(files: Mapping[str, bytes]) -> str:
    """The hash of all files of a board: 16 hexadecimal digits."""
    digest = sha256()
    for path, content in sorted(files.items()):
        digest.update(f"{path}\0{sha256(content).hexdigest()}\n".encode())
    return digest.hexdigest()[:16]


def record_of(
    board: Board, about: Mapping[str, str], found: Measured, files: Mapping[str, bytes], *, own_ports: bool
) -> BenchRecord:
    """Return what the file says; ``about`` has project, program and inputs."""
    return BenchRecord(
        project=about["project"],
        program=about["program"],
        codegen=__version__,
        inputs=about["inputs"],
        firmware=firmware_digest(files),
        board=board.machine,
        version=".".join(map(str, board.version)),
        taken=datetime.now(UTC).isoformat(timespec="seconds"),
        ports="own" if own_ports else "stand-ins",
        measures=found.measures,
        details=found.details,
        told=found.told,
        place=Place(""),
    )


def bench_text(record: BenchRecord) -> str:
    """A record as the JSON of its file."""
    stated = {
        "doc": "Written by codegen bench; codegen trace --results takes it.",
        "format": 1,
        "project": record.project,
        "program": record.program,
        "codegen": record.codegen,
        "inputs": record.inputs,
        "firmware": record.firmware,
        "board": record.board,
        "micropython": record.version,
        "taken": record.taken,
        "ports": record.ports,
        "measures": dict(record.measures),
        "details": {name: dict(values) for name, values in record.details.items()},
        "told": list(record.told),
    }
    return json.dumps(stated, indent=2, ensure_ascii=False) + "\n"
