"""``python -m codegen`` and the console command."""

import gc
import os
import sys


def run() -> None:
    """Run the command line and leave with its exit code."""
    from codegen.cli import main

    # A run is over before looking for cycles in what it reads would free anything worth the time.
    gc.disable()
    code = main(sys.argv[1:])
    # Freeing a whole dialect object by object takes time, and the system does it at once.
    os._exit(code)


if __name__ == "__main__":
    run()
