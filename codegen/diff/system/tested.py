"""Changes of what tests show: criteria that lost their tests, and tests and rows whose criterion is gone."""

from collections.abc import Iterator, Mapping

from codegen.diff.change import Change, changed
from codegen.diff.system.requirements import as_called_now, is_answered
from codegen.diff.system.trace_rules import ORPHANED, UNTESTED
from codegen.source import Place
from codegen.trace.graph import Trace


def tested_changes(old: Trace, new: Trace, ids: Mapping[str, str]) -> Iterator[Change]:
    """Yield what is no longer shown, then what shows nothing that is asked for, in the order of the documents.

    ``ids`` are those of documents that have another one now, by the old ones.
    """
    called = {as_called_now(name, ids): name for name in old.criteria}
    for name, (_, criterion) in new.criteria.items():
        before = called.get(name, name)
        is_uncovered = is_answered(before, old.rows_of) and not is_answered(name, new.rows_of)  # which is told
        if before in old.criteria and old.tests_of.get(before) and not new.tests_of.get(name) and not is_uncovered:
            shown = ", ".join(dict.fromkeys(test.name for test in old.tests_of[before]))
            places = old.criteria[before][1].place, criterion.place
            yield changed(UNTESTED, name, f"shown by {shown}", "shown by no test", places, cited=(name,))
    for name, before in called.items():
        if name not in new.criteria:
            yield from _orphans(name, old.criteria[before][1].place, new)


def _orphans(name: str, was_at: Place, new: Trace) -> Iterator[Change]:
    citing = {test.name: test.place for test in new.tests_of.get(name, ()) if test.place is not None}
    citing |= {row.label: row.place for row in new.rows_of.get(name, ())}
    for label, place in citing.items():
        yield changed(ORPHANED, label, f"answers to {name}", f"{name} is gone", (was_at, place), cited=(name,), rows=())
