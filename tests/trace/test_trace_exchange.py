"""ReqIF and needs.json: what is in them, that other people's readers take them, and that they go round."""

import json
import re
import shutil

import lxml.etree
import pytest
from reqif import PATH_TO_REQIF_ROOT
from reqif.parser import ReqIFParser
from trace_project import Project
from ub_needs_exchange import load

from codegen.cli import main
from codegen.trace.exchange import Exchange, ExchangeObject, ObjectKind, Relation, RelationKind
from codegen.trace.needs import needs_json
from codegen.trace.reqif import identifier, reqif_xml

REQIF = "{http://www.omg.org/spec/ReqIF/20110401/reqif.xsd}"


@pytest.fixture
def told(project: Project) -> Project:
    """Criteria of which one depends on another, reviewed, and then one is changed; its text has all that XML minds."""
    project.change("nobody reads.", "nobody reads (depends on criterion 1).")
    project.change("# FR-1 | A heartbeat", "# FR-1 | A heart & beat <1>")
    assert project.run("accept", "--all", "--reason", "first") == 0
    project.change("It beats once a second.", 'It beats > 1/s & "is" `<b>` with_under_scores *é*.')
    return project


def exported(project: Project, form: str, capsys: pytest.CaptureFixture[str], *options: str) -> str:
    capsys.readouterr()
    project.run("--format", form, *options)
    return capsys.readouterr().out


