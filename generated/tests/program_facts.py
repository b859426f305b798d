# Generated from specs/board.yaml, specs/codegen.yaml, specs/dialects/battery_cell_voltages_rfc_0018.xml,
#   specs/dialects/battery_upstream.xml, specs/dialects/corrections.yaml,
#   specs/dialects/corrections_rfc_0018.yaml, specs/dialects/protocol_version.xml,
#   specs/dialects/upstream.xml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_status.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/protocol_version.yaml, specs/messages/sys_status.yaml,
#   specs/parameters.yaml, specs/state.yaml, specs/streams.yaml, specs/vehicle.yaml: do not edit.
# Inputs: 6ddb5fc60f149434
"""What the specification says about the program, for the checks of the program to compare with."""

CONTROL_US = 2500
LINKS_US = 10000
STEP_LIMIT_US = 10000
REPORT_MS = 10000
HEALTH_MS = 10000
FILES = ("parameters.0", "parameters.1")
CHUNK = 64
FORCE_ARM = 21196
SYSTEM_ID = 1
COMPONENT_ID = 1
VERSION = 2

# The document that each topic's criteria are numbered in; "" where the specification cites none.
REQUIREMENTS = {
    "failsafe": "FR-00020",
    "health": "FR-00021",
    "reading": "FR-00066",
    "update": "FR-00067",
    "telemetry": "FR-00068",
    "conversion": "FR-00069",
    "services": "FR-00070",
    "loop": "FR-00071",
    "storage": "NFR-00061",
    "steady": "NFR-00060",
    "scenarios": "NFR-00062",
}

# Measured components: where they are read, how counts become stored steps, and when a value is given up.
MEASURED = (
    {
        "component": "battery",
        "first": "battery",
        "attribute": "voltage_mv",
        "gpio": 26,
        "pin": "batt_volt_pin",
        "spare_bits": 0,
        "full_scale": 4095,
        "samples": 5,
        "read_limit_us": 2000,
        "multiplier": "batt_volt_mult",
        "multiplier_name": "BATT_VOLT_MULT",
        "latched": True,
        "numerator": 11,
        "denominator": 136500,
        "warn_above": 13000,
        "warn_every_ms": 10000,
        "warning_count": 4085,
        "invalid_after": 5,
        "stale_after_ms": 1000,
        "period_us": 100000,
        "enabled": "monitored",
        "enabled_by": "batt_monitor",
        "trend": "trend_mv_s",
        "trend_half": 20,
        "estimate": None,
        "estimate_points": [],
    },
)

# Failsafes; a threshold in stored steps is the parameter's steps times its scale.
FAILSAFES = (
    {
        "component": "battery",
        "title": "Battery 1",
        "quantity": "voltage",
        "attribute": "voltage_mv",
        "unit": "V",
        "divisor": 1000,
        "low": "batt_low_volt",
        "low_scale": 1,
        "low_action": "batt_fs_low_act",
        "critical": "batt_crt_volt",
        "critical_scale": 1,
        "critical_action": "batt_fs_crt_act",
        "after": "batt_low_timer",
        "minimum": "batt_arm_volt",
        "minimum_scale": 1,
        "health": "health_number",
        "used": "consumed_mah",
        "enabled": "monitored",
    },
)

# Actions: value of the parameter, call, drive mode (None: stays), whether the vehicle is disarmed.
ACTIONS = (
    (1, "return_to_launch", 11, False),
    (2, "hold", 4, False),
    (3, "smart_return", 12, False),
    (4, "smart_return_or_hold", 12, False),
    (5, "terminate", None, True),
)

