"""The kinds of evidence that a finding may stand on."""

from enum import Enum


class Evidence(Enum):
    """The kinds of evidence, the firm ones first."""

    DEFINITION = "definition"
    """XML of the document, or a sum of its own numbers: it is compared with nothing that was guessed."""
    COLUMN = "column"
    """A cell below a heading that says what it holds, in the row of a name."""
    ITEM = "item"
    """An item, a definition or a heading that begins with the name."""
    CODE = "code"
    """A declaration, a constant, an entry of a mapping, or the comment of its line."""
    BESIDE = "beside"
    """A name with its value: ``NAME (#N)``, ``NAME is N bytes``, ``MESSAGE.field: T``."""
    LIST = "list"
    """A list of the values of an enum of which most are right: so it is about that enum."""
    SENTENCE = "sentence"
    """A field and its value beside each other, and no other message in the passage than its own, before them."""
    PASSAGE = "passage"
    """The same, with the message in the headings, or nowhere else in the document."""
    WORDS = "words"
    """Anything else that was understood of the text."""


FIRM = frozenset(Evidence) - {Evidence.WORDS}
"""The kinds of evidence that make a finding certain."""
