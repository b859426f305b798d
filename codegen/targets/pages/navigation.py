"""The links that every page has to the others of its program."""

from dataclasses import dataclass

from codegen.model.system import System

PAGES = (("index.html", "Overview"), ("bandwidth.html", "Bandwidth"))
"""Pages about the whole program: the path below its ``docs/``, and what links call them."""


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
    """Where the page of a message lies below ``docs/``."""
    return f"messages/{name.lower()}.html"


def navigation(system: System, here: str) -> Navigation:
    """The links of the page at the path ``here`` below ``docs/``."""
    up = "../" * here.count("/")
    return Navigation(
        pages=tuple(Link(up + path, label, path == here) for path, label in PAGES),
        messages=tuple(
            Link(up + path, message.name, path == here)
            for message in system.messages
            for path in [message_path(message.name)]
        ),
    )
