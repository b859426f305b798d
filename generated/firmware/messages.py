# Generated from specs/messages/autopilot_version.yaml, specs/messages/battery_cell_voltages.yaml,
#   specs/messages/battery_info.yaml, specs/messages/battery_status.yaml,
#   specs/messages/battery_status_v2.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/protocol_version.yaml, specs/messages/smart_battery_info.yaml,
#   specs/messages/sys_status.yaml, dialect common: do not edit.
# Inputs: 6a4f0dda043125ee
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


class Ping(Message):
    """PING.

    time_usec: uint64, us
    seq: uint32
    target_system: uint8
    target_component: uint8
    """

    NAME = "PING"
    ID = 4
    CRC_EXTRA = 237
    BASE_LENGTH = 14
    LENGTH = 14
    FIELDS = "time_usec:Q seq:I target_system:B target_component:B"


class ParamRequestRead(Message):
    """PARAM_REQUEST_READ.

    param_index: int16, unknown: -1
    target_system: uint8
    target_component: uint8
    param_id: char[16]
    """

    NAME = "PARAM_REQUEST_READ"
    ID = 20
    CRC_EXTRA = 214
    BASE_LENGTH = 20
    LENGTH = 20
    FIELDS = "param_index:h=-1 target_system:B target_component:B param_id:16s"


class ParamRequestList(Message):
    """PARAM_REQUEST_LIST.

    target_system: uint8
    target_component: uint8
    """

    NAME = "PARAM_REQUEST_LIST"
    ID = 21
    CRC_EXTRA = 159
    BASE_LENGTH = 2
    LENGTH = 2
    FIELDS = "target_system:B target_component:B"


class ParamValue(Message):
    """PARAM_VALUE.

    param_value: float
    param_count: uint16
    param_index: uint16
    param_id: char[16]
    param_type: uint8, MAV_PARAM_TYPE
    """

    NAME = "PARAM_VALUE"
    ID = 22
    CRC_EXTRA = 220
    BASE_LENGTH = 25
    LENGTH = 25
    FIELDS = "param_value:f param_count:H param_index:H param_id:16s param_type:B"


class ParamSet(Message):
    """PARAM_SET.

    param_value: float
    target_system: uint8
    target_component: uint8
    param_id: char[16]
    param_type: uint8, MAV_PARAM_TYPE
    """

    NAME = "PARAM_SET"
    ID = 23
    CRC_EXTRA = 168
    BASE_LENGTH = 23
    LENGTH = 23
    FIELDS = "param_value:f target_system:B target_component:B param_id:16s param_type:B"


class RequestDataStream(Message):
    """REQUEST_DATA_STREAM.

    req_message_rate: uint16, Hz
    target_system: uint8
    target_component: uint8
    req_stream_id: uint8, MAV_DATA_STREAM
    start_stop: uint8
    """

    NAME = "REQUEST_DATA_STREAM"
    ID = 66
    CRC_EXTRA = 148
    BASE_LENGTH = 6
    LENGTH = 6
    FIELDS = "req_message_rate:H target_system:B target_component:B req_stream_id:B start_stop:B"


class CommandInt(Message):
    """COMMAND_INT.

    param1: float
    param2: float
    param3: float
    param4: float
    x: int32
    y: int32
    z: float
    command: uint16, MAV_CMD
    target_system: uint8
    target_component: uint8
    frame: uint8, MAV_FRAME
    current: uint8
    autocontinue: uint8
    """

    NAME = "COMMAND_INT"
    ID = 75
    CRC_EXTRA = 158
    BASE_LENGTH = 35
    LENGTH = 35
    FIELDS = (
        "param1:f param2:f param3:f param4:f x:i y:i z:f command:H target_system:B target_component:B frame:B "
        "current:B autocontinue:B"
    )


class CommandLong(Message):
    """COMMAND_LONG.

    param1: float
    param2: float
    param3: float
    param4: float
    param5: float
    param6: float
    param7: float
    command: uint16, MAV_CMD
    target_system: uint8
    target_component: uint8
    confirmation: uint8
    """

    NAME = "COMMAND_LONG"
    ID = 76
    CRC_EXTRA = 152
    BASE_LENGTH = 33
    LENGTH = 33
    FIELDS = (
        "param1:f param2:f param3:f param4:f param5:f param6:f param7:f command:H target_system:B "
        "target_component:B confirmation:B"
    )


class CommandAck(Message):
    """COMMAND_ACK.

    command: uint16, MAV_CMD
    result: uint8, MAV_RESULT
    progress: uint8, extension
    result_param2: int32, extension
    target_system: uint8, extension
    target_component: uint8, extension
    """

    NAME = "COMMAND_ACK"
    ID = 77
    CRC_EXTRA = 143
    BASE_LENGTH = 3
    LENGTH = 10
    FIELDS = "command:H result:B progress:B result_param2:i target_system:B target_component:B"


