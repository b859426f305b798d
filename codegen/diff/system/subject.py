"""A subject: one part of a system as a list of facts, by which two versions of it are compared."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from codegen.diff.change import Change, ChangeRule, changed
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Citation
from codegen.source import Place


class Fact(NamedTuple):
    """One attribute, as text that differs exactly where the attribute does; empty where there is none.

    ``shown`` is what people read in its place, where it is written in other words or units. ``doubt`` is what a person
    has to judge where it is another one than before, or there no longer; what has come is in nobody's place.
    """

    attribute: str
    text: str
    rule: ChangeRule
    place: Place
    shown: str = ""
    doubt: str = ""


class Subject(NamedTuple):
    """A part of a system: its name, what it is in a few words, the rules of its coming and going, and its facts.

    ``row`` is its name in the trace, where that is another one. ``key`` is what it is known by in both versions, where
    that is not the name. ``doubt`` is what a person has to judge where it has gone.
    """

    name: str
    says: str
    added: ChangeRule
    removed: ChangeRule
    place: Place
    facts: tuple[Fact, ...]
    cited: tuple[str, ...] = ()
    messages: tuple[str, ...] = ()
    row: str = ""
    key: str = ""
    doubt: str = ""


def subject_changes(
    old: Iterable[Subject], new: Iterable[Subject], absorbing: Mapping[ChangeRule, Collection[ChangeRule]] | None = None
) -> Iterator[Change]:
    """Yield what came and went, and which facts differ, in the order of the new version; what went comes last.

    Facts of one rule that differ are one change; a rule of ``absorbing`` takes in those of others that follow from it.
    """
    before = {subject.key or subject.name: subject for subject in old}
    after = {subject.key or subject.name: subject for subject in new}
    for name, subject in after.items():
        known = before.get(name)
        if known is None:
            yield _whole(subject.added, None, subject)
        else:
            yield from _facts(known, subject, absorbing or {})
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
        doubt=subject.doubt if new is None else "",
        cited=subject.cited,
        messages=subject.messages,
        rows=(subject.row or subject.name,),
    )


class _Pair(NamedTuple):
    """A fact that differs, as it was and as it is."""

    attribute: str
    old: Fact | None
    new: Fact | None


def _facts(old: Subject, new: Subject, absorbing: Mapping[ChangeRule, Collection[ChangeRule]]) -> Iterator[Change]:
    differing: dict[ChangeRule, list[_Pair]] = {}
    for pair in _pairs(old, new):
        told = pair.new or pair.old
        assert told is not None
        differing.setdefault(told.rule, []).append(pair)
    for rule, absorbed in absorbing.items():
        if rule in differing:
            for other in absorbed:
                differing[rule] += differing.pop(other, ())
    for rule, pairs in differing.items():
        before = _said((pair.attribute, pair.old, pair.new) for pair in pairs)
        after = _said((pair.attribute, pair.new, pair.old) for pair in pairs)
        first = pairs[0]
        yield changed(
            rule,
            new.name,
            before,
            after,
            (first.old.place if first.old else old.place, first.new.place if first.new else new.place),
            doubt="" if rule.breaks else _doubt(pairs),
            cited=dict.fromkeys((*new.cited, *old.cited)),
            messages=dict.fromkeys((*new.messages, *old.messages)),
            rows=(new.row or new.name,),
        )


def _pairs(old: Subject, new: Subject) -> Iterator[_Pair]:
    before = {fact.attribute: fact for fact in old.facts}
    after = {fact.attribute: fact for fact in new.facts}
    for attribute in (*after, *(name for name in before if name not in after)):
        known, fact = before.get(attribute), after.get(attribute)
        if (known.text if known else "") != (fact.text if fact else ""):
            yield _Pair(attribute, known, fact)


def _doubt(pairs: Iterable[_Pair]) -> str:
    """Return what a person has to judge of facts that were stated before, each question once."""
    known = (pair.new or pair.old for pair in pairs if pair.old is not None)
    return ", and ".join(dict.fromkeys(fact.doubt for fact in known if fact is not None and fact.doubt))


def _said(facts: Iterable[tuple[str, Fact | None, Fact | None]]) -> str | None:
    """The facts, each with the one in the other version: what people would read alike is told as it is compared."""
    return (
        "; ".join(
            _with(attribute, fact.text if other and other.shown == fact.shown else fact.shown or fact.text)
            for attribute, fact, other in facts
            if fact and fact.text
        )
        or None
    )


def _with(attribute: str, text: str) -> str:
    """The text after the name of its attribute, unless it says enough by itself."""
    return text if attribute == text else f"{attribute} {text}"


def cited(*citations: Citation | Mapping[str, Citation] | None) -> tuple[str, ...]:
    """The ids of what is cited, each once."""
    found: dict[str, None] = {}
    for each in citations:
        if isinstance(each, Mapping):
            found.update(dict.fromkeys(str(citation) for citation in each.values()))
        elif each is not None:
            found[str(each)] = None
    return tuple(found)


def citations(whole: Citation | None, aspects: Mapping[str, Citation]) -> str:
    """Return what is cited for the whole and for single aspects."""
    words = [str(whole)] if whole else []
    return ", ".join([*words, *(f"{name} {aspect}" for name, aspect in sorted(aspects.items()))])


def amount(value: Fraction | int | None, unit: str = "") -> str:
    """A number with its unit, or nothing."""
    if value is None:
        return ""
    return f"{decimal(Fraction(value))} {unit}".rstrip()
