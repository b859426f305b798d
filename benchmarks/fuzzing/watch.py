"""Records a command's use of files, as the interpreter reports it: every opening, writing, moving and starting."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
_CHANGING = {
    **dict.fromkeys(("os.mkdir", "os.remove", "os.rmdir", "os.truncate", "os.chmod", "os.chown", "os.utime"), (0,)),
    **dict.fromkeys(("os.rename", "os.link", "os.symlink"), (0, 1)),
}
"""Events that change something, and which of their arguments are paths."""
_STARTING = ("subprocess.Popen", "os.exec", "os.posix_spawn", "os.system", "os.fork", "socket.connect", "socket.bind")

_watches: list["Seen"] = []
_is_installed: list[bool] = []


class Seen:
    """The absolute paths of files that were read and of those that were written; what else was done."""

    def __init__(self) -> None:
        self.read: set[str] = set()
        self.written: set[str] = set()
        self.started: list[str] = []

    def take(self, event: str, arguments: tuple[object, ...]) -> None:
        """Take down one event."""
        if event == "open":
            path, mode, flags = arguments
            is_written = bool(flags & _WRITING) if isinstance(flags, int) else mode not in (None, "r", "rb")
            self._note(path, self.written if is_written else self.read)
        elif event in _CHANGING:
            for index in _CHANGING[event]:
                self._note(arguments[index], self.written)
        elif event in ("os.listdir", "os.scandir"):
            self._note(arguments[0], self.read)
        elif event in _STARTING:
            self.started.append(f"{event} {arguments}")

    @staticmethod
    def _note(path: object, paths: set[str]) -> None:
        if isinstance(path, str | bytes | os.PathLike):
            paths.add(os.path.abspath(os.fsdecode(path)))


@contextmanager
def watched() -> Iterator[Seen]:
    """Take down what happens meanwhile. The hook stays for as long as the process lives; it does nothing then."""
    if not _is_installed:
        _is_installed.append(True)
        sys.addaudithook(_hook)
    seen = Seen()
    _watches.append(seen)
    try:
        yield seen
    finally:
        _watches.remove(seen)


def _hook(event: str, arguments: tuple[object, ...]) -> None:
    for seen in _watches:
        seen.take(event, arguments)
