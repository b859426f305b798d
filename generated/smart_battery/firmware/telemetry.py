# Generated from specs/messages/autopilot_version.yaml, specs/messages/battery_cell_voltages.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/protocol_version.yaml, specs/smart_battery/board.yaml,
#   specs/smart_battery/codegen.yaml, specs/smart_battery/messages/battery_info.yaml,
#   specs/smart_battery/messages/heartbeat.yaml,
#   specs/smart_battery/messages/smart_battery_info.yaml,
#   specs/smart_battery/parameters.yaml, specs/smart_battery/state.yaml, dialect common: do not edit.
# Inputs: 7a1d6afeb34ea4bf
"""Messages of the telemetry: for each what builds it, and what makes its frame for a link.

A builder returns the same message object at each call: send or encode it before the next one. An encoder goes from the
state to the whole frame at once; that is valid until the link's next one. Neither allocates. Both take the first
instance and the first page where they are not told another one, counted from 0. What is called `..._frame` is an
encoder that has to be told: machine code has no default arguments, and the streams can do without the call between.
"""
# ruff: noqa: F401  this is where they are imported from

try:
    from telemetry_viper import (
        battery_cell_voltages_frame,
        battery_info_frame,
        battery_status_frame,
        battery_status_v2_frame,
        build_autopilot_version,
        build_battery_cell_voltages,
        build_battery_info,
        build_battery_status,
        build_battery_status_v2,
        build_heartbeat,
        build_protocol_version,
        build_smart_battery_info,
        encode_autopilot_version,
        encode_battery_cell_voltages,
        encode_battery_info,
        encode_battery_status,
        encode_battery_status_v2,
        encode_heartbeat,
        encode_protocol_version,
        encode_smart_battery_info,
        smart_battery_info_frame,
    )
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from telemetry_plain import (
        battery_cell_voltages_frame,
        battery_info_frame,
        battery_status_frame,
        battery_status_v2_frame,
        build_autopilot_version,
        build_battery_cell_voltages,
        build_battery_info,
        build_battery_status,
        build_battery_status_v2,
        build_heartbeat,
        build_protocol_version,
        build_smart_battery_info,
        encode_autopilot_version,
        encode_battery_cell_voltages,
        encode_battery_info,
        encode_battery_status,
        encode_battery_status_v2,
        encode_heartbeat,
        encode_protocol_version,
        encode_smart_battery_info,
        smart_battery_info_frame,
    )
