# Generated from specs/board.yaml, specs/codegen.yaml, specs/dialects/battery_cell_voltages_rfc_0018.xml,
#   specs/dialects/battery_info_upstream.xml, specs/dialects/battery_upstream.xml,
#   specs/dialects/corrections_rfc_0018.yaml, specs/dialects/protocol_version.xml,
#   specs/dialects/upstream.xml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_cell_faults_rfc_0018.yaml,
#   specs/messages/battery_cell_voltages.yaml, specs/messages/battery_info.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/battery_status_v2_rfc_0018.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/protocol_version.yaml, specs/messages/smart_battery_info.yaml,
#   specs/messages/sys_status.yaml, specs/parameters.yaml, specs/receiver.yaml,
#   specs/state.yaml, specs/streams.yaml, specs/vehicle.yaml, dialect common: do not edit.
# Inputs: 3e8b26d225944fc5
"""Facts about this program, drawn from by lot: see counterparts_run.py."""

SYSTEM_ID = 1
COMPONENT_ID = 1

# How old something may be until it is forgotten.
AGES_MS = (1000, 2000)

# Each reading, what the mock calls its input, its component, the largest count, and how many instances are read.
READINGS = [
    ("battery", "adc", "battery", 4095, 2),
    ("battery_current", "battery_current_adc", "battery", 4095, 2),
]

# Parameters, and the steps with which readings are taken that are not with others.
ON = [
    ("batt2_monitor", 0),
    ("batt_monitor", 4),
]

# Attribute of each parameter, its only values, or the smallest and the largest.
PARAMETERS = [
    (
        "arming_check",
        (1,),
        1,
        1,
    ),
    (
        "batt2_amp_offset",
        (),
        0,
        3300,
    ),
    (
        "batt2_amp_pervlt",
        (),
        0,
        9900,
    ),
    (
        "batt2_arm_mah",
        (),
        0,
        1000000,
    ),
    (
        "batt2_arm_volt",
        (),
        0,
        100000,
    ),
    (
        "batt2_capacity",
        (),
        0,
        1000000,
    ),
    (
        "batt2_crt_mah",
        (),
        0,
        1000000,
    ),
    (
        "batt2_crt_volt",
        (),
        0,
        100000,
    ),
    (
        "batt2_curr_pin",
        (),
        26,
        28,
    ),
    (
        "batt2_fs_crt_act",
        (0, 1, 2, 3, 4, 5),
        0,
        5,
    ),
    (
        "batt2_fs_low_act",
        (0, 1, 2, 3, 4, 5),
        0,
        5,
    ),
    (
        "batt2_low_mah",
        (),
        0,
        1000000,
    ),
    (
        "batt2_low_timer",
        (),
        0,
        120,
    ),
    (
        "batt2_low_volt",
        (),
        0,
        100000,
    ),
    (
        "batt2_monitor",
        (0, 3, 4, 29),
        0,
        29,
    ),
    (
        "batt2_volt_mult",
        (),
        10000,
        100000,
    ),
    (
        "batt2_volt_pin",
        (),
        26,
        28,
    ),
    (
        "batt_amp_offset",
        (),
        0,
        3300,
    ),
    (
        "batt_amp_pervlt",
        (),
        0,
        9900,
    ),
    (
        "batt_arm_mah",
        (),
        0,
        1000000,
    ),
    (
        "batt_arm_volt",
        (),
        0,
        100000,
    ),
    (
        "batt_capacity",
        (),
        0,
        1000000,
    ),
    (
        "batt_crt_mah",
        (),
        0,
        1000000,
    ),
    (
        "batt_crt_volt",
        (),
        0,
        100000,
    ),
    (
        "batt_curr_pin",
        (),
        26,
        28,
    ),
    (
        "batt_fs_crt_act",
        (0, 1, 2, 3, 4, 5),
        0,
        5,
    ),
    (
        "batt_fs_low_act",
        (0, 1, 2, 3, 4, 5),
        0,
        5,
    ),
    (
        "batt_low_mah",
        (),
        0,
        1000000,
    ),
    (
        "batt_low_timer",
        (),
        0,
        120,
    ),
    (
        "batt_low_volt",
        (),
        0,
        100000,
    ),
    (
        "batt_monitor",
        (0, 3, 4, 29),
        0,
        29,
    ),
    (
        "batt_report",
        (0, 1, 2),
        0,
        2,
    ),
    (
        "batt_sys_status",
        (),
        1,
        16,
    ),
    (
        "batt_volt_mult",
        (),
        10000,
        100000,
    ),
    (
        "batt_volt_pin",
        (),
        26,
        28,
    ),
    (
        "sr0_extra1",
        (),
        0,
        50,
    ),
    (
        "sr0_extra3",
        (),
        0,
        50,
    ),
    (
        "sr0_ext_stat",
        (),
        0,
        50,
    ),
    (
        "sysid_thismav",
        (),
        1,
        255,
    ),
]


