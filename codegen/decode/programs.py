"""The further programs of a project: what its project file lists, and what each takes from it."""

import os
import re
from collections.abc import Iterator
from dataclasses import replace

from codegen.decode.record_file import decode_record_file
from codegen.diagnostics import Report, Rule
from codegen.frozen import dataclass
from codegen.load.files import Files
from codegen.model.program_folders import COMMON, SHARED_PARTS, SPECIFICATION_FOLDERS
from codegen.model.spec.spec import ProgramProject, Project
from codegen.pattern import pattern
from codegen.source import Place, shown_path

PROGRAM_ALONE = Rule(
    "program-alone",
    "A project file with a base is a further program of another project, and is built together with that one: its "
    "output lies there, and most of its files do. A base has no base of its own.",
)
BAD_PROGRAM_LIST = Rule(
    "bad-program-list",
    "A program that codegen.yaml lists cannot be built beside it: its name becomes a folder of the output, its project "
    "file lies in a folder of its own, and its base is the folder of the project that lists it.",
    remedy="list programs like programs: {tail: tail/codegen.yaml}",
)

_OTHER_NAME = "choose another name"
_DEVICES = "con|prn|aux|nul|com[0-9]|lpt[0-9]"
OUTPUT_FOLDERS = (*SHARED_PARTS, "docs", "schemas", "receiver", COMMON)
"""The folders of the output that a program cannot be called like."""


@dataclass(frozen=True, slots=True)
class ListedProgram:
    """A program of a project: ``base`` lists it at ``place``; ``own`` is what its project file states, if that can be
    read."""

    name: str
    project_file: str
    base: Project
    own: ProgramProject | None
    place: Place

    def project(self, own: ProgramProject) -> Project:
        """The project of the program: what it states itself, and for the rest what its base states."""
        stated = {
            key: value
            for key in ("component_id", "protocol", "machine_code")
            if (value := getattr(own, key)) is not None
        }
        # The base's system id is a default here, which a parameter of the program may set.
        places = {key: place for key, place in self.base.places.items() if key != "system_id"}
        return replace(
            self.base,
            place=own.place,
            places=places | dict(own.places),
            project=own.project,
            output=f"{self.base.output}/{self.name}",
            programs={},
            **stated,
        )


def list_programs(project_file: str, files: Files, report: Report) -> tuple[ListedProgram, ...]:
    """The programs that a project file lists, those with errors left out.

    What is wrong with the project file itself, ``decode_spec`` has reported.
    """
    base = decode_record_file(os.path.abspath(project_file), Project, files, Report())
    if base is None:
        return ()
    programs = []
    folders: dict[str, str] = {}
    for name, written in base.programs.items():
        place = base.at(f"programs.{name}")
        path = os.path.normpath(os.path.join(os.path.dirname(base.place.file), written))
        problems = [*_problems(name, path, base, folders)]
        for message, hint in problems:
            report.add(BAD_PROGRAM_LIST, place, message, hint)
        folders.setdefault(os.path.dirname(path), name)
        if problems or files.read_bytes(path, report, place) is None:
            continue
        own = decode_record_file(path, ProgramProject, files, Report())  # its findings are those of decode_program
        if own is None or _is_base(own, base, files, report):
            programs.append(ListedProgram(name, path, base, own, place))
    return tuple(programs)


def _problems(name: str, path: str, base: Project, folders: dict[str, str]) -> Iterator[tuple[str, str]]:
    if not pattern(r"[a-z][a-z0-9_]*").fullmatch(name):
        yield (
            f"{name} is no name for a program: lower-case letters, digits and underscores",
            "write it like 'tail_board'",
        )
    if re.fullmatch(_DEVICES, name):
        yield (
            f"{name} is no name for a program: Windows keeps it for a device, and could not check out its folder",
            _OTHER_NAME,
        )
    if name in OUTPUT_FOLDERS:
        yield f"the output has a folder {name} already", _OTHER_NAME
    folder, above = os.path.dirname(path), os.path.dirname(base.place.file)
    if folder in (above, *(os.path.join(above, taken) for taken in SPECIFICATION_FOLDERS)):
        yield f"{shown_path(path)} does not lie in a folder of its own", f"move it: {name}: {name}/codegen.yaml"
    if folder in folders:
        yield (
            f"{shown_path(path)} lies in the folder of the program {folders[folder]}",
            f"move it: {name}: {name}/codegen.yaml",
        )


def _is_base(own: ProgramProject, base: Project, files: Files, report: Report) -> bool:
    """Return whether the base that a program states is the project that lists it."""
    stated = os.path.normpath(os.path.join(os.path.dirname(own.place.file), own.base))
    folder = os.path.dirname(base.place.file)
    if stated == folder:
        return True
    message = f"{own.base} is not the folder of the project that lists this program"
    if not files.exists(os.path.join(stated, "codegen.yaml")):
        message = f"{own.base} is not the folder of a project"
    hint = os.path.relpath(folder, os.path.dirname(own.place.file)).replace(os.sep, "/")
    related = [(base.place, "the project that lists it")]
    report.add(BAD_PROGRAM_LIST, own.at("base"), message, f"base: {hint}", related)
    return False
