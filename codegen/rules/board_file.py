"""Names of the files that a program keeps on its board, against each other and against all that lies there besides."""

from collections.abc import Iterator
from typing import NamedTuple

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.spec.access import Admission
from codegen.model.system import System
from codegen.pattern import pattern
from codegen.source import Place

RULE = Rule(
    "board-file",
    "A file that the program writes or reads on the board cannot have that name: the parameters' files, the key of "
    "signed links with what is kept beside it, and the credentials of a Wi-Fi. What is saved under the name of a "
    "module, such as main.py or boot.py, takes its place, and the board starts no more; two that share a name destroy "
    "each other, also where they differ in capital letters only, which FAT does not tell apart. Nobody makes folders, "
    "and a name has letters, digits, _, . and - alone, at most 64, and no . at its end.",
    remedy="name it like parameters.0, signing.key or wifi.json",
)
MOST_LETTERS = 64
"""File systems take 255; something is added to the name of a key, and what lists files has a narrow column."""

_NAME = pattern(r"[A-Za-z0-9_.-]*[A-Za-z0-9_-]")
_MODULES = (".py", ".mpy")
_OF_DEPLOY = {
    "deployed.json": "codegen deploy has its list",
    "deploy.part": "codegen deploy puts what is not whole yet",
}
"""Files that are none of the program's, and what they are, by name."""


class _Kept(NamedTuple):
    """A file on the board: its name, who keeps what in it, where it is written, and a name that would do.

    ``besides`` are names of files that come with it.
    """

    name: str
    what: str
    place: Place
    instead: str
    besides: tuple[str, ...] = ()


def check(system: System) -> Iterator[Diagnostic]:
    """Each name by itself, and against those before it."""
    folders = _folders(system)
    owners: dict[str, tuple[str, _Kept | None]] = {
        name: (what, None) for name, what in (*_OF_DEPLOY.items(), *folders.items())
    }
    for kept in _files(system):
        problem = _problem(kept.name)
        if problem is not None:
            yield Diagnostic(
                kept.place, RULE, f"{kept.name or repr('')} cannot be where {kept.what}: {problem}", kept.instead
            )
            continue
        for name in (kept.name, *kept.besides):
            what, other = owners.setdefault(name.lower(), (kept.what, kept))
            if other is kept:
                continue
            message = f"{name} cannot be where {kept.what}: {what} there"
            if other is not None and name not in (other.name, *other.besides):
                message += f", in {other.name}, and FAT does not tell capital letters apart"
            related = () if other is None else ((other.place, f"{what} in {other.name}"),)
            yield Diagnostic(kept.place, RULE, message, kept.instead, related)
            break


def _files(system: System) -> Iterator[_Kept]:
    vehicle = system.spec.vehicle
    if vehicle is not None:
        storage, several = vehicle.storage, "files: [parameters.0, parameters.1]"
        for index, name in enumerate(storage.files):
            yield _Kept(name, "parameters are saved", storage.at(f"files[{index}]"), several)
    if vehicle is not None and vehicle.access is not None:
        access = vehicle.access
        signed = [name for name, admission in access.links.items() if admission is Admission.SIGNED]
        if signed or "key" in access.places:
            besides = tuple(f"{access.key}.{name}" for name in (*signed, "new"))
            yield _Kept(access.key, "the key is kept", access.at("key"), "key: signing.key", besides=besides)
    for name, link in system.spec.board.links.items():
        if link.credentials is not None:
            what, instead = f"{name} has its credentials", "credentials: wifi.json"
            yield _Kept(link.credentials, what, link.at("credentials"), instead)
            return  # all links have the same, or bad-link says that they have not


def _problem(name: str) -> str | None:
    """Return what is wrong with a name by itself."""
    if name.lower().endswith(_MODULES):
        return "it is the name of a module, which the board would load, and what is written takes its place"
    if "/" in name:
        return f"nobody makes the folder {name.rpartition('/')[0] or '/'} on the board"
    if len(name) > MOST_LETTERS:
        return f"it has {len(name)} letters, and {MOST_LETTERS} are the most"
    if not _NAME.fullmatch(name):
        return "use letters, digits, _, . and -, and no . at the end"
    return None


def _folders(system: System) -> dict[str, str]:
    """The folders of modules that a board has or may have, by name: a file of that name is in their way."""
    tops = {each.imported.partition(".")[0] for each in system.sources.values() if each.imported}
    if system.program is not None:
        tops.add(system.program.module.partition(".")[0])
    return {name.lower(): "modules lie in a folder" for name in ("lib", *sorted(tops))}
