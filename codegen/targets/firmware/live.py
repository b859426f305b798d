"""From the bindings of a message to the views of what its builder writes on every build."""

import math
import struct
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from codegen.answers.each.answer import EachAnswer
from codegen.answers.flags import FlagsAnswer
from codegen.answers.instance import InstanceAnswer
from codegen.answers.live import LiveAnswer
from codegen.answers.page import PageAnswer
from codegen.answers.split import SplitAnswer
from codegen.model.answer import Answer
from codegen.model.dialect import Kind
from codegen.model.population_spec import Rounding
from codegen.model.system import PopulatedMessage
from codegen.model.vehicle import Parameter, Quantity
from codegen.targets.firmware.live_view import EachView, ExpressionView, FlagByteView, LiveView, SpillView, View
from codegen.targets.naming import number, parameter_attribute


def live_names(message: PopulatedMessage) -> tuple[str, ...]:
    """The fields, or elements of fields, that a message keeps as live values, in the order of its bindings."""
    names: list[str] = []
    for binding in message.answers:
        if _live_count(binding):
            covers = binding.covers
            is_whole = covers.count == covers.field.count
            elements = range(covers.first, covers.first + covers.count)
            names += [covers.field.name] if is_whole else [f"{covers.field.name}[{index}]" for index in elements]
    return tuple(names)


def writes_payload(message: PopulatedMessage) -> bool:
    """Whether a builder writes a value into the payload: a float, or an integer that is too long to be live."""
    return any(isinstance(binding, LiveAnswer) and not _live_count(binding) for binding in message.answers)


def live_views(message: PopulatedMessage, reach: Mapping[str, str]) -> tuple[View, ...]:
    """What is written on every build, in the order of the bindings; nothing for what is known at build time.

    ``reach`` has by component how the builder reaches it: ``battery``, or ``state.vehicle``.
    """
    views: list[View] = []
    index = 0
    for binding in message.answers:
        views += _views(binding, index, message, reach)
        index += _live_count(binding)
    return tuple(views)


def _live_count(binding: Answer) -> int:
    """How many live values a binding takes: none where nothing changes, or where the field is too long for one."""
    is_short = binding.covers.field.type.is_integer and binding.covers.field.type.size <= 4
    if isinstance(binding, EachAnswer | PageAnswer):
        return binding.covers.count
    if isinstance(binding, InstanceAnswer):
        return int(binding.first is not None)
    if isinstance(binding, LiveAnswer | SplitAnswer):
        return binding.covers.count if is_short else 0
    if isinstance(binding, FlagsAnswer):
        return int(bool(binding.conditional) and binding.covers.field.type.size <= 2)
    return 0


def _views(binding: Answer, index: int, message: PopulatedMessage, reach: Mapping[str, str]) -> Iterator[View]:
    if isinstance(binding, LiveAnswer):
        is_float = binding.covers.field.type.kind is Kind.FLOAT
        source = _source(binding.source, reach)
        at = index if _live_count(binding) else None
        yield _float_view(binding, source) if is_float else _integer_view(binding, source, at)
    elif isinstance(binding, EachAnswer):
        yield _each_view(binding, index, message, reach)
    elif isinstance(binding, PageAnswer):
        comment = (f"{binding.covers.label}: number of the first value on the page ({binding.covers.citation})",)
        yield ExpressionView(comment, index, f"page * {binding.size}")
    elif isinstance(binding, InstanceAnswer) and binding.first is not None:
        comment = (f"{binding.covers.label}: {binding.first.name}, counted on ({binding.covers.citation})",)
        yield ExpressionView(comment, index, f"{reach[binding.component]}.number")
    elif isinstance(binding, SplitAnswer):
        yield _spill_view(binding, index, message, reach)
    elif isinstance(binding, FlagsAnswer) and binding.conditional:
        if _live_count(binding):
            yield _flags_view(binding, index, reach)
        else:
            yield from _flag_bytes(binding, reach)


def _comment(binding: LiveAnswer | SplitAnswer) -> str:
    covers, source = binding.covers, binding.source
    units = covers.field.definition.units
    kept = source.stored.name if isinstance(source, Quantity) else source.unit.name
    spread = f", spilling above {binding.cell_high}" if isinstance(binding, SplitAnswer) else ""
    target = f"{covers.label} [{units}]" if units else covers.label
    origin = f"{source.path} [{kept}]" if kept and kept != units else source.path
    return f"{target}: {origin}{spread} ({covers.citation})"


def _source(source: Quantity | Parameter, reach: Mapping[str, str]) -> str:
    if isinstance(source, Parameter):
        return f"state.parameters.{parameter_attribute(source.name)}"
    return f"{reach[source.component]}.{source.attribute}"


def _scale(factor: Fraction, rounding: Rounding) -> tuple[str, int, int] | None:
    return None if factor == 1 else (rounding.value, factor.numerator, factor.denominator)


def _before(factor: Fraction, low: Fraction, high: Fraction) -> tuple[str, str] | None:
    """Limits in stored steps, one step wider than the field, that keep the product of the scaling small."""
    if factor == 1:
        return None
    return str(math.floor(low / factor) - 1), str(math.ceil(high / factor) + 1)


def _stand_in(source: Quantity | Parameter) -> str | None:
    initial = source.initial if isinstance(source, Quantity) else None
    return None if initial is None else str(initial)


