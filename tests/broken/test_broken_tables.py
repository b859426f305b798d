"""Broken specifications: each is reported at its line and column, and generated/ stays as it was.

A case changes one file of the shipped specification: ``old`` becomes ``new``, in which ``§`` marks the place that the
diagnostic must point at (it is taken out before the file is written).
"""

import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest
from rover_alone import without_programs
from short_documents import shorten_documents

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Case:
    rule: str
    file: str
    old: str
    new: str
    says: str = ""
    exit_code: int = 1
    at: str = ""
    """The place, where it lies in another file than the change."""
    is_alone: bool = True
    """True: nothing else is found; a fault in the state or the facts is one for each table that reads it."""


BATTERY, SYS, HEARTBEAT = (f"messages/{name}.yaml" for name in ("battery_status", "sys_status", "heartbeat"))
RADIO = "  radio: {uart: 0, tx: 0, rx: 1, baud: 57600}\n"
LINK = "  wifi:\n    udp: 14550\n"
PROGRAM = "vehicle.yaml:3:1"
ARMING = "vehicle.yaml:37:3"
SHARE = '        unit: "%"\n        stored: "%"\n        min: 0\n        max: 100\n'
CHARGE = SHARE + "        left_of: BATT_CAPACITY\n        after: consumed\n"
ESTIMATED = "        estimate_from: voltage\n        curve: discharge\n"
"""An estimate of the charge that is left, in state.yaml."""

MILDER = "hold, return_to_launch, smart_return, smart_return_or_hold"

