"""``codegen import`` of ReqIF and needs.json: the documents that come of them, and what is wrong with such files."""

import json
import os
import re
from collections.abc import Callable
from html import unescape
from pathlib import Path
from xml.sax.saxutils import quoteattr

import pytest
from markdown_it import MarkdownIt

from codegen.cli import main
from codegen.decode.requirement import decode_requirement
from codegen.diagnostics import Report
from codegen.exchanged.arranged import Arranged, ArrangedCriterion
from codegen.exchanged.document_text import document_text
from codegen.exchanged.needs import read_needs
from codegen.exchanged.reqif import Attributes, read_reqif
from codegen.exchanged.restructured import formatted_content
from codegen.exchanged.stated import Formatted
from codegen.load.markdown import parse_markdown
from codegen.source import Place

Object = tuple[str, dict[str, str], list["Object"]]
Write = Callable[..., str]

HEAD = (
    '<?xml version="1.0" encoding="UTF-8"?>\n<REQ-IF xmlns="http://www.omg.org/spec/ReqIF/20110401/reqif.xsd" '
    'xmlns:x="http://www.w3.org/1999/xhtml"><CORE-CONTENT><REQ-IF-CONTENT>\n'
)
TAIL = "</REQ-IF-CONTENT></CORE-CONTENT></REQ-IF>\n"


def xml(objects: list[Object], relations: list[tuple[str, str, str]] = (), text: str = "ReqIF.Text") -> str:  # type: ignore[assignment]
    """A file of ReqIF as other tools write it; objects are (identifier, {attribute: value}, below it).

    The attributes are ``text`` and ``heading``, XHTML, and ``id`` and others, plain.
    """
    names = {"text": text, "heading": "ReqIF.ChapterName", "id": "ReqIF.ForeignID"}
    every, hierarchy = [], []
    used: dict[str, None] = {}

    def place(each: Object) -> str:
        key, values, below = each
        parts = []
        for name, value in values.items():
            used[name] = None
            if name in ("text", "heading"):
                parts.append(
                    f"<ATTRIBUTE-VALUE-XHTML><THE-VALUE><x:div>{value}</x:div></THE-VALUE><DEFINITION>"
                    f"<ATTRIBUTE-DEFINITION-XHTML-REF>a-{name}</ATTRIBUTE-DEFINITION-XHTML-REF></DEFINITION>"
                    "</ATTRIBUTE-VALUE-XHTML>"
                )
            else:
                parts.append(
                    f"<ATTRIBUTE-VALUE-STRING THE-VALUE={quoteattr(value)}><DEFINITION>"
                    f"<ATTRIBUTE-DEFINITION-STRING-REF>a-{name}</ATTRIBUTE-DEFINITION-STRING-REF></DEFINITION>"
                    "</ATTRIBUTE-VALUE-STRING>"
                )
        every.append(f'<SPEC-OBJECT IDENTIFIER="{key}"><VALUES>{"".join(parts)}</VALUES></SPEC-OBJECT>')
        inside = "".join(place(child) for child in below)
        children = f"<CHILDREN>{inside}</CHILDREN>" if inside else ""
        return f"<SPEC-HIERARCHY><OBJECT><SPEC-OBJECT-REF>{key}</SPEC-OBJECT-REF></OBJECT>{children}</SPEC-HIERARCHY>"

    hierarchy = [place(each) for each in objects]
    kinds = dict.fromkeys(kind for kind, _, _ in relations)
    related = "\n".join(
        f"<SPEC-RELATION><SOURCE><SPEC-OBJECT-REF>{source}</SPEC-OBJECT-REF></SOURCE>"
        f"<TARGET><SPEC-OBJECT-REF>{target}</SPEC-OBJECT-REF></TARGET>"
        f"<TYPE><SPEC-RELATION-TYPE-REF>k-{kind}</SPEC-RELATION-TYPE-REF></TYPE></SPEC-RELATION>"
        for kind, source, target in relations
    )
    types = "".join(
        f'<ATTRIBUTE-DEFINITION-XHTML IDENTIFIER="a-{name}" LONG-NAME="{names.get(name, name)}"/>' for name in used
    )
    types += "".join(f'<SPEC-RELATION-TYPE IDENTIFIER="k-{kind}" LONG-NAME="{kind}"/>' for kind in kinds)
    lines = "\n".join(every)
    return (
        f"{HEAD}<SPEC-TYPES><SPEC-OBJECT-TYPE><SPEC-ATTRIBUTES>{types}</SPEC-ATTRIBUTES></SPEC-OBJECT-TYPE></SPEC-TYPES>\n"
        f"<SPEC-OBJECTS>\n{lines}\n</SPEC-OBJECTS>\n<SPEC-RELATIONS>{related}</SPEC-RELATIONS>\n"
        f"<SPECIFICATIONS><SPECIFICATION><CHILDREN>{''.join(hierarchy)}</CHILDREN></SPECIFICATION></SPECIFICATIONS>{TAIL}"
    )


