"""Plans the removals and copies that give a board its files: a pure function of the files on the board."""

from collections.abc import Collection, Iterator, Mapping

from codegen.deploy.board import Found
from codegen.frozen import dataclass

MAIN = "main.py"
"""The file that a board starts by itself: it goes first and comes last."""
PART = "deploy.part"
"""The name of a file until it is whole."""
MANIFEST = "deployed.json"
"""The files that deploys have put there, with their hashes."""

Owned = Mapping[str, Collection[str]]
"""Files of earlier deploys: paths, with the hashes that each may have."""


@dataclass(frozen=True, slots=True)
class Removal:
    """A file that goes, and why. ``kept`` is its new name where it is not known to be generated."""

    path: str
    why: str
    kept: str | None = None


@dataclass(frozen=True, slots=True)
class Plan:
    """``removals`` in their order, main.py first; ``copies`` in theirs, main.py last. ``hidden`` are folders that hide.

    ``unchanged`` is how many files are there already.
    """

    removals: tuple[Removal, ...]
    copies: tuple[str, ...]
    hidden: tuple[str, ...]
    unchanged: int

    @property
    def is_empty(self) -> bool:
        """Return whether nothing has to be done."""
        return not self.removals and not self.copies


def of_interest(wanted: Collection[str], owned: Owned) -> list[str]:
    """The paths whose hashes have to be known."""
    return sorted({*wanted, *owned, *(source for path in wanted for source in _sources(path)), PART})


def plan(wanted: Mapping[str, str], found: Mapping[str, Found], owned: Owned) -> Plan:
    """Return what leads from ``found`` to ``wanted`` (paths with their hashes);
    folders in ``found`` end with a slash.
    """
    changed = [path for path in sorted(wanted) if path not in found or found[path].digest != wanted[path]]
    outdated = {path: "is outdated" for path in changed if path in found}
    hiding = {source: f"hides {path}" for path in sorted(wanted) for source in _sources(path) if source in found}
    strays = {
        path: "belongs no more"
        for path in sorted(owned)
        if path not in wanted and path in found and found[path].digest in owned[path]
    }
    unfinished = {PART: "was never finished"} if PART in found else {}
    reasons = strays | hiding | outdated | unfinished
    if MAIN in wanted and MAIN not in changed and (changed or hiding):
        reasons[MAIN] = "starts nothing until all is there"
        changed.append(MAIN)
    removals = [
        Removal(path, why, _free_name(path, found) if _is_somebodys(path, found[path], owned) else None)
        for path, why in reasons.items()
    ]
    return Plan(
        removals=tuple(sorted(removals, key=lambda each: each.path != MAIN)),
        copies=tuple(sorted(changed, key=lambda path: path == MAIN)),
        hidden=tuple(f"{path.removesuffix('.mpy')}/" for path in sorted(wanted) if _folder(path) in found),
        unchanged=len(wanted) - len(changed),
    )


def room_of(plan: Plan, sizes: Mapping[str, int], found: Mapping[str, Found], free: int, block: int) -> tuple[int, int]:
    """Return the bytes that the copies take, and those that are free once the removals are done, in whole blocks.

    ``sizes``, ``free`` and ``block`` are bytes.
    """
    need = sum(_blocks(sizes[path], block) for path in plan.copies)
    freed = sum(_blocks(found[each.path].size, block) for each in plan.removals if each.kept is None)
    return need + 4 * block, free + freed  # folders and the manifest take some


def _blocks(size: int, block: int) -> int:
    return -(-size // block) * block


def _sources(path: str) -> Iterator[str]:
    """Yield what MicroPython takes in place of a compiled module."""
    if path.endswith(".mpy"):
        yield f"{path.removesuffix('.mpy')}.py"


def _folder(path: str) -> str:
    return f"{path.removesuffix('.mpy').removesuffix('.py')}/"


def _is_somebodys(path: str, there: Found, owned: Owned) -> bool:
    """Return whether it may be the only copy of somebody's work."""
    return path.endswith(".py") and not there.is_made and there.digest not in owned.get(path, ())


def _free_name(path: str, found: Mapping[str, Found]) -> str:
    name, number = f"{path}.kept", 2
    while name in found:
        name, number = f"{path}.kept{number}", number + 1
    return name
