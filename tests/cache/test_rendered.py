"""The text of a template is kept under all that it depends on, and a build renders nothing else anew."""

import dataclasses
from collections.abc import Iterator
from pathlib import Path

import pytest

from codegen.commands.build import render_systems
from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import Dialect
from codegen.model.system import PopulatedMessage, System
from codegen.project.systems import read_systems
from codegen.render import rendered as kept_texts
from codegen.render import templates as render
from codegen.render.rendered import rendered, rendered_page
from codegen.targets import firmware, mocks, pages, receiver
from codegen.targets.documents import files as documents
from codegen.targets.origin import Origin
from codegen.targets.suite import files as suite
from codegen.targets.suite import program as program_suite
from codegen.tool import cache
from codegen.tool.cache import write_new
from codegen.trace import page

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True, slots=True)
class View:
    name: object
    parts: tuple[object, ...] = ()
    unseen: int = dataclasses.field(default=0, compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class Other:
    name: object
    parts: tuple[object, ...] = ()
    unseen: int = 0


def later_run() -> None:
    cache.cache_folder.cache_clear()
    cache._new.clear()


@pytest.fixture
def asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """Yield the list of what was rendered, in a cache of the test's own."""
    found: list[str] = []

    def text(way: str, template: str, view: object) -> str:
        found.append(f"{way} {template} {view!r}")
        return f"text {len(found)} \udcff"

    monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache"))
    for way in ("render_template", "render_page"):
        monkeypatch.setattr(render, way, lambda template, view, way=way: text(way, template, view))
    later_run()
    yield found
    later_run()


def test_a_later_run_renders_nothing_again(asked: list[str]) -> None:
    first = rendered("a.j2", View("a", ("b",)))
    write_new()
    later_run()
    assert rendered("a.j2", View("a", ("b",))) == first
    assert len(asked) == 1


DIFFERENT = [
    lambda: rendered("a.j2", View(1)),
    lambda: rendered("b.j2", View(1)),
    lambda: rendered_page("a.j2", View(1)),
    lambda: rendered("a.j2", View(2)),
    lambda: rendered("a.j2", View(1.0)),
    lambda: rendered("a.j2", View(True)),
    lambda: rendered("a.j2", View("1")),
    lambda: rendered("a.j2", Other(1)),
    lambda: rendered("a.j2", View(1, unseen=1)),
    lambda: rendered("a.j2", View(1, ("a",))),
    lambda: rendered("a.j2", View(1, (("a",),))),
    lambda: rendered("a.j2", View(0.0)),
    lambda: rendered("a.j2", View(-0.0)),
]
"""Texts that may differ: of other templates, in another way, of views that are not the same down to their types."""


def test_whatever_differs_is_rendered_by_itself(asked: list[str]) -> None:
    texts = [make() for make in DIFFERENT]
    assert len(set(texts)) == len(asked) == len(DIFFERENT)
    assert [make() for make in DIFFERENT] == texts


def test_another_codegen_renders_anew(asked: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """Its digest has all templates in it, so also those that another one includes."""
    for digest in ("one", "other", "one"):
        monkeypatch.setattr(kept_texts, "tool_digest", lambda digest=digest: digest)
        rendered("a.j2", View(1))
    assert len(asked) == 2


def test_a_text_is_closed_by_the_digest_of_its_inputs_once() -> None:
    origin = Origin(("specs/a.yaml",), "0123456789abcdef")
    text = f"From {', '.join(origin.open.sources)}: {origin.open.digest}\nand {origin.open.digest}"
    assert origin.closed(text).startswith("From specs/a.yaml: 0123456789abcdef\nand ")
    assert origin.closed(text).count(origin.digest) == 1
    assert origin.open == Origin(origin.sources, "other").open


def test_views_are_data_that_says_the_same_in_every_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A set has another order in each run, and whoever holds the system depends on all that was read.

    Files of a further program are kept as a whole: in a cache of the test's own, or others would find empty ones.
    """
    views: dict[str, object] = {}

    def noted(template: str, view: object) -> str:
        views[template] = view
        return ""

    monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache"))
    later_run()
    for module in (documents, firmware, mocks, pages, program_suite, receiver, suite, page):
        for name in {"rendered", "rendered_page"} & vars(module).keys():
            monkeypatch.setattr(module, name, noted)
    systems = read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())
    render_systems(systems)
    later_run()
    assert len(views) > 15
    kinds = {(template, kind) for template, view in views.items() for kind in _kinds(view)}
    plain = (str, int, float, type(None), tuple, list, dict)
    forbidden = {System, PopulatedMessage, Dialect}
    wrong = {
        f"{template}: {kind.__qualname__}"
        for template, kind in kinds
        if not issubclass(kind, plain) and (kind in forbidden or not dataclasses.is_dataclass(kind))
    }
    assert wrong == set()


def _kinds(value: object) -> Iterator[type]:
    yield type(value)
    if isinstance(value, tuple | list):
        for item in value:
            yield from _kinds(item)
    elif isinstance(value, dict):
        yield from _kinds(list(value.items()))
    elif dataclasses.is_dataclass(value):
        for each in dataclasses.fields(value):
            yield from _kinds(getattr(value, each.name))
