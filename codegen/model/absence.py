"""Questions of ground stations about things a vehicle may not have, with their answers: missions, logs, modes."""

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireMessage


@dataclass(frozen=True, slots=True)
class Absence:
    """A question that is answered by ``method`` of absences.py.j2: the vehicle has none of what it is about."""

    question: WireMessage
    answer: WireMessage
    method: str


MISSIONS = (
    ("MISSION_REQUEST_LIST", "MISSION_COUNT", "count_none"),
    ("MISSION_COUNT", "MISSION_ACK", "refuse_upload"),
    ("MISSION_CLEAR_ALL", "MISSION_ACK", "clear"),
    ("MISSION_REQUEST", "MISSION_ACK", "refuse_item"),
    ("MISSION_REQUEST_INT", "MISSION_ACK", "refuse_item"),
)
LOGS = (("LOG_REQUEST_LIST", "LOG_ENTRY", "list_no_logs"),)
MODES = (("SET_MODE", "COMMAND_ACK", "refuse_mode"),)
"""Questions, what answers them, and by which method: what belongs together, of which a dialect may lack all."""

MORE_MISSIONS = (
    ("MISSION_REQUEST_PARTIAL_LIST", "MISSION_ACK", "refuse_part"),
    ("MISSION_WRITE_PARTIAL_LIST", "MISSION_ACK", "refuse_part"),
)
"""The same of what a dialect may lack though it has the others. MISSION_SET_CURRENT has no answer that says no: the
command in its place has. LOG_DATA is longer than links have room for that send nothing as long."""

ABSENCE_FIELDS = {
    "MISSION_REQUEST_LIST": "target_system target_component mission_type",
    "MISSION_COUNT": "target_system target_component mission_type count",
    "MISSION_CLEAR_ALL": "target_system target_component mission_type",
    "MISSION_REQUEST": "target_system target_component mission_type",
    "MISSION_REQUEST_INT": "target_system target_component mission_type",
    "MISSION_REQUEST_PARTIAL_LIST": "target_system target_component mission_type",
    "MISSION_WRITE_PARTIAL_LIST": "target_system target_component mission_type",
    "MISSION_ACK": "target_system target_component mission_type type",
    "LOG_REQUEST_LIST": "target_system target_component",
    "LOG_ENTRY": "num_logs last_log_num",
    "SET_MODE": "target_system",
    "COMMAND_ACK": "command result target_system target_component",
}
"""The fields that these methods read and write in payloads."""

MISSION_RESULTS = ("MAV_MISSION_ACCEPTED", "MAV_MISSION_UNSUPPORTED", "MAV_MISSION_INVALID_SEQUENCE")
"""The entries of MAV_MISSION_RESULT that they answer with."""
