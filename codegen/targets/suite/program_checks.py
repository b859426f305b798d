"""The checks of the program in the generated suite: which scripts have which, and what each shows."""

import ast
import re
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from codegen.model.program import Program
from codegen.model.system import System
from codegen.targets.suite.criteria import check_criteria
from codegen.targets.suite.program import left_out
from codegen.tool.template_files import copied, plain_files

ONLY_MICROPYTHON = ("heap", "steady")
"""Scripts that measure what CPython does not have; test_program.py of the suite leaves them out there, too."""

_FOLDER = "tests/program"
_ENDING = "_checks.py"
_CHECKS = re.compile(r"^CHECKS = (\(.*?^\)|\(.*?\)$)", re.MULTILINE | re.DOTALL)


class ProgramCheck(NamedTuple):
    """A function of a script, with the criteria that it shows.

    ``identifier`` is what the suite calls the check: its name, and what it shows.
    """

    script: str
    name: str
    criteria: tuple[str, ...]

    @property
    def identifier(self) -> str:
        """``low_after_the_timer-FR-00020.1``."""
        return "-".join((self.name, *self.criteria))


def program_checks(system: System, program: Program) -> Iterator[ProgramCheck]:
    """Every check of the scripts that the suite of a system has."""
    named = check_criteria(system, program)
    absent = left_out(system, program)
    for file in plain_files(_FOLDER):
        if file.endswith(_ENDING) and f"tests/{file}" not in absent:
            for name, aspects in _listed(file):
                criteria = dict.fromkeys(each for aspect in aspects for each in named.get(aspect, ()))
                yield ProgramCheck(file.removesuffix(_ENDING), name, tuple(criteria))


@cache
def _listed(file: str) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Name and aspects of each check of a script, without running it."""
    found = _CHECKS.search(copied(f"{_FOLDER}/{file}"))
    assert found is not None, file
    listed = ast.parse(found[1], mode="eval").body
    assert isinstance(listed, ast.Tuple), file
    return tuple(_check(entry) for entry in listed.elts)


def _check(entry: ast.expr) -> tuple[str, tuple[str, ...]]:
    assert isinstance(entry, ast.Tuple)
    check, *aspects = entry.elts
    assert isinstance(check, ast.Name)
    return check.id, tuple(map(ast.literal_eval, aspects))


def checked_aspects() -> frozenset[str]:
    """Every aspect that a check of the program shows."""
    files = [file for file in plain_files(_FOLDER) if file.endswith(_ENDING)]
    return frozenset(aspect for file in files for _, aspects in _listed(file) for aspect in aspects)
