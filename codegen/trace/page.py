"""The trace as a page of HTML and as Markdown."""

from collections.abc import Sequence

from codegen.findings.comment import fitting
from codegen.frozen import dataclass
from codegen.model.system import System
from codegen.render.rendered import rendered_page
from codegen.targets.origin import Origin, origin_of
from codegen.targets.pages.navigation import TRACE_PAGE, Navigation, navigation
from codegen.trace.view import TraceView


@dataclass(frozen=True, slots=True)
class TracePage:
    """The page: one among others of a project, or a report that stands alone."""

    trace: TraceView
    navigation: Navigation | None
    origin: Origin | None


def trace_report(view: TraceView) -> str:
    """One file of HTML with the matrix of all criteria, to be filtered; it needs nothing beside it."""
    from codegen.render.templates import render_page  # noqa: PLC0415  a build that finds the page in the cache has no use for Jinja

    return render_page("trace/trace.html.j2", TracePage(view, None, None))


def trace_markdown(view: TraceView) -> str:
    """The same as Markdown, for a pull request or a review: what needs attention first, and no more than one takes."""
    from codegen.render.templates import render_template  # noqa: PLC0415

    where = "`codegen trace --format html --out trace.html` writes a page with all."
    return fitting(render_template("trace/trace.md.j2", view), "criteria", where)


def render_trace(systems: Sequence[System], view: TraceView) -> dict[str, str]:
    """The page below ``docs/`` of a project, which has what all of its programs do."""
    origin = origin_of(systems[0], systems[0].spec.files)
    page = TracePage(view, navigation(systems[0], TRACE_PAGE), origin.open)
    return {f"docs/{TRACE_PAGE}": origin.closed(rendered_page("trace/trace.html.j2", page))}