def test_reqif_is_valid(told: Project, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """By the schema that the package reqif ships, which can say no, too, and by its parser."""
    text = exported(told, "reqif", capsys)
    monkeypatch.chdir(PATH_TO_REQIF_ROOT)  # the schema names parts of itself from there
    import xmlschema  # noqa: PLC0415  which takes longer than this whole module

    schema = xmlschema.XMLSchema("reqif/reqif_schema/reqif.xsd", base_url=PATH_TO_REQIF_ROOT)
    schema.validate(text)
    assert not schema.is_valid(text.replace("<SPEC-RELATION-TYPE-REF>depends</SPEC-RELATION-TYPE-REF>", "", 1))
    path = told.folder / "x.reqif"
    path.write_text(text)
    bundle = ReqIFParser.parse(str(path))
    assert not bundle.exceptions
    assert len(bundle.core_content.req_if_content.specifications) == 4
    assert bundle.get_spec_object_by_ref("FR-1.2") is not None


def test_reqif_has_all_of_it(told: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Objects of five types with texts and results, links by relations, criteria below documents, what is suspect."""
    root = lxml.etree.fromstring(exported(told, "reqif", capsys).encode())
    kinds = {one.get("IDENTIFIER"): one.get("LONG-NAME") for one in root.iter(f"{REQIF}SPEC-OBJECT-TYPE")}
    assert set(kinds.values()) == {"Document", "Criterion", "Row", "Symbol", "Test"}
    objects = {one.get("IDENTIFIER"): one for one in root.iter(f"{REQIF}SPEC-OBJECT")}
    types = [kinds[one.findtext(f".//{REQIF}SPEC-OBJECT-TYPE-REF")] for one in objects.values()]
    assert {kind: types.count(kind) for kind in ("Document", "Criterion", "Row", "Symbol")} == {
        "Document": 1,
        "Criterion": 4,
        "Row": 7,
        "Symbol": 4,
    }
    text = objects["FR-1.1"].find(f".//{REQIF}ATTRIBUTE-VALUE-XHTML/{REQIF}THE-VALUE")
    assert "".join(text.itertext()) == 'It beats > 1/s & "is" <b> with_under_scores é.'
    relations = root.findall(f".//{REQIF}SPEC-RELATION")
    ends = {
        (one.findtext(f".//{REQIF}SPEC-RELATION-TYPE-REF"), *(ref.text for ref in one.iter(f"{REQIF}SPEC-OBJECT-REF")))
        for one in relations
    }
    assert ("depends", "FR-1.2", "FR-1.1") in ends
    assert ("answers", identifier("field HEARTBEAT.custom_mode in specs/messages/heartbeat.yaml"), "FR-1.2") in ends
    assert ("shows", identifier("test tests/test_beat.py::test_beats shows FR-1.1"), "FR-1.1") in ends
    assert {kind for kind, _, _ in ends} == {"depends", "answers", "shows", "realizes"}
    suspect = [one for one in relations if 'THE-VALUE="suspect"' in lxml.etree.tostring(one).decode()]
    assert len(suspect) == 8
    assert {list(one.iter(f"{REQIF}SPEC-OBJECT-REF"))[1].text for one in suspect} == {"FR-1.1"}
    below = root.find(f".//{REQIF}SPECIFICATION/{REQIF}CHILDREN/{REQIF}SPEC-HIERARCHY/{REQIF}CHILDREN")
    assert [one.text for one in below.iter(f"{REQIF}SPEC-OBJECT-REF")] == ["FR-1.1", "FR-1.2", "FR-1.3", "FR-1.4"]


def test_it_is_the_same_every_time(told: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """No hour of the export; who wants one gives it, with its zone."""
    assert exported(told, "reqif", capsys) == exported(told, "reqif", capsys)
    assert exported(told, "needs", capsys) == exported(told, "needs", capsys)
    fixed = exported(told, "reqif", capsys)
    assert set(re.findall(r'LAST-CHANGE="([^"]*)"', fixed)) == {"1970-01-01T00:00:00Z"}
    given = exported(told, "reqif", capsys, "--last-change", "2026-11-25T12:00:00Z")
    assert set(re.findall(r'LAST-CHANGE="([^"]*)"', given)) == {"2026-11-25T12:00:00+00:00"}
    assert given.replace("2026-11-25T12:00:00+00:00", "1970-01-01T00:00:00Z") == fixed


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--format", "reqif", "--last-change", "yesterday"], "yesterday is no time"),
        (["--format", "reqif", "--last-change", "2026-11-25"], "2026-11-25 has no zone"),
        (["--format", "needs", "--last-change", "2026-11-25T12:00:00Z"], "--last-change belongs to --format reqif"),
    ],
)
def test_times_that_are_none(
    arguments: list[str], said: str, project: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    assert project.run(*arguments) == 2
    assert said in capsys.readouterr().err


def test_the_reader_of_sphinx_needs_takes_it(told: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Without a word, by the keys that it knows; links lead to needs, and what is suspect is tagged so."""
    path = told.folder / "needs.json"
    path.write_text(exported(told, "needs", capsys))
    version = load(path).select_version(None)
    records = {record.key: record.fields for record in version.records()}
    assert not version.diagnostics
    assert not [found for record in version.records() for found in record.diagnostics]
    assert records["FR_1_2"]["depends_on"] == ["FR_1_1"]
    assert records["FR_1_2"]["parent_needs"] == ["FR_1_"]
    assert records["FR_1_2"]["name"] == "FR-1.2"
    assert {link for need in records.values() for link in need["links"]} <= records.keys()
    rows = [need for need in records.values() if need["type"] == "spec" and "suspect" in need["tags"]]
    assert len(rows) == 6


def test_names_that_would_have_one_id() -> None:
    """The later one is told apart by a hash, and the links follow it."""
    names = ["FR-1", "test a/b", "test a_b", "x" * 90, "x" * 91]
    objects = tuple(ExchangeObject(ObjectKind.ROW, name, name, "", (), ()) for name in names)
    relations = tuple(Relation(RelationKind.ANSWERS, name, "FR-1") for name in names[1:])
    needs = json.loads(needs_json(Exchange("p", objects, relations)))["versions"][""]["needs"]
    assert len(needs) == len(names)
    assert {need["name"] for need in needs.values()} == set(names)
    assert sum(need["links"] == ["FR_1_"] for need in needs.values()) == 4
    assert all(re.fullmatch("[A-Z0-9_]{5,80}", name) for name in needs)


def test_control_characters_do_not_break_xml() -> None:
    text = reqif_xml(
        Exchange("p\x00", (ExchangeObject(ObjectKind.CRITERION, "FR-1.1", "FR-1.1", "a\x1bb", (), ()),), ())
    )
    assert lxml.etree.fromstring(text.encode()) is not None


@pytest.mark.parametrize(("form", "name"), [("reqif", "x.reqif"), ("needs", "needs.json")])
def test_it_goes_round(form: str, name: str, told: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Export, import, export: the same objects and links, but for the lines that documents have now."""
    document = told.document.read_text().replace("## Acceptance", "## Links\n\n- FR-9, ADR-1\n\n## Acceptance")
    inside = "is heard at:\n   - 10 m\n     1. at *noon*\n\n   ```text\n   v = a * b_\n   ```\n\n   > - 7 in all\n"
    told.document.write_text(document.replace("is heard at 10 m.", inside))
    first = exported(told, form, capsys)
    (told.folder / name).write_text(first)
    assert main(["import", name, "--out", "made"]) == 0
    assert "made: 1 document written" in capsys.readouterr().err
    (made,) = (told.folder / "made").iterdir()
    assert made.name == "FR-1-a-heart-beat-1.md"
    told.document.unlink()
    shutil.copy(made, told.document)
    place = re.compile(r"specs/requirements/FR-1\.md:\d+")
    assert place.sub("", exported(told, form, capsys)) == place.sub("", first)
