"""Selects the parts of a specification that count: those without an overlay, and those of the project's overlays."""

import os
from dataclasses import replace

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.load.files import Files
from codegen.model.spec.spec import Correction, Project
from codegen.model.spec.state import StateSpec
from codegen.source import Written

UNKNOWN_OVERLAY = Rule(
    "unknown-overlay",
    "A population table, a quantity or a correction is for an overlay that does not exist, so it would never be used. "
    "The path is written as in codegen.yaml, relative to that file.",
    remedy="write the path as under overlays in codegen.yaml",
)


class Overlays:
    """The overlays of a project whose codegen.yaml lies in ``folder``.

    ``others`` are those that something is written for and that the project does not list, as they are written.
    ``spare`` are the corrections that belong to them.
    """

    def __init__(self, folder: str, files: Files, report: Report) -> None:
        self._folder = folder
        self._files = files
        self._report = report
        self.others: set[str] = set()
        self.spare: list[Correction] = []

    def is_used(self, record: Written, overlay: str | None, project: Project | None) -> bool:
        """Return whether the project has the overlay for which a record is written; one that is no file is reported."""
        if overlay is None:
            return True
        path = self._path(overlay)
        is_listed = project is not None and path in {self._path(name) for name in project.overlays}
        if not self._files.is_file(path):
            names = self._files.names(os.path.join(self._folder, "dialects"), Report())
            hint = did_you_mean(overlay, [f"dialects/{name}" for name in names if name.endswith(".xml")])
            self._report.add(UNKNOWN_OVERLAY, record.at("overlay"), f"there is no overlay {overlay}", hint)
        elif not is_listed:
            self.others.add(overlay)
        return is_listed

    def is_applied(self, correction: Correction, project: Project | None) -> bool:
        """Return whether a correction is used; one that is not is kept for questions about its overlay."""
        is_used = self.is_used(correction, correction.overlay, project)
        if not is_used:
            self.spare.append(correction)
        return is_used

    def state(self, state: StateSpec | None, project: Project | None) -> StateSpec | None:
        """The state without the quantities of overlays that the project does not list."""
        if state is None:
            return None
        components = {
            name: replace(
                component,
                quantities={
                    key: quantity
                    for key, quantity in component.quantities.items()
                    if self.is_used(quantity, quantity.overlay, project)
                },
            )
            for name, component in state.components.items()
        }
        return replace(state, components=components)

    def _path(self, name: str) -> str:
        return os.path.normpath(os.path.join(self._folder, name))
