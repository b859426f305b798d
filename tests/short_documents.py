"""The shipped requirement documents without their prose: checking what they claim takes most of a check's time."""

from collections.abc import Collection
from pathlib import Path

_KEPT = ("Metadata", "Acceptance Criteria")
_TABLES = (*_KEPT, "Field Population", "Worked Examples")


def shorten_documents(specs: Path, tables: Collection[str] = (), whole: Collection[str] = ()) -> None:
    """Leave the documents of a copy their titles and the sections that state criteria, some their ``tables``, too.

    Those that are ``whole`` stay as they are.
    """
    for document in (specs / "requirements").glob("*.md"):
        if document.name.startswith(tuple(whole)):
            continue
        kept = _TABLES if document.name.startswith(tuple(tables)) else _KEPT
        title, *sections = document.read_text().split("\n## ")
        document.write_text("\n## ".join([title, *(each for each in sections if each.startswith(kept))]) + "\n")
