"""Collects the explanations of one topic from all programs of a project."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from codegen.diagnostics import Report

if TYPE_CHECKING:
    from codegen.model.system import System


_INCOMPLETE = "The specification has errors, and what they concern may be missing here: codegen check tells them.\n"


def story_of(topic: str, project: str | None, report: Report) -> str | None:
    """Return what there is to tell of ``topic``; None, with findings, where there is nothing.

    Whoever asks what a rule means often has a specification that breaks it: what is wrong with the specification is a
    finding only where nothing can be told. Without a project there are rules alone.
    """
    from codegen.explain.story import explain
    from codegen.project.systems import read_systems

    reading = Report()
    systems = () if project is None else read_systems(project, reading)
    own = "\n".join(_stories(topic, systems))
    if own:
        return own
    story = explain(topic, systems[0] if systems else None, report)
    if story is None and (reading.has_errors or not systems):
        report.extend(finding for finding in reading if finding.is_error or not systems)
    elif story is not None and systems and reading.has_errors:
        story = f"{story}\n{_INCOMPLETE}"
    return story


def _stories(topic: str, systems: "Sequence[System]") -> Iterator[str]:
    """Return the stories of the programs that have it themselves, each once, with the names of further programs.

    Of a message or a command, which the dialect knows whoever has it, the last line names the programs without it.
    """
    from codegen.explain.dialect import without_it
    from codegen.explain.story import own_story

    told: dict[str, list[System]] = {}
    others = []
    for system in systems:
        story = own_story(topic, system)
        if story is None:
            others.append(system)
        else:
            told.setdefault(story, []).append(system)
    for story, having in told.items():
        names = [system.spec.program for system in having]
        heading = f"In the {'program' if len(names) == 1 else 'programs'} {', '.join(names)}:\n"
        yield story if "" in names else f"{heading}{story}"
    if told and others:
        yield from without_it(topic, others)
