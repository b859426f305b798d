"""One scalar against one shape: the decoded value, or what is wrong with it."""

import re
from fractions import Fraction
from typing import assert_never

from codegen.diagnostics import Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.load.yaml_tree import MappingNode, ScalarNode, SequenceNode, YamlNode
from codegen.model.spec.described import Nothing
from codegen.model.spec.shape import (
    AnyScalar,
    Choice,
    ListOf,
    MappingOf,
    Null,
    Number,
    OneOf,
    RecordOf,
    ScalarOrList,
    ScalarShape,
    Shape,
    Text,
    Whole,
    YesNo,
)

WRONG_TYPE = Rule(
    "wrong-type",
    "A key has a value of another kind than it wants, such as text in place of a number. Numbers are written without "
    "quotes; text that looks like a number or a boolean needs them.",
    remedy="write 12 for a number, 'text', true or false, [a, list], or {a: mapping}",
)
MISSING_VALUE = Rule(
    "missing-value",
    "A key is written without a value. Give it one, or remove the key if it may be left out.",
    remedy="write its value behind the colon, or remove the key",
)
UNKNOWN_CHOICE = Rule(
    "unknown-choice",
    "The value is not among the words that the key takes.",
    remedy="write one of these words",
)
UNUSABLE_NUMBER = Rule(
    "unusable-number",
    "Numbers are kept exactly, so they are finite and have at most 400 digits. A value that is not known is left out, "
    "or answered with unknown.",
    remedy="write a finite number of at most 400 digits, or leave out what is not known",
)


@dataclass(frozen=True, slots=True)
class Mismatch:
    """The reason for which a scalar does not fit; ``message`` follows the name of the key."""

    rule: Rule
    message: str
    hint: str | None = None


Value = str | bool | int | Fraction | Nothing
_YES_NO_WORDS = frozenset(("yes", "no", "on", "off", "y", "n"))


def read_scalar(node: ScalarNode, shape: ScalarShape) -> Value | Mismatch:
    """The value that ``shape`` gives ``node``: text, boolean, int, Fraction, NULL or a member of the choice."""
    if node.value is None or isinstance(shape, Null):
        return _nothing(node, shape)
    match shape:
        case Text():
            return _text(node, shape)
        case AnyScalar():
            return node.text
        case YesNo():
            return _boolean(node, shape)
        case Number():
            return _number(node, shape)
        case Whole():
            return _whole(node, shape)
        case Choice():
            return _choice(node, shape)
        case OneOf():
            return _any_of(node, shape)
    assert_never(shape)


_PLAIN = {Number: "a number", Whole: "a whole number", Null: "null"}


_EXAMPLES = {
    Text: "write a text, in quotes where it looks like a number or like true",
    YesNo: "write true or false, without quotes",
    Number: "write a number alone, such as 12 or 0.5",
    Whole: "write a whole number, such as 12",
    ListOf: "write [one, other], or an item in each line behind '- '",
    MappingOf: "write {name: value}, or name: value in each line below, indented",
    RecordOf: "write {key: value}, or key: value in each line below, indented",
}
"""The written form of a value, by the kind of its shape."""


def _nothing(node: ScalarNode, shape: ScalarShape) -> Value | Mismatch:
    """Return what a key is that is written as ``null``, or without a value, or as something where it wants ``null``."""
    if node.value is not None:
        return mismatch(node, shape)
    if node.text and _may_be_null(shape):
        return Nothing.NULL
    return Mismatch(MISSING_VALUE, "has no value", f"it wants {wanted(shape)}; without one, remove the key")


def _may_be_null(shape: ScalarShape) -> bool:
    return isinstance(shape, Null) or (isinstance(shape, OneOf) and any(map(_may_be_null, shape.members)))


def mismatch(node: YamlNode, shape: Shape, hint: str | None = None) -> Mismatch:
    """Return the mismatch of a node of another type than ``shape`` wants."""
    return Mismatch(WRONG_TYPE, f"wants {wanted(shape)}, not {found(node)}", hint or _EXAMPLES.get(type(shape)))


