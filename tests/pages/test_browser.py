"""The committed pages in a real browser: no error, every width, dark and light, and all of it by keyboard.

Chromium is what `make test` finds or installs. Without one these tests fail: a check that did not run proves nothing.
"""

import contextlib
import io
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import pytest
from playwright.sync_api import Browser, Page, sync_playwright
from rendered import ROOT, Program

from codegen.cli import main

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
"""Names of the browser, as in the Makefile."""
OPTIONS = [
    *("--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"),
    *("--disable-component-update", "--disable-sync"),
]
PAGES = sorted((ROOT / "generated").rglob("*.html"))
SCHEMES: tuple[Literal["light", "dark"], ...] = ("light", "dark")
WIDTHS = (320, 400, 768, 1024, 1280, 1920)
NARROW_AND_WIDE = (320, 1024)
FIRST = ROOT / "generated/docs"
MESSAGE = FIRST / "messages/battery_status.html"
OVERVIEW = FIRST / "index.html"

TOO_WIDE = """() => {
  const inBox = (element) => element.closest(".scroll, pre") || element.closest("svg") !== null;
  return [...document.body.querySelectorAll("*")]
    .filter((element) => !inBox(element) && element.getBoundingClientRect().right > innerWidth + 1)
    .map((element) => element.outerHTML.slice(0, 80));
}"""

CLIPPED = """() => [...document.querySelectorAll(".scroll:not(.drawing), th, td, dd, p, h1, h2, summary, label")]
  .filter((box) => box.getClientRects().length && box.scrollWidth > box.clientWidth + 1)
  .map((box) => `${box.scrollWidth - box.clientWidth} px hidden of ${box.outerHTML.slice(0, 80)}`)"""
"""Content that does not fit into its box; a drawing of the wiring may be moved in its own."""

BROKEN = """() => {
  const found = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const range = document.createRange();
  const lines = () => new Set([...range.getClientRects()].map((box) => Math.round(box.top))).size;
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (!node.data.trim() || node.parentElement.closest("svg, pre, script, style, .hexdump")) continue;
    range.selectNodeContents(node);
    if (lines() < 2) continue;
    for (const word of node.data.matchAll(/\\w+(-\\d[\\d.]*)?/g)) {
      range.setStart(node, word.index);
      range.setEnd(node, word.index + word[0].length);
      if (lines() > 1) found.push(`${word[0]} is broken`);
    }
  }
  return found;
}"""
"""Words, also those that names are made of, with letters on two lines."""

OVERLAPS = """() => [...document.querySelectorAll("svg, .scale")].flatMap((svg) => {
  const boxes = [...svg.querySelectorAll("text, span")].map((text) => [text.textContent, text.getBoundingClientRect()]);
  const frame = svg.getBoundingClientRect();
  if (!frame.width) return [];
  const found = boxes.filter(([, box]) => box.left < frame.left - 1.5 || box.right > frame.right + 1.5)
    .map(([text]) => `${text} leaves its drawing`);
  boxes.forEach(([text, box], index) => boxes.slice(index + 1).forEach(([other, next]) => {
    const wide = Math.min(box.right, next.right) - Math.max(box.left, next.left);
    const high = Math.min(box.bottom, next.bottom) - Math.max(box.top, next.top);
    if (wide > 1 && high > 4) found.push(`${text} lies on ${other}`);
  }));
  return found;
})"""

FAINT = """() => {
  const parse = (colour) => (colour.match(/[\\d.]+/g) || []).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((c) => c / 255)
    .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, index) => sum + c * [0.2126, 0.7152, 0.0722][index], 0);
  const ground = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const colour = parse(getComputedStyle(at).backgroundColor);
      if (colour.length === 3 || colour[3] === 1) return colour;
    }
    return [255, 255, 255];
  };
  const ratio = (one, other) => {
    const [high, low] = [light(one), light(other)].sort((a, b) => b - a);
    return (high + 0.05) / (low + 0.05);
  };
  const found = [];
  for (const element of document.body.querySelectorAll("*:not(script)")) {
    const hasText = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
    if (!hasText || !element.getClientRects().length) continue;
    const style = getComputedStyle(element);
    const cell = element.matches("g > text") ? element.parentElement.querySelector("rect, circle") : null;
    const under = cell && getComputedStyle(cell).fill !== "none" ? parse(getComputedStyle(cell).fill) : ground(element);
    const colour = parse(element.namespaceURI.endsWith("svg") ? style.fill : style.color);
    const reached = ratio(colour, under);
    if (reached < 4.5) found.push(`${reached.toFixed(2)} ${element.outerHTML.slice(0, 60)}`);
  }
  return found;
}"""


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """One browser for all tests."""
    found = next((path for name in NAMES if (path := shutil.which(name))), None)
    if found is None:
        pytest.fail(f"no browser: install Chromium (apt-get install chromium); looked for {', '.join(NAMES)}")
    with sync_playwright() as play:
        started = play.chromium.launch(executable_path=found, args=OPTIONS, timeout=90_000)
        yield started
        started.close()


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """A new page, which may complain of nothing and ask nobody for anything."""
    opened = browser.new_page(viewport={"width": 1280, "height": 900}, color_scheme="light")
    complaints: list[str] = []
    opened.on("console", lambda message: complaints.append(f"{message.type}: {message.text}"))
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    opened.on("request", lambda request: request.url.startswith("file:") or complaints.append(request.url))
    yield opened
    opened.close()
    assert complaints == []