CASES = [
    # a value that contradicts the dialect
    Case(
        "sentinel-contradiction",
        BATTERY,
        "voltages: {each: battery.cells, state: battery.voltage, split: true, ",
        "voltages: {constant: §0, ",
        "UINT16_MAX",
    ),
    Case(
        "sentinel-contradiction", BATTERY, "temperature: {state: battery.temperature, ", "temperature: {constant: §-1, "
    ),
    Case(
        "sentinel-as-constant",
        BATTERY,
        "temperature: {state: battery.temperature, ",
        "temperature: {constant: §32767, ",
    ),
    Case("no-sentinel", SYS, "load: {state: vehicle.load}", "load: §unknown", "corrections"),
    Case("no-sentinel", "state.yaml", "        max: 100\n        initial: 0", "        max: 100"),
    Case("unit-mismatch", BATTERY, "{state: battery.consumed, ", "{state: §battery.current, ", "current (A)"),
    Case("unit-mismatch", "state.yaml", "stored: mA", "stored: §mAh", is_alone=False),
    Case("constant-out-of-range", SYS, "drop_rate_comm: {constant: 0", "drop_rate_comm: {constant: §70000 c%", "65535"),
    Case("bad-constant", SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: §0.5}"),
    Case("bad-constant", SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: §none}"),
    Case("bad-amount", SYS, "drop_rate_comm: {constant: 0", "drop_rate_comm: {constant: §1 percent"),
    Case(
        "unknown-enum-entry",
        HEARTBEAT,
        "enum: MAV_TYPE_GROUND_ROVER",
        "enum: §MAV_TYPE_GROUND_ROVR",
        "did you mean MAV_TYPE_GROUND_ROVER",
    ),
    Case(
        "unknown-enum-entry",
        HEARTBEAT,
        "enum: MAV_TYPE_GROUND_ROVER",
        "enum: §MAV_STATE_STANDBY",
        "belongs to MAV_STATE",
    ),
    Case(
        "unknown-enum-entry",
        "board.yaml",
        "chemistry: MAV_BATTERY_TYPE_LIPO",
        "chemistry: MAV_BATTERY_TYPE_LEAD",
        "MAV_BATTERY_TYPE",
        is_alone=False,
    ),
    Case(
        "unknown-enum",
        "state.yaml",
        "enum: MAV_STATE\n        initial: MAV_STATE_STANDBY",
        "enum: §MAV_STAT\n        initial: MAV_STATE_STANDBY",
    ),
    Case("not-an-enum-field", SYS, "errors_comm: {constant: 0}", "errors_comm: {enum: §MAV_STATE_STANDBY}"),
    Case(
        "not-an-enum-field", BATTERY, "mode: {enum: MAV_BATTERY_MODE_UNKNOWN, ", "mode: {flags: §[], ", "not a bitmask"
    ),
    Case(
        "not-a-boolean",
        SYS,
        "MAV_SYS_STATUS_SENSOR_BATTERY if battery.healthy",
        "MAV_SYS_STATUS_SENSOR_BATTERY if vehicle.mode",
    ),
    Case(
        "empty-limits",
        BATTERY,
        "battery_remaining: {state: battery.remaining, min: 0, max: 100",
        "battery_remaining: {state: battery.remaining, min: §101, max: 100",
    ),
    Case(
        "bad-source",
        BATTERY,
        "voltages: {each: battery.cells, state: battery.voltage, split: true, ",
        "voltages: {state: §battery.voltage, ",
        "split: true",
    ),
    Case(
        "bad-split",
        SYS,
        "voltage_battery: {state: battery.voltage}",
        "voltage_battery: {state: battery.voltage, split: §true}",
    ),
    Case(
        "bad-source",
        HEARTBEAT,
        "custom_mode: {state: vehicle.mode}",
        "custom_mode: {state: §vehicle.armed}",
        "custom_mode takes a number: keep it in a quantity with min: 0 and max: 1",
    ),
    # elements
    Case(
        "answered-twice",
        BATTERY,
        "  voltages: {each: battery.cells, state",
        "  voltages[3]: unknown\n  §voltages: {state",
        "answered twice",
        is_alone=False,
    ),
    Case("unanswered-field", SYS, "  errors_comm: {constant: 0}\n", "", "errors_comm"),
    Case(
        "unanswered-field",
        BATTERY,
        "  voltages_ext: {each: battery.cells, from: 10, ",
        "  voltages_ext[0..2]: {each: battery.cells, from: 10, ",
        "element 3",
    ),
    Case(
        "unknown-element",
        BATTERY,
        "  voltages_ext: {each: battery.cells, from: 10, ",
        "  §voltages_ext[0..4]: {each: battery.cells, from: 10, ",
        "0 to 3",
    ),
    Case("unknown-element", SYS, "  load: {", "  §load[0]: {"),
    Case("unknown-field", SYS, "  load: {", "  §laod: {", "did you mean load", is_alone=False),
    # references
    Case("unknown-message", SYS, "message: SYS_STATUS", "message: §SYS_STATS", "did you mean SYS_STATUS"),
    Case("unknown-stream", SYS, "stream: EXTENDED_STATUS", "stream: §EXTENDED_STATE"),
    Case("unknown-component", BATTERY, "for_each: battery", "for_each: §batery", is_alone=False),
    Case("bad-instance", BATTERY, "for_each: battery\n", "", "for_each"),
    Case("unknown-quantity", SYS, "load: {state: vehicle.load}", "load: {state: §vehicle.laod}", "vehicle.load"),
    Case("unknown-parameter", "streams.yaml", "parameter: SR0_EXTRA1", "parameter: §SR0_EXTRA2", "SR0_EXTRA1"),
    Case("unknown-adc", "state.yaml", "adc: battery_voltage", "adc: §batery_voltage"),
    Case("unknown-fact", BATTERY, "{board: battery.chemistry, ", "{board: §battery.chemstry, "),
    Case("unknown-fact", HEARTBEAT, "{dialect: version}", "{dialect: §versoin}"),
    Case("unknown-requirement", SYS, "requirement: FR-00068.9", "requirement: §FR-00068.99"),
    Case("unknown-requirement", SYS, "requirement: FR-00068.9", "requirement: §FR-00086"),
    Case("unknown-unit", "state.yaml", "unit: degC", "unit: §celsius", "did you mean degC?", is_alone=False),
    Case("unknown-unit", "state.yaml", "stored: mV/s", "stored: §mV/sec", "did you mean mV/s", is_alone=False),
    Case("unknown-unit", "parameters.yaml", "unit: mAh", "unit: §mah", "did you mean mAh", is_alone=False),
    Case("bad-amount", "scenarios.yaml", "noise: 10 mV", "noise: §10 millivolt", "did you mean mV"),
    # what measures the same, and is no multiple of it
    Case("uncarried-conversion", "state.yaml", "stored: cdegC", "stored: §K", "degC + 273.15 = K", is_alone=False),
    Case(
        "uncarried-conversion",
        "dialects/corrections_rfc_0018.yaml",
        "corrections:\n",
        "corrections:\n  - message: BATTERY_STATUS\n    field: temperature\n    set: {units: K}\n"
        "    reason: A test.\n    source: A test.\n",
        "cdegC * 0.01 + 273.15 = K",
        at="messages/battery_status.yaml:10:24",
        is_alone=False,
    ),
    Case(
        "unknown-unit",
        "dialects/corrections_rfc_0018.yaml",
        "corrections:\n",
        "corrections:\n  - message: BATTERY_STATUS\n    field: temperature\n    set: §{units: Kelvin}\n"
        "    reason: A test.\n    source: A test.\n",
        "did you mean K",
    ),
    Case(
        "unknown-unit",
        "dialects/battery_info_upstream.xml",
        'units="g"',
        'units="grm"',
        "did you mean g",
    ),
    # the vehicle
    Case("bad-adc", "board.yaml", "pin: BATT_VOLT_PIN", "gpio: §25"),
    Case("bad-adc", "board.yaml", "samples: 5", "samples: §0"),
    Case("bad-parameter", "parameters.yaml", "default: 3.95", "default: §13.95"),
    Case("bad-parameter", "parameters.yaml", "step: 0.0001", "step: §0"),
    Case("bad-stream", "streams.yaml", "    rate: 1 Hz\n    fastest: 50 Hz", "    fastest: 50 Hz"),
    Case("bad-time", "streams.yaml", "rate: 1 Hz", "rate: §0 Hz"),
    Case("bad-time", "streams.yaml", "rate: 1 Hz", "rate: §2 kHz"),
    Case("bad-amount", "streams.yaml", "rate: 1 Hz", "rate: §1e99999999 Hz"),
    Case("bad-time", "board.yaml", "read_limit: 2 ms", "read_limit: §0.1 us"),
    Case("bad-time", "state.yaml", "stale_after: 1 s", "stale_after: §90000 s"),
    Case("bad-stream", "parameters.yaml", "max: 50", "max: 5000"),
    Case("unknown-aspect", "board.yaml", "samples: FR-00066.2", "sample: §FR-00066.2"),
    Case("bad-quantity", "state.yaml", "max: 1000000", "max: §-1", is_alone=False),
    Case("bad-quantity", "state.yaml", "while_known: voltage", "while_known: voltage\n        initial: true"),
    Case("allocating-arithmetic", "parameters.yaml", "step: 0.0001", "step: 0.00001"),
    Case("bad-project", "codegen.yaml", "protocol: 2", "system_id: §0\nprotocol: 2"),
    Case("bad-project", "codegen.yaml", "protocol: 2", "protocol: §3"),
    Case("bad-project", "codegen.yaml", "output: ../generated", "output: §."),
    Case("bad-project", "codegen.yaml", "output: ../generated", "output: §.."),
    Case("bad-component", "state.yaml", "  vehicle:\n", "  §payload:\n", is_alone=False),
    Case("bad-quantity", "state.yaml", "      armed:\n", "      §lambda:\n", is_alone=False),
    Case("bad-quantity", "state.yaml", "      energy:\n", "      §voltage_mv: {doc: d}\n      energy:\n"),
    Case("bad-stream", "streams.yaml", "  EXTRA1:\n", "  §EXTRA-1:\n", is_alone=False),
    Case("bad-parameter", "parameters.yaml", "  SR0_EXTRA1:\n", "  §sr0_extra1:\n", is_alone=False),
    Case("bad-quantity", "state.yaml", "invalid_after: 5", "invalid_after: §0"),
    Case("bad-quantity", "state.yaml", "while_known: voltage", "while_known: §healthy"),
    Case(
        "pointless-key",
        BATTERY,
        "voltages: {each: battery.cells, state: battery.voltage, split: true, ",
        "voltages: {constant: 12.6 V, split: §true, ",
    ),
    Case("pointless-key", SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: 0, max: §3}"),
    Case("bad-project", "codegen.yaml", "component_id: MAV_COMP_ID_AUTOPILOT1", "component_id: §MAV_COMP_ID_ALL"),
    Case("not-an-enum-value", BATTERY, "  mode: {enum: MAV_BATTERY_MODE_UNKNOWN, ", "  §mode: {constant: 77, "),
    Case(
        "limit-beyond-field",
        SYS,
        "battery_remaining: {state: battery.remaining, min: 0, max: 100",
        "battery_remaining: {state: battery.remaining, min: 0, max: §300",
    ),
    Case(
        "limit-beyond-field",
        SYS,
        "battery_remaining: {state: battery.remaining, min: 0",
        "battery_remaining: {state: battery.remaining, min: §-1",
    ),
    Case("stale-before-update", "state.yaml", "stale_after: 1 s", "stale_after: §50 ms"),
    Case("bad-component", "state.yaml", "  vehicle:\n", "  §update_battery:\n", is_alone=False),
    Case(
        "corrected-twice",
        "dialects/corrections_rfc_0018.yaml",
        "corrections:\n",
        "corrections:\n"
        "  - {message: BATTERY_STATUS, fields: time_*, set: {invalid: 7}, reason: r, source: s}\n"
        "  - {message: BATTERY_STATUS, field: time_remaining, set: {invalid: 8}, reason: r, source: s}\n",
    ),
    Case("unknown-dialect", "codegen.yaml", "dialect: common", "dialect: §comon", "did you mean common", 2),
    # links
    Case("bad-link", "board.yaml", "  wifi:\n", "  §Wi-Fi:\n", "cannot be the name of a link"),
    Case("bad-link", "board.yaml", "  wifi:\n", "  §class:\n", "cannot be the name of a link"),
    Case("bad-link", "board.yaml", "udp: 14550", "udp: §0", "1 to 65535"),
    Case("bad-link", "board.yaml", "    to: 255.255.255.255\n", "", "needs to", at="board.yaml:36:3"),
    Case("bad-link", "board.yaml", "    credentials: wifi.json\n", "", "needs credentials", at="board.yaml:36:3"),
    Case("bad-link", "board.yaml", "    retry: 5 s\n", "", "needs retry", at="board.yaml:36:3"),
    Case("bad-link", "board.yaml", "    retry: 5 s\n", "    retry: 5 s\n    baud: §9600\n", "a link over UDP"),
    Case("bad-link", "board.yaml", "    retry: 5 s\n", "    retry: 5 s\n    local_port: §65536\n", "0 to 65535"),
    Case("bad-link", "board.yaml", "    retry: 5 s\n", "    retry: 5 s\n    buffer: §279\n", "280 to 65536"),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  radio: {uart: §2, tx: 0, rx: 1, baud: 57600}\n" + LINK,
        "UART 0 and 1 for links",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  radio: {uart: 0, tx: §30, rx: 1, baud: 57600}\n" + LINK,
        "0, 2, 12, 14, 16, 18 and 28",
    ),
    Case("bad-link", "board.yaml", LINK, "  radio: {uart: 0, tx: 0, rx: §-1, baud: 57600}\n" + LINK, "not -1"),
    Case("bad-link", "board.yaml", LINK, "  radio: {uart: 0, tx: 0, rx: 1, baud: §299}\n" + LINK, "300 to 3000000"),
    Case("bad-link", "board.yaml", LINK, "  §radio: {uart: 0, tx: 0, rx: 1}\n" + LINK, "needs baud"),
    Case("bad-link", "board.yaml", LINK, "  cable: {usb: true, tx: §0}\n" + LINK, "a link over USB"),
    Case("bad-link", "board.yaml", LINK, "  cable: {usb: true, to: §255.255.255.255}\n" + LINK, "a link over USB"),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        RADIO + "  other: {uart: §0, tx: 12, rx: 13, baud: 9600}\n" + LINK,
        "radio takes",
    ),
    Case(
        "shared-pin",
        "board.yaml",
        LINK,
        "  radio: {uart: 1, tx: §26, rx: 5, baud: 57600}\n" + LINK,
        "battery 1 and tx of radio are both on GPIO 26",
    ),
    Case("bad-link", "board.yaml", LINK, "  radio: {uart: 0, tx: 0, rx: §0, baud: 9600}\n" + LINK, "rx of UART 0 is"),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  §field: {tcp_server: 5760, retry: 5 s, timeout: 30 s}\n" + LINK,
        "a link over TCP server and needs credentials",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  §field: {tcp_server: 5760, credentials: wifi.json, retry: 5 s}\n" + LINK,
        "needs timeout",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  field: {tcp_server: §0, credentials: wifi.json, retry: 5 s, timeout: 30 s}\n" + LINK,
        "1 to 65535",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  field: {tcp_server: 1, backlog: §17, credentials: wifi.json, retry: 5 s, timeout: 30 s}\n" + LINK,
        "1 to 16",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  field: {tcp_server: 1, to: §1.2.3.4, credentials: wifi.json, retry: 5 s, timeout: 30 s}\n" + LINK,
        "says nothing about a link over TCP server",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  field: {tcp_server: 1, credentials: wifi.json, retry: 5 s, timeout: §1 s}\n" + LINK,
        "not 2 s or more",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  a: {tcp_server: 1, credentials: wifi.json, retry: 5 s, timeout: 9 s}\n  b: {tcp_server: §1, credentials: wifi.json, retry: 5 s, timeout: 9 s}\n"
        + LINK,
        "a takes already",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  §base: {tcp_client: 5760, credentials: wifi.json, retry: 5 s, timeout: 30 s}\n" + LINK,
        "needs to",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  base: {tcp_client: 5760, to: §1.2.3.255, credentials: wifi.json, retry: 5 s, timeout: 30 s}\n" + LINK,
        "is a broadcast",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  base: {tcp_client: 5760, to: §base.local, credentials: wifi.json, retry: 5 s, timeout: 30 s}\n" + LINK,
        "would block",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  base: {tcp_client: §70000, to: 1.2.3.4, credentials: wifi.json, retry: 5 s, timeout: 30 s}\n" + LINK,
        "1 to 65535",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  base: {tcp_client: 1, backlog: §2, to: 1.2.3.4, credentials: wifi.json, retry: 5 s, timeout: 30 s}\n" + LINK,
        "says nothing about a link over TCP client",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  base: {tcp_client: 1, to: 1.2.3.4, credentials: wifi.json, retry: §2 h, timeout: 30 s}\n" + LINK,
        "more than an hour",
    ),
    Case(
        "bad-link",
        "board.yaml",
        LINK,
        "  radio: {uart: 0, tx: 0, rx: 1, baud: 9600, timeout: §3 s}\n" + LINK,
        "says nothing about a link over UART",
    ),
    Case("bad-link", "board.yaml", LINK, "  a: {usb: true}\n  b: {usb: §true}\n" + LINK, "a takes already"),
    Case("bad-time", "board.yaml", "retry: 5 s", "retry: §0 s"),
    Case("wrong-type", "board.yaml", LINK, "  cable: {usb: §false}\n" + LINK),
    Case("one-of-keys", "board.yaml", LINK, "  cable: {usb: true, §uart: 0, tx: 0, rx: 1, baud: 9600}\n" + LINK),
    Case("one-of-keys", "board.yaml", LINK, "  §cable: {buffer: 1024}\n" + LINK),
    # the program
    Case(
        "bad-program",
        "state.yaml",
        "      load:\n",
        "      lead:\n",
        "needs a number load that can be set",
        at=ARMING,
        is_alone=False,
    ),
    Case(
        "bad-program",
        "state.yaml",
        "of the autopilot's own.\n        initial: 0\n        min: 0\n        max: 1000000\n",
        "of the autopilot's own.\n        boolean: true\n        initial: false\n",
        "needs a number mode",
        at=ARMING,
        is_alone=False,
    ),
    Case(
        "bad-program",
        "state.yaml",
        "  vehicle:\n",
        "  rover:\n",
        "no single component vehicle",
        at=PROGRAM,
        is_alone=False,
    ),
    Case(
        "bad-program",
        "board.yaml",
        "instances:\n",
        "instances:\n  vehicle: [{doc: One.}, {doc: Two.}]\n",
        "no single",
        at=PROGRAM,
        is_alone=False,
    ),
    Case("bad-program", "vehicle.yaml", "files: [parameters.0, parameters.1]", "files: §[parameters.0]"),
    Case("bad-program", "vehicle.yaml", "files: [parameters.0, parameters.1]", "files: §[a, b, c]"),
    Case("bad-program", "vehicle.yaml", "chunk: 64", "chunk: §15", "16 to 256"),
    Case("bad-program", "vehicle.yaml", "chunk: 64", "chunk: §257", "16 to 256"),
    Case("bad-program", "vehicle.yaml", "call: hold", "call: §return_to_launch", "a call of its own"),
    Case("bad-program", "vehicle.yaml", "call: hold", "call: §Hold", "a call of its own"),
    Case("bad-program", "vehicle.yaml", "call: hold", "call: §control", "a call of its own"),
    Case("bad-program", "vehicle.yaml", "call: hold", "call: §pass", "a call of its own"),
    Case("bad-program", "vehicle.yaml", "value: 5, call: terminate", "value: §4, call: terminate", "another action"),
    Case("bad-time", "vehicle.yaml", "rate: 400 Hz", "rate: §1200 Hz"),
    Case("bad-time", "vehicle.yaml", "report_every: 10 s", "report_every: §0 s"),
    Case("bad-time", "vehicle.yaml", "fastest: 10 Hz", "fastest: §2 kHz"),
    Case("unit-mismatch", "vehicle.yaml", "rate: 400 Hz", "rate: §2500 us"),
    Case("unknown-requirement", "vehicle.yaml", "requirement: FR-00071\n", "requirement: §FR-00071.99\n"),
    Case("unknown-key", "vehicle.yaml", "control:\n", "§contrl:\n", "did you mean control"),
    Case("unknown-key", "vehicle.yaml", "  chunk: 64", "  §chunks: 64", "did you mean chunk"),
    Case("unknown-key", "vehicle.yaml", "  force: 21196", "  force: 21196\n  §forced: 1", "did you mean force"),
    Case("unknown-key", "vehicle.yaml", "    health: health", "    §heath: health", "did you mean health"),
    Case("unknown-key", "vehicle.yaml", "low: {below: ", "low: {§belo: ", "did you mean below", is_alone=False),
    Case("unknown-key", "vehicle.yaml", "disarm: true", "§disarms: true", "did you mean disarm"),
    Case("missing-key", "vehicle.yaml", "  fastest: 10 Hz\n", "", "fastest", at="vehicle.yaml:42:3"),
    # failsafes
    Case(
        "bad-failsafe", "vehicle.yaml", "watches: battery.voltage", "watches: §batery.voltage", "did you mean battery"
    ),
    Case(
        "unknown-quantity",
        "vehicle.yaml",
        "watches: battery.voltage",
        "watches: §battery.volts",
        "did you mean voltage",
    ),
    Case("bad-failsafe", "vehicle.yaml", "watches: battery.voltage", "watches: §battery.healthy", "not a number"),
    Case(
        "bad-failsafe",
        "vehicle.yaml",
        "to_arm: [{below: BATT_ARM_VOLT}",
        "to_arm: [" + ", ".join(["{below: BATT_ARM_VOLT}"] * 27),
        "it has 32 conditions, and at most 30",
        at="vehicle.yaml:62:3",
    ),
    Case("bad-failsafe", "vehicle.yaml", "watches: battery.voltage", "watches: §battery.cells", "not a number"),
    Case("bad-failsafe", "vehicle.yaml", "low: {below: BATT_LOW_VOLT", "low: {below: §BATT_CAPACITY", "no threshold"),
    Case("bad-failsafe", "vehicle.yaml", "critical: {below: BATT_CRT_VOLT", "critical: {below: §BATT_VOLT_MULT"),
    Case("unit-mismatch", "vehicle.yaml", "low: {below: BATT_LOW_VOLT", "low: {below: §3 A"),
    Case("bad-failsafe", "vehicle.yaml", "low: {below: BATT_LOW_VOLT", "low: {below: §0.1 mV", "not in whole mV"),
    Case("bad-failsafe", "vehicle.yaml", "low: {below: BATT_LOW_VOLT, action", "§low: {action", "exactly one of"),
    Case("bad-failsafe", "vehicle.yaml", "to_arm: [{below: BATT_ARM_VOLT}", "to_arm: [{below: §SR0_EXTRA1}"),
    Case(
        "bad-failsafe",
        "vehicle.yaml",
        "to_arm: [{below: BATT_ARM_VOLT}",
        "to_arm: [{below: BATT_ARM_VOLT, after: §2 s}",
        "no time",
    ),
    Case("one-of-keys", "vehicle.yaml", "to_arm: [{below: BATT_ARM_VOLT}", "to_arm: [§{watches: battery.left}"),
    Case(
        "bad-failsafe",
        "vehicle.yaml",
        "to_arm: [{below: BATT_ARM_VOLT}",
        "to_arm: [{watches: §vehicle.mode, below: 3}",
        "another component",
    ),
    Case("bad-failsafe", "vehicle.yaml", "action: BATT_FS_LOW_ACT", "action: §BATT_LOW_TIMER", "none of the actions"),
    Case("bad-failsafe", "vehicle.yaml", "action: BATT_FS_LOW_ACT", "action: §holds", "did you mean hold"),
    Case("bad-failsafe", "vehicle.yaml", "after: BATT_LOW_TIMER", "after: §BATT_LOW_VOLT", "not a time"),
    Case("bad-failsafe", "vehicle.yaml", "after: BATT_LOW_TIMER", "after: §5 h", "at most four hours"),
    Case("bad-failsafe", "vehicle.yaml", "health: health", "health: §trend", "initial value"),
    Case("bad-failsafe", "vehicle.yaml", "health: health", "health: §failsafe", "has the level already"),
    Case(
        "bad-failsafe",
        "vehicle.yaml",
        'text: "{name} is {level}[ {voltage:.2}V][ used {consumed} mAh]"',
        'text: §"{consummed or 0} mAh"',
        "did you mean consumed",
    ),
    Case("bad-failsafe", "vehicle.yaml", 'text: "{name}', 'text: §"{{name}', "braces"),
    Case("bad-failsafe", "vehicle.yaml", 'text: "{name}', 'text: §"[{name}', "braces, brackets"),
    Case("bad-failsafe", "vehicle.yaml", 'text: "{name}', 'text: §"[Pack] {name}', "[Pack] shows no quantity"),
    Case(
        "bad-failsafe",
        "vehicle.yaml",
        "{voltage:.2}V]",
        "{voltage:.2} mV]",
        "shown in V, and the text goes on with mV",
        at="vehicle.yaml:72:11",
    ),
    Case("bad-failsafe", "vehicle.yaml", "title: Battery {number}", "title: §Battery", "which it is"),
    Case("bad-failsafe", "vehicle.yaml", "title: Battery {number}", "title: §Battery {instance}", "no title"),
    Case("bad-failsafe", "vehicle.yaml", "health_every: 10 s", "hysteresis: §0.1 V", "write latch: false"),
    Case("bad-failsafe", "vehicle.yaml", "health_every: 10 s", "over: §It is over", "never over"),
    Case("bad-failsafe", "vehicle.yaml", "      low: {", "      §Low!: {", "no name of a level"),
    Case(
        "bad-priority",
        "vehicle.yaml",
        "actions:\n",
        f"priority: §[halt, {MILDER}, terminate]\nactions:\n",
        "no action halt",
    ),
    Case("bad-priority", "vehicle.yaml", "actions:\n", f"priority: §[{MILDER}]\nactions:\n", "terminate has no place"),
    Case(
        "bad-priority",
        "vehicle.yaml",
        "actions:\n",
        f"priority: §[terminate, {MILDER}, hold]\nactions:\n",
        "a place already",
    ),
    Case(
        "unknown-key",
        "vehicle.yaml",
        "watches: battery.voltage",
        "watches: battery.voltage\n    §used: consumed",
        "stands in text:",
    ),
    Case(
        "unknown-key",
        "vehicle.yaml",
        "watches: battery.voltage",
        "watches: battery.voltage\n    §quantity: voltage",
        "says watches:",
    ),
    Case(
        "unknown-key",
        "vehicle.yaml",
        "watches: battery.voltage",
        "watches: battery.voltage\n    §low: {below: BATT_LOW_VOLT}",
        "levels: {low:",
    ),
    Case("unknown-requirement", "vehicle.yaml", "    requirement: FR-00020\n", "    requirement: §FR-20\n"),
    # the system id
    Case("bad-project", "codegen.yaml", "protocol: 2", "system_id: §7\nprotocol: 2", "vehicle.yaml has a parameter"),
    Case("bad-project", "vehicle.yaml", "system_id: SYSID_THISMAV", "system_id: §BATT_CAPACITY", "from 1 to 255"),
    Case("bad-project", "vehicle.yaml", "system_id: SYSID_THISMAV", "system_id: §BATT_VOLT_MULT", "from 1 to 255"),
    Case(
        "bad-project",
        "parameters.yaml",
        "default: 1\n    min: 1\n    max: 255",
        "default: 1\n    min: 0\n    max: 255",
        "from 1 to 255",
        at=PROGRAM.replace("3:1", "3:12"),
    ),
    # parameters
    Case("bad-parameter", "parameters.yaml", "type: int32\n", "type: §int8\n", "int8 does not carry"),
    Case("bad-parameter", "parameters.yaml", "type: int32\n", "type: §uint16\n", "uint16 does not carry"),
    Case(
        "bad-parameter",
        "parameters.yaml",
        "    default: 3.95\n",
        "    type: §int16\n    default: 3.95\n",
        "step of 0.0001",
    ),
    Case("bad-parameter", "parameters.yaml", "3: Analog Voltage Only", "three: §Analog, 3: Voltage", "not a number"),
    Case("bad-parameter", "parameters.yaml", "3: Analog Voltage Only", "3: Analog, 30: §Other", "a value that"),
    Case("bad-parameter", "parameters.yaml", "3: Analog Voltage Only", "3: Analog, 1.5: §Other", "a value that"),
    Case("bad-parameter", "parameters.yaml", "default: 3\n", "default: §1\n", "none of its values"),
    Case("unknown-choice", "parameters.yaml", "type: int32", "type: §int64"),
    # keys that name a parameter
    Case("unknown-parameter", "board.yaml", "pin: BATT_VOLT_PIN", "pin: §BATT_VOLTS_PIN", "did you mean BATT_VOLT_PIN"),
    Case("unknown-parameter", "state.yaml", "enabled_by: BATT_MONITOR", "enabled_by: §BATT_MONITR", "BATT_MONITOR"),
    Case("unknown-parameter", "state.yaml", "multiplier: BATT_VOLT_MULT", "multiplier: §BATT_VOLT_MUL"),
    Case("unknown-parameter", "vehicle.yaml", "system_id: SYSID_THISMAV", "system_id: §SYSID_THISMAW", "SYSID_THISMAV"),
    Case("unknown-parameter", "vehicle.yaml", "low: {below: BATT_LOW_VOLT", "low: {below: §BATT_LOW_VOLTS"),
    Case("unknown-parameter", "vehicle.yaml", "action: BATT_FS_LOW_ACT", "action: §BATT_FS_LO_ACT", "BATT_FS_LOW_ACT"),
    Case("unknown-parameter", "vehicle.yaml", "below: BATT_CRT_VOLT", "below: §BATT_CRIT_VOLT", "BATT_CRT_VOLT"),
    Case("unknown-parameter", "vehicle.yaml", "action: BATT_FS_CRT_ACT", "action: §BATT_FS_ACT"),
    Case("unknown-parameter", "vehicle.yaml", "after: BATT_LOW_TIMER", "after: §BATT_LOW_TIME", "BATT_LOW_TIMER"),
    Case("unknown-parameter", "vehicle.yaml", "to_arm: [{below: BATT_ARM_VOLT", "to_arm: [{below: §BATT_ARM_VOLTS"),
    # pins by parameter
    Case("bad-adc", "board.yaml", "pin: BATT_VOLT_PIN", "pin: §BATT_CAPACITY", "26 to 28"),
    Case("bad-adc", "board.yaml", "pin: BATT_VOLT_PIN", "pin: §BATT_VOLT_MULT", "26 to 28"),
    Case("bad-adc", "board.yaml", "pin: BATT_VOLT_PIN", "gpio: §30", "26 to 28"),
    Case("one-of-keys", "board.yaml", "pin: BATT_VOLT_PIN", "gpio: 26\n    §pin: BATT_VOLT_PIN"),
    Case("one-of-keys", "board.yaml", "    pin: BATT_VOLT_PIN\n", "", "none is given", at="board.yaml:6:3"),
    # streams
    Case("bad-stream", "streams.yaml", "MAV_DATA_STREAM_EXTRA1", "§MAV_DATA_STREAM_EXTRA9", "MAV_DATA_STREAM_EXTRA1"),
    Case("bad-stream", "streams.yaml", "data_stream: MAV_DATA_STREAM_EXTRA1", "data_stream: §MAV_DATA_STREAM_ALL"),
    Case("bad-time", "streams.yaml", "fastest: 50 Hz", "fastest: §1001 Hz"),
    Case("unit-mismatch", "streams.yaml", "fastest: 50 Hz", "fastest: §50 V"),
    # quantities that are computed
    Case("bad-trend", "state.yaml", "trend_of: voltage", "trend_of: §volts", "did you mean voltage"),
    Case("bad-trend", "state.yaml", "trend_of: voltage", "trend_of: §temperature"),
    Case(
        "bad-trend", "state.yaml", "        trend_of: voltage\n", "", "both trend_of and window", at="state.yaml:128:17"
    ),
    Case("bad-trend", "state.yaml", "        window: 4 s\n", "", "both trend_of and window", at="state.yaml:128:19"),
    Case("bad-trend", "state.yaml", "window: 4 s", "window: §300 ms", "even number of readings"),
    Case("bad-trend", "state.yaml", "window: 4 s", "window: §21 s", "4 to 200"),
    Case("bad-trend", "state.yaml", "window: 4 s", "window: §410 ms", "even number of readings"),
    Case(
        "bad-trend",
        "state.yaml",
        "    update_rate: 10 Hz\n",
        "",
        "needs an update_rate",
        at="state.yaml:128:17",
        is_alone=False,
    ),
    Case("bad-trend", "state.yaml", "stored: mV/s", "stored: §V/s", "mV/s, not V/s"),
    Case("bad-time", "state.yaml", "warn_every: 10 s", "warn_every: §0 s"),
    Case("bad-quantity", "state.yaml", "unit: hJ\n", "unit: hJ\n        warn_every: §1 s\n", "no adc"),
    Case("bad-quantity", "state.yaml", "boolean: true\n        enabled_by: ", "enabled_by: §", "a boolean"),
    Case(
        "bad-quantity",
        "state.yaml",
        "        trend_of: voltage\n",
        "        trend_of: voltage\n        stale_after: §1 s\n",
        "not set by code",
    ),
    Case(
        "bad-quantity",
        "state.yaml",
        "        trend_of: voltage\n",
        "        adc: battery_voltage\n        trend_of: §voltage\n",
        "one source, not both adc and trend_of",
    ),
    Case(
        "bad-quantity",
        "state.yaml",
        "while_known: voltage\n",
        "while_known: voltage\n        enabled_by: §BATT_MONITOR\n",
        "one source",
    ),
    Case(
        "bad-quantity",
        "state.yaml",
        "        while_known: voltage\n",
        "        while_known: voltage\n        estimate_from: §voltage\n",
        "cannot have estimate_from",
    ),
    # scenarios
    Case("scenario-points", "scenarios.yaml", "[[0 s, 12.3 V], [60 s, 12.1 V]]", "[[60 s, 12.3 V], [§1 s, 12.1 V]]"),
    Case("scenario-points", "scenarios.yaml", "[[0 s, 12.3 V], [60 s, 12.1 V]]", "[[0 s, 12.3 V], §[60 s]]", "12.6 V"),
    Case("scenario-time", "scenarios.yaml", "duration: 60 s", "duration: §0 s", "from 1 ms to a day"),
    Case("scenario-time", "scenarios.yaml", "at: 5 s, arm", "at: §61 s, arm", "after the end"),
    Case(
        "scenario-event",
        "scenarios.yaml",
        "fault: slow, of: battery.voltage, delay: 3 ms",
        "fault: §slow, of: battery.voltage",
        "need a delay",
    ),
    Case("scenario-event", "scenarios.yaml", "at: 5 s, arm: true", "at: 5 s, arm: true, for: §1 s"),
    Case("scenario-points", "scenarios.yaml", "noise: 10 mV", "noise: §-1 mV"),
    Case("scenario-course", "scenarios.yaml", "battery.voltage:", "§battery.charging:", "has no course of its own"),
    Case("unit-mismatch", "scenarios.yaml", "noise: 10 mV", "noise: §10 ms"),
    Case("unknown-key", "scenarios.yaml", "noise: 10 mV", "§nois: 10 mV", "did you mean noise"),
    Case("scenario-event", "scenarios.yaml", "fault: fail, of", "fault: §fial, of", "did you mean fail"),
    # an estimate
    Case("bad-estimate", "state.yaml", CHARGE, SHARE + "        estimate_from: §volts\n", "did you mean voltage"),
    Case("bad-estimate", "state.yaml", CHARGE, SHARE + "        estimate_from: §current\n", "no curve is named"),
    Case("bad-estimate", "state.yaml", CHARGE, SHARE + "        estimate_from: §voltage\n", "curve: and its name: dis"),
    Case("bad-estimate", "state.yaml", CHARGE, SHARE + ESTIMATED.replace(": dis", ": §dus"), "did you mean discharge"),
    Case("bad-quantity", "state.yaml", "reaches: charging_m", "reaches: §chargin_m", "did you mean charging_maximum_v"),
    Case(
        "unit-mismatch",
        "state.yaml",
        "reaches: charging_maximum_voltage",
        "reaches: §weight",
        "250 g is no amount in V",
    ),
    Case(
        "unit-mismatch", "state.yaml", "reaches: charging_maximum_voltage", "reaches: §12 A", "12 A is no amount in V"
    ),
    Case(
        "unit-mismatch",
        HEARTBEAT,
        "{state: vehicle.mode}",
        "{state: §battery.current}",
        "can say that custom_mode is in",
        is_alone=False,
    ),
    Case(
        "bad-source",
        HEARTBEAT,
        "system_status: {state: vehicle.status",
        "system_status: {state: §vehicle.armed",
        "keep an entry of MAV_STATE in a quantity with enum: MAV_STATE",
    ),
    Case(
        "bad-source",
        SYS,
        "_present_extended: {flags: []}",
        "_present_extended: {state: §vehicle.armed}",
        "use it in 'flags'",
    ),
    Case("wrong-type", "streams.yaml", "rate: 1 Hz", "rate: §1_0 Hz", "a number with its unit"),
    Case(
        "bad-time",
        "state.yaml",
        "update_rate: 10 Hz",
        "update_rate: §60 Hz",
        "62.5 Hz is once in 16 ms",
        is_alone=False,
    ),
    Case(
        "bad-quantity",
        "state.yaml",
        "      voltage:\n        doc: Voltage of",
        '      guess: {doc: g, unit: "%", min: 0, max: 100, estimate_from: voltage, curve: discharge}\n'
        "      §estimate: {doc: e}\n      voltage:\n        doc: Voltage of",
        "cannot be the name",
    ),
]

