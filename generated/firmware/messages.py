# Generated from specs/messages/battery_status.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/sys_status.yaml, dialect common: do not edit.
# Inputs: 7b288d6d22252ccc
"""Layout of the messages that the telemetry sends, as the dialect states it."""

from mavlink import Message


class Heartbeat(Message):
    NAME = "HEARTBEAT"
    ID = 0
    CRC_EXTRA = 50
    BASE_LENGTH = 9
    LENGTH = 9
    FIELDS = {
        "custom_mode": ("I", 0, 0),
        "type": ("B", 4, 0),  # MAV_TYPE
        "autopilot": ("B", 5, 0),  # MAV_AUTOPILOT
        "base_mode": ("B", 6, 0),  # MAV_MODE_FLAG
        "system_status": ("B", 7, 0),  # MAV_STATE
        "mavlink_version": ("B", 8, 0),
    }


class SysStatus(Message):
    NAME = "SYS_STATUS"
    ID = 1
    CRC_EXTRA = 124
    BASE_LENGTH = 31
    LENGTH = 43
    FIELDS = {
        "onboard_control_sensors_present": ("I", 0, 0),  # MAV_SYS_STATUS_SENSOR
        "onboard_control_sensors_enabled": ("I", 4, 0),  # MAV_SYS_STATUS_SENSOR
        "onboard_control_sensors_health": ("I", 8, 0),  # MAV_SYS_STATUS_SENSOR
        "load": ("H", 12, 0),  # d%
        "voltage_battery": ("H", 14, 0),  # mV
        "current_battery": ("h", 16, 0),  # cA
        "drop_rate_comm": ("H", 18, 0),  # c%
        "errors_comm": ("H", 20, 0),
        "errors_count1": ("H", 22, 0),
        "errors_count2": ("H", 24, 0),
        "errors_count3": ("H", 26, 0),
        "errors_count4": ("H", 28, 0),
        "battery_remaining": ("b", 30, 0),  # %
        "onboard_control_sensors_present_extended": ("I", 31, 0),  # MAV_SYS_STATUS_SENSOR_EXTENDED, extension
        "onboard_control_sensors_enabled_extended": ("I", 35, 0),  # MAV_SYS_STATUS_SENSOR_EXTENDED, extension
        "onboard_control_sensors_health_extended": ("I", 39, 0),  # MAV_SYS_STATUS_SENSOR_EXTENDED, extension
    }


class BatteryStatus(Message):
    NAME = "BATTERY_STATUS"
    ID = 147
    CRC_EXTRA = 154
    BASE_LENGTH = 36
    LENGTH = 54
    FIELDS = {
        "current_consumed": ("i", 0, 0),  # mAh
        "energy_consumed": ("i", 4, 0),  # hJ
        "temperature": ("h", 8, 0),  # cdegC
        "voltages": ("H", 10, 10),  # mV
        "current_battery": ("h", 30, 0),  # cA
        "id": ("B", 32, 0),
        "battery_function": ("B", 33, 0),  # MAV_BATTERY_FUNCTION
        "type": ("B", 34, 0),  # MAV_BATTERY_TYPE
        "battery_remaining": ("b", 35, 0),  # %
        "time_remaining": ("i", 36, 0),  # s, extension
        "charge_state": ("B", 40, 0),  # MAV_BATTERY_CHARGE_STATE, extension
        "voltages_ext": ("H", 41, 4),  # mV, extension
        "mode": ("B", 49, 0),  # MAV_BATTERY_MODE, extension
        "fault_bitmask": ("I", 50, 0),  # MAV_BATTERY_FAULT, extension
    }


ALL = (
    Heartbeat,
    SysStatus,
    BatteryStatus,
)
