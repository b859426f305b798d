"""A received message says in which frame its positions and speeds are, and the table takes no notice of it."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.stated_frames import stated_frames
from codegen.model.system import System

RULE = Rule(
    "untreated-frame",
    "A received message says in which coordinate frame its positions, heights and speeds are, and the table takes "
    "these whatever it says: a speed ahead is taken for one to the north, a height above the ground for one above the "
    "sea. Name under 'where' the frame with which the table counts, or under 'when' of the field, or take it into a "
    "quantity that code looks at. 'when: {}' at a field says that it is the same in each frame that is sent.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each table and field of frames, at the first field that is taken without a look at it."""
    for table in system.receptions:
        seen: set[str] = set()
        frames = list(stated_frames(table.wire, system.dialect.enums))
        for taken in table.fields:
            for each in frames:
                if each.field != taken.field.name or each.judge in seen or table.looks_at(each.judge, taken):
                    continue
                seen.add(each.judge)
                judge = table.wire.field(each.judge)
                assert judge is not None
                yield Diagnostic(
                    taken.spec.place,
                    RULE,
                    f"{table.wire.name}.{taken.label} is taken whatever frame {each.judge} says",
                    f"write where: {{{each.judge}: {each.example}}} for the table, with the frame that is meant, or "
                    f"take it: {each.judge}: {{state: ...}}",
                    ((judge.definition.place, f"{each.judge} is declared here"),),
                )