def first(value, count):
    """Return a list of so many values, of which the first one is known."""
    return [value if at == 0 else None for at in range(count)]


# Component, instances, attribute and elements of what is stored, and values: the last ones are beyond its limits.
QUANTITIES = [
    (
        "battery",
        2,
        "voltage_mv",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            65535,
        ],
    ),
    (
        "battery",
        2,
        "current_ma",
        0,
        [
            None,
            5,
            7,
            5,
            -327681,
            327671,
        ],
    ),
    (
        "battery",
        2,
        "consumed_mah",
        0,
        [
            None,
            5,
            7,
            5,
            -1073741824,
            1073741824,
        ],
    ),
    (
        "battery",
        2,
        "energy_hj",
        0,
        [
            None,
            5,
            7,
            5,
            -1073741824,
            1073741824,
        ],
    ),
    (
        "battery",
        2,
        "remaining_pct",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            101,
        ],
    ),
    (
        "battery",
        2,
        "left_mah",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            1073741824,
        ],
    ),
    (
        "battery",
        2,
        "time_left_s",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            1000001,
        ],
    ),
    (
        "battery",
        2,
        "counted_from_full",
        0,
        [
            None,
            5,
            7,
        ],
    ),
    (
        "battery",
        2,
        "cells_mv",
        3,
        [
            [None] * 3,
            [5] * 3,
            [7] * 3,
            first(5, 3),
            first(-1, 3),
            first(65535, 3),
        ],
    ),
    (
        "battery",
        2,
        "temperature_cdegc",
        0,
        [
            None,
            5,
            7,
            5,
            -32769,
            32767,
        ],
    ),
    (
        "battery",
        2,
        "trend_mv_s",
        0,
        [
            None,
            5,
            7,
            5,
            -1073741824,
            1073741824,
        ],
    ),
    (
        "battery",
        2,
        "health_number",
        0,
        [
            None,
            0,
            2,
            2,
            -1,
            3,
        ],
    ),
    (
        "battery",
        2,
        "failsafe_number",
        0,
        [
            None,
            0,
            2,
            2,
            -1,
            3,
        ],
    ),
    (
        "battery",
        2,
        "swaps_number",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            1000001,
        ],
    ),
    (
        "battery",
        2,
        "monitored",
        0,
        [
            None,
            5,
            7,
        ],
    ),
    (
        "battery",
        2,
        "protected",
        0,
        [
            None,
            5,
            7,
        ],
    ),
    (
        "battery",
        2,
        "lowest_cell_mv",
        0,
        [
            None,
            5,
            7,
            5,
            -1073741824,
            1073741824,
        ],
    ),
    (
        "battery",
        2,
        "highest_cell_mv",
        0,
        [
            None,
            5,
            7,
            5,
            -1073741824,
            1073741824,
        ],
    ),
    (
        "vehicle",
        1,
        "armed",
        0,
        [
            None,
            5,
            7,
        ],
    ),
    (
        "vehicle",
        1,
        "ready",
        0,
        [
            None,
            5,
            7,
        ],
    ),
    (
        "vehicle",
        1,
        "mode_number",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            1000001,
        ],
    ),
    (
        "vehicle",
        1,
        "status",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            9,
        ],
    ),
    (
        "vehicle",
        1,
        "load_dpct",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            1001,
        ],
    ),
]

# Messages, and what tells their functions the instance and the page.
TABLES = [
    ("heartbeat", ((),)),
    ("sys_status", ((),)),
    ("battery_status", ((0,), (1,))),
    ("autopilot_version", ((),)),
    ("protocol_version", ((),)),
    ("battery_status_v2", ((0,), (1,))),
    ("smart_battery_info", ((0,), (1,))),
    ("battery_info", ((0,), (1,))),
    ("battery_cell_voltages", ((0, 0), (1, 0))),
]
