"""One fact, one finding: what follows from a change stands below it and is not counted again."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from codegen.diff import behaviour_rules, wire_rules
from codegen.diff.change import Area, Notice
from codegen.diff.grouping import Group

Carried = Mapping[str, tuple[str, ...]]
"""What takes numbers from parameters, ADC channels and quantities, by their names: quantities and fields."""

_TABLE = (
    behaviour_rules.UNKNOWN,
    behaviour_rules.CONVERSION,
    behaviour_rules.LIMITS,
    behaviour_rules.FLAGS,
    behaviour_rules.CONSTANT,
)
_KEPT = (behaviour_rules.QUANTITY_UNIT, behaviour_rules.QUANTITY_RANGE, behaviour_rules.CHANNEL)
_HEARD = (wire_rules.MESSAGE_ID, wire_rules.CRC_EXTRA)
_ELEMENTS = re.compile(r"\[[^\]]*\]$")


def with_following(groups: Sequence[Group], carried: Carried) -> list[Group]:
    """The groups, those that follow from another one moved below it; never one that is graver than that."""
    heads: dict[int, int] = {}
    for index, group in enumerate(groups):
        for is_followed in _RELATIONS:
            head = next(
                (
                    other
                    for other, each in enumerate(groups)
                    if other != index
                    and other not in heads
                    and _may_lead(each, group)
                    and is_followed(each, group, carried)
                ),
                None,
            )
            if head is not None and not any(leader == index for leader in heads.values()):
                heads[index] = head
                break
    below: dict[int, list[Group]] = {}
    for index, head in heads.items():
        below.setdefault(head, []).append(groups[index])
    return [
        replace(group, following=tuple(below.get(index, ())))
        for index, group in enumerate(groups)
        if index not in heads
    ]


def _may_lead(head: Group, group: Group) -> bool:
    return head.first.weight.rank <= group.first.weight.rank


def _is_dropped_with(head: Group, group: Group, _: Carried) -> bool:
    """Whether nobody reads the bytes that a change is about, the whole message being dropped for the same reason."""
    change = group.first
    if head.first.rule not in _HEARD or change.enum is not None or change.rule.area is Area.DOCUMENTATION:
        return False
    is_noticed = change.notice in (Notice.NOTICED, Notice.UNKNOWN_ID) and change.rule not in _HEARD[:1]
    return is_noticed and bool(change.messages) and set(change.messages) <= set(head.first.messages)


def _is_of_the_field(head: Group, group: Group, _: Carried) -> bool:
    """Whether a table says otherwise what the dialect says otherwise of the same field."""
    if group.first.rule not in _TABLE or not _is_of_dialect(head):
        return False
    if head.first.enum is not None:
        return group.first.rule is behaviour_rules.FLAGS and not set(group.first.rows).isdisjoint(head.first.rows)
    return set(_fields(group)) <= set(_fields(head))


def _is_kept_otherwise(head: Group, group: Group, carried: Carried) -> bool:
    """Whether a number is converted otherwise because of how its source is kept, measured or limited."""
    if head.first.rule not in _KEPT:
        return False
    reached = {target for change in head.changes for target in carried.get(change.subject, ())}
    if group.first.rule in (behaviour_rules.CONVERSION, behaviour_rules.LIMITS, behaviour_rules.QUANTITY_SOURCE):
        return set(_fields(group)) <= reached
    return False


def _is_its_default(head: Group, group: Group, _: Carried) -> bool:
    """Whether a stream has another rate because the default of its parameter is another one."""
    return (
        head.first.rule is behaviour_rules.STREAM_RATE
        and group.first.rule is behaviour_rules.PARAMETER_DEFAULT
        and f"default of {group.first.subject}" in (head.first.new or "")
    )


_RELATIONS: tuple[Callable[[Group, Group, Carried], bool], ...] = (
    _is_dropped_with,
    _is_of_the_field,
    _is_kept_otherwise,
    _is_its_default,
)


def _is_of_dialect(group: Group) -> bool:
    rule = group.first.rule
    return rule.area is not Area.DOCUMENTATION and any(rule is each for each in vars(wire_rules).values())


def _fields(group: Group) -> Iterator[str]:
    """What a group is about, without the name of a program and without elements."""
    return (_ELEMENTS.sub("", change.subject.rpartition(": ")[2]) for change in group.changes)
