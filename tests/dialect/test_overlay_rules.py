"""The rules about overlays find drafts' faults, and nothing in the dialects that pymavlink ships."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

from codegen.decode.dialect.files import decode_dialect_files
from codegen.decode.dialect.known import taken_elsewhere
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path
from codegen.model.dialect.dialect import Dialect, KnownMessage
from codegen.model.system import System
from codegen.rules import overlay_entry, overlay_flag, overlay_id, overlay_text
from codegen.source import Place

Read = Callable[..., SimpleNamespace]
BASE = "<mavlink><messages/></mavlink>"


def system(dialect: Dialect) -> System:
    """All of a system that the rules look at."""
    return SimpleNamespace(dialect=dialect)  # type: ignore[return-value]


def contradicted(text: str, read_overlay: Read, kind: str = "float", invalid: str = "NaN") -> str | None:
    """Return the rule's quotation from the text, for a field of an overlay."""
    field = f'<field type="{kind}" name="f" invalid="{invalid}">{text}</field>'
    overlay = f'<mavlink><messages><message id="9" name="M">{field}</message></messages></mavlink>'
    dialect = read_overlay(BASE, overlay).dialect
    found = [one.message for one in overlay_text.check(system(dialect))]
    return found[0].split("the text says ")[1].split(",")[0] if found else None


@pytest.mark.parametrize(
    ("text", "kind", "invalid", "quoted"),
    [
        ("Charge. UINT32_MAX: not provided", "float", "NaN", "UINT32_MAX"),
        ("Charge, -1 if it is unknown.", "int8_t", "INT8_MAX", "-1"),
        ("Charge. NaN means not known", "float", "0", "NaN"),
        ("Cells. 0: no value", "uint16_t[3]", "[UINT16_MAX]", "0"),
        # the same value, written differently, or among others
        ("Charge. 255: unknown", "uint8_t", "UINT8_MAX", None),
        ("Charge (NAN if unknown)", "float", "nan", None),
        ("0 = unknown, 1 = invalid signal", "uint8_t", "0", None),
        # numbers that are about something else
        ("From 0 to 100. UINT16_MAX: 64 KB/s or more", "uint16_t", "0", None),
        ("Number 3. Unknown to many", "uint8_t", "0", None),
        ("Nothing about it", "uint8_t", "0", None),
        ("-1: unknown", "int8_t", "", None),
    ],
)
def test_texts(text: str, kind: str, invalid: str, quoted: str | None, read_overlay: Read) -> None:
    """A text contradicts the attribute if it names values for unknown, and not that one."""
    assert contradicted(text, read_overlay, kind, invalid) == quoted


def test_texts_of_shipped_dialects(shipped: Callable[[str], tuple[Dialect, Report]]) -> None:
    """Of 3000 sentinels none is taken for a contradiction, however its text is worded."""
    looked_at = 0
    for name in shipped_dialect_names(DISK):
        for message in shipped(name)[0].messages.values():
            for field in message.fields:
                looked_at += field.sentinel is not None
                assert overlay_text.contradicting_text(field) is None, f"{message.name}.{field.name}"
    assert looked_at > 3000


FLAGS = """<mavlink><enums><enum name="E" bitmask="{bitmask}">
<entry value="0" name="E_NONE"/><entry value="1" name="E_A"/><entry value="2" name="E_B"/><entry value="6" name="E_C"/>
</enum></enums></mavlink>"""


def test_flags(read: Read, read_overlay: Read) -> None:
    """More than one bit in a bitmask that an overlay adds; 0, other enums and the dialect's own are left alone."""
    found = list(overlay_flag.check(system(read_overlay(BASE, FLAGS.format(bitmask="true")).dialect)))
    assert [(one.place.line, "E_C is 0x6: 2 bits" in one.message) for one in found] == [(2, True)]
    assert "E_B" in found[0].related[0][1]
    assert not list(overlay_flag.check(system(read_overlay(BASE, FLAGS.format(bitmask="false")).dialect)))
    assert not list(overlay_flag.check(system(read(BASE, FLAGS.format(bitmask="true")).dialect)))


def test_ids_and_names_of_other_dialects(read_overlay: Read) -> None:
    """The same id or the same name alone is a warning, both together are the same message."""
    field = '<field type="uint8_t" name="f"/>'
    messages = "".join(
        f'<message id="{number}" name="{name}">{field}</message>'
        for number, name in (
            (42000, "MINE"),
            (54007, "ICAROUS_KINEMATIC_BANDS"),
            (10001, "UAVIONIX_ADSB_OUT_CFG"),
            (54008, "OK"),
        )
    )
    result = read_overlay(BASE, f"<mavlink><messages>{messages}</messages></mavlink>")
    here = Place("/known.xml", 3)
    added = [message.definition for message in result.dialect.added_messages()]
    listed = [KnownMessage(54008, "OTHER", here), KnownMessage(9, "NOBODY", here)]
    known = taken_elsewhere(added, result.dialect.files, listed, DISK)
    assert {(one.id, one.name) for one in known} == {
        (42000, "ICAROUS_HEARTBEAT"),
        (42001, "ICAROUS_KINEMATIC_BANDS"),
        (10001, "UAVIONIX_ADSB_OUT_CFG"),
        (54008, "OTHER"),
    }
    icarous = next(one for one in known if one.id == 42000)
    lines = Path(icarous.place.file).read_text(encoding="utf-8").split("\n")
    assert lines[icarous.place.line - 1][icarous.place.column - 1 :].startswith('<message id="42000"')
    dialect = replace(result.dialect, known=known)
    assert [one.message for one in overlay_id.check(system(dialect))] == [
        "MINE has the id 42000 of ICAROUS_HEARTBEAT",
        "ICAROUS_KINEMATIC_BANDS has the id 42001 elsewhere",
        "OK has the id 54008 of OTHER",
    ]


def test_a_file_of_the_dialect_is_no_other_dialect() -> None:
    """The dialect in use is compared with itself by other rules; without a message there is nothing to look for."""
    path = shipped_dialect_path("icarous", DISK)
    assert path is not None
    files = decode_dialect_files(path, DISK, Report())
    assert taken_elsewhere(files[-1].messages, [file.path for file in files], (), DISK) == ()
    assert taken_elsewhere((), (), [KnownMessage(1, "A", Place("/x"))], DISK) == ()


@pytest.mark.parametrize(
    ("value", "kind", "enum", "hints"),
    [
        ("300", "uint8_t", "E", ["take a number up to 255"]),
        ("255", "uint8_t", "E", []),
        ("300", "uint16_t", "E", []),
        ("300", "float", "E", []),
        ("300", "uint8_t", "OTHER", []),
    ],
)
def test_an_entry_that_no_field_carries(value: str, kind: str, enum: str, hints: list[str], read_overlay: Read) -> None:
    """It is found where an overlay adds it: entry-beyond-fields."""
    base = f"""<mavlink><enums><enum name="E"><entry name="E_A" value="1"/></enum>
    <enum name="OTHER"><entry name="O_A" value="1"/></enum></enums>
    <messages><message id="9" name="M"><field type="{kind}" name="f" enum="{enum}"/></message></messages></mavlink>"""
    overlay = f'<mavlink><enums><enum name="E"><entry name="E_B" value="{value}"/></enum></enums></mavlink>'
    dialect = read_overlay(base, overlay).dialect
    found = list(overlay_entry.check(system(dialect)))
    assert [one.hint for one in found] == hints
    assert {one.rule.id for one in found} <= {"entry-beyond-fields"}