def wanted(shape: Shape) -> str:
    """Return what may be written, as in "it wants ..."."""
    match shape:
        case Text():
            return "text" if shape.pattern is None else "a number with its unit"
        case AnyScalar():
            return "text or a number"
        case YesNo():
            return "true or false" if shape.only is None else str(shape.only).lower()
        case Number() | Whole() | Null():
            return _PLAIN[type(shape)]
        case Choice():
            return " or ".join(shape.words)
        case OneOf() | ScalarOrList():
            return " or ".join(wanted(member) for member in shape.members)
        case ListOf():
            return "a list"
        case MappingOf() | RecordOf():
            return "a mapping"
    assert_never(shape)


def found(node: YamlNode) -> str:
    """Return what is written, as in "found ..."."""
    match node:
        case MappingNode():
            return "a mapping"
        case SequenceNode():
            return "a list"
        case ScalarNode(value=None):
            return "nothing"
        case ScalarNode(value=bool()):
            return node.text
        case ScalarNode(value=str()):
            return f"the text {shortened(node.text)!r}"
        case _:
            return f"the number {shortened(node.text)}"


def shortened(text: str) -> str:
    """``text`` as a message quotes it: at most 40 characters."""
    return text if len(text) <= 40 else f"{text[:37]}..."


def _text(node: ScalarNode, shape: Text) -> Value | Mismatch:
    if shape.pattern is not None:
        if isinstance(node.value, Fraction):
            return mismatch(node, shape, "add the unit")
        if not isinstance(node.value, str) or not re.fullmatch(shape.pattern, node.value):
            return mismatch(node, shape, "write it as in 3.3 V, 10 Hz or 2 ms")
    if not isinstance(node.value, str):
        return mismatch(node, shape, f'for this text, put it in quotes: "{shortened(node.text)}"')
    return node.value


def _boolean(node: ScalarNode, shape: YesNo) -> Value | Mismatch:
    if not isinstance(node.value, bool):
        hint = "write true or false" if node.text.lower() in _YES_NO_WORDS else None
        return mismatch(node, shape, hint)
    if shape.only is not None and node.value is not shape.only:
        return mismatch(node, shape, "remove the key, or say where the value comes from")
    return node.value


def _number(node: ScalarNode, shape: Number | Whole) -> Fraction | Mismatch:
    if isinstance(node.value, Fraction):
        return node.value
    if isinstance(node.value, float):
        return Mismatch(UNUSABLE_NUMBER, f"wants a number, and {shortened(node.text)} cannot be used as one")
    hint = None
    if isinstance(node.value, str) and re.match(r"[-+]?\.?[0-9]", node.value):
        hint = "write the number alone, without quotes and unit"
    return mismatch(node, shape, hint)


def _whole(node: ScalarNode, shape: Whole) -> Value | Mismatch:
    number = _number(node, shape)
    if isinstance(number, Mismatch):
        return number
    if number.denominator != 1:
        return mismatch(node, shape)
    return int(number)


def _choice(node: ScalarNode, shape: Choice) -> Value | Mismatch:
    if not isinstance(node.value, str):
        return mismatch(node, shape)
    if node.value not in list(shape.words):
        hint = did_you_mean(node.value, shape.words)
        return Mismatch(UNKNOWN_CHOICE, f"is {shortened(node.value)!r}, not {wanted(shape)}", hint)
    return shape.words(node.value)


def _any_of(node: ScalarNode, shape: OneOf) -> Value | Mismatch:
    """The first member that fits; a member that says more than "another kind" speaks for all."""
    said = None
    for member in shape.members:
        value = read_scalar(node, member)
        if not isinstance(value, Mismatch):
            return value
        if value.rule is not WRONG_TYPE:
            said = value
    return said or mismatch(node, shape)
