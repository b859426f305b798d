"""A YAML file into the one record that it states."""

from codegen.decode.record import Record, decode_record
from codegen.diagnostics import Report
from codegen.load.text import read_text
from codegen.load.yaml_tree import parse_yaml
from codegen.source import Place


def decode_record_file(path: str, cls: type[Record], report: Report, asked_at: Place | None = None) -> Record | None:
    """The record of class ``cls`` that the file at an absolute path states; None after what is wrong was reported.

    ``asked_at`` is the place that names the file, for ``read_bytes``; ``decode_record`` says what is left out.
    """
    text = read_text(path, report, asked_at)
    tree = None if text is None else parse_yaml(text, path, report)
    return None if tree is None else decode_record(tree, cls, report)
