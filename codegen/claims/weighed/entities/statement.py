"""A statement that may stand at one place of a part: of a message, an entry or a field, compared with the dialect."""

from codegen.claims.parts.span import Span, is_data
from codegen.claims.weighed.pairs import is_line, whole_number
from codegen.diagnostics import Rule
from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Statement:
    """One thing that may be said at an offset of a part, in the piece between ``low`` and ``high``.

    ``message`` is the name of the message or the command, ``field`` that of its field if there is one, ``group`` what
    is compared in a list or a block of code together, and ``traits`` what speaks for the statement or against it.
    """

    kind: str
    rule: Rule
    span: Span
    at: int
    low: int
    high: int
    message: str
    field: str
    is_right: bool
    text: str = ""
    group: str = ""
    traits: tuple[str, ...] = ()

    @property
    def sentence(self) -> str:
        """The short text of the sentence, the row or the line."""
        return self.span.text[self.low : self.high]

    @property
    def name(self) -> int:
        """The offset of what it is about: nothing but the words around it name that."""
        return self.at

    @property
    def written(self) -> str:
        """The words of the term that is compared."""
        terms = self.span.sentence.terms
        return terms[self.at].written if self.at in terms else ""


def piece(span: Span, at: int) -> tuple[int, int]:
    """Return the bounds of the sentence, the row or the line around an offset; of data, those of its line."""
    if is_data(span) and not span.is_comment:
        line = span.place(at).line
        low, high = at, at
        while low > 0 and span.place(low - 1).line == line:
            low -= 1
        while high < len(span.text) and span.place(high).line == line:
            high += 1
        return low, high
    return (0, len(span.text)) if is_line(span) else span.bounds(at)


def whole(span: Span, at: int) -> int | None:
    """Return the whole number that stands at an offset; None for a part of a name or of another number."""
    value = whole_number(span.sentence.term(at))
    if value is None:
        return None
    text = span.text
    is_part = at > 1 and text[at - 1] in "-." and text[at - 2].isalnum()
    return None if is_part or text[at + 1 : at + 3].startswith(("-N", "/N", ".N")) else value


def is_alike(written: int, true: int) -> bool:
    """Return whether a number looks like another one: its digits in another order, one of them changed, or near it."""
    one, other = str(written), str(true)
    if len(one) == len(other) and len(one) > 1:
        changed = sum(a != b for a, b in zip(one, other, strict=True))
        return changed == 1 or sorted(one) == sorted(other)
    return abs(written - true) <= _NEAR < true


_NEAR = 3
