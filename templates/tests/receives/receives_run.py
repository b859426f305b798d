"""Runs cases of received messages on whatever interpreter reads this file, and prints what the vehicle knows then.

The argument is a file with the quantities, what is called, and the cases: frames in hexadecimal digits, and times in ms
that pass. Values come as texts, so that nothing is lost of them.
"""

import json
import sys

from program_bench import Craft, mock_time


def known(state, paths):
    """Return the values of quantities by path, as texts."""
    found = {}
    for path in paths:
        component, _, attribute = path.partition(".")
        value = getattr(getattr(state, component), attribute)
        found[path] = None if value is None else str(value)
    return found


def outcome(steps, paths, calls):
    """Return what is known after the steps of a case, what was counted by table, called and told, and faults."""
    craft = Craft()
    connection = craft.connections[0]
    for path in paths:  # the bench knows some value of everything
        component, _, attribute = path.partition(".")
        setattr(getattr(craft.state, component), attribute, None)
    called = {}
    for table, reception in connection.receptions.items():
        if calls[table] is not None:
            assert reception.called == getattr(craft, calls[table])
            called[table] = 0
            reception.called = counting(called, table)
    now_ms = 0
    for step in steps:
        if isinstance(step, int):
            mock_time.advance_us(1000 * step)
            now_ms += step
            continue
        craft.port.arrives(bytes.fromhex(step))
        for _ in range(3):
            connection.run(now_ms)
    counts = {table: [each.taken, each.refused] for table, each in connection.receptions.items()}
    texts = [text.split(" not plausible: ") for _, text in craft.said()]
    told = sorted([parts[0] for parts in texts if len(parts) > 1])
    return known(craft.state, paths), counts, called, told, connection.faults


def counting(called, table):
    """Return a function that counts its calls."""

    def count():
        called[table] += 1

    return count


with open(sys.argv[1]) as file:
    about = json.loads(file.read())
for steps in about["cases"]:
    print(json.dumps(outcome(steps, about["paths"], about["calls"])))  # each by itself: all would take much heap
