"""The way of the data for a codec: read a dialect, choose messages, render; no specification is needed."""

import json
import os
from collections.abc import Collection, Iterable, Sequence

from codegen.decode.decoded import decoded_with_includes
from codegen.decode.dialect.files import decode_dialect_files
from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.load.files import DISK, Files
from codegen.load.shipped import dialect_path, files_beside
from codegen.model.dialect.dialect import Dialect, EnumDefinition, WireMessage
from codegen.resolve.dialect.dialect import resolve_dialect
from codegen.source import Place
from codegen.targets.codec import render_codec
from codegen.targets.codec.enums import enums_of

ALL = "all"

CODEC_DIALECT = Rule(
    "codec-dialect",
    "A codec is made of a dialect that pymavlink ships (common, ardupilotmega, ...) or of an XML file, whose path ends "
    "in .xml.",
    unreadable=True,
    remedy="name a dialect of pymavlink, such as common, or a path that ends in .xml",
)
CODEC_MESSAGE = Rule(
    "codec-message",
    "A codec is asked for a message that the dialect does not have. Names are those of the dialect, in any case.",
    remedy="write the name of the message as the XML of the dialect has it",
)
CODEC_ENUM = Rule(
    "codec-enum",
    "A codec is asked for an enum that the dialect does not have. Names are those of the dialect, in any case.",
    remedy="write the name of the enum as the XML of the dialect has it",
)
CODEC_EMPTY = Rule(
    "codec-empty",
    "A codec without a message would have nothing to do: the dialect states none.",
    remedy="name a dialect that has messages, or includes some",
)


def read_codec_dialect(written: str, report: Report) -> Dialect | None:
    """The dialect called ``written``, or of the file of that path with its includes; None after a diagnostic."""
    place = Place(os.path.abspath(written))
    is_file = written.lower().endswith(".xml")
    path = dialect_path(written, os.getcwd(), CODEC_DIALECT, place, DISK, report, is_file=is_file)
    if path is None:
        return None
    name = os.path.splitext(os.path.basename(path))[0]

    def read(noting: Files, found: Report) -> Dialect | None:
        files = decode_dialect_files(path, noting, found)
        return resolve_dialect(name, files, (), found) if files else None

    dialect, _ = decoded_with_includes("codec", path, read, files_beside(path, DISK), report)
    return dialect


def chosen_messages(names: Sequence[str], dialect: Dialect, report: Report) -> tuple[WireMessage, ...]:
    """The messages called ``names`` (or all), in order of id, each once; names that do not exist are reported."""
    if not dialect.messages:
        report.add(CODEC_EMPTY, Place(dialect.files[-1]), f"the dialect {dialect.name} has no messages")
    named = [name for name in names if name.lower() != ALL]
    wanted = _known(named, "message", dialect.messages, CODEC_MESSAGE, dialect, report)
    if len(named) < len(names):
        wanted = set(dialect.messages)
    return tuple(message for name, message in dialect.messages.items() if name in wanted)


def chosen_enums(
    names: Sequence[str] | None, messages: Sequence[WireMessage], dialect: Dialect, report: Report
) -> tuple[EnumDefinition, ...]:
    """The enums called ``names``, without any those that the messages refer to, and for all messages every one."""
    if names is not None:
        wanted = _known(names, "enum", dialect.enums, CODEC_ENUM, dialect, report)
        return tuple(dialect.enums[name] for name in sorted(wanted))
    if len(messages) == len(dialect.messages):
        return tuple(dialect.enums[name] for name in sorted(dialect.enums))
    return enums_of(messages, dialect)


def _known(
    names: Sequence[str], kind: str, known: Collection[str], rule: Rule, dialect: Dialect, report: Report
) -> set[str]:
    """The names in the dialect's case; those that it does not have are reported."""
    wanted = set()
    spelt = {name.upper(): name for name in known}
    for name in names:
        if name in known or name.upper() in spelt:
            wanted.add(name if name in known else spelt[name.upper()])
        else:
            hint = did_you_mean(name.upper(), known)
            report.add(rule, Place(dialect.files[-1]), f"the dialect {dialect.name} has no {kind} {name}", hint)
    return wanted


def codec_files(
    written: str,
    names: Sequence[str],
    report: Report,
    *,
    enums: Sequence[str] | None = None,
    machine_code: bool = True,
) -> dict[str, str]:
    """``{path below the output folder: text}`` of a codec; empty if anything was reported as an error.

    ``names`` are those of messages, ``enums`` those of enums (None: the ones that the messages refer to).
    """
    dialect = read_codec_dialect(written, report)
    return {} if dialect is None else codec_of(dialect, names, report, enums=enums, machine_code=machine_code)


def codec_of(
    dialect: Dialect,
    names: Sequence[str],
    report: Report,
    *,
    enums: Sequence[str] | None = None,
    machine_code: bool = True,
    package: str | None = None,
) -> dict[str, str]:
    """Return the files of a codec, like :func:`codec_files`, for a dialect that was read."""
    messages = chosen_messages(names, dialect, report)
    chosen = chosen_enums(enums, messages, dialect, report)
    if report.has_errors:
        return {}
    return render_codec(dialect, messages, chosen, machine_code=machine_code, package=package)


def mip_list(paths: Iterable[str]) -> str:
    """``package.json``: what ``mip.install`` and ``mpremote mip install`` copy, from where this file lies."""
    copied_files = [path for path in sorted(paths) if os.path.splitext(path)[1] in (".py", ".mpy")]
    return json.dumps({"urls": [[path, path] for path in copied_files], "version": "1"}, indent=2) + "\n"
