"""The links that take nothing of what a simulated ground station sends, since nobody signs it."""

from codegen.model.scenario import GROUND_STATION
from codegen.model.system import System


def deaf_links(system: System) -> tuple[str, ...]:
    """Return the names of those that are signed, or listed without that station, in the order of the board."""
    access = system.program.access if system.program else None
    return tuple(link.name for link in system.links if access and not access.hears(link.name, GROUND_STATION))


def bridged_link(system: System) -> str | None:
    """Return the first cable that takes what nobody signs, else the first of all; None without one."""
    cables = [link.name for link in system.links if not link.kind.is_wireless]
    deaf = deaf_links(system)
    return next((name for name in cables if name not in deaf), cables[0] if cables else None)


def spoken_cable(system: System) -> str | None:
    """Return the cable by which a scenario speaks to a board whose network takes nothing; None where there is none."""
    deaf = deaf_links(system)
    wireless = [link.name for link in system.links if link.kind.is_wireless]
    if not wireless or not set(wireless) <= set(deaf):
        return None
    return next((link.name for link in system.links if link.name not in deaf), None)
