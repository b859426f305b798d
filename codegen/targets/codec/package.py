"""The codec as a package: its modules import one another there, and have stubs for type checkers."""

import keyword
import re
from collections.abc import Iterable, Iterator, Mapping

from codegen.model.dialect.dialect import Kind, WireField, WireMessage
from codegen.targets.naming import class_names
from codegen.tool.template_files import copied

STUBS = ("mavlink", "message", "receiver", "sender", "signing")
"""Modules that have a stub which is the same for each dialect."""

OWN = frozenset(
    {"NAME", "ID", "CRC_EXTRA", "BASE_LENGTH", "LENGTH", "FIELDS", "TARGETS", "DEFAULTS", "wire", "live"}
    | {"source_sequence", "source_system", "source_component", "names", "get", "raw", "set", "update"}
)
"""Attributes of each message: a field with one of these names has ``_`` behind it."""
_EMPTY = '"""MAVLink for MicroPython, made by codegen codec."""\n'


def packed(files: Mapping[str, str], package: str, messages: Iterable[WireMessage]) -> dict[str, str]:
    """The files of a codec as the package of that name (``mymav``, or ``mymav.inner``), below its folder.

    The page shows how it is imported from there.
    """
    folder = package.replace(".", "/")
    modules = "|".join(sorted(path.removesuffix(".py") for path in files if path.endswith(".py")))
    inside = re.compile(rf"(?m)^( *)(?:from ({modules}) import|import ({modules})\b)")
    shown = re.compile(rf"(?:from ({modules}) import|(?m:^)import ({modules})\b)")
    result = {}
    for path, text in files.items():
        is_module = path.endswith(".py")
        here = inside.sub(_relative, text) if is_module else shown.sub(lambda found: _absolute(found, package), text)
        result[f"{folder}/{path}"] = here
    names = package.split(".")
    for depth in range(1, len(names) + 1):
        result[f"{'/'.join(names[:depth])}/__init__.py"] = _EMPTY
    result |= {f"{folder}/{name}.pyi": copied(f"codec/stubs/{name}.pyi") for name in STUBS}
    result[f"{folder}/messages.pyi"] = _messages_stub(messages)
    result[f"{folder}/py.typed"] = ""
    return dict(sorted(result.items()))


def _relative(found: "re.Match[str]") -> str:
    return f"{found[1]}from .{found[2]} import" if found[2] else f"{found[1]}from . import {found[3]}"


def _absolute(found: "re.Match[str]", package: str) -> str:
    return f"from {package}.{found[1]} import" if found[1] else f"from {package} import {found[2]}"


def _messages_stub(messages: Iterable[WireMessage]) -> str:
    messages = tuple(messages)
    classes = class_names(message.name for message in messages)
    lines = ["from collections.abc import Sequence", "from typing import Self", "", "from .message import Message", ""]
    for message in messages:
        lines += _class_stub(message, classes[message.name])
    return "\n".join([*lines, "ALL: tuple[type[Message], ...]"]) + "\n"


def _class_stub(message: WireMessage, name: str) -> Iterator[str]:
    yield f"class {name}(Message):"
    keywords = []
    for field in message.fields:
        held = _held(field)
        attribute = field.name + "_" * (field.name in OWN or keyword.iskeyword(field.name))
        yield f"    {attribute}: {held}"
        argument = field.name + "_" * (field.name == "self" or keyword.iskeyword(field.name))
        keywords.append(f"        {argument}: {held} = ...,")
    yield "    def update(  # type: ignore[override]"
    yield "        self,"
    yield "        *,"
    yield from keywords
    yield "    ) -> Self: ..."
    yield ""


def _held(field: WireField) -> str:
    """Return what a field takes, and is read as: None is unknown."""
    if field.type.kind is Kind.CHAR:
        return "str | bytes | None"
    number = "float" if field.type.kind is Kind.FLOAT else "int"
    return f"Sequence[{number} | None] | None" if field.is_array else f"{number} | None"
