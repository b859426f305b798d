"""Requirement and decision documents: their id, metadata, links and numbered criteria.

# FR-00068 | Title
## Metadata               - Status: Approved, - Aliases: FR-zxxlp
## Links                  the ids of other documents
## Acceptance Criteria    1. ..., 2. ... (depends on criterion 1); in an ADR the numbered items of "Decision", where it
                          has no criteria
## What a host cannot show    - Criterion 1: ..., - Criteria 3, 4 and 6: ...
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches

from codegen.decode.criterion_dependency import dependencies_of
from codegen.diagnostics import Report, Rule, Severity
from codegen.frozen import dataclass
from codegen.load.markdown import Document, Item, Section
from codegen.model.spec.spec import Criterion, HostLimit, Requirement
from codegen.pattern import pattern
from codegen.source import Place

REQUIREMENT_TITLE = Rule(
    "requirement-title",
    "A requirement document begins with one heading of the form '# ID | Title', where the ID is capital letters, a "
    "hyphen, and digits or small letters, such as FR-00068. Without it nothing can refer to the document.",
    remedy="begin the document with '# FR-00068 | Title': an ID of its own and its title",
)
REQUIREMENT_STATUS = Rule(
    "requirement-status",
    "The section Metadata of a requirement document states the status: '- Status: Approved'.",
)
REQUIREMENT_METADATA = Rule(
    "requirement-metadata",
    "An entry of the section Metadata is written twice, or an alias is no document id.",
    remedy="keep one of the two lines",
)
REQUIREMENT_WITHOUT_CRITERIA = Rule(
    "requirement-without-criteria",
    "A requirement (FR, NFR) needs a section 'Acceptance Criteria' with a numbered list: without criteria nothing "
    "can be traced to it.",
)
DOCUMENT_WITHOUT_CRITERIA = Rule(
    "document-without-criteria",
    "A document in the folder requirements that decides nothing (its ID does not begin with ADR) has no section "
    "'Acceptance Criteria' with a numbered list, so nothing of it is traced.",
    Severity.WARNING,
)
CRITERION_NUMBER = Rule(
    "criterion-number",
    "Acceptance criteria are numbered 1, 2, 3 and so on, because tables and tests cite them by number. The message "
    "says which number is expected at the place. Where a criterion is gone and the others keep their numbers, the next "
    "one begins a list of its own, behind a heading or a comment: within a list a page counts on by itself, and would "
    "show another number than the one that is cited.",
    remedy="number the criteria 1, 2, 3 and so on, and the tables that cite them alike",
)
CRITERION_TEXT = Rule(
    "criterion-text",
    "A criterion has no text, so it asks for nothing. Its text is all that stands in its item, further paragraphs, "
    "lists, code and quotations included.",
    remedy="write what is asked for, or remove the criterion",
)
TEXT_OUTSIDE_CRITERIA = Rule(
    "text-outside-criteria",
    "Text follows a criterion and is not in its item, as it is not indented as the text of the item is. It belongs to "
    "no criterion: the trace does not show it, and no criterion is suspect when it changes. What introduces criteria "
    "stands before the first one or below a heading, and so may what has nothing to do with them.",
    Severity.WARNING,
    remedy="indent it as the text of a criterion, or write it before the first one, or below a heading",
)
REQUIREMENT_DUPLICATE = Rule(
    "requirement-duplicate",
    "Two documents have the same id or alias, so that a reference to it is ambiguous. Renumber one of them.",
    remedy="give one of the documents another ID, or take the alias out",
)
METADATA_SPELLING = Rule(
    "metadata-spelling",
    "An entry of the section Metadata is spelt nearly like one that is read, but not the same, so it has no effect.",
    Severity.WARNING,
)

SECTION_SPELLING = Rule(
    "section-spelling",
    "A heading of a requirement document is spelt nearly like one that is read (Metadata, Links, Acceptance Criteria, "
    "What a host cannot show, in an ADR also Decision), or is not of the second level, so that what stands below it "
    "has no effect.",
    Severity.WARNING,
)

CRITERIA = "acceptance criteria"
"""Title of the section with the criteria, in small letters."""
_LIMITS = "what a host cannot show"
_READ_SECTIONS = {
    "metadata": "Metadata",
    "links": "Links",
    CRITERIA: "Acceptance Criteria",
    _LIMITS: "What a host cannot show",
}
"""Titles of the sections that are read in every document, as they are written, by themselves in small letters."""

_ID = r"[A-Z]+-[0-9a-z]+"
_TITLE = pattern(rf"({_ID})\s*\|\s*(\S.*)")
_LINK = pattern(rf"(?<![A-Za-z0-9-]){_ID}")
_ENTRY = pattern(r"([^:]{1,40}):\s*(.*)", re.DOTALL)
_LIMITED = pattern(r"Criteri(?:on|a) (\d[\d, and]*): *(\S.*)", re.DOTALL)
_READ_ENTRIES = ("type", "status", "aliases")
_NEEDS_CRITERIA = ("FR", "NFR")
_DECISION = "ADR"


@dataclass(frozen=True, slots=True)
class _Entry:
    value: str
    place: Place


def decode_requirement(document: Document, report: Report) -> Requirement | None:
    """The requirement that a document states; None, after a diagnostic, where it has no id.

    ``places`` has ``id``, ``status``, ``aliases`` and each alias (``aliases[0]``) as far as they are written.
    """
    heading = _heading(document, report)
    metadata = _metadata(_items(document, "metadata"), report)
    links = [link for item in _items(document, "links") for link in _LINK.findall(item.text)]
    if heading is None:
        return None
    match = _TITLE.fullmatch(heading.title)
    assert match is not None
    identifier, title = match.groups()
    misspelt = _misspelt(document, identifier, report)
    if "status" not in metadata:
        report.add(REQUIREMENT_STATUS, heading.place, f"{identifier} states no status", "## Metadata: - Status: ...")
    places = {"id": heading.place} | {name: entry.place for name, entry in metadata.items()}
    aliases = _aliases(metadata.get("aliases"), report)
    places |= {f"aliases[{index}]": metadata["aliases"].place for index in range(len(aliases))}
    return Requirement(
        place=heading.place,
        places=places,
        id=identifier,
        title=title,
        aliases=aliases,
        status=metadata["status"].value if "status" in metadata else "",
        links=tuple(dict.fromkeys(links)),
        criteria=_criteria(document, identifier, heading.place, report, is_misspelt=CRITERIA in misspelt),
        host_limits=tuple(_host_limits(document)),
        said=document.said,
    )


def check_unique(requirements: Iterable[Requirement], report: Report) -> None:
    """Report every id and alias that a document shares with an earlier one, at the later one."""
    known: dict[str, Place] = {}
    for requirement in requirements:
        names = [(requirement.id, requirement.at("id"))]
        names += [(alias, requirement.at(f"aliases[{index}]")) for index, alias in enumerate(requirement.aliases)]
        for name, place in names:
            if name in known:
                message = f"{name} is already the id or an alias of another document"
                if known[name].file == place.file:
                    message = f"{name} is written twice"
                report.add(REQUIREMENT_DUPLICATE, place, message, related=[(known[name], f"{name} is stated here")])
            else:
                known[name] = place


def _heading(document: Document, report: Report) -> Section | None:
    """The first heading of level 1, if it names the document."""
    headings = [section for section in document.sections if section.level == 1]
    if not headings:
        report.add(REQUIREMENT_TITLE, Place(document.path), "the document has no heading '# ID | Title'")
        return None
    for further in headings[1:]:
        related = [(headings[0].place, "the first one")]
        report.add(
            REQUIREMENT_TITLE,
            further.place,
            "a second heading of level 1; use ##",
            related=related,
            hint="write ## in front of it: a document has one ID",
        )
    if not _TITLE.fullmatch(headings[0].title):
        message = f"the heading {headings[0].title!r} is not of the form 'ID | Title'"
        report.add(REQUIREMENT_TITLE, headings[0].place, message, "for instance: # FR-1 | Position")
        return None
    return headings[0]


def _items(document: Document, title: str) -> list[Item]:
    """The items of the sections with a title, whatever its case."""
    return [item for section in document.sections if section.title.casefold() == title for item in section.items]


def _misspelt(document: Document, identifier: str, report: Report) -> set[str]:
    """Return which of the sections that are read seem to be meant by other headings, in small letters; each is told."""
    titles = {**_READ_SECTIONS, **({"decision": "Decision"} if identifier.startswith(f"{_DECISION}-") else {})}
    written = {each.title.casefold() for each in document.sections}
    found = set()
    for section in document.sections:
        is_open = section.level == 2 and section.title.casefold() not in titles
        for title, place in (*([(section.title, section.place)] if is_open else []), *section.deeper):
            near = get_close_matches(title.casefold(), titles, n=1, cutoff=0.85)
            is_deeper = place != section.place
            if near and not (is_deeper and near[0] in written):
                found.add(near[0])
                hint = f"did you mean ## {titles[near[0]]}?"
                report.add(SECTION_SPELLING, place, f"what stands below {title} is not read", hint)
    return found


def _strays(document: Document) -> list[Place]:
    """The places of text behind a criterion that is in no item."""
    return [place for each in document.sections if each.title.casefold() == CRITERIA for place in each.stray]


def _metadata(items: Iterable[Item], report: Report) -> Mapping[str, _Entry]:
    """The entries ``Name: value`` by their name in small letters."""
    entries: dict[str, _Entry] = {}
    for item in items:
        match = _ENTRY.fullmatch(item.text)
        if match is None:
            continue
        name = match[1].strip().casefold()
        near = get_close_matches(name, _READ_ENTRIES, n=1, cutoff=0.75)
        if name in entries:
            related = [(entries[name].place, "first written here")]
            report.add(REQUIREMENT_METADATA, item.place, f"{match[1].strip()} is written twice", related=related)
        elif near and name not in _READ_ENTRIES:
            hint = f"did you mean {near[0].capitalize()}?"
            report.add(METADATA_SPELLING, item.place, f"{match[1].strip()} is not read", hint)
        elif match[2].strip():
            entries[name] = _Entry(match[2].strip(), item.place)
    return entries


def _aliases(entry: _Entry | None, report: Report) -> tuple[str, ...]:
    if entry is None or entry.value.casefold() == "none":
        return ()
    aliases = []
    for alias in (part.strip() for part in entry.value.split(",")):
        if re.fullmatch(_ID, alias):
            aliases.append(alias)
        else:
            hint = "write ids such as FR-zxxlp, with commas between them"
            report.add(REQUIREMENT_METADATA, entry.place, f"the alias {alias!r} is no document id", hint)
    return tuple(aliases)


def _host_limits(document: Document) -> Iterator[HostLimit]:
    """The items about criteria; what else the section says is for people."""
    for item in _items(document, _LIMITS):
        match = _LIMITED.fullmatch(item.whole) if item.depth == 0 else None
        if match is not None:
            numbers = tuple(map(int, pattern(r"\d+").findall(match[1])))
            yield HostLimit(place=item.place, numbers=numbers, text=match[2])


def _criteria(
    document: Document, identifier: str, place: Place, report: Report, *, is_misspelt: bool
) -> tuple[Criterion, ...]:
    """The numbered items of the outermost lists; an item with a wrong number is reported, and so is text in no item.

    ``is_misspelt`` tells that a heading was found that may be meant for the section; that has been reported.
    A criterion keeps the number that is written, so that references to it hold; of two with one number the first stays.
    """
    items = [item for item in _items(document, CRITERIA) if item.depth == 0]
    prefix = identifier.partition("-")[0]
    if not items and prefix == _DECISION:
        items = [item for item in _items(document, "decision") if item.depth == 0 and item.number is not None]
    if not items and prefix in _NEEDS_CRITERIA:
        hint = "add '## Acceptance Criteria' with '1. ...'"
        report.add(REQUIREMENT_WITHOUT_CRITERIA, place, f"{identifier} has no acceptance criteria", hint)
    elif not items and prefix != _DECISION and not is_misspelt:
        hint = "add '## Acceptance Criteria' with '1. ...', or call it ADR-... if it decides and asks for nothing"
        report.add(DOCUMENT_WITHOUT_CRITERIA, place, f"{identifier} has no acceptance criteria", hint)
    for stray in _strays(document):
        report.add(TEXT_OUTSIDE_CRITERIA, stray, "this belongs to no criterion")
    criteria: dict[int, Criterion] = {}
    expected = 1
    for item in items:
        if item.number is None:
            hint = f"number it: {expected}."
            if criteria:
                hint += f" Or indent it as the text of criterion {expected - 1} is, if it belongs to that"
            report.add(CRITERION_NUMBER, item.place, "the criterion is a bullet", hint)
            continue
        is_gap = item.number > expected
        if item.number < expected or (is_gap and not item.begins_list):
            message = f"the criterion is numbered {item.number} where {expected} is expected"
            hint = f"where {expected} is gone, write <!-- {expected} is gone --> above, on a line that is not indented"
            report.add(CRITERION_NUMBER, item.place, message, hint if is_gap else None)
        if not item.whole:
            report.add(CRITERION_TEXT, item.place, f"criterion {item.number} has no text")
        depends_on = dependencies_of(item.whole, identifier, item.place, report)
        criterion = Criterion(place=item.place, number=item.number, text=item.whole, depends_on=depends_on)
        criteria.setdefault(item.number, criterion)
        expected = item.number + 1
    return tuple(criteria.values())