ESTIMATE = "state.yaml:80:16"
CHEMISTRY = "messages/battery_status.yaml:9:17"
POINTS = "        {4.20 V: 100, 4.15 V: 95"
ESTIMATES = [
    Case("bad-estimate", "board.yaml", POINTS, "        §{4.20 V: 100, 4.15 V: 85", "rise or fall throughout"),
    Case("bad-estimate", "board.yaml", POINTS, "        {4.20 V: §101, 4.15 V: 95", "101 is not within 0 to 100"),
    Case("bad-estimate", "board.yaml", "4.15 V: 95", "4.15 V: §95.5", "whole number of %"),
    Case(
        "bad-estimate", "board.yaml", "4.15 V: 95", "4.1505 V: §95", "4.1505 V times 3 is no whole mV, and voltage is"
    ),
    Case("bad-estimate", "board.yaml", "4.15 V: 95", "4.1505 V: §95", "stored: uV at voltage, or round it"),
    Case(
        "bad-estimate", "board.yaml", POINTS, "        §{4.20 V: 100, 4.15 V: 96, 4150 mV: 95", "at different amounts"
    ),
    Case("bad-estimate", "board.yaml", "4.15 V: 95", "4.15 A: §95", "no amount of voltage, which is in mV"),
    Case("bad-estimate", "board.yaml", "4.15 V: 95", "much: §95", "no amount of voltage, which is in mV"),
    Case("bad-estimate", "board.yaml", "    by:\n", "    points: {4 V: 1}\n    by:\n", "has points and points by"),
    Case("bad-estimate", "board.yaml", "choice: chemistry", "choice: §chemistri", "did you mean chemistry"),
    Case("bad-estimate", "board.yaml", "    choice: chemistry\n", "", "neither points, nor a choice"),
    Case("bad-estimate", "board.yaml", "    per: cells\n", "    per: cell\n", "did you mean cells", at=ESTIMATE),
    Case("bad-estimate", "board.yaml", "cells: 3", "cells: 0", "not a whole number", at=ESTIMATE, is_alone=False),
    Case(
        "bad-estimate",
        "board.yaml",
        "      MAV_BATTERY_TYPE_LIPO:\n",
        "      MAV_BATTERY_TYPE_LIP:\n",
        "did you mean MAV_BATTERY_TYPE_LIP",
        at="board.yaml:46:16",
    ),
    Case(
        "unknown-enum-entry",
        "board.yaml",
        "chemistry: MAV_BATTERY_TYPE_LIPO",
        "chemistry: MAV_BATTERY_TYPE_LIP",
        at=CHEMISTRY,
        is_alone=False,
    ),
]
"""With ``ESTIMATED`` in state.yaml."""


