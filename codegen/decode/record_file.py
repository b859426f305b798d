"""A YAML file into the one record that it states."""

from codegen.decode.decoded import decoded
from codegen.decode.record import Record, decode_record
from codegen.diagnostics import Report
from codegen.load.files import Files
from codegen.load.yaml_tree import parse_yaml
from codegen.source import Place


def decode_record_file(
    path: str, cls: type[Record], files: Files, report: Report, asked_at: Place | None = None
) -> Record | None:
    """The record of class ``cls`` that the file at an absolute path states; None after what is wrong was reported.

    ``asked_at`` is the place that names the file, for ``read_bytes``; ``decode_record`` says what is left out.
    """
    text = files.read_text(path, report, asked_at)
    return None if text is None else decode_record_text(text, path, cls, report)


def decode_record_text(text: str, path: str, cls: type[Record], report: Report) -> Record | None:
    """The same for a text that was read from that path."""

    def read(found: Report) -> Record | None:
        tree = parse_yaml(text, path, found)
        return None if tree is None else decode_record(tree, cls, found)

    return decoded(f"{cls.__module__}.{cls.__qualname__}", text, path, read, report)
