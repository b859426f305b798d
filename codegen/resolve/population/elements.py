"""Assigns the elements of a message to the keys of its population table."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.answers.answer import Elements
from codegen.model.dialect.dialect import Kind, WireField, WireMessage
from codegen.model.spec.population import FieldAnswer, PopulationSpec
from codegen.model.spec.spec import Requirement
from codegen.model.vehicle import Citation
from codegen.pattern import pattern
from codegen.resolve.citation import cite
from codegen.source import Place

UNKNOWN_FIELD = Rule(
    "unknown-field",
    "A population table answers for a field that the message does not have.",
    remedy="write the name of a field as the dialect has it",
)
UNKNOWN_ELEMENT = Rule(
    "unknown-element",
    "A key of a population table is name, name[2] or name[1..9], and its elements exist in the field.",
)
ANSWERED_TWICE = Rule("answered-twice", "Two keys of a population table answer for the same element of a field.")
UNANSWERED_FIELD = Rule(
    "unanswered-field",
    "A population table answers for every field of its message, including extensions and every element of an array. "
    "Answer 'unknown' where nothing measures the value, or say 'others: unknown' for all that is not listed.",
)

_KEY = pattern(r"([A-Za-z_]\w*)(?:\[([0-9]{1,3})(?:\.\.([0-9]{1,3}))?\])?")


def answered_elements(
    population: PopulationSpec,
    message: WireMessage,
    citation: Citation,
    index: Mapping[str, Requirement],
    report: Report,
) -> list[Elements]:
    """The elements that a table answers for, in wire order; gaps and overlaps are reported.

    ``citation`` is that of the message; it holds where an answer cites nothing of its own.
    """
    answers: list[Elements] = []
    # A key that could not be read, or names no such element, was reported: its field is not "unanswered".
    broken = {_field_of(key) for key in _written_keys(population) if key not in population.fields}
    for key, answer in population.fields.items():
        cited = (
            None if answer.requirement is None else cite(answer.requirement, answer.at("requirement"), index, report)
        )
        found_elements = list(_answered(key, answer, cited or citation, message, report))
        answers.extend(found_elements)
        if not found_elements:
            broken.add(_field_of(key))
    named = {_field_of(key) for key in population.fields}
    owners: dict[tuple[str, int], Place] = {}
    kept = []
    for found in answers:
        taken = [owners.get((found.field.name, element)) for element in _elements(found)]
        earlier = next((place for place in taken if place is not None), None)
        if earlier is not None:
            report.add(
                ANSWERED_TWICE,
                found.written.place,
                f"{message.name}.{found.field.name} is answered twice",
                "leave out one of both, or answer other elements with it, as in name[1..9]",
                related=[(earlier, "the first answer is here")],
            )
            continue
        owners.update(((found.field.name, element), found.written.place) for element in _elements(found))
        kept.append(found)
    for field in message.fields:
        missing = [element for element in range(_element_count(field)) if (field.name, element) not in owners]
        if not missing or field.name in broken:
            continue
        if population.others is not None:
            kept += [_other(field, first, count, population, citation) for first, count in _runs(missing, field)]
        elif "others" not in population.places:
            _report_unanswered(population, message, field, missing, field.name in named, report)
    return sorted(kept, key=lambda found: (found.field.offset, found.first))


def _other(field: WireField, first: int, count: int, population: PopulationSpec, citation: Citation) -> Elements:
    """Elements that the table does not list: their sentinel goes out; without one the finding is at ``others``."""
    return Elements(field, first, count, FieldAnswer(place=population.at("others"), unknown=True), citation, True)


def _runs(missing: Sequence[int], field: WireField) -> Iterator[tuple[int, int]]:
    """First and number of the elements that follow one another; a text is whole."""
    if field.type.kind is Kind.CHAR:
        yield 0, field.count
        return
    for _, run in groupby(enumerate(missing), key=lambda each: each[1] - each[0]):
        members = [element for _, element in run]
        yield members[0], len(members)


def other_ranges(
    answered: Iterable[tuple[WireField, int, int]], message: WireMessage
) -> Iterator[tuple[WireField, int, int]]:
    """The field, the first element and the number of elements of what nothing answers for, in wire order."""
    taken = {(field.name, element) for field, first, count in answered for element in range(first, first + count)}
    for field in message.fields:
        missing = [element for element in range(_element_count(field)) if (field.name, element) not in taken]
        if missing:
            yield from ((field, first, count) for first, count in _runs(missing, field))


def answered_ranges(key: str, message: WireMessage) -> Iterator[tuple[WireField, int, int]]:
    """The field, the first element and the number of elements that a key answers for; nothing for a wrong key."""
    match = _KEY.fullmatch(key)
    field = None if match is None else message.field(match[1])
    if match is None or field is None:
        return
    if match[2] is None:
        yield field, 0, field.count
    elif int(match[2]) <= int(match[3] or match[2]) < field.count:
        yield field, int(match[2]), int(match[3] or match[2]) - int(match[2]) + 1


def _written_keys(population: PopulationSpec) -> list[str]:
    return [key.removeprefix("fields.") for key in population.places if key.startswith("fields.")]


def _field_of(key: str) -> str:
    return key.partition("[")[0]


def _element_count(field: WireField) -> int:
    """A text has one answer, whatever its length."""
    return 1 if field.type.kind is Kind.CHAR else field.count


def _elements(found: Elements) -> range:
    return range(found.first, found.first + (1 if found.field.type.kind is Kind.CHAR else found.count))


def _answered(
    key: str, answer: FieldAnswer, citation: Citation, message: WireMessage, report: Report
) -> Iterator[Elements]:
    match = _KEY.fullmatch(key)
    if match is None:
        report.add(UNKNOWN_ELEMENT, answer.place, f"{key!r} is not a field", "write name, name[2] or name[1..9]")
        return
    name, first, last = match.groups()
    field = message.field(name)
    if field is None:
        known = [each.name for each in message.fields]
        what = f"{message.name} has no field {name}"
        report.add(UNKNOWN_FIELD, answer.place, what, lambda: did_you_mean(name, known))
        return
    if first is None:
        yield Elements(field, 0, field.count, answer, citation)
        return
    if not field.is_array or field.type.kind is Kind.CHAR:
        report.add(
            UNKNOWN_ELEMENT,
            answer.place,
            f"{message.name}.{name} is answered as a whole, without an index",
            hint=f"write {name}",
        )
        return
    begin, end = int(first), int(last if last is not None else first)
    if not begin <= end < field.count:
        message_text = f"{message.name}.{name} has the elements 0 to {field.count - 1}, not {key[len(name) :]}"
        report.add(
            UNKNOWN_ELEMENT,
            answer.place,
            message_text,
            hint=f"write {name}[0..{field.count - 1}] for all, or one of these",
        )
        return
    yield Elements(field, begin, end - begin + 1, answer, citation)


def _report_unanswered(
    population: PopulationSpec,
    message: WireMessage,
    field: WireField,
    missing: list[int],
    is_partly_answered: bool,
    report: Report,
) -> None:
    what = f"{message.name}.{field.name}"
    if is_partly_answered:
        what += f" element{'s' if len(missing) > 1 else ''} {', '.join(map(str, missing))}"
    kind = "extension field " if field.definition.is_extension else ""
    has_sentinel = field.sentinel is not None and field.sentinel.values[0] is not None
    hint = f"add '{field.name}: unknown'" if has_sentinel else f"say where {field.name} comes from"
    report.add(
        UNANSWERED_FIELD,
        population.at("fields"),
        f"{kind}{what} is not answered",
        hint,
        [(field.definition.place, f"{field.name} is declared here")],
    )
