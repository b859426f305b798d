"""needs.json of sphinx-needs as another project has written it: the needs of its current version."""

import json
import re
from collections import Counter
from collections.abc import Collection, Mapping
from typing import Any

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.exchanged.restructured import formatted_content
from codegen.exchanged.stated import Stated, StatedFile
from codegen.load.files import DISK
from codegen.load.text import decode_text
from codegen.source import Place

NEEDS_FORMAT = Rule(
    "needs-format",
    "A file that ends with .json is needs.json as sphinx-needs writes it: an object with versions, the needs of each "
    "by their ids. Give the file that sphinx-build -b needs has made.",
    unreadable=True,
    remedy="give the needs.json that sphinx-build -b needs has made",
)
NEEDS_RECORD = Rule(
    "needs-record",
    "A need is not as sphinx-needs writes it: it is no object, its texts are no texts, or its links are no lists of "
    "ids. Export the file again.",
    remedy="export the file again with sphinx-build -b needs",
)
NEEDS_TYPE = Rule(
    "needs-type",
    "No need of the file is of a type that is imported. --type names the types that requirements have there.",
)

MAX_BYTES = 50_000_000
"""Largest file that is read, in bytes: some ten times what 10,000 needs take."""

FACTS = ("aliases", "refers_to", "bench")


def read_needs(path: str, types: Collection[str], version: str | None, report: Report) -> StatedFile | None:
    """Return what a file states with its needs of some ``types``; None, after a finding, where it is no needs.json.

    ``version`` is the one that is read, by default the current one. An older file calls the content description.
    """
    data = DISK.read_bytes(path, report, None, MAX_BYTES)
    text = None if data is None else decode_text(data, path, report)
    if text is None:
        return None
    needs = _needs(text, path, version, report)
    return None if needs is None else _Reader(text, path, needs, report).file(types)


def _needs(text: str, path: str, version: str | None, report: Report) -> Mapping[str, Any] | None:
    """The needs of a version by id."""
    try:
        whole = json.loads(text)
    except RecursionError:
        report.add(NEEDS_FORMAT, Place(path), "it is nested too deeply")
        return None
    except ValueError as fault:
        place = Place(path, getattr(fault, "lineno", 1), getattr(fault, "colno", 1))
        report.add(NEEDS_FORMAT, place, f"it is no JSON: {getattr(fault, 'msg', fault)}")
        return None
    versions = whole.get("versions") if isinstance(whole, dict) else None
    if not isinstance(versions, dict):
        report.add(NEEDS_FORMAT, Place(path), "it has no versions")
        return None
    asked = whole.get("current_version") if version is None else version
    if not isinstance(asked, str) or asked not in versions:
        report.add(NEEDS_FORMAT, Place(path), f"it has no version {asked!r}", did_you_mean(str(asked), versions))
        return None
    needs = versions[asked].get("needs") if isinstance(versions[asked], dict) else None
    if not isinstance(needs, dict):
        report.add(NEEDS_FORMAT, Place(path), f"its version {asked!r} has no needs")
        return None
    return needs


class _Reader:
    """Knows where each need begins in the text."""

    def __init__(self, text: str, path: str, needs: Mapping[str, Any], report: Report) -> None:
        self._path = path
        self._needs = needs
        self._report = report
        self._lines = _lines_of(text, needs)

    def file(self, types: Collection[str]) -> StatedFile:
        """The needs of some types in the order of the file, and how many there are of others."""
        objects = []
        others: Counter[str] = Counter()
        for key, need in self._needs.items():
            kind = need.get("type") if isinstance(need, dict) else None
            if kind is not None and kind not in types:
                others[str(kind)] += 1
                continue
            stated = self._stated(key, need)
            if stated is not None:
                objects.append(stated)
        if not objects and others:
            hint = f"--type NAME; its types are {', '.join(sorted(others))}"
            message = f"no need is of the type {' or '.join(sorted(types))}"
            self._report.add(NEEDS_TYPE, Place(self._path), message, hint)
        return StatedFile(tuple(objects), others)

    def _stated(self, key: str, need: Any) -> Stated | None:
        place = self._lines.get(key) or Place(self._path)
        place = Place(self._path, place.line, place.column)
        wrong = _wrong(need)
        if wrong:
            self._report.add(NEEDS_RECORD, place, f"the need {key} {wrong}")
            return None
        content = need.get("content") or need.get("description") or ""
        faults = Report()
        text = formatted_content(content, place, faults) if content.strip() else None
        self._report.extend(faults)
        facts = {name: need[name] for name in ("status", *FACTS) if need.get(name)}
        parents = [each for each in need.get("parent_needs") or () if each != key]
        return Stated(
            key=key,
            name=need.get("name") or key,
            title=need.get("title") or "",
            text=text if text and text.plain else None,
            is_broken=faults.has_errors,
            parent=parents[0] if parents else None,
            depends_on=tuple(need.get("depends_on") or ()),
            facts=facts,
            place=place,
        )


def _wrong(need: Any) -> str:
    """Return what is wrong with a need, or nothing."""
    if not isinstance(need, dict):
        return "is no object"
    for name in ("title", "content", "description", "status", "name", *FACTS):
        if not isinstance(need.get(name), str | None):
            return f"has a {name} that is no text"
    for name in ("parent_needs", "depends_on"):
        listed = need.get(name)
        if listed is not None and not (isinstance(listed, list) and all(isinstance(each, str) for each in listed)):
            return f"has {name} that are no list of ids"
    return ""


def _lines_of(text: str, needs: Mapping[str, Any]) -> dict[str, Place]:
    """Return where the key of each need stands: in the text, a key is followed by a colon and a brace."""
    found: dict[str, Place] = {}
    line, start = 1, 0
    for key in re.finditer(r'\n|"((?:[^"\\\n]|\\.)*)"\s*:\s*(?=[{\[\w"])', text):
        if key[0] == "\n":
            line, start = line + 1, key.end()
            continue
        name = key[1] if "\\" not in key[1] else json.loads(f'"{key[1]}"')
        if name in needs and name not in found:
            found[name] = Place("", line, key.start() - start + 1)
        line += key[0].count("\n")
        start = key.start() + key[0].rfind("\n") + 1 if "\n" in key[0] else start
    return found
