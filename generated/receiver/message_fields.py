# Generated from specs/messages/battery_cell_voltages.yaml, specs/messages/battery_info.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/smart_battery_info.yaml, dialect common: do not edit.
# Inputs: f5f0934fe05ce977
"""The fields of the messages in messages.py, by their ids, in wire order; fields.py says what the words mean."""

FIELDS = {
    147: (
        "current_consumed:i=-1 energy_consumed:i=-1 temperature:h=32767 voltages:10H=65535 current_battery:h=-1 "
        "id:B battery_function:B type:B battery_remaining:b=-1 time_remaining:i=0 charge_state:B "
        "voltages_ext:4H=0 mode:B fault_bitmask:I"
    ),
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
