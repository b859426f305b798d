"""Reports for people: text of others is text, and numbers agree with their nouns."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest

from codegen.cli import main
from codegen.diagnostics import MOST
from codegen.diff.change import Change, changed
from codegen.diff.dialect.wire_rules import ENTRY_ADDED, FIELD_UNITS, MESSAGE_REMOVED
from codegen.diff.report.markdown import code, plain, review_markdown
from codegen.diff.report.page import review_page
from codegen.diff.report.review import Review, review
from codegen.diff.system.system import Comparison
from codegen.diff.system.trace_rules import DOC, REQUIREMENT_TEXT, UNTESTED
from codegen.findings.comment import MOST_CHARACTERS
from codegen.source import Place


def change(name: str = "A_LONG_NAME.of_a_field") -> Change:
    return changed(
        MESSAGE_REMOVED, name, "old | `value`", None, (Place("/x/y.yaml", 3, 4), None), "see @us in #12 & co"
    )


def reviewed(*changes: Change, elsewhere: int = 0, notes: tuple[str, ...] = ()) -> Review:
    return review("main", "work tree", Comparison(changes, (change(),) * elsewhere), notes)


def test_a_comment_calls_nobody_and_links_to_no_issue() -> None:
    """Forges look for these after the Markdown was read: a backslash is gone by then, a space of no width is not."""
    assert plain("@octocat #12 a@b x&lt;y") == "\\@&#8203;octocat \\#&#8203;12 a\\@&#8203;b x\\&lt;y"
    comment = review_markdown(reviewed(change(), notes=("ask @octocat",)))
    assert not re.search(r"[@#]\w", comment.replace("&#8203;", " "))


def test_code_in_a_comment_stands_as_it_is() -> None:
    """A bar ends cells of tables only, and no table of the comment has code; a backslash before it would be seen."""
    assert code("a | `b`") == "`` a | `b` ``"
    comment = review_markdown(reviewed(change()))
    assert "gone: `` old | `value` ``" in comment
    assert not any("`" in line for line in comment.splitlines() if line.startswith("|"))


@pytest.mark.parametrize(
    ("count", "said"), [(1, "1 further change of the dialect concerns"), (2, "2 further changes of the")]
)
def test_what_is_only_counted_is_counted_in_words_that_agree(count: int, said: str) -> None:
    found = reviewed(change(), elsewhere=count)
    assert said in review_markdown(found)
    assert said in review_page(found)


@pytest.mark.parametrize(("count", "said"), [(0, ""), (1, "1 is lost"), (2, "2 are lost")])
def test_what_is_lost_is_counted_in_words_that_agree(count: int, said: str) -> None:
    lost = [changed(UNTESTED, f"FR-{each}.1", "a", None, (Place(f"{each}"), None)) for each in range(count)]
    other = changed(REQUIREMENT_TEXT, "FR-9.1", "a", "b", (Place("x"), Place("x")))
    (row,) = re.findall(r"(?m)^\| Requirements \| .*", review_markdown(reviewed(other, *lost)))
    assert row == f"| Requirements | {count + 1} |  | {said} |  |"


def test_long_names_break_between_their_parts() -> None:
    assert "<b>A_<wbr>LONG_<wbr>NAME.<wbr>of_<wbr>a_<wbr>field</b>" in review_page(reviewed(change()))
    other = changed(REQUIREMENT_TEXT, "FR-1.1", "a", "b", (Place("x"), Place("x")))
    named = changed(DOC, "_x..y_", "a", "b", (Place("x"), Place("x")))
    page = review_page(reviewed(other, named)).replace("<wbr>", "")
    assert '<b><span class="whole">FR-1.1</span></b>' in page
    assert "<b>_x..y_</b>" in page


@pytest.mark.parametrize(
    ("option", "value", "said"),
    [
        ("--fail-on", "", "--fail-on knows no empty list"),
        ("--fail-on", " , ", "--fail-on knows no empty list"),
        ("--fail-on", "never,any", "--fail-on never,any: never goes with no other"),
        ("--fail-on", "wire,claim-unit", "--fail-on knows no claim-unit"),
        ("--bandwidth", "-1", "--bandwidth is at least 0 %, not -1"),
    ],
)
def test_what_could_never_fail_is_refused(
    option: str, value: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """A workflow with an empty variable, or with a rule of another command, would be green whatever changed."""
    assert main(["diff", "common", "common", f"{option}={value}"]) == 2
    assert said in capsys.readouterr().err


def test_a_comment_has_room_for_what_breaks_before_what_does_not() -> None:
    """However much is harmless: not one of the breaking ones is left out, and what is left out is counted."""
    place = Place("/x/y.xml", 3, 4), Place("/x/y.xml", 3, 4)
    harmless = [changed(ENTRY_ADDED, f"E{number}.x", None, "x" * 200, place) for number in range(300)]
    doubtful = [changed(ENTRY_ADDED, f"D{n}.x", "a", "b", place, breaks=(), doubt="which it is") for n in range(40)]
    breaking = [changed(FIELD_UNITS, f"M{number}.f", "mV", "V" * 100, place) for number in range(60)]
    comment = review_markdown(reviewed(*harmless, *doubtful, *breaking))
    assert len(comment) <= MOST_CHARACTERS
    assert comment.count("**silent and breaking** ·") == 60
    assert comment.count("**needs a person** ·") == 40
    shown = comment.count("(`enum-entry-added`)") - 40
    assert 0 < shown < 300
    assert f"{300 - shown} further changes do not fit into a comment, none of which breaks anybody" in comment
    many = [changed(FIELD_UNITS, f"M{number}.f", "mV", "V" * 100, place) for number in range(400)]
    comment = review_markdown(reviewed(*harmless, *many))
    assert len(comment) <= MOST_CHARACTERS
    assert "enum-entry-added" not in comment
    assert re.search(r"[1-9]\d* of them among those that break or need a person", comment)


XML = '<mavlink><messages><message id="7" name="M"><description>d</description>{}</message></messages></mavlink>'
FIELD = '<field type="{}" name="{}">a</field>'

READERS: dict[str, Callable[[str], str]] = {
    "text": str,
    "markdown": lambda out: out.replace("\\", ""),
    "html": lambda out: re.sub("<[^>]*>", "", out),
    "json": lambda out: " ".join(one["message"] for one in json.loads(out)["errors"]),
    "github": lambda out: "\n".join(line for line in out.splitlines() if line.startswith("::error")),
    "sarif": lambda out: " ".join(
        one["message"]["text"] for one in json.loads(out)["runs"][0]["results"] if one["level"] == "error"
    ),
    "junit": lambda out: " ".join(
        case.get("message", "")
        for case in ElementTree.fromstring(out).iter("failure")  # noqa: S314  our own
    ),
    "gitlab": lambda out: " ".join(one["description"] for one in json.loads(out) if one["severity"] == "major"),
}


@pytest.mark.parametrize("form", READERS)
def test_a_side_with_errors_says_so_in_every_format(
    form: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """All of its errors: what a misspelt type hides is not said to be harmless."""
    old, new = tmp_path / "old.xml", tmp_path / "new.xml"
    old.write_text(XML.format(FIELD.format("uint8_t", "a")))
    new.write_text(XML.format(FIELD.format("uint88_t", "a") + FIELD.format("uint99_t", "b")))
    for allowed in ((), ("--allow-errors", "--fail-on", "never")):
        code = main(["diff", str(old), str(new), "--format", form, *allowed])
        captured = capsys.readouterr()
        assert code == (0 if allowed else 1)
        said = READERS[form](captured.out + (captured.err if form == "text" else ""))
        assert "uint88_t" in said
        assert "uint99_t" in said
    main(["diff", str(old), str(new), "--fail-on", "never"])
    assert "has 2 errors, and what they concern may be missing (--allow-errors" in capsys.readouterr().err


@pytest.mark.parametrize("form", [form for form in READERS if form not in ("json", "markdown")])
def test_of_many_errors_of_a_side_some_are_shown_and_the_others_counted(
    form: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """As in every list of findings; what is for programs has all of them, and a comment has fewer."""
    old, new = tmp_path / "old.xml", tmp_path / "new.xml"
    old.write_text(XML.format(FIELD.format("uint8_t", "a")))
    new.write_text(XML.format("".join(FIELD.format("uint88_t", f"f{number}") + "\n" for number in range(150))))
    assert main(["diff", str(old), str(new), "--format", form]) == 1
    captured = capsys.readouterr()
    said = READERS[form](captured.out + (captured.err if form == "text" else ""))
    assert said.count("uint88_t") == MOST
    assert "50 more of these" in said
