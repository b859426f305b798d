# Generated from specs/board.yaml, specs/codegen.yaml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_cell_voltages.yaml, specs/messages/battery_info.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/heartbeat.yaml, specs/messages/protocol_version.yaml,
#   specs/messages/smart_battery_info.yaml, specs/messages/sys_status.yaml,
#   specs/parameters.yaml, specs/state.yaml, dialect common: do not edit.
# Inputs: 03e73bd7087a6bfa
"""From the words of the state to the payload of a message, in plain Python: one function for each message.

`value` is at first the time in ms, then each value in turn; `wire` is the payload of a message, `words` are those of
the state, see state.py. Frames are made by Link.encode().

Locals are few, and what machine code is told in `place` is a variable for loops here: MicroPython puts the locals of
larger functions on the heap at every call.
"""

import time

import messages
from floats_plain import put_float
from micropython import const

_UNKNOWN = const(-0x3FFFFFFF - 1)
# Where the state keeps what.
_BATTERY = const(0)
_BATTERY_SIZE = const(87)
_BATTERY_VOLTAGE_MV = const(0)
_BATTERY_CURRENT_MA = const(1)
_BATTERY_CONSUMED_MAH = const(2)
_BATTERY_ENERGY_HJ = const(3)
_BATTERY_REMAINING_PCT = const(4)
_BATTERY_LEFT_MAH = const(5)
_BATTERY_TIME_LEFT_S = const(6)
_BATTERY_COUNTED_FROM_FULL = const(7)
_BATTERY_TEMPERATURE_CDEGC = const(8)
_BATTERY_TREND_MV_S = const(9)
_BATTERY_HEALTH_NUMBER = const(10)
_BATTERY_FAILSAFE_NUMBER = const(11)
_BATTERY_MONITORED = const(13)
_BATTERY_PROTECTED = const(14)
_BATTERY_LOWEST_CELL_MV = const(15)
_BATTERY_HIGHEST_CELL_MV = const(16)
_BATTERY_EXPIRES_MS = const(22)
_BATTERY_CURRENT_EXPIRES_MS = const(32)
_BATTERY_TREND_COUNT = const(40)
_BATTERY_TREND_NEWER = const(41)
_BATTERY_TREND_OLDER = const(42)
_BATTERY_CELLS_MV = const(84)
_VEHICLE = const(174)
_VEHICLE_ARMED = const(0)
_VEHICLE_READY = const(1)
_VEHICLE_MODE_NUMBER = const(2)
_VEHICLE_STATUS = const(3)
_VEHICLE_LOAD_DPCT = const(4)
_SMART_BATTERY_INFO_DEVICE_NAME = b"generic_LiPo-3300"
_BATTERY_INFO_NAME = b"generic_LiPo-3300"

# What the builders return, in their order, for each instance of which there are several; None until it is asked for.
_MESSAGES = (
    [None],
    [None],
    [None] * 2,
    [None],
    [None],
    [None] * 2,
    [None] * 2,
    [None] * 2,
    [None] * 2,
)


