"""Prints what the firmware puts into the payload of each message, as JSON, on whatever interpreter reads this file.

By name, for each of a few patterns of values: the payload, and the values that are read back from it; then the frames
of the same values as live ones, of those fields that can be live, and what of these is received as live ones; then of
the fields that can be unknown what they are at first, what they are once small values were set, and what they are once
they are unknown again; of some messages what is said of names that are not quite those of a field; and what is wrong
where fields are attributes.
"""

import mavlink
from fields import layout_of
from messages import ALL
from telling import tell

LIVE = "BHIbhi"
SIZES = {"B": 1, "H": 2, "I": 4, "Q": 8, "b": 1, "h": 2, "i": 4, "q": 8}


def elements(code, pattern, indices):
    """Return the values of elements: a pattern goes from the smallest over small ones to the largest."""
    if code in "fd":
        return [(0.0, -1.5, 1024.0, 0.25 * index)[pattern] for index in indices]
    bits = 8 * SIZES[code]
    low, high = (0, (1 << bits) - 1) if code.isupper() else (-(1 << bits - 1), (1 << bits - 1) - 1)
    return [(low, low + 1 + at % 7, high - 1 - at % 5, (at * 37 + 1) & high)[pattern] for at in indices]


def values(fields, pattern):
    """Return the value of each field."""
    found = {}
    for name, (form, _place, count) in fields.items():
        if form[-1] == "s":
            found[name] = "abcdefgh"[: min(count, 2 * pattern)]
        elif count:
            found[name] = elements(form[-1], pattern, range(count))
        else:
            found[name] = elements(form[-1], pattern, (len(found),))[0]
    return found


def named_for_call(given):
    """Return values by names that a call takes: a field called self is self_ there."""
    return {"self_" if name == "self" else name: value for name, value in given.items()}


class Wire:
    """A port that keeps the last frame."""

    def write(self, frame):
        """Keep one."""
        self.frame = bytes(frame)
        return len(frame)


def carried(cls):
    """Return the payloads and what is read of them, then the frames with live values."""
    fields = {name: field[:3] for name, field in layout_of(cls).items()}
    found = []
    for pattern in range(4):
        given = values(fields, pattern)
        message = cls(unknown=False).update(**named_for_call(given))
        found.append([given, bytes(message.wire).hex(), {name: message.raw(name) for name in fields}])
    live = [name for name, field in fields.items() if field[0][-1] in LIVE]
    frames = as_live(cls, fields, live, live, range(4))
    sizes = [[name for name in live if SIZES[fields[name][0][-1]] == size] for size in (1, 2, 4)]
    for part in sizes:
        if part not in ([], live):  # else it was done, and two patterns change every byte
            frames += as_live(cls, fields, live, part, (1, 3))
    return [found, frames, unknown(cls, fields), misspelt(cls, fields) if cls in ALL[:3] else [], named(cls, fields)]


def as_live(cls, fields, names, live, patterns):
    """Return for some patterns values of `names`, the frame of them, and whether those that are `live` arrive.

    Each is also set and read by name: before that it is something else, as are all the others.
    """
    message, arrived = cls(live, unknown=False), cls(live, unknown=False)
    wire = Wire()
    link = mavlink.Link(wire, 1, 1, 2, (arrived,), cls.LENGTH)
    frames = []
    for pattern in patterns:
        given = values(fields, pattern)
        message.update(**named_for_call({name: given[name] for name in names if name not in live}))
        flat = []
        for name in live:
            flat += given[name] if fields[name][2] else [given[name]]
        for index, value in enumerate(flat):
            message.live[index] = value - (1 << 32) if value > 0x7FFFFFFF else value
        same = [is_given(message, name, given) for name in live]
        for name in live:
            message.set(name, [0] * fields[name][2] or 0)
            message.set(name, given[name])
            same.append(is_given(message, name, given))
        link.send(message)
        for index in range(len(flat)):
            arrived.live[index] = -1 - message.live[index]  # nothing that is to be received
        for _ in link.feed(wire.frame):
            pass
        same += [arrived.live[index] == message.live[index] for index in range(len(flat))]
        frames.append([{name: given[name] for name in names}, wire.frame.hex(), same])
    return frames


def is_given(message, name, given):
    """Return whether a field is what was given."""
    told = message.raw(name)
    return (list(told) if isinstance(told, tuple) else told) == given[name]


def named(cls, fields):
    """Return what is wrong where fields are attributes; one that has the name of something else has "_" behind it."""
    message, given, wrong = cls(unknown=False), values(fields, 1), []
    for name in fields:
        is_taken = hasattr(cls, name) or name in ("wire", "live")
        for attribute in (name + "_",) if is_taken else (name, name + "_"):
            message.set(name, "" if fields[name][0][-1] == "s" else [0] * fields[name][2] or 0)
            setattr(message, attribute, given[name])
            if not is_given(message, name, given) or getattr(message, attribute) != message.get(name):
                wrong.append(attribute)
    for name in ("wire", "live", "get", "NAME", "no_such_field", "_"):
        try:
            setattr(message, name, 1)
            wrong.append(name)
        except AttributeError:
            continue
    for name in ("no_such_field", "no_such_field_", "_"):
        if hasattr(message, name):
            wrong.append(name)
    return wrong


def unknown(cls, fields):
    """Return name, values at first, small values that are set, what is read of them, and the values at the end.

    Between these stand values of which every second element is unknown, where each can be, and what is read of them.
    """
    found = []
    given = values(fields, 1)
    for name, field in layout_of(cls).items():
        if field[3] and field[4] is not None:
            message = cls()
            steps = [name, message.get(name), given[name]]
            message.set(name, given[name])
            steps.append(message.get(name))
            mixed = given[name]
            if isinstance(steps[1], tuple) and set(steps[1]) == {None}:
                mixed = [None if at % 2 else value for at, value in enumerate(mixed)]
            message.set(name, mixed)
            steps += [mixed, message.get(name)]
            message.set(name, None)
            steps.append(message.get(name))
            found.append(steps)
    return found


def misspelt(cls, fields):
    """Return names that no field has, made of the longest and the shortest that there is, and what is said of each."""
    found = []
    for name in (max(fields, key=len), min(fields, key=len)):
        moved = name[1:2] + name[:1] + name[2:]
        for wrong in (name[1:], name[:-1], name + "x", "x" + name, "x" + name[1:], moved, name + name, "xyz"):
            try:
                cls().get(wrong)
            except KeyError as error:
                found.append([wrong, error.args[0]])
    return found


tell((cls.NAME, carried(cls)) for cls in ALL)
