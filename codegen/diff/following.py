"""One fact, one finding: what follows from a change stands below it and is not counted again."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from codegen.diff.change import Area, Change, ChangeRule, Notice
from codegen.diff.dialect import wire_rules
from codegen.diff.report.grouping import Group
from codegen.diff.system import behaviour_rules

Carried = Mapping[str, tuple[str, ...]]
"""All that takes numbers from parameters, ADC channels, quantities and facts of the board, as changes call these."""

_TABLE = frozenset(
    rule.id
    for rule in (
        behaviour_rules.UNKNOWN,
        behaviour_rules.CONVERSION,
        behaviour_rules.LIMITS,
        behaviour_rules.FLAGS,
        behaviour_rules.CONSTANT,
    )
)
_CONVERTED = frozenset(
    rule.id for rule in (behaviour_rules.CONVERSION, behaviour_rules.LIMITS, behaviour_rules.QUANTITY_SOURCE)
)
_KEPT = frozenset(
    rule.id
    for rule in (
        behaviour_rules.QUANTITY_UNIT,
        behaviour_rules.QUANTITY_RANGE,
        behaviour_rules.CHANNEL,
        behaviour_rules.SENSOR,
    )
)
_STATED = frozenset(
    rule.id
    for rule in (
        behaviour_rules.QUANTITY_RANGE,
        behaviour_rules.QUANTITY_AGE,
        behaviour_rules.PARAMETER_DEFAULT,
        behaviour_rules.LIMITS,
        behaviour_rules.QUANTITY_SOURCE,
        behaviour_rules.CONSTANT,
        behaviour_rules.CONVERSION,
    )
)
_HEARD = frozenset({wire_rules.MESSAGE_ID.id, wire_rules.CRC_EXTRA.id})
_COMMANDS = frozenset(
    rule.id
    for rule in (
        behaviour_rules.COMMAND,
        behaviour_rules.COMMAND_ADDED,
        behaviour_rules.COMMAND_REMOVED,
        behaviour_rules.COMMAND_RANGE,
        behaviour_rules.COMMAND_UNIT,
    )
)
_TAKEN = frozenset(rule.id for rule in (behaviour_rules.COMMAND_RANGE, behaviour_rules.COMMAND_UNIT))
_NUMBERED = frozenset({wire_rules.ENTRY_VALUE.id, wire_rules.ENTRY_RENAMED.id})
_DROPPED = (Notice.NOTICED, Notice.UNKNOWN_ID)
_PARAMETER = re.compile(r"\bparameter (\d)\b")
_ELEMENTS = re.compile(r"\[[^\]]*\]$")


class _Relation(NamedTuple):
    """A relation between groups of changes: possible leaders, possible followers, and the test of a pair of them."""

    may_lead: Callable[[Change], bool]
    may_follow: Callable[[Change], bool]
    is_followed: Callable[[Group, Group, Carried], bool]


def with_following(groups: Sequence[Group], carried: Carried) -> list[Group]:
    """The groups, those that follow from another one moved below it; never one that is graver than that."""
    heads: dict[int, int] = {}
    leading: set[int] = set()
    for relation in _RELATIONS:
        candidates = [index for index, group in enumerate(groups) if relation.may_lead(group.first)]
        if not candidates:
            continue
        for index, group in enumerate(groups):
            if index in heads or index in leading or not relation.may_follow(group.first):
                continue
            for head in candidates:
                is_free = head != index and head not in heads and _may_lead(groups[head], group)
                if is_free and relation.is_followed(groups[head], group, carried):
                    heads[index] = head
                    leading.add(head)
                    break
    below: dict[int, list[Group]] = {}
    for index, head in heads.items():
        below.setdefault(head, []).append(groups[index])
    return [
        replace(group, following=tuple(below[index])) if index in below else group
        for index, group in enumerate(groups)
        if index not in heads
    ]


def _may_lead(head: Group, group: Group) -> bool:
    return head.first.weight.rank <= group.first.weight.rank


def _is_dropped_with(head: Group, group: Group, _: Carried) -> bool:
    """Return whether nobody reads the bytes that a change is about, the whole
    message being dropped for the same reason.
    """
    return set(group.first.messages) <= set(head.first.messages)


def _is_in_dropped(change: Change) -> bool:
    is_of_bytes = change.enum is None and change.rule.area is not Area.DOCUMENTATION
    return (
        is_of_bytes
        and change.notice in _DROPPED
        and change.rule.id != wire_rules.MESSAGE_ID.id
        and bool(change.messages)
    )


def _is_of_the_field(head: Group, group: Group, _: Carried) -> bool:
    """Return whether a table says otherwise what the dialect says otherwise of the same field."""
    if head.first.enum is not None:
        is_flags = group.first.rule.id == behaviour_rules.FLAGS.id
        return is_flags and not set(group.first.rows).isdisjoint(head.first.rows)
    return set(_fields(group)) <= set(_fields(head))


def _is_kept_otherwise(head: Group, group: Group, carried: Carried) -> bool:
    """Return whether a number is converted otherwise because of how its source is kept, measured or limited."""
    reached = {target for change in head.changes for target in carried.get(change.subject, ())}
    return {_without_elements(change.subject) for change in group.changes} <= reached


def _is_for_new_field(head: Group, group: Group, _: Carried) -> bool:
    """Return whether a table answers a field for which CRC_EXTRA is another one."""
    field = next(_fields(group)).rpartition(".")[2]
    return head.first.messages == group.first.messages and f"{field} is new" in head.first.causes


def _is_its_default(head: Group, group: Group, _: Carried) -> bool:
    """Return whether a stream has another rate because the default of its parameter is another one."""
    return f"default of {group.first.subject}" in (head.first.new or "")


def _is_of_the_command(head: Group, group: Group, _: Carried) -> bool:
    """Return whether the number or the name of a command is another one because the dialect's is."""
    names = {change.entry for change in head.changes}
    return {change.subject.rpartition(": ")[2] for change in group.changes} <= names


