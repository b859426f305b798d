"""New projects: each kind is a folder of templates/start, a project as it stands, or codegen's own specification."""

import json
import os
import re
from collections.abc import Iterator, Mapping

from codegen.decode.board_model import FOLDER, board_model_path
from codegen.decode.record_file import decode_record_file
from codegen.diagnostics import Report, Rule, did_you_mean, shortened_list
from codegen.frozen import dataclass
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path
from codegen.model.board_model import BoardModelSpec
from codegen.source import Place
from codegen.tool.template_files import templates_folder

CODEC = "codec"
"""The kind that has no specification: a dialect of one's own, of which a codec is made."""

INIT_EXISTS = Rule(
    "init-exists",
    "codegen init never overwrites: where a file of the new project is there already, nothing is written. Name another "
    "folder, or move the files away.",
)
INIT_UNKNOWN = Rule(
    "init-unknown",
    "codegen init was given a board that codegen does not describe, or a dialect that pymavlink does not ship and that "
    "is no XML file.",
    unreadable=True,
    remedy="write the path of an XML file, if the dialect is one of your own",
)

_COMMON = {"gitattributes": ".gitattributes", "gitignore": ".gitignore", "codegen.yml": ".github/workflows/codegen.yml"}
_PLAIN = re.compile(r"[A-Za-z][\w.-]*")


@dataclass(frozen=True, slots=True)
class Wish:
    """A request for a new project: a kind, in a folder (absolute). None leaves board or dialect as the kind has it."""

    kind: str
    folder: str
    board: str | None = None
    dialect: str | None = None


def start_files(wish: Wish, report: Report) -> dict[str, str]:
    """The text of each file of the new project by its path below the folder; empty after a finding."""
    has_wifi = wish.board is None or _has_wifi(wish.board, report)
    dialect, copied = _dialect(wish, report)
    if report.has_errors:
        return {}
    files = _kind_files(wish.kind)
    if wish.kind == CODEC:
        files = {path: _replaced(text, "common", dialect) for path, text in files.items()}
        return files | {f"dialects/{name}": text for name, text in copied.items()}
    common = _texts(os.path.join(templates_folder(), "start", "common"))
    files |= {path: common[name] for name, path in _COMMON.items()}
    project = files["specs/codegen.yaml"]
    project = _with(project, "project", os.path.basename(wish.folder))
    files["specs/codegen.yaml"] = project if dialect is None else _with(project, "dialect", dialect)
    files |= {f"specs/dialects/{name}": text for name, text in copied.items()}
    if wish.board is not None:
        board = _with(files["specs/board.yaml"], "board", wish.board)
        if not has_wifi:
            board = _with_links(board, common["board_cable.yaml"])
        files["specs/board.yaml"] = board
    return dict(sorted(files.items()))


def report_existing(folder: str, paths: Mapping[str, object], report: Report) -> None:
    """One finding about everything that is in the way of the new files."""
    there = [path for path in paths if os.path.lexists(os.path.join(folder, path))]
    blocked = os.path.lexists(folder) and not os.path.isdir(folder)
    if blocked:
        report.add(INIT_EXISTS, Place(folder), "it is not a folder", "name another one: codegen init FOLDER")
    elif there:
        message = f"{'it is' if len(there) == 1 else 'they are'} there already: {shortened_list(there)}"
        report.add(INIT_EXISTS, Place(folder), message, "name another folder: codegen init FOLDER")


def _kind_files(kind: str) -> dict[str, str]:
    """The files of a kind; without a folder it is the specification that codegen itself is built and tested with."""
    folder = os.path.join(templates_folder(), "start", kind)
    if os.path.isdir(folder):
        return _texts(folder)
    installed = os.path.join(os.path.dirname(templates_folder()), "own_specs")
    checkout = os.path.join(os.path.dirname(templates_folder()), "specs")
    specs = _texts(installed if os.path.isdir(installed) else checkout)
    return {f"specs/{path}": text for path, text in specs.items()}


def _texts(folder: str) -> dict[str, str]:
    """The text of each file below a folder by its path there."""
    found = {}
    for where, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(where, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder).replace(os.sep, "/")] = file.read().decode("utf-8")
    return found


