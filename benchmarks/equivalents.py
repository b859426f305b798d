"""The faults that benchmarks/equivalents.yaml lists, with reasons: nobody can notice them, and they do not count."""

import ast
from collections.abc import Mapping, Set
from functools import cache
from typing import NamedTuple

import yaml
from mutants import Mutant
from results import ROOT

LIST = ROOT / "benchmarks" / "equivalents.yaml"


class Fault(NamedTuple):
    """A fault as the list names it: wherever its line stands, it is the same fault.

    ``within`` is the function that the line stands in, after its class: ``Wifi.poll``; "" is any, or none.
    """

    module: str
    line: str
    old: str
    new: str
    within: str = ""


def listed(texts: Mapping[str, str], program: str | None = None) -> set[Fault]:
    """Return those in these modules; an entry about a line that is gone is a fault of the list.

    One that names its programs holds in their firmware alone: what nothing calls there, or what there is one of.
    """
    found = set()
    for entry in yaml.safe_load(LIST.read_text(encoding="utf-8")) or ():
        module, line = entry["module"], entry["line"]
        if program not in entry.get("programs", [program]):
            continue
        if module in texts and line not in map(str.strip, texts[module].splitlines()):
            raise SystemExit(f"{LIST}: {module} has no line {line!r} any more")
        found.add(Fault(module, line, str(entry["old"]), str(entry["new"]), entry.get("within", "")))
    return found


def fault_of(mutant: Mutant, text: str) -> Fault:
    """Return a fault as the list would name it; ``text`` is that of its module."""
    return Fault(
        mutant.file, mutant.line_in(text), " ".join(mutant.old.split()), mutant.new, _within(text, mutant.line)
    )


def is_listed(fault: Fault, found: Set[Fault]) -> bool:
    """Return whether an entry is about a fault: about its function, or about its line in any."""
    return fault in found or fault._replace(within="") in found


def _within(text: str, line: int) -> str:
    """Return the names of the classes and functions around a line: ``Wifi.poll``."""
    return ".".join(name for name, first, last in _named(text) if first <= line <= last)


@cache
def _named(text: str) -> list[tuple[str, int, int]]:
    """Return the name, the first and the last line of each class and function of a module, in their order."""
    kinds = ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
    found = [node for node in ast.walk(ast.parse(text)) if isinstance(node, kinds)]
    return sorted(((node.name, node.lineno, node.end_lineno or 0) for node in found), key=lambda each: each[1])
