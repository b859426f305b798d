"""YAML as located trees, read by the rules of YAML 1.2."""

import os

from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.load.yaml_scalar import ScalarValue
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class ScalarNode:
    """One scalar; ``text`` is what is written, without quotes, ``value`` what it means (see ``ScalarValue``)."""

    value: ScalarValue
    text: str
    place: Place


@dataclass(frozen=True, slots=True)
class SequenceNode:
    """A list; the place is that of its first item, or of its bracket."""

    items: tuple["YamlNode", ...]
    place: Place


@dataclass(frozen=True, slots=True)
class MappingNode:
    """A mapping in the order of the file, every key once; the place is that of its first key, or of its bracket."""

    entries: tuple[tuple[ScalarNode, "YamlNode"], ...]
    place: Place


YamlNode = ScalarNode | MappingNode | SequenceNode


def parse_yaml(text: str, path: str, report: Report) -> YamlNode | None:
    """The tree of YAML text. Places count characters from 1 and name the absolute form of ``path``.

    Of a key that is written twice the first value stays in the tree. Returns None, after a diagnostic, where the
    text is no YAML, is empty, or uses a construct that would change what the tree means.
    """
    from codegen.load.yaml_composer import composed  # noqa: PLC0415  most runs know what the files say

    root, findings = composed(text, os.path.abspath(path))
    report.extend(findings)
    return root
