# ruff: noqa: T201  it says what it has stored
"""What is made of each project of the tests and of the example: project_outputs.json has a digest of each file.

Run as a program it stores them anew. With a folder it writes the files themselves there as well, so that those before
and after a change can be compared: `python tests/emit/project_outputs.py build/after`.
"""

import hashlib
import json
import sys
from pathlib import Path

from codegen.commands.build import render_systems
from codegen.diagnostics import Report
from codegen.project.systems import read_systems
from codegen.targets.origin import united

ROOT = Path(__file__).resolve().parents[2]
PROJECTS = ROOT / "tests" / "projects"
STORED = Path(__file__).with_suffix(".json")
PLACES = {path.parent.name: path for path in PROJECTS.glob("*/specs")} | {
    "examples/boat": ROOT / "examples" / "boat" / "specs"
}
"""The folders of specifications, by the name of the project."""
COMMITTED = [ROOT / "generated", *(ROOT / "generated" / name for name in ("common", "smart_battery"))]


def rendered(project: str) -> dict[str, str]:
    """Return the text of each output file of a project, by its path below the output folder."""
    report = Report()
    systems = read_systems(str(PLACES[project] / "codegen.yaml"), report)
    assert systems, [str(found) for found in report]
    assert not report.has_errors, [str(found) for found in report]
    return dict(render_systems(systems).files)


def digests(files: dict[str, str]) -> dict[str, str]:
    """Return the first digits of the sha256 of each file, without those that are the same in generated/.

    A header that names other sources makes no other file there.
    """
    return {
        path: hashlib.sha256(text.encode()).hexdigest()[:12]
        for path, text in sorted(files.items())
        if not any(_is_same(text, folder / path) for folder in COMMITTED)
    }


def _is_same(text: str, committed: Path) -> bool:
    return committed.is_file() and united([text, committed.read_text(encoding="utf-8")]) is not None


def stored() -> dict[str, dict[str, str]]:
    """Return the digests that are stored, by project and path."""
    found: dict[str, dict[str, str]] = json.loads(STORED.read_text(encoding="utf-8"))
    return found


def main() -> None:
    """Store the digests, and write the files to the folder that is named."""
    found = {}
    for project in sorted(PLACES):
        files = rendered(project)
        found[project] = digests(files)
        for folder in sys.argv[1:]:
            for path, text in files.items():
                place = Path(folder) / project / path
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_text(text, encoding="utf-8", newline="")
    STORED.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    print(f"{STORED.name} has {sum(map(len, found.values()))} files of {len(found)} projects")


if __name__ == "__main__":
    main()