def changed_copy(case: Case, folder: Path) -> tuple[Path, str | None]:
    """Copy the project with the change; return the changed file and the marked ``line:col``."""
    if not (folder / "specs").exists():
        shutil.copytree(ROOT / "specs", folder / "specs")
    path = folder / "specs" / case.file
    text = path.read_text()
    assert text.count(case.old) >= 1, f"{case.old!r} is not in {case.file}"
    text = text.replace(case.old, case.new, 1)
    before, mark, after = text.partition("§")
    path.write_text(before + after)
    if not mark:
        return path, None
    return path, f"{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"


WITH_PROGRAMS = ("codegen.yaml", "scenarios.yaml", "smart_battery/")
"""The files that cases about further programs change; others need the rover alone, which is read in half the time."""


def check_place(case: Case, folder: Path, monkeypatch, capsys) -> None:
    """A build finds what the case says, at its place, and writes nothing. ``folder`` has the changed project."""
    path, place = changed_copy(case, folder)
    if not case.file.startswith(WITH_PROGRAMS):
        without_programs(folder / "specs")
    wanted = f"specs/{case.at}" if case.at else f"{path.relative_to(folder)}:{place}" if place else ""
    (folder / "generated").mkdir()
    (folder / "generated" / "keep.txt").write_text("as it was")
    monkeypatch.chdir(folder)
    exit_code = main(["build"])
    out, err = capsys.readouterr()
    errors = [line for line in out.splitlines() if ": error " in line]
    found = [line for line in errors if f" {case.rule}: " in line]
    assert found, out + err
    if wanted:
        assert any(line.startswith(f"{wanted}: error ") for line in found), (wanted, found)
    assert len(errors) == 1 or not case.is_alone, errors
    assert case.says in out
    assert exit_code == case.exit_code
    assert [item.name for item in (folder / "generated").iterdir()] == ["keep.txt"]


