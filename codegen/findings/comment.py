"""Cuts Markdown to the length of a comment on a pull request."""

MOST_CHARACTERS = 60_000
"""A comment on GitHub has at most 65,536."""

_TAIL = 400


def fitting(text: str, noun: str, where: str) -> str:
    """Markdown that is at most a comment long: of a longer one the first lines, how many follow and where they are.

    Rows of tables are what is counted, as ``noun``: ``criteria``.
    """
    if len(text) <= MOST_CHARACTERS:
        return text
    kept = text[: MOST_CHARACTERS - _TAIL].rpartition("\n")[0]
    left = sum(line.startswith("| ") and not line.startswith("| ---") for line in text[len(kept) :].splitlines())
    return f"{kept}\n\n{left} further {noun} do not fit into a comment: {where}\n"
