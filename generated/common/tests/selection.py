# Generated from templates/tests/selection.py: do not edit.
# Inputs: 23ba58081804655c
"""Finds the selected tests of a function: one run of a script is for all of them."""


def selected(item):
    """Return the parameters of each selected test of a function, with the interpreter of `item` and its marker days."""
    kind = _kind(item)
    items = item.session.items
    others = [each for each in items if each.path == item.path and each.originalname == item.originalname]
    return [each.callspec.params for each in others if _kind(each) == kind]


def _kind(item):
    return item.callspec.params["interpreter"], item.get_closest_marker("days") is None
