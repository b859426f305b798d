"""Every page is whole by itself: well-formed, escaped, without dead links, and in need of nothing from anywhere."""

import posixpath
import re
import shutil
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path

from lxml import html
from rendered import PROJECTS, ROOT, Program, programs_of

VOID = {"meta", "input", "br", "wbr"}


class Balance(HTMLParser):
    """Collects tags that are not closed in the order in which they were opened, and attributes that come twice."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.faults: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._look_at(attrs)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, _tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._look_at(attrs)

    def handle_endtag(self, tag: str) -> None:
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"</{tag}> at {self.getpos()}")

    def _look_at(self, attrs: list[tuple[str, str | None]]) -> None:
        names = [name for name, _ in attrs]
        if len(set(names)) < len(names):
            self.faults.append(f"{names} at {self.getpos()}")


def faults(page: str) -> list[str]:
    """Return the places of a page that are not well-formed."""
    parser = Balance()
    parser.feed(page)
    parser.close()
    return parser.faults + parser.open


def test_pages_are_well_formed(every: list[Program], longest: Program) -> None:
    found = [(path, faults(text)) for program in (*every, longest) for path, text in program.pages.items()]
    assert len(found) > 35
    assert [(path, wrong) for path, wrong in found if wrong] == []


def test_browsers_find_the_encoding(every: list[Program]) -> None:
    """They look for it in the first 1024 bytes, and a page may name all files of the specification in its head."""
    stored = {path.name: path.read_text("utf-8") for path in (ROOT / "generated").rglob("*.html")}
    pages = [stored, *(program.pages for program in every)]
    late = [path for named in pages for path, text in named.items() if b'charset="utf-8"' not in text.encode()[:1024]]
    assert late == []
    assert "trace.html" in stored


def test_the_check_of_the_form_bites() -> None:
    assert faults("<p><b>x</p></b>")
    assert faults("<p>")
    assert faults('<p id="a" id="b"></p>')
    assert faults('<p><br><svg><path d="M0 0"/></svg></p>') == []


def test_links_lead_somewhere_and_ids_are_unique(projects: dict[str, list[Program]]) -> None:
    """Files are those of the whole project, so that pages of one program lead to those of another."""
    dead = []
    for programs in projects.values():
        files = {path: text for program in programs for path, text in program.documents.items()}
        ids: dict[str, set[str]] = {}
        for path, text in files.items():
            if path.endswith(".html"):
                counted = Counter(html.document_fromstring(text).xpath("//@id"))
                assert max(counted.values()) == 1, f"{path}: {counted.most_common(1)}"
                ids[path] = set(counted)
        for path in ids:
            for href in html.document_fromstring(files[path]).xpath("//a/@href"):
                name, _, fragment = href.partition("#")
                target = posixpath.normpath(posixpath.join(posixpath.dirname(path), name)) if name else path
                if target not in files or (fragment and fragment not in ids[target]) or not (name or fragment):
                    dead.append(f"{path}: {href}")
    assert dead == []


def test_every_page_is_reached_from_the_overview(shipped: list[Program]) -> None:
    for program in shipped:
        hrefs = set(program.page("index.html").xpath("//a/@href"))
        front = posixpath.join(program.folder, "docs/")
        assert {path.removeprefix(front) for path in program.pages} <= hrefs


def test_pages_need_nothing_from_anywhere(every: list[Program]) -> None:
    for program in every:
        for path, text in program.pages.items():
            assert not re.search(r"https?:|\bsrc=|url\((?!#)|@import|<link|<iframe|fetch\(|import\(", text), path


def test_pages_say_nothing_of_the_machine(every: list[Program]) -> None:
    """No path of it and no date: the same input makes the same bytes everywhere."""
    for program in every:
        for path, text in program.pages.items():
            assert str(ROOT) not in text, path
            assert not re.search(r"\b20[2-9]\d-\d\d-\d\d\b", text), path


def test_pages_stay_small(shipped: list[Program]) -> None:
    """They are committed, and read on phones.

    The largest has all criteria with what comes of them, and the places where its names may break.
    """
    sizes = {path: len(text) for program in shipped for path, text in program.pages.items()}
    assert max(sizes.values()) < 290_000
    assert sum(sizes.values()) < 1_600_000


def test_what_a_specification_says_is_text_and_never_markup(tmp_path: Path) -> None:
    """Names and texts of people come through as they are, in every page that has them."""
    hostile = "<script>alert(1)</script> & \"quotes\" 'too' </title> <!-- x -->"
    shutil.copytree(PROJECTS["radio_rover"], tmp_path / "specs")
    (document,) = (tmp_path / "specs/requirements").glob("*.md")
    lines = document.read_text().split("\n")
    first = next(index for index, line in enumerate(lines) if line.startswith("1. "))
    lines[first] += " `" + hostile + "`"
    document.write_text("\n".join(lines))
    project = tmp_path / "specs/codegen.yaml"
    project.write_text(re.sub(r"^project: .*$", 'project: "<i>x</i>&amp;"', project.read_text(), flags=re.M))
    (program,) = programs_of(tmp_path / "specs")
    for path, text in program.pages.items():
        page = html.document_fromstring(text)
        assert faults(text) == [], path
        assert len(page.xpath("//script")) <= 1, path
        assert not page.xpath("//i[text()='x']"), path
        assert "<i>x</i>&amp;" in page.findtext("head/title"), path
    assert hostile in program.page("index.html").text_content()
