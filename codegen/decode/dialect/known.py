"""Other dialects that receivers know: which of their messages have a name or an id that the project adds, too."""

import os
import re
from collections.abc import Collection, Iterable, Iterator

from codegen.decode.decoded import decoded
from codegen.diagnostics import Report, Rule
from codegen.load.files import Files
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path
from codegen.load.xml_tree import parse_xml_bytes, place_of
from codegen.model.dialect.dialect import MAX_MESSAGE_ID, KnownMessage, MessageDefinition
from codegen.model.dialect.literals import bounded_number, is_identifier
from codegen.source import Place

KNOWN_MESSAGES = Rule(
    "known-messages",
    "A file under known in codegen.yaml is a dialect of which only the names and ids of the messages are looked at: "
    '<message id="371" name="FUEL_STATUS"/>.',
    remedy='list messages like <message id="371" name="FUEL_STATUS"/>',
)

_MESSAGE = re.compile(rb'<message\s+id="(\d{1,8})"\s+name="(\w+)"')


def decode_known_file(path: str, files: Files, report: Report, asked_at: Place) -> tuple[KnownMessage, ...]:
    """The messages of a file that the project names under ``known``; it needs to state no more than name and id."""
    data = files.read_bytes(path, report, asked_at)
    if data is None:
        return ()
    path = os.path.abspath(path)
    return decoded("known messages", data, path, lambda found: _known_messages(data, path, found), report) or ()


def _known_messages(data: bytes, path: str, report: Report) -> tuple[KnownMessage, ...]:
    root = parse_xml_bytes(data, path, report)
    if root is None:
        return ()
    messages = []
    groups = [child for child in root.children if child.tag == "messages"]
    for element in (child for group in groups for child in group.children if child.tag == "message"):
        place = place_of(element, path)
        number = bounded_number(element.attributes.get("id", ""), MAX_MESSAGE_ID)
        name = element.attributes.get("name", "")
        if number is None or not is_identifier(name):
            report.add(KNOWN_MESSAGES, place, "the message has no usable id and name")
        else:
            messages.append(KnownMessage(number, name, place))
    if not groups:
        report.add(KNOWN_MESSAGES, place_of(root, path), "the file lists no messages")
    return tuple(messages)


def taken_elsewhere(
    messages: Iterable[MessageDefinition],
    read: Collection[str],
    listed: Iterable[KnownMessage],
    files: Files,
    others: Collection[str] = (),
) -> tuple[KnownMessage, ...]:
    """Return which messages of shipped dialects, but for the files ``read`` (absolute paths), and of ``listed``, have
    the name or the id of one of ``messages``, or one of the names ``others``.
    """
    messages = tuple(messages)
    names = {message.name for message in messages} | set(others)
    ids = {message.id for message in messages}
    if not names:
        return ()
    shipped = (shipped_dialect_path(name, files) for name in shipped_dialect_names(files))
    paths = [path for path in shipped if path and path not in read]
    candidates = [*(message for path in paths for message in _scanned(path, files, names, ids)), *listed]
    return tuple(message for message in candidates if message.name in names or message.id in ids)


def _scanned(path: str, files: Files, names: set[str], ids: set[int]) -> Iterator[KnownMessage]:
    """The messages of a shipped file, without parsing it: it is looked through only where a name or an id occurs."""
    text = files.read_bytes(path, Report())
    wanted = [*(f'name="{name}"' for name in names), *(f'id="{number}"' for number in ids)]
    if text is None or not any(word.encode() in text for word in wanted):
        return
    for found in _MESSAGE.finditer(text):
        start = found.start()
        line, column = text.count(b"\n", 0, start) + 1, start - text.rfind(b"\n", 0, start)
        yield KnownMessage(int(found[1]), found[2].decode(), Place(path, line, column))