DRAFTS = {
    "messages/battery_status_v2.yaml": "battery_upstream",
    "messages/battery_cell_voltages.yaml": "battery_cell_voltages_rfc_0018",
}
"""Tables that count only with the overlay that they are for."""


def about_their_drafts(cases):
    """The cases, those about one of these tables marked with its overlay."""
    about = [
        (each, [draft for table, draft in DRAFTS.items() if table in (each.file, each.at.split(":")[0])])
        for each in cases
    ]
    return [pytest.param(each, marks=pytest.mark.draft(*drafts)) for each, drafts in about]


def name_of(case: Case) -> str:
    return f"{case.rule}-{case.file.rpartition('/')[2]}"


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)


@pytest.mark.parametrize("case", ESTIMATES, ids=name_of)
def test_an_estimate_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The same, where state.yaml asks for an estimate of the charge."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    state = tmp_path / "specs" / "state.yaml"
    assert CHARGE in state.read_text()
    state.write_text(state.read_text().replace(CHARGE, SHARE + ESTIMATED))
    check_place(case, tmp_path, monkeypatch, capsys)


def findings(capsys) -> list[str]:
    """The errors of a check in the working directory."""
    assert main(["check"]) == 1
    return [line for line in capsys.readouterr().out.splitlines() if ": error " in line]


