# Generated from specs/messages/autopilot_version.yaml, specs/messages/battery_cell_voltages.yaml,
#   specs/messages/battery_info.yaml, specs/messages/battery_status.yaml,
#   specs/messages/battery_status_v2.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/protocol_version.yaml, specs/messages/smart_battery_info.yaml,
#   specs/messages/sys_status.yaml, dialect common: do not edit.
# Inputs: 3030aa0d26480019
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
    TARGETS = (12, 13)


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
    TARGETS = (2, 3)


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
    TARGETS = (0, 1)


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
    TARGETS = (4, 5)


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
    TARGETS = (2, 3)


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
    TARGETS = (30, 31)


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
    TARGETS = (30, 31)


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
    TARGETS = (8, 9)


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
    TARGETS = (1, 2)


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
    TARGETS = (2, 3)


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
