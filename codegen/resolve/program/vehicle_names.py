"""The names that the attributes and methods of a Vehicle have, which calls of the user's code cannot have."""

VEHICLE_NAMES = frozenset(
    (
        *("texts", "connections", "parameters", "storage", "state", "board", "scheduler", "long_commands", "sources"),
        *("access", "control", "measure", "check_arming", "on_arm", "on_disarm", "is_armed", "arming_problem", "arm"),
        *(
            "disarm",
            "reboot",
            "restart_ms",
            "reception",
            "run_pass",
            "run",
            "check_mode",
            "set_mode",
            "stop_motors",
            "halt_motors",
        ),
        *("remind",),
    )
)
"""Those of all programs, whether this one has them or not."""
_OF_FAILSAFES, _OF_TABLES = "_failsafes", "received_"
"""The ends and fronts of the names that are made of those of failsafes, and of tables of received messages."""


def is_vehicle_name(name: str) -> bool:
    """Return whether a Vehicle has, or can have, an attribute or a method of that name."""
    return name in VEHICLE_NAMES or name.endswith(_OF_FAILSAFES) or name.startswith(_OF_TABLES)