class FileTransferProtocol(Message):
    """FILE_TRANSFER_PROTOCOL.

    target_network: uint8
    target_system: uint8
    target_component: uint8
    payload: uint8[251]
    """

    NAME = "FILE_TRANSFER_PROTOCOL"
    ID = 110
    CRC_EXTRA = 84
    BASE_LENGTH = 254
    LENGTH = 254
    FIELDS = "target_network:B target_system:B target_component:B payload:251B"


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


class AutopilotVersion(Message):
    """AUTOPILOT_VERSION.

    capabilities: uint64, MAV_PROTOCOL_CAPABILITY
    uid: uint64
    flight_sw_version: uint32
    middleware_sw_version: uint32
    os_sw_version: uint32
    board_version: uint32
    vendor_id: uint16
    product_id: uint16
    flight_custom_version: uint8[8]
    middleware_custom_version: uint8[8]
    os_custom_version: uint8[8]
    uid2: uint8[18], extension
    """

    NAME = "AUTOPILOT_VERSION"
    ID = 148
    CRC_EXTRA = 178
    BASE_LENGTH = 60
    LENGTH = 78
    FIELDS = (
        "capabilities:Q uid:Q flight_sw_version:I middleware_sw_version:I os_sw_version:I board_version:I "
        "vendor_id:H product_id:H flight_custom_version:8B middleware_custom_version:8B os_custom_version:8B "
        "uid2:18B"
    )


class MessageInterval(Message):
    """MESSAGE_INTERVAL.

    interval_us: int32, us
    message_id: uint16
    """

    NAME = "MESSAGE_INTERVAL"
    ID = 244
    CRC_EXTRA = 95
    BASE_LENGTH = 6
    LENGTH = 6
    FIELDS = "interval_us:i message_id:H"


class Statustext(Message):
    """STATUSTEXT.

    severity: uint8, MAV_SEVERITY
    text: char[50]
    id: uint16, extension
    chunk_seq: uint8, extension
    """

    NAME = "STATUSTEXT"
    ID = 253
    CRC_EXTRA = 83
    BASE_LENGTH = 51
    LENGTH = 54
    FIELDS = "severity:B text:50s id:H chunk_seq:B"


class ProtocolVersion(Message):
    """PROTOCOL_VERSION.

    version: uint16
    min_version: uint16
    max_version: uint16
    spec_version_hash: uint8[8]
    library_version_hash: uint8[8]
    """

    NAME = "PROTOCOL_VERSION"
    ID = 300
    CRC_EXTRA = 217
    BASE_LENGTH = 22
    LENGTH = 22
    FIELDS = "version:H min_version:H max_version:H spec_version_hash:8B library_version_hash:8B"


class ParamError(Message):
    """PARAM_ERROR.

    param_index: int16, unknown: -1
    target_system: uint8
    target_component: uint8
    param_id: char[16]
    error: uint8, MAV_PARAM_ERROR
    """

    NAME = "PARAM_ERROR"
    ID = 345
    CRC_EXTRA = 209
    BASE_LENGTH = 21
    LENGTH = 21
    FIELDS = "param_index:h=-1 target_system:B target_component:B param_id:16s error:B"


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
    FIELDS = (
        "voltage:f=nan current:f=nan capacity_consumed:f=nan capacity_remaining:f=nan state_of_charge:f=nan "
        "status_flags:I temperature:h=32767 id:B"
    )


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
    FIELDS = (
        "capacity_full_specification:i=-1 capacity_full:i=-1 cycle_count:H=65535 weight:H=0 "
        "discharge_minimum_voltage:H=65535 charging_minimum_voltage:H=65535 resting_minimum_voltage:H=65535 id:B "
        "battery_function:B type:B serial_number:16s=0 device_name:50s=0 charging_maximum_voltage:H=0 "
        "cells_in_series:B=0 discharge_maximum_current:I=0 discharge_maximum_burst_current:I=0 "
        "manufacture_date:11s=0"
    )


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
    FIELDS = (
        "discharge_minimum_voltage:f=0 charging_minimum_voltage:f=0 resting_minimum_voltage:f=0 "
        "charging_maximum_voltage:f=0 charging_maximum_current:f=0 nominal_voltage:f=0 "
        "discharge_maximum_current:f=0 discharge_maximum_burst_current:f=0 design_capacity:f=0 "
        "full_charge_capacity:f=nan cycle_count:H=65535 weight:H=0 id:B battery_function:B type:B "
        "state_of_health:B=255 cells_in_series:B=0 manufacture_date:9s=0 serial_number:32s=0 name:50s=0"
    )


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
    FIELDS = "id:H index:H voltages:12H=0"


ALL = (
    Heartbeat,
    SysStatus,
    Ping,
    ParamRequestRead,
    ParamRequestList,
    ParamValue,
    ParamSet,
    RequestDataStream,
    CommandInt,
    CommandLong,
    CommandAck,
    FileTransferProtocol,
    BatteryStatus,
    AutopilotVersion,
    MessageInterval,
    Statustext,
    ProtocolVersion,
    ParamError,
    BatteryStatusV2,
    SmartBatteryInfo,
    BatteryInfo,
    BatteryCellVoltages,
)
