"""Looks up a component of the vehicle state by the name that some other part of the specification gives it."""

from collections.abc import Mapping
from typing import TypeVar

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.spec.state import StateSpec
from codegen.source import Place

_Resolved = TypeVar("_Resolved")


def find_component(
    name: str,
    resolved: Mapping[str, _Resolved],
    state: StateSpec,
    rule: Rule,
    place: Place,
    report: Report,
    hint: str | None = None,
) -> _Resolved | None:
    """Return the entry of component ``name`` in ``resolved``, which has one for each component that could be read.

    None, with a finding of ``rule`` at ``place``, where state.yaml has no such component; ``hint`` stands in it where
    no name is spelled alike. None without a finding where the component is written but faulty: that has been reported.
    """
    found = resolved.get(name)
    if found is None and not state.has_written(name):
        report.add(
            rule,
            place,
            f"the state has no component {name}",
            did_you_mean(name, resolved) or hint or f"components: {{{name}: ...}}",
        )
    return found
