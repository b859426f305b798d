"""The texts of templates, kept from one run to the next under what their views say: an edit changes few of them."""

from codegen.tool.cache import entry, keep, kept, pickled
from codegen.tool.digest import tool_digest


def rendered(template: str, view: object) -> str:
    """The text of a template, as ``render_template`` makes it of a view that holds nothing but data."""
    return _rendered("render_template", template, view)


def rendered_page(template: str, view: object) -> str:
    """The same for a page of HTML, as ``render_page`` makes it."""
    return _rendered("render_page", template, view)


def _rendered(way: str, template: str, view: object) -> str:
    """The digest stands for all templates, and for what a view computes when it is asked."""
    name = entry("rendered", tool_digest(), way, template, pickled(view))
    known = kept(name)
    if known is not None:
        return known.decode("utf-8", "surrogatepass")
    from codegen.render import templates as render  # noqa: PLC0415  it imports Jinja, which takes longer than to look up all texts

    text: str = getattr(render, way)(template, view)
    keep(name, text.encode("utf-8", "surrogatepass"))
    return text
