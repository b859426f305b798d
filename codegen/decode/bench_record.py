"""The file of ``codegen bench``, as it is written there."""

import json
from collections.abc import Mapping
from typing import Any

from codegen.diagnostics import Report, Rule
from codegen.load.files import Files
from codegen.model.bench_record import BenchRecord
from codegen.source import Place

BENCH_FORMAT = Rule(
    "bench-format",
    "A file of results that ends with .json is one that codegen bench has written, and this one is not, or lacks a "
    "part of what it writes. Measure again.",
    unreadable=True,
)
_HINT = "codegen bench --out FILE"
_TEXTS = ("project", "program", "codegen", "inputs", "firmware", "board", "micropython", "taken", "ports")


def decode_bench(path: str, files: Files, report: Report) -> BenchRecord | None:
    """The record of a file; None, after a finding, where it has none."""
    text = files.read_text(path, report)
    if text is None:
        return None
    try:
        stated = json.loads(text)
    except RecursionError:
        report.add(BENCH_FORMAT, Place(path), "it is nested too deeply", _HINT)
        return None
    except ValueError as fault:
        line, column = getattr(fault, "lineno", 1), getattr(fault, "colno", 1)
        report.add(BENCH_FORMAT, Place(path, line, column), f"it is no JSON: {getattr(fault, 'msg', fault)}", _HINT)
        return None
    if not isinstance(stated, dict) or stated.get("format") != 1:
        report.add(BENCH_FORMAT, Place(path), "it has no format 1", _HINT)
        return None
    wrong = [name for name in _TEXTS if not isinstance(stated.get(name), str)]
    measures = _numbers(stated.get("measures"))
    if wrong or measures is None:
        report.add(BENCH_FORMAT, Place(path), f"it has no {(wrong or ['measures'])[0]}", _HINT)
        return None
    details, told = stated.get("details"), stated.get("told")
    return BenchRecord(
        **{("version" if name == "micropython" else name): stated[name] for name in _TEXTS},
        measures=measures,
        details={name: _numbers(each) or {} for name, each in details.items()} if isinstance(details, dict) else {},
        told=tuple(map(str, told)) if isinstance(told, list) else (),
        place=Place(path),
    )


def _numbers(stated: Any) -> Mapping[str, float] | None:
    """Numbers by name; None for anything else."""
    if not isinstance(stated, dict):
        return None
    are_numbers = all(isinstance(value, int | float) and not isinstance(value, bool) for value in stated.values())
    return stated if are_numbers else None
