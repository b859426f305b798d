"""Prints the generated receiver's view of the rover's first battery: swaps, cells, voltage and charge, line by line."""

import json
import sys

from batteries import Batteries

batteries = Batteries()
seen = []
for number, line in enumerate(sys.stdin):
    batteries.feed(bytes.fromhex(line), 100 * number)
    view = batteries.view(1, 0)
    seen.append([view.swaps, view.cells, view.voltage, view.remaining, view.left])
sys.stdout.write(json.dumps(seen))
