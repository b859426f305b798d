"""Arranges the objects of a file as documents: headings become documents, the requirements below them criteria.

A requirement below no heading is a document of its own. Nothing is named that the file does not name: where an id is
none that a document can have, that is a finding.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from codegen.decode.criterion_dependency import dependencies_of
from codegen.diagnostics import Report, Rule, Severity
from codegen.exchanged.stated import Formatted, Stated
from codegen.frozen import dataclass
from codegen.source import Place

IMPORT_ID = Rule(
    "import-id",
    "An object that would be a document has no id of the form that documents have, capital letters, a hyphen, and "
    "digits or small letters, such as FR-12; or two have the same one. --prefix FR makes FR-12 of 12, and "
    "FR-sysreq12 of SYS-REQ_12.",
    remedy="rename one of the two, or import each --specification with a --prefix of its own",
)
IMPORT_TITLE = Rule(
    "import-title",
    "A requirement that stands below no heading would be a document of its own, and has no title to go with its text.",
)
IMPORT_DEPENDENCY = Rule(
    "import-dependency",
    "A requirement depends on something that is not imported with it: the document does not say so.",
    Severity.WARNING,
    remedy="import the other one with it, or take the dependency out where it was written",
)
IMPORT_BELOW = Rule(
    "import-below",
    "A requirement stands below another one, not below a heading. Criteria have no criteria below them: it becomes one "
    "of the same document.",
    Severity.WARNING,
    remedy="put it below a heading, if it is to be a document of its own",
)

_ID = re.compile(r"[A-Z]+-[0-9a-z]+")
_NUMBERED = re.compile(rf"({_ID.pattern})\.(\d+)")


@dataclass(frozen=True, slots=True)
class ArrangedCriterion:
    """A criterion; ``depends_on`` is what its text does not say yet, ``source`` what the other tool calls it."""

    number: int
    text: Formatted
    depends_on: tuple[str, ...]
    bench: str
    source: str
    place: Place


@dataclass(frozen=True, slots=True)
class Arranged:
    """A document as it will be written; ``source`` is what the other tool calls it."""

    id: str
    title: str
    facts: Mapping[str, str]
    criteria: tuple[ArrangedCriterion, ...]
    source: str
    place: Place


def arranged(objects: Sequence[Stated], prefix: str | None, report: Report) -> tuple[Arranged, ...]:
    """The documents in the order of the file; those with findings are left out."""
    by_key = {each.key: each for each in objects}
    members: dict[str, list[Stated]] = {}
    for each in objects:
        head = _head(each, by_key, report)
        members.setdefault(head.key, [])
        if each.text is not None or each.is_broken:
            members[head.key].append(each)
    heads = [by_key[key] for key in members if members[key] or "status" in by_key[key].facts]
    ids = dict(_ids(heads, prefix, report))
    numbered = {
        each.key: (ids[head.key], number)
        for head in heads
        if head.key in ids
        for each, number in _numbered(members[head.key], ids[head.key])
    }
    return tuple(_documents(heads, members, ids, numbered, report))


def _head(each: Stated, by_key: Mapping[str, Stated], report: Report) -> Stated:
    """The object that becomes the document of another one, which may be itself."""
    if each.text is None and not each.is_broken:
        return each
    seen = {each.key}
    at = each
    while at.parent is not None and at.parent in by_key and at.parent not in seen:
        above = by_key[at.parent]
        if at is each and (above.text is not None or above.is_broken):
            named = above.name or above.key
            report.add(IMPORT_BELOW, each.place, f"{each.name or each.key} stands below the requirement {named}")
        seen.add(above.key)
        at = above
        if above.text is None and not above.is_broken:
            return above
    return at


def _ids(heads: Iterable[Stated], prefix: str | None, report: Report) -> Iterator[tuple[str, str]]:
    """The ids of the documents by key; one without, or with that of another, has a finding."""
    taken: dict[str, Stated] = {}
    for head in heads:
        name = head.name or head.key
        found = name if _ID.fullmatch(name) else _made(name, prefix)
        if found is None:
            hint = "give --prefix FR, or write an id such as FR-12 there"
            report.add(IMPORT_ID, head.place, f"{name!r} is no id that a document can have", hint)
        elif found in taken:
            related = [(taken[found].place, f"{found} is here")]
            report.add(IMPORT_ID, head.place, f"{name!r} would be {found}, as another one is", None, related)
        else:
            taken[found] = head
            yield head.key, found


def _made(name: str, prefix: str | None) -> str | None:
    letters = "".join(filter(str.isalnum, name.lower()))
    return f"{prefix}-{letters}" if prefix and letters and letters.isascii() else None


def _numbered(members: Sequence[Stated], document: str) -> list[tuple[Stated, int]]:
    """The criteria in their order: by the numbers that all of their names have, or else 1, 2, 3 as they come."""
    found = [_NUMBERED.fullmatch(each.name) for each in members]
    numbers = [int(each[2]) for each in found if each is not None and each[1] == document]
    if len(set(numbers)) < len(members):
        return [(each, number) for number, each in enumerate(members, 1)]
    return sorted(zip(members, numbers, strict=True), key=lambda each: each[1])


def _documents(
    heads: Iterable[Stated],
    members: Mapping[str, Sequence[Stated]],
    ids: Mapping[str, str],
    numbered: Mapping[str, tuple[str, int]],
    report: Report,
) -> Iterator[Arranged]:
    for head in heads:
        if head.key not in ids:
            continue
        if not head.title:
            report.add(IMPORT_TITLE, head.place, f"{head.name or head.key} has no title", "give it one there")
            continue
        if any(each.is_broken for each in members[head.key]):
            continue
        own = [each for each, _ in _numbered(members[head.key], ids[head.key])]
        criteria = tuple(_criterion(each, ids[head.key], numbered, report) for each in own)
        yield Arranged(ids[head.key], head.title, head.facts, criteria, head.name or head.key, head.place)


def _criterion(
    each: Stated, document: str, numbered: Mapping[str, tuple[str, int]], report: Report
) -> ArrangedCriterion:
    assert each.text is not None
    said = dependencies_of(each.text.plain, document, each.place, report)
    needed = []
    for key in each.depends_on:
        if key not in numbered:
            named = each.name or each.key
            report.add(IMPORT_DEPENDENCY, each.place, f"{named} depends on {key}, which is not imported")
            continue
        other, number = numbered[key]
        if f"{other}.{number}" not in said:
            needed.append(f"criterion {number}" if other == document else f"{other}.{number}")
    number = numbered[each.key][1]
    return ArrangedCriterion(
        number, each.text, tuple(needed), each.facts.get("bench", ""), each.name or each.key, each.place
    )
