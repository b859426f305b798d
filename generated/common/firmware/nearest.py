# Generated from templates/codec/nearest.py: do not edit.
# Inputs: d56fe6425b13cd8b
"""Finds the name that somebody may have meant by a wrong one."""


def hint(name, known):
    """Return the name that is nearest, as the end of an error; nothing where none is near."""
    name = str(name)
    nearest = min([(_distance(name, other), other) for other in known] or [(9, "")])
    return f"; did you mean {nearest[1]}?" if nearest[0] <= (len(name) // 4 or 1) else ""


def _distance(one, other):
    """Return how many letters have to be changed, put in or left out to get from one name to the other."""
    row = list(range(len(other) + 1))
    for letter in one:
        before = row
        row = [before[0] + 1]
        for at in range(len(other)):
            row.append(min(before[at] + (letter != other[at]), before[at + 1] + 1, row[at] + 1))
    return row[-1]
