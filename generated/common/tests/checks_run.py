# Generated from templates/tests/program/checks_run.py: do not edit.
# Inputs: c93879198c397660
"""Runs checks of the program's scripts, one after another in one process: a line of JSON for each, once it is over.

The arguments are the number of a free port and the checks, each with its script, as in `loop jitter_is_no_drift`; those
of a script stand together. A line has the check, so written, and what went wrong, or null.
"""

import gc
import json
import sys

from program_bench import IS_MICROPYTHON, outcomes

# The program collects at its start. CPython would go through all that was imported each time, and through the vehicles
# of earlier checks, whose generators begin anew when they are closed.
freeze = getattr(gc, "freeze", lambda: None)
UNBUFFERED = {} if IS_MICROPYTHON else {"flush": True}


def run(script, asked):
    """Print what the checks of a script find; where it cannot be imported, each finds that."""
    try:
        module = __import__(script + "_checks")
        found = outcomes(module.CHECKS, getattr(module, "SUBJECT", True), asked)
    except Exception as error:
        wrong = f"{type(error).__name__}: {error}"
        found = ((name, wrong) for name in asked)
    for name, wrong in found:
        print(json.dumps([f"{script} {name}", wrong]), **UNBUFFERED)
        freeze()


def main(given):
    """Run checks, script by script; what one has kept is forgotten with it: the next has the heap for itself."""
    scripts = []
    for script, name in [each.split(" ") for each in given]:
        if not scripts or scripts[-1][0] != script:
            scripts.append((script, []))
        scripts[-1][1].append(name)
    freeze()
    own = list(sys.modules)
    for script, asked in scripts:
        run(script, asked)
        for name in list(sys.modules):
            if name.endswith("_checks") and name not in own:
                del sys.modules[name]


if __name__ == "__main__":
    main(sys.argv[2:])
