# Generated from templates/firmware/guard.py: do not edit.
# Inputs: a637cf28e04cdd49
"""Going on after an exception, and keeping it, without a variable for it.

`except Exception as error` makes a function of MicroPython so large that its variables are put on the heap at each
call, whether anything is raised or not. `with` does not.
"""


class Guard:
    """`with guard:` ends where an exception is raised; `error` is then that exception, and None otherwise."""

    def __init__(self):
        self.error = None

    def __enter__(self):
        self.error = None

    def __exit__(self, _kind, error, _trace):
        self.error = error
        return error is not None and isinstance(error, Exception)  # a name of Python's own takes long to find
