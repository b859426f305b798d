"""Composes the tree of YAML text.

PyYAML's parser (the one in C where it is installed) supplies the events; the tree is built here, without recursion,
so that neither deep nesting nor aliases of aliases can exhaust anything.
"""

import dataclasses
import re
from collections.abc import Iterable
from dataclasses import field
from functools import lru_cache
from typing import Any

import yaml

from codegen.diagnostics import Diagnostic, Rule
from codegen.load.yaml_scalar import plain_value
from codegen.load.yaml_syntax import syntax_finding, unwanted_character
from codegen.load.yaml_tree import MappingNode, ScalarNode, SequenceNode, YamlNode
from codegen.source import Place

MAX_DEPTH = 64
"""Deepest nesting; the file formats need less than ten levels."""
MAX_FINDINGS = 100
"""Findings after which a file is given up: nobody reads more, and a hostile file could produce millions."""

YAML_EMPTY = Rule("yaml-empty", "The file holds nothing but comments. Write its content, or remove the file.")
YAML_DUPLICATE_KEY = Rule(
    "yaml-duplicate-key",
    "A key is written twice in one mapping, so that one of the two values would be lost. Remove or rename one of them.",
    remedy="rename one of the two, or remove it",
)
YAML_UNSUPPORTED = Rule(
    "yaml-unsupported",
    "Anchors, aliases, merge keys, tags, several documents in a file and keys that are not plain text are not used in "
    "specifications: a reviewer could not see at one place what a value is. Write the values out.",
)
YAML_TOO_DEEP = Rule(
    "yaml-too-deep",
    "The file is nested far deeper than any specification.",
    unreadable=True,
    remedy="name the file that is meant: no specification is nested so deep",
)
YAML_TOO_MANY_FINDINGS = Rule(
    "yaml-too-many-findings",
    "So much is wrong with the file that reading it was given up.",
    remedy="correct the findings above first; the rest is read then",
)


def composed(text: str, path: str) -> tuple[YamlNode | None, tuple[Diagnostic, ...]]:
    """Return the tree of a text, if there is one, and the findings."""
    return _parsed(text, path, getattr(yaml, "CSafeLoader", yaml.SafeLoader))


@lru_cache(maxsize=1)  # a project file is asked for its output, for its folders, and then for all that it states
def _parsed(text: str, path: str, loader: type[yaml.SafeLoader]) -> tuple[YamlNode | None, tuple[Diagnostic, ...]]:
    text = text.removeprefix("\ufeff")
    unwanted = unwanted_character(text, path)
    if unwanted is not None:
        return None, (unwanted,)
    composer = _Composer(path)
    composer.read(text, loader)
    is_syntax = composer.broken is not None and composer.broken.rule is not YAML_TOO_MANY_FINDINGS
    if is_syntax and len(text) < 1_000_000:
        # The parser in Python names the cause and the place better, but is too slow for the files that are right.
        second = _Composer(path)
        second.read(text, yaml.SafeLoader)
        composer = second if second.broken is not None or second.refused else composer
    if composer.broken is not None:
        return None, (*composer.findings, composer.broken)
    return None if composer.refused else composer.root, tuple(composer.findings)


_HALF_CHARACTER = re.compile("[\ud800-\udfff]")


@dataclasses.dataclass(slots=True)
class _Open:
    """A list or mapping whose end was not reached; the children of a mapping are keys and values in turn."""

    place: Place
    is_mapping: bool
    children: list[YamlNode] = field(default_factory=list)

    @property
    def awaits_value(self) -> bool:
        return self.is_mapping and len(self.children) % 2 == 1


