# Generated from specs/board.yaml, specs/messages/battery_status.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/sys_status.yaml, specs/parameters.yaml, specs/state.yaml, dialect common: do not edit.
# Inputs: a54bf13a8c3ac865
"""Messages of the telemetry, one builder each.

A builder fills in what changes and returns the same message object at each call: send or encode it before the next
one. Constants and sentinels are in place from the start; nothing here allocates.
"""

import time
from struct import pack_into

import messages
from conversion import limited, spill


def _new_heartbeat():
    message = messages.Heartbeat()
    payload = message.payload
    payload[4] = 10  # type: MAV_TYPE_GROUND_ROVER
    payload[5] = 3  # autopilot: MAV_AUTOPILOT_ARDUPILOTMEGA
    payload[6] = 65  # base_mode: MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | MAV_MODE_FLAG_MANUAL_INPUT_ENABLED
    payload[8] = 3  # mavlink_version: version of the dialect
    return message


_heartbeat = _new_heartbeat()


def build_heartbeat(state):
    """Return HEARTBEAT (0), FR-00068.8."""
    message = _heartbeat
    payload = message.payload
    vehicle = state.vehicle

    # custom_mode: vehicle.mode (FR-00068.8)
    value = vehicle.mode_number
    value = 0 if value is None else limited(value, 0, 1000000)
    pack_into("<I", payload, 0, value)

    # base_mode: MAV_MODE_FLAG_SAFETY_ARMED if vehicle.armed (FR-00068.8)
    payload[6] = 0x41 | (0x80 if vehicle.armed else 0)

    # system_status: vehicle.status (FR-00068.8)
    value = vehicle.status
    value = 3 if value is None else limited(value, 0, 8)
    payload[7] = value
    return message


def _new_sys_status():
    message = messages.SysStatus()
    payload = message.payload
    pack_into("<I", payload, 0, 33554432)  # onboard_control_sensors_present: MAV_SYS_STATUS_SENSOR_BATTERY
    pack_into("<I", payload, 4, 33554432)  # onboard_control_sensors_enabled: MAV_SYS_STATUS_SENSOR_BATTERY
    # onboard_control_sensors_health: no flag, 0
    # drop_rate_comm: 0
    # errors_comm: 0
    # errors_count1: 0
    # errors_count2: 0
    # errors_count3: 0
    # errors_count4: 0
    # onboard_control_sensors_present_extended: no flag, 0
    # onboard_control_sensors_enabled_extended: no flag, 0
    # onboard_control_sensors_health_extended: no flag, 0
    return message


_sys_status = _new_sys_status()


def build_sys_status(state):
    """Return SYS_STATUS (1), FR-00068.9."""
    message = _sys_status
    payload = message.payload
    battery = state.battery
    battery.expire(time.ticks_ms())
    vehicle = state.vehicle

    # onboard_control_sensors_health: MAV_SYS_STATUS_SENSOR_BATTERY if battery.healthy (FR-00067.3)
    payload[11] = 0x02 if battery.healthy else 0

    # load [d%]: vehicle.load (FR-00068.9)
    value = vehicle.load_dpct
    value = 0 if value is None else limited(value, 0, 1000)
    pack_into("<H", payload, 12, value)

    # voltage_battery [mV]: battery.voltage (FR-00068.9)
    value = battery.voltage_mv
    value = 65535 if value is None else limited(value, 0, 65534)
    pack_into("<H", payload, 14, value)

    # current_battery [cA]: battery.current (FR-00068.4)
    value = battery.current_ca
    if value is None:
        value = -1  # unknown
    else:
        value = limited(value, -32768, 32767)
        if value == -1:
            value = -2  # -1 would read as unknown
    pack_into("<h", payload, 16, value)

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = battery.remaining_pct
    value = -1 if value is None else limited(value, 0, 100)
    pack_into("<b", payload, 30, value)
    return message


def _new_battery_status(instance):
    message = messages.BatteryStatus()
    payload = message.payload
    payload[32] = instance  # id: the battery's number
    payload[33] = 1  # battery_function: MAV_BATTERY_FUNCTION_ALL
    payload[34] = 1  # type: MAV_BATTERY_TYPE_LIPO
    # time_remaining: unknown (0), 0
    # charge_state: MAV_BATTERY_CHARGE_STATE_UNDEFINED, 0
    # voltages_ext: unknown ([0]), 0
    # mode: MAV_BATTERY_MODE_UNKNOWN, 0
    # fault_bitmask: no flag, 0
    return message


_battery_status = [_new_battery_status(instance) for instance in range(1)]


def build_battery_status(state, instance=0):
    """Return BATTERY_STATUS (147), FR-00068.1."""
    message = _battery_status[instance]
    payload = message.payload
    battery = state.battery
    battery.expire(time.ticks_ms())

    # current_consumed [mAh]: battery.consumed (FR-00068.6)
    value = battery.consumed_mah
    if value is None:
        value = -1  # unknown
    else:
        value = limited(value, -1073741823, 1073741823)
        if value == -1:
            value = -2  # -1 would read as unknown
    pack_into("<i", payload, 0, value)

    # energy_consumed [hJ]: battery.energy (FR-00068.6)
    value = battery.energy_hj
    if value is None:
        value = -1  # unknown
    else:
        value = limited(value, -1073741823, 1073741823)
        if value == -1:
            value = -2  # -1 would read as unknown
    pack_into("<i", payload, 4, value)

    # temperature [cdegC]: battery.temperature (FR-00068.6)
    value = battery.temperature_cdegc
    value = 32767 if value is None else limited(value, -32768, 32766)
    pack_into("<h", payload, 8, value)

    # voltages [mV]: battery.voltage, spilling above 65534 (FR-00068.3)
    value = battery.voltage_mv
    if value is not None:
        value = limited(value, 0, 655340)
    spill(payload, "<H", 10, 2, 10, value, 65534, 65535)

    # current_battery [cA]: battery.current (FR-00068.4)
    value = battery.current_ca
    if value is None:
        value = -1  # unknown
    else:
        value = limited(value, -32768, 32767)
        if value == -1:
            value = -2  # -1 would read as unknown
    pack_into("<h", payload, 30, value)

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = battery.remaining_pct
    value = -1 if value is None else limited(value, 0, 100)
    pack_into("<b", payload, 35, value)
    return message
