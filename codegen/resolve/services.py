"""What the services to ground stations need of the dialect: messages, and entries of enums."""

from codegen.diagnostics import Report, Rule, shortened_list
from codegen.model.clock import SYSTEM_TIME
from codegen.model.dialect import Dialect, WireMessage
from codegen.model.program import RECEIVED
from codegen.model.program_spec import VehicleSpec

NO_SERVICE_MESSAGE = Rule(
    "no-service-message",
    "The services to ground stations need a message, or an entry of an enum, that the dialect does not have. Choose a "
    "dialect that includes common.xml, or add it with an overlay.",
)

HEAD_ONLY = ("FILE_TRANSFER_PROTOCOL",)
"""Those of which the services read a beginning only."""
SENT = ("PING", "PARAM_VALUE", "COMMAND_ACK", "MESSAGE_INTERVAL", "STATUSTEXT", "PARAM_ERROR")
"""The messages that the services send; of FILE_TRANSFER_PROTOCOL they send a short beginning only."""

SERVICE_ENTRIES = {
    "MAV_CMD": (
        "GET_MESSAGE_INTERVAL SET_MESSAGE_INTERVAL REQUEST_MESSAGE REQUEST_PROTOCOL_VERSION "
        "REQUEST_AUTOPILOT_CAPABILITIES COMPONENT_ARM_DISARM PREFLIGHT_REBOOT_SHUTDOWN"
    ),
    "MAV_RESULT": "ACCEPTED TEMPORARILY_REJECTED DENIED UNSUPPORTED FAILED",
    "MAV_SEVERITY": "ERROR WARNING NOTICE INFO",
    "MAV_STATE": "STANDBY ACTIVE CRITICAL",
    "MAV_DATA_STREAM": "ALL",
    "MAV_TYPE": "GCS",
    "MAV_FTP_OPCODE": "ACK NAK",
    "MAV_FTP_ERR": "UNKNOWNCOMMAND",
    "REBOOT_SHUTDOWN_ACTION": "NONE REBOOT",
    "REBOOT_SHUTDOWN_CONDITIONS": "FORCE",
    "MAV_PARAM_ERROR": "DOES_NOT_EXIST VALUE_OUT_OF_RANGE",
    "MAV_PARAM_TYPE": "INT8 UINT8 INT16 UINT16 INT32 UINT32 REAL32",
}
"""The entries of enums that the program uses, without the name of the enum at their front."""


def service_messages(
    spec: VehicleSpec, dialect: Dialect, report: Report, *, takes_time: bool
) -> tuple[WireMessage, ...]:
    """The messages that the services receive and send; those that the dialect lacks are one finding.

    ``takes_time``: a table has the time since 1970, which SYSTEM_TIME can say; a dialect may be without that.
    """
    time = [SYSTEM_TIME] if takes_time and SYSTEM_TIME in dialect.messages else []
    names = dict.fromkeys((*RECEIVED, *time, *SENT))
    missing = [name for name in names if name not in dialect.messages]
    if missing:
        report.add(NO_SERVICE_MESSAGE, spec.place, f"{dialect.name} has no message {shortened_list(missing)}")
    return tuple(dialect.messages[name] for name in names if name in dialect.messages)


def service_constants(spec: VehicleSpec, dialect: Dialect, report: Report) -> dict[str, int]:
    """The numbers of the entries that the program uses, by name; those that the dialect lacks are one finding."""
    found, missing = {}, []
    for name, entries in SERVICE_ENTRIES.items():
        enum = dialect.enums.get(name)
        for suffix in entries.split():
            entry = enum.entry(f"{name}_{suffix}") or enum.entry(f"MAV_{suffix}") if enum else None
            if entry is None:
                missing.append(f"{name}_{suffix}")
            else:
                found[entry.name] = entry.value
    if missing:
        report.add(NO_SERVICE_MESSAGE, spec.place, f"{dialect.name} has no enum entry {shortened_list(missing)}")
    return found