@pytest.mark.draft("battery_cell_voltages_rfc_0018")
def test_a_message_without_stream_needs_a_program(tmp_path, monkeypatch, capsys):
    """Nothing sends it: one finding for each, at the top of its table."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    (tmp_path / "specs" / "vehicle.yaml").unlink()
    monkeypatch.chdir(tmp_path)
    found = [line for line in findings(capsys) if " error bad-announcement: " not in line]
    assert [line.partition(": ")[0] for line in found] == [
        f"specs/messages/{name}.yaml:2:1" for name in ("autopilot_version", "battery_cell_voltages", "protocol_version")
    ]
    assert all(" error unknown-stream: " in line for line in found)


def test_a_dialect_without_the_services(tmp_path, monkeypatch, capsys):
    """A dialect without the program's needs has one finding for the messages, one for the entries of enums."""
    shutil.copytree(ROOT / "tests" / "projects" / "minimal" / "specs", tmp_path / "specs")
    quantities = {
        "armed": "boolean: true, initial: false",
        "ready": "boolean: true, initial: false",
        "mode": "initial: 0",
        "load": "initial: 0",
    }
    with (tmp_path / "specs" / "state.yaml").open("a") as file:
        file.writelines(f"      {name}: {{doc: d, {keys}}}\n" for name, keys in quantities.items())
    (tmp_path / "specs" / "vehicle.yaml").write_text(
        "control: {rate: 50 Hz, report_every: 1 s, links: 50 Hz}\nstorage: {files: [a, b], chunk: 16, step_limit: 1 ms}\narming: {force: 1}\n"
        "services: {fastest: 1 Hz}\n"
    )
    monkeypatch.chdir(tmp_path)
    messages, entries = findings(capsys)
    assert messages.startswith("specs/vehicle.yaml:1:1: error no-service-message: minimal has no enum entry MAV_CMD_")
    assert entries.startswith("specs/vehicle.yaml:1:1: error no-service-message: minimal has no message PING, ")


