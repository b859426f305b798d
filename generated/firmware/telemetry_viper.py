# Generated from specs/board.yaml, specs/codegen.yaml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_cell_voltages.yaml, specs/messages/battery_info.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/heartbeat.yaml, specs/messages/protocol_version.yaml,
#   specs/messages/smart_battery_info.yaml, specs/messages/sys_status.yaml,
#   specs/parameters.yaml, specs/state.yaml, dialect common: do not edit.
# Inputs: 03e73bd7087a6bfa
"""From the words of the state to the frame of a message, by MicroPython's viper emitter: one function for each message.

`value` is each value in turn, at last the checksum; `wire` is where the payload goes, in a link's buffer; `words` are
those of the state, see state.py. Calls are dear, and so is each look into an object: so one function does all of it,
and a link and a state know the addresses of what they hold. A link that is too short for the message, signs or sends
MAVLink 1 has no room, see sender.py: there Link.encode() makes the frame of the message. What builds a message calls
the same function with the payload of the message in place of a link's.

Of a function's arguments and variables the first three have registers: so `value` is declared before the others.
Ports with words of 64 bits read 32 bits without their sign: `sign` extends it, and `unknown` is how such a word reads.

Viper checks no bounds. All that is read or written in steps of two or four bytes lies at a multiple of that, which the
smaller Cortex-M insist on. telemetry_plain has the same functions for ports without machine code.
"""

# ptr8, ptr16 and ptr32 are viper's own names.
# ruff: noqa: F821

from time import ticks_ms

import messages
import micropython
from floats_viper import put_floats
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


class _Stand:
    """Stands in for a link where a message is built: the room of that is 1 more than where its payload begins."""

    def __init__(self):
        self.room = _room


_room = [0, None]
_stand = _Stand()
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


def _made(place, instance, kind):
    message = _MESSAGES[place][instance] = kind(unknown=False)
    return message


@micropython.viper
def _stand_in(message):
    _room[0] = int(ptr8(message.wire)) + 1
    return _stand


@micropython.viper
def _finished(wire_at: int, last_word: int, crc_extra: int) -> int:
    """Finish the frame of a payload as others do on their own, and return its length: a call is dear, yet code smaller.

    That is for messages which are on request, or due no more often than every second unless a ground station asks for
    more.
    """
    wire = ptr8(wire_at)
    frame = ptr8(wire_at - 12)
    # Zeros at the end are left out, but never the first byte; the source, which is never 0, stands before them all.
    words = ptr32(int(wire) + last_word)
    while not words[0]:
        words = ptr32(int(words) - 4)
    last = ptr8(int(words) + 3)
    while not last[0]:
        last = ptr8(int(last) - 1)
    length = int(last) - int(wire) + 1
    if length < 1:
        length = 1
    frame[3] = length
    # The byte of the length stands at an odd address, everything after it begins at an even one.
    words = ptr32(int(frame) - 8)
    table = ptr16(words[0] | words[1] << 32)
    high = ptr16(int(table) + 512)
    value = high[length ^ 0xFF] ^ 0xFF
    data = ptr16(int(frame) + 4)
    value ^= data[0]  # the next two bytes are in it already
    left = (length + 8) >> 3
    while left:
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[1]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[2]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[3]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[4]
        data = ptr16(int(data) + 8)
        left -= 1
    if length & 4:
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[1]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[2]
        data = ptr16(int(data) + 4)
    value ^= data[0]
    last = ptr8(data)
    left = length & 3
    while left:
        value = high[(value ^ last[0]) & 0xFF] ^ (value >> 8)
        last = ptr8(int(last) + 1)
        left -= 1
    value = high[(value ^ crc_extra) & 0xFF] ^ (value >> 8)
    last[0] = value
    last[1] = value >> 8
    return length


def build_heartbeat(state):
    """Return HEARTBEAT (0), FR-00068.8."""
    message = _MESSAGES[0][0]
    if message is None:
        message = _made(0, 0, messages.Heartbeat)
    encode_heartbeat(_stand_in(message), state)
    return message


@micropython.viper
def encode_heartbeat(link, state):
    """Return the frame of HEARTBEAT (0), FR-00068.8."""
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 9:
        return link.encode(build_heartbeat(state))
    words = ptr32(int(state.words_at))
    wire32 = ptr32(wire)
    bit = 1
    sign = bit << 31
    vehicle = ptr32(int(words) + 4 * _VEHICLE)

    # What nothing below writes is 0.
    wire32[2] = 0

    # custom_mode: vehicle.mode (FR-00068.8)
    value = (vehicle[_VEHICLE_MODE_NUMBER] ^ sign) - sign
    if value < 0:
        value = 0
    elif value > 1000000:
        value = 1000000
    wire32[0] = value

    # type: MAV_TYPE_GROUND_ROVER (FR-00068.8)
    wire[4] = 10

    # autopilot: MAV_AUTOPILOT_ARDUPILOTMEGA (FR-00068.8)
    wire[5] = 3

    # base_mode: MAV_MODE_FLAG_SAFETY_ARMED if vehicle.armed (FR-00068.8)
    flags = 0x41
    if vehicle[_VEHICLE_ARMED]:
        flags |= 0x80
    wire[6] = flags

    # system_status: vehicle.status (FR-00068.8)
    value = (vehicle[_VEHICLE_STATUS] ^ sign) - sign
    if value < 0:
        value = 3 if value == _UNKNOWN else 0  # until it is set, or too small
    elif value > 8:
        value = 8
    wire[7] = value

    # mavlink_version: version of the dialect (FR-00068.8)
    wire[8] = 3

    if room_at & 1:
        return None
    frame[9] = 0
    frame[10] = 0
    frame[11] = 0
    return views[_finished(int(wire), 8, 50)]


