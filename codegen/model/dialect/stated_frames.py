"""Fields of a message that say from where, and along which axes, others are measured, and which others these are."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from codegen.model.dialect.dialect import EnumDefinition, WireField, WireMessage
from codegen.model.dialect.phrase import phrase
from codegen.model.dialect.stated_validity import is_measured


class StatedFrame(NamedTuple):
    """The field ``judge`` says in which frame ``field`` is; ``example`` is one of its entries, which the words name."""

    field: str
    judge: str
    example: str


_FRAME = r"(?:\w+_)?FRAME"
_OPTIONS = r"\b[A-Z]\w*_FRAME_\w+"
_FIELDS = r"\bof the fields: (\w+(?:, \w+)*)"
_ALIKE = r"(?:\w*_)?(?:distance|size|radius|increment|fov)(?:_\w*)?|param\d|(?:min|max)_\w+"
"""The names of fields that are the same in all frames."""


def stated_frames(message: WireMessage, enums: Mapping[str, EnumDefinition]) -> Iterator[StatedFrame]:
    """Yield the fields of a message whose frame another one says, in wire order."""
    for judge in message.fields:
        enum = enums.get(judge.definition.enum or "")
        if enum is None or not phrase(_FRAME).fullmatch(enum.name) or not judge.type.is_integer:
            continue
        options = [name for name in phrase(_OPTIONS).findall(judge.definition.description) if enum.entry(name)]
        example = next(iter(options), next((each.name for each in enum.entries if each.name.endswith("LOCAL_NED")), ""))
        for field in message.fields:
            if field is not judge and _is_in_frame(field, judge, options):
                yield StatedFrame(field.name, judge.name, example or enum.entries[0].name)


def _is_in_frame(field: WireField, judge: WireField, options: list[str]) -> bool:
    """Return whether the numbers of a field are others in another frame: with global ones only heights are."""
    text = judge.definition.description
    if listed := phrase(_FIELDS).search(text):
        return field.name in listed[1].split(", ")
    if options and all("_GLOBAL" in name for name in options):
        return field.name in ("alt", "z")
    if phrase(_ALIKE).fullmatch(field.name) or not (is_measured(field) or field.name in ("x", "y", "z")):
        return False
    is_of_motion = "/s" in (field.definition.units or "") or "velocity" in field.name
    if "velocity" in text:
        return is_of_motion
    return not is_of_motion if "pose" in text else True
