# Generated from specs/board.yaml, specs/codegen.yaml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_cell_voltages.yaml, specs/messages/battery_info.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/heartbeat.yaml, specs/messages/protocol_version.yaml,
#   specs/messages/smart_battery_info.yaml, specs/messages/sys_status.yaml,
#   specs/parameters.yaml, specs/state.yaml, dialect common: do not edit.
# Inputs: bd634d5381aacf98
"""Messages of the telemetry, one builder each.

A builder fills in what changes and returns the same message object at each call: send or encode it before the next
one. Constants and sentinels are in place from the start; nothing here allocates.
"""

from struct import pack_into

import messages
import micropython
from conversion import complete, limited, spill

try:
    from floats_viper import put_float
except (AttributeError, ImportError, SyntaxError, ValueError):  # as in frames
    from floats_plain import put_float

NAN = float("nan")


def _new_heartbeat():
    message = messages.Heartbeat(live=("custom_mode", "base_mode", "system_status"), unknown=False)
    wire = message.wire
    wire[4] = 10  # type: MAV_TYPE_GROUND_ROVER
    wire[5] = 3  # autopilot: MAV_AUTOPILOT_ARDUPILOTMEGA
    wire[6] = 65  # base_mode: MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | MAV_MODE_FLAG_MANUAL_INPUT_ENABLED
    wire[8] = 3  # mavlink_version: version of the dialect
    return message


_heartbeat = _new_heartbeat()


@micropython.native
def build_heartbeat(state):
    """Return HEARTBEAT (0), FR-00068.8."""
    message = _heartbeat
    live = message.live
    vehicle = state.vehicle

    # custom_mode: vehicle.mode (FR-00068.8)
    value = vehicle.mode_number
    if value is None:
        value = 0  # until it is set
    elif value < 0:
        value = 0
    elif value > 1000000:
        value = 1000000
    live[0] = value

    # base_mode: MAV_MODE_FLAG_SAFETY_ARMED if vehicle.armed (FR-00068.8)
    live[1] = 0x41 | (0x80 if vehicle.armed else 0)

    # system_status: vehicle.status (FR-00068.8)
    value = vehicle.status
    if value is None:
        value = 3  # until it is set
    elif value < 0:
        value = 0
    elif value > 8:
        value = 8
    live[2] = value
    return message


def _new_sys_status():
    message = messages.SysStatus(
        live=(
            "load",
            "voltage_battery",
            "current_battery",
            "battery_remaining",
        ),
        unknown=False,
    )
    wire = message.wire
    pack_into("<I", wire, 0, 268435456)  # onboard_control_sensors_present: MAV_SYS_STATUS_PREARM_CHECK
    pack_into("<I", wire, 4, 268435456)  # onboard_control_sensors_enabled: MAV_SYS_STATUS_PREARM_CHECK
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


def _sys_status_battery(state):
    """Return the battery that BATT_SYS_STATUS numbers, from 1, or else the first enabled one."""
    known = state.battery
    number = state.parameters.batt_sys_status - 1
    if number < 2 and known[number].monitored:
        return known[number]
    for battery in known:
        if battery.monitored:
            return battery
    return known[0]


@micropython.native
def build_sys_status(state):
    """Return SYS_STATUS (1), FR-00068.9."""
    message = _sys_status
    live = message.live
    wire = message.wire
    battery = _sys_status_battery(state)
    vehicle = state.vehicle
    battery.expire()

    # onboard_control_sensors_present: MAV_SYS_STATUS_SENSOR_BATTERY if battery.monitored (FR-00068.9)
    wire[3] = 0x10 | (0x02 if battery.monitored else 0)

    # onboard_control_sensors_enabled: MAV_SYS_STATUS_SENSOR_BATTERY if battery.monitored (FR-00068.9)
    wire[7] = 0x10 | (0x02 if battery.monitored else 0)

    # onboard_control_sensors_health: (FR-00067.3)
    #   MAV_SYS_STATUS_SENSOR_BATTERY if battery.healthy
    #   MAV_SYS_STATUS_PREARM_CHECK if vehicle.ready
    wire[11] = (0x02 if battery.healthy else 0) | (0x10 if vehicle.ready else 0)

    # load [d%]: vehicle.load (FR-00068.9)
    value = vehicle.load_dpct
    if value is None:
        value = 0  # until it is set
    elif value < 0:
        value = 0
    elif value > 1000:
        value = 1000
    live[0] = value

    # voltage_battery [mV]: battery.voltage (FR-00068.9)
    value = battery.voltage_mv
    if value is None:
        value = 65535  # unknown
    elif value < 0:
        value = 0
    elif value > 65534:
        value = 65534
    live[1] = value

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
    live[2] = value

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = battery.remaining_pct
    if value is None:
        value = -1  # unknown
    elif value < 0:
        value = 0
    elif value > 100:
        value = 100
    live[3] = value
    return message