@pytest.fixture(scope="module")
def reports(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Pages that commands write in the same look: a simulation, the trace, reviews of projects and of a dialect."""
    folder = tmp_path_factory.mktemp("reports")
    names = ("simulation.html", "trace.html", "review.html", "dialect.html")
    simulated, traced, compared, of_dialect = (folder / name for name in names)
    (release,) = (Path(sys.prefix) / "releases").glob("pymavlink-*.whl")
    options = ["--speed", "max", "--duration", "20", "--quiet", "--out", "udp:127.0.0.1:9"]
    output = io.StringIO()
    with contextlib.chdir(ROOT), contextlib.redirect_stdout(output):
        assert main(["sim", "critical", *options, "--report", str(simulated)]) == 0
        output.truncate(0)
        output.seek(0)
        assert (
            main(["diff", "tests/projects/minimal/specs", "tests/projects/radio_rover/specs", "--format", "html"]) == 1
        )
        compared.write_text(output.getvalue(), encoding="utf-8")
        output.truncate(0)
        output.seek(0)
        assert main(["diff", f"{release}:common", "--format", "html"]) == 1
        assert main(["trace", "--format", "html", "--out", str(traced)]) == 0
    of_dialect.write_text(output.getvalue(), encoding="utf-8")
    return [simulated, traced, compared, of_dialect]


def show(page: Page, path: Path) -> None:
    page.goto(path.as_uri())


def test_there_are_pages() -> None:
    assert len(PAGES) > 20
    assert {MESSAGE, OVERVIEW, FIRST / "bandwidth.html"} <= set(PAGES)


def test_no_page_scrolls_sideways_breaks_a_name_or_hides_anything(page: Page, reports: list[Path]) -> None:
    """In windows from the narrowest phone to a wide screen: tables become cards, and names break between their words.

    Pages of further programs are like those of the first one, and are looked at in two of these, as are reviews.
    """
    found = []
    for path in (*PAGES, *reports):
        show(page, path)
        for width in WIDTHS if path in reports[:2] or FIRST in path.parents else NARROW_AND_WIDE:
            page.set_viewport_size({"width": width, "height": 900})
            wide = page.evaluate("document.documentElement.scrollWidth")
            found += [(path.name, width, page.evaluate(TOO_WIDE))] if wide > width else []
            found += [(path.name, width, fault) for fault in page.evaluate(CLIPPED)]
            if width in NARROW_AND_WIDE:
                found += [(path.name, width, fault) for fault in page.evaluate(BROKEN)]
            if width in (WIDTHS[0], WIDTHS[-1]):
                found += [(path.name, width, fault) for fault in page.evaluate(OVERLAPS)]
    assert found == []


def test_text_stands_out_in_dark_and_in_light(page: Page, reports: list[Path]) -> None:
    """4.5 to 1 at least, as WCAG 2.2 asks for (1.4.3), on a page of each kind and on fields of each kind."""
    fields = [FIRST / f"messages/{name}.html" for name in ("battery_status", "battery_status_v2", "battery_info")]
    found = []
    for path in (*sorted(FIRST.glob("*.html")), *fields, *reports):
        show(page, path)
        for scheme in SCHEMES:
            page.emulate_media(color_scheme=scheme)
            found += [(path.name, scheme, fault) for fault in page.evaluate(FAINT)]
    assert found == []


def test_dark_is_dark_and_light_is_light(page: Page) -> None:
    show(page, OVERVIEW)
    sums = []
    for scheme in SCHEMES:
        page.emulate_media(color_scheme=scheme)
        ground = page.evaluate("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)")
        sums.append(sum(ground[:3]))
    assert sums[0] > 600
    assert sums[1] < 150


def test_payloads_of_255_bytes_fit_a_phone(page: Page, longest: Program, tmp_path: Path) -> None:
    for name in ("logging_data", "file_transfer_protocol"):
        path = tmp_path / f"{name}.html"
        path.write_text(longest.pages[f"docs/messages/{name}.html"], encoding="utf-8")
        show(page, path)
        page.set_viewport_size({"width": 320, "height": 700})
        assert page.evaluate("document.documentElement.scrollWidth") == 320
        assert page.evaluate(OVERLAPS) == []


def test_the_keyboard_reaches_everything_in_order(page: Page) -> None:
    """Each tab stop comes after the one before it, can be seen, and shows that it has the focus."""
    for path in (MESSAGE, FIRST / "bandwidth.html"):
        show(page, path)
        wanted = page.evaluate(
            "[...document.querySelectorAll('a, input, summary, [tabindex=\"0\"]')]"
            ".filter((e) => e.getClientRects().length && (e.type !== 'radio' || e.checked)).length"
        )
        seen = []
        for _ in range(wanted):
            page.keyboard.press("Tab")
            seen.append(page.evaluate(FOCUSED))
        assert [stop for stop in seen if not stop["isMarked"]] == []
        order = [stop["index"] for stop in seen]
        assert order == sorted(order)
        assert len(set(order)) == wanted


FOCUSED = """() => {
  const focused = document.activeElement;
  const style = getComputedStyle(focused);
  const cell = focused.matches(".piece") ? getComputedStyle(focused.querySelector("rect")) : null;
  const box = focused.getBoundingClientRect();
  return {
    index: [...document.querySelectorAll("*")].indexOf(focused),
    name: focused.outerHTML.slice(0, 60),
    isMarked: box.bottom > 0 && box.right > 0 && parseFloat(cell ? cell.strokeWidth : style.outlineWidth) >= 2
      && (cell !== null || style.outlineStyle !== "none"),
  };
}"""


def test_the_first_stop_skips_the_navigation(page: Page) -> None:
    show(page, OVERVIEW)
    page.keyboard.press("Tab")
    page.wait_for_function("document.activeElement.getBoundingClientRect().top >= 0")
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.closest('main') !== null")


def test_the_messages_open_by_keyboard(page: Page) -> None:
    show(page, OVERVIEW)
    page.locator(".pages summary").focus()
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    page.wait_for_url("**/messages/*.html")
    assert page.locator("h1").inner_text().endswith("HEARTBEAT")


def test_tables_are_filtered_by_keyboard(page: Page) -> None:
    show(page, OVERVIEW)
    rows = page.locator("#parameter-table tbody tr:visible")
    every = rows.count()
    page.keyboard.press("/")
    page.keyboard.type("batt2 volt")
    assert 0 < rows.count() < every
    assert all("BATT2" in text and "volt" in text.lower() for text in rows.all_inner_texts())
    output = page.locator("#parameters output")
    assert output.inner_text() == f"{rows.count()} of {every} rows"
    page.keyboard.press("Escape")
    assert (rows.count(), output.inner_text()) == (every, f"{every} rows")
    page.keyboard.press("Tab")
    page.keyboard.press("Space")
    marked = page.locator("#parameter-table tbody tr[data-tags]").count()
    assert rows.count() == marked < every
    page.keyboard.press("Space")
    assert rows.count() == every
    page.keyboard.press("/")
    page.keyboard.type("no such row")
    assert (rows.count(), output.inner_text()) == (0, f"0 of {every} rows")


def test_a_map_is_read_by_keyboard(page: Page) -> None:
    """One tab stop for all bytes, arrows between them, and another state by the arrows of its choice."""
    show(page, MESSAGE)
    maps = page.locator(".map:visible")
    assert maps.count() == 1
    assert maps.locator(".piece[tabindex='0']").count() == 1
    maps.locator(".piece[tabindex='0']").focus()
    readout = maps.locator(".readout")
    assert readout.inner_text().startswith("start, 1 byte")
    for _ in range(11):
        page.keyboard.press("ArrowRight")
    assert readout.inner_text().startswith("voltages[0], uint16_t, bytes 10 to 11: e0 2e = 12000 mV")
    page.keyboard.press("End")
    assert readout.inner_text().startswith("signature, 6 bytes")
    page.keyboard.press("Home")
    assert readout.inner_text().startswith("start, 1 byte")
    assert maps.locator(".piece[tabindex='0']").count() == 1
    page.locator("input[name=state]").first.focus()
    page.keyboard.press("ArrowDown")
    assert page.locator(".map:visible").get_attribute("id") == "state-2"


def test_pointing_at_a_byte_tells_of_it(page: Page) -> None:
    show(page, MESSAGE)
    page.locator("#state-1 .piece", has_text="voltages[0]").hover()
    assert "12000 mV" in page.locator("#state-1 .readout").inner_text()


def test_pages_are_read_without_scripts_and_on_paper(browser: Browser) -> None:
    """All states are shown, no control that does nothing; the navigation is not printed."""
    context = browser.new_context(java_script_enabled=False)
    opened = context.new_page()
    show(opened, MESSAGE)
    assert opened.locator(".map:visible").count() == 3
    assert opened.locator(".filter:visible, .states:visible").count() == 0
    opened.emulate_media(media="print")
    assert opened.locator(".pages:visible").count() == 0
    assert opened.locator(".map:visible").count() == 3
    context.close()
