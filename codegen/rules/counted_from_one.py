"""Numbers of instances that begin with 0, where by the dialect's words the first is 1, or 0 means something else."""

import re
from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.dialect.phrase import phrase
from codegen.model.system import PopulatedMessage, System

RULE = Rule(
    "counted-from-one",
    "A field with the number of an instance begins with 0, and the dialect says that the first one has another number, "
    "or that 0 means something of its own, such as all of them: a ground station that asks for number 1 gets another "
    "one, or none. With first_number, the component names a parameter with the number of its first instance.",
    Severity.WARNING,
    remedy="give the component first_number: NAME, of a parameter whose default is 1",
)

_FIRST = phrase(
    r"\b1 (?:for|is|means|indicates) (?:the )?first\b|\b1 ?[=:] ?(?:the )?first\b|"
    r"\bfirst (?:\w+ ){0,2}(?:is|has|gets|=) (?:number |index |id )?1\b|"
    r"\b(?:number(?:ed|ing)|count(?:ed|s|ing)|index(?:ed|ing)?|start(?:s|ed|ing)?|begin(?:s|ning)?) "
    r"(?:from|at|with) 1\b|"
    r"\b(?:1|one)[- ](?:based|indexed)\b",
    re.IGNORECASE,
)
_OWN_MEANING = phrase(
    r"\b1 ?(?:-|to|\.\.) ?\d+ for\b|\bbetween 1\b|\(1 ?(?:-|to|\.\.) ?\d+\)|"
    r"(?<![\w.-])0 ?(?:[:=]|for|if|means|is|indicates)(?!\w)",
    re.IGNORECASE,
)
_FROM_ZERO = phrase(
    r"\b(?:from|at|with) (?:0|zero)\b|\b(?:0|zero)[- ](?:based|indexed)\b|"
    r"(?<![\w.-])0 ?(?:[:=]|for|is|means)? ?(?:the )?first\b",
    re.IGNORECASE,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Each field of a message that is sent with the number of the instance, or with 0 in its place."""
    for message in system.messages:
        for answer in message.answers:
            if _begins_with_zero(message, answer):
                words = answer.covers.field.definition.description
                found = _words(words, is_counted=answer.covers.written.state is not None)
                if found:
                    yield _finding(message, answer, found)


def _begins_with_zero(message: PopulatedMessage, answer: Answer) -> bool:
    """Return whether a field tells the first instance by 0: of several as they are counted, of one as a constant."""
    component, written = message.component, answer.covers.written
    if component is not None and written.state == f"{component.name}.instance":
        return component.first_number is None or component.first_number.default == 0
    return answer.covers.field.definition.is_instance and answer.constants == (0,)


def _words(description: str, *, is_counted: bool) -> str | None:
    """Return the words by which the first instance is not 0; None where nothing says so."""
    if _FROM_ZERO.search(description):
        return None
    found = _FIRST.search(description) or (_OWN_MEANING.search(description) if is_counted else None)
    if found is None:
        return None
    end = re.search(r"[.;)]|$", description[found.end() :])
    return description[found.start() : found.end() + (end.start() if end else 0)].strip(" ()")


def _finding(message: PopulatedMessage, answer: Answer, words: str) -> Diagnostic:
    definition = answer.covers.field.definition
    counts = "is 0 for the first instance" if answer.covers.written.state is not None else "is 0"
    return Diagnostic(
        answer.covers.written.place,
        RULE,
        f"{message.name}.{answer.covers.field.name} {counts}, and the dialect says {words!r}",
        None if answer.covers.written.state is not None else "write the number that the dialect has for it",
        ((definition.place, "the dialect says so here"),),
    )
