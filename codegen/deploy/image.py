"""The program as an image of a ROMFS, from which a MicroPython that has one runs it in place."""

from collections.abc import Mapping
from typing import Any

from codegen.deploy.plan import MAIN


def image_of(files: Mapping[str, str | bytes]) -> bytes:
    """Return the image with all files, by their paths on the board, but main.py, which a board starts from its flash.

    Raises ImportError without mpremote.
    """
    from mpremote.romfs import VfsRomWriter  # noqa: PLC0415  an optional dependency, which only this needs

    writer = VfsRomWriter()
    opened: list[str] = []
    for path, content in sorted(files.items()):  # those of a folder lie together then
        if path == MAIN:
            continue
        *folders, name = path.split("/")
        _enter(writer, opened, folders)
        writer.mkfile(name, content.encode() if isinstance(content, str) else content)
    _enter(writer, opened, [])
    return bytes(writer.finalise())


def _enter(writer: Any, opened: list[str], folders: list[str]) -> None:
    """Close the folders that a file is not in, and open those that it is in."""
    while opened != folders[: len(opened)]:
        writer.closedir()
        opened.pop()
    for folder in folders[len(opened) :]:
        writer.opendir(folder)
        opened.append(folder)
