# Generated from specs/codegen.yaml, specs/dialects/battery_cell_voltages_rfc_0018.xml,
#   specs/dialects/battery_info_upstream.xml, specs/dialects/battery_upstream.xml,
#   specs/dialects/corrections_rfc_0018.yaml, specs/dialects/protocol_version.xml,
#   specs/dialects/upstream.xml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_cell_faults_rfc_0018.yaml,
#   specs/messages/battery_cell_voltages.yaml, specs/messages/battery_status.yaml,
#   specs/messages/battery_status_v2.yaml, specs/messages/battery_status_v2_rfc_0018.yaml,
#   specs/messages/protocol_version.yaml, specs/smart_battery/board.yaml,
#   specs/smart_battery/codegen.yaml, specs/smart_battery/messages/battery_info.yaml,
#   specs/smart_battery/messages/heartbeat.yaml,
#   specs/smart_battery/messages/smart_battery_info.yaml,
#   specs/smart_battery/parameters.yaml, specs/smart_battery/state.yaml,
#   specs/smart_battery/streams.yaml, specs/smart_battery/vehicle.yaml, dialect common: do not edit.
# Inputs: 8e4825f7db72c0dc
"""Facts about this program, drawn from by lot: see counterparts_run.py."""

SYSTEM_ID = 1
COMPONENT_ID = 180

# How old something may be until it is forgotten.
AGES_MS = (1000, 2000)

# Each reading, what the mock calls its input, its component, the largest count, and how many instances are read.
READINGS = [
    ("battery", "adc", "battery", 4095, 1),
]

# Parameters, and the steps with which readings are taken that are not with others.
ON = []

# Attribute of each parameter, its only values, or the smallest and the largest.
PARAMETERS = [
    (
        "batt_capacity",
        (),
        0,
        1000000,
    ),
    (
        "batt_id",
        (),
        0,
        9,
    ),
    (
        "batt_monitor",
        (0, 3),
        0,
        3,
    ),
    (
        "batt_report",
        (0, 1, 2),
        0,
        2,
    ),
    (
        "batt_status_rate",
        (),
        0,
        100,
    ),
    (
        "batt_v2_rate",
        (),
        0,
        100,
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
        "compid_batt",
        (),
        1,
        255,
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
        1,
        "voltage_mv",
        0,
        [
            None,
            5,
            7,
            5,
            -1,
            655341,
        ],
    ),
    (
        "battery",
        1,
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
        1,
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
        1,
        "energy_hj",
        0,
        [
            None,
            5,
            7,
            5,
            -2147483649,
            2147483648,
        ],
    ),
    (
        "battery",
        1,
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
        1,
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
        1,
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
        1,
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
        1,
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
        1,
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
        1,
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
        1,
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
        1,
        "used_up",
        0,
        [
            None,
            5,
            7,
        ],
    ),
    (
        "battery",
        1,
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
        1,
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
        1,
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
]

# Messages, and what tells their functions the instance and the page.
TABLES = [
    ("heartbeat", ((),)),
    ("battery_status", ((0,),)),
    ("autopilot_version", ((),)),
    ("protocol_version", ((),)),
    ("battery_status_v2", ((0,),)),
    ("smart_battery_info", ((0,),)),
    ("battery_info", ((0,),)),
    ("battery_cell_voltages", ((0, 0),)),
]
