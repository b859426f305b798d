"""Names that classes of the firmware have are taken: what a table calls so would replace them, and nobody is told."""

import re
from pathlib import Path

from codegen.resolve.program.vehicle_names import VEHICLE_NAMES, is_vehicle_name
from codegen.targets.naming import PARAMETERS_NAMES, parameter_attribute

TEMPLATES = Path(__file__).resolve().parents[2] / "templates" / "firmware"
MEMBERS = re.compile(r"^    (?:async )?def ([a-z]\w*)|\bself\.([a-z]\w*) = |keep\(self, \"(\w+)\"", re.MULTILINE)
"""The methods of a class, and the attributes that it gives itself; what begins with _ no table can call so."""
STARTS = {"access", "long_commands", "sources"}
"""Attributes of a Vehicle that a view prints, since few programs have them."""


def members(template: str, head: str) -> set[str]:
    """Return the names that a class in a template has itself, but for those that tables give."""
    text = (TEMPLATES / template).read_text().partition(f"\nclass {head}")[2]
    return {next(filter(None, found)) for found in MEMBERS.findall(text)}


def test_no_call_of_the_user_replaces_a_part_of_the_vehicle() -> None:
    """Neither a method nor an attribute, whatever the program has."""
    own = members("program/vehicle.py.j2", "Vehicle")
    assert {"reboot", "run_pass", "restart_ms", "connections"} <= own, "the pattern still finds them"
    assert own | STARTS <= VEHICLE_NAMES
    assert is_vehicle_name("depth_failsafes")
    assert is_vehicle_name("received_heartbeat")
    assert not is_vehicle_name("depth")


def test_no_parameter_replaces_a_part_of_the_parameters() -> None:
    """RESTORE is kept as restore_."""
    own = members("parameters.py.j2", "Parameters")
    assert {"get", "restore", "changes"} <= own
    assert own <= PARAMETERS_NAMES
    assert [parameter_attribute(name) for name in ("RESTORE", "BATT_LOW")] == ["restore_", "batt_low"]
