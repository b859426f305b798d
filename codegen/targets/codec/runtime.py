"""The part of the codec that is the same for every dialect: links, messages and frames."""

from collections.abc import Iterable

from codegen.model.dialect.dialect import WireMessage
from codegen.targets.origin import headed, origin_of_text
from codegen.tool.template_files import copied

MODULES = (
    *("checksum", "fields", "frames", "frames_plain", "live_fields", "mavlink", "message", "nearest", "receiver"),
    "sender",
)
"""Modules that a link needs; signing.py comes with those that sign, frames_viper.py where machine code is wanted."""

MACHINE_CODE = "frames_viper"

DOUBLES = "doubles"
"""The module that comes with messages that have fields of type double."""


def runtime_files(folder: str, messages: Iterable[WireMessage], *more: str) -> dict[str, str]:
    """The modules for ``messages``, and ``more`` of templates/codec, by path; ``folder`` is "" or ends in a slash."""
    files = {}
    doubles = [DOUBLES] if has_doubles(messages) else []
    for module in sorted((*MODULES, *more, *doubles)):
        text = copied(f"codec/{module}.py")
        if module == "frames" and MACHINE_CODE not in more:
            text = _without_machine_code(text)
        if module == "fields" and doubles:
            text = with_doubles(text)
        files[f"{folder}{module}.py"] = headed(text, origin_of_text(f"templates/codec/{module}.py", text))
    return files


def has_doubles(messages: Iterable[WireMessage]) -> bool:
    """Return whether any of the messages has a field of type double."""
    return any(field.type.code == "d" for message in messages for field in message.fields)


def _without_machine_code(text: str) -> str:
    """frames.py without its attempt to import machine code: a file that is left over must not be found."""
    before, _, rest = text.partition("try:\n")
    _, _, after = rest.partition("\n    from frames_plain")
    return f"{before}from frames_plain{after}"


def with_doubles(text: str) -> str:
    """A module with its numbers read and written by doubles.py, which is exact where a board's floats are not."""
    before, imported, after = text.partition("from struct import pack_into, unpack_from\n\n")
    assert imported
    others = after.splitlines(keepends=True)
    at = sum(line.startswith("from ") and line < "from doubles" for line in others)
    others.insert(at, "from doubles import pack_into, unpack_from\n")
    return before.rstrip("\n") + "\n\n" + "".join(others)