class _Composer:
    """Builds the tree of one document from the parser's events.

    ``refused``: the tree lacks something that was written. ``broken``: the finding that ended the reading.
    """

    def __init__(self, path: str) -> None:
        self.findings: list[Diagnostic] = []
        self.root: YamlNode | None = None
        self.refused = False
        self.broken: Diagnostic | None = None
        self._path = path
        self._open: list[_Open] = []
        self._documents = 0
        self._reached = Place(path)

    def read(self, text: str, loader: type[yaml.SafeLoader]) -> None:
        """Read everything, up to the first thing that makes the rest meaningless."""
        stream: Any = loader(text)
        try:
            while self.broken is None and self._documents < 2 and stream.check_event():
                event = stream.get_event()
                self._reached = self._place(event.start_mark)
                self._take(event)
        # ValueError, OverflowError and RecursionError: what Python makes of odd escapes and directives.
        except (yaml.YAMLError, ValueError, OverflowError, RecursionError) as error:
            if isinstance(stream, yaml.SafeLoader):
                self._reached = self._place(stream.get_mark())
            self.broken = syntax_finding(error, self._path, self._reached)
        if self.root is None and self.broken is None:
            self._empty()

    def _take(self, event: yaml.Event) -> None:
        match event:
            case yaml.ScalarEvent():  # first, since most are
                self._check_properties(event)
                self._add(self._scalar(event))
            case yaml.DocumentStartEvent():
                self._start_document(event)
            case yaml.AliasEvent():
                self._refuse(event, f"*{event.anchor} is an alias", "write the value out")
                self._add(ScalarNode(None, "", self._place(event.start_mark)))
            case yaml.SequenceStartEvent() | yaml.MappingStartEvent():
                self._check_properties(event)
                self._open.append(_Open(self._place(event.start_mark), isinstance(event, yaml.MappingStartEvent)))
                if len(self._open) > MAX_DEPTH:
                    message = f"lists and mappings are nested more than {MAX_DEPTH} deep"
                    self.broken = Diagnostic(self._place(event.start_mark), YAML_TOO_DEEP, message)
            case yaml.SequenceEndEvent():
                closed = self._open.pop()
                self._add(SequenceNode(tuple(closed.children), closed.place))
            case yaml.MappingEndEvent():
                self._add(self._mapping(self._open.pop()))
        if len(self.findings) > MAX_FINDINGS:
            message = f"more than {MAX_FINDINGS} findings; the rest of the file was not read"
            self.broken = Diagnostic(self.findings[-1].place, YAML_TOO_MANY_FINDINGS, message)

    def _start_document(self, event: yaml.DocumentStartEvent) -> None:
        self._documents += 1
        if self._documents > 1:
            self._refuse(event, "a second document begins here", "put it in a file of its own")
        if event.version is not None and tuple(event.version) != (1, 2):
            version = ".".join(str(number) for number in event.version)
            self._refuse(event, f"%YAML {version} is asked for", "specifications are YAML 1.2; remove the directive")

    def _check_properties(self, event: yaml.ScalarEvent | yaml.CollectionStartEvent) -> None:
        if event.anchor is not None:
            self._refuse(event, f"&{event.anchor} is an anchor", "write the value out where it is needed")
        if event.tag is not None:
            self._refuse(event, f"{event.tag} is a tag", "remove it: the key decides what its value is")

    def _scalar(self, event: yaml.ScalarEvent) -> ScalarNode:
        text = event.value
        is_plain = bool(event.implicit[0])
        place = self._place(event.start_mark)
        if is_plain and not text and self._open and self._open[-1].awaits_value:
            # Nothing is written, so there is no place of it; parsers differ, the key is what one looks for.
            place = self._open[-1].children[-1].place
        if _HALF_CHARACTER.search(text):
            self._refuse(event, "the escapes make half a character", r"write \U and eight digits, or the character")
        return ScalarNode(plain_value(text) if is_plain else text, text, place)

    def _mapping(self, closed: _Open) -> MappingNode:
        entries: dict[str, tuple[ScalarNode, YamlNode]] = {}
        for key, value in _pairs(closed.children):
            if len(self.findings) > MAX_FINDINGS:
                break
            if not isinstance(key, ScalarNode):
                self._refuse(key, "a key is a list or a mapping", "keys are names")
            elif key.text == "<<":
                self._refuse(key, "<< merges another mapping", "write the keys out")
            elif key.text in entries:
                first = entries[key.text][0].place
                message = f"{key.text!r} is written twice; the first is in line {first.line}"
                related = ((first, "first written here"),)
                self.findings.append(Diagnostic(key.place, YAML_DUPLICATE_KEY, message, None, related))
            else:
                entries[key.text] = (key, value)
        return MappingNode(tuple(entries.values()), closed.place)

    def _add(self, node: YamlNode) -> None:
        if self._open:
            self._open[-1].children.append(node)
            return
        self.root = node
        if isinstance(node, ScalarNode) and node.value is None and not node.text and not self.refused:
            self._empty()

    def _empty(self) -> None:
        self.findings.append(
            Diagnostic(
                Place(self._path),
                YAML_EMPTY,
                "the file is empty",
                "codegen init FOLDER writes a project with an example of each",
            )
        )
        self.refused = True

    def _refuse(self, at: yaml.Event | YamlNode, message: str, hint: str) -> None:
        place = self._place(at.start_mark) if isinstance(at, yaml.Event) else at.place
        self.findings.append(Diagnostic(place, YAML_UNSUPPORTED, message, hint))
        self.refused = True

    def _place(self, mark: Any) -> Place:
        return Place(self._path, mark.line + 1, mark.column + 1) if mark is not None else self._reached


def _pairs(children: list[YamlNode]) -> Iterable[tuple[YamlNode, YamlNode]]:
    return zip(children[::2], children[1::2], strict=True)
