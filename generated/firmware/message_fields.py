# Generated from specs/messages/autopilot_version.yaml, specs/messages/battery_cell_voltages.yaml,
#   specs/messages/battery_info.yaml, specs/messages/battery_status.yaml,
#   specs/messages/battery_status_v2.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/protocol_version.yaml, specs/messages/smart_battery_info.yaml,
#   specs/messages/sys_status.yaml, dialect common: do not edit.
# Inputs: 3030aa0d26480019
"""The fields of the messages in messages.py, by their ids, in wire order; fields.py says what the words mean."""

FIELDS = {
    0: "custom_mode:I type:B autopilot:B base_mode:B system_status:B mavlink_version:B",
    1: (
        "onboard_control_sensors_present:I onboard_control_sensors_enabled:I onboard_control_sensors_health:I "
        "load:H voltage_battery:H=65535 current_battery:h=-1 drop_rate_comm:H errors_comm:H errors_count1:H "
        "errors_count2:H errors_count3:H errors_count4:H battery_remaining:b=-1 "
        "onboard_control_sensors_present_extended:I onboard_control_sensors_enabled_extended:I "
        "onboard_control_sensors_health_extended:I"
    ),
    4: "time_usec:Q seq:I target_system:B target_component:B",
    20: "param_index:h=-1 target_system:B target_component:B param_id:16s",
    21: "target_system:B target_component:B",
    22: "param_value:f param_count:H param_index:H param_id:16s param_type:B",
    23: "param_value:f target_system:B target_component:B param_id:16s param_type:B",
    66: "req_message_rate:H target_system:B target_component:B req_stream_id:B start_stop:B",
    75: (
        "param1:f param2:f param3:f param4:f x:i y:i z:f command:H target_system:B target_component:B frame:B "
        "current:B autocontinue:B"
    ),
    76: (
        "param1:f param2:f param3:f param4:f param5:f param6:f param7:f command:H target_system:B "
        "target_component:B confirmation:B"
    ),
    77: "command:H result:B progress:B result_param2:i target_system:B target_component:B",
    110: "target_network:B target_system:B target_component:B payload:251B",
    147: (
        "current_consumed:i=-1 energy_consumed:i=-1 temperature:h=32767 voltages:10H=65535 current_battery:h=-1 "
        "id:B battery_function:B type:B battery_remaining:b=-1 time_remaining:i=0 charge_state:B "
        "voltages_ext:4H=0 mode:B fault_bitmask:I"
    ),
    148: (
        "capabilities:Q uid:Q flight_sw_version:I middleware_sw_version:I os_sw_version:I board_version:I "
        "vendor_id:H product_id:H flight_custom_version:8B middleware_custom_version:8B os_custom_version:8B "
        "uid2:18B"
    ),
    244: "interval_us:i message_id:H",
    253: "severity:B text:50s id:H chunk_seq:B",
    300: "version:H min_version:H max_version:H spec_version_hash:8B library_version_hash:8B",
    345: "param_index:h=-1 target_system:B target_component:B param_id:16s error:B",
    369: (
        "voltage:f=nan current:f=nan capacity_consumed:f=nan capacity_remaining:f=nan state_of_charge:f=nan "
        "status_flags:I temperature:h=32767 id:B"
    ),
    370: (
        "capacity_full_specification:i=-1 capacity_full:i=-1 cycle_count:H=65535 weight:H=0 "
        "discharge_minimum_voltage:H=65535 charging_minimum_voltage:H=65535 resting_minimum_voltage:H=65535 id:B "
        "battery_function:B type:B serial_number:16s=0 device_name:50s=0 charging_maximum_voltage:H=0 "
        "cells_in_series:B=0 discharge_maximum_current:I=0 discharge_maximum_burst_current:I=0 "
        "manufacture_date:11s=0"
    ),
    372: (
        "discharge_minimum_voltage:f=0 charging_minimum_voltage:f=0 resting_minimum_voltage:f=0 "
        "charging_maximum_voltage:f=0 charging_maximum_current:f=0 nominal_voltage:f=0 "
        "discharge_maximum_current:f=0 discharge_maximum_burst_current:f=0 design_capacity:f=0 "
        "full_charge_capacity:f=nan cycle_count:H=65535 weight:H=0 id:B battery_function:B type:B "
        "state_of_health:B=255 cells_in_series:B=0 manufacture_date:9s=0 serial_number:32s=0 name:50s=0"
    ),
    54371: "id:H index:H voltages:12H=0",
}