def _is_parameter(change: Change) -> bool:
    return change.rule.id == wire_rules.COMMAND_PARAMETER.id


def _is_of_the_parameter(head: Group, group: Group, _: Carried) -> bool:
    """Return whether one side tells of the same parameters of a command, the other being the dialect."""
    return set(_parameters(group)) <= set(_parameters(head))


def _parameters(group: Group) -> Iterator[tuple[str | None, str]]:
    """Return the command and the number of each parameter that a group is about."""
    for change in group.changes:
        if change.entry is not None:
            yield change.entry, change.subject.rpartition(".")[2]
        else:
            name = change.subject.rpartition(": ")[2]
            yield from ((name, each) for each in _PARAMETER.findall(f"{change.old}; {change.new}"))


_OF_DIALECT = frozenset(
    rule.id
    for rule in vars(wire_rules).values()
    if isinstance(rule, ChangeRule) and rule.area is not Area.DOCUMENTATION
)
_RELATIONS = (
    _Relation(lambda change: change.rule.id in _HEARD, _is_in_dropped, _is_dropped_with),
    _Relation(
        lambda change: change.rule.id == wire_rules.CRC_EXTRA.id,
        lambda change: change.rule.id == behaviour_rules.SOURCE.id and change.old is None,
        _is_for_new_field,
    ),
    _Relation(
        lambda change: change.rule.id in _NUMBERED, lambda change: change.rule.id in _COMMANDS, _is_of_the_command
    ),
    _Relation(_is_parameter, lambda change: change.rule.id in _TAKEN, _is_of_the_parameter),
    _Relation(lambda change: change.rule.id in _TAKEN, _is_parameter, _is_of_the_parameter),
    _Relation(lambda change: change.rule.id in _OF_DIALECT, lambda change: change.rule.id in _TABLE, _is_of_the_field),
    _Relation(lambda change: change.rule.id in _KEPT, lambda change: change.rule.id in _CONVERTED, _is_kept_otherwise),
    _Relation(
        lambda change: change.rule.id == behaviour_rules.FACT.id,
        lambda change: change.rule.id in _STATED,
        _is_kept_otherwise,
    ),
    _Relation(
        lambda change: change.rule.id == behaviour_rules.STREAM_RATE.id,
        lambda change: change.rule.id == behaviour_rules.PARAMETER_DEFAULT.id,
        _is_its_default,
    ),
)


def _fields(group: Group) -> Iterator[str]:
    """Return what a group is about, without the name of a program and without elements."""
    return (_without_elements(change.subject.rpartition(": ")[2]) for change in group.changes)


def _without_elements(subject: str) -> str:
    return _ELEMENTS.sub("", subject)
