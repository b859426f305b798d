"""The shipped requirement documents without their prose: checking what they claim takes most of a check's time."""

from collections.abc import Collection
from pathlib import Path

_KEPT = ("Metadata", "Acceptance Criteria")


def shorten_documents(specs: Path, whole: Collection[str] = ()) -> None:
    """Leave the documents of a copy their titles and the sections that state criteria, but for the ``whole`` ones."""
    for document in (specs / "requirements").glob("*.md"):
        if not document.name.startswith(tuple(whole)):
            title, *sections = document.read_text().split("\n## ")
            document.write_text("\n## ".join([title, *(each for each in sections if each.startswith(_KEPT))]) + "\n")
