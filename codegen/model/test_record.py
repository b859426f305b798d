"""Tests and their results: the criteria that a test shows, and the outcome of its last run."""

import hashlib
from collections.abc import Mapping
from enum import StrEnum
from typing import ClassVar, NamedTuple

from codegen.frozen import dataclass
from codegen.source import Place

SPECIFICATION_PROPERTY = "codegen-specification"
"""Name of the property that says, in results of JUnit's format, with which specification a test was run."""


def specification_hash(suites: Mapping[str, str]) -> str:
    """One hash, 16 hex digits, of those of the generated suites by program; the project's own has no name."""
    listed = "".join(f"{program} {digest}\n" for program, digest in sorted(suites.items()))
    return hashlib.sha256(listed.encode()).hexdigest()[:16]


class MarkedTest(NamedTuple):
    """A test function, or a method as ``TestClass::test_name``, and one criterion that it shows, with its place."""

    function: str
    shows: str
    place: Place


class Outcome(StrEnum):
    """The outcome of a test; only a passed one shows anything."""

    PASSED = "passed"
    FAILED = "failed"
    SKIPPED = "skipped"


@dataclass(frozen=True, slots=True)
class TestResult:
    """One test case of a file of results.

    ``module`` is the dotted name of the test's module, and of its class, as pytest writes it; ``name`` has the
    parameters in brackets. ``shows`` are the criteria that it was marked with, ``inputs`` the hash of the specification
    that a generated test was made of, ``specification`` that of what a test written by hand was run with.
    ``uncollected`` is the dotted name of a module of which pytest could not collect the tests: there is no test then.
    """

    __test__: ClassVar[bool] = False  # pytest takes classes of such names for tests

    module: str
    name: str
    outcome: Outcome
    shows: tuple[str, ...]
    inputs: str | None
    place: Place
    specification: str | None = None
    uncollected: str = ""
