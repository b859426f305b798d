# Generated from templates/tests/dialect_run.py: do not edit.
# Inputs: bda109412a45d0c1
"""Prints how the firmware lays out each message, as JSON, on whatever interpreter reads this file.

By name: id, CRC_EXTRA, length without and with extension fields, places of the target, what fields hold at first, and
the fields in wire order, each with its name, its form for struct and its place. Of messages that are known by their
ids alone, the first five of these.
"""

import json

from fields import layout_of
from messages import ALL


def laid_out(cls):
    """Return what a class says of its message."""
    fields = [[name, field[0][1:], field[1]] for name, field in layout_of(cls).items()]
    fields.sort(key=lambda field: field[2])
    return [cls.ID, cls.CRC_EXTRA, cls.BASE_LENGTH, cls.LENGTH, list(cls.TARGETS), cls.DEFAULTS, fields]


def bare():
    """Return what the answers about what the vehicle does not have say of theirs; there may be none."""
    try:
        import absences  # noqa: PLC0415  where there is no program, there is none
    except ImportError:
        return []
    return [
        [each.ID, each.CRC_EXTRA, each.BASE_LENGTH, each.LENGTH, list(each.TARGETS)]
        for each in [absences.Bare(number) for number in absences._KINDS]
    ]


print(json.dumps({"named": {cls.NAME: laid_out(cls) for cls in ALL}, "bare": bare()}))
