"""Reports for people: text of others is text, and numbers agree with their nouns."""

import re

import pytest

from codegen.cli import main
from codegen.diff.change import Change, changed
from codegen.diff.markdown import code, plain, review_markdown
from codegen.diff.page import review_page
from codegen.diff.review import Review, review
from codegen.diff.system import Comparison
from codegen.diff.trace_rules import DOC, REQUIREMENT_TEXT
from codegen.diff.wire_rules import MESSAGE_REMOVED
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


def test_long_names_break_between_their_parts() -> None:
    assert "<b>A_<wbr>LONG_<wbr>NAME.<wbr>of_<wbr>a_<wbr>field<wbr></b>" in review_page(reviewed(change()))
    other = changed(REQUIREMENT_TEXT, "FR-1.1", "a", "b", (Place("x"), Place("x")))
    named = changed(DOC, "_x..y_", "a", "b", (Place("x"), Place("x")))
    page = review_page(reviewed(other, named)).replace("<wbr>", "")
    assert "<b>FR-1.1</b>" in page
    assert "<b>_x..y_</b>" in page


@pytest.mark.parametrize(
    ("option", "value", "said"),
    [
        ("--fail-on", "", "--fail-on knows no empty list"),
        ("--fail-on", " , ", "--fail-on knows no empty list"),
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
