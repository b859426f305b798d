"""Frames of the rover's first battery along courses of its sources: hex on stdout, MICROPYPATH has what was generated.

stdin has a course in each line, JSON lists of pairs: what a source does and its value; -1 is the count of a reading
that fails. Each step is a reading of both inputs, a tenth of a second later; what code sets is set before it. A line
of the output has the frames after each step: SYS_STATUS, BATTERY_STATUS and BATTERY_STATUS_V2.
"""

import json
import sys

import telemetry
from mock_board import MockBoard
from parameters import Parameters
from program_bench import Link, Sink, machine, mock_time
from state import SystemState

BUILDERS = (telemetry.encode_sys_status, telemetry.encode_battery_status, telemetry.encode_battery_status_v2)


def tell(course, monitor):
    """Return the frames after each step of a course."""
    mock_time.set_ticks_us(0)
    machine.reset_analog()
    parameters = Parameters()
    parameters.set("BATT_MONITOR", monitor)
    board = MockBoard(log=lambda *_: None, parameters=parameters)
    state = SystemState(parameters, log=lambda *_: None)
    counts = {"voltage": 3770, "current": 1234}
    link = Link(Sink())
    for steps in course:
        for name, value in steps:
            if monitor == 29 and name == "voltage":  # of another system, which says nothing where a reading fails
                if value >= 0:
                    state.battery[0].voltage_mv = 3 * value
            elif name in counts:
                counts[name] = value
            else:
                setattr(state.battery[0], name, value)
        board.set_adc_waveform([counts["voltage"]])
        if monitor == 4:
            board.set_battery_current_adc_waveform([counts["current"]])
        mock_time.advance_us(100000)
        state.update_battery(board)
        yield [bytes(build(link, state)).hex() for build in BUILDERS]


for line in sys.stdin:
    given = json.loads(line)
    sys.stdout.write(json.dumps(list(tell(given["course"], given["monitor"]))) + "\n")
