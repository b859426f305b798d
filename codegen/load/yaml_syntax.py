"""Findings about text that is no YAML: the parser's terse problems in the words of someone who wrote a table."""

import re

import yaml

from codegen.diagnostics import Diagnostic, Rule
from codegen.frozen import dataclass
from codegen.source import Place

YAML_SYNTAX = Rule(
    "yaml-syntax",
    "The text is not YAML, so nothing of the file could be read. The place is where reading stopped; "
    "the mistake is there or shortly before.",
    unreadable=True,
    remedy="look here and in the lines above: quotes, brackets, colons without a blank, indentation",
)

# U+0085, U+2028 and U+2029 end a line for the parser, but neither in YAML 1.2 nor in editors: places would be wrong.
# A tab is white space to one parser and an error to the other.
_UNWANTED = "[^\n\r\x20-\x7e\xa0-\u2027\u202a-\ud7ff\ue000-\ufefe\uff00-\ufffd\U00010000-\U0010ffff]"
_LINE_END = re.compile(r"\r\n?|\n")


@dataclass(frozen=True, slots=True)
class _Wording:
    """The wording of one of the parser's problems; ``at_start``: the place is where the unfinished thing begins."""

    problem: str
    message: str
    hint: str | None = None
    at_start: bool = False


_WORDINGS = (
    _Wording(r"character '([@`%])'", "unquoted text cannot begin with {0}", "put the text in quotes"),
    _Wording(r"unexpected end of stream", "the quote that opens here is never closed", "close the quote", True),
    _Wording(r"unexpected document separator", "the quote that opens here is not closed before ---", None, True),
    _Wording(r"mapping values are not allowed", "a second ': ' in one entry", "put text that holds ': ' in quotes"),
    _Wording(r"could not find expected ':'", "this line is neither 'key: value' nor a list item", None, True),
    _Wording(r"sequence entries are not allowed", "a list item cannot begin here", "begin the list on a new line"),
    _Wording(r"mapping keys are not allowed", "a key cannot begin here"),
    _Wording(r"unknown escape character '(.*)'", "\\{0} is not an escape in double quotes", "use single quotes"),
    _Wording(r"escape sequence of (\d+) hex", "this escape wants {0} hexadecimal digits"),
    _Wording(r"expected ',' or '([\]}])'", "',' or {0} is missing here", "close the bracket"),
    _Wording(r"expected the node content, but found '<stream end>'", "the bracket is never closed"),
    _Wording(r"expected the node content, but found '(.*)'", "a value is missing before {0}"),
    _Wording(r"expected <block end>", "the line does not fit in with the lines above", "check its indentation"),
    _Wording(r"expected '<document start>'", "text follows after the end of the value", "check its indentation"),
)


def unwanted_character(text: str, path: str) -> Diagnostic | None:
    """The finding about the first character that no specification holds: tabs, control characters, lone surrogates."""
    if text.replace("\n", "").replace("\r", "").isprintable():
        return None  # at once: the characters that are wanted take long to tell from the others
    unwanted = re.search(_UNWANTED, text)
    if unwanted is None:
        return None
    before = _LINE_END.split(text[: unwanted.start()])
    place = Place(path, len(before), len(before[-1]) + 1)
    if unwanted[0] == "\t":
        hint = r"use spaces; in double quotes a tab is written \t"
        return Diagnostic(place, YAML_SYNTAX, "tabs are not allowed in specifications", hint)
    message = f"the character U+{ord(unwanted[0]):04X} is not allowed in YAML here"
    return Diagnostic(place, YAML_SYNTAX, message, "remove it, or write it as an escape in double quotes")


def syntax_finding(error: Exception, path: str, reached: Place) -> Diagnostic:
    """The finding about an exception of the parser; ``reached`` is the place of the last thing it understood."""
    if not isinstance(error, yaml.MarkedYAMLError):
        # For instance an escape beyond the last character of Unicode: Python refuses it, not the parser.
        return Diagnostic(reached, YAML_SYNTAX, "this cannot be read as YAML")
    at = _place(error.problem_mark, path)
    start = _place(error.context_mark, path)
    problem = error.problem or error.context or "this is not YAML"
    for wording in _WORDINGS:
        if found := re.search(wording.problem, problem):
            message = wording.message.format(*found.groups())
            if wording.at_start and start is not None:
                return Diagnostic(start, YAML_SYNTAX, message, wording.hint)
            return _finding(at, start, reached, message, wording.hint)
    return _finding(at, start, reached, problem, None)


def _finding(at: Place | None, start: Place | None, reached: Place, message: str, hint: str | None) -> Diagnostic:
    place = at or start or reached
    related = ((start, "what it belongs to begins here"),) if start is not None and start != place else ()
    return Diagnostic(place, YAML_SYNTAX, message, hint, related)


def _place(mark: yaml.Mark | None, path: str) -> Place | None:
    return None if mark is None else Place(path, mark.line + 1, mark.column + 1)