def _new_battery_status(instance):
    message = messages.BatteryStatus(
        live=(
            "current_consumed",
            "energy_consumed",
            "temperature",
            "voltages",
            "current_battery",
            "battery_remaining",
            "voltages_ext",
        ),
        unknown=False,
    )
    wire = message.wire
    wire[32] = instance  # id: the battery's number
    wire[33] = 1  # battery_function: MAV_BATTERY_FUNCTION_ALL
    wire[34] = 1  # type: MAV_BATTERY_TYPE_LIPO
    # time_remaining: unknown (0), 0
    # charge_state: MAV_BATTERY_CHARGE_STATE_UNDEFINED, 0
    # mode: MAV_BATTERY_MODE_UNKNOWN, 0
    # fault_bitmask: no flag, 0
    return message


_battery_status = [_new_battery_status(instance) for instance in range(2)]


@micropython.native
def build_battery_status(state, instance=0):
    """Return BATTERY_STATUS (147), FR-00068.1."""
    message = _battery_status[instance]
    live = message.live
    wire = message.wire
    battery = state.battery[instance]
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

    # voltages [mV]: battery.cells while all are known, else battery.voltage, spilling above 65534 (FR-00068.3)
    value = battery.voltage_mv
    if complete(battery.cells_mv, 14):
        _fill_battery_status_voltages(live, battery.cells_mv)
    elif value is None or value > 65534 or live[4] != 65535:
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

    # battery_remaining [%]: battery.remaining (FR-00068.5)
    value = battery.remaining_pct
    if value is None:
        value = -1  # unknown
    elif value < 0:
        value = 0
    elif value > 100:
        value = 100
    live[14] = value

    # voltages_ext [mV]: battery.cells, from 10 while all are known (FR-00068.6)
    _fill_battery_status_voltages_ext(live, battery.cells_mv)

    # fault_bitmask: (FR-00068.6)
    #   MAV_BATTERY_FAULT_DEEP_DISCHARGE if battery.under_voltage
    #   MAV_BATTERY_FAULT_OVER_TEMPERATURE if battery.hot
    #   MAV_BATTERY_FAULT_UNDER_TEMPERATURE if battery.cold
    wire[50] = (0x01 if battery.under_voltage else 0) | (0x10 if battery.hot else 0) | (0x20 if battery.cold else 0)
    return message


def _spill_battery_status_voltages(live, value):
    if value is not None and value < 0:
        value = 0
    spill(live, 3, 10, value, 65534, 65535)


def _fill_battery_status_voltages(live, values):
    for index in range(10):
        value = values[index] if index < len(values) else None
        if value is None:
            value = 65535  # unknown, or not there
        elif value < 0:
            value = 0
        elif value > 65534:
            value = 65534
        live[3 + index] = value


def _fill_battery_status_voltages_ext(live, values):
    if not complete(values, 14):
        values = ()
    for index in range(4):
        place = 10 + index
        value = values[place] if place < len(values) else None
        if value is None:
            value = 0  # unknown, or not there
        elif value < 1:
            value = 1
        elif value > 65535:
            value = 65535
        live[15 + index] = value


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


def _new_battery_status_v2(instance):
    message = messages.BatteryStatusV2(live=("temperature",), unknown=False)
    wire = message.wire
    # status_flags: no flag, 0
    wire[26] = instance  # id: the battery's number
    return message


_battery_status_v2 = [_new_battery_status_v2(instance) for instance in range(2)]