def needs(*listed: dict[str, object], **whole: object) -> str:
    by_id = {str(each["id"]): {"type": "req", **each} for each in listed}
    return json.dumps({"current_version": "1", "versions": {"1": {"needs": by_id}}, **whole}, indent=1)


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Write:
    """Write a file into the working directory, where no project is; its name."""
    monkeypatch.chdir(tmp_path)

    def written(name: str, text: str) -> str:
        (tmp_path / name).write_text(text)
        return name

    return written


def criteria(text: str) -> dict[str, list[str]]:
    """The texts of the criteria of printed documents, by id, as a project would read them."""
    found = {}
    for part in re.split(r"^(?=# )", text, flags=re.MULTILINE)[1:]:
        report = Report()
        requirement = decode_requirement(parse_markdown(part, "/d.md"), report)
        assert requirement is not None
        assert list(report) == []
        found[requirement.id] = [one.text for one in requirement.criteria]
    return found


CHAPTERS = [
    (
        "o1",
        {"heading": "Power", "id": "SRS-1"},
        [
            ("o2", {"text": "It <x:b>starts</x:b> in <x:code>2 s</x:code>.", "id": "SRS-2"}, []),
            ("o3", {"text": "<x:p>It stops.</x:p><x:p>At once.</x:p>", "id": "SRS-3"}, []),
            ("o4", {"heading": "Charge", "id": "SRS-4"}, [("o5", {"text": "1. of BATT_LOW_VOLT"}, [])]),
        ],
    ),
    ("o6", {"heading": "Introduction", "id": "SRS-5"}, []),
]


