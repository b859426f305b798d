"""A part of a specification that comes, goes or is another one is told under a rule of its own, in either direction."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_dialects, compare_systems
from codegen.model.spec.spec import ParameterType, Requirement
from codegen.model.system import System
from codegen.project.systems import read_system

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def system() -> System:
    """The shipped specification."""
    found = read_system(str(ROOT / "specs" / "codegen.yaml"), Report())
    assert found is not None
    return found


def less(value: Any) -> Any:
    """A mapping or a tuple without its last member."""
    return dict(list(value.items())[:-1]) if isinstance(value, Mapping) else value[:-1]


def without_quantity(system: System) -> System:
    name, component = list(system.components.items())[-1]
    changed = replace(component, quantities=less(component.quantities))
    return replace(system, components={**system.components, name: changed})


def with_one_battery(system: System) -> System:
    """A component of several instances has one less."""
    component = next(each for each in system.components.values() if each.instances > 1)
    return replace(
        system, components={**system.components, component.name: replace(component, parts=less(component.parts))}
    )


def updated_otherwise(system: System) -> System:
    component = next(each for each in system.components.values() if each.period_ms is not None)
    changed = replace(component, period_ms=(component.period_ms or 0) + 1)
    return replace(system, components={**system.components, component.name: changed})


def with_parameter(system: System, **spec: Any) -> System:
    parameter = next(each for each in system.parameters.values() if each.spec.type is ParameterType.INT32)
    changed = replace(parameter, spec=replace(parameter.spec, **spec))
    return replace(system, parameters={**system.parameters, parameter.name: changed})


def with_documents(system: System, change: Callable[[Requirement], Requirement | None]) -> System:
    """The document that messages cite most is another one, or gone."""
    first = system.messages[0].citation.requirement
    found = {name: change(each) if each is first else each for name, each in system.requirements.items()}
    return replace(system, requirements={name: each for name, each in found.items() if each is not None})


CASES: Mapping[str, tuple[Callable[[System], System], str]] = {
    "parameter-removed": (lambda system: replace(system, parameters=less(system.parameters)), "parameter-added"),
    "parameter-changed": (lambda system: with_parameter(system, reboot=True), "parameter-changed"),
    "parameter-type-changed": (
        lambda system: with_parameter(system, type=ParameterType.UINT8),
        "parameter-type-changed",
    ),
    "doc-changed": (lambda system: with_parameter(system, doc="Otherwise."), "doc-changed"),
    "component-removed": (lambda system: replace(system, components=less(system.components)), "component-added"),
    "component-instances-changed": (with_one_battery, "component-instances-changed"),
    "component-rate-changed": (updated_otherwise, "component-rate-changed"),
    "quantity-removed": (without_quantity, "quantity-added"),
    "stream-removed": (lambda system: replace(system, streams=less(system.streams)), "stream-added"),
    "link-changed": (lambda system: replace(system, links=less(system.links)), "link-changed"),
    "message-no-longer-sent": (lambda system: replace(system, messages=less(system.messages)), "message-sent"),
    "requirement-removed": (lambda system: with_documents(system, lambda _: None), "requirement-added"),
    "criterion-removed": (
        lambda system: with_documents(system, lambda each: replace(each, criteria=less(each.criteria))),
        "criterion-added",
    ),
    "criterion-uncovered": (lambda system: replace(system, messages=()), "criterion-covered"),
    "document-text-changed": (
        lambda system: with_documents(system, lambda each: replace(each, said=f"{each.said}x")),
        "document-text-changed",
    ),
}
"""By the rule of what goes: how it goes, and the rule under which it comes back."""


@pytest.mark.parametrize("goes", CASES)
def test_is_told_in_either_direction(goes: str, system: System) -> None:
    """The reports on a change and on its reversal have both."""
    change, comes = CASES[goes]
    other = change(system)
    for old, new, wanted in ((system, other, goes), (other, system, comes)):
        assert wanted in {found.rule.id for found in compare_systems((old,), (new,)).changes}


def test_fields_in_another_order_are_told(system: System) -> None:
    """Two fields of one type that change places: each is read for the other."""
    wire = system.dialect.messages["SYS_STATUS"]
    first, second, *others = wire.fields
    assert first.type == second.type
    swapped = (replace(second, offset=first.offset), replace(first, offset=second.offset), *others)
    messages = {**system.dialect.messages, wire.name: replace(wire, fields=swapped)}
    changes = compare_dialects(system.dialect, replace(system.dialect, messages=messages)).changes
    assert "field-order-changed" in {found.rule.id for found in changes}