def _expire_battery(value, words, battery):
    # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
    if words[battery + _BATTERY_EXPIRES_MS] != _UNKNOWN:
        if value - words[battery + _BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            words[battery + _BATTERY_VOLTAGE_MV] = _UNKNOWN
            words[battery + _BATTERY_TREND_MV_S] = _UNKNOWN
            words[battery + _BATTERY_TREND_COUNT] = 0
            words[battery + _BATTERY_TREND_NEWER] = 0
            words[battery + _BATTERY_TREND_OLDER] = 0
            words[battery + _BATTERY_EXPIRES_MS] = _UNKNOWN


def _expire_battery_current(value, words, battery):
    # The current is forgotten once it is older than 1000 ms (FR-00077.4).
    if words[battery + _BATTERY_CURRENT_EXPIRES_MS] != _UNKNOWN:
        if value - words[battery + _BATTERY_CURRENT_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            words[battery + _BATTERY_CURRENT_MA] = _UNKNOWN
            words[battery + _BATTERY_REMAINING_PCT] = _UNKNOWN
            words[battery + _BATTERY_LEFT_MAH] = _UNKNOWN
            words[battery + _BATTERY_TIME_LEFT_S] = _UNKNOWN
            words[battery + _BATTERY_CURRENT_EXPIRES_MS] = _UNKNOWN


def _made(place, instance, kind):
    message = _MESSAGES[place][instance] = kind(unknown=False)
    return message


def build_heartbeat(state):
    """Return HEARTBEAT (0), FR-00068.8."""
    message = _MESSAGES[0][0]
    if message is None:
        message = _made(0, 0, messages.Heartbeat)
    write_heartbeat(time.ticks_ms(), 0, message.wire, state.words)
    return message


def encode_heartbeat(link, state):
    """Return the frame of HEARTBEAT (0), FR-00068.8."""
    return link.encode(build_heartbeat(state))


def write_heartbeat(value, place, wire, words):
    """Write the payload of HEARTBEAT (0), FR-00068.8."""
    # custom_mode: vehicle.mode (FR-00068.8)
    value = words[_VEHICLE + _VEHICLE_MODE_NUMBER]
    if value < 0:
        value = 0
    elif value > 1000000:
        value = 1000000
    wire[0] = value & 0xFF
    wire[1] = value >> 8 & 0xFF
    wire[2] = value >> 16 & 0xFF
    wire[3] = value >> 24 & 0xFF

    # type: MAV_TYPE_GROUND_ROVER (FR-00068.8)
    wire[4] = 10

    # autopilot: MAV_AUTOPILOT_ARDUPILOTMEGA (FR-00068.8)
    wire[5] = 3

    # base_mode: MAV_MODE_FLAG_SAFETY_ARMED if vehicle.armed (FR-00068.8)
    wire[6] = 65
    if words[_VEHICLE + _VEHICLE_ARMED]:
        wire[6] |= 0x80

    # system_status: vehicle.status (FR-00068.8)
    value = words[_VEHICLE + _VEHICLE_STATUS]
    if value < 0:
        value = 3 if value == _UNKNOWN else 0  # until it is set, or too small
    elif value > 8:
        value = 8
    wire[7] = value & 0xFF

    # mavlink_version: version of the dialect (FR-00068.8)
    wire[8] = 3


def build_sys_status(state):
    """Return SYS_STATUS (1), FR-00068.9."""
    message = _MESSAGES[1][0]
    if message is None:
        message = _made(1, 0, messages.SysStatus)
    write_sys_status(time.ticks_ms(), 0, message.wire, state.words, state.parameters.batt_sys_status)
    return message


def encode_sys_status(link, state):
    """Return the frame of SYS_STATUS (1), FR-00068.9."""
    return link.encode(build_sys_status(state))


def write_sys_status(value, place, wire, words, batt_sys_status):
    """Write the payload of SYS_STATUS (1), FR-00068.9."""
    # The battery that BATT_SYS_STATUS says, from 1 there, or else the first enabled one.
    place = batt_sys_status - 1
    if place < 0 or place >= 2:
        place = 0
    battery = _BATTERY + _BATTERY_SIZE * place
    if not words[battery + _BATTERY_MONITORED]:
        place = 0
        battery = _BATTERY + _BATTERY_SIZE * place
        while place < 1 and not words[battery + _BATTERY_MONITORED]:
            place += 1
            battery = _BATTERY + _BATTERY_SIZE * place
        if not words[battery + _BATTERY_MONITORED]:
            place = 0
            battery = _BATTERY + _BATTERY_SIZE * place

    _expire_battery(value, words, battery)

    _expire_battery_current(value, words, battery)

    # onboard_control_sensors_present: MAV_SYS_STATUS_SENSOR_BATTERY if battery.monitored (FR-00068.9)
    wire[0] = 0
    wire[1] = 0
    wire[2] = 0
    wire[3] = 16
    if words[battery + _BATTERY_MONITORED]:
        wire[3] |= 0x2

    # onboard_control_sensors_enabled: MAV_SYS_STATUS_SENSOR_BATTERY if battery.monitored (FR-00068.9)
    wire[4] = 0
    wire[5] = 0
    wire[6] = 0
    wire[7] = 16
    if words[battery + _BATTERY_MONITORED]:
        wire[7] |= 0x2

    # onboard_control_sensors_health: (FR-00067.3)
    #   MAV_SYS_STATUS_SENSOR_BATTERY if battery.healthy
    #   MAV_SYS_STATUS_PREARM_CHECK if vehicle.ready
    wire[8] = 0
    wire[9] = 0
    wire[10] = 16
    wire[11] = 0
    value = words[battery + _BATTERY_VOLTAGE_MV]
    if value != _UNKNOWN:
        wire[11] |= 0x2
    if words[_VEHICLE + _VEHICLE_READY]:
        wire[11] |= 0x10

    # load [d%]: vehicle.load (FR-00068.9)
    value = words[_VEHICLE + _VEHICLE_LOAD_DPCT]
    if value < 0:
        value = 0
    elif value > 1000:
        value = 1000
    wire[12] = value & 0xFF
    wire[13] = value >> 8 & 0xFF

    # voltage_battery [mV]: battery.voltage (FR-00068.9)
    value = words[battery + _BATTERY_VOLTAGE_MV]
    if value < 0:
        value = 65535 if value == _UNKNOWN else 0  # unknown, or too small
    elif value > 65534:
        value = 65534
    wire[14] = value & 0xFF
    wire[15] = value >> 8 & 0xFF

    # current_battery [cA]: battery.current [mA] (FR-00068.4)
    value = words[battery + _BATTERY_CURRENT_MA]
    if value == _UNKNOWN:
        value = -1  # unknown
    else:
        if value < -327680:
            value = -327680
        elif value > 327670:
            value = 327670
        if value < 0:
            value = 0 - (5 - value) // 10
        else:
            value = (value + 5) // 10
        if value == -1:
            value = -2  # -1 would read as unknown
    wire[16] = value & 0xFF
    wire[17] = value >> 8 & 0xFF

    # drop_rate_comm: 0 (FR-00068.9)
    wire[18] = 0
    wire[19] = 0

    # errors_comm: 0 (FR-00068.9)
    wire[20] = 0
    wire[21] = 0

    # errors_count1: 0 (FR-00068.9)
    wire[22] = 0
    wire[23] = 0

    # errors_count2: 0 (FR-00068.9)
    wire[24] = 0
    wire[25] = 0

    # errors_count3: 0 (FR-00068.9)
    wire[26] = 0
    wire[27] = 0

    # errors_count4: 0 (FR-00068.9)
    wire[28] = 0
    wire[29] = 0

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = words[battery + _BATTERY_REMAINING_PCT]
    if value < 0:
        value = -1 if value == _UNKNOWN else 0  # unknown, or too small
    elif value > 100:
        value = 100
    wire[30] = value & 0xFF

    # onboard_control_sensors_present_extended: no flag (FR-00068.9)
    wire[31] = 0
    wire[32] = 0
    wire[33] = 0
    wire[34] = 0

    # onboard_control_sensors_enabled_extended: no flag (FR-00068.9)
    wire[35] = 0
    wire[36] = 0
    wire[37] = 0
    wire[38] = 0

    # onboard_control_sensors_health_extended: no flag (FR-00068.9)
    wire[39] = 0
    wire[40] = 0
    wire[41] = 0
    wire[42] = 0


def build_battery_status(state, instance=0):
    """Return BATTERY_STATUS (147), FR-00068.1."""
    message = _MESSAGES[2][instance]
    if message is None:
        message = _made(2, instance, messages.BatteryStatus)
    write_battery_status(time.ticks_ms(), 0, message.wire, state.words, instance)
    return message


def encode_battery_status(link, state, instance=0):
    """Return the frame of BATTERY_STATUS (147), FR-00068.1."""
    return link.encode(build_battery_status(state, instance))


battery_status_frame = encode_battery_status


def write_battery_status(value, place, wire, words, instance):
    """Write the payload of BATTERY_STATUS (147), FR-00068.1."""
    battery = _BATTERY + _BATTERY_SIZE * instance

    _expire_battery(value, words, battery)

    _expire_battery_current(value, words, battery)

    # current_consumed [mAh]: battery.consumed (FR-00068.6)
    value = words[battery + _BATTERY_CONSUMED_MAH]
    if value == _UNKNOWN:
        value = -1  # unknown
    elif value == -1:
        value = -2  # -1 would read as unknown
    wire[0] = value & 0xFF
    wire[1] = value >> 8 & 0xFF
    wire[2] = value >> 16 & 0xFF
    wire[3] = value >> 24 & 0xFF

    # energy_consumed [hJ]: battery.energy (FR-00068.6)
    value = words[battery + _BATTERY_ENERGY_HJ]
    if value == _UNKNOWN:
        value = -1  # unknown
    elif value == -1:
        value = -2  # -1 would read as unknown
    wire[4] = value & 0xFF
    wire[5] = value >> 8 & 0xFF
    wire[6] = value >> 16 & 0xFF
    wire[7] = value >> 24 & 0xFF

    # temperature [cdegC]: battery.temperature (FR-00068.6)
    value = words[battery + _BATTERY_TEMPERATURE_CDEGC]
    if value < -32768:
        value = 32767 if value == _UNKNOWN else -32768  # unknown, or too small
    elif value > 32766:
        value = 32766
    wire[8] = value & 0xFF
    wire[9] = value >> 8 & 0xFF

    # voltages [mV]: battery.cells while all are known, else battery.voltage, spilling above 65534 (FR-00068.3)
    place = 0
    while place < 3 and words[battery + _BATTERY_CELLS_MV + place] != _UNKNOWN:
        place += 1
    if place == 3:
        place = 0
        while place < 3:
            value = words[battery + _BATTERY_CELLS_MV + place]
            if value < 0:
                value = 65535 if value == _UNKNOWN else 0  # unknown, or too small
            elif value > 65534:
                value = 65534
            wire[2 * place + 10] = value & 0xFF
            wire[2 * place + 11] = value >> 8 & 0xFF
            place += 1
        while place < 10:
            wire[2 * place + 10] = 255
            wire[2 * place + 11] = 255
            place += 1
    else:
        value = words[battery + _BATTERY_VOLTAGE_MV]
        wire[12] = 255
        wire[13] = 255
        wire[14] = 255
        wire[15] = 255
        wire[16] = 255
        wire[17] = 255
        wire[18] = 255
        wire[19] = 255
        wire[20] = 255
        wire[21] = 255
        wire[22] = 255
        wire[23] = 255
        wire[24] = 255
        wire[25] = 255
        wire[26] = 255
        wire[27] = 255
        wire[28] = 255
        wire[29] = 255
        if value == _UNKNOWN:
            wire[10] = 255
            wire[11] = 255
        else:
            if value < 0:
                value = 0
            elif value > 655340:
                value = 655340
            place = 0
            while value > 65534 and place < 9:
                wire[2 * place + 10] = 254
                wire[2 * place + 11] = 255
                value -= 65534
                place += 1
            wire[2 * place + 10] = value & 0xFF
            wire[2 * place + 11] = value >> 8 & 0xFF

    # current_battery [cA]: battery.current [mA] (FR-00068.4)
    value = words[battery + _BATTERY_CURRENT_MA]
    if value == _UNKNOWN:
        value = -1  # unknown
    else:
        if value < -327680:
            value = -327680
        elif value > 327670:
            value = 327670
        if value < 0:
            value = 0 - (5 - value) // 10
        else:
            value = (value + 5) // 10
        if value == -1:
            value = -2  # -1 would read as unknown
    wire[30] = value & 0xFF
    wire[31] = value >> 8 & 0xFF

    # id: the battery's number (FR-00068.7)
    wire[32] = instance & 0xFF

    # battery_function: MAV_BATTERY_FUNCTION_ALL (FR-00068.7)
    wire[33] = 1

    # type: MAV_BATTERY_TYPE_LIPO (FR-00068.7)
    wire[34] = 1

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = words[battery + _BATTERY_REMAINING_PCT]
    if value < 0:
        value = -1 if value == _UNKNOWN else 0  # unknown, or too small
    elif value > 100:
        value = 100
    wire[35] = value & 0xFF

    # time_remaining [s]: battery.time_left (FR-00077.7)
    value = words[battery + _BATTERY_TIME_LEFT_S]
    if value < 1:
        value = 0 if value == _UNKNOWN else 1  # unknown, or too small
    elif value > 1000000:
        value = 1000000
    wire[36] = value & 0xFF
    wire[37] = value >> 8 & 0xFF
    wire[38] = value >> 16 & 0xFF
    wire[39] = value >> 24 & 0xFF

    # charge_state: the first of (FR-00068.6)
    #   MAV_BATTERY_CHARGE_STATE_CHARGING if battery.charging
    #   else MAV_BATTERY_CHARGE_STATE_UNDEFINED
    wire[40] = 0
    value = words[battery + _BATTERY_CURRENT_MA]
    if value < 0 and value != _UNKNOWN:
        wire[40] = 7

    # voltages_ext [mV]: battery.cells, from 10 while all are known (FR-00068.6)
    # there are 3: all unknown
    wire[41] = 0
    wire[42] = 0
    wire[43] = 0
    wire[44] = 0
    wire[45] = 0
    wire[46] = 0
    wire[47] = 0
    wire[48] = 0

    # mode: MAV_BATTERY_MODE_UNKNOWN, 0 (FR-00068.6)
    wire[49] = 0

    # fault_bitmask: (FR-00068.6)
    #   MAV_BATTERY_FAULT_DEEP_DISCHARGE if battery.under_voltage
    #   MAV_BATTERY_FAULT_DEEP_DISCHARGE if battery.cell_under_voltage
    #   MAV_BATTERY_FAULT_OVER_CURRENT if battery.over_current
    #   MAV_BATTERY_FAULT_OVER_TEMPERATURE if battery.hot
    #   MAV_BATTERY_FAULT_UNDER_TEMPERATURE if battery.cold
    wire[50] = 0
    wire[51] = 0
    wire[52] = 0
    wire[53] = 0
    value = words[battery + _BATTERY_VOLTAGE_MV]
    if value < 9000 and value >= 3000:
        wire[50] |= 0x1
    value = words[battery + _BATTERY_LOWEST_CELL_MV]
    if value < 3000 and value != _UNKNOWN:
        wire[50] |= 0x1
    value = words[battery + _BATTERY_CURRENT_MA]
    if value >= 132000:
        wire[50] |= 0x8
    value = words[battery + _BATTERY_TEMPERATURE_CDEGC]
    if value >= 6000:
        wire[50] |= 0x10
    if value < -2000 and value != _UNKNOWN:
        wire[50] |= 0x20


def build_autopilot_version(state):
    """Return AUTOPILOT_VERSION (148), FR-00070.2."""
    message = _MESSAGES[3][0]
    if message is None:
        message = _made(3, 0, messages.AutopilotVersion)
    write_autopilot_version(time.ticks_ms(), 0, message.wire, state.words)
    return message


def encode_autopilot_version(link, state):
    """Return the frame of AUTOPILOT_VERSION (148), FR-00070.2."""
    return link.encode(build_autopilot_version(state))


def write_autopilot_version(value, place, wire, words):
    """Write the payload of AUTOPILOT_VERSION (148), FR-00070.2."""
    # capabilities: MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT + MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST +
    #   MAV_PROTOCOL_CAPABILITY_MAVLINK2 + MAV_PROTOCOL_CAPABILITY_COMMAND_INT (FR-00070.2)
    wire[0] = 10
    wire[1] = 32
    wire[2] = 2
    wire[3] = 0
    wire[4] = 0
    wire[5] = 0
    wire[6] = 0
    wire[7] = 0

    # uid: 0 (FR-00070.2)
    wire[8] = 0
    wire[9] = 0
    wire[10] = 0
    wire[11] = 0
    wire[12] = 0
    wire[13] = 0
    wire[14] = 0
    wire[15] = 0

    # flight_sw_version: 16777216 (FR-00070.2)
    wire[16] = 0
    wire[17] = 0
    wire[18] = 0
    wire[19] = 1

    # middleware_sw_version: 0 (FR-00070.2)
    wire[20] = 0
    wire[21] = 0
    wire[22] = 0
    wire[23] = 0

    # os_sw_version: 0 (FR-00070.2)
    wire[24] = 0
    wire[25] = 0
    wire[26] = 0
    wire[27] = 0

    # board_version: 0 (FR-00070.2)
    wire[28] = 0
    wire[29] = 0
    wire[30] = 0
    wire[31] = 0

    # vendor_id: 0 (FR-00070.2)
    wire[32] = 0
    wire[33] = 0

    # product_id: 0 (FR-00070.2)
    wire[34] = 0
    wire[35] = 0

    # flight_custom_version: 0 (FR-00070.2)
    wire[36] = 0
    wire[37] = 0
    wire[38] = 0
    wire[39] = 0
    wire[40] = 0
    wire[41] = 0
    wire[42] = 0
    wire[43] = 0

    # middleware_custom_version: 0 (FR-00070.2)
    wire[44] = 0
    wire[45] = 0
    wire[46] = 0
    wire[47] = 0
    wire[48] = 0
    wire[49] = 0
    wire[50] = 0
    wire[51] = 0

    # os_custom_version: 0 (FR-00070.2)
    wire[52] = 0
    wire[53] = 0
    wire[54] = 0
    wire[55] = 0
    wire[56] = 0
    wire[57] = 0
    wire[58] = 0
    wire[59] = 0

    # uid2: 0 (FR-00070.2)
    place = 0
    while place < 18:
        wire[60 + place] = 0
        place += 1


def build_protocol_version(state):
    """Return PROTOCOL_VERSION (300), FR-00070.2."""
    message = _MESSAGES[4][0]
    if message is None:
        message = _made(4, 0, messages.ProtocolVersion)
    write_protocol_version(time.ticks_ms(), 0, message.wire, state.words)
    return message


def encode_protocol_version(link, state):
    """Return the frame of PROTOCOL_VERSION (300), FR-00070.2."""
    return link.encode(build_protocol_version(state))


def write_protocol_version(value, place, wire, words):
    """Write the payload of PROTOCOL_VERSION (300), FR-00070.2."""
    # version: 200 (FR-00070.2)
    wire[0] = 200
    wire[1] = 0

    # min_version: 100 (FR-00070.2)
    wire[2] = 100
    wire[3] = 0

    # max_version: 200 (FR-00070.2)
    wire[4] = 200
    wire[5] = 0

    # spec_version_hash: 0 (FR-00070.2)
    wire[6] = 0
    wire[7] = 0
    wire[8] = 0
    wire[9] = 0
    wire[10] = 0
    wire[11] = 0
    wire[12] = 0
    wire[13] = 0

    # library_version_hash: 0 (FR-00070.2)
    wire[14] = 0
    wire[15] = 0
    wire[16] = 0
    wire[17] = 0
    wire[18] = 0
    wire[19] = 0
    wire[20] = 0
    wire[21] = 0


def build_battery_status_v2(state, instance=0):
    """Return BATTERY_STATUS_V2 (369), FR-00072.1."""
    message = _MESSAGES[5][instance]
    if message is None:
        message = _made(5, instance, messages.BatteryStatusV2)
    write_battery_status_v2(time.ticks_ms(), 0, message.wire, state.words, instance)
    return message


def encode_battery_status_v2(link, state, instance=0):
    """Return the frame of BATTERY_STATUS_V2 (369), FR-00072.1."""
    return link.encode(build_battery_status_v2(state, instance))


battery_status_v2_frame = encode_battery_status_v2


def write_battery_status_v2(value, place, wire, words, instance):
    """Write the payload of BATTERY_STATUS_V2 (369), FR-00072.1."""
    battery = _BATTERY + _BATTERY_SIZE * instance

    _expire_battery(value, words, battery)

    _expire_battery_current(value, words, battery)

    # voltage [V]: battery.voltage [mV] (FR-00072.4)
    value = words[battery + _BATTERY_VOLTAGE_MV]
    if value == _UNKNOWN:  # goes out as NaN
        wire[0] = 0
        wire[1] = 0
        wire[2] = 192
        wire[3] = 127
    else:
        put_float(wire, 0, value, 1000)

    # current [A]: battery.current [mA] (FR-00072.4)
    value = words[battery + _BATTERY_CURRENT_MA]
    if value == _UNKNOWN:  # goes out as NaN
        wire[4] = 0
        wire[5] = 0
        wire[6] = 192
        wire[7] = 127
    else:
        put_float(wire, 4, value, 1000)

    # capacity_consumed [Ah]: battery.consumed [mAh] (FR-00072.4)
    value = words[battery + _BATTERY_CONSUMED_MAH]
    if value == _UNKNOWN:  # goes out as NaN
        wire[8] = 0
        wire[9] = 0
        wire[10] = 192
        wire[11] = 127
    else:
        put_float(wire, 8, value, 1000)

    # capacity_remaining [Ah]: battery.left [mAh] (FR-00072.4)
    value = words[battery + _BATTERY_LEFT_MAH]
    if value == _UNKNOWN:  # goes out as NaN
        wire[12] = 0
        wire[13] = 0
        wire[14] = 192
        wire[15] = 127
    else:
        if value < 0:
            value = 0
        put_float(wire, 12, value, 1000)

    # state_of_charge [%]: battery.remaining (FR-00072.4)
    value = words[battery + _BATTERY_REMAINING_PCT]
    if value == _UNKNOWN:  # goes out as NaN
        wire[16] = 0
        wire[17] = 0
        wire[18] = 192
        wire[19] = 127
    else:
        if value < 0:
            value = 0
        elif value > 100:
            value = 100
        put_float(wire, 16, value, 1)

    # status_flags: (FR-00072.5)
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.unhealthy
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.used_up
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.over_voltage
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.under_voltage
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.cell_over_voltage
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.cell_under_voltage
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.over_current
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.hot
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.cold
    #   MAV_BATTERY_STATUS_FLAGS_CHARGING if battery.charging
    #   MAV_BATTERY_STATUS_FLAGS_PROTECTIONS_ENABLED if battery.protected
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_OVER_VOLT if battery.over_voltage
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_OVER_VOLT if battery.cell_over_voltage
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_UNDER_VOLT if battery.under_voltage
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_UNDER_VOLT if battery.cell_under_voltage
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_OVER_TEMPERATURE if battery.hot
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_UNDER_TEMPERATURE if battery.cold
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_OVER_CURRENT if battery.over_current
    #   MAV_BATTERY_STATUS_FLAGS_CAPACITY_RELATIVE_TO_FULL if battery.counted_from_full
    wire[20] = 0
    wire[21] = 0
    wire[22] = 0
    wire[23] = 0
    value = words[battery + _BATTERY_HEALTH_NUMBER]
    if value >= 2:
        wire[20] |= 0x1
    value = words[battery + _BATTERY_FAILSAFE_NUMBER]
    if value >= 1:
        wire[20] |= 0x1
    value = words[battery + _BATTERY_VOLTAGE_MV]
    if value >= 12750:
        wire[20] |= 0x1
        wire[21] |= 0x2
    if value < 9000 and value >= 3000:
        wire[20] |= 0x1
        wire[21] |= 0x4
    value = words[battery + _BATTERY_HIGHEST_CELL_MV]
    if value >= 4250:
        wire[20] |= 0x1
        wire[21] |= 0x2
    value = words[battery + _BATTERY_LOWEST_CELL_MV]
    if value < 3000 and value != _UNKNOWN:
        wire[20] |= 0x1
        wire[21] |= 0x4
    value = words[battery + _BATTERY_CURRENT_MA]
    if value >= 132000:
        wire[20] |= 0x1
        wire[21] |= 0x20
    if value < 0 and value != _UNKNOWN:
        wire[20] |= 0x2
    value = words[battery + _BATTERY_TEMPERATURE_CDEGC]
    if value >= 6000:
        wire[20] |= 0x1
        wire[21] |= 0x8
    if value < -2000 and value != _UNKNOWN:
        wire[20] |= 0x1
        wire[21] |= 0x10
    if words[battery + _BATTERY_PROTECTED]:
        wire[20] |= 0x80
    if words[battery + _BATTERY_COUNTED_FROM_FULL]:
        wire[22] |= 0x4

    # temperature [cdegC]: battery.temperature (FR-00072.4)
    value = words[battery + _BATTERY_TEMPERATURE_CDEGC]
    if value < -32768:
        value = 32767 if value == _UNKNOWN else -32768  # unknown, or too small
    elif value > 32766:
        value = 32766
    wire[24] = value & 0xFF
    wire[25] = value >> 8 & 0xFF

    # id: the battery's number (FR-00073.4)
    wire[26] = instance & 0xFF


def build_smart_battery_info(state, instance=0):
    """Return SMART_BATTERY_INFO (370), FR-00076.1."""
    message = _MESSAGES[6][instance]
    if message is None:
        message = _made(6, instance, messages.SmartBatteryInfo)
    write_smart_battery_info(time.ticks_ms(), 0, message.wire, state.words, instance, state.parameters.batt_capacity)
    return message


def encode_smart_battery_info(link, state, instance=0):
    """Return the frame of SMART_BATTERY_INFO (370), FR-00076.1."""
    return link.encode(build_smart_battery_info(state, instance))


smart_battery_info_frame = encode_smart_battery_info


def write_smart_battery_info(value, place, wire, words, instance, batt_capacity):
    """Write the payload of SMART_BATTERY_INFO (370), FR-00076.1."""
    # capacity_full_specification [mAh]: BATT_CAPACITY (FR-00076.1)
    value = batt_capacity
    if value < 0:
        value = 0
    elif value > 1000000:
        value = 1000000
    wire[0] = value & 0xFF
    wire[1] = value >> 8 & 0xFF
    wire[2] = value >> 16 & 0xFF
    wire[3] = value >> 24 & 0xFF

    # capacity_full: unknown (-1) (FR-00076.1)
    wire[4] = 255
    wire[5] = 255
    wire[6] = 255
    wire[7] = 255

    # cycle_count: unknown (UINT16_MAX) (FR-00076.1)
    wire[8] = 255
    wire[9] = 255

    # weight: 250 g (FR-00076.1)
    wire[10] = 250
    wire[11] = 0

    # discharge_minimum_voltage: 3.3 V (FR-00076.1)
    wire[12] = 228
    wire[13] = 12

    # charging_minimum_voltage: 3.0 V (FR-00076.1)
    wire[14] = 184
    wire[15] = 11

    # resting_minimum_voltage: 3.6 V (FR-00076.1)
    wire[16] = 16
    wire[17] = 14

    # id: the battery's number (FR-00073.4)
    wire[18] = instance & 0xFF

    # battery_function: MAV_BATTERY_FUNCTION_ALL (FR-00076.1)
    wire[19] = 1

    # type: MAV_BATTERY_TYPE_LIPO (FR-00076.1)
    wire[20] = 1

    # serial_number: unknown ([0]) (FR-00076.1)

    # device_name: text (FR-00076.1)
    place = 0
    while place < 17:
        wire[37 + place] = _SMART_BATTERY_INFO_DEVICE_NAME[place]
        place += 1

    # charging_maximum_voltage: 4.2 V (FR-00076.1)
    wire[87] = 104
    wire[88] = 16

    # cells_in_series: 3 (FR-00076.1)
    wire[89] = 3

    # discharge_maximum_current: 66 A (FR-00076.1)
    wire[90] = 208
    wire[91] = 1
    wire[92] = 1
    wire[93] = 0

    # discharge_maximum_burst_current: 132 A (FR-00076.1)
    wire[94] = 160
    wire[95] = 3
    wire[96] = 2
    wire[97] = 0

    # manufacture_date: unknown ([0]) (FR-00076.1)


def build_battery_info(state, instance=0):
    """Return BATTERY_INFO (372), FR-00076.2."""
    message = _MESSAGES[7][instance]
    if message is None:
        message = _made(7, instance, messages.BatteryInfo)
    write_battery_info(time.ticks_ms(), 0, message.wire, state.words, instance, state.parameters.batt_capacity)
    return message


def encode_battery_info(link, state, instance=0):
    """Return the frame of BATTERY_INFO (372), FR-00076.2."""
    return link.encode(build_battery_info(state, instance))


battery_info_frame = encode_battery_info


def write_battery_info(value, place, wire, words, instance, batt_capacity):
    """Write the payload of BATTERY_INFO (372), FR-00076.2."""
    # discharge_minimum_voltage: 3.3 V (FR-00076.2)
    wire[0] = 51
    wire[1] = 51
    wire[2] = 83
    wire[3] = 64

    # charging_minimum_voltage: 3.0 V (FR-00076.2)
    wire[4] = 0
    wire[5] = 0
    wire[6] = 64
    wire[7] = 64

    # resting_minimum_voltage: 3.6 V (FR-00076.2)
    wire[8] = 102
    wire[9] = 102
    wire[10] = 102
    wire[11] = 64

    # charging_maximum_voltage: 4.2 V (FR-00076.2)
    wire[12] = 102
    wire[13] = 102
    wire[14] = 134
    wire[15] = 64

    # charging_maximum_current: 3.3 A (FR-00076.2)
    wire[16] = 51
    wire[17] = 51
    wire[18] = 83
    wire[19] = 64

    # nominal_voltage: 11.1 V (FR-00076.2)
    wire[20] = 154
    wire[21] = 153
    wire[22] = 49
    wire[23] = 65

    # discharge_maximum_current: 66 A (FR-00076.2)
    wire[24] = 0
    wire[25] = 0
    wire[26] = 132
    wire[27] = 66

    # discharge_maximum_burst_current: 132 A (FR-00076.2)
    wire[28] = 0
    wire[29] = 0
    wire[30] = 4
    wire[31] = 67

    # design_capacity [Ah]: BATT_CAPACITY [mAh] (FR-00076.2)
    value = batt_capacity
    if value < 1:
        value = 1
    elif value > 1000000:
        value = 1000000
    put_float(wire, 32, value, 1000)

    # full_charge_capacity: unknown (NaN) (FR-00076.2)
    wire[36] = 0
    wire[37] = 0
    wire[38] = 192
    wire[39] = 127

    # cycle_count: unknown (UINT16_MAX) (FR-00076.2)
    wire[40] = 255
    wire[41] = 255

    # weight: 250 g (FR-00076.2)
    wire[42] = 250
    wire[43] = 0

    # id: the battery's number (FR-00073.4)
    wire[44] = instance & 0xFF

    # battery_function: MAV_BATTERY_FUNCTION_ALL (FR-00076.2)
    wire[45] = 1

    # type: MAV_BATTERY_TYPE_LIPO (FR-00076.2)
    wire[46] = 1

    # state_of_health: unknown (UINT8_MAX) (FR-00076.2)
    wire[47] = 255

    # cells_in_series: 3 (FR-00076.2)
    wire[48] = 3

    # manufacture_date: unknown ([0]) (FR-00076.2)

    # serial_number: unknown ([0]) (FR-00076.2)

    # name: text (FR-00076.2)
    place = 0
    while place < 17:
        wire[90 + place] = _BATTERY_INFO_NAME[place]
        place += 1


def build_battery_cell_voltages(state, instance=0, page=0):
    """Return BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    message = _MESSAGES[8][instance]
    if message is None:
        message = _made(8, instance, messages.BatteryCellVoltages)
    write_battery_cell_voltages(time.ticks_ms(), 0, message.wire, state.words, instance, page)
    return message


def encode_battery_cell_voltages(link, state, instance=0, page=0):
    """Return the frame of BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    return link.encode(build_battery_cell_voltages(state, instance, page))


battery_cell_voltages_frame = encode_battery_cell_voltages


def write_battery_cell_voltages(value, place, wire, words, instance, page):
    """Write the payload of BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    battery = _BATTERY + _BATTERY_SIZE * instance

    _expire_battery(value, words, battery)

    # id: the battery's number (FR-00073.4)
    wire[0] = instance & 0xFF
    wire[1] = instance >> 8 & 0xFF

    # index: number of the first value on the page (FR-00076.7)
    wire[2] = (page * 12) & 0xFF
    wire[3] = (page * 12) >> 8 & 0xFF

    # voltages [mV]: battery.cells, a page of them (FR-00076.7)
    place = 0
    while place < 12 and place + page * 12 < 3:
        value = words[battery + _BATTERY_CELLS_MV + place + page * 12]
        if value < 1:
            value = 0 if value == _UNKNOWN else 1  # unknown, or too small
        elif value > 65535:
            value = 65535
        wire[2 * place + 4] = value & 0xFF
        wire[2 * place + 5] = value >> 8 & 0xFF
        place += 1
    while place < 12:
        wire[2 * place + 4] = 0
        wire[2 * place + 5] = 0
        place += 1
