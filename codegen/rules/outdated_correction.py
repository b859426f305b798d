"""A correction that comes with codegen quotes words that the dialect no longer has."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.dialect import Standing
from codegen.model.system import System

RULE = Rule(
    "outdated-correction",
    "codegen comes with a correction for a field that the project sends, but the installed pymavlink no longer has the "
    "words that it quotes, so it is not applied. Read what the dialect says now, and state it in a correction of the "
    "project if an attribute still lacks it; or refuse the correction, with the reason.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each correction of a populated message that does not hold."""
    populated = {message.name: message.wire for message in system.messages}
    told = set()
    for correction in system.dialect.corrections:
        message = populated.get(correction.owner)
        field = message.field(correction.part) if message else None
        if correction.standing is not Standing.OUTDATED or field is None or correction.place in told:
            continue
        told.add(correction.place)
        yield Diagnostic(
            field.definition.place,
            RULE,
            f"{correction.owner}.{correction.part} no longer says {correction.grounds!r}, so {correction.attribute} "
            f"is not corrected to {correction.text}",
            "state it in a correction of the project, or refuse it there",
            ((correction.place, "the correction that comes with codegen"),),
        )
