"""The shapes of the file formats, derived from the type hints of the models.

The decoder and the JSON Schemas both work on these shapes, so that they cannot disagree about what is valid.
"""

import types
from collections.abc import Mapping
from dataclasses import MISSING, Field, fields, replace
from enum import StrEnum
from fractions import Fraction
from functools import cache
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, Nothing, Verbatim
from codegen.source import Written

AMOUNT_PATTERN = r"^[-+]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)? *[A-Za-z%]\S*$"
"""An amount: a number, a space (which may be missing) and a unit. Means the same in Python and in JSON Schema."""


@dataclass(frozen=True, slots=True)
class Text:
    """Text; numbers and booleans have to be quoted. With a pattern it is an amount."""

    pattern: str | None = None


@dataclass(frozen=True, slots=True)
class AnyScalar:
    """Text, a number or a boolean, taken by its text."""


@dataclass(frozen=True, slots=True)
class YesNo:
    """A boolean; ``only`` is the one that may be written, where it is not both."""

    only: bool | None = None


@dataclass(frozen=True, slots=True)
class Number:
    """An exact number."""


@dataclass(frozen=True, slots=True)
class Whole:
    """A whole number."""


@dataclass(frozen=True, slots=True)
class Null:
    """``null``, written as the value."""


@dataclass(frozen=True, slots=True)
class Choice:
    """One of the words of an enumeration."""

    words: type[StrEnum]


@dataclass(frozen=True, slots=True)
class OneOf:
    """Any of several scalars."""

    members: tuple["ScalarShape", ...]


@dataclass(frozen=True, slots=True)
class ListOf:
    """A list; a tuple in the model."""

    item: "Shape"


@dataclass(frozen=True, slots=True)
class MappingOf:
    """A mapping from names of the author's choice."""

    value: "Shape"
    may_be_empty: bool = True


@dataclass(frozen=True, slots=True)
class RecordOf:
    """A mapping with the keys of a model class."""

    model: type[Written]


@dataclass(frozen=True, slots=True)
class ScalarOrList:
    """A scalar, or a list in its place."""

    scalar: "ScalarShape"
    items: ListOf

    @property
    def members(self) -> tuple["Shape", ...]:
        """Both."""
        return (self.scalar, self.items)


ScalarShape = Text | AnyScalar | YesNo | Number | Whole | Null | Choice | OneOf
Shape = ScalarShape | ListOf | MappingOf | RecordOf | ScalarOrList


@dataclass(frozen=True, slots=True)
class Group:
    """Keys of a record that are a record of their own, of class ``model``, in the tuple ``attribute``."""

    attribute: str
    model: type[Written]


@dataclass(frozen=True, slots=True)
class Key:
    """One key of a record: its name in YAML and in the model, and what may be written for it.

    With a ``group`` the attribute is one of the group's own class.
    """

    name: str
    attribute: str
    shape: Shape
    is_required: bool
    doc: str
    default: Any
    group: Group | None = None


def keys_of(model: type[Written]) -> tuple[Key, ...]:
    """The keys of a record in the order of the model; ``place`` and ``places`` are not written but filled in."""
    hashable: Any = model  # mypy takes the class of hashable records for unhashable
    return _keys_of(hashable)


@cache
def _keys_of(model: type[Written]) -> tuple[Key, ...]:
    hints = get_type_hints(model)
    written = [field for field in fields(model) if field.name not in ("place", "places", "unread")]
    return tuple(key for field in written for key in _keys(field, hints[field.name]))


def _keys(field: Field[Any], hint: Any) -> tuple[Key, ...]:
    """The key of a field, or all those of the records that are flattened into it; none of these has to be written."""
    if "flattened" not in field.metadata:
        return (_key(field, hint),)
    groups = [Group(field.name, model) for model in get_args(get_args(hint)[0])]
    return tuple(replace(key, is_required=False, group=group) for group in groups for key in keys_of(group.model))


def one_of(model: type[Written]) -> tuple[str, ...]:
    """The keys of which exactly one is written; nothing if the class knows no such choice."""
    keys: tuple[str, ...] = getattr(model, "ONE_OF", ())
    return keys


def beside(model: type[Written]) -> Mapping[str, str]:
    """Return by a key of ``one_of`` another of these keys that may be written with it."""
    pairs: Mapping[str, str] = getattr(model, "BESIDE", {})
    return pairs


def instead(model: type[Written]) -> str | None:
    """Return what is to be written in place of a key that the class does not have."""
    hint: str | None = getattr(model, "INSTEAD", None)
    return hint


def short_forms(model: type[Written]) -> Mapping[str, Mapping[str, Any]]:
    """The words that stand for a whole record, each with the keys it stands for."""
    forms: Mapping[str, Mapping[str, Any]] = getattr(model, "SHORT_FORMS", {})
    return forms


def chosen_by(model: type[Written]) -> str | None:
    """The key whose value decides which class a record is of; None where the class is the one that is named."""
    key: str | None = getattr(model, "CHOSEN_BY", None)
    return key


def rest(model: type[Written]) -> str | None:
    """The attribute that takes keys of the author's choice; None where there are none."""
    name: str | None = getattr(model, "REST", None)
    return name


def _key(field: Field[Any], hint: Any) -> Key:
    is_required = field.default is MISSING and field.default_factory is MISSING
    shape = _shape(hint)
    if isinstance(shape, MappingOf):
        shape = MappingOf(shape.value, may_be_empty=not is_required)
    default = None if field.default is MISSING else field.default
    return Key(field.metadata["key"] or field.name, field.name, shape, is_required, field.metadata["doc"], default)


_SCALARS: Mapping[Any, Shape] = {
    str: Text(),
    Amount: Text(AMOUNT_PATTERN),
    Verbatim: AnyScalar(),
    bool: YesNo(),
    int: Whole(),
    Fraction: Number(),
    Literal[True]: YesNo(only=True),
    Nothing: Null(),
}


def _shape(hint: Any) -> Shape:
    """The shape of a type hint of the models. None in a union says that the key may be left out, not that it may be
    written without a value."""
    if hint in _SCALARS:
        return _SCALARS[hint]
    arguments = get_args(hint)
    origin = get_origin(hint)
    if origin in (Union, types.UnionType):
        members = [_shape(member) for member in arguments if member is not type(None)]
        match members:
            case [only]:
                return only
            case [ListOf() as items, *scalars] | [*scalars, ListOf() as items]:
                return ScalarOrList(scalars[0] if len(scalars) == 1 else OneOf(tuple(scalars)), items)  # type: ignore[arg-type]
        return OneOf(tuple(members))  # type: ignore[arg-type]
    if origin is tuple:
        return ListOf(_shape(arguments[0]))
    if origin is Mapping:
        return MappingOf(_shape(arguments[1]))
    if issubclass(hint, StrEnum):
        return Choice(hint)
    assert issubclass(hint, Written), hint
    return RecordOf(hint)
