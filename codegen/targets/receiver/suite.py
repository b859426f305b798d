"""The generated tests of the receiver: what it must say for the cases of the suite, by exact arithmetic."""

import ast
import json
from collections.abc import Iterator, Mapping
from functools import cache

from codegen.model.receiver import Receiver
from codegen.model.system import PopulatedMessage, System
from codegen.targets.origin import copied_files, origin_of, specification_file
from codegen.targets.receiver.view import ReceiverView
from codegen.tool.template_files import copied

_SUITE = "tests/receiver"


def render_receiver_suite(system: System, receiver: Receiver, view: ReceiverView) -> dict[str, str]:
    """The files below ``tests/`` that are about the receiver."""
    files = {path.replace(_SUITE, "tests"): text for path, text in copied_files(_SUITE).items()}
    tables = [message.population.place.file for message in receiver.messages]
    names = [specification_file(system, f"{name}.yaml") for name in ("receiver", "state")]
    origin = origin_of(system, [*names, *tables], [message.wire for message in receiver.messages])
    names_by_key = {quantity.key: quantity.name for quantity in view.quantities}
    facts = {
        "generated": {"from": list(origin.sources), "inputs": origin.digest},
        "criteria": {aspect: str(citation) for aspect, citation in receiver.aspects.items()},
        "module": view.module,
        "class": view.views_class,
        "component": view.component,
        "stale_ms": receiver.stale_after_ms,
        "messages": {
            message.wire.name: {
                "number": reader.number_field,
                "attributes": {
                    names_by_key[name]: about
                    for name, about in _attributes(message, receiver)
                    if name in {reading.name for reading in reader.readings}
                },
            }
            for message, reader in zip(receiver.messages, view.readers, strict=True)
        },
    }
    files["tests/receiver_facts.json"] = json.dumps(facts, indent=1) + "\n"
    return files


def _attributes(message: PopulatedMessage, receiver: Receiver) -> Iterator[tuple[str, dict[str, object]]]:
    """Yield what a message says about each quantity: where the state keeps it, and how exactly it must come back."""
    seen: set[str] = set()
    for answer in message.answers:
        for read in answer.read_back():
            name = read.quantity.name
            if read.quantity.component == receiver.component.name and name not in seen:
                seen.add(name)
                yield name, {**read.about, "is_extension": answer.covers.field.definition.is_extension}


@cache
def shown_by_receiver_tests() -> Mapping[str, tuple[str, ...]]:
    """The tests by name, with the aspects that they are marked with."""
    module = ast.parse(copied(f"{_SUITE}/test_receiver.py"))
    return {
        statement.name: tuple(map(ast.literal_eval, mark.args))
        for statement in module.body
        if isinstance(statement, ast.FunctionDef)
        for mark in statement.decorator_list
        if isinstance(mark, ast.Call) and ast.unparse(mark.func) == "shows"
    }
