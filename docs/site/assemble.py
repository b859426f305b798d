"""Puts the pages of the site and all that they link to into one folder, each file where the repository has it.

So a link that holds in the repository holds on the site. A folder that a page links to gets a page with its files.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE", "docs/*.md", "docs/*.svg", "generated/docs/**/*")
LINK = re.compile(r"(?:\]\(|^\[[^\]]+\]: )([^)#:\s]+)", re.MULTILINE)


def assemble(target: Path) -> None:
    """Write the folder that mkdocs.yml names anew."""
    shutil.rmtree(target, ignore_errors=True)
    waiting = {path for pattern in PAGES for path in ROOT.glob(pattern) if path.is_file()}
    done: set[Path] = set()
    while waiting:
        path = waiting.pop()
        done.add(path)
        copy = target / path.relative_to(ROOT)
        if path.name == "index.md":
            text = _listing(path.parent)
            waiting |= set(_files(path.parent)) - done
        elif path.suffix == ".md":
            text = path.read_text(encoding="utf-8")
            waiting |= {found for found in _linked(path, text) if found not in done}
        else:
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, copy)
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(_with_pages_of_folders(path, text), encoding="utf-8")


def _linked(page: Path, text: str) -> set[Path]:
    """What a page links to in the repository and is there; mkdocs tells of the rest."""
    found = {(page.parent / target).resolve() for target in LINK.findall(text)}
    found = {_page_of(path) if path.is_dir() else path for path in found}
    return {path for path in found if path.is_relative_to(ROOT) and (path.exists() or path.name == "index.md")}


def _page_of(folder: Path) -> Path:
    """Its README, or else the page that lists it."""
    read_me = folder / "README.md"
    return read_me if read_me.exists() else folder / "index.md"


def _with_pages_of_folders(page: Path, text: str) -> str:
    """A link to a folder leads to the page that lists it."""

    def lead(link: re.Match[str]) -> str:
        folder = page.parent / link[1]
        if not folder.is_dir():
            return link[0]
        return link[0].replace(link[1], f"{link[1].rstrip('/')}/{_page_of(folder).name}")

    return LINK.sub(lead, text)


def _files(folder: Path) -> list[Path]:
    """The files of a folder that the repository has, and that are to be read."""
    command = ["git", "ls-files", "-z", "--", str(folder)]
    listed = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.split("\0")
    return [ROOT / name for name in sorted(listed) if name and not Path(name).name.startswith(".")]


def _listing(folder: Path) -> str:
    name = folder.relative_to(ROOT).as_posix()
    rows = [
        f"- [{path.relative_to(folder).as_posix()}]({path.relative_to(folder).as_posix()})" for path in _files(folder)
    ]
    return "\n".join([f"# {name}", "", *rows, ""])


if __name__ == "__main__":
    assemble(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "site" / "source")
