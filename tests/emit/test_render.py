"""Templates become text exactly as they are laid out, and a name that nobody set is never silently empty."""

from pathlib import Path
from types import SimpleNamespace

import pytest
from jinja2 import UndefinedError

from codegen.render import templates as render
from codegen.render.templates import render_template
from codegen.tool import template_files
from codegen.tool.template_files import copied, filled, templates_folder

FOLDER = Path(templates_folder())
TEMPLATES = sorted(path.relative_to(FOLDER).as_posix() for path in FOLDER.rglob("*.j2"))


@pytest.fixture
def templates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A template folder of the test's own."""
    for module in (render, template_files):
        monkeypatch.setattr(module, "templates_folder", lambda: str(tmp_path))
    monkeypatch.setattr(template_files, "_template", template_files._template.__wrapped__)
    monkeypatch.setattr(render, "_environment", render._environment.__wrapped__)
    return tmp_path


def test_templates_of_the_checkout_are_found() -> None:
    assert (FOLDER / "firmware").is_dir()


def test_lines_of_the_template_language_leave_no_trace(templates: Path) -> None:
    (templates / "a.py.j2").write_text(
        "{% for x in view.names %}\n    {% if x %}\n  {{ x }} = '<&>'\n    {% endif %}\n{% endfor %}\n"
    )
    assert render_template("a.py.j2", SimpleNamespace(names=["a", "", "b"])) == "  a = '<&>'\n  b = '<&>'\n"


def test_text_stays_as_the_view_and_the_template_have_it(templates: Path) -> None:
    """The output is not HTML, and its last line end is part of it."""
    (templates / "a.py.j2").write_text("{{ view.text }}\n")
    assert render_template("a.py.j2", SimpleNamespace(text="a < b and '&'")) == "a < b and '&'\n"


@pytest.mark.parametrize("text", ["{{ view.missing }}", "{{ missing }}", "{% if view.missing %}{% endif %}",
                                  "{% for x in view.missing %}{% endfor %}"])  # fmt: skip
def test_a_name_that_is_not_there_raises(templates: Path, text: str) -> None:
    (templates / "a.j2").write_text(text)
    with pytest.raises(UndefinedError):
        render_template("a.j2", SimpleNamespace(there=1))


def test_a_plain_file_is_copied_to_the_byte(templates: Path) -> None:
    (templates / "a.py").write_bytes("µ = '{{ x }}'\r\n".encode())
    assert copied("a.py") == "µ = '{{ x }}'\r\n"


def test_names_are_filled_in_and_a_missing_one_raises(templates: Path) -> None:
    (templates / "a.py.in").write_text("$name = '$text'  # $$5\n")
    assert filled("a.py.in", {"name": "x", "text": "$name"}) == "x = '$name'  # $5\n"
    with pytest.raises(KeyError):
        filled("a.py.in", {"name": "x"})


@pytest.mark.parametrize("name", TEMPLATES)
def test_every_template_of_the_project_can_be_compiled(name: str) -> None:
    """Also those that the shipped specification never asks for."""
    assert render._environment().get_template(name)
