"""The messages and entries of enums that the services to ground stations need of the dialect."""

from collections.abc import Iterator

from codegen.diagnostics import Report, Rule, shortened_list
from codegen.frozen import dataclass
from codegen.model.code.clock import SYSTEM_TIME
from codegen.model.command import BUILT_IN, Needs
from codegen.model.dialect.dialect import Dialect, WireMessage
from codegen.model.program import COMMAND_CANCEL, RECEIVED, SENT, SET_MODE
from codegen.model.spec.access import SETUP_SIGNING
from codegen.model.spec.program import VehicleSpec

NO_SERVICE_MESSAGE = Rule(
    "no-service-message",
    "The services to ground stations need a message, a field of one, or an entry of an enum, that the dialect does not "
    "have. Choose a dialect that includes common.xml, or add it with an overlay.",
    remedy="take a dialect that includes common.xml, or add it with an overlay",
)

HEAD_ONLY = ("FILE_TRANSFER_PROTOCOL",)
"""Those of which the services read a beginning only."""

SERVICE_FIELDS = {
    "HEARTBEAT": "type",
    "PING": "target_system target_component",
    "PARAM_REQUEST_READ": "param_index param_id",
    "PARAM_SET": "param_value param_id param_type",
    "PARAM_VALUE": "param_value param_count param_index param_id param_type",
    "PARAM_ERROR": "param_index target_system target_component param_id error",
    "REQUEST_DATA_STREAM": "req_message_rate req_stream_id start_stop",
    "COMMAND_INT": "frame",
    "COMMAND_LONG": "param1 command confirmation",
    "COMMAND_ACK": "command result progress target_system target_component",
    "MESSAGE_INTERVAL": "interval_us message_id",
    "FILE_TRANSFER_PROTOCOL": "target_system target_component payload",
    "STATUSTEXT": "severity text id chunk_seq",
    "SYSTEM_TIME": "time_unix_usec",
    "SET_MODE": "base_mode custom_mode",
    "COMMAND_CANCEL": "command",
    "SETUP_SIGNING": "secret_key initial_timestamp",
}
"""The fields that the program reads and writes in payloads, in templates such as `dialect.PING_TARGET_SYSTEM_AT`."""

SERVICE_ENTRIES = {
    "MAV_CMD": " ".join(each.name.removeprefix("MAV_CMD_") for each in BUILT_IN if each.needs is not Needs.MODES),
    "MAV_RESULT": "ACCEPTED TEMPORARILY_REJECTED DENIED UNSUPPORTED FAILED",
    "MAV_SEVERITY": "ERROR WARNING NOTICE INFO",
    "MAV_STATE": "STANDBY ACTIVE CRITICAL",
    "MAV_DATA_STREAM": "ALL",
    "MAV_TYPE": "GCS",
    "MAV_AUTOPILOT": "INVALID",
    "MAV_FTP_OPCODE": "ACK NAK",
    "MAV_FTP_ERR": "UNKNOWNCOMMAND",
    "REBOOT_SHUTDOWN_ACTION": "NONE REBOOT",
    "REBOOT_SHUTDOWN_CONDITIONS": "FORCE",
    "MAV_PARAM_ERROR": "DOES_NOT_EXIST READ_ONLY VALUE_OUT_OF_RANGE",
    "MAV_PARAM_TYPE": "INT8 UINT8 INT16 UINT16 INT32 UINT32 REAL32",
}
"""The entries of enums that the program uses, without the name of the enum at their front."""


CANCELLED = "MAV_RESULT_CANCELLED"


@dataclass(frozen=True, slots=True)
class Uses:
    """The features of the program that need more of the dialect.

    A table has the time since 1970, which SYSTEM_TIME can say; the vehicle has commands of its own; one of them takes
    long; modes are declared; a link brings the key of others.
    """

    takes_time: bool = False
    has_commands: bool = False
    takes_long: bool = False
    has_modes: bool = False
    takes_keys: bool = False


def service_messages(spec: VehicleSpec, dialect: Dialect, report: Report, uses: Uses) -> tuple[WireMessage, ...]:
    """The messages that the services receive and send; those that the dialect lacks are one finding.

    A dialect may be without SYSTEM_TIME, SET_MODE, which MAV_CMD_DO_SET_MODE supersedes, and COMMAND_CANCEL.
    """
    may_lack = [
        *([SYSTEM_TIME] if uses.takes_time else []),
        *([SET_MODE] if uses.has_modes else []),
        *([SETUP_SIGNING] if uses.takes_keys else []),
        *([COMMAND_CANCEL] if uses.takes_long and _entry_of(dialect, CANCELLED) else []),
    ]
    names = dict.fromkeys((*RECEIVED, *(name for name in may_lack if name in dialect.messages), *SENT))
    missing = [name for name in names if name not in dialect.messages]
    if missing:
        report.add(NO_SERVICE_MESSAGE, spec.place, f"{dialect.name} has no message {shortened_list(missing)}")
    found = tuple(dialect.messages[name] for name in names if name in dialect.messages)
    for wire in found:
        lacking = set(SERVICE_FIELDS.get(wire.name, "").split()) - {field.name for field in wire.fields}
        if lacking:
            what = shortened_list([f"{wire.name}.{name}" for name in sorted(lacking)])
            report.add(NO_SERVICE_MESSAGE, spec.place, f"{dialect.name} has no field {what}")
    return found


def service_constants(spec: VehicleSpec, dialect: Dialect, report: Report, uses: Uses) -> dict[str, int]:
    """The numbers of the entries that the program uses, by name; those that the dialect lacks are one finding."""
    found, missing = {}, []
    for name, entries in _entries(dialect, uses):
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


def _entries(dialect: Dialect, uses: Uses) -> Iterator[tuple[str, str]]:
    yield from SERVICE_ENTRIES.items()
    if uses.has_commands:
        yield "MAV_RESULT", "IN_PROGRESS"
    if uses.takes_long and _entry_of(dialect, CANCELLED):
        yield "MAV_RESULT", "CANCELLED"
    if uses.has_modes:
        yield "MAV_CMD", "DO_SET_MODE"
        yield "MAV_MODE_FLAG", "CUSTOM_MODE_ENABLED"


def _entry_of(dialect: Dialect, name: str) -> bool:
    """Return whether the dialect has an entry of MAV_RESULT."""
    enum = dialect.enums.get("MAV_RESULT")
    return enum is not None and enum.entry(name) is not None
