"""View of absences.py, which answers about what the vehicle does not have."""

from codegen.frozen import dataclass
from codegen.model.absence import Absence
from codegen.model.dialect.dialect import WireMessage


@dataclass(frozen=True, slots=True)
class KindView:
    """A message by its numbers; ``targets`` is a literal of the places of its target system and component."""

    name: str
    number: int
    crc_extra: int
    base_length: int
    length: int
    targets: str


@dataclass(frozen=True, slots=True)
class QuestionView:
    """A question by its number, and the method that answers it."""

    number: int
    method: str


@dataclass(frozen=True, slots=True)
class AbsencesView:
    """The module: the ``kinds`` of questions and answers, by number; of ``answers`` the names, too.

    ``part_question`` is the name of one about a part of a list, or nothing; all of them have the same layout.
    """

    kinds: tuple[KindView, ...]
    answers: tuple[tuple[str, int], ...]
    questions: tuple[QuestionView, ...]
    has_missions: bool
    part_question: str
    has_logs: bool
    has_modes: bool


def absences_view(absences: tuple[Absence, ...]) -> AbsencesView:
    """The view of the module for these questions."""
    answers = {absence.answer.name: absence.answer for absence in absences}
    wires = {wire.id: wire for absence in absences for wire in (absence.question, absence.answer)}
    methods = {absence.method for absence in absences}
    return AbsencesView(
        kinds=tuple(_kind(wires[number]) for number in sorted(wires)),
        answers=tuple((wire.name, wire.id) for wire in answers.values()),
        questions=tuple(QuestionView(absence.question.id, absence.method) for absence in absences),
        has_missions="count_none" in methods,
        part_question=next((each.question.name for each in absences if each.method == "refuse_part"), ""),
        has_logs="list_no_logs" in methods,
        has_modes="refuse_mode" in methods,
    )


def _kind(wire: WireMessage) -> KindView:
    return KindView(wire.name, wire.id, wire.crc_extra, wire.base_length, wire.length, str(wire.targets))
