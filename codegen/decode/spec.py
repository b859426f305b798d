"""The folder of a project file: which files belong to a specification, and the specification they state.

The specification of a further program is that of its base, but for the files that lie in the program's own folder.
"""

import codecs
import hashlib
import os
from typing import TypeVar

from codegen.decode.board_model import FOLDER, board_model_path
from codegen.decode.decoded import decoded
from codegen.decode.driver_modules import driver_module, stores_of, user_modules
from codegen.decode.overlays import Overlays
from codegen.decode.programs import PROGRAM_ALONE, ListedProgram
from codegen.decode.record import decode_record
from codegen.decode.record_file import decode_record_file, decode_record_text
from codegen.decode.requirement import check_unique, decode_requirement
from codegen.decode.unread import DRIVERS, report_unread
from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.load.files import Files
from codegen.load.markdown import parse_markdown
from codegen.load.text import decode_text
from codegen.load.yaml_tree import MappingNode, parse_yaml
from codegen.model.board_model import BoardModelSpec
from codegen.model.spec.board import BoardSpec
from codegen.model.spec.command import CommandsSpec
from codegen.model.spec.driver import DriverSpec, OwnDriver
from codegen.model.spec.population import PopulationSpec
from codegen.model.spec.program import CodeSpec, VehicleSpec
from codegen.model.spec.receive import ReceiveSpec
from codegen.model.spec.receiver import ReceiverSpec
from codegen.model.spec.source import OwnSourceSpec
from codegen.model.spec.spec import (
    Correction,
    CorrectionsSpec,
    ParametersSpec,
    ProgramProject,
    Project,
    Refusal,
    Requirement,
    Spec,
    StreamsSpec,
)
from codegen.model.spec.state import StateSpec
from codegen.source import Place, Written, shown_path

NO_MESSAGES = Rule(
    "no-messages",
    "The folder messages beside codegen.yaml has no YAML file, or a further program lists no message. A station knows "
    "a program by its HEARTBEAT. Write one population table for each message. A codec needs none: codegen codec.",
)
INCOMPLETE_PROJECT = Rule(
    "incomplete-project",
    "A project has state.yaml, board.yaml, parameters.yaml and streams.yaml beside its codegen.yaml, and some of them "
    "are missing. codegen init writes a project that has everything, with comments.",
    unreadable=True,
)
DUPLICATE_TABLE = Rule(
    "duplicate-table",
    "Two tables of messages have the same name, so it is ambiguous what is sent, or taken: they are for the same "
    "message, or say the same 'as'. Merge them into one, or give one of them a name of its own with 'as: NAME'.",
)
NO_TABLE = Rule(
    "no-table",
    "A program lists a message that has no population table, neither in its own folder messages nor in that of its "
    "base. Write the table, or correct the name.",
    remedy="write a table for it in messages, or take it out of the list",
)
FIXED_FILES = ("state.yaml", "board.yaml", "parameters.yaml", "streams.yaml")
"""The files that every project has beside its project file."""
PROGRAM_FILE = "vehicle.yaml"
RECEIVER_FILE = "receiver.yaml"
COMMANDS_FILE = "commands.yaml"
OPTIONAL_FILES = (PROGRAM_FILE, RECEIVER_FILE, COMMANDS_FILE)
"""Files beside it that only a project with a whole program, a receiver for its messages, or commands of its own has."""

_Record = TypeVar("_Record", bound=Written)


def decode_spec(project_file: str, files: Files, report: Report) -> Spec | None:
    """The specification of a project file and of the files beside it.

    Everything that is wrong in any of the files is reported. The result is None where the project file, one of the
    four fixed files, or vehicle.yaml where there is one, could not be decoded at all; otherwise it lacks the records
    that could not be, so what later stages say about a missing record may follow from an error that was reported here.
    """
    return _SpecReader(os.path.abspath(project_file), None, files, report).read()


def decode_program(program: ListedProgram, files: Files, report: Report) -> Spec | None:
    """The specification of a further program; what is said of ``decode_spec`` holds for it, too."""
    return _SpecReader(program.project_file, program, files, report).read()


def _hash(data: bytes) -> str:
    """The sha256 of a text, whatever its line ends are, with a byte order mark or without: editors and git choose."""
    return hashlib.sha256(data.removeprefix(codecs.BOM_UTF8).replace(b"\r\n", b"\n")).hexdigest()


