"""The page on what comes in and what follows: received messages, commands, failsafes, sensors and the main loop."""

from collections.abc import Iterator
from dataclasses import replace

from codegen.frozen import dataclass
from codegen.loop.budget import loop_budget, why_not_predicted
from codegen.loop.shares import shares
from codegen.loop.words import (
    COLUMNS,
    COLUMNS_WITHOUT_TIMES,
    NOT_COUNTED,
    job_words,
    load_words,
    rows,
    source_words,
    us_words,
)
from codegen.memory import words as memory_words
from codegen.memory.estimate import memory_estimate
from codegen.model.quantities.source_kind import hertz
from codegen.model.reception import Reception
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.summaries.receptions import condition_words, received_rows, sender_words
from codegen.targets.documents.program import program_section
from codegen.targets.origin import Origin, source_name
from codegen.targets.pages.navigation import PROGRAM_PAGE, Navigation, navigation


@dataclass(frozen=True, slots=True)
class TableView:
    """A table: ``columns`` are the names of its cells, the first cell of each row names it."""

    id: str
    title: str
    doc: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, slots=True)
class ProgramPage:
    """The page."""

    project: str
    origin: Origin
    navigation: Navigation
    tables: tuple[TableView, ...]


def program_page(system: System, origin: Origin) -> ProgramPage:
    """The view of the page."""
    received = (_received(table, system) for table in system.receptions)
    tables = (*received, *_done(system), *_sensors(system), *_loop(system), *_memory(system))
    return ProgramPage(
        project=system.spec.project.project,
        origin=origin,
        navigation=navigation(system, PROGRAM_PAGE),
        tables=tuple(_shown(table) for table in tables if table.rows),
    )


def _shown(table: TableView) -> TableView:
    """The table without columns in which nothing stands."""
    kept = [at for at in range(len(table.columns)) if any(row[at] for row in table.rows)]
    rows = tuple(tuple(row[at] for at in kept) for row in table.rows)
    return replace(table, columns=tuple(table.columns[at] for at in kept), rows=rows)


def _received(table: Reception, system: System) -> TableView:
    doc = f"{sender_words(table).capitalize()}; table {source_name(system, table.spec.place.file)}, {table.citation}."
    condition = condition_words(table)
    return TableView(
        id=f"received-{table.name.lower()}",
        title=f"{table.title}, received",
        doc=f"{doc} Only with {condition}." if condition else doc,
        columns=("Field", "Unit", "Sets", "Converted", "Taken", "Sets it unknown", "Leaves it", "Too old", "Criterion"),
        rows=tuple(
            (
                row.field,
                row.unit,
                row.quantity,
                row.conversion,
                row.taken,
                row.unknown,
                row.unchanged,
                f"after {taken.quantity.trust.stale_after_ms} ms" if taken.quantity.ages else "never",
                row.criterion,
            )
            for row, taken in zip(received_rows(table), table.fields, strict=True)
        ),
    )


def _done(system: System) -> Iterator[TableView]:
    section = program_section(system)
    if section is None:
        return
    yield TableView(
        id="commands",
        title="Commands",
        doc="By COMMAND_LONG and COMMAND_INT; what stands here is done, everything else is unsupported.",
        columns=("Command", "What it does", "Parameters", "Done", "By", "Criterion"),
        rows=tuple(
            tuple(_plain(cell) for cell in (row.name, row.doc, row.params, row.when, row.method, row.criterion))
            for row in section.commands
        ),
    )
    yield TableView(
        id="failsafes",
        title="Failsafes",
        doc="A level is reached once its condition has held for its time.",
        columns=("Watched", "Level", "While", "For", "Action", "Criterion"),
        rows=tuple(
            tuple(_plain(cell) for cell in (row.watched, row.level, row.when, row.after, row.action, row.criterion))
            for row in section.levels
        ),
    )
    priority = system.program.priority if system.program else ()
    yield TableView(
        id="actions",
        title="What failsafes do",
        doc="Of several the most severe holds, the first in this order: "
        + ", ".join(each.call for each in priority)
        + "."
        if priority
        else "Each failsafe acts for itself.",
        columns=("Call", "Value", "Mode", "Disarms", "What it is for"),
        rows=tuple((row.call, str(row.value), row.mode, row.disarms, _plain(row.doc)) for row in section.actions),
    )


def _sensors(system: System) -> Iterator[TableView]:
    yield TableView(
        id="sensors",
        title="Sensors",
        doc="Each is asked at its rate, one in a pass of the main loop.",
        columns=("Sensor", "What it is", "Gives", "Rate", "Longest turn", "Criterion"),
        rows=tuple(
            (
                source.name,
                source.words(),
                ", ".join(f"{output.name} [{output.unit.name}]".strip() for output in source.outputs).replace(
                    " []", ""
                ),
                f"{decimal(hertz(source.polling.period_us))} Hz",
                "" if source.polling.limit_us is None else f"{source.polling.limit_us} us",
                str(source.polling.citation or ""),
            )
            for source in system.polled
        ),
    )


def _loop(system: System) -> Iterator[TableView]:
    budget = loop_budget(system)
    if budget is None:
        return
    why = why_not_predicted(system)
    doc = f"control() is called every {budget.control_us} us, jobs after it. {load_words(budget)}"
    yield TableView(
        id="loop",
        title="Main loop",
        doc=" ".join([doc, *([f"No times: {why}."] if why else []), *NOT_COUNTED]),
        columns=tuple(name[:1].upper() + name[1:] for name in (COLUMNS_WITHOUT_TIMES if why else COLUMNS)),
        rows=tuple(rows(budget)),
    )
    yield TableView(
        id="loop-jobs",
        title="Jobs of the main loop",
        doc="In the order in which they run where several are due.",
        columns=("Job", "What it does"),
        rows=tuple((job.name, job_words(job)) for job in budget.jobs),
    )
    yield TableView(
        id="loop-longest",
        title="What takes the longest slot",
        doc=f"That of {budget.longest.words}, with all messages due. {source_words(budget)}",
        columns=("Part", "Takes", "Share"),
        rows=tuple((name, us_words(took), share) for name, took, share in shares(budget.longest, budget)),
    )


def _memory(system: System) -> Iterator[TableView]:
    estimate = memory_estimate(system)
    if estimate is None:
        return
    whole, source = memory_words.whole_words(estimate, system.board_name), memory_words.source_words(estimate)
    yield TableView(
        id="heap",
        title="Heap",
        doc=" ".join([whole, *memory_words.NOT_COUNTED, source]),
        columns=("Part", "Heap"),
        rows=tuple(memory_words.rows(estimate)),
    )


def _plain(text: str) -> str:
    """A cell of the Markdown document without its marks."""
    return text.replace("`", "").replace("\\|", "|")
