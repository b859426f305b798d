# Generated from specs/messages/autopilot_version.yaml, specs/messages/battery_cell_voltages.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/protocol_version.yaml, specs/smart_battery/board.yaml,
#   specs/smart_battery/codegen.yaml, specs/smart_battery/messages/battery_info.yaml,
#   specs/smart_battery/messages/heartbeat.yaml,
#   specs/smart_battery/messages/smart_battery_info.yaml,
#   specs/smart_battery/parameters.yaml, specs/smart_battery/state.yaml, dialect common: do not edit.
# Inputs: 8591f96d2e77c6e6
"""Messages of the telemetry: for each what builds it, and what makes its frame for a link.

A builder returns the same message object at each call: send or encode it before the next one. An encoder goes from the
state to the whole frame at once; that is valid until the link's next one. Neither allocates.
"""

import time

import messages

try:
    from telemetry_viper import (
        TABLE_AT,
        each_encoder,
        encoder,
        write_autopilot_version,
        write_battery_cell_voltages,
        write_battery_info,
        write_battery_status,
        write_battery_status_v2,
        write_heartbeat,
        write_protocol_version,
        write_smart_battery_info,
    )
except (AttributeError, ImportError, SyntaxError, ValueError):  # as in frames
    from telemetry_plain import (
        TABLE_AT,
        each_encoder,
        encoder,
        write_autopilot_version,
        write_battery_cell_voltages,
        write_battery_info,
        write_battery_status,
        write_battery_status_v2,
        write_heartbeat,
        write_protocol_version,
        write_smart_battery_info,
    )


_heartbeat = messages.Heartbeat(unknown=False)


def build_heartbeat(state):
    """Return HEARTBEAT (0), FR-00074.1."""
    message = _heartbeat
    write_heartbeat(time.ticks_ms(), 0, message.wire, state.words)
    return message


encode_heartbeat = encoder(write_heartbeat, build_heartbeat)


_battery_status = [messages.BatteryStatus(unknown=False) for _ in range(1)]


def build_battery_status(state, instance=0):
    """Return BATTERY_STATUS (147), FR-00068.1."""
    message = _battery_status[instance]
    write_battery_status(time.ticks_ms(), 0, message.wire, state.words, instance)
    return message


encode_battery_status = each_encoder(write_battery_status, build_battery_status)


_autopilot_version = messages.AutopilotVersion(unknown=False)


def build_autopilot_version(state):
    """Return AUTOPILOT_VERSION (148), FR-00070.2."""
    message = _autopilot_version
    write_autopilot_version(time.ticks_ms(), 0, message.wire, state.words)
    return message


encode_autopilot_version = encoder(write_autopilot_version, build_autopilot_version)


_protocol_version = messages.ProtocolVersion(unknown=False)


def build_protocol_version(state):
    """Return PROTOCOL_VERSION (300), FR-00070.2."""
    message = _protocol_version
    write_protocol_version(time.ticks_ms(), 0, message.wire, state.words)
    return message


encode_protocol_version = encoder(write_protocol_version, build_protocol_version)


_battery_status_v2 = [messages.BatteryStatusV2(unknown=False) for _ in range(1)]


def build_battery_status_v2(state, instance=0):
    """Return BATTERY_STATUS_V2 (369), FR-00072.1."""
    message = _battery_status_v2[instance]
    write_battery_status_v2(time.ticks_ms(), 0, message.wire, state.words, instance)
    return message


encode_battery_status_v2 = each_encoder(write_battery_status_v2, build_battery_status_v2)


_smart_battery_info = [messages.SmartBatteryInfo(unknown=False) for _ in range(1)]


def build_smart_battery_info(state, instance=0):
    """Return SMART_BATTERY_INFO (370), FR-00074.4."""
    message = _smart_battery_info[instance]
    write_smart_battery_info(time.ticks_ms(), 0, message.wire, state.words, instance, state.parameters.batt_capacity)
    return message


def encode_smart_battery_info(link, state, instance=0):
    """Return the frame of SMART_BATTERY_INFO (370), FR-00074.4."""
    if TABLE_AT:
        length = write_smart_battery_info(
            time.ticks_ms(), TABLE_AT, link.room, state.words, instance, state.parameters.batt_capacity
        )
        if length:
            return link.views[length]
    return link.encode(build_smart_battery_info(state, instance))


_battery_info = [messages.BatteryInfo(unknown=False) for _ in range(1)]


def build_battery_info(state, instance=0):
    """Return BATTERY_INFO (372), FR-00074.4."""
    message = _battery_info[instance]
    write_battery_info(time.ticks_ms(), 0, message.wire, state.words, instance, state.parameters.batt_capacity)
    return message


def encode_battery_info(link, state, instance=0):
    """Return the frame of BATTERY_INFO (372), FR-00074.4."""
    if TABLE_AT:
        length = write_battery_info(
            time.ticks_ms(), TABLE_AT, link.room, state.words, instance, state.parameters.batt_capacity
        )
        if length:
            return link.views[length]
    return link.encode(build_battery_info(state, instance))


_battery_cell_voltages = [messages.BatteryCellVoltages(unknown=False) for _ in range(1)]


def build_battery_cell_voltages(state, instance=0, page=0):
    """Return BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    message = _battery_cell_voltages[instance]
    write_battery_cell_voltages(time.ticks_ms(), 0, message.wire, state.words, instance, page)
    return message


def encode_battery_cell_voltages(link, state, instance=0, page=0):
    """Return the frame of BATTERY_CELL_VOLTAGES (54371), FR-00076.7."""
    if TABLE_AT:
        length = write_battery_cell_voltages(time.ticks_ms(), TABLE_AT, link.room, state.words, instance, page)
        if length:
            return link.views[length]
    return link.encode(build_battery_cell_voltages(state, instance, page))
