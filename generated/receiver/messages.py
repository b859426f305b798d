# Generated from specs/messages/battery_cell_voltages.yaml, specs/messages/battery_info.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/smart_battery_info.yaml, dialect common: do not edit.
# Inputs: f5f0934fe05ce977
"""Messages as the dialect lays them out; what each field is stands with its class."""

from message import Message


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


class BatteryStatusV2(Message):
    """BATTERY_STATUS_V2.

    voltage: float, V, unknown: nan
    current: float, A, unknown: nan
    capacity_consumed: float, Ah, unknown: nan
    capacity_remaining: float, Ah, unknown: nan
    state_of_charge: float, %, unknown: nan
    status_flags: uint32, MAV_BATTERY_STATUS_FLAGS
    temperature: int16, cdegC, unknown: 32767
    id: uint8
    """

    NAME = "BATTERY_STATUS_V2"
    ID = 369
    CRC_EXTRA = 145
    BASE_LENGTH = 27
    LENGTH = 27


class SmartBatteryInfo(Message):
    """SMART_BATTERY_INFO.

    capacity_full_specification: int32, mAh, unknown: -1
    capacity_full: int32, mAh, unknown: -1
    cycle_count: uint16, unknown: 65535
    weight: uint16, g, unknown: 0
    discharge_minimum_voltage: uint16, mV, unknown: 65535
    charging_minimum_voltage: uint16, mV, unknown: 65535
    resting_minimum_voltage: uint16, mV, unknown: 65535
    id: uint8
    battery_function: uint8, MAV_BATTERY_FUNCTION
    type: uint8, MAV_BATTERY_TYPE
    serial_number: char[16], unknown: empty text
    device_name: char[50], unknown: empty text
    charging_maximum_voltage: uint16, mV, unknown: 0, extension
    cells_in_series: uint8, unknown: 0, extension
    discharge_maximum_current: uint32, mA, unknown: 0, extension
    discharge_maximum_burst_current: uint32, mA, unknown: 0, extension
    manufacture_date: char[11], unknown: empty text, extension
    """

    NAME = "SMART_BATTERY_INFO"
    ID = 370
    CRC_EXTRA = 75
    BASE_LENGTH = 87
    LENGTH = 109


class BatteryInfo(Message):
    """BATTERY_INFO.

    discharge_minimum_voltage: float, V, unknown: 0
    charging_minimum_voltage: float, V, unknown: 0
    resting_minimum_voltage: float, V, unknown: 0
    charging_maximum_voltage: float, V, unknown: 0
    charging_maximum_current: float, A, unknown: 0
    nominal_voltage: float, V, unknown: 0
    discharge_maximum_current: float, A, unknown: 0
    discharge_maximum_burst_current: float, A, unknown: 0
    design_capacity: float, Ah, unknown: 0
    full_charge_capacity: float, Ah, unknown: nan
    cycle_count: uint16, unknown: 65535
    weight: uint16, g, unknown: 0
    id: uint8
    battery_function: uint8, MAV_BATTERY_FUNCTION
    type: uint8, MAV_BATTERY_TYPE
    state_of_health: uint8, %, unknown: 255
    cells_in_series: uint8, unknown: 0
    manufacture_date: char[9], unknown: empty text
    serial_number: char[32], unknown: empty text
    name: char[50], unknown: empty text
    """

    NAME = "BATTERY_INFO"
    ID = 372
    CRC_EXTRA = 26
    BASE_LENGTH = 140
    LENGTH = 140


class BatteryCellVoltages(Message):
    """BATTERY_CELL_VOLTAGES.

    id: uint16
    index: uint16
    voltages: uint16[12], mV, unknown: 0 in an element
    """

    NAME = "BATTERY_CELL_VOLTAGES"
    ID = 54371
    CRC_EXTRA = 8
    BASE_LENGTH = 28
    LENGTH = 28


ALL = (
    BatteryStatus,
    BatteryStatusV2,
    SmartBatteryInfo,
    BatteryInfo,
    BatteryCellVoltages,
)
