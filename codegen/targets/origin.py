"""The header of generated files: what they come from, and a hash of it."""

import hashlib
import os
import re
from collections.abc import Iterable, Sequence
from functools import cache
from typing import TYPE_CHECKING

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireMessage

if TYPE_CHECKING:
    from codegen.model.system import System
from codegen.targets.naming import prose
from codegen.tool.template_files import copied, plain_files

_OPEN = "\0"
"""The mark in place of a digest: no name of a file has that character."""


@dataclass(frozen=True, slots=True)
class Origin:
    """The sources of a generated file, by name below the project, and the first 16 digits of their sha256."""

    sources: tuple[str, ...]
    digest: str

    @property
    def open(self) -> "Origin":
        """The same for a view: what it says does not change with every input. ``closed`` puts the digest in."""
        return Origin(self.sources, _OPEN)

    def closed(self, text: str) -> str:
        """A text that was rendered of a view with ``open``, in which the digest stands after the sources."""
        return text.replace(_OPEN, self.digest, 1)


def source_name(system: "System", path: str) -> str:
    """The name of a specification file as headers and documents print it: ``specs/state.yaml``."""
    return _name_below(os.path.dirname(system.spec.folder), path)


@cache
def _name_below(folder: str, path: str) -> str:
    return os.path.relpath(path, folder).replace(os.sep, "/")


def origin_of_text(name: str, text: str) -> Origin:
    """The origin of a file that is copied as it is."""
    return Origin((name,), hashlib.sha256(text.encode()).hexdigest()[:16])


def origin_of(system: "System", paths: Iterable[str], messages: Iterable[WireMessage] = ()) -> Origin:
    """The origin of a file that comes from specification files and from messages of the dialect.

    Of the dialect only what the messages are on the wire counts, with corrections applied: a new release of it
    that changes other messages changes no hash.
    """
    digest = hashlib.sha256()
    names = []
    for path in sorted(set(paths)):
        name = source_name(system, path)
        names.append(name)
        digest.update(f"{name} {system.spec.files[path]}\n".encode())
    described = [_wire_facts(message) for message in messages]
    digest.update("".join(described).encode())
    if described:
        names.append(f"dialect {prose(system.dialect.name)}")
    return Origin(tuple(names), digest.hexdigest()[:16])


def wire_digest(messages: Iterable[WireMessage]) -> str:
    """The first 16 digits of the sha256 of what messages are on the wire."""
    return hashlib.sha256("".join(_wire_facts(message) for message in messages).encode()).hexdigest()[:16]


def _wire_facts(message: WireMessage) -> str:
    facts = [f"{message.name} {message.id} {message.crc_extra} {message.base_length} {message.length}\n"]
    for field in message.fields:
        definition = field.definition
        multiplied = "" if field.multiplier == 1 else f" * {field.multiplier}"
        sentinel = field.sentinel.values if field.sentinel else None
        facts.append(
            f"{field.name} {field.type.name} {field.offset} {definition.length} {definition.units} "
            f"{definition.enum} {definition.minimum} {definition.maximum} {sentinel}"
            f"{multiplied}\n"
        )
    return "".join(facts)


def specification_file(system: "System", name: str) -> str:
    """The absolute path of a file of the specification."""
    return system.spec.path(name)


def headed(text: str, origin: Origin) -> str:
    """A Python file with the header that says what it comes from."""
    return f"# Generated from {_wrapped(origin.sources)}: do not edit.\n# Inputs: {origin.digest}\n{text}"


def _wrapped(sources: tuple[str, ...]) -> str:
    """The sources in lines of comment that stay readable."""
    lines = [""]
    for source in sources:
        if lines[-1] and len(lines[-1]) + len(source) > 85:
            lines[-1] += ","
            lines.append(source)
        else:
            lines[-1] += f", {source}" if lines[-1] else source
    return "\n#   ".join(lines)


_HEADED = re.compile(r"# Generated from (.+?): do not edit\.\n# Inputs: (\w+)\n(.*)", re.DOTALL)


def united(texts: Sequence[str]) -> str | None:
    """Return the one file in place of several that differ in nothing but their headers; None where they do."""
    if len(set(texts)) == 1:
        return texts[0]
    found = [_HEADED.fullmatch(text) for text in texts]
    headers = [each for each in found if each is not None]
    if len(headers) < len(texts) or len({each[3] for each in headers}) > 1:
        return None
    sources = dict.fromkeys(source for each in headers for source in _unwrapped(each[1]))
    digest = hashlib.sha256("".join(each[2] for each in headers).encode()).hexdigest()[:16]
    return headed(headers[0][3], Origin(tuple(sources), digest))


def _unwrapped(text: str) -> list[str]:
    return text.replace("\n#  ", "").split(", ")


def copied_files(folder: str) -> dict[str, str]:
    """Every plain file of a template folder with its header, by its path in the output."""
    files = {}
    for name in plain_files(folder):
        text = copied(f"{folder}/{name}")
        files[f"{folder}/{name}"] = headed(text, origin_of_text(f"templates/{folder}/{name}", text))
    return files
