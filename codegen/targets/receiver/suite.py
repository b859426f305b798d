"""The generated tests of the receiver: what it must say for the cases of the suite, by exact arithmetic."""

import ast
import json
from collections.abc import Iterator, Mapping
from functools import cache

from codegen.model.receiver import Receiver
from codegen.model.system import Binding, EachBinding, FlagsBinding, LiveBinding, PopulatedMessage, SplitBinding, System
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.targets.expected import is_settable
from codegen.targets.origin import copied_files, origin_of, specification_file
from codegen.targets.receiver.view import ReceiverView
from codegen.template_files import copied

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
        "requirement": view.citation,
        "module": view.module,
        "class": view.views_class,
        "component": view.component,
        "stale_ms": receiver.stale_after_ms,
        "messages": {
            message.name: {
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
    """What a message says about each quantity: where the state keeps it, and how exactly it must come back."""
    seen: set[str] = set()
    for binding in message.bindings:
        for quantity, about in _abouts(binding):
            if quantity.component == receiver.component.name and quantity.name not in seen:
                seen.add(quantity.name)
                about["is_extension"] = binding.covers.field.definition.is_extension
                yield quantity.name, about


def _abouts(binding: Binding) -> Iterator[tuple[Quantity, dict[str, object]]]:
    if isinstance(binding, LiveBinding | SplitBinding) and isinstance(binding.source, Quantity):
        yield binding.source, _number(binding, binding.source)
    elif isinstance(binding, EachBinding):
        # Pages, and what is spread where single values are unknown, have tests of their own.
        if binding.fallback is not None:
            about = _number(binding.fallback, binding.fallback.source)
            yield binding.fallback.source, {**about, "unless": binding.source.attribute}
    elif isinstance(binding, FlagsBinding):
        for _, value, quantity in binding.conditional:
            alone = sum(other == value for _, other, _ in binding.conditional) == 1
            if is_settable(quantity) and quantity.enabled_by is None and alone:
                yield quantity, {"stored": quantity.attribute, "boolean": True}


def _number(binding: LiveBinding | SplitBinding, source: Quantity) -> dict[str, object]:
    """All in the unit of the quantity; ``within`` is one unit of the wire, or what a float of the wire resolves."""
    to_unit = 1 / (binding.factor * source.steps)
    one = to_unit if binding.covers.field.type.is_integer else 1 / source.steps / 2
    return {
        "stored": source.attribute,
        "steps": float(source.steps) if source.kind is QuantityKind.NUMBER else 1,
        "low": float(binding.low * to_unit),
        "high": float(binding.high * to_unit),
        "within": float(one),
        "stands_in": None if source.initial is None else float(source.initial / source.steps),
    }


@cache
def shown_by_receiver_tests() -> Mapping[str, tuple[int, ...]]:
    """The tests by name, with the numbers of the criteria that they are marked with."""
    module = ast.parse(copied(f"{_SUITE}/test_receiver.py"))
    return {
        statement.name: tuple(map(ast.literal_eval, mark.args))
        for statement in module.body
        if isinstance(statement, ast.FunctionDef)
        for mark in statement.decorator_list
        if isinstance(mark, ast.Call) and ast.unparse(mark.func) == "shows"
    }
