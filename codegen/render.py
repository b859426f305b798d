"""Render: views and templates to text, in memory."""

from functools import cache
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined


def templates_folder() -> Path:
    """The folder of the templates: inside the package when it was installed, beside it in a checkout."""
    package = Path(__file__).parent
    installed = package / "templates"
    return installed if installed.is_dir() else package.parent / "templates"


def render_template(name: str, view: object) -> str:
    """The text of the template ``name`` (posix path below the templates) with ``view`` as its one variable, ``view``.

    A name that is not defined, a missing template or a fault in one is an error of codegen itself and raises jinja2's
    exception: no input leads there.
    """
    return _environment().get_template(name).render(view=view)


def plain_files(folder: str) -> tuple[str, ...]:
    """The names of the Python files of a template folder that go to the output as they stand."""
    return tuple(sorted(path.name for path in (templates_folder() / folder).glob("*.py")))


def copied(name: str) -> str:
    """The text of a file below the templates that goes to the output as it stands."""
    return (templates_folder() / name).read_bytes().decode("utf-8")


@cache
def _environment() -> Environment:
    # The output is Python, Markdown and JSON, never HTML: escaping would damage it.
    return Environment(
        loader=FileSystemLoader(templates_folder()),
        undefined=StrictUndefined,
        autoescape=False,  # noqa: S701
        keep_trailing_newline=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )
