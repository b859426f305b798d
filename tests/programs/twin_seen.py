"""Prints what the generated receiver says of battery 2 each second; stdin has times in ms and frames in hex."""

import binascii
import json
import sys

from batteries import Batteries

batteries = Batteries()
seen = []
for line in sys.stdin:
    now_ms, frame = line.split()
    batteries.feed(binascii.unhexlify(frame), int(now_ms))
    view = batteries.view(1, 2)
    if view is not None and int(now_ms) // 1000 >= len(seen):
        seen.append([view.swaps, view.contest])
sys.stdout.write(json.dumps(seen))
