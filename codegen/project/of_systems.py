"""Results of pure functions of systems, kept between runs under the hash of everything that makes the systems."""

from collections.abc import Callable
from typing import TypeVar, cast

from codegen.model.system import System
from codegen.tool.cache import entry, keep_object, kept_object, pickled
from codegen.tool.digest import tool_digest

_Made = TypeVar("_Made")


def of_systems(make: Callable[..., _Made], *systems: System) -> _Made:
    """Return what ``make`` returns for systems, which depends on nothing else, by this run or an earlier one.

    A system is made of the files of its specification and of its dialect. Of a dialect that had something to report no
    hash is known; then nothing is kept.
    """
    if not all(system.dialect.digest for system in systems):
        return make(*systems)
    name = entry(make.__module__, make.__qualname__, tool_digest(), pickled([_about(system) for system in systems]))
    known = kept_object(name)
    if known is not None:
        return cast(_Made, known)
    made = make(*systems)
    keep_object(name, made)
    return made


def _about(system: System) -> object:
    spec = system.spec
    return spec.program, spec.folder, spec.own_folder, sorted(spec.files.items()), system.dialect.digest
