# Generated from specs/messages/autopilot_version.yaml, specs/messages/protocol_version.yaml,
#   specs/smart_battery/board.yaml, specs/smart_battery/codegen.yaml,
#   specs/smart_battery/messages/battery_status.yaml,
#   specs/smart_battery/messages/heartbeat.yaml, specs/smart_battery/parameters.yaml,
#   specs/state.yaml, dialect common: do not edit.
# Inputs: a3ac811dc67613b1
"""Messages of the telemetry, one builder each.

A builder fills in what changes and returns the same message object at each call: send or encode it before the next
one. Constants and sentinels are in place from the start; nothing here allocates.
"""

import time
from struct import pack_into

import messages
import micropython
from conversion import spill


def _new_heartbeat():
    message = messages.Heartbeat(unknown=False)
    wire = message.wire
    # custom_mode: 0
    wire[4] = 36  # type: MAV_TYPE_BATTERY
    wire[5] = 8  # autopilot: MAV_AUTOPILOT_INVALID
    # base_mode: no flag, 0
    wire[7] = 4  # system_status: MAV_STATE_ACTIVE
    wire[8] = 3  # mavlink_version: version of the dialect
    return message


_heartbeat = _new_heartbeat()


@micropython.native
def build_heartbeat(_state):
    """Return HEARTBEAT (0), FR-00074.1."""
    return _heartbeat


def _new_battery_status(instance):
    message = messages.BatteryStatus(
        live=(
            "current_consumed",
            "energy_consumed",
            "temperature",
            "voltages",
            "current_battery",
            "id",
            "battery_remaining",
        ),
        unknown=False,
    )
    wire = message.wire
    wire[33] = 1  # battery_function: MAV_BATTERY_FUNCTION_ALL
    wire[34] = 1  # type: MAV_BATTERY_TYPE_LIPO
    # time_remaining: unknown (0), 0
    # charge_state: MAV_BATTERY_CHARGE_STATE_UNDEFINED, 0
    # voltages_ext: unknown ([0]), 0
    # mode: MAV_BATTERY_MODE_UNKNOWN, 0
    # fault_bitmask: no flag, 0
    return message


_battery_status = [_new_battery_status(instance) for instance in range(1)]


@micropython.native
def build_battery_status(state, instance=0):
    """Return BATTERY_STATUS (147), FR-00074.3."""
    message = _battery_status[instance]
    live = message.live
    battery = state.battery
    expires_ms = battery.expires_ms
    if expires_ms is not None and time.ticks_diff(time.ticks_ms(), expires_ms) > 0:
        battery.expire()

    # current_consumed [mAh]: battery.consumed (FR-00068.6)
    value = battery.consumed_mah
    if value is None:
        value = -1  # unknown
    elif value < -1073741823:
        value = -1073741823
    elif value > 1073741823:
        value = 1073741823
    elif value == -1:
        value = -2  # -1 would read as unknown
    live[0] = value

    # energy_consumed [hJ]: battery.energy (FR-00068.6)
    value = battery.energy_hj
    if value is None:
        value = -1  # unknown
    elif value < -1073741823:
        value = -1073741823
    elif value > 1073741823:
        value = 1073741823
    elif value == -1:
        value = -2  # -1 would read as unknown
    live[1] = value

    # temperature [cdegC]: battery.temperature (FR-00068.6)
    value = battery.temperature_cdegc
    if value is None:
        value = 32767  # unknown
    elif value < -32768:
        value = -32768
    elif value > 32766:
        value = 32766
    live[2] = value

    # voltages [mV]: battery.voltage, spilling above 65534 (FR-00068.3)
    value = battery.voltage_mv
    if value is None or value > 65534 or live[4] != 65535:
        _spill_battery_status_voltages(live, value)
    else:
        live[3] = value if value > 0 else 0

    # current_battery [cA]: battery.current (FR-00068.4)
    value = battery.current_ca
    if value is None:
        value = -1  # unknown
    elif value < -32768:
        value = -32768
    elif value > 32767:
        value = 32767
    elif value == -1:
        value = -2  # -1 would read as unknown
    live[13] = value

    # id: BATT_ID (FR-00074.7)
    value = state.parameters.batt_id
    if value < 0:
        value = 0
    elif value > 9:
        value = 9
    live[14] = value

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = battery.remaining_pct
    if value is None:
        value = -1  # unknown
    elif value < 0:
        value = 0
    elif value > 100:
        value = 100
    live[15] = value
    return message


def _spill_battery_status_voltages(live, value):
    if value is not None and value < 0:
        value = 0
    spill(live, 3, 10, value, 65534, 65535)


def _new_autopilot_version():
    message = messages.AutopilotVersion(unknown=False)
    wire = message.wire
    # capabilities: MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT | MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST |
    # MAV_PROTOCOL_CAPABILITY_MAVLINK2 | MAV_PROTOCOL_CAPABILITY_COMMAND_INT
    pack_into("<Q", wire, 0, 139274)
    # uid: 0
    pack_into("<I", wire, 16, 16777216)  # flight_sw_version: 16777216
    # middleware_sw_version: 0
    # os_sw_version: 0
    # board_version: 0
    # vendor_id: 0
    # product_id: 0
    # flight_custom_version: 0
    # middleware_custom_version: 0
    # os_custom_version: 0
    # uid2: 0
    return message


_autopilot_version = _new_autopilot_version()


@micropython.native
def build_autopilot_version(_state):
    """Return AUTOPILOT_VERSION (148), FR-00070.2."""
    return _autopilot_version


def _new_protocol_version():
    message = messages.ProtocolVersion(unknown=False)
    wire = message.wire
    pack_into("<H", wire, 0, 200)  # version: 200
    pack_into("<H", wire, 2, 100)  # min_version: 100
    pack_into("<H", wire, 4, 200)  # max_version: 200
    # spec_version_hash: 0
    # library_version_hash: 0
    return message


_protocol_version = _new_protocol_version()


@micropython.native
def build_protocol_version(_state):
    """Return PROTOCOL_VERSION (300), FR-00070.2."""
    return _protocol_version
