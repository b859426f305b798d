"""The frames that a smart battery sends after its start: arguments are its chip, its charge drawn and BATT_REPORT.

A process is one board, because a board's chip never changes while its program runs.
"""

import binascii
import sys

import machine

machine.set_unique_id(sys.argv[1].encode())  # before the firmware looks at it, which is once

from program_bench import SECOND_US, new_craft, run  # noqa: E402

battery = new_craft()
battery.state.battery.consumed_mah = int(sys.argv[2])
battery.state.battery.current_ma = 5000
assert battery.parameters.set("BATT_REPORT", int(sys.argv[3]))
run(battery, 5 * SECOND_US)
for frame in battery.port.frames:
    sys.stdout.write(binascii.hexlify(frame).decode() + "\n")
sys.stdout.write("end\n")