def test_headings_are_documents_and_texts_their_criteria(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """Chapters without requirements are none; what the other tool calls a thing stays readable."""
    path = write(
        "a.reqif", xml(CHAPTERS, [("depends on", "o3", "o2"), ("depends_on", "o5", "o3"), ("satisfies", "o2", "o3")])
    )
    assert main(["import", path]) == 0
    said = capsys.readouterr()
    assert criteria(said.out) == {
        "SRS-1": ["It starts in 2 s.", "It stops. At once. (depends on criterion 1)"],
        "SRS-4": ["1. of BATT_LOW_VOLT (depends on SRS-1.2)"],
    }
    assert "1. It **starts** in `2 s`." in said.out
    assert "- Status: Imported" in said.out
    assert "- Imported from `a.reqif`, where it is called `SRS-1`." in said.out
    assert "- Criterion 1 is called `SRS-2` there." in said.out
    assert "not imported, as it is no requirement: 1 relation 'satisfies'" in said.err


def test_documents_are_written_and_never_over_others(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """Neither over a file of the name, nor beside a document of the id; then nothing at all is written."""
    path = write("a.reqif", xml(CHAPTERS))
    assert main(["import", path, "--out", "made", "--status", "Draft"]) == 0
    assert sorted(os.listdir("made")) == ["SRS-1-power.md", "SRS-4-charge.md"]
    assert "- Status: Draft" in Path("made/SRS-1-power.md").read_text()
    before = Path("made/SRS-1-power.md").read_bytes()
    capsys.readouterr()
    os.rename("made/SRS-4-charge.md", "made/other.md")
    assert main(["import", path, "--out", "made"]) == 1
    said = capsys.readouterr().out
    assert "a.reqif:5:1: error import-present: SRS-1 is there: made/SRS-1-power.md" in said
    assert "error import-present: SRS-4 is there: made/other.md" in said
    assert sorted(os.listdir("made")) == ["SRS-1-power.md", "other.md"]
    assert Path("made/SRS-1-power.md").read_bytes() == before


def test_a_document_that_cannot_be_read_may_be_the_one_that_is_there(
    write: Write, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write("a.reqif", xml(CHAPTERS))
    Path("made").mkdir()
    Path("made/notes.md").write_bytes(b"# SRS-1 | \xff\n")
    assert main(["import", path, "--out", "made"]) == 2
    assert "made/notes.md:1:11: error file-not-utf8" in capsys.readouterr().out
    assert os.listdir("made") == ["notes.md"]


@pytest.mark.parametrize(
    "text",
    [
        "1. first",
        "- a list",
        "+ 3.3 V",
        "# 7 is a heading",
        "&gt; 5 V",
        "[x] done",
        "*stars* and _lines_ and `ticks` and [a](b) and &lt;b&gt;",
        "a \\ b \\* c",
        "&amp;lt; stays",
        "5 * 3 * 2 = 30, BATT_LOW_VOLT, __init__",
        "word " * 60 + "1. is no list, - nor this, # nor this",
        "é ü → °C",
        "---",
        "~~~ code",
    ],
)
def test_any_text_is_read_back_as_it_was(text: str, write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """Whatever Markdown would make of it, at its beginning, in its middle or where a line is broken."""
    path = write("a.reqif", xml([("o1", {"heading": text, "id": "A-1"}, [("o2", {"text": text}, [])])]))
    assert main(["import", path]) == 0
    assert criteria(capsys.readouterr().out) == {"A-1": [" ".join(unescape(text).split())]}


@pytest.mark.parametrize(
    ("inside", "what"),
    [
        ("<x:ul><x:li>a</x:li></x:ul>", "<ul>"),
        ("<x:table/>", "<table>"),
        ("10<x:sup>3</x:sup>", "<sup>"),
        ("<x:object data='p.png'/>", "<object>"),
        ("<x:del>not</x:del>", "<del>"),
    ],
)
def test_what_is_no_prose_is_not_guessed_at(
    inside: str, what: str, write: Write, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its document is left out, with the place; the others are made."""
    other = ("o3", {"heading": "Good", "id": "A-2"}, [("o4", {"text": "Fine."}, [])])
    path = write("a.reqif", xml([("o1", {"heading": "Bad", "id": "A-1"}, [("o2", {"text": inside}, [])]), other]))
    assert main(["import", path, "--out", "made"]) == 1
    assert f"error import-text: {what} cannot be written into a line of prose" in capsys.readouterr().out
    assert os.listdir("made") == ["A-2-good.md"]


@pytest.mark.parametrize(
    ("attribute", "what"),
    [
        ("style='text-decoration: line-through;'", "style 'text-decoration: line-through'"),
        (
            "style='color:red; TEXT-DECORATION : Underline LINE-THROUGH'",
            "style 'TEXT-DECORATION : Underline LINE-THROUGH'",
        ),
        ("style='text-decoration-line:line-through'", "style 'text-decoration-line:line-through'"),
        ("style='vertical-align:super'", "style 'vertical-align:super'"),
        ("style='vertical-align: 4pt'", "style 'vertical-align: 4pt'"),
        ("style='display:none'", "style 'display:none'"),
        ("style='visibility: hidden'", "style 'visibility: hidden'"),
        ("style='mso-hide:all'", "style 'mso-hide:all'"),
        ("style='font-size:0'", "style 'font-size:0'"),
        ("style='font: 0/0 serif'", "style 'font: 0/0 serif'"),
        ("style='color: #FFFFFF'", "style 'color: #FFFFFF'"),
        ("style='text-transform:uppercase'", "style 'text-transform:uppercase'"),
        ("style='white-space:pre'", "style 'white-space:pre'"),
        ("style='unicode-bidi:bidi-override; direction:rtl'", "style 'unicode-bidi:bidi-override'"),
        ("style='position:absolute'", "style 'position:absolute'"),
        ("style='text-indent:-9999px'", "style 'text-indent:-9999px'"),
        (r"style='text-decoration:line\2d through'", "style 'text-decoration:line"),
        ("class='ql-strike'", "class 'ql-strike'"),
        ("class='a superscript'", "class 'superscript'"),
        ("hidden='hidden'", "hidden 'hidden'"),
        ("dir='rtl'", "dir 'rtl'"),
    ],
)
@pytest.mark.parametrize("tag", ["span", "p", "b", "br"])
def test_attributes_that_change_what_is_said(
    tag: str, attribute: str, what: str, write: Write, capsys: pytest.CaptureFixture[str]
) -> None:
    """Struck, raised and hidden words are as much of a finding where an attribute says so as where an element does."""
    marked = f"It <x:{tag} {attribute}>not</x:{tag}> starts."
    path = write("a.reqif", xml([("o1", {"heading": "Bad", "id": "A-1"}, [("o2", {"text": marked}, [])])]))
    assert main(["import", path]) == 1
    assert f"error import-text: <{tag}> with the {what}" in capsys.readouterr().err


def test_attributes_of_the_whole_text_count_too(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """The element around a text strikes all of it; a text that a tool has simplified may have been struck before."""
    whole = xml([("o1", {"heading": "Bad", "id": "A-1"}, [("o2", {"text": "It starts."}, [])])])
    struck = whole.replace("<x:div>It starts", "<x:div style='text-decoration:line-through'>It starts")
    simple = "<ATTRIBUTE-VALUE-XHTML IS-SIMPLIFIED='true'><THE-ORIGINAL-VALUE><x:div>It <x:del>never</x:del> starts."
    simplified = whole.replace(
        "<ATTRIBUTE-VALUE-XHTML><THE-VALUE><x:div>It starts",
        f"{simple}</x:div></THE-ORIGINAL-VALUE><THE-VALUE><x:div>It never starts",
    )
    alone = whole.replace(
        "<ATTRIBUTE-VALUE-XHTML><THE-VALUE><x:div>It",
        "<ATTRIBUTE-VALUE-XHTML IS-SIMPLIFIED='true'><THE-VALUE><x:div>It",
    )
    for text in (struck, simplified, alone):
        assert text != whole
        assert main(["import", write("a.reqif", text)]) == 1
        assert "error import-text: " in capsys.readouterr().err
    same = simplified.replace("<x:del>never</x:del>", "<x:b>never</x:b>")
    assert main(["import", write("a.reqif", same)]) == 0
    assert "It **never** starts." in capsys.readouterr().out


@pytest.mark.parametrize(
    "attribute",
    [
        "style='color:#1F497D; font-family:\"Arial\",sans-serif; font-size:10.0pt; mso-fareast-language:DE'",
        "style='text-decoration: underline; vertical-align: baseline; margin-left: 0cm;; background:white'",
        "style='font: bold 10pt Empire !important; white-space: pre-wrap; text-indent: -18.0pt'",
        "class='MsoNormal'",
        "dir='ltr' lang='en' id='a1' title='t'",
        "style=''",
    ],
)
def test_attributes_that_change_looks_alone(attribute: str, write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """Fonts, colours and margins of other tools say nothing."""
    marked = f"It <x:span {attribute}>always</x:span> starts."
    path = write("a.reqif", xml([("o1", {"heading": "Good", "id": "A-1"}, [("o2", {"text": marked}, [])])]))
    assert main(["import", path]) == 0
    assert criteria(capsys.readouterr().out) == {"A-1": ["It always starts."]}


@pytest.mark.parametrize(
    ("objects", "options", "told"),
    [
        (
            [("o1", {"heading": "T", "id": "12"}, [("o2", {"text": "a"}, [])])],
            [],
            "5:1: error import-id: '12' is no id",
        ),
        ([("o1", {"heading": "T", "id": "12"}, [("o2", {"text": "a"}, [])])], ["--prefix", "FR"], None),
        (
            [
                (f"o{n}", {"heading": "T", "id": name}, [(f"p{n}", {"text": "a"}, [])])
                for n, name in enumerate(("1-2", "12"))
            ],
            ["--prefix", "FR"],
            "error import-id: '12' would be FR-12, as another one is",
        ),
        ([("o1", {"text": "a", "id": "A-1"}, [])], [], "error import-title: A-1 has no title"),
        (
            [("o1", {"heading": "T", "id": "A-1"}, [("o2", {"text": "a", "id": "A-2"}, [("o3", {"text": "b"}, [])])])],
            [],
            "warning import-below: o3 stands below the requirement A-2",
        ),
    ],
)
def test_what_documents_need(
    objects: list[Object], options: list[str], told: str | None, write: Write, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write("a.reqif", xml(objects))
    code = main(["import", path, "--out", "made", *options])
    said = capsys.readouterr().out
    assert code == (told is not None and "error" in told)
    assert (told or "") in said
    if told is None:
        assert os.listdir("made") == ["FR-12-t.md"]


def test_other_names_of_attributes(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """A file without ReqIF.Text says what it has; no attribute is taken for it unasked."""
    path = write("a.reqif", xml(CHAPTERS, text="Object Text"))
    assert main(["import", path]) == 1
    assert "error reqif-attribute: no object has an attribute ReqIF.Text" in (said := capsys.readouterr().err)
    assert "its attributes are Object Text, ReqIF.ChapterName, ReqIF.ForeignID: --text NAME" in said
    assert main(["import", path, "--text", "Object Text"]) == 0
    assert list(criteria(capsys.readouterr().out)) == ["SRS-1", "SRS-4"]


def test_one_of_several_specifications(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """Modules that number their objects each for itself are imported one by one, with prefixes of their own."""
    first = ("o1", {"heading": "One", "id": "1"}, [("o2", {"text": "It starts.", "id": "2"}, [])])
    second = ("o3", {"heading": "Two", "id": "1"}, [("o4", {"text": "It stops.", "id": "2"}, [])])
    whole = xml([first, second])
    apart = "</SPEC-HIERARCHY></CHILDREN></SPECIFICATION><SPECIFICATION IDENTIFIER='m2' LONG-NAME='Second'><CHILDREN>"
    text = whole.replace("<SPECIFICATION>", "<SPECIFICATION IDENTIFIER='m1' LONG-NAME='First'>")
    at = "<SPEC-HIERARCHY><OBJECT><SPEC-OBJECT-REF>o3"
    text = text.replace(f"</SPEC-HIERARCHY>{at}", apart + at)
    assert text.count("<SPECIFICATION ") == 2
    path = write("a.reqif", text)
    assert main(["import", path, "--prefix", "FR"]) == 1
    assert "hint: rename one of the two, or import each --specification with" in (capsys.readouterr().err)
    for name, prefix, said in (("First", "FR", "It starts."), ("m2", "NFR", "It stops.")):
        assert main(["import", path, "--specification", name, "--prefix", prefix]) == 0
        told = capsys.readouterr()
        assert criteria(told.out) == {f"{prefix}-1": [said]}
        assert "not imported, as it is no requirement: 2 object" in told.err
    assert main(["import", path, "--specification", "Third"]) == 1
    assert "error reqif-specification: no specification is called Third" in capsys.readouterr().err
    assert main(["import", path, "--specification", "Third"]) == 1
    assert "hint: name one of First, Second" in capsys.readouterr().err


def test_references_that_lead_nowhere(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    good = xml(CHAPTERS, [("depends on", "o3", "o2")])
    broken = good.replace(
        "<SPEC-OBJECT-REF>o3</SPEC-OBJECT-REF></OBJECT>", "<SPEC-OBJECT-REF>o9</SPEC-OBJECT-REF></OBJECT>"
    )
    broken = broken.replace("<TARGET><SPEC-OBJECT-REF>o2<", "<TARGET><SPEC-OBJECT-REF>o8<")
    broken = broken.replace('IDENTIFIER="a-id"', 'IDENTIFIER="a-other"').replace('IDENTIFIER="o6"', 'IDENTIFIER="o5"')
    assert main(["import", write("a.reqif", broken), "--out", "made"]) == 1
    said = capsys.readouterr().out
    for message in ("the file has no object o9", "the file has no object o8", "no such attribute def", "is called o5"):
        assert f"error reqif-reference: {message}" in said or message in said, message
    twice = good.replace("<SPEC-OBJECT-REF>o6</SPEC-OBJECT-REF>", "<SPEC-OBJECT-REF>o2</SPEC-OBJECT-REF>")
    assert main(["import", write("b.reqif", twice), "--out", "made2"]) == 0
    assert "warning reqif-twice: o2 stands in a hierarchy before" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "text", "rule"),
    [
        ("a.reqif", "", "1:1: error xml-syntax"),
        ("a.reqif", "<REQ-IF>", "error xml-syntax"),
        ("a.reqif", "<html/>", "1:1: error reqif-format: <html>"),
        ("a.reqif", "<REQ-IF/>", "1:1: error reqif-format"),
        ("a.reqif", '<!DOCTYPE a [<!ENTITY b SYSTEM "/etc/passwd">]><REQ-IF>&b;</REQ-IF>', "1:1: error xml-doctype"),
        ("a.reqif", "<a>" * 5000, "error xml-syntax"),
        ("a.reqif", '<?xml version="1.0" encoding="utf-7"?><REQ-IF/>', "error xml-encoding"),
        ("n.json", "", "1:1: error needs-format: it is no JSON"),
        ("n.json", '{"versions": }', "1:14: error needs-format: it is no JSON"),
        ("n.json", "[" * 100_000, "error needs-format: it is nested too deeply"),
        ("n.json", "[]", "error needs-format: it has no versions"),
        ("n.json", '{"versions": {}}', "error needs-format: it has no version None"),
        (
            "n.json",
            '{"current_version": "1", "versions": {"1": []}}',
            "error needs-format: its version '1' has no needs",
        ),
        ("n.json", '{"current_version": [], "versions": {}}', "error needs-format: it has no version"),
        ("missing.reqif", None, "error file-not-found"),
        ("missing.json", None, "error file-not-found"),
    ],
)
def test_files_that_are_none(
    name: str, text: str | None, rule: str, write: Write, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nothing is fetched, expanded or written, and the exit code says that nothing could be read."""
    if text is not None:
        write(name, text)
    assert main(["import", str(Path(name)), "--out", "made"]) == 2
    assert rule in capsys.readouterr().out
    assert not Path("made").exists()


def test_a_file_that_is_too_large(write: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    for module, read in (
        ("reqif", lambda report: read_reqif(write("a.reqif", xml(CHAPTERS)), Attributes(), report)),
        ("needs", lambda report: read_needs(write("n.json", needs()), ["req"], None, report)),
    ):
        monkeypatch.setattr(f"codegen.exchanged.{module}.MAX_BYTES", 20)
        report = Report()
        assert read(report) is None
        assert [found.rule.id for found in report] == ["file-too-large"]


def test_needs_become_documents(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """Below a parent a need is a criterion, without one a document; other types are counted, as tests are."""
    path = write(
        "n.json",
        needs(
            {"id": "REQ_1", "title": "Power", "status": "open", "content": ""},
            {"id": "REQ_2", "title": "a", "content": "It *starts* in ``2 s``.", "parent_needs": ["REQ_1"]},
            {
                "id": "REQ_3",
                "title": "b",
                "description": "As **before**.",
                "parent_needs": ["REQ_1"],
                "depends_on": ["REQ_2"],
            },
            {"id": "REQ_4", "title": "Alone", "content": "It is alone.", "depends_on": ["REQ_3", "GONE"]},
            {"id": "T_1", "type": "test", "title": "t"},
        ),
    )
    assert main(["import", path, "--prefix", "FR"]) == 0
    said = capsys.readouterr()
    assert criteria(said.out) == {
        "FR-req1": ["It starts in 2 s.", "As before. (depends on criterion 1)"],
        "FR-req4": ["It is alone. (depends on FR-req1.2)"],
    }
    assert "- Status: open" in said.out
    assert "It *starts* in `2 s`." in said.out
    assert "not imported, as it is no requirement: 1 test" in said.err
    assert "warning import-dependency: REQ_4 depends on GONE, which is not imported" in said.err


@pytest.mark.parametrize(
    ("need", "told"),
    [
        ({"title": 7}, "6:5: error needs-record: the need A_1 has a title that is no text"),
        ({"content": []}, "error needs-record: the need A_1 has a content that is no text"),
        ({"parent_needs": "B"}, "error needs-record: the need A_1 has parent_needs that are no list of ids"),
        ({"depends_on": [1]}, "error needs-record: the need A_1 has depends_on that are no list of ids"),
        ({"type": "story"}, "1:1: error needs-type: no need is of the type req"),
        ({"content": "See :need:`B`."}, "6:5: error import-text: its content has ':need:`'"),
        ({"content": "a\n\n.. image:: x.png"}, "error import-text: its content has '..'"),
        ({"content": "- a\n- b"}, "error import-text: its content has '-'"),
        ({"content": "a::\n\n  code"}, "error import-text: its content has '::'"),
        ({"content": "see foo_ there"}, "error import-text: its content has 'foo_'"),
    ],
)
def test_needs_that_cannot_be_read(
    need: dict[str, object], told: str, write: Write, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write("n.json", needs({"id": "A_1", "title": "t", "content": "c", **need}))
    assert main(["import", path, "--prefix", "FR", "--out", "made"]) == 1
    assert told in capsys.readouterr().out


def test_a_need_that_is_no_object(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    path = write("n.json", '{"current_version": "1", "versions": {"1": {"needs": {"A": 7}}}}')
    assert main(["import", path, "--out", "made"]) == 1
    assert "n.json:1:55: error needs-record: the need A is no object" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("content", "markdown"),
    [
        ("a\\_b \\*c\\*", "a\\_b \\*c\\*"),
        ("``a_b`` *c* **d**", "`a_b` *c* **d**"),
        ("a\\ b", "ab"),
        ("x * y * z", "x * y * z"),
    ],
)
def test_what_a_content_says(content: str, markdown: str) -> None:
    report = Report()
    found = formatted_content(content, Place("/n.json"), report)
    assert list(report) == []
    assert found is not None
    assert found.markdown == markdown


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["a.reqif", "--merge"], "--merge belongs to the import of fields"),
        (["a.reqif", "--for-each", "x"], "--for-each belongs to the import of fields"),
        (["a.reqif", "--prefix", "fr"], "--prefix takes capital letters, not 'fr'"),
        (["a.reqif", "--out", "a.reqif"], "a.reqif is no folder"),
        (["a.md", "--prefix", "FR"], "--prefix belongs to the import of a FILE.reqif or needs.json"),
    ],
)
def test_wrong_usage(arguments: list[str], said: str, write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    write("a.reqif", xml(CHAPTERS))
    write("a.md", "# A-1 | T\n")
    assert main(["import", *arguments]) == 2
    assert said in capsys.readouterr().err


def test_ten_thousand_requirements(write: Write) -> None:
    """Of both formats, with as many links: a matter of seconds."""
    chapters = [
        (
            f"h{n}",
            {"heading": f"Chapter {n}", "id": f"A-{n}"},
            [(f"o{n}x{m}", {"text": f"It does {m}."}, []) for m in range(100)],
        )
        for n in range(100)
    ]
    relations = [("depends on", f"o{n}x{m}", f"o{n}x{m - 1}") for n in range(100) for m in range(1, 100)]
    assert main(["import", write("a.reqif", xml(chapters, relations)), "--out", "made"]) == 0
    assert len(os.listdir("made")) == 100
    assert "100. It does 99. (depends on criterion 99)" in Path("made/A-7-chapter-7.md").read_text()
    report = Report()
    many = [{"id": f"R_{n}", "title": "t", "content": f"It does {n}."} for n in range(10_000)]
    stated = read_needs(write("n.json", needs(*many)), ["req"], None, report)
    assert stated is not None
    assert len(stated.objects) == 10_000
    assert stated.objects[-1].place.line > 50_000


def test_numbers_that_names_have_are_kept(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """In a file that is sorted by its ids, the tenth criterion comes before the second."""
    names = ["FR-1.1", "FR-1.10", *(f"FR-1.{number}" for number in range(2, 10))]
    below = [{"id": name, "title": name, "content": f"It is {name}.", "parent_needs": ["FR-1"]} for name in names]
    assert main(["import", write("n.json", needs({"id": "FR-1", "title": "T"}, *below))]) == 0
    assert criteria(capsys.readouterr().out) == {"FR-1": [f"It is FR-1.{number}." for number in range(1, 11)]}


def test_gaps_in_numbers_are_kept(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    """A number that was deleted in the other tool is not used again; a page shows what is cited."""
    names = ["FR-1.2", "FR-1.3", "FR-1.5", "FR-1.9"]
    below = [{"id": name, "title": name, "content": f"It is {name}.", "parent_needs": ["FR-1"]} for name in names]
    assert main(["import", write("n.json", needs({"id": "FR-1", "title": "T"}, *below))]) == 0
    text = capsys.readouterr().out
    report = Report()
    requirement = decode_requirement(parse_markdown(text, "/d.md"), report)
    assert list(report) == []
    assert requirement is not None
    assert [(each.number, each.text) for each in requirement.criteria] == [
        (int(name[-1]), f"It is {name}.") for name in names
    ]
    page = MarkdownIt("commonmark").render(text)
    assert re.findall(r'<ol(?: start="(\d+)")?>', page) == ["2", "5", "9"]
    assert "<!-- FR-1.6 to FR-1.8 are not in the file -->" in text


def test_a_document_that_reads_otherwise_is_not_written() -> None:
    """Whatever made its Markdown: it says what was imported, or it is not there."""
    place = Place("/a.reqif", 7, 1)
    criterion = ArrangedCriterion(1, Formatted("It *beats*", "It sleeps"), (), "", "o1", place)
    report = Report()
    assert document_text(Arranged("A-1", "T", {}, (criterion,), "A-1", place), "Draft", "a.reqif", report) is None
    assert [(found.rule.id, found.place) for found in report] == [("import-text", place)]
