"""A file of another tool as it was read: objects with texts and headings, and the links between them."""

from collections.abc import Mapping

from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.source import Place

UNREADABLE_TEXT = Rule(
    "import-text",
    "The text of a requirement has something in it that a criterion in Markdown cannot have without being guessed at: "
    "a list, a table, a picture, a directive. Put it into words where it was written, or make each item a requirement "
    "of its own. The document that it belongs to is left out.",
    remedy="put it into plain sentences where it was written, or make each item a requirement",
)


@dataclass(frozen=True, slots=True)
class Formatted:
    """A text as Markdown, and as a reader sees it: on one line, without marks."""

    markdown: str
    plain: str


@dataclass(frozen=True, slots=True)
class Stated:
    """One object: ``key`` is what the file itself calls it, ``name`` what people do, empty where nothing says it.

    An object with a ``text`` is a requirement, one without, but with a ``title``, a heading. ``is_broken`` tells that
    its text could not be read. ``parent`` is the key of the object that it stands below, ``depends_on`` has keys.
    ``facts`` are of those that the export of the trace has: status, aliases, refers_to, bench.
    """

    key: str
    name: str
    title: str
    text: Formatted | None
    is_broken: bool
    parent: str | None
    depends_on: tuple[str, ...]
    facts: Mapping[str, str]
    place: Place


@dataclass(frozen=True, slots=True)
class StatedFile:
    """The objects of a file in its order; ``left_out`` counts what is no requirement, by what it is called."""

    objects: tuple[Stated, ...]
    left_out: Mapping[str, int]
