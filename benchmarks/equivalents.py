"""The faults that benchmarks/equivalents.yaml lists, with reasons: nobody can notice them, and they do not count."""

import ast
import re
from collections.abc import Iterator, Mapping, Sequence, Set
from functools import cache
from typing import NamedTuple

import yaml
from mutants import Mutant, mutants_of
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

    One that names its programs holds in their firmware alone: what nothing calls there, or what there is one of. One
    with ``like`` in place of ``line`` is about all lines of that form, and about no fault where there is none.
    """
    found = set()
    for entry in yaml.safe_load(LIST.read_text(encoding="utf-8")) or ():
        if program not in entry.get("programs", [program]):
            continue
        if "like" in entry:
            found.update(_alike(entry, texts))
            continue
        module, line = entry["module"], entry["line"]
        if module in texts and line not in map(str.strip, texts[module].splitlines()):
            raise SystemExit(f"{LIST}: {module} has no line {line!r} any more")
        found.add(Fault(module, line, str(entry["old"]), str(entry["new"]), entry.get("within", "")))
    return found


def _alike(entry: Mapping[str, str], texts: Mapping[str, str]) -> Iterator[Fault]:
    """Yield the faults that an entry is about, by regular expressions for the module, its line, and what is changed.

    ``body`` is the only line of what stands below such a line, where that matters; \\1 in it is a group of the line.
    """
    for module, text in texts.items():
        if not re.fullmatch(entry["module"], module):
            continue
        lines = text.splitlines()
        for mutant, fault in faults_of(module, text):
            like = re.fullmatch(entry["like"], fault.line)
            if like is None or not re.fullmatch(entry["old"], fault.old) or not re.fullmatch(entry["new"], fault.new):
                continue
            if not re.fullmatch(entry.get("within", ".*"), fault.within):
                continue
            if "body" not in entry or _body(lines, mutant.line) == like.expand(entry["body"]):
                yield fault


def _body(lines: Sequence[str], line: int) -> str | None:
    """Return the only line of what stands below a line, counted from 1; None where there are more."""
    depths = [len(each) - len(each.lstrip()) for each in lines[line - 1 : line + 2]]
    return lines[line].strip() if len(depths) == 3 and depths[1] > depths[0] >= depths[2] else None


@cache
def faults_of(module: str, text: str) -> list[tuple[Mutant, Fault]]:
    """Return all mutants of a module, each with the fault as the list would name it."""
    return [(mutant, fault_of(mutant, text)) for mutant in mutants_of(module, text)]


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
