"""The lock: which texts of criteria were reviewed together with what answers to them.

A changed text makes every link from the criterion suspect (``link.py``) until somebody has looked and accepts it.
"""

import hashlib
import json
import re
from collections.abc import Collection, Iterable, Mapping
from enum import StrEnum

from codegen.diagnostics import Rule
from codegen.findings.fingerprint import LENGTH, normalised
from codegen.model.spec.trace_lock import ReviewedSpec, TraceLockSpec
from codegen.trace.graph import Trace, is_decision

LOCK_FORM = Rule(
    "trace-lock-form",
    "The lock file is valid, but not written with one entry of 'criteria' in each line, so that nothing can be added "
    "without rewriting it. Put each criterion on a line of its own, indented by two spaces.",
    remedy="put each criterion on a line of its own, indented by two spaces",
)

HEAD = (
    "# yaml-language-server: $schema=../generated/schemas/trace_lock.schema.json\n"
    "# Texts of criteria whose rows and tests were reviewed; codegen trace accept writes it.\n"
    "criteria:\n"
)
"""The beginning of a new lock file."""

_ENTRY = re.compile(r"^  ([A-Z]+-[0-9a-z]+\.\d+):")
_CONTINUED = re.compile(r"^   +[^\s#]")


class Review(StrEnum):
    """The state of a criterion's review, according to the lock file."""

    REVIEWED = "reviewed"
    CHANGED = "changed since it was reviewed"
    NEW = "never reviewed"
    NO_LOCK = "no lock file"


def text_fingerprint(text: str) -> str:
    """12 hex digits for the text of a criterion: markup, line breaks and repeated spaces do not count in it.

    What is struck is asked for no more, so those marks do.
    """
    said = normalised(text.replace("~~", " <struck> "))
    return hashlib.sha256(said.encode("utf-8", "surrogatepass")).hexdigest()[:LENGTH]


def required(trace: Trace) -> list[str]:
    """The names of the criteria that ask for something, in the order of the documents."""
    return [name for name, (requirement, _) in trace.criteria.items() if not is_decision(requirement)]


def reviews(trace: Trace, lock: TraceLockSpec | None) -> Mapping[str, Review]:
    """Return what the lock says of each criterion that asks for something."""
    if lock is None:
        return dict.fromkeys(required(trace), Review.NO_LOCK)
    found = {}
    for name in required(trace):
        kept = lock.criteria.get(name)
        if kept is None:
            found[name] = Review.NEW
        else:
            is_same = kept.text.lower() == text_fingerprint(trace.criteria[name][1].text)
            found[name] = Review.REVIEWED if is_same else Review.CHANGED
    return found


def gone(trace: Trace, lock: TraceLockSpec | None) -> dict[str, ReviewedSpec]:
    """The entries of the lock whose criterion does not exist any more, or only decides."""
    asked = set(required(trace))
    return {name: kept for name, kept in lock.criteria.items() if name not in asked} if lock else {}


def lock_line(name: str, text: str, reason: str, by: str | None) -> str:
    """The line of a criterion of which everything was looked at with its ``text`` as it is now."""
    return f"  {name}: {{{_facts(text_fingerprint(text), reason, by)}}}\n"


def lock_line_by_link(
    name: str,
    kept: ReviewedSpec,
    text: str,
    reason: str,
    by: str | None,
    looked_at: Collection[str],
    *,
    is_partial: bool,
) -> str:
    """The line of a criterion of which the links ``looked_at`` were looked at with its ``text`` as it is now.

    ``kept`` is its entry so far; what was looked at with this text before stays. Unless the line ``is_partial``, no
    link is left to be looked at.
    """
    now = text_fingerprint(text)
    links = {
        link: _facts(each.text, each.reason, each.by) for link, each in kept.links.items() if each.text.lower() == now
    }
    links |= dict.fromkeys(looked_at, _facts(now, reason, by))
    shown = ", ".join(f"{json.dumps(link, ensure_ascii=False)}: {{{facts}}}" for link, facts in links.items())
    whole = _facts(kept.text, kept.reason, kept.by) if is_partial else _facts(now, reason, by)
    return f"  {name}: {{{whole}, links: {{{shown}}}}}\n"


def _facts(fingerprint: str, reason: str, by: str | None) -> str:
    """The keys of an entry: JSON's strings are YAML's, so that any reason stays on its line."""
    facts = {"text": fingerprint, "reason": " ".join(reason.split()), **({"by": by} if by else {})}
    return ", ".join(f"{key}: {json.dumps(value, ensure_ascii=False)}" for key, value in facts.items())


def accepted(written: str | None, lines: Mapping[str, str], dropped: Collection[str] = ()) -> str:
    """The text of the lock file with ``lines`` in it and the entries ``dropped`` out of it.

    ``written`` is its text so far, None for no file. All other lines stay as they are, and where they are; a new line
    goes in front of the first entry that comes after it in the order of ids and numbers.
    """
    blocks = _blocks(written if written is not None else HEAD)
    if not any(name is None and "criteria:" in text for name, text in blocks):
        blocks.append((None, "criteria:\n"))
    kept = [(name, lines.get(name, text) if name else text) for name, text in blocks if name not in dropped]
    for name, line in lines.items():
        if name in {other for other, _ in kept}:
            continue
        later = [place for place, (other, _) in enumerate(kept) if other and _order(other) > _order(name)]
        place = later[0] if later else _end(kept)
        while later and kept[place - 1][1].lstrip().startswith("#") and place > _begin(kept):
            place -= 1  # what is said about an entry stays above it
        kept.insert(place, (name, line))
    return "".join(text for _, text in kept)


def holds(
    written: TraceLockSpec | None, kept: TraceLockSpec | None, lines: Collection[str], dropped: Collection[str]
) -> bool:
    """Return whether a lock has what is accepted, has nothing that was dropped, and all else as it was ``kept``."""
    if written is None:
        return False
    before = {name: each for name, each in (kept.criteria if kept else {}).items() if name not in {*lines, *dropped}}
    return {name: each for name, each in written.criteria.items() if name not in lines} == before and all(
        name in written.criteria for name in lines
    )


def _blocks(text: str) -> list[tuple[str | None, str]]:
    """The text in pieces: each entry with the lines that belong to it, and what stands between them without a name."""
    blocks: list[tuple[str | None, str]] = []
    for line in text.splitlines(keepends=True):
        whole = line if line.endswith("\n") else f"{line}\n"
        entry = _ENTRY.match(whole)
        if entry:
            blocks.append((entry[1], whole))
        elif blocks and blocks[-1][0] and _CONTINUED.match(whole):
            blocks[-1] = (blocks[-1][0], blocks[-1][1] + whole)
        else:
            blocks.append((None, whole.replace("criteria: {}", "criteria:")))
    return blocks


def _begin(blocks: Iterable[tuple[str | None, str]]) -> int:
    """Return the place behind the line that begins the entries."""
    return next(place + 1 for place, (name, text) in enumerate(blocks) if not name and text.startswith("criteria:"))


def _end(blocks: Iterable[tuple[str | None, str]]) -> int:
    """Return the place behind the last entry, or behind the line that begins them."""
    places = [place for place, (name, text) in enumerate(blocks) if name or text.startswith("criteria:")]
    return places[-1] + 1


def _order(name: str) -> tuple[str, int]:
    document, _, number = name.partition(".")
    return document, int(number)
