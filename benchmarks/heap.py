"""The heap of the rover's and the boat's programs on a MicroPython whose words have 32 bits, as a board's."""

import json
import math
import os
import shutil
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import measure
from figure import Figure

from codegen.deploy.image import image_of
from codegen.diagnostics import Report
from codegen.emit.mpy import BYTECODE, STARTED, compiled

COMPARES = """The program of the rover with one link, and that of examples/boat with its modules, without machine
code, on a MicroPython 1.27 whose words have 32 bits as those of a board: compiled to WebAssembly, its collector made
sound (benchmarks/micropython32/prepare.py). The firmware is its source, or what `codegen deploy` copies, .mpy files and
main.py, or the same in a ROMFS, from which a MicroPython that has one runs .mpy files in place; the mocks are .mpy
files. A board has its ROMFS in the flash: what the image takes of the heap here is not counted.

Bytes in use are those beyond the mocks, after a collection. The smallest heap is the first of 64, 66, 68 ... KB in
which, and in the two next ones as well, the program is imported, starts and runs a simulated minute. It is the heap of
the program alone: no board has the mocks and the script, and `-X heapsize` has as much more as they hold before the
program is imported. What the program makes of the mocks counts as its own. The machine code of a board comes on top: it
stands in the next section. Asked rarely: then somebody lists, sets and resets parameters, sends each command, and asks
for missions, logs and modes, so that what is loaded only then finds room, too. `make test` lets the program run in the
heaps that stand here.

Names of the mocks share tables with those of the program. Where a table is full the next one has twice the room, 4.5 KB
or 9: a few names more or less may change what is in use by as much."""

SCRIPT, MOUNT = "rover_minute.py", "mount_rom.py"
FORMS = {"source": "from source", "mpy": "from .mpy", "rom": "in place from a ROMFS"}
IMAGE = "image.romfs"
MOMENTS = {"mocks": "the mocks", "imported": "program imported", "started": "program started"}
RARELY = "rarely"
NOTHING = "import gc; gc.collect(); print(gc.mem_alloc())"
STEP = 2  # KB from one heap that is tried to the next
LEAST, MOST = 64, 256
IN_A_ROW = 3  # heaps that have to do: a little more is no help where the free memory lies in pieces
GOALS = {"mpy": 96, "source": 128}  # KB, of the rover's program; the boat's needs no more than that


def figures(quick: bool) -> list[Figure]:
    """Let the programs run; a quick run takes no smaller heap than one that is enough."""
    found: list[Figure] = []
    for vehicle, put in VEHICLES.items():
        goals = GOALS if vehicle == "rover" else {"mpy": _value(found, "smallest_mpy")}
        with measure.scratch() as folder:
            put(folder)
            found += _figures_of(vehicle, folder, goals, quick)
    if any(figure.value is None for figure in found):
        raise SystemExit(f"a program does not run in a heap of {MOST} KB")
    return found


def _value(figures: list[Figure], key: str) -> float | None:
    return next(figure.value for figure in figures if figure.key == key)


