# Generated from templates/tests/selection.py: do not edit.
# Inputs: d2b941f90110057e
"""Knows the checks of the selected tests: one run of a script is for all of them."""

_checks = {}


def note(items):
    """Note what tests have as their parameter `check`, by the names of their functions."""
    _checks.clear()
    for item in items:
        if hasattr(item, "callspec") and "check" in item.callspec.params:
            _checks.setdefault(item.originalname, []).append(item.callspec.params["check"])


def selected(function):
    """Return the parameter `check` of each selected test of a function, in their order."""
    return _checks.get(function, ())