# Parameters: name, attribute, default, smallest and largest in steps; a value is steps * numerator / denominator.
PARAMETERS = (
    {
        "name": "BATT_ARM_VOLT",
        "attribute": "batt_arm_volt",
        "default": 0,
        "minimum": 0,
        "maximum": 100000,
        "numerator": 1,
        "denominator": 1000,
        "type": 9,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "BATT_CAPACITY",
        "attribute": "batt_capacity",
        "default": 3300,
        "minimum": 0,
        "maximum": 1000000,
        "numerator": 1,
        "denominator": 1,
        "type": 6,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "BATT_CRT_VOLT",
        "attribute": "batt_crt_volt",
        "default": 9900,
        "minimum": 0,
        "maximum": 100000,
        "numerator": 1,
        "denominator": 1000,
        "type": 9,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "BATT_FS_CRT_ACT",
        "attribute": "batt_fs_crt_act",
        "default": 2,
        "minimum": 0,
        "maximum": 5,
        "numerator": 1,
        "denominator": 1,
        "type": 2,
        "after_restart": False,
        "choices": (0, 1, 2, 3, 4, 5),
    },
    {
        "name": "BATT_FS_LOW_ACT",
        "attribute": "batt_fs_low_act",
        "default": 2,
        "minimum": 0,
        "maximum": 5,
        "numerator": 1,
        "denominator": 1,
        "type": 2,
        "after_restart": False,
        "choices": (0, 1, 2, 3, 4, 5),
    },
    {
        "name": "BATT_LOW_TIMER",
        "attribute": "batt_low_timer",
        "default": 10,
        "minimum": 0,
        "maximum": 120,
        "numerator": 1,
        "denominator": 1,
        "type": 2,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "BATT_LOW_VOLT",
        "attribute": "batt_low_volt",
        "default": 10500,
        "minimum": 0,
        "maximum": 100000,
        "numerator": 1,
        "denominator": 1000,
        "type": 9,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "BATT_MONITOR",
        "attribute": "batt_monitor",
        "default": 3,
        "minimum": 0,
        "maximum": 3,
        "numerator": 1,
        "denominator": 1,
        "type": 2,
        "after_restart": True,
        "choices": (0, 3),
    },
    {
        "name": "BATT_VOLT_MULT",
        "attribute": "batt_volt_mult",
        "default": 39500,
        "minimum": 10000,
        "maximum": 100000,
        "numerator": 1,
        "denominator": 10000,
        "type": 9,
        "after_restart": True,
        "choices": (),
    },
    {
        "name": "BATT_VOLT_PIN",
        "attribute": "batt_volt_pin",
        "default": 26,
        "minimum": 26,
        "maximum": 28,
        "numerator": 1,
        "denominator": 1,
        "type": 2,
        "after_restart": True,
        "choices": (),
    },
    {
        "name": "SR0_EXTRA1",
        "attribute": "sr0_extra1",
        "default": 2,
        "minimum": 0,
        "maximum": 50,
        "numerator": 1,
        "denominator": 1,
        "type": 4,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "SR0_EXT_STAT",
        "attribute": "sr0_ext_stat",
        "default": 1,
        "minimum": 0,
        "maximum": 50,
        "numerator": 1,
        "denominator": 1,
        "type": 4,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "SYSID_THISMAV",
        "attribute": "sysid_thismav",
        "default": 1,
        "minimum": 1,
        "maximum": 255,
        "numerator": 1,
        "denominator": 1,
        "type": 4,
        "after_restart": True,
        "choices": (),
    },
)

# Streams: a fixed period in ms, numerator / denominator, or a parameter that sets the rate in Hz. Messages are
# (id, instances, whether they are left out with the monitor off).
STREAMS = (
    {
        "name": "HEARTBEAT",
        "period_numerator": 1000,
        "period_denominator": 1,
        "parameter": None,
        "parameter_name": "",
        "numerator": 1,
        "denominator": 1,
        "default": 0,
        "minimum": 0,
        "maximum": 0,
        "data_stream": None,
        "fastest_hz": 50,
        "messages": [(0, 1, False)],
    },
    {
        "name": "EXTENDED_STATUS",
        "period_numerator": 0,
        "period_denominator": 1,
        "parameter": "sr0_ext_stat",
        "parameter_name": "SR0_EXT_STAT",
        "numerator": 1,
        "denominator": 1,
        "default": 1,
        "minimum": 0,
        "maximum": 50,
        "data_stream": 2,
        "fastest_hz": 50,
        "messages": [(1, 1, False)],
    },
    {
        "name": "EXTRA1",
        "period_numerator": 0,
        "period_denominator": 1,
        "parameter": "sr0_extra1",
        "parameter_name": "SR0_EXTRA1",
        "numerator": 1,
        "denominator": 1,
        "default": 2,
        "minimum": 0,
        "maximum": 50,
        "data_stream": 10,
        "fastest_hz": 50,
        "messages": [(147, 1, True)],
    },
)

# Ids of the messages that are sent on request only, and the shortest interval of each message in microseconds.
ON_REQUEST = [148, 300]
SENT = (0, 1, 147, 148, 300)
SHORTEST_US = (20000, 20000, 20000, 100000, 100000)
