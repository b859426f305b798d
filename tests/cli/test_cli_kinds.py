"""The command line writes out what can fail, so as to start without the modules that know it: both have to agree."""

from codegen.cli import diff, trace
from codegen.diff.change import Area
from codegen.diff.report.review import FailOn
from codegen.trace import findings


def test_diff_offers_every_kind_of_change() -> None:
    assert (*FailOn, *Area) == diff.KINDS


def test_trace_offers_every_kind_of_finding_and_counts_the_same_by_default() -> None:
    assert tuple(findings.KINDS) == trace.KINDS
    assert trace.COUNTED == findings.COUNTED
