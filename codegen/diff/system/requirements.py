"""Changes of requirement documents, and of what answers to their criteria."""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace

from codegen.diff.change import Change, changed
from codegen.diff.system import trace_rules as rules
from codegen.diff.system.subject import Fact, Subject, subject_changes
from codegen.model.spec.spec import Requirement
from codegen.model.system import System
from codegen.source import Place

_ID = re.compile(r"\w+(?:-\w+)*")


def renamed_ids(old: System, new: System) -> dict[str, str]:
    """The ids of documents that have a new one now and list the old one as an alias, by the old one."""
    before = {each.id for each in old.requirements.values()}
    after = {each.id: each for each in new.requirements.values()}
    added = [each for name, each in after.items() if name not in before]
    return {alias: each.id for each in added for alias in each.aliases if alias in before and alias not in after}


def as_called_now(text: str, ids: Mapping[str, str]) -> str:
    """A text in which citations have the new ids."""
    return _ID.sub(lambda found: ids.get(found[0], found[0]), text)


def requirement_changes(old: System, new: System) -> Iterator[Change]:
    """Yield what documents say, in the order of their ids; what they say outside their criteria last."""
    ids = renamed_ids(old, new)
    before = {ids.get(each.id, each.id): each for each in old.requirements.values()}
    after = {each.id: each for each in new.requirements.values()}
    subjects = [[_document(each, name) for name, each in sorted(side.items())] for side in (before, after)]
    yield from subject_changes(subjects[0], subjects[1])
    for name in sorted(before.keys() & after.keys()):
        yield from _criteria(before[name], after[name])
    for name in sorted(before.keys() & after.keys()):
        yield from _prose(before[name], after[name])


def _document(requirement: Requirement, name: str) -> Subject:
    """A document under the id that it has now."""
    facts = (
        Fact("id", requirement.id, rules.REQUIREMENT_STATUS, requirement.at("id")),
        Fact("title", requirement.title, rules.REQUIREMENT_TEXT, requirement.at("id")),
        Fact("status", requirement.status, rules.REQUIREMENT_STATUS, requirement.at("status")),
        Fact("aliases", ", ".join(requirement.aliases), rules.REQUIREMENT_STATUS, requirement.at("aliases")),
        Fact("links", ", ".join(requirement.links), rules.REQUIREMENT_STATUS, requirement.place),
    )
    return Subject(
        name=name,
        says=requirement.title,
        added=rules.REQUIREMENT_ADDED,
        removed=rules.REQUIREMENT_REMOVED,
        place=requirement.place,
        facts=facts,
        cited=(name,),
    )


def _criteria(old: Requirement, new: Requirement) -> Iterator[Change]:
    before, after = ({each.number: each for each in side.criteria} for side in (old, new))
    for number in sorted(before.keys() | after.keys()):
        known, criterion = before.get(number), after.get(number)
        places = known.place if known else None, criterion.place if criterion else None
        texts = [side.text if side else None for side in (known, criterion)]
        rule = rules.REQUIREMENT_TEXT
        if known is None:
            rule = rules.CRITERION_ADDED
        elif criterion is None:
            rule = rules.CRITERION_REMOVED
        if texts[0] != texts[1]:
            name = f"{new.id}.{number}"
            yield changed(rule, name, texts[0], texts[1], places, cited=(name,))


def _prose(old: Requirement, new: Requirement) -> Iterator[Change]:
    """Yield whether a document differs in what the model does not hold: its rationale, its tables, its examples."""
    if old.said != new.said and replace(old, said=new.said) == new:
        yield changed(rules.DOCUMENT, new.id, None, "other text", (old.place, new.place), cited=(new.id,))


def coverage_changes(
    old: System, new: System, cited_before: Iterable[str], cited_after: Iterable[str]
) -> Iterator[Change]:
    """Criteria of both versions that lost everything that answered to them, or found something.

    What cites a whole document answers to each of its criteria, as in the trace.
    """
    ids = renamed_ids(old, new)
    known = {as_called_now(name, ids): place for name, place in _criterion_places(old).items()}
    before, after = {as_called_now(name, ids) for name in cited_before}, set(cited_after)
    for name, place in _criterion_places(new).items():
        places = known.get(name), place
        was, is_now = (is_answered(name, names) for names in (before, after))
        if name in known and was and not is_now:
            yield changed(rules.UNCOVERED, name, "answered to", "answered to by nothing", places, cited=(name,))
        if name in known and is_now and not was:
            yield changed(rules.COVERED, name, "answered to by nothing", "answered to", places, cited=(name,))


def is_answered(criterion: str, cited: Collection[str]) -> bool:
    """Return whether a criterion, or its document as a whole, is among the names that are cited."""
    return criterion in cited or criterion.rpartition(".")[0] in cited


def _criterion_places(system: System) -> dict[str, Place]:
    documents = {each.id: each for each in system.requirements.values()}
    return {f"{each.id}.{one.number}": one.place for each in documents.values() for one in each.criteria}
