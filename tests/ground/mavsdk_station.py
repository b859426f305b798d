"""MAVSDK as a program: it does what it reads, and writes what it is told and what it sees.

A line `{"do": "param.get_param_int", "with": ["SR0_EXTRA1"], "number": 1}` is answered with `=done= {...}`: the result
or the name of the error. What MAVSDK reports by itself is `=seen= {...}`. It runs on its own, since nothing
interrupts a native call.
"""

import json
import sys
import threading
from collections.abc import Mapping, Sequence
from typing import Any

from mavsdk import ComponentType, Configuration, ConnectionResult, Mavsdk
from mavsdk.plugins.action import Action
from mavsdk.plugins.geofence import Geofence
from mavsdk.plugins.info import Info
from mavsdk.plugins.log_files import LogFiles
from mavsdk.plugins.mission import Mission
from mavsdk.plugins.param import Param
from mavsdk.plugins.telemetry import Telemetry

_WRITING = threading.Lock()


def write(title: str, **values: Any) -> None:
    """Write a line; MAVSDK calls from threads of its own."""
    with _WRITING:
        sys.stdout.write(f"\n={title}= {json.dumps(values)}\n")
        sys.stdout.flush()


def plain(value: Any) -> Any:
    """Anything that MAVSDK returns, as JSON has it."""
    if isinstance(value, bool | int | float | str | None):
        return value
    if isinstance(value, Sequence):
        return [plain(one) for one in value]
    attributes: Mapping[str, Any] = vars(value)
    return {name: plain(one) for name, one in attributes.items()}


def main() -> None:
    """Wait for a vehicle at the UDP port or address of the first argument, then for lines; others are told, too."""
    mavsdk = Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION))
    where = sys.argv[1]
    result = mavsdk.add_any_connection(where if "://" in where else f"udpin://127.0.0.1:{where}")
    if result != ConnectionResult.SUCCESS:
        sys.exit(f"no connection: {result!r}")
    write("ready")
    system = mavsdk.first_autopilot(60.0)
    if system is None:
        sys.exit("no vehicle")
    telemetry = Telemetry(system)
    plugins = {
        "telemetry": telemetry,
        "param": Param(system),
        "action": Action(system),
        "info": Info(system),
        "mission": Mission(system),
        "geofence": Geofence(system),
        "log_files": LogFiles(system),
    }
    kinds = ("battery", "status_text", "health", "armed", "health_all_ok", *sys.argv[2:])
    for kind in kinds:
        getattr(telemetry, f"subscribe_{kind}")(lambda value, kind: write("seen", kind=kind, value=plain(value)), kind)
    write(
        "system",
        number=system.get_system_id(),
        components=system.component_ids(),
        autopilot=int(system.autopilot_type()),
        vehicle=int(system.vehicle_type()),
    )
    for line in sys.stdin:
        request = json.loads(line)
        plugin, _, method = request["do"].partition(".")
        try:
            result = getattr(plugins[plugin], method)(*request["with"])
        except Exception as fault:  # every plugin has its own class for it
            write("done", number=request["number"], result=None, error=fault.result.name)
        else:
            write("done", number=request["number"], result=plain(result), error=None)


if __name__ == "__main__":
    main()
