"""The way of the data for ``codegen bench``: what a board has to know, and what its results are about."""

from collections.abc import Iterable

from codegen.model.system import System
from codegen.targets.suite.facts.bench import bench_facts, bench_inputs


def facts_for_bench(system: System) -> tuple[dict[str, object], str]:
    """What `codegen bench` has to know of a program, and the hash of the specification that its results are about."""
    return bench_facts(system), bench_inputs(system)


def bench_inputs_of(systems: Iterable[System]) -> dict[tuple[str, str], str]:
    """By project and program the hash of the specification that results of `codegen bench` have to be about."""
    return {(each.spec.project.project, each.spec.program): bench_inputs(each) for each in systems}