def test_scenarios_are_checked_though_the_rest_is_broken(tmp_path, monkeypatch, capsys):
    """A specification that cannot be resolved does not hide what is wrong with the scenarios, and they may be absent."""
    changed_copy(Case("", "scenarios.yaml", "duration: 60 s", "duration: 0 s"), tmp_path)
    shorten_documents(tmp_path / "specs")
    streams = tmp_path / "specs" / "streams.yaml"
    streams.write_text("streams: 3\n")
    monkeypatch.chdir(tmp_path)
    found = findings(capsys)
    assert [line.split(" error ")[1].partition(":")[0] for line in found] == ["scenario-time", "wrong-type"]
    shutil.copy(ROOT / "specs" / "streams.yaml", streams)
    (tmp_path / "specs" / "scenarios.yaml").unlink()
    assert main(["check"]) == 0


def test_everything_is_reported_in_one_run(tmp_path, monkeypatch, capsys):
    """Faults in different files are all shown, ordered by place."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    wanted = []
    for case in (CASES[0], CASES[3], CASES[11], CASES[33], CASES[40]):
        path = tmp_path / "specs" / case.file
        path.write_text(path.read_text().replace(case.old, case.new.replace("§", ""), 1))
        wanted.append(case.rule)
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    out = capsys.readouterr().out
    assert all(f" error {rule}: " in out for rule in wanted), out
    places = [line.split(" ")[0] for line in out.splitlines() if " error " in line and not line.startswith(" ")]
    assert places == sorted(places, key=lambda place: (place.split(":")[0], int(place.split(":")[1])))


FOLLOW_UPS = [
    ("board.yaml", "board: pico_2_w\n", "board: pico_3_w\n", "unknown-board"),
    ("parameters.yaml", "    default: 1\n    min: 1\n", "    min: 1\n", "missing-key"),
    ("parameters.yaml", "    default: 3.5\n", "    default: 1e9\n", "bad-parameter"),
    ("streams.yaml", "    doc: Detailed battery telemetry.\n", "", "missing-key"),
    ("state.yaml", "max: 1000000", "max: -1", "bad-quantity"),
    ("vehicle.yaml", "  chunk: 64\n", "", "missing-key"),
    ("vehicle.yaml", "rate: 400 Hz", "rate: 400", "wrong-type"),
    ("board.yaml", "samples: 5", "samples: 0", "bad-adc"),
    ("board.yaml", LINK, f'  radio: {{uart: 0, tx: 0, rx: 1, baud: "57600"}}\n{LINK}', "wrong-type"),
    ("board.yaml", LINK, f"  radio: {{uart: 0, tx: 0, rx: one, baud: 57600}}\n{LINK}", "wrong-type"),
    ("state.yaml", "invalid_after: 5", "invalid_after: -3", "bad-quantity"),
    (
        BATTERY,
        "  voltages_ext: {each: battery.cells, from: 10, ",
        "  voltages_ext[0..12]: {each: battery.cells, from: 10, ",
        "unknown-element",
    ),
    (SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: .nan}", "unusable-number"),
    (SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: 0, unknown: true}", "one-of-keys"),
]


@pytest.mark.parametrize(("file", "old", "new", "rule"), FOLLOW_UPS, ids=[case[3] for case in FOLLOW_UPS])
def test_one_fault_is_one_finding(file, old, new, rule, tmp_path, monkeypatch, capsys):
    """Consequences of a fault are not reported as well: the cause stands alone."""
    changed_copy(Case(rule, file, old, new), tmp_path)
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) in (1, 2)
    errors = [line for line in capsys.readouterr().out.splitlines() if ": error " in line]
    assert len({line.split(" error ")[1].split(":")[0] for line in errors}) == 1, errors
    assert f" error {rule}: " in errors[0]
