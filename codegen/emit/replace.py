"""Putting a file in the place of another in one step, so that nobody ever sees half of it."""

import os
import stat
from contextlib import suppress

from codegen.emit.folder import UNFINISHED


def replace_file(target: str, content: bytes) -> None:
    """Write ``content`` to ``target``, whole or not at all; the permissions of a file that was there are kept.

    Folders that are missing are made. OSError if the system refuses; then nothing has changed.
    """
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
        os.makedirs(folder or ".", exist_ok=True)
        return os.open(path, flags, 0o666)
