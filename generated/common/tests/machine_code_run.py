# Generated from templates/tests/machine_code_run.py: do not edit.
# Inputs: 7d72774cc447069b
"""Prints what keeps each of the named modules from being compiled, as JSON: null where the interpreter has no viper.

Where a module in machine code cannot be imported, the firmware takes its plain counterpart without a word, and every
other test passes.
"""

import json
import sys

VIPER = """
import micropython

@micropython.viper
def number() -> int:
    return 1
"""


def problems(names):
    """Return what keeps each module from being imported, by its name."""
    found = {}
    for name in names:
        try:
            __import__(name)
        except Exception as error:
            found[name] = type(error).__name__ + ": " + str(error)
    return found


def has_viper():
    """Return whether this interpreter compiles machine code."""
    try:
        exec(VIPER, {})  # noqa: S102  a syntax error ends no more than it
    except (AttributeError, ImportError, SyntaxError):
        return False
    return True


if __name__ == "__main__":
    import mock_time

    mock_time.install()
    print(json.dumps(problems(sys.argv[1:]) if has_viper() else None))
