"""Pages for reviewers: what is sent byte by byte, where it comes from, what it costs. Each opens from disk alone."""

from codegen.model.system import System
from codegen.render.rendered import rendered_page
from codegen.targets.origin import origin_of, specification_file
from codegen.targets.pages.bandwidth import bandwidth_page
from codegen.targets.pages.message import message_page
from codegen.targets.pages.navigation import (
    PROGRAM_PAGE,
    WIRING_DRAWING,
    WIRING_PAGE,
    is_wired,
    message_path,
    takes_anything,
)
from codegen.targets.pages.overview import overview_page
from codegen.targets.pages.program import program_page
from codegen.targets.pages.wiring import wiring_view


def render_pages(system: System) -> dict[str, str]:
    """The files below ``docs/`` that browsers open."""
    names = ("codegen", "state", "board", "parameters", "streams", "vehicle")
    shared = [path for name in names if (path := specification_file(system, f"{name}.yaml")) in system.spec.files]
    files = {}
    cited: set[str] = set()
    for message in system.messages:
        own = [message.population.place.file, message.citation.requirement.place.file]
        origin = origin_of(system, [*shared, *own], [message.wire])
        page = message_page(message, system, origin.open)
        cited |= {name for field in page.fields for step in field.steps for name in step.criteria}
        files[f"docs/{message_path(message.name)}"] = origin.closed(rendered_page("pages/message.html.j2", page))
    wires = [message.wire for message in system.messages]
    tables = [message.population.place.file for message in system.messages]
    origin = origin_of(system, [*shared, *tables], wires)
    bandwidth = bandwidth_page(system, origin.open)
    files["docs/bandwidth.html"] = origin.closed(rendered_page("pages/bandwidth.html.j2", bandwidth))
    origin = origin_of(system, system.spec.files, [*wires, *(table.wire for table in system.receptions)])
    if takes_anything(system):
        program = program_page(system, origin.open)
        files[f"docs/{PROGRAM_PAGE}"] = origin.closed(rendered_page("pages/program.html.j2", program))
    if is_wired(system):
        origin = origin_of(system, shared)
        wiring = wiring_view(system, origin.open)
        files[f"docs/{WIRING_PAGE}"] = origin.closed(rendered_page("pages/wiring.html.j2", wiring))
        files[f"docs/{WIRING_DRAWING}"] = origin.closed(rendered_page("pages/drawing.svg.j2", wiring))
    origin = origin_of(system, system.spec.files, wires)
    overview = overview_page(system, origin.open, cited)
    files["docs/index.html"] = origin.closed(rendered_page("pages/overview.html.j2", overview))
    return files