def _integer_view(binding: LiveAnswer, source: str, index: int | None) -> LiveView:
    assert binding.unknown is None or isinstance(binding.unknown, int)
    unknown = _stand_in(binding.source) if binding.unknown is None else str(binding.unknown)
    return LiveView(
        comment=_comment(binding),
        source=source,
        index=index,
        code=f"<{binding.covers.field.type.code}",
        offset=binding.covers.offset,
        unknown=unknown,
        unknown_comment="unknown" if binding.unknown is not None else "until it is set",
        before=_before(binding.scaling.factor, binding.scaling.low, binding.scaling.high),
        scale=_scale(binding.scaling.factor, binding.scaling.rounding),
        low=str(binding.scaling.low),
        high=str(binding.scaling.high),
        hole=None if binding.scaling.hole is None else str(binding.scaling.hole),
        beside=str(binding.scaling.beside),
    )


def _float_view(binding: LiveAnswer, source: str) -> LiveView:
    """A float field: everything up to the last division happens in stored steps.

    What stands in for None is in steps, too; what tells that a value is unknown is the number on the wire.
    """
    factor = binding.scaling.factor
    low, high = binding.scaling.steps
    hole = None if binding.scaling.hole is None else binding.scaling.hole / factor
    divided = f" * {factor.numerator}" if factor.numerator != 1 else ""
    return LiveView(
        comment=_comment(binding),
        source=source,
        index=None,
        code=f"<{binding.covers.field.type.code}",
        offset=binding.covers.offset,
        unknown=None if binding.unknown is None else number(binding.unknown),
        unknown_comment="unknown",
        before=None,
        scale=None,
        low=str(low),
        high=str(high),
        hole=str(hole) if hole is not None and hole.denominator == 1 else None,
        beside="" if binding.scaling.beside is None else str(binding.scaling.beside / factor),
        stand_in=_stand_in(binding.source) if binding.unknown is None else None,
        divisor=f"{divided} / {factor.denominator}" if binding.makes_float else None,
        ratio=None if binding.makes_float else (factor.numerator, factor.denominator),
    )


def _spill_view(binding: SplitAnswer, index: int, message: PopulatedMessage, reach: Mapping[str, str]) -> SpillView:
    low, high = binding.scaling.low, binding.scaling.high
    return SpillView(
        comment=_comment(binding),
        source=_source(binding.source, reach),
        index=index,
        cells=binding.covers.count,
        function=f"_spill_{message.name.lower()}_{binding.covers.field.name}",
        stand_in=_stand_in(binding.source),
        low=int(low),
        high=int(high),
        before=_before(binding.scaling.factor, low, high),
        scale=_scale(binding.scaling.factor, binding.scaling.rounding),
        cell_high=binding.cell_high,
        unused=binding.unused,
    )


def _each_view(binding: EachAnswer, index: int, message: PopulatedMessage, reach: Mapping[str, str]) -> EachView:
    covers, fallback = binding.covers, binding.fallback
    units = covers.field.definition.units
    words = binding.source.path + (f", from {binding.first}" if binding.first else "")
    words += ", a page of them" if binding.is_paged else ""
    words += " while all are known" if binding.room is not None else ""
    words += f", else {fallback.source.path}, spilling above {fallback.cell_high}" if fallback else ""
    return EachView(
        comment=f"{covers.label}{f' [{units}]' if units else ''}: {words} ({covers.citation})",
        values=_source(binding.source, reach),
        function=f"_fill_{message.name.lower()}_{covers.field.name}" + (f"_{covers.first}" if covers.first else ""),
        index=index,
        count=covers.count,
        first=binding.first,
        is_paged=binding.is_paged,
        room=binding.room,
        spill=None if fallback is None else _spill_view(fallback, index, message, reach),
        before=_before(binding.scaling.factor, binding.scaling.low, binding.scaling.high),
        scale=_scale(binding.scaling.factor, binding.scaling.rounding),
        unknown=binding.unknown,
        low=str(binding.scaling.low),
        high=str(binding.scaling.high),
        hole=None if binding.scaling.hole is None else str(binding.scaling.hole),
        beside=str(binding.scaling.beside),
    )


def _flags_view(binding: FlagsAnswer, index: int, reach: Mapping[str, str]) -> ExpressionView:
    terms = [(value, _source(quantity, reach)) for _, value, quantity in binding.conditional]
    return ExpressionView(_flag_comment(binding), index, _or(binding.mask, terms))


def _flag_bytes(binding: FlagsAnswer, reach: Mapping[str, str]) -> Iterator[FlagByteView]:
    size = binding.covers.field.type.size
    comment = _flag_comment(binding)
    masks = struct.pack("<Q", binding.mask)
    for index in range(size):
        terms = [
            (byte, _source(quantity, reach))
            for _, value, quantity in binding.conditional
            if (byte := struct.pack("<Q", value)[index])
        ]
        if terms:
            yield FlagByteView(comment, binding.covers.offset + index, _or(masks[index], terms))
            comment = ()


def _or(always: int, terms: Iterable[tuple[int, str]]) -> str:
    """``0x41 | (0x80 if vehicle.armed else 0)``."""
    parts = [f"{always:#04x}"] * bool(always) + [f"({bits:#04x} if {source} else 0)" for bits, source in terms]
    return " | ".join(parts) if len(parts) > 1 else parts[0].strip("()")


def _flag_comment(binding: FlagsAnswer) -> tuple[str, ...]:
    """One line, or, where that gets long, a line for each flag."""
    label, citation = f"{binding.covers.label}:", f"({binding.covers.citation})"
    words = [f"{name} if {quantity.path}" for name, _, quantity in binding.conditional]
    line = f"{label} {', '.join(words)} {citation}"
    return (line,) if len(line) < 100 else (f"{label} {citation}", *(f"  {word}" for word in words))