class _SpecReader:
    """Reads the files of one specification and keeps account of them.

    Of a further program, ``_folder`` is its own, and ``_base`` that of the project that lists it; else both are one.
    """

    def __init__(self, project_file: str, program: ListedProgram | None, files: Files, report: Report) -> None:
        self._project_file = project_file
        self._program = program
        self._folder = os.path.dirname(project_file)
        self._base_file = program.base.place.file if program else project_file
        self._base = os.path.dirname(self._base_file)
        self._files = files
        self._report = report
        self._overlays = Overlays(self._base, files, report)
        self._hashes: dict[str, str] = {}
        self._unused_tables: dict[str, str] = {}  # their overlays, by name
        self._own_drivers: tuple[str, ...] = ()  # those that the project has, used or not
        self._has_broken_table = False
        self._missing: list[str] = []  # of the files that every project has

    def read(self) -> Spec | None:
        # A project file with errors does not keep the other files from being checked.
        project = self._main_project() if self._program is None else self._program_project(self._program)
        if self._project_file not in self._hashes:
            return None
        self._missing = [name for name in FIXED_FILES if not self._files.exists(self._used(name))]
        if len(self._missing) > 1:
            message = f"there is no {', '.join(self._missing[:-1])} and {self._missing[-1]} beside it"
            hint = "codegen init FOLDER writes a project that has them all"
            self._report.add(INCOMPLETE_PROJECT, Place(self._project_file), message, hint)
        state = self._overlays.state(self._fixed("state.yaml", StateSpec), project)
        board = self._fixed("board.yaml", BoardSpec)
        board_model = None if board is None else self._board_model(board)
        drivers, broken_drivers = self._drivers(board)
        parameters = self._fixed("parameters.yaml", ParametersSpec)
        streams = self._fixed("streams.yaml", StreamsSpec)
        vehicle = self._optional(PROGRAM_FILE, VehicleSpec)
        commands = self._optional(COMMANDS_FILE, CommandsSpec)
        populations = self._populations(project)
        if self._program is not None:
            populations = self._chosen(populations, self._program)
        corrections, refusals = self._corrections(project)
        receives = self._receives(project)
        requirements = self._requirements()
        receiver = self._receiver()
        if project is not None:
            self._add_hashes(project)
            beside, in_program = (*FIXED_FILES, *OPTIONAL_FILES), self._program is not None
            report_unread(
                self._folder, self._hashes, beside, files=self._files, report=self._report, in_program=in_program
            )
        if project is None or state is None or board is None or parameters is None or streams is None:
            return None
        if vehicle is None and self._used(PROGRAM_FILE) in self._hashes:
            return None  # what is said about a project without a program would not hold
        app = (vehicle.code or CodeSpec(place=vehicle.place)).module if vehicle else None
        return Spec(
            folder=self._base,
            own_folder=self._folder,
            program=self._program.name if self._program else "",
            project=project,
            state=state,
            board=board,
            board_model=board_model,
            parameters=parameters,
            streams=streams,
            vehicle=vehicle,
            populations=populations,
            corrections=corrections,
            requirements=requirements,
            files=dict(sorted(self._hashes.items())),
            receiver=receiver,
            refusals=refusals,
            receives=receives,
            commands=commands,
            drivers=drivers,
            broken_drivers=broken_drivers,
            own_drivers=self._own_drivers,
            user_modules=user_modules(board.sources.values(), app, self._base, self._files),
            state_stores=stores_of(board.sources.values(), app, self._base, self._files),
            other_overlays=tuple(sorted(self._overlays.others)),
            other_corrections=tuple(self._overlays.spare),
        )

    def _main_project(self) -> Project | None:
        text = self._text(self._project_file, None)
        if text is None:
            return None

        def read(found: Report) -> Project | None:
            node = parse_yaml(text, self._project_file, found)
            if isinstance(node, MappingNode):
                for key, value in node.entries:
                    if key.text == "base":
                        self._hashes.clear()  # nothing else here would be read as it is meant
                        hint = "run codegen on the project that lists it: --project FILE"
                        found.add(PROGRAM_ALONE, value.place, "this is a program of another project", hint)
                        return None
            return None if node is None else decode_record(node, Project, found)

        return decoded("main project", text, self._project_file, read, self._report)

    def _program_project(self, program: ListedProgram) -> Project | None:
        """Return what the program states, and its base for the rest."""
        self._text(self._base_file, None)
        own = self._record(self._project_file, ProgramProject, program.place)
        return None if own is None else program.project(own)

    def _text(self, path: str, asked_at: Place | None) -> str | None:
        data = self._files.read_bytes(path, self._report, asked_at)
        if data is None:
            return None
        self._hashes[path] = _hash(data)
        return decode_text(data, path, self._report)

    def _record(self, path: str, cls: type[_Record], asked_at: Place) -> _Record | None:
        text = self._text(path, asked_at)
        return None if text is None else decode_record_text(text, path, cls, self._report)

    def _fixed(self, name: str, cls: type[_Record]) -> _Record | None:
        if name in self._missing and len(self._missing) > 1:
            return None  # one finding names them all
        return self._record(self._used(name), cls, Place(self._base_file))

    def _optional(self, name: str, cls: type[_Record]) -> _Record | None:
        path = self._used(name)
        return self._record(path, cls, Place(path)) if self._files.exists(path) else None

    def _board_model(self, board: BoardSpec) -> BoardModelSpec | None:
        """Return what there is to know about the board; None where none is named, or after a finding."""
        if board.board is None:
            return None
        place = board.at("board")
        path = board_model_path(board.board, (self._folder, self._base), place, self._files, self._report)
        if path is None:
            return None
        if os.path.dirname(path) == FOLDER:  # codegen itself, and no file of the specification
            return decode_record_file(path, BoardModelSpec, self._files, self._report, place)
        return self._record(path, BoardModelSpec, place)

    def _drivers(self, board: BoardSpec | None) -> tuple[dict[str, OwnDriver], frozenset[str]]:
        """The project's own drivers that sensors name, and those of them that could not be read."""
        sources = board.sources.values() if board else ()
        names = {source.driver for source in sources if isinstance(source, OwnSourceSpec)}
        drivers = {}
        found = {os.path.basename(path).removesuffix(".yaml"): path for path in self._united(DRIVERS, (".yaml",))}
        self._own_drivers = tuple(sorted(found))
        for name in sorted(names & found.keys()):
            path = found[name]
            module = path.removesuffix(".yaml") + ".py"
            found_before = self._report.count
            spec, text = self._record(path, DriverSpec, Place(path)), self._text(module, Place(path))
            if spec is not None and text is not None and self._report.count == found_before:
                drivers[name] = OwnDriver(spec, module, text, driver_module(module, text))
        return drivers, frozenset((names & found.keys()) - drivers.keys())

    def _receiver(self) -> ReceiverSpec | None:
        """The receiver of the messages of this program; a further one does not repeat that of its base."""
        path = os.path.join(self._folder, RECEIVER_FILE)
        return self._record(path, ReceiverSpec, Place(path)) if self._files.exists(path) else None

    def _populations(self, project: Project | None) -> tuple[PopulationSpec, ...]:
        """The tables in use, by the names of their files; of two with one name the first."""
        paths = self._united("messages", (".yaml",))
        if not paths and len(self._missing) < 2:
            lost = "".join(
                f"; {name} needs one" for name in ("commands.yaml", "receives") if self._files.exists(self._used(name))
            )
            what = f"there is no population table messages/*.yaml, so nothing would be sent{lost}"
            hint = "write messages/heartbeat.yaml: codegen init FOLDER writes a project that has it"
            self._report.add(NO_MESSAGES, Place(self._base_file), what, hint)
        tables: dict[str, PopulationSpec] = {}
        for path in paths:
            table = self._record(path, PopulationSpec, Place(path))
            if table is None:
                self._has_broken_table = True
                continue
            if not self._overlays.is_used(table, table.overlay, project):
                assert table.overlay is not None
                self._unused_tables[table.name] = table.overlay
                continue
            first = tables.setdefault(table.name, table)
            if first is not table:
                place, where = (each.at("as" if each.named else "message") for each in (first, table))
                message = f"{table.name} has a table already, {shown_path(place.file)}"
                hint = "'as: NAME' gives one of them a name of its own"
                if os.path.dirname(place.file) != os.path.dirname(path):
                    hint = "a table of a program takes the place of its base's that has the same file name"
                related = [(place, "the first table")]
                self._report.add(DUPLICATE_TABLE, where, message, hint, related)
        return tuple(tables.values())

    def _receives(self, project: Project | None) -> tuple[ReceiveSpec, ...]:
        """The tables of received messages in use, those of this program alone; of two with one name the first."""
        tables: dict[str, ReceiveSpec] = {}
        for path in self._listed("receives", (".yaml",)):
            table = self._record(path, ReceiveSpec, Place(path))
            if table is None or not self._overlays.is_used(table, table.overlay, project):
                continue
            first = tables.setdefault(table.name, table)
            if first is not table:
                place, where = (each.at("as" if each.named else "receive") for each in (first, table))
                message = f"{table.name} has a table already, {shown_path(place.file)}"
                hint = "'as: NAME' gives one of them a name of its own"
                self._report.add(DUPLICATE_TABLE, where, message, hint, [(place, "the first table")])
        return tuple(tables.values())

    def _chosen(self, tables: tuple[PopulationSpec, ...], program: ListedProgram) -> tuple[PopulationSpec, ...]:
        """The tables of the messages that a program has; the others count as not read."""
        own = program.own
        if own is None or own.messages is None:
            return tables
        if not own.messages:
            message = f"{program.name} lists no message, so nothing would be sent"
            way = "list its messages, or leave out messages: without it all tables are used"
            self._report.add(NO_MESSAGES, own.at("messages"), message, way)
            return tables
        known = {table.name: table for table in tables}
        is_complete = not self._has_broken_table  # what is broken has been reported
        for index, name in enumerate(own.messages):
            if name not in known and is_complete:
                hint = did_you_mean(name, known)
                if name in self._unused_tables:
                    hint = f"its table is for {self._unused_tables[name]}, which is none of the overlays of the project"
                elif named := [table.name for table in tables if table.message == name]:
                    hint = f"its tables have names: {', '.join(named)}"
                place = own.at(f"messages[{index}]")
                self._report.add(NO_TABLE, place, f"there is no table for {name}", hint)
        for table in tables:
            if table.name not in own.messages:
                del self._hashes[table.place.file]
        return tuple(table for table in tables if table.name in own.messages)

    def _corrections(self, project: Project | None) -> tuple[tuple[Correction, ...], tuple[Refusal, ...]]:
        """The project's corrections, and which of codegen's own it refuses."""
        corrections: list[Correction] = []
        refusals: list[Refusal] = []
        for index, name in enumerate(project.corrections if project else ()):
            assert project is not None
            decoded = self._record(self._path(name), CorrectionsSpec, project.at(f"corrections[{index}]"))
            for correction in decoded.corrections if decoded else ():
                if self._overlays.is_applied(correction, project):
                    corrections.append(correction)
            refusals += decoded.refuse if decoded else ()
        return tuple(corrections), tuple(refusals)

    def _requirements(self) -> tuple[Requirement, ...]:
        requirements = []
        for path in self._united("requirements", (".md",)):
            text = self._text(path, Place(path))
            requirement = None if text is None else self._requirement(text, path)
            if requirement is not None:
                requirements.append(requirement)
        check_unique(requirements, self._report)
        return tuple(requirements)

    def _requirement(self, text: str, path: str) -> Requirement | None:
        def read(found: Report) -> Requirement | None:
            return decode_requirement(parse_markdown(text, path), found)

        return decoded("requirement", text, path, read, self._report)

    def _add_hashes(self, project: Project) -> None:
        """Account for the XML files that the project names; whoever reads them reports what is wrong with them."""
        for name in (project.dialect, *project.overlays, *project.known):
            data = self._files.read_bytes(self._path(name), Report()) if name.endswith(".xml") else None
            if data is not None:
                self._hashes[self._path(name)] = _hash(data)

    def _path(self, name: str) -> str:
        """The path of a file that the project names: below the base, where that is stated."""
        return os.path.normpath(os.path.join(self._base, name))

    def _own(self, name: str) -> str:
        return os.path.join(self._folder, name)

    def _used(self, name: str) -> str:
        """The path of a file with a fixed name: the program's own, if there is one."""
        own = self._own(name)
        return own if self._files.exists(own) else os.path.join(self._base, name)

    def _united(self, folder: str, endings: tuple[str, ...]) -> list[str]:
        """The files of the base's folder and of the program's own by name; of two with one name its own."""
        paths = self._listed(folder, endings, self._base) + self._listed(folder, endings)
        return [path for _, path in sorted({os.path.basename(path): path for path in paths}.items())]

    def _listed(self, folder: str, endings: tuple[str, ...], below: str | None = None) -> list[str]:
        """The files of a folder with one of the endings, by name; hidden files (of editors) are left out."""
        path = os.path.join(below or self._folder, folder).rstrip(os.sep)
        names = self._files.names(path, self._report)
        return [os.path.join(path, name) for name in names if name.endswith(endings) and not name.startswith(".")]
