"""Runs scripts of MicroPython, each in a fork of this process: benchmarks/cost.py starts it under valgrind.

Most of what such a run takes is to start CPython, of which MicroPython is a module: a fork has that, and what valgrind
translated of it. The argument is the folder of that module. Each line of the input is one run: the path of its modules,
the folder in which it runs, the file that takes what is printed, and its arguments, parted by tabs. A line of the
output has the number of the fork, which names what valgrind writes, and what it returned.
"""

import os
import sys

sys.path.append(sys.argv[1])

from micropython_unix import main


def _run(path: str, folder: str, printed: str, *arguments: str) -> None:
    """Be the interpreter, and end."""
    code = 1
    try:
        os.chdir(folder)
        os.environ["MICROPYPATH"] = path
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        into = os.open(printed, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(into, 1)
        os.dup2(into, 2)
        sys.argv = ["micropython", *arguments]
        code = main() or 0
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
    finally:
        sys.stdout.flush()
        os._exit(code)


for asked in sys.stdin:
    fork = os.fork()
    if fork == 0:
        _run(*asked.rstrip("\n").split("\t"))
    _, status = os.waitpid(fork, 0)
    sys.stdout.write(f"{fork} {status}\n")
    sys.stdout.flush()