def _figures_of(vehicle: str, folder: Path, goals: Mapping[str, float | None], quick: bool) -> list[Figure]:
    with ThreadPoolExecutor() as pool:
        used = dict(zip(FORMS, pool.map(lambda form: in_use(folder, form, MOST), FORMS), strict=True))
        # The heap in use once it has started does not fit into less.
        least = {form: (used[form] or {}).get("started", 0) // 1024 for form in FORMS}
        tried = pool.map(lambda form: MOST if quick else _smallest(folder, form, least[form]), FORMS)
        smallest = dict(zip(FORMS, tried, strict=True))
    against = "32-bit words"
    of, prefix = ("", "") if vehicle == "rover" else (f" of the {vehicle}", f"{vehicle}_")
    found = []
    for form, title in FORMS.items():
        for moment, what in MOMENTS.items():
            count = (used[form] or {}).get(moment)
            name = f"heap in use{of}: {what}, {title}"
            found.append(Figure(f"{prefix}{moment}_{form}", name, against, count, "bytes"))
    for form, title in FORMS.items():
        what = f"smallest heap in which it runs{of}, {title}"
        found.append(Figure(f"{prefix}smallest_{form}", what, against, smallest[form], "KB", most=goals.get(form)))
    found.append(Figure(f"{prefix}beside", f"held by the mocks and the script{of}", against, beside(folder), "KB"))
    asked = MOST if quick else _smallest(folder, "mpy", smallest["mpy"] or MOST, RARELY)
    what = f"smallest heap in which it runs{of} and is asked rarely, {FORMS['mpy']}"
    return [*found, Figure(f"{prefix}rarely_mpy", what, against, asked, "KB")]


def prepare(folder: Path, *, in_bundles: bool = True) -> None:
    """Put the rover's firmware into folders of a folder, named as its forms are, the mocks beside it, and the script.

    Names of files lie on the heap, too: within the folder they are the same everywhere. Without bundles each module is
    compiled on its own.
    """
    _lay_out(folder, measure.rover(folder / "project", machine_code=False), [], in_bundles=in_bundles)


def prepare_boat(folder: Path) -> None:
    """Do the same with examples/boat, whose own modules are part of its program."""
    generated = measure.without_machine_code(BOAT, folder / "project")
    _lay_out(folder, generated, sorted(BOAT.glob("*.py")))


def _lay_out(folder: Path, generated: Path, own: list[Path], *, in_bundles: bool = True) -> None:
    script, mount = (measure.HERE / "micropython" / name for name in (SCRIPT, MOUNT))
    shutil.copy(script, folder)
    (folder / MOUNT).write_text(mount.read_text() + script.read_text())
    shutil.copytree(generated / "firmware", folder / "source")
    for module in own:
        shutil.copy(module, folder / "source")
    own_texts = {SCRIPT: script.read_text(), **{module.name: module.read_text() for module in own}}
    files = _deployed(_texts(folder / "source"), own_texts, in_bundles=in_bundles)
    (folder / IMAGE).write_bytes(image_of(files))
    _put(folder / "mpy", files)
    _put(folder / "rom", {STARTED: files[STARTED]})
    _put(folder / "mocks", _deployed(_texts(generated / "mocks"), {}))


def _texts(folder: Path) -> dict[str, str]:
    """Return modules by their names, without those in machine code, which this interpreter does not run."""
    return {source.name: source.read_text() for source in folder.glob("*.py") if not source.stem.endswith("_viper")}


def _deployed(texts: Mapping[str, str], own: Mapping[str, str], *, in_bundles: bool = True) -> dict[str, str | bytes]:
    """Return what `codegen deploy` copies; the script, of which names are used, is treated as the user's own code.

    A program whose main.py is the user's has no bundles.
    """
    report = Report()
    users = {*own, *(() if in_bundles else (STARTED,))}
    files = compiled({**texts, **own}, BYTECODE, report, unnumbered=texts.keys() - users)
    if report.has_errors:
        raise SystemExit("mpy-cross does not compile the program")
    return {name: content for name, content in files.items() if name != SCRIPT.replace(".py", ".mpy")}


def _put(folder: Path, files: Mapping[str, str | bytes]) -> None:
    folder.mkdir()
    for name, content in files.items():
        (folder / name).write_bytes(content.encode() if isinstance(content, str) else content)


VEHICLES = {"rover": prepare, "boat": prepare_boat}
BOAT = measure.ROOT / "examples" / "boat"


def in_use(folder: Path, form: str, heap: int, *arguments: str) -> dict[str, int] | None:
    """Return what the script says in a heap of so many KB, or None: the program does not run in it.

    The heap is the program's: what no board has on it lies beside.
    """
    return _said(folder, form, heap * 1024 + _held(folder), *arguments)


def beside(folder: Path) -> int:
    """Return the whole KB that the mocks and the script hold before the program is imported."""
    return _held(folder) // 1024


@cache
def _held(folder: Path) -> int:
    alone = measure.said([measure.tool("micropython32"), "-X", f"heapsize={MOST}k", "-c", NOTHING], cwd=folder)
    held = _said(folder, "mpy", MOST * 1024, "held")
    if held is None:
        raise SystemExit(f"the mocks do not find room in {MOST} KB")
    return held["held"] - int(alone)


def _said(folder: Path, form: str, heap: int, *arguments: str) -> dict[str, int] | None:
    """Return what the script says in a heap of so many bytes, with the image of a ROMFS beside them."""
    image = image_size(folder) * 1024 if form == "rom" else 0
    script = MOUNT if image else SCRIPT
    command = [measure.tool("micropython32"), "-X", f"heapsize={heap + image}", script, *arguments]
    done = measure.ended(command, env={**os.environ, "MICROPYPATH": os.pathsep.join(("mocks", form))}, cwd=folder)
    if done.returncode and "MemoryError" not in done.stderr:
        raise SystemExit(f"the program ended by something else than a full heap:\n{done.stdout}{done.stderr}")
    if done.returncode:
        return None
    found: dict[str, int] = json.loads(done.stdout.splitlines()[-1])
    return found


def image_size(folder: Path) -> int:
    """The KB of the image for a ROMFS, which lies on the heap here."""
    return math.ceil((folder / IMAGE).stat().st_size / 1024)


def _smallest(folder: Path, form: str, least: int, *arguments: str) -> int | None:
    """Return the first heap from ``least`` KB on, of those that are tried, that is enough and the next ones as well."""
    in_a_row = 0
    for heap in range(max(LEAST, least // STEP * STEP), MOST + 1, STEP):
        in_a_row = in_a_row + 1 if in_use(folder, form, heap, *arguments) else 0
        if in_a_row == IN_A_ROW:
            return heap - (IN_A_ROW - 1) * STEP
    return None


if __name__ == "__main__":
    measure.run(COMPARES, figures)
