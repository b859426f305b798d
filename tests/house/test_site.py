"""The site of docs/ builds without a warning: every link and every anchor leads somewhere, no page is left out."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from lxml import html

ROOT = Path(__file__).resolve().parents[2]
SETTINGS = ROOT / "docs" / "site" / "mkdocs.yml"
BIN = Path(sys.executable).parent


def build(folder: Path) -> "subprocess.CompletedProcess[str]":
    """Build what was put together in a folder, as `make docs` does."""
    settings = folder / "mkdocs.yml"
    text = SETTINGS.read_text(encoding="utf-8")
    text = re.sub("^docs_dir: .*", f"docs_dir: {folder / 'source'}", text, flags=re.MULTILINE)
    settings.write_text(re.sub("^site_dir: .*", f"site_dir: {folder / 'pages'}", text, flags=re.MULTILINE))
    command = [str(BIN / "mkdocs"), "build", "--strict", "--config-file", str(settings)]
    environment = {**os.environ, "NO_MKDOCS_2_WARNING": "true"}
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    subprocess.run([sys.executable, str(ROOT / "docs/site/assemble.py"), str(folder / "source")], check=True)
    done = build(folder)
    assert (done.returncode, "WARNING" in done.stderr) == (0, False), done.stderr
    return folder


def test_every_page_is_in_the_navigation(site: Path) -> None:
    """Each page of docs/ is one of the site; each has a heading."""
    listed = str(yaml.safe_load(SETTINGS.read_text())["nav"])
    for page in sorted((ROOT / "docs").glob("*.md")):
        assert f"'docs/{page.name}'" in listed, page.name
        shown = html.document_fromstring((site / "pages/docs" / f"{page.stem}.html").read_bytes())
        assert shown.findtext(".//h1"), page.name


def test_the_site_needs_nothing_from_elsewhere(site: Path) -> None:
    """No font and no script of another host: pages open from the disk."""
    page = html.document_fromstring((site / "pages" / "index.html").read_bytes())
    for address in page.xpath("//script/@src | //link[@rel='stylesheet']/@href | //img/@src"):
        assert "//" not in address, address
        assert (site / "pages" / address.partition("?")[0]).exists(), address


def test_a_dead_link_fails(site: Path) -> None:
    """To a page, to a heading, to a file of the repository: or the test above shows nothing."""
    page = site / "source/docs/platforms.md"
    text = page.read_text()
    page.write_text(text + "\n[a](nothing.md) [b](rover.md#nothing) [c](../specs/nothing.yaml)\n")
    done = build(site)
    page.write_text(text)
    assert done.returncode == 1
    assert all(name in done.stderr for name in ("nothing.md", "#nothing", "nothing.yaml"))
