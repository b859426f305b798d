"""``codegen watch``: build and check again whenever a file of the specification changes."""

import argparse
import os
import sys
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from watchfiles import Change

ENDINGS = (".yaml", ".yml", ".xml", ".md")
"""Files of a specification."""
WAKE_MS = 500
"""How long it waits at most before it looks whether somebody has ended it."""


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "watch",
        parents=[common],
        description="Build and check now, and again whenever a file of the specification changes; Ctrl-C ends it. "
        "What a build refuses to overwrite stays, as with codegen build.",
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
    try:
        while True:
            _until_project_changes(project)
    except KeyboardInterrupt:
        return 0


def _until_project_changes(project: str) -> None:
    """Build and check with each change until the project file changed, which may name other files now."""
    from watchfiles import watch

    from codegen.source import shown_path

    files, folder = named_files(project), os.path.dirname(project)

    def is_watched(_change: "Change", path: str) -> bool:
        return path in files or (path.startswith(folder + os.sep) and is_specification(path))

    found = watch(
        *_folders(folder, files), watch_filter=is_watched, debounce=300, rust_timeout=WAKE_MS, yield_on_timeout=True
    )
    changes = next(found)  # from here on no change is missed, those during the build included
    while project not in {path for _, path in changes}:
        _build_and_check(project)
        print(f"watching {shown_path(folder)}; Ctrl-C ends it", file=sys.stderr, flush=True)
        changes = next(each for each in found if each)
        print(f"{', '.join(sorted({shown_path(path) for _, path in changes}))} changed", file=sys.stderr, flush=True)


def named_files(project: str) -> frozenset[str]:
    """The absolute paths of the project file, and of the files that it names wherever they lie."""
    from codegen.decode.record_file import decode_record_file
    from codegen.diagnostics import Report
    from codegen.model.spec import Project

    found = decode_record_file(project, Project, Report())
    if found is None:
        return frozenset({project})
    names = [found.dialect, *found.overlays, *found.known, *found.corrections, *found.programs.values()]
    folder = os.path.dirname(project)
    paths = (os.path.normpath(os.path.join(folder, name)) for name in names)
    return frozenset({project, *(path for path in paths if path.endswith(ENDINGS))})


def is_specification(path: str) -> bool:
    """Whether a path seems to be a file of a specification, and none that an editor keeps while it writes."""
    name = os.path.basename(path)
    return name.endswith(ENDINGS) and not name.startswith((".", "#", "~"))


def _folders(folder: str, files: Iterable[str]) -> list[str]:
    """The folder of the specification, and those of files elsewhere that are there."""
    others = {os.path.dirname(path) for path in files if not path.startswith(folder + os.sep)}
    return [folder, *sorted(other for other in others if os.path.isdir(other))]


def _build_and_check(project: str) -> None:
    """Run both as processes of their own: nothing that was read before counts."""
    import subprocess

    for command in ("build", "check"):
        done = subprocess.run(  # noqa: S603
            [sys.executable, "-m", "codegen", "--project", project, command], check=False
        )
        if done.returncode:
            return  # check would say the same again
