"""The dialects of a pymavlink: of the installed one, of a wheel, of a source archive, of a folder that has one."""

import os
import re
from contextlib import ExitStack

from codegen.diagnostics import did_you_mean
from codegen.diff.sides.side import Side, Unreadable, dialect_side, hang
from codegen.load.shipped import dialects_in, shipped_dialect_names, shipped_dialect_path
from codegen.load.trees import file_names, is_file

INSTALLED = "pymavlink"
ARCHIVES = (".whl", ".zip", ".tar.gz", ".tgz", ".tar")
"""What names of archives end in."""

_DIALECTS = re.compile(r"(?:^|/)(?:dialects/v20|message_definitions/v1\.0)/[^/]+\.xml$")
_FOLDERS = ("", "pymavlink/dialects/v20", "dialects/v20", "v20", "message_definitions/v1.0")
_SITE_PACKAGES = re.compile(r"python3[.\d]*")


def installed_side(name: str) -> Side | Unreadable:
    """A dialect of the installed pymavlink."""
    path = shipped_dialect_path(name)
    if path is None:
        return Unreadable(f"the installed pymavlink has no dialect {name}", did_you_mean(name, shipped_dialect_names()))
    return dialect_side(path, f"{INSTALLED}:{name}", is_release=True)


def release_side(release: str, name: str, stack: ExitStack) -> Side | Unreadable:
    """A dialect of another pymavlink."""
    folder = release_folder(release, stack, name)
    if isinstance(folder, Unreadable):
        return folder
    dialects = dialects_in(folder)
    if name not in dialects:
        return Unreadable(f"{release} has no dialect {name}", did_you_mean(name, dialects))
    return dialect_side(dialects[name], f"{release}:{name}", is_release=True)


def release_folder(path: str, stack: ExitStack, name: str = "common") -> str | Unreadable:
    """The folder with the dialects of a pymavlink: of a wheel, a source archive, a folder that one is installed in.

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
        root = hang(os.path.basename(path), archive, stack)
        folders = sorted({os.path.dirname(inner) for inner in archive.paths()}, key=_is_second_choice)
        if folders:
            return os.path.join(root, folders[0])
    elif os.path.isdir(path):
        below = [os.path.join(root, "lib", name, "site-packages") for name in file_names(os.path.join(root, "lib"))]
        for start in (root, *(one for one in below if _SITE_PACKAGES.fullmatch(one.split(os.sep)[-2]))):
            for folder in _FOLDERS:
                candidate = os.path.join(start, folder).rstrip(os.sep)
                if any(is_file(os.path.join(candidate, f"{each}.xml")) for each in ("common", name)):
                    return candidate
    else:
        return Unreadable(
            f"{path} is neither a file nor a folder" if os.path.exists(path) else f"{path} does not exist"
        )
    return Unreadable(f"{path} holds neither a project nor the dialects of a pymavlink")


def _is_second_choice(folder: str) -> bool:
    return "v20" not in folder
