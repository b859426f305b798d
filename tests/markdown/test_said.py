"""The fingerprint of all that a document says: its layout does not count, each word and each list does."""

import pytest

from codegen.load.markdown import parse_markdown

TEXT = """\
# FR-1 | Position

The *boat* says `where` it is,
once per second.

| Field | Value |
| --- | --- |
| lat | 5 |

```python
if a:
    b()
```

1. First.
"""


def said(text: str) -> str:
    """Return the fingerprint of a document."""
    return parse_markdown(text, "/documents/fr-1.md").said


@pytest.mark.parametrize(
    ("written", "otherwise"),
    [
        ("it is,\nonce per", "it is, once\nper"),
        ("The *boat*", "The  _boat_"),
        ("`where`", "where"),
        ("| --- | --- |", "|-----|-------|"),
        ("| lat | 5 |", "|  lat  |  5  |"),
        ("1. First.", "1) First."),
        ("# FR-1 | Position\n", "FR-1 | Position\n===\n"),
        ("Position\n\n", "Position\n\n\n\n"),
    ],
)
def test_what_is_only_written_differently_says_the_same(written: str, otherwise: str) -> None:
    """A review is not asked to look at it."""
    assert written in TEXT
    assert said(TEXT.replace(written, otherwise)) == said(TEXT)


@pytest.mark.parametrize(
    ("written", "otherwise"),
    [
        ("once per", "twice per"),
        ("The *boat*", "The ~~boat~~"),
        ("| lat | 5 |", "| lat | -5 |"),
        ("    b()", "b()"),
        ("```python", "```c"),
        ("1. First.", "2. First."),
        ("1. First.", "- First."),
        ("The *boat*", "## The *boat*"),
    ],
)
def test_what_says_something_else_is_told_apart(written: str, otherwise: str) -> None:
    """Another word, another number, what is struck, code that is indented otherwise, another list."""
    assert written in TEXT
    assert said(TEXT.replace(written, otherwise)) != said(TEXT)
