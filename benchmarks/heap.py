"""How much heap the rover's program takes on a MicroPython whose words have 32 bits, as those of a board."""

import json
import os
import shutil
from pathlib import Path

import measure
from figure import Figure

COMPARES = """The program of the rover with one link, without machine code, on a MicroPython 1.27 whose words have 32
bits as those of a board: compiled to WebAssembly, and its collector made sound (benchmarks/micropython32/prepare.py).
The firmware is its source, or .mpy files by mpy-cross; the mocks are .mpy files.

Bytes in use are those beyond the mocks, after a collection. The smallest heap is the first of 64, 68, 72 ... KB (`-X
heapsize`) in which, and in the two next ones as well, the program is imported, starts and runs a simulated minute. It
holds the mocks, too, which take about as much as machine code would add on a board. `make test` lets the program run in
the heaps that stand here."""

SCRIPT = "rover_minute.py"
FORMS = {"source": "from source", "mpy": "from .mpy"}
MOMENTS = {"mocks": "the mocks", "imported": "program imported", "started": "program started"}
STEP = 4  # KB from one heap that is tried to the next
LEAST, MOST = 64, 256
IN_A_ROW = 3  # heaps that have to do: a little more is no help where the free memory lies in pieces
GOALS = {"mpy": 128}


def figures(quick: bool) -> list[Figure]:
    """Let the program run; a quick run takes no smaller heap than one that is enough."""
    with measure.scratch() as folder:
        prepare(folder)
        used = {form: in_use(folder, form, MOST) for form in FORMS}
        smallest = {form: MOST if quick else _smallest(folder, form) for form in FORMS}
    against = "32-bit words"
    found = []
    for form, title in FORMS.items():
        for moment, what in MOMENTS.items():
            count = (used[form] or {}).get(moment)
            found.append(Figure(f"{moment}_{form}", f"heap in use: {what}, {title}", against, count, "bytes"))
    for form, title in FORMS.items():
        what = f"smallest heap in which it runs, {title}"
        found.append(Figure(f"smallest_{form}", what, against, smallest[form], "KB", most=GOALS.get(form)))
    if any(figure.value is None for figure in found):
        raise SystemExit(f"the program does not run in a heap of {MOST} KB")
    return found


def prepare(folder: Path) -> None:
    """Put the rover's firmware into folders of a folder, named as its forms are, the mocks beside it, and the script.

    Names of files lie on the heap, too: within the folder they are the same everywhere.
    """
    generated = measure.rover(folder / "project", machine_code=False)
    shutil.copytree(generated / "firmware", folder / "source")
    _compile(folder / "mpy", generated / "firmware")
    _compile(folder / "mocks", generated / "mocks")
    shutil.copy(measure.HERE / "micropython" / SCRIPT, folder)


def _compile(folder: Path, sources: Path) -> None:
    folder.mkdir()
    for source in sources.glob("*.py"):
        command = [measure.tool("mpy-cross"), "-s", source.stem, "-o", str(folder / f"{source.stem}.mpy"), str(source)]
        measure.said(command)


def in_use(folder: Path, form: str, heap: int) -> dict[str, int] | None:
    """Return what the script says in a heap of so many KB, or None: the program does not run in it."""
    command = [measure.tool("micropython32"), "-X", f"heapsize={heap}k", SCRIPT]
    done = measure.ended(command, env={**os.environ, "MICROPYPATH": os.pathsep.join(("mocks", form))}, cwd=folder)
    if done.returncode and "MemoryError" not in done.stderr:
        raise SystemExit(f"the program ended by something else than a full heap:\n{done.stdout}{done.stderr}")
    if done.returncode:
        return None
    found: dict[str, int] = json.loads(done.stdout.splitlines()[-1])
    return found


def _smallest(folder: Path, form: str) -> int | None:
    in_a_row = 0
    for heap in range(LEAST, MOST + 1, STEP):
        in_a_row = in_a_row + 1 if in_use(folder, form, heap) else 0
        if in_a_row == IN_A_ROW:
            return heap - (IN_A_ROW - 1) * STEP
    return None


if __name__ == "__main__":
    measure.run(COMPARES, figures)
