"""The generated tests of received messages: facts of the tables, and the cases, as data beside what runs them."""

import json
from collections.abc import Iterable

from codegen.model.reception import ReceivedField, Reception
from codegen.model.system import System
from codegen.targets.origin import copied_files, origin_of
from codegen.targets.suite.cases.file import dialect_files, json_line
from codegen.targets.suite.cases.receptions import ReceptionCase, reception_cases

_SUITE = "tests/receives"


def render_reception_suite(system: System) -> dict[str, str]:
    """The files below ``tests/`` that are about received messages; none where nothing is received."""
    if not system.receptions:
        return {}
    files = {path.replace(_SUITE, "tests"): text for path, text in copied_files(_SUITE).items()}
    paths = [path for path in system.spec.files if not path.endswith(".md")]
    origin = origin_of(system, paths, [table.wire for table in system.receptions])
    parts = [
        f'"generated": {json.dumps({"from": list(origin.sources), "inputs": origin.digest})}',
        f'"dialect": {json.dumps(dialect_files(system))}',
        f'"own": {json.dumps([system.system_id, system.component_id])}',
        f'"tables": [\n{_joined(_table(table) for table in system.receptions)}\n]',
        f'"cases": [\n{_joined(_case(case) for case in reception_cases(system))}\n]',
    ]
    files["tests/receives.json"] = "{" + ",\n".join(parts) + "}\n"
    return files


def _joined(records: Iterable[dict[str, object]]) -> str:
    return ",\n".join(map(json_line, records))


def _case(case: ReceptionCase) -> dict[str, object]:
    return {"table": case.table, "name": case.name, "requirement": case.requirement, "steps": case.steps}


def _table(table: Reception) -> dict[str, object]:
    system, component = table.targets
    return {
        "name": table.name,
        "message": table.wire.name,
        "sender": table.spec.sender.value,
        "target": [field.name if field else None for field in (system, component)],
        "where": {field.name: number for field, number in table.conditions},
        "call": f"received_{table.name.lower()}" if table.spec.call else None,
        "fields": [_field(taken) for taken in table.fields],
    }


def _field(taken: ReceivedField) -> dict[str, object]:
    quantity = taken.quantity
    is_whole = taken.field.type.is_integer
    return {
        "label": taken.label,
        "field": taken.field.name,
        "element": taken.element if taken.field.is_array and not taken.is_text else None,
        "component": quantity.component,
        "attribute": quantity.attribute,
        "kind": "float" if quantity.storage.is_float else quantity.kind.value,
        "factor": str(taken.factor),
        "rounding": taken.spec.rounding.value,
        "low": int(taken.low) if is_whole else float(taken.low),
        "high": int(taken.high) if is_whole else float(taken.high),
        "sentinel": taken.sentinel,
        "unchanged": list(taken.unchanged),
        "unknown": list(taken.absent),
        "speaking": list(taken.speaking),
        "provisos": [
            {
                "field": each.field.name,
                "numbers": list(each.numbers),
                "is_of_flags": each.is_of_flags,
                "is_denied": each.is_denied,
            }
            for each in taken.provisos
        ],
        "otherwise": taken.spec.otherwise.value,
        "is_extension": taken.is_extension,
        "initial": quantity.initial if isinstance(quantity.initial, str) else None,
        "stale_ms": quantity.trust.stale_after_ms if quantity.ages else None,
    }
