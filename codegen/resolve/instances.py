"""Resolves the instances of a component, and the facts about each."""

from collections.abc import Mapping

from codegen.diagnostics import Report, Rule
from codegen.model.spec.spec import Spec
from codegen.model.vehicle import Component, Instance
from codegen.pattern import pattern
from codegen.resolve.quantities.component import find_component
from codegen.source import Place

BAD_INSTANCES = Rule(
    "bad-instances",
    "The instances of a component in board.yaml contradict themselves or the rest: there are 1 to 16, of a component "
    "that state.yaml has; prefixes are different and of the form BATT2_; defaults are those of the instance's own "
    "parameters, within their limits.",
    remedy="write defaults of parameters with for_each, and instances of components of state.yaml",
)
MOST_INSTANCES = 16
MOST_LETTERS = 12

_PREFIX = pattern(r"[A-Z][A-Z0-9_]{0,14}")


def resolve_instances(spec: Spec, report: Report) -> dict[str, tuple[Instance, ...]]:
    """The instances by component, one at least for each component of the state."""
    board = spec.board
    for name, written in board.instances.items():
        place = board.at(f"instances.{name}")
        if find_component(name, spec.state.components, spec.state, BAD_INSTANCES, place, report) is None:
            continue
        if not 1 <= len(written) <= MOST_INSTANCES:
            front = name[:4].upper()
            message = f"{name} has {len(written)} instances, not 1 to {MOST_INSTANCES}"
            report.add(BAD_INSTANCES, place, message, f"list each: [{{prefix: {front}1_}}, {{prefix: {front}2_}}]")
        _check_prefixes(spec, name, report)
    return {name: _parts(spec, name) for name in spec.state.components}


def _parts(spec: Spec, name: str) -> tuple[Instance, ...]:
    common = spec.board.facts.get(name, {})
    written = spec.board.instances.get(name, ())[:MOST_INSTANCES]
    parts = (Instance(number, each.prefix or "", {**common, **each.facts}) for number, each in enumerate(written))
    return tuple(parts) or (Instance(0, "", common),)


def _check_prefixes(spec: Spec, name: str, report: Report) -> None:
    written = spec.board.instances[name]
    needs_prefix = any(parameter.for_each == name for parameter in spec.parameters.parameters.values())
    owners: dict[str, Place] = {}
    for number, each in enumerate(written, 1):
        if each.prefix is None:
            if needs_prefix:
                hint = f"prefix: {_usual_prefix(spec, name, number)}"
                report.add(BAD_INSTANCES, each.place, f"this {name} has no prefix for its parameters", hint)
            continue
        place = each.at("prefix")
        if not _PREFIX.fullmatch(each.prefix):
            report.add(
                BAD_INSTANCES,
                place,
                f"{each.prefix} cannot be the front of a parameter's name",
                hint=f"write it like {_usual_prefix(spec, name, number)}",
            )
        first = owners.setdefault(each.prefix, place)
        if first is not place:
            related = [(first, "it is taken here")]
            report.add(
                BAD_INSTANCES,
                place,
                f"{each.prefix} is the prefix of another {name}",
                related=related,
                hint=f"write another one, such as {_usual_prefix(spec, name, number)}",
            )


def _usual_prefix(spec: Spec, name: str, number: int) -> str:
    """A prefix that the parameters of the component take: of the first instance the beginning of their names.

    ``CELL_`` and ``CELL2_`` for CELL_CAP, which is the parameter of the first one.
    """
    families = [each for each, written in spec.parameters.parameters.items() if written.for_each == name]
    first = families[0].partition("_")[0] if families else ""
    if not 0 < len(first) <= MOST_LETTERS or not all(each.startswith(f"{first}_") for each in families):
        return f"{name[:4].upper()}{number}_"
    return f"{first}_" if number == 1 else f"{first.rstrip('0123456789')}{number}_"


def known_facts(spec: Spec, components: Mapping[str, Component]) -> list[str]:
    """Every fact that board.yaml states, as tables name them: ``battery.cells``."""
    names = {f"{owner}.{fact}" for owner, facts in spec.board.facts.items() for fact in facts}
    names |= {
        f"{name}.{fact}" for name, component in components.items() for part in component.parts for fact in part.facts
    }
    return sorted(names)
