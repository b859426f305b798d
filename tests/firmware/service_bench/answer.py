"""Answers one scenario for each line of standard input, on the interpreter that it is started with."""

import json
import sys

from vehicle_bench import Bench


def assign(target, values):
    """Set attributes."""
    for name, value in values.items():
        setattr(target, name, value)


def arrive(bench, data):
    """Let bytes arrive."""
    bench.port.arrived += bytes.fromhex(data)


STEPS = {
    "in": arrive,
    "arrive": arrive,
    "passes": lambda bench, count: bench.passes(count),
    "say": lambda bench, text: bench.vehicle.texts.say(text[0], text[1]),
    "port": lambda bench, values: assign(bench.port, values),
    "vehicle": lambda bench, values: assign(bench.vehicle, values),
    "streams": lambda bench, values: assign(bench.connection.streams, values),
}


def run(scenario):
    """Do the steps of a scenario, [what, argument]; return what was written in each step, and what is left behind."""
    bench = Bench(scenario["versions"])
    outputs = []
    for what, argument in scenario["steps"]:
        STEPS[what](bench, argument)
        outputs.append([connection.port.written.hex() for connection in bench.vehicle.connections])
        for connection in bench.vehicle.connections:
            connection.port.written = b""
    connection = bench.connection
    return {
        "outputs": outputs,
        "calls": bench.calls,
        "faults": connection.faults,
        "lost_replies": connection.lost_replies,
        "tx_errors": connection.link.tx_errors,
        "left": len(bench.port.arrived),
        "received": connection.link.received,
        "ground_station": connection.services.ground_station,
        "is_armed": bench.vehicle.is_armed,
    }


for line in sys.stdin:
    sys.stdout.write(json.dumps(run(json.loads(line))) + "\n")
    if hasattr(sys.stdout, "flush"):
        sys.stdout.flush()
