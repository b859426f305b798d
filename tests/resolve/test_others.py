"""``others: unknown`` in a table: what it answers for, what it cannot answer for, and who is told."""

from pathlib import Path

from edited_project import edited

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.explain.story import explain
from codegen.importing.comparison import Verdict, compare, comparison_text
from codegen.importing.document import find_fields
from codegen.importing.drift import drift
from codegen.importing.existing import table_of, table_of_project
from codegen.importing.of_system import sources_of
from codegen.importing.proposal import propose
from codegen.importing.stated import stated_fields
from codegen.model.system import PopulatedMessage, System
from codegen.targets.suite.expected import expected_fields

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "named_tables" / "specs"
BOW = "messages/bow.yaml"


def bow(system: System) -> PopulatedMessage:
    return next(message for message in system.messages if message.name == "bow")


def test_what_is_not_listed_is_the_sentinel(folder: Path) -> None:
    """Of the type and the field: UINT16_MAX, or 0 where the dialect says so."""
    system, findings = edited(folder)
    assert not findings
    known = {"gps.fix": 3, "gps.altitude": 7, "gps.satellites": 9, "gps.speed": 5}
    fields = expected_fields(bow(system), known, 0)
    assert [fields[name] for name in ("eph", "epv", "cog", "yaw", "vel", "alt")] == [65535, 65535, 65535, 0, 5, 7]


def test_each_field_without_a_sentinel_is_a_finding(folder: Path) -> None:
    """At the key, with the line of the dialect; none of them goes out as 0."""
    _, findings = edited(folder, (BOW, "  lat: {constant: 1}\n", ""), (BOW, "  alt: {state: gps.altitude}\n", ""))
    assert [(found.rule.id, found.place.line, found.message.split()[0]) for found in findings] == [
        ("no-sentinel", 6, "alt"),
        ("no-sentinel", 6, "lat"),
    ]
    assert all(found.related[0][0].file.endswith("common.xml") for found in findings)


def test_nothing_else_can_be_said_of_others(folder: Path) -> None:
    """A zero, say, is no value for unknown."""
    _, findings = edited(folder, (BOW, "others: unknown", "others: 0"))
    assert [found.rule.id for found in findings] == ["wrong-type"]
    _, findings = edited(folder, (BOW, "others: 0", "others: zero"))
    assert [found.rule.id for found in findings] == ["unknown-choice"]


def test_elements_that_are_not_listed_go_out_as_unknown(folder: Path) -> None:
    """In runs; a field that is listed wrongly is not answered so."""
    path = folder / "messages" / "cells.yaml"
    table = "message: BATTERY_STATUS\nas: cells\nrequirement: FR-1\nstream: POSITION\nothers: unknown\nfields:\n"
    rest = (
        "  id: {constant: 0}\n  type: {constant: 0}\n  battery_function: {constant: 0}\n"
        "  charge_state: {constant: 0}\n  mode: {constant: 0}\n"
        "  fault_bitmask: {constant: 0}\n"
    )
    path.write_text(f"{table}{rest}  voltages[2..3]: {{constant: 5}}\n  voltages[7]: {{constant: 6}}\n")
    system, findings = edited(folder)
    cells = next(message for message in system.messages if message.name == "cells")
    others = [answer.covers.label for answer in cells.answers if answer.covers.by_others]
    assert [name for name in others if name.startswith("voltages[")] == [
        "voltages[0..1]",
        "voltages[4..6]",
        "voltages[8..9]",
    ]
    assert expected_fields(cells, {}, 0)["voltages"] == [65535, 65535, 5, 5, 65535, 65535, 65535, 6, 65535, 65535]
    path.write_text(f"{table}{rest}  voltages[10]: {{constant: 5}}\n")
    _, findings = edited(folder)
    assert [found.rule.id for found in findings] == ["unknown-element"]


def test_explain_lists_what_nobody_answered(folder: Path) -> None:
    """Of the message as a whole, and of the field with the line of the key."""
    system, _ = edited(folder)
    story, field = explain("bow", system, Report()), explain("bow.yaw", system, Report())
    assert story is not None
    assert "unknown, as the table does not list them: eph, epv, cog, yaw\n" in story
    assert field is not None
    assert "unknown (others)" in field
    assert "bow.yaml:6:9" in field


def test_a_field_that_is_listed_now_is_told(folder: Path) -> None:
    """The bytes are the same; that somebody has thought of it is new."""
    system, _ = edited(folder)
    other, _ = edited(folder, (BOW, "fields:\n", "fields:\n  yaw: unknown\n"))
    changes = compare_systems((system,), (other,)).changes
    assert [(change.rule.id, change.subject, change.old) for change in changes] == [
        ("doc-changed", "bow.yaw", "answered by others")
    ]


DOCUMENT = """# FR-1 | Where it is

The fields of GPS_RAW_INT:

| field | value |
| --- | --- |
| eph | unknown |
| cog | {cog} |
| lat | 1 |
| lon | 1 |
| fix_type | gps.fix |
| alt | gps.altitude |
| vel | gps.speed |
| satellites_visible | gps.satellites |
| time_usec | 0 |
"""


def test_documents_are_compared_with_what_is_not_listed(folder: Path) -> None:
    """A document that says unknown agrees, one that says a number does not; what both leave out is no drift."""
    system, _ = edited(folder)
    table = table_of_project((folder / BOW).read_text(), bow(system))
    alone = table_of((folder / BOW).read_text(), str(folder / BOW), bow(system).wire, Report())
    assert alone is not None
    for cog, verdict in (("unknown", Verdict.SAME), ("65535", Verdict.SAME), ("12 cdeg", Verdict.DIFFERENT)):
        text = DOCUMENT.format(cog=cog)
        found = find_fields(text, "doc.md", None, system.dialect, Report())
        assert found is not None
        sources = sources_of(system.dialect, system)
        proposal = propose(found.lists, found.message, sources, Report())
        for existing in (table, alone):
            rows = {row.target.label: row for row in compare(proposal, existing.answers, sources)}
            assert (rows["eph"].verdict, rows["cog"].verdict) == (Verdict.SAME, verdict)
            assert rows["yaw"].verdict is Verdict.ONLY_TABLE
            assert "unknown (others)" in comparison_text([rows["yaw"]])
        drifted = drift(stated_fields(text, "doc.md"), (system,))
        about = {found.message.split()[0] for found in drifted if found.rule.id.startswith("document-")}
        assert ("GPS_RAW_INT.cog" in about) == (verdict is Verdict.DIFFERENT)
        assert not about & {"GPS_RAW_INT.yaw", "GPS_RAW_INT.epv"}
