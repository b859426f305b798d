"""The trace as a page of HTML and as Markdown."""

from codegen.render import render_page, render_template
from codegen.trace.view import TraceView


def trace_page(view: TraceView) -> str:
    """One file of HTML with the matrix of all criteria, to be filtered; it needs nothing beside it."""
    return render_page("trace/trace.html.j2", view)


def trace_markdown(view: TraceView) -> str:
    """The same as Markdown, for a pull request or a review."""
    return render_template("trace/trace.md.j2", view)
