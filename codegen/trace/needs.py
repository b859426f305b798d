"""The trace as needs.json of sphinx-needs, so that documentation made with Sphinx can show and query it.

A document and a criterion are of the type req, a row is spec, a symbol impl, and a test test; links lead from what
answers to what asks. Ids are in capitals with underscores, as sphinx-needs takes them: FR-00068.3 is FR_00068_3, and
``name`` has it as it is called.
"""

import hashlib
import json
import re
from typing import Any

from codegen.trace.exchange import Exchange, ExchangeObject, ObjectKind, RelationKind

_MARKS = re.compile(r"[\\*`|_]")
_TYPES = {
    ObjectKind.DOCUMENT: ("req", "Requirement"),
    ObjectKind.CRITERION: ("req", "Requirement"),
    ObjectKind.ROW: ("spec", "Specification"),
    ObjectKind.SYMBOL: ("impl", "Implementation"),
    ObjectKind.TEST: ("test", "Test Case"),
}
_OWN_FACTS = ("name", "result", "review", "bench", "aliases", "refers_to", "place", "cases")
"""Fields of a need beyond those of sphinx-needs: the project that imports it lists these names, or drops them."""


def needs_json(exchange: Exchange) -> str:
    """The text of the file, sorted by ids; it has no date, so that unchanged input gives the same text."""
    ids = _ids(exchange)
    needs = {ids[each.name]: _need(each, ids[each.name]) for each in exchange.objects}
    for relation in exchange.relations:
        need, target = needs[ids[relation.source]], ids[relation.target]
        need["links"].append(target)
        if relation.kind is RelationKind.PART:
            need["parent_needs"].append(target)
        if relation.kind is RelationKind.DEPENDS:
            need["depends_on"].append(target)
        if relation.is_suspect:
            need["tags"].append("suspect")
    for need in needs.values():
        need["tags"] = list(dict.fromkeys(need["tags"]))
    whole = {
        "project": exchange.project,
        "current_version": "",
        "versions": {
            "": {
                "creator": {"program": "codegen"},
                "needs_amount": len(needs),
                "needs": dict(sorted(needs.items())),
            }
        },
    }
    return json.dumps(whole, indent=1, ensure_ascii=False) + "\n"


def need_id(name: str) -> str:
    """A name as an id: capitals, digits and underscores, at least five of them and at most 80."""
    plain = re.sub(r"[^A-Z0-9]+", "_", name.upper()).strip("_").ljust(5, "_")
    return plain if len(plain) <= 80 else f"{plain[:67]}_{_digits(name)}"


def _ids(exchange: Exchange) -> dict[str, str]:
    """Return the ids by name: where two names would have one, the later one has the hash of its name behind it."""
    taken: dict[str, str] = {}
    ids: dict[str, str] = {}
    for each in exchange.objects:
        plain = need_id(each.name)
        if taken.setdefault(plain, each.name) != each.name:
            plain = f"{plain[:67]}_{_digits(each.name)}"
        ids[each.name] = plain
    return ids


def _digits(name: str) -> str:
    return hashlib.sha256(name.encode()).hexdigest()[:12].upper()


def _need(each: ExchangeObject, identifier: str) -> dict[str, Any]:
    kind, title = _TYPES[each.kind]
    facts = {"name": each.name, **dict(each.facts)}
    return {
        "id": identifier,
        "type": kind,
        "type_name": title,
        "title": each.title,
        "status": facts.get("status"),
        "docname": None,
        "lineno": None,
        "content": _prose(each.text),
        "tags": [*each.tags],
        "links": [],
        "parent_needs": [],
        "depends_on": [],
        **{name: facts[name] for name in _OWN_FACTS if name in facts},
    }


def _prose(text: str) -> str:
    """Text for reStructuredText, in which sphinx-needs reads contents: its marks are text here."""
    return _MARKS.sub(r"\\\g<0>", text)
