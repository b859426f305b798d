"""Tells on a terminal what a command is doing, where that takes longer than a second."""

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

TYPE_CHECKING = False  # typing takes longer to import than --help may take
if TYPE_CHECKING:
    from typing import TextIO

    from rich.progress import Progress

_SOON_S = 1.0


@contextmanager
def working(text: str) -> Iterator[Callable[[str], None]]:
    """Show ``text`` and the seconds on stderr from the first second on, until the block ends; nothing of it stays.

    Gives a function that changes the text. Nothing else may be printed inside the block.
    """
    if not is_terminal(sys.stderr):
        yield lambda _text: None
        return
    line = _Line(text)
    try:
        yield line.change
    finally:
        line.end()


def is_terminal(stream: "TextIO | None") -> bool:
    """Return whether a stream is a terminal that can do more than print one line after the other."""
    return stream is not None and stream.isatty() and os.environ.get("TERM") not in ("dumb", "")


class _Line:
    """The line, which another thread begins once it is time: rich is imported only then."""

    def __init__(self, text: str) -> None:
        from threading import Timer

        self._text = text
        self._shown: Progress | None = None
        self._timer = Timer(_SOON_S, self._begin)
        self._timer.daemon = True
        self._timer.start()

    def change(self, text: str) -> None:
        self._text = text
        if self._shown is not None:
            for task in self._shown.tasks:
                self._shown.update(task.id, description=text, refresh=True)

    def end(self) -> None:
        self._timer.cancel()
        self._timer.join()
        if self._shown is not None:
            self._shown.stop()

    def _begin(self) -> None:
        from rich.console import Console
        from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

        columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), TimeElapsedColumn())
        console = Console(stderr=True, no_color=bool(os.environ.get("NO_COLOR")))
        shown = Progress(*columns, console=console, transient=True, redirect_stdout=False, redirect_stderr=False)
        shown.start()
        shown.add_task(self._text, total=None)
        self._shown = shown
        self.change(self._text)  # which may be another one meanwhile
