"""Prints the frames of a smart battery in 90 s: arguments are its chip, a count of its ADC and BATT_REPORT.

Lines, also those of stdin with what arrives meanwhile, are a time in ms and a frame in hex. A process is one board,
because a board's chip never changes.
"""

import binascii
import sys

import machine

machine.set_unique_id(sys.argv[1].encode())  # before the firmware looks at it, which is once

from program_bench import MEASURED, analog, new_craft, run  # noqa: E402

PASS_MS = 50
arriving = [line.split() for line in sys.stdin]
battery = new_craft()
assert battery.parameters.set("BATT_REPORT", int(sys.argv[3]))
analog(MEASURED[0], 0).source = int(sys.argv[2])
taken = 0
for now_ms in range(0, 90000, PASS_MS):
    while arriving and int(arriving[0][0]) < now_ms:
        battery.port.arrives(binascii.unhexlify(arriving.pop(0)[1]))
    run(battery, PASS_MS * 1000)
    for frame in battery.port.frames[taken:]:
        sys.stdout.write(f"{now_ms} {binascii.hexlify(frame).decode()}\n")
    taken = len(battery.port.frames)
