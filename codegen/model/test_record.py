"""What tests say about themselves: which criteria they show, and how their last run went."""

from enum import StrEnum
from typing import ClassVar, NamedTuple

from codegen.frozen import dataclass
from codegen.source import Place


class MarkedTest(NamedTuple):
    """A test function, or a method as ``TestClass::test_name``, and one criterion that it shows, with its place."""

    function: str
    shows: str
    place: Place


class Outcome(StrEnum):
    """How a test went; only what passed shows anything."""

    PASSED = "passed"
    FAILED = "failed"
    SKIPPED = "skipped"


@dataclass(frozen=True, slots=True)
class TestResult:
    """One test case of a file of results.

    ``module`` is the dotted name of the test's module, and of its class, as pytest writes it; ``name`` has the
    parameters in brackets. ``shows`` are the criteria that it was marked with, ``inputs`` the hash of the specification
    that a generated test was made of.
    """

    __test__: ClassVar[bool] = False  # pytest takes classes of such names for tests

    module: str
    name: str
    outcome: Outcome
    shows: tuple[str, ...]
    inputs: str | None
    place: Place