@micropython.native
def build_battery_status_v2(state, instance=0):
    """Return BATTERY_STATUS_V2 (369), FR-00072.1."""
    message = _battery_status_v2[instance]
    live = message.live
    wire = message.wire
    state.battery[instance].expire()

    # voltage [V]: battery.voltage [mV] (FR-00072.4)
    value = state.battery[instance].voltage_mv
    if value is None:
        pack_into("<f", wire, 0, NAN)  # unknown
    else:
        value = limited(value, -1073741823, 1073741823)
        put_float(wire, 0, value, 1000)

    # current [A]: battery.current [cA] (FR-00072.4)
    value = state.battery[instance].current_ca
    if value is None:
        pack_into("<f", wire, 4, NAN)  # unknown
    else:
        value = limited(value, -1073741823, 1073741823)
        put_float(wire, 4, value, 100)

    # capacity_consumed [Ah]: battery.consumed [mAh] (FR-00072.4)
    value = state.battery[instance].consumed_mah
    if value is None:
        pack_into("<f", wire, 8, NAN)  # unknown
    else:
        value = limited(value, -1073741823, 1073741823)
        put_float(wire, 8, value, 1000)

    # capacity_remaining [Ah]: battery.left [mAh] (FR-00072.4)
    value = state.battery[instance].left_mah
    if value is None:
        pack_into("<f", wire, 12, NAN)  # unknown
    else:
        value = limited(value, 0, 1073741823)
        put_float(wire, 12, value, 1000)

    # state_of_charge [%]: battery.remaining (FR-00072.4)
    value = state.battery[instance].remaining_pct
    if value is None:
        pack_into("<f", wire, 16, NAN)  # unknown
    else:
        value = limited(value, 0, 100)
        put_float(wire, 16, value, 1)

    # status_flags: (FR-00072.5)
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.unhealthy
    #   MAV_BATTERY_STATUS_FLAGS_NOT_READY_TO_USE if battery.used_up
    #   MAV_BATTERY_STATUS_FLAGS_CHARGING if battery.charging
    #   MAV_BATTERY_STATUS_FLAGS_PROTECTIONS_ENABLED if battery.protected
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_OVER_VOLT if battery.over_voltage
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_UNDER_VOLT if battery.under_voltage
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_OVER_TEMPERATURE if battery.hot
    #   MAV_BATTERY_STATUS_FLAGS_FAULT_UNDER_TEMPERATURE if battery.cold
    #   MAV_BATTERY_STATUS_FLAGS_CAPACITY_RELATIVE_TO_FULL if battery.counted_from_full
    wire[20] = (
        (0x01 if state.battery[instance].unhealthy else 0)
        | (0x01 if state.battery[instance].used_up else 0)
        | (0x02 if state.battery[instance].charging else 0)
        | (0x80 if state.battery[instance].protected else 0)
    )
    wire[21] = (
        (0x02 if state.battery[instance].over_voltage else 0)
        | (0x04 if state.battery[instance].under_voltage else 0)
        | (0x08 if state.battery[instance].hot else 0)
        | (0x10 if state.battery[instance].cold else 0)
    )
    wire[22] = 0x04 if state.battery[instance].counted_from_full else 0

    # temperature [cdegC]: battery.temperature (FR-00072.4)
    value = state.battery[instance].temperature_cdegc
    if value is None:
        value = 32767  # unknown
    elif value < -32768:
        value = -32768
    elif value > 32766:
        value = 32766
    live[0] = value
    return message


def _new_smart_battery_info(instance):
    message = messages.SmartBatteryInfo(live=("capacity_full_specification",), unknown=False)
    wire = message.wire
    pack_into("<i", wire, 4, -1)  # capacity_full: unknown (-1)
    pack_into("<H", wire, 8, 65535)  # cycle_count: unknown (UINT16_MAX)
    pack_into("<H", wire, 10, 250)  # weight: 250 g
    pack_into("<H", wire, 12, 3300)  # discharge_minimum_voltage: 3.3 V
    pack_into("<H", wire, 14, 3000)  # charging_minimum_voltage: 3.0 V
    pack_into("<H", wire, 16, 3600)  # resting_minimum_voltage: 3.6 V
    wire[18] = instance  # id: the battery's number
    wire[19] = 1  # battery_function: MAV_BATTERY_FUNCTION_ALL
    wire[20] = 1  # type: MAV_BATTERY_TYPE_LIPO
    # serial_number: unknown ([0])
    message.set("device_name", "generic_LiPo-3300")  # device_name: text
    pack_into("<H", wire, 87, 4200)  # charging_maximum_voltage: 4.2 V
    wire[89] = 3  # cells_in_series: 3
    pack_into("<I", wire, 90, 66000)  # discharge_maximum_current: 66 A
    pack_into("<I", wire, 94, 132000)  # discharge_maximum_burst_current: 132 A
    # manufacture_date: unknown ([0])
    return message


