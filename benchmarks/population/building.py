"""Builds the firmware of a project, and leaves to it what the generator refuses: that is a finding, with its reason."""

import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from codegen.diagnostics import Diagnostic, Report
from codegen.project.systems import read_system
from codegen.targets.firmware import render_firmware
from codegen.targets.mocks import render_mocks
from population.answer import Answer
from population.answers import answer, refused
from population.fields import Message
from population.project import Places, write_project

Refusals = dict[str, str]
"""The rule that refuses an answer, by the answer's label."""


def build(
    dialect: str, messages: Sequence[Message], folder: Path, seed: int
) -> tuple[dict[str, list[Answer]], Refusals]:
    """Build firmware and mocks of some messages below ``folder``; tell how each is answered, and what was refused.

    These are the files that ``codegen build`` writes, without pages and the generated suite.
    """
    tables = {message.name: answer(message, seed) for message in messages}
    found: Refusals = {}
    while True:
        shutil.rmtree(folder, ignore_errors=True)
        places = write_project(folder, dialect, tables)
        report = Report()
        system = read_system(str(folder / "specs" / "codegen.yaml"), report)
        errors = [each for each in report if each.is_error]
        if system is not None and not errors:
            for name, text in {**render_firmware(system), **render_mocks(system)}.items():
                target = folder / "generated" / name
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_text(text, encoding="utf-8")
            return tables, found
        found |= _refusals(errors, places, folder, found)
        tables = {
            name: [refused(each) if _first(each) in found else each for each in answers]
            for name, answers in tables.items()
        }


def _refusals(errors: Sequence[Diagnostic], places: Places, folder: Path, known: Refusals) -> Refusals:
    """The rules by the labels of the answers that errors are about; one that is about none ends the proof."""
    found: Refusals = {}
    for error in errors:
        path = Path(error.place.file).relative_to(folder.resolve() / "specs").as_posix()
        about = places.get((path, error.place.line))
        assert about is not None, f"{error.place.shown()}: {error.rule.id}: {error.message}"
        found.setdefault(about.label, error.rule.id)
    assert found.keys() - known.keys(), [error.message for error in errors]
    return found


def _first(answer: Answer) -> str:
    """The label under which a finding about an answer is known: of a list that of its first value."""
    return replace(answer, at=0).label if answer.listed else answer.label
