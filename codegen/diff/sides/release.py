"""The dialects of a pymavlink: of the installed one, of a wheel, of a source archive, of a folder that has one."""

import os
import re

from codegen.diagnostics import Report, did_you_mean
from codegen.diff.sides.side import Side, Unreadable, dialect_side, hang
from codegen.load.files import Files
from codegen.load.shipped import dialects_in, shipped_dialect_names, shipped_dialect_path

INSTALLED = "pymavlink"
ARCHIVES = (".whl", ".zip", ".tar.gz", ".tgz", ".tar")
"""Ends of the names of archives."""

_DIALECTS = re.compile(r"(?:^|/)(?:dialects/v20|message_definitions/v1\.0)/[^/]+\.xml$")
_FOLDERS = ("", "pymavlink/dialects/v20", "dialects/v20", "v20", "message_definitions/v1.0")
_SITE_PACKAGES = re.compile(r"python3[.\d]*")


def installed_side(name: str, files: Files) -> Side | Unreadable:
    """A dialect of the installed pymavlink."""
    path = shipped_dialect_path(name, files)
    if path is None:
        return Unreadable(
            f"the installed pymavlink has no dialect {name}", did_you_mean(name, shipped_dialect_names(files))
        )
    return dialect_side(path, f"{INSTALLED}:{name}", files, is_release=True)


def release_side(release: str, name: str, files: Files) -> Side | Unreadable:
    """A dialect of another pymavlink."""
    found = release_folder(release, files, name)
    if isinstance(found, Unreadable):
        return found
    folder, files = found
    report = Report()
    dialects = dialects_in(folder, files, report)
    if report.has_errors:
        return Unreadable(f"{release} cannot be read", findings=tuple(report))
    if name not in dialects:
        return Unreadable(f"{release} has no dialect {name}", did_you_mean(name, dialects))
    return dialect_side(dialects[name], f"{release}:{name}", files, is_release=True)


def release_folder(path: str, files: Files, name: str = "common") -> tuple[str, Files] | Unreadable:
    """The folder with the dialects of a pymavlink: of a wheel, a source archive, a folder that one is installed in.

    With it come the files in which it is one.

    A folder of dialects may have ``name`` in place of common.
    """
    root = os.path.abspath(path)
    if os.path.isfile(path):
        if not path.endswith(ARCHIVES):
            return Unreadable(f"{path} is neither a dialect (.xml) nor an archive", f"archives: {', '.join(ARCHIVES)}")
        from codegen.load.archive import read_archive  # noqa: PLC0415  only these need what reads archives

        archive = read_archive(path, _DIALECTS)
        if isinstance(archive, str):
            return Unreadable(archive)
        root, files = hang(os.path.basename(path), archive, files)
        folders = sorted({os.path.dirname(inner) for inner in archive.paths()}, key=_is_second_choice)
        if folders:
            return os.path.join(root, folders[0]), files
    elif os.path.isdir(path):
        libraries = files.names(os.path.join(root, "lib"), Report())
        below = [os.path.join(root, "lib", name, "site-packages") for name in libraries]
        for start in (root, *(one for one in below if _SITE_PACKAGES.fullmatch(one.split(os.sep)[-2]))):
            for folder in _FOLDERS:
                candidate = os.path.join(start, folder).rstrip(os.sep)
                if any(files.is_file(os.path.join(candidate, f"{each}.xml")) for each in ("common", name)):
                    return candidate, files
    else:
        return Unreadable(
            f"{path} is neither a file nor a folder" if os.path.exists(path) else f"{path} does not exist"
        )
    return Unreadable(f"{path} holds neither a project nor the dialects of a pymavlink")


def _is_second_choice(folder: str) -> bool:
    return "v20" not in folder
