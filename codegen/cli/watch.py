"""``codegen watch``: build and check again whenever a file of the specification changes."""

import argparse
import os
import sys
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from codegen.cli.deploy import port_name
from codegen.emit.folder import MANIFEST

if TYPE_CHECKING:
    import subprocess

    from watchfiles import Change

    from codegen.model.spec.spec import Project

ENDINGS = (".yaml", ".yml", ".xml", ".md")
"""Files of a specification."""
WAKE_MS = 500
"""The longest wait before it looks whether somebody has ended it."""


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "watch",
        parents=[common],
        description="Build and check now, and again whenever a file of the specification changes; Ctrl-C ends it. "
        "What a build refuses to overwrite stays, as with codegen build. With --deploy or --sim that is what follows "
        "where nothing is wrong, and code of yours counts, too.",
    )
    follows = parser.add_mutually_exclusive_group()
    follows.add_argument("--deploy", action="store_true", help="then bring the program to the board on USB")
    follows.add_argument(
        "--sim",
        metavar="SCENARIO",
        nargs="?",
        const="nominal",
        help="then start the simulation anew, which goes on without an end (default: nominal)",
    )
    parser.add_argument(
        "--port", metavar="P", type=port_name, help="of the board for --deploy (default: the only one there is)"
    )
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Go on until somebody ends it, and return the exit code."""
    from codegen.cli.project import project_file, report_no_project

    project = project_file(arguments)
    if project is None:
        return report_no_project()
    if not os.path.isfile(project):
        print(f"codegen watch: there is no {project}", file=sys.stderr)
        return 2
    if arguments.port is not None and not arguments.deploy:
        print("codegen watch: --port belongs to --deploy", file=sys.stderr)
        return 2
    following = Following(project, arguments.deploy, arguments.port, arguments.sim)
    try:
        while True:
            _until_project_changes(project, following)
    except KeyboardInterrupt:
        return 0
    finally:
        following.end()


class Following:
    """The step after a build without a fault: a deploy, a simulation that runs until the next one, or nothing."""

    def __init__(self, project: str, deploys: bool, port: str | None, scenario: str | None) -> None:
        self._project = project
        self._deploy = ["deploy", "--log", "2", *([] if port is None else ["--port", port])] if deploys else []
        self._scenario = scenario
        self._simulation: subprocess.Popen[bytes] | None = None

    @property
    def folders(self) -> list[str]:
        """Return where code lies that belongs to it, too: that of the project."""
        own = os.path.dirname(os.path.dirname(self._project))
        return [own] if self._deploy or self._scenario is not None else []

    def begin(self) -> None:
        """Do it, or start it in place of what ran before."""
        if self._deploy:
            _codegen(self._project, self._deploy).wait()
        if self._scenario is not None:
            self.end()
            self._simulation = _codegen(self._project, ["sim", self._scenario, "--duration", "forever"])

    def end(self) -> None:
        """End the simulation, if one runs."""
        if self._simulation is not None:
            self._simulation.terminate()
            self._simulation.wait()


def _until_project_changes(project: str, following: Following) -> None:
    """Build and check with each change until the project file changed, which may name other files now."""
    from watchfiles import Change, watch

    from codegen.source import shown_path

    files, folder, beside = named_files(project), os.path.dirname(project), following.folders
    roots = {folder, *program_folders(project)}
    seen = {each for root in roots for each in specification_folders(root)}

    def is_watched(change: "Change", path: str) -> bool:
        is_below = any(path.startswith(root + os.sep) for root in roots)
        is_specified = path in files or (is_below and is_specification(path))
        # Of a folder that is moved, the system tells nothing about what lies in it.
        if change is Change.added and is_below and os.path.isdir(path):
            come = specification_folders(path)
            seen.update(come)
            return bool(come)
        has_gone = change is Change.deleted and path in seen
        return is_specified or has_gone or any(is_code(path, each) for each in beside)

    folders = [*_folders(folder, files), *beside]
    found = watch(*folders, watch_filter=is_watched, debounce=300, rust_timeout=WAKE_MS, yield_on_timeout=True)
    changes = next(found)  # from here on no change is missed, those during the build included
    while project not in {path for _, path in changes}:
        if _build_and_check(project):
            following.begin()
        seen.update(each for root in roots for each in specification_folders(root))
        print(f"watching {shown_path(folder)}; Ctrl-C ends it", file=sys.stderr, flush=True)
        changes = next(each for each in found if each)
        print(f"{', '.join(sorted({shown_path(path) for _, path in changes}))} changed", file=sys.stderr, flush=True)


def named_files(project: str) -> frozenset[str]:
    """The absolute paths of the project file, and of the files that it names wherever they lie."""
    found = _stated(project)
    if found is None:
        return frozenset({project})
    names = [found.dialect, *found.overlays, *found.known, *found.corrections, *found.programs.values()]
    folder = os.path.dirname(project)
    paths = (os.path.normpath(os.path.join(folder, name)) for name in names)
    return frozenset({project, *(path for path in paths if path.endswith(ENDINGS))})


def program_folders(project: str) -> set[str]:
    """The absolute paths of the folders of further programs, wherever they lie."""
    found, folder = _stated(project), os.path.dirname(project)
    paths = () if found is None else found.programs.values()
    return {os.path.dirname(os.path.normpath(os.path.join(folder, path))) for path in paths}


def _stated(project: str) -> "Project | None":
    """Return what a project file says; None where it has errors."""
    from codegen.decode.record_file import decode_record_file
    from codegen.diagnostics import Report
    from codegen.load.files import DISK
    from codegen.model.spec.spec import Project

    return decode_record_file(project, Project, DISK, Report())


def is_specification(path: str) -> bool:
    """Return whether a path seems to be a file of a specification, and none that an editor keeps while it writes."""
    name = os.path.basename(path)
    return name.endswith(ENDINGS) and not name.startswith((".", "#", "~"))


def specification_folders(folder: str) -> set[str]:
    """The absolute paths of ``folder`` and of those below it that have files of a specification, at any depth."""
    found: set[str] = set()
    for where, _, names in os.walk(folder):
        if any(is_specification(name) for name in names):
            part = where
            while part not in found and part.startswith(folder):
                found.add(part)
                part = os.path.dirname(part)
    return found


def is_code(path: str, folder: str) -> bool:
    """Return whether a path is a module of the folder of a project, not generated and not of an environment."""
    below = path.removeprefix(folder + os.sep)
    names = below.split(os.sep)
    is_ours = names[0] == "build" or os.path.exists(os.path.join(folder, names[0], MANIFEST))
    is_hidden = any(name.startswith((".", "#", "~", "__")) for name in names)
    return below != path and names[-1].endswith(".py") and not (is_ours or is_hidden)


def _folders(folder: str, files: Iterable[str]) -> list[str]:
    """The folder of the specification, and those of files elsewhere that are there."""
    others = {os.path.dirname(path) for path in files if not path.startswith(folder + os.sep)}
    return [folder, *sorted(other for other in others if os.path.isdir(other))]


def _build_and_check(project: str) -> bool:
    """Return whether nothing is wrong. After a build that fails, check would say the same again."""
    return not any(_codegen(project, [command]).wait() for command in ("build", "check"))


def _codegen(project: str, arguments: list[str]) -> "subprocess.Popen[bytes]":
    """Start a command as a process of its own: nothing that was read before counts."""
    import subprocess

    return subprocess.Popen([sys.executable, "-m", "codegen", "--project", project, *arguments])  # noqa: S603
