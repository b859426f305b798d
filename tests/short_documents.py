"""The shipped requirement documents without their prose: checking what they claim takes most of a check's time."""

import re
from collections.abc import Collection
from pathlib import Path

_KEPT = ("Metadata", "Acceptance Criteria")
_TABLES = (*_KEPT, "Field Population", "Worked Examples")


_CRITERION = re.compile(r"(?ms)^(\d+\. ).*?(?=^\d+\. |\Z)")


def shorten_documents(
    specs: Path, tables: Collection[str] = (), whole: Collection[str] = (), *, numbers_only: bool = False
) -> None:
    """Leave the documents of a copy their titles and the sections that state criteria, some their ``tables``, too.

    Those that are ``whole`` stay as they are. Where ``numbers_only``, criteria of those without tables say nothing.
    """
    for document in (specs / "requirements").glob("*.md"):
        if document.name.startswith(tuple(whole)):
            continue
        kept = _TABLES if document.name.startswith(tuple(tables)) else _KEPT
        title, *sections = document.read_text().split("\n## ")
        text = "\n## ".join([title, *(each for each in sections if each.startswith(kept))]) + "\n"
        is_bare = numbers_only and kept is _KEPT
        document.write_text(_CRITERION.sub(r"\1It is so.\n", text) if is_bare else text)
