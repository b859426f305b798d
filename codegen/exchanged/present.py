"""Documents that are there already: an import replaces none of them, whatever their files are called."""

import os
import re
from collections.abc import Mapping

from codegen.diagnostics import Report, Rule
from codegen.load.files import DISK
from codegen.source import Place, shown_path

IMPORT_PRESENT = Rule(
    "import-present",
    "A document with the id is in the folder already, or a file of the name. Nothing is replaced and nothing written: "
    "import into an empty folder and compare, or take the old document away.",
)

_TITLE = re.compile(r"^#\s+([A-Z]+-[0-9a-z]+)\s*\|", re.MULTILINE)


def check_absent(folder: str, wanted: Mapping[str, tuple[str, Place]], report: Report) -> bool:
    """Return whether a folder, which may not exist, has none of the documents; what cannot be read may be one of them.

    ``wanted`` has by id file name and place.
    """
    present: dict[str, str] = {}
    reading = Report()
    names = DISK.names(folder, reading)
    for name in names:
        path = os.path.join(folder, name)
        text = DISK.read_text(path, reading) if name.endswith(".md") else None
        found = _TITLE.search(text or "")
        if found is not None:
            present[found[1]] = path
    report.extend(reading)
    is_free = not reading.has_errors
    for identifier, (name, place) in wanted.items():
        if identifier in present or name in names:
            shown = shown_path(os.path.abspath(present.get(identifier) or os.path.join(folder, name)))
            report.add(IMPORT_PRESENT, place, f"{identifier} is there: {shown}", "nothing was written")
            is_free = False
    return is_free
