"""The code of the project's own drivers: it is copied into the firmware, and no attribute says what it does."""

from collections.abc import Iterator
from hashlib import sha256
from os.path import basename, splitext

from codegen.diff.change import Change, changed
from codegen.diff.system.behaviour_rules import DRIVER_CODE
from codegen.diff.system.subject import cited
from codegen.model.quantities.source_kind import Source
from codegen.model.system import System
from codegen.source import Place

_DOUBT = "whether it still gives the same numbers, at the same times"


def driver_changes(old: System, new: System) -> Iterator[Change]:
    """Yield the drivers of both versions whose modules differ, by what else than the ends of lines."""
    before, after = _modules(old), _modules(new)
    for name, (path, text, sources) in after.items():
        known = before.get(name)
        if known is None or known[1] == text:
            continue
        sensors = [source.name for source in sources]
        was, now = (
            f"{len(each.splitlines())} lines, SHA-256 {sha256(each.encode()).hexdigest()[:12]}"
            for each in (known[1], text)
        )
        yield changed(
            DRIVER_CODE,
            f"driver {name}",
            was,
            now,
            (Place(known[0], 1, 1), Place(path, 1, 1)),
            f"the code that reads {', '.join(sensors)} is another one",
            doubt=_DOUBT,
            cited=dict.fromkeys(
                each for source in sources for each in cited(source.polling.citation, source.polling.aspects)
            ),
            rows=(*sensors, *_given_by(sensors, old), *_given_by(sensors, new)),
        )


def _modules(system: System) -> dict[str, tuple[str, str, list[Source]]]:
    """The path and the text of each module, by its name, with the sensors that it reads."""
    found: dict[str, tuple[str, str, list[Source]]] = {}
    for source in system.sources.values():
        for path, text in source.own_modules.items():
            name = splitext(basename(path))[0]
            found.setdefault(name, (path, "\n".join(text.splitlines()), []))[2].append(source)
    return found


def _given_by(sensors: list[str], system: System) -> Iterator[str]:
    """The quantities that sensors give."""
    for component in system.components.values():
        for quantity in component.quantities.values():
            if any(name.partition(".")[0] in sensors for name, _, _ in quantity.derivation.gives):
                yield quantity.path
