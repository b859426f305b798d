# Generated from specs/messages/battery_status.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/sys_status.yaml, dialect common: do not edit.
# Inputs: 7b288d6d22252ccc
"""Messages as the dialect lays them out; what each field is stands with its class."""

from message import Message


class Heartbeat(Message):
    """HEARTBEAT.

    custom_mode: uint32
    type: uint8, MAV_TYPE
    autopilot: uint8, MAV_AUTOPILOT
    base_mode: uint8, MAV_MODE_FLAG
    system_status: uint8, MAV_STATE
    mavlink_version: uint8
    """

    NAME = "HEARTBEAT"
    ID = 0
    CRC_EXTRA = 50
    BASE_LENGTH = 9
    LENGTH = 9
    FIELDS = "custom_mode:I type:B autopilot:B base_mode:B system_status:B mavlink_version:B"
    DEFAULTS = {"mavlink_version": 3}


class SysStatus(Message):
    """SYS_STATUS.

    onboard_control_sensors_present: uint32, MAV_SYS_STATUS_SENSOR
    onboard_control_sensors_enabled: uint32, MAV_SYS_STATUS_SENSOR
    onboard_control_sensors_health: uint32, MAV_SYS_STATUS_SENSOR
    load: uint16, d%
    voltage_battery: uint16, mV, unknown: 65535
    current_battery: int16, cA, unknown: -1
    drop_rate_comm: uint16, c%
    errors_comm: uint16
    errors_count1: uint16
    errors_count2: uint16
    errors_count3: uint16
    errors_count4: uint16
    battery_remaining: int8, %, unknown: -1
    onboard_control_sensors_present_extended: uint32, MAV_SYS_STATUS_SENSOR_EXTENDED, extension
    onboard_control_sensors_enabled_extended: uint32, MAV_SYS_STATUS_SENSOR_EXTENDED, extension
    onboard_control_sensors_health_extended: uint32, MAV_SYS_STATUS_SENSOR_EXTENDED, extension
    """

    NAME = "SYS_STATUS"
    ID = 1
    CRC_EXTRA = 124
    BASE_LENGTH = 31
    LENGTH = 43
    FIELDS = (
        "onboard_control_sensors_present:I onboard_control_sensors_enabled:I onboard_control_sensors_health:I "
        "load:H voltage_battery:H=65535 current_battery:h=-1 drop_rate_comm:H errors_comm:H errors_count1:H "
        "errors_count2:H errors_count3:H errors_count4:H battery_remaining:b=-1 "
        "onboard_control_sensors_present_extended:I onboard_control_sensors_enabled_extended:I "
        "onboard_control_sensors_health_extended:I"
    )


class BatteryStatus(Message):
    """BATTERY_STATUS.

    current_consumed: int32, mAh, unknown: -1
    energy_consumed: int32, hJ, unknown: -1
    temperature: int16, cdegC, unknown: 32767
    voltages: uint16[10], mV, unknown: 65535 in an element
    current_battery: int16, cA, unknown: -1
    id: uint8
    battery_function: uint8, MAV_BATTERY_FUNCTION
    type: uint8, MAV_BATTERY_TYPE
    battery_remaining: int8, %, unknown: -1
    time_remaining: int32, s, unknown: 0, extension
    charge_state: uint8, MAV_BATTERY_CHARGE_STATE, extension
    voltages_ext: uint16[4], mV, unknown: 0 in an element, extension
    mode: uint8, MAV_BATTERY_MODE, extension
    fault_bitmask: uint32, MAV_BATTERY_FAULT, extension
    """

    NAME = "BATTERY_STATUS"
    ID = 147
    CRC_EXTRA = 154
    BASE_LENGTH = 36
    LENGTH = 54
    FIELDS = (
        "current_consumed:i=-1 energy_consumed:i=-1 temperature:h=32767 voltages:10H=65535 current_battery:h=-1 "
        "id:B battery_function:B type:B battery_remaining:b=-1 time_remaining:i=0 charge_state:B "
        "voltages_ext:4H=0 mode:B fault_bitmask:I"
    )


ALL = (
    Heartbeat,
    SysStatus,
    BatteryStatus,
)
