# Generated from templates/tests/telling.py: do not edit.
# Inputs: 1398de816062e75e
"""Prints results as one JSON object, each as soon as it is there: who waits for the script hears that it goes on.

As one text, many of them would need a large piece of the heap.
"""

import json


def tell(found):
    """Print pairs of a name and what JSON can say as an object."""
    begin = "{"
    for name, value in found:
        print(begin + json.dumps(name) + ": " + json.dumps(value))
        begin = ", "
    print("{}" if begin == "{" else "}")
