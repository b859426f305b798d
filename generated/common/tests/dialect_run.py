# Generated from templates/tests/dialect_run.py: do not edit.
# Inputs: 1d9bb64592e2fdc7
"""Prints how the firmware lays out each message, as JSON, on whatever interpreter reads this file.

By name: id, CRC_EXTRA, length without and with extension fields, places of the target, what fields hold at first, and
the fields in wire order, each with its name, its form for struct and its place.
"""

import json

from fields import layout_of
from messages import ALL


def laid_out(cls):
    """Return what a class says of its message."""
    fields = [[name, field[0][1:], field[1]] for name, field in layout_of(cls).items()]
    fields.sort(key=lambda field: field[2])
    return [cls.ID, cls.CRC_EXTRA, cls.BASE_LENGTH, cls.LENGTH, list(cls.TARGETS), cls.DEFAULTS, fields]


print(json.dumps({cls.NAME: laid_out(cls) for cls in ALL}))
