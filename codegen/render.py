"""Render: views and templates to text, in memory."""

from functools import cache

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from codegen.template_files import templates_folder


def render_template(name: str, view: object) -> str:
    """The text of the template ``name`` (posix path below the templates) with ``view`` as its one variable, ``view``.

    A name that is not defined, a missing template or a fault in one is an error of codegen itself and raises jinja2's
    exception: no input leads there.
    """
    return _environment().get_template(name).render(view=view)


def render_page(name: str, view: object) -> str:
    """The same for a page of HTML: whatever the view says is text of the page and never markup."""
    return _environment(is_escaping=True).get_template(name).render(view=view)


@cache
def _environment(*, is_escaping: bool = False) -> Environment:
    # Python, Markdown and JSON would be damaged by escaping.
    return Environment(
        loader=FileSystemLoader(templates_folder()),
        undefined=StrictUndefined,
        autoescape=is_escaping,  # noqa: S701
        keep_trailing_newline=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )
