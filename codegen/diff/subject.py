"""What there is to say about one part of a system, as facts that two versions of it are compared by."""

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from codegen.diff.change import Change, ChangeRule, changed
from codegen.model.unit import decimal
from codegen.model.vehicle import Citation
from codegen.source import Place


class Fact(NamedTuple):
    """One attribute, as text that differs exactly where the attribute does; empty where there is none."""

    attribute: str
    text: str
    rule: ChangeRule
    place: Place


class Subject(NamedTuple):
    """A part of a system: its name, what it is in a few words, the rules of its coming and going, and its facts."""

    name: str
    says: str
    added: ChangeRule
    removed: ChangeRule
    place: Place
    facts: tuple[Fact, ...]
    cited: tuple[str, ...] = ()
    messages: tuple[str, ...] = ()


def subject_changes(old: Iterable[Subject], new: Iterable[Subject]) -> Iterator[Change]:
    """What came and went, and which facts differ, in the order of the new version; what went comes last."""
    before = {subject.name: subject for subject in old}
    after = {subject.name: subject for subject in new}
    for name, subject in after.items():
        known = before.get(name)
        if known is None:
            yield _whole(subject.added, None, subject)
        else:
            yield from _facts(known, subject)
    for name, subject in before.items():
        if name not in after:
            yield _whole(subject.removed, subject, None)


def _whole(rule: ChangeRule, old: Subject | None, new: Subject | None) -> Change:
    subject = new or old
    assert subject is not None
    return changed(
        rule,
        subject.name,
        old.says if old else None,
        new.says if new else None,
        (old.place if old else None, new.place if new else None),
        cited=subject.cited,
        messages=subject.messages,
    )


def _facts(old: Subject, new: Subject) -> Iterator[Change]:
    before = {fact.attribute: fact for fact in old.facts}
    after = {fact.attribute: fact for fact in new.facts}
    for attribute in (*after, *(name for name in before if name not in after)):
        known, fact = before.get(attribute), after.get(attribute)
        texts = [side.text if side else "" for side in (known, fact)]
        if texts[0] == texts[1]:
            continue
        told = fact or known
        assert told is not None
        yield changed(
            told.rule,
            new.name,
            _with(attribute, texts[0]),
            _with(attribute, texts[1]),
            (known.place if known else old.place, fact.place if fact else new.place),
            cited=dict.fromkeys((*new.cited, *old.cited)),
            messages=dict.fromkeys((*new.messages, *old.messages)),
        )


def _with(attribute: str, text: str) -> str | None:
    """The text after the name of its attribute, unless it says that itself; None where there is none."""
    if not text:
        return None
    return text if attribute.startswith(".") else f"{attribute} {text}"


def cited(*citations: Citation | Mapping[str, Citation] | None) -> tuple[str, ...]:
    """The ids of what is cited, each once."""
    found: dict[str, None] = {}
    for each in citations:
        if isinstance(each, Mapping):
            found.update(dict.fromkeys(str(citation) for citation in each.values()))
        elif each is not None:
            found[str(each)] = None
    return tuple(found)


def amount(value: Fraction | int | None, unit: str = "") -> str:
    """A number with its unit, or nothing."""
    if value is None:
        return ""
    return f"{decimal(Fraction(value))} {unit}".rstrip()
