"""The trace as needs.json of sphinx-needs, so that documentation made with Sphinx can show and query it.

A document and a criterion are of the type req, a row is spec, a generated file impl, and a test test; links lead from
what answers to what asks. Ids are in capitals with underscores, as sphinx-needs takes them: FR-00068.3 is FR_00068_3.
"""

import hashlib
import json
import re
from typing import Any

from codegen.trace.view import CriterionView, DocumentView, TraceView

_Need = dict[str, Any]

_MARKS = re.compile(r"[\\*`|_]")
_STATUS = {"good": "passed", "warn": "partly passed", "bad": "not passed", "": "linked"}
_TYPES = {"req": "Requirement", "spec": "Specification", "impl": "Implementation", "test": "Test Case"}


def needs_json(view: TraceView) -> str:
    """The text of the file, sorted by ids; it has no date, so that unchanged input gives the same text."""
    needs: dict[str, _Need] = {}
    for document in (*view.documents, *view.decisions):
        _add_document(needs, document)
    whole = {
        "project": view.project,
        "current_version": "",
        "versions": {"": {"needs_amount": len(needs), "needs": dict(sorted(needs.items()))}},
    }
    return json.dumps(whole, indent=1, ensure_ascii=False) + "\n"


def need_id(name: str) -> str:
    """A name as an id: capitals, digits and underscores, at least five of them."""
    return re.sub(r"[^A-Z0-9]+", "_", name.upper()).strip("_").ljust(5, "_")


def _add_document(needs: dict[str, _Need], document: DocumentView) -> None:
    tags = ["decision"] if document.is_decision else []
    own = _need("req", document.id, f"{document.id} {document.title}", document.status, document.place, tags)
    needs[own["id"]] = own
    for one in document.criteria:
        _add_criterion(needs, one, own["id"])


def _add_criterion(needs: dict[str, _Need], one: CriterionView, document: str) -> None:
    own = _need("req", one.name, one.name, one.status, one.place, [*one.tags])
    own["content"] = f"{_prose(one.text)}\n\n{_prose(one.place)}"
    own["links"] = [document]
    needs[own["id"]] = own
    for row in one.rows:
        need = _need("spec", f"ROW {row.kind} {row.label}", f"{row.kind} {row.label}", "", row.place, [])
        _link(needs, need, own["id"])
    for symbols in one.symbols:
        need = _need("impl", f"FILE {symbols.file}", symbols.file, "", symbols.file, [])
        known = needs.get(need["id"])
        before = known["content"].split(", ") if known else []
        need["content"] = ", ".join(dict.fromkeys([*before, *map(_prose, symbols.names)]))
        if known:
            known["content"] = need["content"]
        _link(needs, need, own["id"])
    for test in one.tests:
        status = _STATUS[test.mood]
        need = _need("test", f"TEST {test.name} {one.name}", f"{test.name} shows {one.name}", status, "", [])
        need["content"] = _prose("; ".join(filter(None, (test.cases, test.result))))
        _link(needs, need, own["id"])


def _link(needs: dict[str, _Need], need: _Need, target: str) -> None:
    known = needs.setdefault(need["id"], need)
    if target not in known["links"]:
        known["links"].append(target)


def _need(kind: str, name: str, title: str, status: str, place: str, tags: list[str]) -> _Need:
    return {
        "id": _short(need_id(name)),
        "type": kind,
        "type_name": _TYPES[kind],
        "title": title,
        "status": status or None,
        "docname": None,
        "lineno": None,
        "content": _prose(place),
        "tags": tags,
        "links": [],
    }


def _prose(text: str) -> str:
    """Text for reStructuredText, in which sphinx-needs reads contents: its marks are text here."""
    return _MARKS.sub(r"\\\g<0>", text)


def _short(identifier: str) -> str:
    """Ids of at most 80 characters: the rest of a longer one is its hash."""
    if len(identifier) <= 80:
        return identifier
    return f"{identifier[:67]}_{hashlib.sha256(identifier.encode()).hexdigest()[:12].upper()}"