def _with_links(board: str, links: str) -> str:
    """Return the text of a board.yaml with other links; what else it says stays."""
    parts = board.rstrip("\n").split("\n\n")
    return "\n\n".join(links.rstrip("\n") if "\nlinks:" in f"\n{part}" else part for part in parts) + "\n"


def _has_wifi(board: str, report: Report) -> bool:
    place = Place(os.getcwd())
    path = board_model_path(board, (), place, DISK, Report())
    if path is None:
        names = [name for name, _ in boards()]
        report.add(INIT_UNKNOWN, place, f"codegen describes no board {board}", did_you_mean(board, names))
        return True
    model = decode_record_file(path, BoardModelSpec, DISK, report, place)
    return model is None or model.wifi


def boards() -> Iterator[tuple[str, str]]:
    """The boards that come with codegen: what each is called in board.yaml, and the path of its file."""
    for name in DISK.names(FOLDER, Report()):
        yield name.removesuffix(".yaml"), os.path.join(FOLDER, name)


def _dialect(wish: Wish, report: Report) -> tuple[str | None, dict[str, str]]:
    """Return how the project names its dialect (None: as its kind does), and the
    files that are copied for it by name.
    """
    written = wish.dialect
    if written is None or shipped_dialect_path(written, DISK) is not None:
        return written, {}
    if not written.lower().endswith(".xml"):
        hint = did_you_mean(written, shipped_dialect_names(DISK))
        report.add(INIT_UNKNOWN, Place(os.getcwd()), f"pymavlink ships no dialect {written}", hint)
        return None, {}
    text = DISK.read_text(os.path.abspath(written), report)
    name = os.path.basename(written)
    return f"dialects/{name}", {} if text is None else {name: text}


def _with(text: str, key: str, value: str) -> str:
    """A YAML file with another value for a key of its top level."""
    shown = value if _PLAIN.fullmatch(value) or "/" in value else json.dumps(value, ensure_ascii=False)
    return re.sub(rf"(?m)^{key}: .*$", lambda _found: f"{key}: {shown}", text, count=1)


def _replaced(text: str, old: str, new: str | None) -> str:
    return text if new is None else text.replace(f"{old}.xml", f"{os.path.basename(new).removesuffix('.xml')}.xml")


def check_wish(wish: "Wish", files: dict[str, str], report: "Report") -> None:
    """Report what does not fit the board or the dialect that were chosen, at the places that the files will have."""
    import tempfile
    from dataclasses import replace

    from codegen.diagnostics import Report
    from codegen.project.systems import check_scenarios, read_systems
    from codegen.source import Place

    found = Report()
    with tempfile.TemporaryDirectory(prefix="codegen-init-") as folder:
        trial = os.path.realpath(folder)
        _write_files(trial, files, found)
        project = os.path.join(trial, "specs", "codegen.yaml")
        systems = read_systems(project, found)
        check_scenarios(project, systems, found)

        def moved(place: Place) -> Place:
            inside = place.file.startswith(trial + os.sep)
            return place._replace(file=wish.folder + place.file[len(trial) :]) if inside else place

        for finding in found:
            related = tuple((moved(place), text) for place, text in finding.related)
            report.extend([replace(finding, place=moved(finding.place), related=related)])


def write_project(folder: str, files: dict[str, str], schemas: dict[str, str], report: "Report") -> None:
    """The files, and the schemas where a build will have them: an editor checks from the start."""
    from codegen.emit.plan import plan_output
    from codegen.emit.write import write_output

    _write_files(folder, files, report)
    plan = plan_output(schemas, os.path.join(folder, "generated"), report) if schemas else None
    if plan is not None and not report.has_errors:
        write_output(plan, report)


def _write_files(folder: str, files: dict[str, str], report: "Report") -> None:
    from codegen.emit.file import write_file

    for path, text in files.items():
        write_file(os.path.join(folder, path), text, report)


def schemas_for_editors() -> dict[str, str]:
    """Return the schemas of the specification files by their paths below the output folder."""
    from codegen.targets.schemas.texts import schema_texts

    return {f"schemas/{name}": text for name, text in schema_texts().items()}
