"""The file of the cases: what the runner reads, with the dialect that judges and the instances that there are."""

import json
import math
import os
from collections.abc import Mapping

from codegen.model.answers.answer import Answer
from codegen.model.dialect.dialect import Kind
from codegen.model.spec.spec import Correction
from codegen.model.system import System
from codegen.model.vehicle import Component, QuantityKind
from codegen.targets.naming import message_about
from codegen.targets.suite.cases.messages import conversion_cases, message_cases
from codegen.targets.suite.cases.value_sources import value_sources


def cases_text(system: System, origin: dict[str, object]) -> str:
    """The cases as JSON, one case a line, so that a diff shows which cases changed."""
    messages = [
        {
            "name": case.name,
            "requirement": case.requirement,
            **({"also": case.also} if case.also else {}),
            "message": case.message,
            **({"table": case.table} if case.table != case.message else {}),
            "instance": case.instance,
            **({"page": case.page} if case.page else {}),
            "set": [setting if setting[3] else setting[:3] for setting in case.settings],
            "expect": case.expect,
        }
        for case in message_cases(system)
    ]
    conversions = [
        {
            "name": case.name,
            "requirement": case.requirement,
            "component": case.component,
            "parameters": case.parameters,
            "setter": case.setter,
            "count": case.count,
            "attribute": case.attribute,
            "expect": case.expect,
        }
        for case in conversion_cases(system)
    ]
    parts = [f'"generated": {json.dumps(origin)}']
    parts.append(f'"dialect": {json.dumps(dialect_files(system))}')
    parts.append(f'"instances": {json.dumps(_instances(system.components))}')
    parts.append(f'"about": {json.dumps(_about(system))}')
    parts.append(f'"texts": {json.dumps(_texts(system))}')
    sources = ",\n".join(map(json_line, value_sources(system)))
    parts.append(f'"sources": [\n{sources}\n]' if sources else '"sources": []')
    for key, cases in (("messages", messages), ("conversions", conversions)):
        lines = ",\n".join(json_line(case) for case in cases)
        parts.append(f'"{key}": [\n{lines}\n]')
    return "{" + ",\n".join(parts) + "}\n"


def _instances(components: Mapping[str, Component]) -> dict[str, int]:
    """Return how many of each component exist: the runner reaches the n-th of several through a list."""
    return {"parameters": 1, **{name: component.instances for name, component in components.items()}}


def _about(system: System) -> dict[str, int]:
    """Return by message the count of numbers that tell a function its instance and page."""
    counts = {message.name: message_about(message) for message in system.messages}
    return {name: len(told) for name, told in counts.items() if told}


def _texts(system: System) -> dict[str, list[str]]:
    """Return by message the fields of bytes, not of characters, that carry a text."""
    return {
        message.name: fields
        for message in system.messages
        if (fields := [answer.covers.field.name for answer in message.answers if _is_text_in_bytes(answer)])
    }


def _is_text_in_bytes(answer: Answer) -> bool:
    is_text = any(quantity.kind is QuantityKind.TEXT for quantity in answer.carried)
    is_text = is_text or any(isinstance(value, str) for value in answer.constants)
    return is_text and answer.covers.field.type.kind is not Kind.CHAR


def dialect_files(system: System) -> dict[str, object]:
    """Return what pymavlink needs to make the same dialect: the one that it ships, and the project's own files.

    The paths of these are relative to the folder of the tests.
    """
    spec = system.spec
    is_file = spec.project.dialect.endswith(".xml")
    own = [*([spec.project.dialect] if is_file else []), *spec.project.overlays]
    tests = os.path.join(spec.folder, spec.project.output, "tests")
    files = [os.path.relpath(os.path.join(spec.folder, name), tests).replace(os.sep, "/") for name in own]
    about: dict[str, object] = {"shipped": None if is_file else spec.project.dialect, "files": files}
    changes = [change for correction in spec.corrections if (change := _wire_changes(correction))]
    return {**about, "corrections": changes} if changes else about


def _wire_changes(correction: Correction) -> dict[str, object]:
    """Return what a correction changes of the bytes that are sent: an id, a type,
    the value of an entry; else nothing.
    """
    names = ("message", "field", "enum", "entry")
    changes = {name: text.strip() for name, text in correction.set.items() if name in ("id", "type", "value")}
    named = {name: getattr(correction, name) for name in names if getattr(correction, name) is not None}
    return {**named, "set": changes} if changes else {}


def json_line(case: dict[str, object]) -> str:
    """A record in one line, as UTF-8: MicroPython's json does not read a character in two escapes."""
    try:
        return json.dumps(case, allow_nan=False, ensure_ascii=False)
    except ValueError:
        return json.dumps(_without_nan(case), allow_nan=False, ensure_ascii=False)


def _without_nan(value: object) -> object:
    """JSON has no NaN and nothing infinite: they are written as texts, "nan", "inf" and "-inf"."""
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_without_nan(item) for item in value]
    return value
