"""One file, replaced whole: whoever reads it meanwhile has the old content or the new one, and never a part."""

import os
import stat
from contextlib import suppress

from codegen.diagnostics import Report, Rule
from codegen.emit.folder import UNFINISHED
from codegen.source import Place

FILE_UNWRITABLE = Rule(
    "file-unwritable",
    "The system refused to write a file: no permission, a full disk, a folder in its place. A file that was there "
    "before is still whole.",
    unreadable=True,
    remedy="free the path: permissions, space on the disk, or a folder that has its name",
)


def write_file(path: str, text: str, report: Report) -> bool:
    """Put ``text`` into a file as UTF-8; whether that was possible, or else a finding says why not."""
    path = os.path.abspath(path)
    try:
        replace_file(path, text.encode("utf-8", "surrogatepass"))
    except OSError as problem:
        report.add(FILE_UNWRITABLE, Place(path), f"it cannot be written: {problem.strerror or problem}")
        return False
    return True


def replace_file(target: str, content: bytes) -> None:
    """Put ``content`` at ``target`` in one step; what was there keeps its permissions. May raise OSError."""
    where = os.path.dirname(target)
    unfinished = os.path.join(where, os.urandom(8).hex().join(UNFINISHED))
    try:
        with open(_created(unfinished, where), "wb", buffering=0) as stream:
            written = 0
            while written < len(content):
                written += stream.write(memoryview(content)[written:])
        if os.path.exists(target):
            os.chmod(unfinished, stat.S_IMODE(os.stat(target).st_mode))
        os.replace(unfinished, target)
    except BaseException:
        with suppress(OSError):
            os.unlink(unfinished)
        raise


def _created(path: str, folder: str) -> int:
    """The descriptor of a new file, in a folder that is made if it is not there."""
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL
    try:
        return os.open(path, flags, 0o666)
    except FileNotFoundError:
        os.makedirs(folder, exist_ok=True)
        return os.open(path, flags, 0o666)
