"""Numbers of a received field that are no value: those that leave its quantity as it was, and further unknown ones."""

from codegen.diagnostics import Report
from codegen.model.dialect.dialect import EnumDefinition, Kind, WireField
from codegen.model.spec.receive import ReceivedFieldSpec
from codegen.model.units.unit import decimal
from codegen.resolve.dialect.special_numbers import SPECIAL_VALUE, Numbers, is_among, listed, numbers, problems


def special_values(
    field: WireField, written: ReceivedFieldSpec, enum: EnumDefinition | None, report: Report
) -> tuple[Numbers, Numbers]:
    """Return the numbers that leave the quantity as it was, and those that set it unknown beside the sentinel.

    What the table lists goes before what a correction states, of which problems are told at the correction; an empty
    list is that there are none.
    """
    if field.type.kind is Kind.CHAR:
        for key in ("unchanged", "unknown"):
            if key in written.places:
                report.add(SPECIAL_VALUE, written.at(key), f"{key} says nothing of a text", "leave it out")
        return (), ()
    definition = field.definition
    lists: dict[str, Numbers] = {}
    for key, own, stated in (
        ("unchanged", written.unchanged, definition.unchanged),
        ("unknown", written.unknown, definition.unknown),
    ):
        if own is not None:
            texts = [each if isinstance(each, str) else decimal(each) for each in own]
            for problem in problems(texts, field.type, enum):
                report.add(SPECIAL_VALUE, written.at(key), f"{field.name}: {problem.message}", problem.hint)
        else:
            texts = listed(stated)
        lists[key] = numbers(texts, field.type, enum)
    unchanged, unknown = lists["unchanged"], lists["unknown"]
    both = tuple(number for number in unknown if is_among(number, unchanged))
    if not both:
        return unchanged, unknown
    if written.unchanged is not None and written.unknown is not None:
        message = f"{field.name}: {both[0]} leaves the quantity as it was, and makes it unknown"
        related = [(written.at("unchanged"), "the other list is here")]
        report.add(SPECIAL_VALUE, written.at("unknown"), message, "keep it in one of the lists", related)
    if written.unchanged is None:
        return tuple(number for number in unchanged if not is_among(number, both)), unknown
    return unchanged, tuple(number for number in unknown if not is_among(number, both))