def build_sys_status(state):
    """Return SYS_STATUS (1), FR-00068.9."""
    message = _MESSAGES[1][0]
    if message is None:
        message = _made(1, 0, messages.SysStatus)
    encode_sys_status(_stand_in(message), state)
    return message


@micropython.viper
def encode_sys_status(link, state):
    """Return the frame of SYS_STATUS (1), FR-00068.9."""
    value: int
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 43:
        return link.encode(build_sys_status(state))
    words = ptr32(int(state.words_at))
    batt_sys_status = int(state.parameters.batt_sys_status)
    wire16 = ptr16(wire)
    wire32 = ptr32(wire)
    bit = 1
    sign = bit << 31
    unknown = sign | bit << 30
    vehicle = ptr32(int(words) + 4 * _VEHICLE)

    # The battery that BATT_SYS_STATUS says, from 1 there, or else the first enabled one.
    place = batt_sys_status - 1
    if place < 0 or place >= 2:
        place = 0
    battery = ptr32(int(words) + 4 * (_BATTERY + _BATTERY_SIZE * place))
    if not battery[_BATTERY_MONITORED]:
        place = 0
        battery = ptr32(int(words) + 4 * (_BATTERY + _BATTERY_SIZE * place))
        while place < 1 and not battery[_BATTERY_MONITORED]:
            place += 1
            battery = ptr32(int(words) + 4 * (_BATTERY + _BATTERY_SIZE * place))
        if not battery[_BATTERY_MONITORED]:
            place = 0
            battery = ptr32(int(words) + 4 * (_BATTERY + _BATTERY_SIZE * place))

    # What nothing below writes is 0.
    wire32[4] = 0
    wire32[5] = 0
    wire32[6] = 0
    wire32[7] = 0
    wire32[8] = 0
    wire32[9] = 0
    wire32[10] = 0

    # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
    if battery[_BATTERY_EXPIRES_MS] != unknown:
        if int(ticks_ms()) - battery[_BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
            battery[_BATTERY_TREND_MV_S] = _UNKNOWN
            battery[_BATTERY_TREND_COUNT] = 0
            battery[_BATTERY_TREND_NEWER] = 0
            battery[_BATTERY_TREND_OLDER] = 0
            battery[_BATTERY_EXPIRES_MS] = _UNKNOWN

    # The current is forgotten once it is older than 1000 ms (FR-00077.4).
    if battery[_BATTERY_CURRENT_EXPIRES_MS] != unknown:
        if int(ticks_ms()) - battery[_BATTERY_CURRENT_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_CURRENT_MA] = _UNKNOWN
            battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
            battery[_BATTERY_LEFT_MAH] = _UNKNOWN
            battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
            battery[_BATTERY_CURRENT_EXPIRES_MS] = _UNKNOWN

    # onboard_control_sensors_present: MAV_SYS_STATUS_SENSOR_BATTERY if battery.monitored (FR-00068.9)
    flags = 0x10000000
    if battery[_BATTERY_MONITORED]:
        flags |= 0x2000000
    wire32[0] = flags

    # onboard_control_sensors_enabled: MAV_SYS_STATUS_SENSOR_BATTERY if battery.monitored (FR-00068.9)
    flags = 0x10000000
    if battery[_BATTERY_MONITORED]:
        flags |= 0x2000000
    wire32[1] = flags

    # onboard_control_sensors_health: (FR-00067.3)
    #   MAV_SYS_STATUS_SENSOR_BATTERY if battery.healthy
    #   MAV_SYS_STATUS_PREARM_CHECK if vehicle.ready
    flags = 0x100000
    value = (battery[_BATTERY_VOLTAGE_MV] ^ sign) - sign
    if value != _UNKNOWN:
        flags |= 0x2000000
    if vehicle[_VEHICLE_READY]:
        flags |= 0x10000000
    wire32[2] = flags

    # load [d%]: vehicle.load (FR-00068.9)
    value = (vehicle[_VEHICLE_LOAD_DPCT] ^ sign) - sign
    if value < 0:
        value = 0
    elif value > 1000:
        value = 1000
    wire16[6] = value

    # voltage_battery [mV]: battery.voltage (FR-00068.9)
    value = (battery[_BATTERY_VOLTAGE_MV] ^ sign) - sign
    if value < 0:
        value = 65535 if value == _UNKNOWN else 0  # unknown, or too small
    elif value > 65534:
        value = 65534
    wire16[7] = value

    # current_battery [cA]: battery.current [mA] (FR-00068.4)
    value = (battery[_BATTERY_CURRENT_MA] ^ sign) - sign
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
    wire16[8] = value

    # drop_rate_comm: 0 (FR-00068.9)

    # errors_comm: 0 (FR-00068.9)

    # errors_count1: 0 (FR-00068.9)

    # errors_count2: 0 (FR-00068.9)

    # errors_count3: 0 (FR-00068.9)

    # errors_count4: 0 (FR-00068.9)

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = (battery[_BATTERY_REMAINING_PCT] ^ sign) - sign
    if value < 0:
        value = -1 if value == _UNKNOWN else 0  # unknown, or too small
    elif value > 100:
        value = 100
    wire[30] = value

    # onboard_control_sensors_present_extended: no flag (FR-00068.9)

    # onboard_control_sensors_enabled_extended: no flag (FR-00068.9)

    # onboard_control_sensors_health_extended: no flag (FR-00068.9)

    if room_at & 1:
        return None
    frame[9] = 1
    frame[10] = 0
    frame[11] = 0
    # Zeros at the end are left out, but never the first byte; the source, which is never 0, stands before them all.
    words = ptr32(int(wire) + 40)
    while not words[0]:
        words = ptr32(int(words) - 4)
    last = ptr8(int(words) + 3)
    while not last[0]:
        last = ptr8(int(last) - 1)
    length = int(last) - int(wire) + 1
    if length < 1:
        length = 1
    frame[3] = length
    # The byte of the length stands at an odd address, everything after it begins at an even one.
    words = ptr32(int(frame) - 8)
    table = ptr16(words[0] | words[1] << 32)
    high = ptr16(int(table) + 512)
    value = high[length ^ 0xFF] ^ 0xFF
    data = ptr16(int(frame) + 4)
    value ^= data[0]  # the next two bytes are in it already
    left = (length + 8) >> 3
    while left:
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[1]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[2]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[3]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[4]
        data = ptr16(int(data) + 8)
        left -= 1
    if length & 4:
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[1]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[2]
        data = ptr16(int(data) + 4)
    value ^= data[0]
    last = ptr8(data)
    left = length & 3
    while left:
        value = high[(value ^ last[0]) & 0xFF] ^ (value >> 8)
        last = ptr8(int(last) + 1)
        left -= 1
    value = high[(value ^ 124) & 0xFF] ^ (value >> 8)
    last[0] = value
    last[1] = value >> 8
    return views[length]


def build_battery_status(state, instance=0):
    """Return BATTERY_STATUS (147), FR-00068.1."""
    message = _MESSAGES[2][instance]
    if message is None:
        message = _made(2, instance, messages.BatteryStatus)
    battery_status_frame(_stand_in(message), state, instance)
    return message


@micropython.viper
def battery_status_frame(link, state, instance: int):
    """Return the frame of BATTERY_STATUS (147), FR-00068.1."""
    value: int
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 54:
        return link.encode(build_battery_status(state, instance))
    words = ptr32(int(state.words_at))
    wire16 = ptr16(wire)
    wire32 = ptr32(wire)
    bit = 1
    sign = bit << 31
    unknown = sign | bit << 30
    battery = ptr32(int(words) + 4 * (_BATTERY + _BATTERY_SIZE * instance))

    # What nothing below writes is 0.
    wire32[10] = 0
    wire32[11] = 0
    wire32[12] = 0
    wire32[13] = 0

    # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
    if battery[_BATTERY_EXPIRES_MS] != unknown:
        if int(ticks_ms()) - battery[_BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
            battery[_BATTERY_TREND_MV_S] = _UNKNOWN
            battery[_BATTERY_TREND_COUNT] = 0
            battery[_BATTERY_TREND_NEWER] = 0
            battery[_BATTERY_TREND_OLDER] = 0
            battery[_BATTERY_EXPIRES_MS] = _UNKNOWN

    # The current is forgotten once it is older than 1000 ms (FR-00077.4).
    if battery[_BATTERY_CURRENT_EXPIRES_MS] != unknown:
        if int(ticks_ms()) - battery[_BATTERY_CURRENT_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_CURRENT_MA] = _UNKNOWN
            battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
            battery[_BATTERY_LEFT_MAH] = _UNKNOWN
            battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
            battery[_BATTERY_CURRENT_EXPIRES_MS] = _UNKNOWN

    # current_consumed [mAh]: battery.consumed (FR-00068.6)
    value = (battery[_BATTERY_CONSUMED_MAH] ^ sign) - sign
    if value == _UNKNOWN:
        value = -1  # unknown
    elif value == -1:
        value = -2  # -1 would read as unknown
    wire32[0] = value

    # energy_consumed [hJ]: battery.energy (FR-00068.6)
    value = (battery[_BATTERY_ENERGY_HJ] ^ sign) - sign
    if value == _UNKNOWN:
        value = -1  # unknown
    elif value == -1:
        value = -2  # -1 would read as unknown
    wire32[1] = value

    # temperature [cdegC]: battery.temperature (FR-00068.6)
    value = (battery[_BATTERY_TEMPERATURE_CDEGC] ^ sign) - sign
    if value < -32768:
        value = 32767 if value == _UNKNOWN else -32768  # unknown, or too small
    elif value > 32766:
        value = 32766
    wire16[4] = value

    # voltages [mV]: battery.cells while all are known, else battery.voltage, spilling above 65534 (FR-00068.3)
    place = 0
    while place < 3 and battery[_BATTERY_CELLS_MV + place] != unknown:
        place += 1
    if place == 3:
        place = 0
        while place < 3:
            value = (battery[_BATTERY_CELLS_MV + place] ^ sign) - sign
            if value < 0:
                value = 65535 if value == _UNKNOWN else 0  # unknown, or too small
            elif value > 65534:
                value = 65534
            wire16[5 + place] = value
            place += 1
        while place < 10:
            wire16[5 + place] = 65535
            place += 1
    else:
        value = (battery[_BATTERY_VOLTAGE_MV] ^ sign) - sign
        wire32[3] = -1
        wire32[4] = -1
        wire32[5] = -1
        wire32[6] = -1
        wire16[14] = 65535
        if value == _UNKNOWN:
            wire16[5] = 65535
        else:
            if value < 0:
                value = 0
            elif value > 655340:
                value = 655340
            place = 0
            while value > 65534 and place < 9:
                wire16[5 + place] = 65534
                value -= 65534
                place += 1
            wire16[5 + place] = value

    # current_battery [cA]: battery.current [mA] (FR-00068.4)
    value = (battery[_BATTERY_CURRENT_MA] ^ sign) - sign
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
    wire16[15] = value

    # id: the battery's number (FR-00068.7)
    wire[32] = instance

    # battery_function: MAV_BATTERY_FUNCTION_ALL (FR-00068.7)
    wire[33] = 1

    # type: MAV_BATTERY_TYPE_LIPO (FR-00068.7)
    wire[34] = 1

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = (battery[_BATTERY_REMAINING_PCT] ^ sign) - sign
    if value < 0:
        value = -1 if value == _UNKNOWN else 0  # unknown, or too small
    elif value > 100:
        value = 100
    wire[35] = value

    # time_remaining [s]: battery.time_left (FR-00077.7)
    value = (battery[_BATTERY_TIME_LEFT_S] ^ sign) - sign
    if value < 1:
        value = 0 if value == _UNKNOWN else 1  # unknown, or too small
    elif value > 1000000:
        value = 1000000
    wire32[9] = value

    # charge_state: the first of (FR-00068.6)
    #   MAV_BATTERY_CHARGE_STATE_CHARGING if battery.charging
    #   else MAV_BATTERY_CHARGE_STATE_UNDEFINED
    value = (battery[_BATTERY_CURRENT_MA] ^ sign) - sign
    if value < 0 and value != _UNKNOWN:
        wire[40] = 7

    # voltages_ext [mV]: battery.cells, from 10 while all are known (FR-00068.6)
    # there are 3: all unknown

    # mode: MAV_BATTERY_MODE_UNKNOWN, 0 (FR-00068.6)

    # fault_bitmask: (FR-00068.6)
    #   MAV_BATTERY_FAULT_DEEP_DISCHARGE if battery.under_voltage
    #   MAV_BATTERY_FAULT_DEEP_DISCHARGE if battery.cell_under_voltage
    #   MAV_BATTERY_FAULT_OVER_CURRENT if battery.over_current
    #   MAV_BATTERY_FAULT_OVER_TEMPERATURE if battery.hot
    #   MAV_BATTERY_FAULT_UNDER_TEMPERATURE if battery.cold
    flags = 0
    value = (battery[_BATTERY_VOLTAGE_MV] ^ sign) - sign
    if value < 9000 and value >= 3000:
        flags |= 0x1
    value = (battery[_BATTERY_LOWEST_CELL_MV] ^ sign) - sign
    if value < 3000 and value != _UNKNOWN:
        flags |= 0x1
    value = (battery[_BATTERY_CURRENT_MA] ^ sign) - sign
    if value >= 132000:
        flags |= 0x8
    value = (battery[_BATTERY_TEMPERATURE_CDEGC] ^ sign) - sign
    if value >= 6000:
        flags |= 0x10
    if value < -2000 and value != _UNKNOWN:
        flags |= 0x20
    wire16[25] = flags
    wire16[26] = flags >> 16

    if room_at & 1:
        return None
    frame[9] = 147
    frame[10] = 0
    frame[11] = 0
    # Zeros at the end are left out, but never the first byte; the source, which is never 0, stands before them all.
    words = ptr32(int(wire) + 52)
    while not words[0]:
        words = ptr32(int(words) - 4)
    last = ptr8(int(words) + 3)
    while not last[0]:
        last = ptr8(int(last) - 1)
    length = int(last) - int(wire) + 1
    if length < 1:
        length = 1
    frame[3] = length
    # The byte of the length stands at an odd address, everything after it begins at an even one.
    words = ptr32(int(frame) - 8)
    table = ptr16(words[0] | words[1] << 32)
    high = ptr16(int(table) + 512)
    value = high[length ^ 0xFF] ^ 0xFF
    data = ptr16(int(frame) + 4)
    value ^= data[0]  # the next two bytes are in it already
    left = (length + 8) >> 3
    while left:
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[1]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[2]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[3]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[4]
        data = ptr16(int(data) + 8)
        left -= 1
    if length & 4:
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[1]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[2]
        data = ptr16(int(data) + 4)
    value ^= data[0]
    last = ptr8(data)
    left = length & 3
    while left:
        value = high[(value ^ last[0]) & 0xFF] ^ (value >> 8)
        last = ptr8(int(last) + 1)
        left -= 1
    value = high[(value ^ 154) & 0xFF] ^ (value >> 8)
    last[0] = value
    last[1] = value >> 8
    return views[length]


@micropython.native
def encode_battery_status(link, state, instance=0):
    """Return the frame of BATTERY_STATUS (147), FR-00068.1."""
    return battery_status_frame(link, state, instance)


def build_autopilot_version(state):
    """Return AUTOPILOT_VERSION (148), FR-00070.2."""
    message = _MESSAGES[3][0]
    if message is None:
        message = _made(3, 0, messages.AutopilotVersion)
    encode_autopilot_version(_stand_in(message), state)
    return message


@micropython.viper
def encode_autopilot_version(link, state):
    """Return the frame of AUTOPILOT_VERSION (148), FR-00070.2."""
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 78:
        return link.encode(build_autopilot_version(state))
    wire32 = ptr32(wire)

    # What nothing below writes is 0.
    wire32[2] = 0
    wire32[3] = 0
    place = 5
    while place < 15:
        wire32[place] = 0
        place += 1
    wire32[19] = 0

    # capabilities: MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT + MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST +
    #   MAV_PROTOCOL_CAPABILITY_MAVLINK2 + MAV_PROTOCOL_CAPABILITY_COMMAND_INT (FR-00070.2)
    wire32[0] = 139274
    wire32[1] = 0

    # uid: 0 (FR-00070.2)

    # flight_sw_version: 16777216 (FR-00070.2)
    wire32[4] = 16777216

    # middleware_sw_version: 0 (FR-00070.2)

    # os_sw_version: 0 (FR-00070.2)

    # board_version: 0 (FR-00070.2)

    # vendor_id: 0 (FR-00070.2)

    # product_id: 0 (FR-00070.2)

    # flight_custom_version: 0 (FR-00070.2)

    # middleware_custom_version: 0 (FR-00070.2)

    # os_custom_version: 0 (FR-00070.2)

    # uid2: 0 (FR-00070.2)
    place = 0
    while place < 18:
        wire[60 + place] = 0
        place += 1

    if room_at & 1:
        return None
    frame[9] = 148
    frame[10] = 0
    frame[11] = 0
    return views[_finished(int(wire), 76, 178)]


def build_protocol_version(state):
    """Return PROTOCOL_VERSION (300), FR-00070.2."""
    message = _MESSAGES[4][0]
    if message is None:
        message = _made(4, 0, messages.ProtocolVersion)
    encode_protocol_version(_stand_in(message), state)
    return message


@micropython.viper
def encode_protocol_version(link, state):
    """Return the frame of PROTOCOL_VERSION (300), FR-00070.2."""
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 22:
        return link.encode(build_protocol_version(state))
    wire16 = ptr16(wire)
    wire32 = ptr32(wire)

    # What nothing below writes is 0.
    wire32[1] = 0
    wire32[2] = 0
    wire32[3] = 0
    wire32[4] = 0
    wire32[5] = 0

    # version: 200 (FR-00070.2)
    wire16[0] = 200

    # min_version: 100 (FR-00070.2)
    wire16[1] = 100

    # max_version: 200 (FR-00070.2)
    wire16[2] = 200

    # spec_version_hash: 0 (FR-00070.2)

    # library_version_hash: 0 (FR-00070.2)

    if room_at & 1:
        return None
    frame[9] = 44
    frame[10] = 1
    frame[11] = 0
    return views[_finished(int(wire), 20, 217)]


def build_battery_status_v2(state, instance=0):
    """Return BATTERY_STATUS_V2 (369), FR-00072.1."""
    message = _MESSAGES[5][instance]
    if message is None:
        message = _made(5, instance, messages.BatteryStatusV2)
    battery_status_v2_frame(_stand_in(message), state, instance)
    return message


@micropython.viper
def battery_status_v2_frame(link, state, instance: int):
    """Return the frame of BATTERY_STATUS_V2 (369), FR-00072.1."""
    value: int
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 27:
        return link.encode(build_battery_status_v2(state, instance))
    words = ptr32(int(state.words_at))
    wire16 = ptr16(wire)
    wire32 = ptr32(wire)
    bit = 1
    sign = bit << 31
    unknown = sign | bit << 30
    battery = ptr32(int(words) + 4 * (_BATTERY + _BATTERY_SIZE * instance))

    # What nothing below writes is 0.
    wire32[6] = 0

    # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
    if battery[_BATTERY_EXPIRES_MS] != unknown:
        if int(ticks_ms()) - battery[_BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
            battery[_BATTERY_TREND_MV_S] = _UNKNOWN
            battery[_BATTERY_TREND_COUNT] = 0
            battery[_BATTERY_TREND_NEWER] = 0
            battery[_BATTERY_TREND_OLDER] = 0
            battery[_BATTERY_EXPIRES_MS] = _UNKNOWN

    # The current is forgotten once it is older than 1000 ms (FR-00077.4).
    if battery[_BATTERY_CURRENT_EXPIRES_MS] != unknown:
        if int(ticks_ms()) - battery[_BATTERY_CURRENT_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_CURRENT_MA] = _UNKNOWN
            battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
            battery[_BATTERY_LEFT_MAH] = _UNKNOWN
            battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
            battery[_BATTERY_CURRENT_EXPIRES_MS] = _UNKNOWN

    # voltage [V]: battery.voltage [mV] (FR-00072.4)
    value = (battery[_BATTERY_VOLTAGE_MV] ^ sign) - sign
    if value == _UNKNOWN:  # goes out as NaN
        wire16[0] = 0
        wire16[1] = 0x7FC0
    else:
        wire32[0] = value

    # current [A]: battery.current [mA] (FR-00072.4)
    value = (battery[_BATTERY_CURRENT_MA] ^ sign) - sign
    if value == _UNKNOWN:  # goes out as NaN
        wire16[2] = 0
        wire16[3] = 0x7FC0
    else:
        wire32[1] = value

    # capacity_consumed [Ah]: battery.consumed [mAh] (FR-00072.4)
    value = (battery[_BATTERY_CONSUMED_MAH] ^ sign) - sign
    if value == _UNKNOWN:  # goes out as NaN
        wire16[4] = 0
        wire16[5] = 0x7FC0
    else:
        wire32[2] = value

    # capacity_remaining [Ah]: battery.left [mAh] (FR-00072.4)
    value = (battery[_BATTERY_LEFT_MAH] ^ sign) - sign
    if value == _UNKNOWN:  # goes out as NaN
        wire16[6] = 0
        wire16[7] = 0x7FC0
    else:
        if value < 0:
            value = 0
        wire32[3] = value

    # state_of_charge [%]: battery.remaining (FR-00072.4)
    value = (battery[_BATTERY_REMAINING_PCT] ^ sign) - sign
    if value == _UNKNOWN:  # goes out as NaN
        wire16[8] = 0
        wire16[9] = 0x7FC0
    else:
        if value < 0:
            value = 0
        elif value > 100:
            value = 100
        wire32[4] = value

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
    flags = 0
    value = (battery[_BATTERY_HEALTH_NUMBER] ^ sign) - sign
    if value >= 2:
        flags |= 0x1
    value = (battery[_BATTERY_FAILSAFE_NUMBER] ^ sign) - sign
    if value >= 1:
        flags |= 0x1
    value = (battery[_BATTERY_VOLTAGE_MV] ^ sign) - sign
    if value >= 12750:
        flags |= 0x201
    if value < 9000 and value >= 3000:
        flags |= 0x401
    value = (battery[_BATTERY_HIGHEST_CELL_MV] ^ sign) - sign
    if value >= 4250:
        flags |= 0x201
    value = (battery[_BATTERY_LOWEST_CELL_MV] ^ sign) - sign
    if value < 3000 and value != _UNKNOWN:
        flags |= 0x401
    value = (battery[_BATTERY_CURRENT_MA] ^ sign) - sign
    if value >= 132000:
        flags |= 0x2001
    if value < 0 and value != _UNKNOWN:
        flags |= 0x2
    value = (battery[_BATTERY_TEMPERATURE_CDEGC] ^ sign) - sign
    if value >= 6000:
        flags |= 0x801
    if value < -2000 and value != _UNKNOWN:
        flags |= 0x1001
    if battery[_BATTERY_PROTECTED]:
        flags |= 0x80
    if battery[_BATTERY_COUNTED_FROM_FULL]:
        flags |= 0x40000
    wire32[5] = flags

    # temperature [cdegC]: battery.temperature (FR-00072.4)
    value = (battery[_BATTERY_TEMPERATURE_CDEGC] ^ sign) - sign
    if value < -32768:
        value = 32767 if value == _UNKNOWN else -32768  # unknown, or too small
    elif value > 32766:
        value = 32766
    wire16[12] = value

    # id: the battery's number (FR-00073.4)
    wire[26] = instance

    # As floats, each whole number divided: that at 0 / 1000, that at 4 / 1000, that at 8 / 1000, that at 12 / 1000,
    #   that at 16 / 1.
    put_floats(
        int(wire), b"\x00\xfa\x00\x00\x01\xfa\x00\x00\x02\xfa\x00\x00\x03\xfa\x00\x00D\x00\x00\x00\x00\x00\x00\x00"
    )

    if room_at & 1:
        return None
    frame[9] = 113
    frame[10] = 1
    frame[11] = 0
    # Zeros at the end are left out, but never the first byte; the source, which is never 0, stands before them all.
    words = ptr32(int(wire) + 24)
    while not words[0]:
        words = ptr32(int(words) - 4)
    last = ptr8(int(words) + 3)
    while not last[0]:
        last = ptr8(int(last) - 1)
    length = int(last) - int(wire) + 1
    if length < 1:
        length = 1
    frame[3] = length
    # The byte of the length stands at an odd address, everything after it begins at an even one.
    words = ptr32(int(frame) - 8)
    table = ptr16(words[0] | words[1] << 32)
    high = ptr16(int(table) + 512)
    value = high[length ^ 0xFF] ^ 0xFF
    data = ptr16(int(frame) + 4)
    value ^= data[0]  # the next two bytes are in it already
    left = (length + 8) >> 3
    while left:
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[1]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[2]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[3]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[4]
        data = ptr16(int(data) + 8)
        left -= 1
    if length & 4:
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[1]
        value = table[value & 0xFF] ^ high[value >> 8] ^ data[2]
        data = ptr16(int(data) + 4)
    value ^= data[0]
    last = ptr8(data)
    left = length & 3
    while left:
        value = high[(value ^ last[0]) & 0xFF] ^ (value >> 8)
        last = ptr8(int(last) + 1)
        left -= 1
    value = high[(value ^ 145) & 0xFF] ^ (value >> 8)
    last[0] = value
    last[1] = value >> 8
    return views[length]


@micropython.native
def encode_battery_status_v2(link, state, instance=0):
    """Return the frame of BATTERY_STATUS_V2 (369), FR-00072.1."""
    return battery_status_v2_frame(link, state, instance)


def build_smart_battery_info(state, instance=0):
    """Return SMART_BATTERY_INFO (370), FR-00076.1."""
    message = _MESSAGES[6][instance]
    if message is None:
        message = _made(6, instance, messages.SmartBatteryInfo)
    smart_battery_info_frame(_stand_in(message), state, instance)
    return message


@micropython.viper
def smart_battery_info_frame(link, state, instance: int):
    """Return the frame of SMART_BATTERY_INFO (370), FR-00076.1."""
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 109:
        return link.encode(build_smart_battery_info(state, instance))
    batt_capacity = int(state.parameters.batt_capacity)
    wire16 = ptr16(wire)
    wire32 = ptr32(wire)

    # What nothing below writes is 0.
    place = 5
    while place < 22:
        wire32[place] = 0
        place += 1
    wire32[24] = 0
    wire32[25] = 0
    wire32[26] = 0
    wire32[27] = 0

    # capacity_full_specification [mAh]: BATT_CAPACITY (FR-00076.1)
    value = batt_capacity
    if value < 0:
        value = 0
    elif value > 1000000:
        value = 1000000
    wire32[0] = value

    # capacity_full: unknown (-1) (FR-00076.1)
    wire32[1] = -1

    # cycle_count: unknown (UINT16_MAX) (FR-00076.1)
    wire16[4] = 65535

    # weight: 250 g (FR-00076.1)
    wire16[5] = 250

    # discharge_minimum_voltage: 3.3 V (FR-00076.1)
    wire16[6] = 3300

    # charging_minimum_voltage: 3.0 V (FR-00076.1)
    wire16[7] = 3000

    # resting_minimum_voltage: 3.6 V (FR-00076.1)
    wire16[8] = 3600

    # id: the battery's number (FR-00073.4)
    wire[18] = instance

    # battery_function: MAV_BATTERY_FUNCTION_ALL (FR-00076.1)
    wire[19] = 1

    # type: MAV_BATTERY_TYPE_LIPO (FR-00076.1)
    wire[20] = 1

    # serial_number: unknown ([0]) (FR-00076.1)

    # device_name: text (FR-00076.1)
    text = ptr8(_SMART_BATTERY_INFO_DEVICE_NAME)
    place = 0
    while place < 17:
        wire[37 + place] = text[place]
        place += 1

    # charging_maximum_voltage: 4.2 V (FR-00076.1)
    wire[87] = 104
    wire[88] = 16

    # cells_in_series: 3 (FR-00076.1)
    wire[89] = 3

    # discharge_maximum_current: 66 A (FR-00076.1)
    wire16[45] = 464
    wire16[46] = 1

    # discharge_maximum_burst_current: 132 A (FR-00076.1)
    wire16[47] = 928
    wire16[48] = 2

    # manufacture_date: unknown ([0]) (FR-00076.1)

    if room_at & 1:
        return None
    frame[9] = 114
    frame[10] = 1
    frame[11] = 0
    return views[_finished(int(wire), 108, 75)]


def encode_smart_battery_info(link, state, instance=0):
    """Return the frame of SMART_BATTERY_INFO (370), FR-00076.1."""
    return smart_battery_info_frame(link, state, instance)


def build_battery_info(state, instance=0):
    """Return BATTERY_INFO (372), FR-00076.2."""
    message = _MESSAGES[7][instance]
    if message is None:
        message = _made(7, instance, messages.BatteryInfo)
    battery_info_frame(_stand_in(message), state, instance)
    return message


@micropython.viper
def battery_info_frame(link, state, instance: int):
    """Return the frame of BATTERY_INFO (372), FR-00076.2."""
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 140:
        return link.encode(build_battery_info(state, instance))
    batt_capacity = int(state.parameters.batt_capacity)
    wire16 = ptr16(wire)
    wire32 = ptr32(wire)

    # What nothing below writes is 0.
    wire32[1] = 0
    wire32[6] = 0
    wire32[7] = 0
    wire32[9] = 0
    place = 12
    while place < 35:
        wire32[place] = 0
        place += 1

    # discharge_minimum_voltage: 3.3 V (FR-00076.2)
    wire16[0] = 13107
    wire16[1] = 16467

    # charging_minimum_voltage: 3.0 V (FR-00076.2)
    wire16[3] = 16448

    # resting_minimum_voltage: 3.6 V (FR-00076.2)
    wire16[4] = 26214
    wire16[5] = 16486

    # charging_maximum_voltage: 4.2 V (FR-00076.2)
    wire16[6] = 26214
    wire16[7] = 16518

    # charging_maximum_current: 3.3 A (FR-00076.2)
    wire16[8] = 13107
    wire16[9] = 16467

    # nominal_voltage: 11.1 V (FR-00076.2)
    wire16[10] = 39322
    wire16[11] = 16689

    # discharge_maximum_current: 66 A (FR-00076.2)
    wire16[13] = 17028

    # discharge_maximum_burst_current: 132 A (FR-00076.2)
    wire16[15] = 17156

    # design_capacity [Ah]: BATT_CAPACITY [mAh] (FR-00076.2)
    value = batt_capacity
    if value < 1:
        value = 1
    elif value > 1000000:
        value = 1000000
    wire32[8] = value

    # full_charge_capacity: unknown (NaN) (FR-00076.2)
    wire16[19] = 32704

    # cycle_count: unknown (UINT16_MAX) (FR-00076.2)
    wire16[20] = 65535

    # weight: 250 g (FR-00076.2)
    wire16[21] = 250

    # id: the battery's number (FR-00073.4)
    wire[44] = instance

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
    text = ptr8(_BATTERY_INFO_NAME)
    place = 0
    while place < 17:
        wire[90 + place] = text[place]
        place += 1

    # As floats, each whole number divided: that at 32 / 1000.
    put_floats(int(wire), b"\x08\xfa\x00\x00\x00\x00\x00\x00")

    if room_at & 1:
        return None
    frame[9] = 116
    frame[10] = 1
    frame[11] = 0
    return views[_finished(int(wire), 136, 26)]


def encode_battery_info(link, state, instance=0):
    """Return the frame of BATTERY_INFO (372), FR-00076.2."""
    return battery_info_frame(link, state, instance)


def build_battery_cell_voltages(state, instance=0, page=0):
    """Return BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    message = _MESSAGES[8][instance]
    if message is None:
        message = _made(8, instance, messages.BatteryCellVoltages)
    battery_cell_voltages_frame(_stand_in(message), state, instance, page)
    return message


@micropython.viper
def battery_cell_voltages_frame(link, state, instance: int, page: int):
    """Return the frame of BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    room, views = link.room
    room_at = int(room)
    wire = ptr8(room_at & -4)
    frame = ptr8(int(wire) - 12)
    if not room_at & 1 and int(frame[0]) < 28:
        return link.encode(build_battery_cell_voltages(state, instance, page))
    words = ptr32(int(state.words_at))
    wire16 = ptr16(wire)
    wire32 = ptr32(wire)
    bit = 1
    sign = bit << 31
    unknown = sign | bit << 30
    battery = ptr32(int(words) + 4 * (_BATTERY + _BATTERY_SIZE * instance))

    # What nothing below writes is 0.
    wire32[1] = 0
    wire32[2] = 0
    wire32[3] = 0
    wire32[4] = 0
    wire32[5] = 0
    wire32[6] = 0

    # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
    if battery[_BATTERY_EXPIRES_MS] != unknown:
        if int(ticks_ms()) - battery[_BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
            battery[_BATTERY_TREND_MV_S] = _UNKNOWN
            battery[_BATTERY_TREND_COUNT] = 0
            battery[_BATTERY_TREND_NEWER] = 0
            battery[_BATTERY_TREND_OLDER] = 0
            battery[_BATTERY_EXPIRES_MS] = _UNKNOWN

    # id: the battery's number (FR-00073.4)
    wire16[0] = instance

    # index: number of the first value on the page (FR-00076.7)
    wire16[1] = page * 12

    # voltages [mV]: battery.cells, a page of them (FR-00076.7)
    place = 0
    while place < 12 and place + page * 12 < 3:
        value = (battery[_BATTERY_CELLS_MV + place + page * 12] ^ sign) - sign
        if value < 1:
            value = 0 if value == _UNKNOWN else 1  # unknown, or too small
        elif value > 65535:
            value = 65535
        wire16[2 + place] = value
        place += 1

    if room_at & 1:
        return None
    frame[9] = 99
    frame[10] = 212
    frame[11] = 0
    return views[_finished(int(wire), 24, 8)]


def encode_battery_cell_voltages(link, state, instance=0, page=0):
    """Return the frame of BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    return battery_cell_voltages_frame(link, state, instance, page)
