"""The trace for the terminal: a summary, or everything that hangs on some criteria."""

from collections.abc import Iterator, Sequence
from textwrap import wrap

from codegen.trace.view import CriterionView, DocumentView, RowView, TraceView

WIDTH = 100
"""Columns of a line of prose."""
SUSPECT = "  suspect"
"""The mark behind a link that was made for another text."""


def summary_text(view: TraceView) -> str:
    """Return what there is, and how the tests of the criteria went."""
    totals = ", ".join(f"{number} {what}" for number, what in view.totals)
    lines = [f"{view.project}:", *wrap(totals, WIDTH, initial_indent="  ", subsequent_indent="  ")]
    width = max((len(status) for status, _, _ in view.verdicts), default=0)
    lines += [f"  {status:<{width}} {number:>4}" for status, number, _ in view.verdicts]
    if view.uncited:
        lines.append(
            f"{view.uncited} {'row cites' if view.uncited == 1 else 'rows cite'} nothing: --fail-on uncited lists them."
        )
    if view.has_results:
        lines.append(f"Results: {', '.join(view.results)}")
    else:
        lines.append("No results were given: --results FILE takes what pytest --junit-xml=FILE writes.")
    if not view.is_locked:
        lines.append(
            'Nothing was reviewed yet: codegen trace accept --all --reason "..." notes the texts as they are now.'
        )
    return "\n".join(lines) + "\n"


def tree_text(view: TraceView) -> str:
    """The documents and criteria, each with its rows, symbols and tests."""
    parts = ["\n".join(_document(document)) for document in (*view.documents, *view.decisions)]
    return "\n\n".join(parts) + "\n" if parts else ""


def _document(document: DocumentView) -> Iterator[str]:
    yield f"{document.id} | {document.title} ({document.status})  {document.place}"
    shared = document.criteria[0].rows_by_document if document.criteria else ()
    if shared:
        yield "  the document as a whole is cited by"
        yield from _rows(shared, "    ")
    for one in document.criteria:
        yield ""
        yield from _criterion(one)


def _criterion(one: CriterionView) -> Iterator[str]:
    notes = [one.status, *([one.result] if one.result else []), *([one.review] if one.review else [])]
    yield f"  {one.name}  [{'; '.join(notes)}]  {one.place}"
    yield from wrap(one.text, WIDTH, initial_indent="    ", subsequent_indent="    ")
    if one.rows:
        yield "    rows"
        yield from _rows(one.rows, "      ")
    if one.symbols:
        yield "    symbols"
        for symbols in one.symbols:
            names = f"{symbols.file}: {', '.join(symbols.names)}"
            yield from wrap(names, WIDTH, initial_indent="      ", subsequent_indent="        ")
    if one.tests:
        yield "    tests"
        for test in one.tests:
            about = "; ".join(filter(None, (test.cases, test.result)))
            suspect = SUSPECT if test.is_suspect else ""
            yield f"      {test.name}{f'  ({about})' if about else ''}{suspect}"
    yield from _dependencies(one)
    if one.host_limit:
        yield "    a host cannot show all of it"
        yield from wrap(one.host_limit, WIDTH, initial_indent="      ", subsequent_indent="      ")


def _dependencies(one: CriterionView) -> Iterator[str]:
    if one.depends_on:
        yield "    depends on"
    for each in one.depends_on:
        yield f"      {each.name}{f', {each.note}' if each.note else ''}"
    if one.needed_by:
        yield "    is needed by"
    for each in one.needed_by:
        yield f"      {each.name}{SUSPECT if each.is_suspect else ''}"


def _rows(rows: Sequence[RowView], indent: str) -> Iterator[str]:
    width = max(len(f"{row.kind} {row.label}") for row in rows)
    for row in rows:
        suspect = SUSPECT if row.is_suspect else ""
        yield f"{indent}{f'{row.kind} {row.label}':<{width}}  {row.place}{suspect}"
