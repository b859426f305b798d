"""Changes of what messages are populated with, element by element."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import groupby

from codegen.diff.change import Change, Notice, Victim, changed
from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.judged import is_narrower
from codegen.diff.system.subject import Fact, Subject, citations, cited, subject_changes
from codegen.diff.system.trace_rules import CITATION, DOC
from codegen.model.answers.account import Aspect
from codegen.model.answers.answer import Answer
from codegen.model.answers.known import Value
from codegen.model.code.letters import on_one_line
from codegen.model.dialect.dialect import Kind
from codegen.model.system import PopulatedMessage, Representation, System
from codegen.model.units.unit import decimal

_RULES = {
    Aspect.SOURCE: rules.SOURCE,
    Aspect.CONSTANT: rules.CONSTANT,
    Aspect.FLAGS: rules.FLAGS,
    Aspect.CONVERSION: rules.CONVERSION,
    Aspect.LIMITS: rules.LIMITS,
    Aspect.UNKNOWN: rules.UNKNOWN,
}
"""The rule under which a change of each aspect of an answer is told."""

_ABOUT = "whether receivers are to be told of another {}, {}"
_STATION = (Victim.OLD_STATION,)
_ABSORBING = {rules.SOURCE: (rules.CONSTANT, rules.CONVERSION, rules.LIMITS, rules.FLAGS)}
"""Changes that follow from another source, and are told with it."""


def population_changes(old: System, new: System) -> Iterator[Change]:
    """Messages that are sent or no longer, how they are scheduled, and what each element of them carries."""
    before = {_name_now(message, old, new): message for message in old.messages}
    was = (_message(message, name) for name, message in before.items())
    yield from subject_changes(was, (_message(message, message.name) for message in new.messages))
    for message in new.messages:
        known = before.get(message.name)
        if known is not None and known is not message:
            yield from _elements(known, message)


def _name_now(message: PopulatedMessage, old: System, new: System) -> str:
    """Return what a table is called in the new version: of one that has gone, the
    one of the same message that has come.
    """
    gone = _others(message, old, new)
    come = _others(message, new, old)
    return come[0] if gone == [message.name] and len(come) == 1 else message.name


def _others(message: PopulatedMessage, system: System, other: System) -> list[str]:
    """The tables of a message that only one of the versions has, by name."""
    known = {table.name for table in other.tables(message.wire.name)}
    return [table.name for table in system.tables(message.wire.name) if table.name not in known]


def _message(message: PopulatedMessage, name: str) -> Subject:
    """Return what there is to say about a table, which is called ``name`` in the new version."""
    spec = message.population
    stream = message.stream.name if message.stream else "on request"
    facts = [
        Fact("stream", stream, rules.MESSAGE_STREAM, spec.at("stream")),
        Fact(
            "sent on connection", "yes" if message.on_connection else "", rules.MESSAGE_STREAM, spec.at("on_connection")
        ),
        Fact(
            "sent on a change of",
            message.on_change.path if message.on_change else "",
            rules.MESSAGE_STREAM,
            spec.at("on_change"),
        ),
        Fact("withheld while unknown", _withheld(message), rules.MESSAGE_STREAM, spec.at("send")),
        Fact("pages", str(message.pages) if message.pages > 1 else "", rules.MESSAGE_STREAM, spec.at("pages")),
        Fact(
            "sent for each",
            message.component.name if message.component else "",
            rules.MESSAGE_INSTANCES,
            spec.at("for_each"),
        ),
        *(
            Fact(
                f"{name} it is about:",
                _policy(choice),
                rules.MESSAGE_INSTANCES,
                spec.at(f"represents.{name}"),
                doubt=_ABOUT.format(name, _policy(choice)) if choice.component.instances > 1 else "",
            )
            for name, choice in message.represents.items()
        ),
        Fact("table", message.name, rules.TABLE_RENAMED, spec.at("as")),
        Fact("answers to", citations(message.citation, message.aspects), CITATION, spec.at("requirement")),
    ]
    rate = f"{decimal(message.stream.default_rate)} Hz" if message.stream else "on request"
    each = f" for each {message.component.name}" if message.component else ""
    return Subject(
        name=name,
        says=f"{rate}{each}",
        added=rules.MESSAGE_SENT,
        removed=rules.MESSAGE_NOT_SENT,
        place=spec.at("message"),
        facts=tuple(facts),
        cited=cited(message.citation, message.aspects),
        messages=(message.wire.name,),
    )


def _withheld(message: PopulatedMessage) -> str:
    return ", ".join(dict.fromkeys(quantity.path for _, quantity in message.withheld_for))


def _policy(choice: Representation) -> str:
    words = {
        "first": "the first",
        "parameter": f"the one of {choice.parameter.name}" if choice.parameter else "",
        "lowest": f"the one with the lowest {choice.quantity.name}" if choice.quantity else "",
    }
    return words[choice.policy.value]


def _elements(old: PopulatedMessage, new: PopulatedMessage) -> Iterator[Change]:
    """Changes of single elements; neighbours that change alike are told as one."""
    before, after = _facts(old, new.name), _facts(new, new.name)
    answers = _answers(old), _answers(new)
    fields: dict[str, list[tuple[int, list[Change]]]] = {}
    for (field, index), known in before.items():
        if (field, index) in after:
            found = list(subject_changes((known,), (after[field, index],), _ABSORBING))
            told = [change for change in found if _is_told(change)]
            pair = answers[0][field, index], answers[1][field, index]
            fields.setdefault(field, []).append((index, [_as_heard(change, *pair) for change in told]))
    wires = old.wire, new.wire
    for element, subject in {**before, **after}.items():
        sides = before.get(element), after.get(element)
        # A field that only one dialect has is told by the change of the dialect, with what it is populated from now.
        if None not in sides or (sides[1] is None and wires[1].field(element[0]) is None):
            continue
        texts = [_told(side) if side else None for side in sides]
        places = tuple(side.place if side else None for side in sides)
        whole = changed(
            rules.SOURCE,
            subject.name,
            texts[0],
            texts[1],
            (places[0], places[1]),
            cited=subject.cited,
            messages=(new.wire.name,),
        )
        fields.setdefault(element[0], []).append((element[1], [whole]))
    for field, elements in fields.items():
        count = sum(name == field for name, _ in {**before, **after})
        yield from _joined(f"{new.name}.{field}", sorted(elements, key=lambda element: element[0]), count)


def _told(subject: Subject) -> str:
    return "; ".join(f"{fact.attribute} {fact.text}" for fact in subject.facts if fact.text)


def _is_told(change: Change) -> bool:
    """An unknown that goes out where there was none, or no more, is told by the source that came or went."""
    return change.rule is not rules.UNKNOWN or (change.old is not None and change.new is not None)


def _joined(name: str, elements: list[tuple[int, list[Change]]], count: int) -> Iterator[Change]:
    for _, run in groupby(elements, key=lambda element: [_said(change) for change in element[1]]):
        members = list(run)
        first, last = members[0][0], members[-1][0]
        label = name if len(members) == count else f"{name}[{first}]" if first == last else f"{name}[{first}..{last}]"
        for change in members[0][1]:
            yield replace(change, subject=label, rows=(name,))


def _said(change: Change) -> tuple[object, ...]:
    said = change.effect, change.doubt, change.breaks
    return change.rule.id, change.old, change.new, change.place, change.was_at, *said


def _answers(message: PopulatedMessage) -> dict[tuple[str, int], tuple[Answer, Value | None]]:
    """The answer of each element, with what it always carries, if that is so."""
    found = {}
    for answer in message.answers:
        covers, always = answer.covers, answer.always
        for position in range(covers.count):
            # A text is one value, whatever letters it has.
            at = 0 if covers.field.type.kind is Kind.CHAR else position
            value = None if always is None or at >= len(always) else always[at]
            found[covers.field.name, covers.first + position] = answer, value
    return found


def _as_heard(change: Change, old: tuple[Answer, Value | None], new: tuple[Answer, Value | None]) -> Change:
    """A change of an element, judged where receivers get other numbers than before, or always the same one."""
    before, after = old[1], new[1]
    if change.rule is rules.FLAGS:
        return _flagged(change, old[0], new[0])
    if change.rule is rules.LIMITS:
        return _limited(change, old[0], new[0])
    if change.rule is rules.CONVERSION:
        return _converted(change, old[0], new[0])
    if change.rule not in (rules.SOURCE, rules.CONSTANT):
        return change
    if before is None and after is not None:
        sentinel = new[0].covers.field.sentinel
        if sentinel is not None and any(_is_same(after, value) for value in sentinel.values):
            effect = "receivers hear nothing of it any more"
            return replace(change, effect=effect, notice=Notice.NONE, breaks=_STATION)
        return replace(
            change, effect=f"always {_plain(after)}, which receivers take for what is so now", breaks=_STATION
        )
    if before is not None and after is not None and not _is_same(before, after):
        return replace(
            change, doubt=f"whether {_plain(after)} is what receivers are to be told in place of {_plain(before)}"
        )
    if before is None and after is None:
        return _from_elsewhere(change, old[0], new[0])
    return change


def _plain(value: Value) -> str:
    return on_one_line(value) if isinstance(value, str) else str(value)


def _from_elsewhere(change: Change, old: Answer, new: Answer) -> Change:
    """A value that is not always the same comes from somewhere else: another place of the same list, or any other."""
    lists = [{quantity.path for quantity in side.quantities} for side in (old, new)]
    if lists[0] == lists[1] and None not in (old.shift, new.shift) and old.shift != new.shift:
        effect = "the same element holds another value of the list, which receivers take for the one that it was"
        return replace(change, effect=effect, breaks=_STATION)
    return replace(change, doubt="whether it still tells receivers of the same thing")


def _limited(change: Change, old: Answer, new: Answer) -> Change:
    """A field that cuts off more than before; where numbers are converted otherwise, its limits are others anyway."""
    beside = 1 if new.covers.field.type.is_integer else 0  # which is where a field steps aside for its sentinel
    if not any(
        (before.factor, before.rounding) == (after.factor, after.rounding)
        and is_narrower((before.low, before.high), (after.low - beside, after.high + beside))
        for before, after in zip(old.scalings, new.scalings, strict=False)
    ):
        return change
    return replace(change, doubt="whether values beyond its limits, which are narrower now, are meant to be cut off")


def _converted(change: Change, old: Answer, new: Answer) -> Change:
    """The same amount goes out as another number, which it does not where it is only kept in another unit."""
    if _per_amount(old) == _per_amount(new):
        return change
    return replace(change, doubt="whether receivers are to get other numbers for the same amount")


def _per_amount(answer: Answer) -> list[object]:
    """Return what an amount is multiplied with and how it is rounded, whatever unit it is kept in."""
    scales = [quantity.stored.scale for quantity in answer.quantities]
    scales += [parameter.step * parameter.unit.scale for parameter in answer.parameters]
    kept = scales[0] if scales else Fraction(1)
    if not answer.scalings:
        return [trait for trait in answer.traits(0) if trait.aspect is Aspect.CONVERSION]
    return [(scaling.factor / kept, scaling.rounding) for scaling in answer.scalings]


def _flagged(change: Change, old: Answer, new: Answer) -> Change:
    """Bits that never change any more are taken for what is so now; other conditions, or other constants, are a
    question. A bit that begins to tell something harms nobody.
    """
    before, after = old.conditions or {}, new.conditions or {}
    stuck = [bit for bit, paths in before.items() if paths and not after.get(bit)]
    if stuck:
        constant = " and ".join(f"{bit:#x} is {'always' if bit in after else 'never'} set" for bit in stuck)
        return replace(change, effect=f"{constant}, which receivers take for what is so now", breaks=_STATION)
    other = [bit for bit, paths in before.items() if paths and paths != after[bit]]
    if other:
        return replace(change, doubt="whether the flags still tell receivers of the same thing")
    fixed = [{bit for bit, paths in side.items() if not paths} for side in (before, after)]
    if any(bit not in before or bit not in after for bit in fixed[0] ^ fixed[1]):
        return replace(change, doubt="whether receivers are to be told so at all times")
    return change


def _is_same(one: Value | None, other: Value | None) -> bool:
    return one == other or str(one).lower() == str(other).lower() == "nan"


def _facts(message: PopulatedMessage, name: str) -> dict[tuple[str, int], Subject]:
    """Return what is known of each element, by the name of its field and its number from 0."""
    found = {}
    for answer in message.answers:
        covers = answer.covers
        place = covers.written.place
        note = covers.written.note or ""
        for index in range(covers.first, covers.first + covers.count):
            traits = answer.traits(index - covers.first)
            facts = [Fact(trait.attribute, trait.text, _RULES[trait.aspect], place) for trait in traits]
            own = "" if covers.citation == message.citation else str(covers.citation)
            facts.append(Fact("answers to", own, CITATION, covers.written.at("requirement")))
            facts.append(Fact("answered by", "others" if covers.by_others else "", DOC, place))
            facts.append(Fact("note", note, DOC, covers.written.at("note")))
            found[covers.field.name, index] = Subject(
                name=f"{name}.{covers.field.name}",
                says=covers.label,
                added=rules.SOURCE,
                removed=rules.SOURCE,
                place=place,
                facts=tuple(facts),
                cited=cited(covers.citation, message.citation),
                messages=(message.wire.name,),
            )
    return found
