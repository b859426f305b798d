"""``codegen trace accept``: criteria whose rows and tests were reviewed with their text as it is now."""

from collections.abc import Mapping, Sequence

from codegen.commands.trace import Refused, chosen_criteria, read_trace, trace_lock_path
from codegen.decode.reach import within
from codegen.decode.trace_lock import decode_trace_lock, read_trace_lock_text
from codegen.diagnostics import Report
from codegen.emit.file import write_file
from codegen.frozen import dataclass
from codegen.load.files import DISK
from codegen.model.spec.trace_lock import TraceLockSpec
from codegen.model.system import System
from codegen.source import Place
from codegen.trace.graph import Trace
from codegen.trace.link import Link, chosen_link, suspects
from codegen.trace.lock import (
    LOCK_FORM,
    Review,
    accepted,
    gone,
    holds,
    lock_line,
    lock_line_by_link,
    required,
    reviews,
)


@dataclass(frozen=True, slots=True)
class LookedAt:
    """A review by a person: of the criteria or documents ``names``, or of ``all`` that are not reviewed.

    Of one criterion that may be some of its suspect ``links`` alone. ``reason`` says what was looked at, ``by`` who
    looked.
    """

    names: Sequence[str]
    all: bool
    links: Sequence[str]
    reason: str
    by: str | None


@dataclass(frozen=True, slots=True)
class Accepted:
    """The new content of the lock file at ``path``: the accepted ``criteria``, and those that were ``dropped``."""

    path: str
    criteria: Sequence[str]
    dropped: Sequence[str]


def accept(project: str, systems: Sequence[System], seen: LookedAt, report: Report) -> Accepted | Refused | None:
    """Write the lock file, all other entries as they are.

    Refused where what is named cannot be accepted; None after a finding about the lock file.
    """
    path = trace_lock_path(project)
    written = read_trace_lock_text(path, within(project, DISK), report)
    lock = None if written is None else decode_trace_lock(written, path, report)
    if report.has_errors:
        return None
    trace = read_trace(systems, Report())
    dropped = list(gone(trace, lock))
    names = _names(seen.names, trace, dropped)
    if isinstance(names, Refused):
        return names
    if seen.all:
        names = [name for name, review in reviews(trace, lock).items() if review is not Review.REVIEWED]
    else:
        dropped = [name for name in dropped if name in seen.names]
    lines = _lines(names, trace, lock, seen)
    if isinstance(lines, Refused):
        return lines
    text = accepted(written, lines, dropped)
    reading = Report()
    read_back = decode_trace_lock(text, path, reading)
    if reading.has_errors or not holds(read_back, lock, lines.keys(), dropped):
        report.add(LOCK_FORM, Place(path), "it has to have one line for each criterion")
    elif text != written:
        write_file(path, text, report)
    return None if report.has_errors else Accepted(path, list(lines), dropped)


def _names(asked: Sequence[str], trace: Trace, dropped: Sequence[str]) -> list[str] | Refused:
    """Return the criteria that are meant, in their order, without those that only decide."""
    known = [name for name in asked if name not in dropped]
    chosen = chosen_criteria(known, trace) if known else set()
    return chosen if isinstance(chosen, Refused) else [name for name in required(trace) if name in chosen]


def _lines(
    names: Sequence[str], trace: Trace, lock: TraceLockSpec | None, seen: LookedAt
) -> Mapping[str, str] | Refused:
    """Return the lines of the lock file by criterion: of all of its links, or of the one criterion with some of its."""
    if seen.links:
        line = _line_of_links(names, trace, lock, seen)
        return line if isinstance(line, Refused) else {names[0]: line}
    return {name: lock_line(name, trace.criteria[name][1].text, seen.reason, seen.by) for name in names}


def _line_of_links(names: Sequence[str], trace: Trace, lock: TraceLockSpec | None, seen: LookedAt) -> str | Refused:
    """Return the line of the one criterion of which single links are accepted."""
    if len(names) != 1:
        return Refused("accept --link takes one criterion")
    name = names[0]
    if lock is None or name not in lock.criteria:
        return Refused(f"{name} was never reviewed: accept it without --link, with all that answers to it")
    links = suspects(trace, lock).get(name)
    if links is None:
        return Refused(f"the text of {name} is the one that was reviewed: none of its links is suspect")
    chosen = [chosen_link(asked, links) for asked in seen.links]
    refused = next((each for each in chosen if isinstance(each, str)), None)
    if refused is not None:
        return Refused(refused)
    looked_at = [each.name for each in chosen if isinstance(each, Link)]
    is_partial = any(link.name not in looked_at for link in links)
    text, kept = trace.criteria[name][1].text, lock.criteria[name]
    return lock_line_by_link(name, kept, text, seen.reason, seen.by, looked_at, is_partial=is_partial)
