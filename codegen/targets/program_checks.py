"""The checks of the program in the generated suite: which scripts have which, and what each shows."""

import ast
import re
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from codegen.model.program import Program
from codegen.model.system import System
from codegen.targets.program_suite import LEFT_TO_THE_PROJECT, documents_of_topics
from codegen.template_files import copied, plain_files

ONLY_MICROPYTHON = ("heap", "steady")
"""Scripts that measure what CPython does not have; test_program.py of the suite leaves them out there, too."""

_FOLDER = "tests/program"
_ENDING = "_checks.py"
_CHECKS = re.compile(r"^CHECKS = (\(.*?^\)|\(.*?\)$)", re.MULTILINE | re.DOTALL)


class ProgramCheck(NamedTuple):
    """A function of a script, with the criterion that it shows: ``number`` of ``document``, which is "" for none.

    ``identifier`` is what the suite calls the check: its name, and what it shows.
    """

    script: str
    name: str
    topic: str
    document: str
    number: int

    @property
    def identifier(self) -> str:
        """``low_after_the_timer-FR-00020.1``, or with the topic where no document is cited."""
        return f"{self.name}-{self.document}.{self.number}" if self.document else f"{self.name}-{self.topic}"


def program_checks(system: System, program: Program) -> Iterator[ProgramCheck]:
    """Every check of the scripts that the suite of a system has."""
    documents = documents_of_topics(system, program)
    left_out = LEFT_TO_THE_PROJECT if system.spec.program else ()
    for file in plain_files(_FOLDER):
        if file.endswith(_ENDING) and f"tests/{file}" not in left_out:
            for topic, number, name in _listed(file):
                yield ProgramCheck(file.removesuffix(_ENDING), name, topic, documents.get(topic, ""), number)


@cache
def _listed(file: str) -> tuple[tuple[str, int, str], ...]:
    """Topic, number and name of each check of a script, without running it."""
    found = _CHECKS.search(copied(f"{_FOLDER}/{file}"))
    assert found is not None, file
    listed = ast.parse(found[1], mode="eval").body
    assert isinstance(listed, ast.Tuple), file
    return tuple(_check(entry) for entry in listed.elts)


def _check(entry: ast.expr) -> tuple[str, int, str]:
    assert isinstance(entry, ast.Tuple)
    topic, number, check = entry.elts
    assert isinstance(check, ast.Name)
    return ast.literal_eval(topic), ast.literal_eval(number), check.id
