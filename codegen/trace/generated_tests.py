"""The tests of the generated suites: which there are for a system, by pytest's names, and what each shows."""

import os
from collections.abc import Iterable, Iterator
from dataclasses import replace

from codegen.model.system import System
from codegen.model.test_record import specification_hash
from codegen.targets.receiver.suite import shown_by_receiver_tests
from codegen.targets.suite.amounts.file import amount_tests
from codegen.targets.suite.behaviour import checks_of_behaviour
from codegen.targets.suite.cases.messages import conversion_cases, message_cases
from codegen.targets.suite.cases.receptions import reception_cases
from codegen.targets.suite.files import suite_origin
from codegen.targets.suite.program_checks import ONLY_MICROPYTHON, program_checks
from codegen.targets.suite.sources import source_checks
from codegen.trace.graph import Test

INTERPRETERS = ("cpython", "micropython")


def tests_of(system: System) -> tuple[Test, ...]:
    """The tests of the suite of a project or a further program, one for each criterion that they show."""
    inputs = suite_origin(system).digest
    return tuple(replace(test, inputs=inputs) for test in _tests(system))


def inputs_of(systems: Iterable[System]) -> str:
    """The hash of all suites of a project: what results of tests written by hand have to say."""
    return specification_hash({system.spec.program: suite_origin(system).digest for system in systems})


def suite_folder(system: System) -> str:
    """The folder of a system's suite below that of the project, with slashes: ``generated/tests``."""
    spec = system.spec
    output = os.path.join(os.path.basename(spec.folder), spec.project.output, "tests")
    return os.path.normpath(output).replace(os.sep, "/")


def _tests(system: System) -> Iterator[Test]:
    folder = suite_folder(system)
    frames: dict[tuple[str, str], list[str]] = {}
    for case in message_cases(system):
        identifier = f"{case.name}-{case.requirement}"
        for criterion in (case.requirement, *case.also):
            frames.setdefault((criterion, case.table), []).extend(_under_each(identifier))
    for (criterion, message), cases in frames.items():
        yield Test(f"{folder}/test_frames.py", "test_frames", criterion, tuple(cases), message)
    yield from _grouped(
        f"{folder}/test_frames.py",
        "test_conversion",
        ((case.requirement, f"{case.name}-{case.requirement}") for case in conversion_cases(system)),
    )
    checks = ((check.criterion, check.identifier) for check in checks_of_behaviour(system))
    yield from _grouped(f"{folder}/test_behaviour.py", "test_behaviour", checks)
    received = ((case.requirement, case.identifier) for case in reception_cases(system))
    yield from _grouped(f"{folder}/test_receives.py", "test_receives", received)
    yield from _grouped(f"{folder}/test_sources.py", "test_source", source_checks(system))
    yield from _grouped(f"{folder}/test_amounts.py", "test_amount", amount_tests(system))
    yield from _of_program(system, folder)
    yield from _of_receiver(system, folder)


def _of_program(system: System, folder: str) -> Iterator[Test]:
    if system.program is None:
        return
    found: dict[str, list[str]] = {}
    for check in program_checks(system, system.program):
        interpreters = INTERPRETERS[-1:] if check.script in ONLY_MICROPYTHON else INTERPRETERS
        cases = [f"{interpreter}-{check.script}-{check.identifier}" for interpreter in interpreters]
        for criterion in check.criteria:
            found.setdefault(criterion, []).extend(cases)
    for criterion, cases in found.items():
        yield Test(f"{folder}/test_program.py", "test_program", criterion, tuple(cases))


def _of_receiver(system: System, folder: str) -> Iterator[Test]:
    receiver = system.receiver
    if receiver is None:
        return
    for function, aspects in shown_by_receiver_tests().items():
        shown = [receiver.aspects[aspect] for aspect in aspects if aspect in receiver.aspects]
        for criterion in dict.fromkeys(map(str, shown)):
            yield Test(f"{folder}/test_receiver.py", function, criterion)


def _grouped(file: str, function: str, cases: Iterable[tuple[str, str]]) -> Iterator[Test]:
    found: dict[str, list[str]] = {}
    for criterion, identifier in cases:
        if criterion:
            found.setdefault(criterion, []).extend(_under_each(identifier))
    for criterion, listed in found.items():
        yield Test(file, function, criterion, tuple(listed))


def _under_each(identifier: str) -> Iterator[str]:
    return (f"{interpreter}-{identifier}" for interpreter in INTERPRETERS)
