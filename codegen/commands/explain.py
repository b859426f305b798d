"""Collects the explanations of one topic from all programs of a project."""

from codegen.diagnostics import Report


def story_of(topic: str, project: str | None, report: Report) -> str | None:
    """Return what there is to tell of ``topic``; None, with findings, where there is nothing.

    Whoever asks what a rule means often has a specification that breaks it: what is wrong with the specification is a
    finding only where nothing can be told. Without a project there are rules alone.
    """
    from codegen.explain.story import explain
    from codegen.project.systems import read_systems

    reading = Report()
    systems = () if project is None else read_systems(project, reading)
    story = explain(topic, systems[0] if systems else None, report)
    for program in systems[1:]:
        told = explain(topic, program, Report())
        if told is not None and told != story:
            heading = f"In the program {program.spec.program}:\n{told}"
            story = heading if story is None else f"{story}\n{heading}"
    if story is None and not systems:
        report.extend(reading)
    return story
