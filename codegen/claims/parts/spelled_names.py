"""Names of fields and messages in other spellings than the dialect's: those of languages, and two written as one."""

from collections.abc import Iterator

from codegen.claims.parts.sentence import NamedField, Term, Vocabulary
from codegen.claims.reading import snake
from codegen.pattern import pattern

_OTHER_END = pattern(r"/(?P<end>_?[A-Za-z0-9]{1,12})(?:\[\d{0,3}\])?(?![\w(])")


def in_snake(name: str) -> tuple[str, ...]:
    """Return the names that fields may have which code calls so: ``timeBootMs``, or as Go exports them, ``NumSats``."""
    if name.islower() or name.isupper() or "_" in name or not any(map(str.isupper, name[1:])):
        return ()
    return snake(name), name[:1].lower() + name[1:]


def camel(name: str, start: int, end: int, words: Vocabulary) -> Term | None:
    """``RcChannels``: a message as languages spell types."""
    if not name[:1].isupper() or "_" in name or name.isupper():
        return None
    spelled = pattern(r"(?<=[a-z0-9])(?=[A-Z])").sub("_", name).upper()
    return Term("M", spelled, name, start, end) if "_" in spelled and spelled in words.messages else None


def other_ends(term: Term, text: str, high: int, words: Vocabulary) -> Iterator[Term]:
    """Yield the fields that have the name before them with another end: ``flow_y`` behind ``flow_x``, in "flow_x/y"."""
    value, end = term.value, term.end
    if term.letter != "F" or not isinstance(value, NamedField):
        return
    known = {field.name for field in words.messages[value.message].fields} if value.message else words.fields
    while (found := _OTHER_END.match(text, end, high)) is not None:
        other = found["end"]
        name = value.name[: -len(other)] + other
        if len(value.name) <= len(other) or name == value.name or name not in known:
            return
        yield Term("F", NamedField(name, value.message), found[0][1:], found.start() + 1, found.end())
        end = found.end()
