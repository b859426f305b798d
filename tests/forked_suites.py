"""Runs pytest in forks of this process, which has imported what generated suites import: a fork has it at once.

Each line of its input asks for one run: a JSON object with the arguments, the folder, the environment, and the file
that takes what is printed. A line of its output says how that run ended. It ends with its input.
"""

import gc
import importlib
import json
import os
import sys
import traceback

import pytest

for _name in ("ast", "json", "queue", "tempfile", "unittest.mock", "xml.etree.ElementTree"):
    importlib.import_module(_name)
for _name in ("generator.mavgen", "generator.mavparse", "dialects.v20.common", "dialects.v10.common"):
    importlib.import_module(f"pymavlink.{_name}")


def main() -> None:
    """Answer what is asked. As in the process of the tests, cycles are looked for at the end of a run."""
    gc.collect()
    gc.freeze()
    gc.disable()
    for line in sys.stdin:
        asked = json.loads(line)
        forked = os.fork()
        if forked == 0:
            _run(**asked)
        _, status = os.waitpid(forked, 0)
        print(os.waitstatus_to_exitcode(status), flush=True)  # noqa: T201  the answer


def _run(arguments: list[str], folder: str, environment: dict[str, str], printed: str) -> None:
    """Be what `python -m pytest` is in a folder, and end."""
    code = 1
    try:
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        into = os.open(printed, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(into, 1)
        os.dup2(into, 2)
        os.chdir(folder)
        os.environ.clear()
        os.environ.update(environment)
        sys.path[0] = folder
        sys.argv = ["pytest", *arguments]
        code = int(pytest.main(arguments))
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


if __name__ == "__main__":
    main()
