"""The dialect of overlays and corrections as a project reads it, the codec generated from it, and the oracle."""

import importlib
import importlib.util
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType, SimpleNamespace

import yaml

from codegen.decode.dialect.files import decode_dialect_files, decode_overlay
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_path
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.spec import Correction
from codegen.resolve.dialect.dialect import resolve_dialect
from codegen.source import Place
from codegen.targets.codec import render_codec

ROOT = Path(__file__).parents[2]
SPECS = ROOT / "specs"
DIALECTS = SPECS / "dialects"
CODEC = (
    "checksum",
    "fields",
    "message_fields",
    "live_fields",
    "frames",
    "frames_plain",
    "frames_viper",
    "mavlink",
    "message",
    "messages",
    "receiver",
    "sender",
)


def corrections_for(*overlays: str) -> tuple[Correction, ...]:
    """The RFC's corrections as a project with these overlays has them."""
    path = DIALECTS / "corrections_rfc_0018.yaml"
    written = yaml.safe_load(path.read_text(encoding="utf-8"))["corrections"]
    return tuple(
        Correction(place=Place(str(path)), **entry)
        for entry in written
        if entry["overlay"] in {f"dialects/{name}" for name in overlays}
    )


def overlaid(*overlays: str, is_corrected: bool) -> tuple[Dialect, list[str]]:
    """common.xml with overlays of the shipped specification, and the rules that it breaks while it is read."""
    report = Report()
    path = shipped_dialect_path("common", DISK)
    assert path is not None
    files = decode_dialect_files(path, DISK, report)
    for name in overlays:
        files += decode_overlay(str(DIALECTS / name), DISK, report, known=files)
    corrections = corrections_for(*overlays) if is_corrected else ()
    return resolve_dialect("common", files, corrections, report), [found.rule.id for found in report]


def oracle(*overlays: str, is_corrected: bool) -> ModuleType:
    """pymavlink's dialect of the same XML, made by its own generator."""
    template = ROOT / "templates" / "tests" / "oracle.py"
    spec = importlib.util.spec_from_file_location("template_oracle", template)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    about = {
        "shipped": "common",
        "files": list(overlays),
        "corrections": [
            {name: value for name in ("message", "field", "enum", "entry") if (value := getattr(correction, name))}
            | {"set": {name: text for name, text in correction.set.items() if name in ("id", "type", "value")}}
            for correction in (corrections_for(*overlays) if is_corrected else ())
        ],
    }
    dialect: ModuleType = module.dialects(about, ["not in pymavlink"], DIALECTS)[0]
    return dialect


@contextmanager
def codec(dialect: Dialect, folder: Path) -> Iterator[SimpleNamespace]:
    """The modules of the codec for the messages that the overlays add, in this interpreter as long as they are used."""
    for name, text in render_codec(dialect, tuple(dialect.added_messages()), ()).items():
        (folder / name).write_text(text, encoding="utf-8")
    before = {name: sys.modules.pop(name, None) for name in CODEC}
    sys.path.insert(0, str(folder))
    try:
        yield SimpleNamespace(**{name: importlib.import_module(name) for name in ("mavlink", "messages")})
    finally:
        sys.path.remove(str(folder))
        for name, module in before.items():
            sys.modules.pop(name, None)
            if module is not None:
                sys.modules[name] = module