_smart_battery_info = [_new_smart_battery_info(instance) for instance in range(2)]


@micropython.native
def build_smart_battery_info(state, instance=0):
    """Return SMART_BATTERY_INFO (370), FR-00076.1."""
    message = _smart_battery_info[instance]
    live = message.live

    # capacity_full_specification [mAh]: BATT_CAPACITY (FR-00076.1)
    value = state.parameters.batt_capacity
    if value < 0:
        value = 0
    elif value > 1000000:
        value = 1000000
    live[0] = value
    return message


def _new_battery_info(instance):
    message = messages.BatteryInfo(unknown=False)
    wire = message.wire
    pack_into("<f", wire, 0, 3.3)  # discharge_minimum_voltage: 3.3 V
    pack_into("<f", wire, 4, 3.0)  # charging_minimum_voltage: 3.0 V
    pack_into("<f", wire, 8, 3.6)  # resting_minimum_voltage: 3.6 V
    pack_into("<f", wire, 12, 4.2)  # charging_maximum_voltage: 4.2 V
    pack_into("<f", wire, 16, 3.3)  # charging_maximum_current: 3.3 A
    pack_into("<f", wire, 20, 11.1)  # nominal_voltage: 11.1 V
    pack_into("<f", wire, 24, 66.0)  # discharge_maximum_current: 66 A
    pack_into("<f", wire, 28, 132.0)  # discharge_maximum_burst_current: 132 A
    pack_into("<f", wire, 36, NAN)  # full_charge_capacity: unknown (NaN)
    pack_into("<H", wire, 40, 65535)  # cycle_count: unknown (UINT16_MAX)
    pack_into("<H", wire, 42, 250)  # weight: 250 g
    wire[44] = instance  # id: the battery's number
    wire[45] = 1  # battery_function: MAV_BATTERY_FUNCTION_ALL
    wire[46] = 1  # type: MAV_BATTERY_TYPE_LIPO
    wire[47] = 255  # state_of_health: unknown (UINT8_MAX)
    wire[48] = 3  # cells_in_series: 3
    # manufacture_date: unknown ([0])
    # serial_number: unknown ([0])
    message.set("name", "generic_LiPo-3300")  # name: text
    return message


_battery_info = [_new_battery_info(instance) for instance in range(2)]


@micropython.native
def build_battery_info(state, instance=0):
    """Return BATTERY_INFO (372), FR-00076.2."""
    message = _battery_info[instance]
    wire = message.wire

    # design_capacity [Ah]: BATT_CAPACITY [mAh] (FR-00076.2)
    value = state.parameters.batt_capacity
    value = limited(value, 1, 1000000)
    put_float(wire, 32, value, 1000)
    return message


def _new_battery_cell_voltages(instance):
    message = messages.BatteryCellVoltages(live=("index", "voltages"), unknown=False)
    wire = message.wire
    pack_into("<H", wire, 0, instance)  # id: the battery's number
    return message


_battery_cell_voltages = [_new_battery_cell_voltages(instance) for instance in range(2)]


@micropython.native
def build_battery_cell_voltages(state, instance=0, page=0):
    """Return BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    message = _battery_cell_voltages[instance]
    live = message.live
    battery = state.battery[instance]
    battery.expire()

    # index: number of the first value on the page (FR-00076.7)
    live[0] = page * 12

    # voltages [mV]: battery.cells, a page of them (FR-00076.7)
    _fill_battery_cell_voltages_voltages(live, battery.cells_mv, page)
    return message


def _fill_battery_cell_voltages_voltages(live, values, page):
    for index in range(12):
        place = page * 12 + index
        value = values[place] if place < len(values) else None
        if value is None:
            value = 0  # unknown, or not there
        elif value < 1:
            value = 1
        elif value > 65535:
            value = 65535
        live[1 + index] = value
