"""The links that every page has to the others of its program."""

from codegen.frozen import dataclass
from codegen.model.connections import connections
from codegen.model.system import System

PAGES = (("index.html", "Overview"), ("bandwidth.html", "Bandwidth"))
"""Pages about the whole program: the path below its ``docs/``, and what links call them."""

PROGRAM_PAGE = "program.html"
"""The page on what comes in, of projects in which something does."""

WIRING_PAGE = "wiring.html"
"""The page on what is connected to which pin, of programs whose board is known."""

WIRING_DRAWING = "wiring.svg"
"""The drawing of it, for documents."""

TRACE_PAGE = "trace.html"
"""The page about the requirements of a project, which its further programs share."""


@dataclass(frozen=True, slots=True)
class Link:
    """A link as pages print it; ``is_here`` marks the page that it stands on."""

    href: str
    label: str
    is_here: bool = False


@dataclass(frozen=True, slots=True)
class Navigation:
    """The links to pages about the whole, and to the page of each message."""

    pages: tuple[Link, ...]
    messages: tuple[Link, ...]


def message_path(name: str) -> str:
    """Return where the page of a message lies below ``docs/``."""
    return f"messages/{name.lower()}.html"


def takes_anything(system: System) -> bool:
    """Return whether anything comes in: messages, commands, or what sensors give."""
    return bool(system.program or system.receptions or system.polled)


def is_wired(system: System) -> bool:
    """Return whether anything is connected to pins that the board is known to have."""
    return system.board is not None and next(connections(system), None) is not None


def shared_docs(system: System) -> str:
    """The way from ``docs/`` of a program to that of its project, where it is another one."""
    return "../../docs/" if system.spec.program else ""


def navigation(system: System, here: str) -> Navigation:
    """The links of the page at the path ``here`` below ``docs/``."""
    up = "../" * here.count("/")
    shared = up + shared_docs(system)
    return Navigation(
        pages=(
            *(Link(up + path, label, path == here) for path, label in PAGES),
            *([Link(up + PROGRAM_PAGE, "Program", here == PROGRAM_PAGE)] if takes_anything(system) else []),
            *([Link(up + WIRING_PAGE, "Wiring", here == WIRING_PAGE)] if is_wired(system) else []),
            Link(shared + TRACE_PAGE, "Requirements", here == TRACE_PAGE),
        ),
        messages=tuple(
            Link(up + path, message.name, path == here)
            for message in system.messages
            for path in [message_path(message.name)]
        ),
    )
