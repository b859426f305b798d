"""The codec: messages of any dialect for MicroPython, with or without a specification."""

from collections.abc import Sequence

from codegen.model.dialect.dialect import Dialect, EnumDefinition, WireMessage
from codegen.targets.codec.enums import enums_text
from codegen.targets.codec.layout import message_files
from codegen.targets.codec.page import page_text
from codegen.targets.codec.runtime import MACHINE_CODE, runtime_files
from codegen.targets.naming import prose
from codegen.targets.origin import Origin, headed, wire_digest


def render_codec(
    dialect: Dialect,
    messages: Sequence[WireMessage],
    enums: Sequence[EnumDefinition],
    *,
    machine_code: bool = True,
    package: str | None = None,
) -> dict[str, str]:
    """The files of a codec for ``messages`` (at least one) and ``enums`` of a dialect, loose or as a ``package``."""
    files = runtime_files("", messages, "signing", *([MACHINE_CODE] if machine_code else []))
    origin = Origin((f"dialect {prose(dialect.name)}",), wire_digest(messages))
    files |= message_files("", messages, dialect.version, origin)
    files["enums.py"] = headed(enums_text(enums), origin)
    files["README.md"] = page_text(dialect.name, messages, enums)
    if package is None:
        return files
    from codegen.targets.codec.package import packed  # noqa: PLC0415  most codecs are none

    return packed(files, package, messages)
