"""Prints what the generated receiver says of battery 2 after each of the batteries whose frames come on stdin."""

import binascii
import json
import sys

from batteries import Batteries

batteries = Batteries()
now_ms = 0
seen = []
for line in sys.stdin:
    if line.strip() == "end":
        view = batteries.view(1, 2)
        seen.append([view.info.serial_number, view.swaps, view.consumed])
    else:
        batteries.feed(binascii.unhexlify(line.strip()), now_ms)
        now_ms += 100
sys.stdout.write(json.dumps(seen))
