"""A review as JSON, and the schema of that."""

import json
from typing import Any

from codegen.diagnostics import Severity
from codegen.diff.change import Area, Notice, Victim, Weight
from codegen.diff.report.grouping import Group
from codegen.diff.report.review import Review, severity
from codegen.diff.system.bandwidth import Bandwidth
from codegen.model.price import Range
from codegen.source import Place

_Object = dict[str, Any]


def review_json(found: Review) -> str:
    """One object, as ``review_schema()`` describes it."""
    changes = [change for group in found.counting for change in group.changes]
    stated = {
        "base": found.base,
        "head": found.head,
        "summary": {
            "changes": len(changes),
            "silent": sum(change.is_silent for change in changes),
            "breaking": sum(change.is_breaking for change in changes),
            "person": sum(change.weight is Weight.PERSON for change in changes),
            **{area.value: sum(change.rule.area is area for change in changes) for area in Area},
        },
        "changes": [
            _change(each, index, "" if each is group else group.fingerprint)
            for group in found.groups
            for each in (group, *group.following)
            for index in range(len(each.changes))
        ],
        "bandwidth": [_bandwidth(program, bandwidth) for program, bandwidth in found.bandwidth],
        "elsewhere": found.elsewhere,
        "off": found.off,
        "notes": list(found.notes),
        "errors": [
            {"side": label, "rule": fault.rule.id, "message": fault.message, **_place(fault.place)}
            for label, fault in found.faults
        ],
    }
    return json.dumps(stated, indent=2)


def _change(group: Group, index: int, follows: str) -> _Object:
    change = group.changes[index]
    return {
        "rule": change.rule.id,
        "area": change.rule.area.value,
        "severity": str(severity(group)),
        "subject": change.subject,
        "old": change.old,
        "new": change.new,
        "effect": change.effect,
        "notice": change.notice.name.lower(),
        "weight": change.weight.value,
        "doubt": change.doubt,
        "softened": change.softened,
        "breaks": [Victim(victim).name.lower() for victim in change.breaks],
        "causes": list(change.causes),
        "messages": list(change.messages),
        **_place(change.place),
        "was_at": _place(change.was_at) if change.was_at else None,
        "requirements": list(change.reach.requirements),
        "symbols": list(change.reach.symbols),
        "tests": list(change.reach.tests),
        "fingerprint": group.fingerprint,
        "follows": follows,
        "waived": group.waived,
    }


def _place(place: Place) -> _Object:
    file, line, column = place.shown().rsplit(":", 2)
    return {"file": file, "line": int(line), "column": int(column)}


def _bandwidth(program: str, bandwidth: Bandwidth) -> _Object:
    rows = (*bandwidth.rows, bandwidth.whole)
    return {
        "program": program,
        "messages": [{"name": row.name, "old": _range(row.old), "new": _range(row.new)} for row in rows],
        "links": [{"name": link.name, "bytes_per_second": link.capacity} for link in bandwidth.links],
    }


def _range(found: Range | None) -> list[float] | None:
    return None if found is None else [float(found.low), float(found.high)]


def review_schema() -> str:
    """The JSON Schema (draft 2020-12) of what ``review_json`` writes."""
    place = {
        "file": {"type": "string", "description": "Path, or REVISION:path"},
        "line": {"type": "integer", "minimum": 1},
        "column": {"type": "integer", "minimum": 1},
    }
    text, texts = {"type": "string"}, {"type": "array", "items": {"type": "string"}}
    value = {"type": ["string", "null"]}
    count = {"type": "integer", "minimum": 0}
    bytes_range = {"type": ["array", "null"], "items": {"type": "number"}, "minItems": 2, "maxItems": 2}
    change = {
        "rule": text,
        "area": {"enum": [area.value for area in Area]},
        "severity": {"enum": [str(each) for each in Severity]},
        "subject": text,
        "old": value,
        "new": value,
        "effect": text,
        "notice": {
            "enum": [notice.name.lower() for notice in Notice],
            "description": "; ".join(
                f"{notice.name.lower()}: {notice.value or 'not on the wire'}" for notice in Notice
            ),
        },
        "weight": {"enum": [weight.value for weight in Weight]},
        "doubt": text,
        "softened": text,
        "breaks": {"type": "array", "items": {"enum": [victim.name.lower() for victim in Victim]}},
        "causes": texts,
        "messages": texts,
        **place,
        "was_at": {"anyOf": [_closed(place), {"type": "null"}]},
        "requirements": texts,
        "symbols": texts,
        "tests": texts,
        "fingerprint": {"type": "string", "pattern": "^[0-9a-f]{12}$"},
        "follows": {"type": "string", "description": "The fingerprint of the change that it comes of, or nothing"},
        "waived": value,
    }
    row = {"name": text, "old": bytes_range, "new": bytes_range}
    link = {"name": text, "bytes_per_second": count}
    bandwidth = {
        "program": text,
        "messages": {"type": "array", "items": _closed(row)},
        "links": {"type": "array", "items": _closed(link)},
    }
    whole = _closed(
        {
            "base": text,
            "head": text,
            "summary": _closed(dict.fromkeys(("changes", "silent", "breaking", "person", *map(str, Area)), count)),
            "changes": {"type": "array", "items": _closed(change)},
            "bandwidth": {"type": "array", "items": _closed(bandwidth)},
            "elsewhere": count,
            "off": count,
            "notes": texts,
            "errors": {"type": "array", "items": _closed({"side": text, "rule": text, "message": text, **place})},
        }
    )
    title = "codegen diff --format json"
    return json.dumps({"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title, **whole}, indent=2)


def _closed(properties: _Object) -> _Object:
    """An object that has these properties and no others."""
    return {
        "type": "object",
        "properties": properties,
        "required": list(properties),
        "additionalProperties": False,
    }
