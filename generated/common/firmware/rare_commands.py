# Generated from templates/firmware/program/rare_commands.py, dialect common: do not edit.
# Inputs: cf32ca8430b9bf1a
"""Commands that few ask for; commands.py loads this module with the first of them."""

from struct import pack_into

import messages
import parameters
from micropython import const

# Numbers of the dialect.
_MAV_CMD_PREFLIGHT_STORAGE = const(245)
_MAV_RESULT_ACCEPTED = const(0)
_MAV_RESULT_DENIED = const(2)
_MAV_RESULT_FAILED = const(4)
_MAV_RESULT_TEMPORARILY_REJECTED = const(1)
_MAV_RESULT_UNSUPPORTED = const(3)
_MAV_SEVERITY_ERROR = const(3)
_MESSAGE_INTERVAL_INTERVAL_US_AT = const(0)
_MESSAGE_INTERVAL_MESSAGE_ID_AT = const(4)

_WRITE = const(1)  # of MAV_CMD_PREFLIGHT_STORAGE
_DEFAULTS = const(2)
_LARGEST_US = const(0x7FFFFFFF)  # 36 minutes: MESSAGE_INTERVAL carries no more, and anything below 0 says never


def do(vehicle, command):
    """Do a command and return its MAV_RESULT."""
    is_storage = command.number == _MAV_CMD_PREFLIGHT_STORAGE
    return _store(vehicle, command.whole(1, 0, 0xFF)) if is_storage else _check(vehicle)


def interval_of(connection, command, number):
    """Answer with the interval of the message that a parameter names, 0 if the vehicle does not have it."""
    message_id = command.whole(number, 0, 0xFFFF)  # MESSAGE_INTERVAL carries no more
    if message_id is None:
        return _MAV_RESULT_DENIED, None
    return _MAV_RESULT_ACCEPTED, (_send_interval, (connection, message_id))


def _send_interval(asked):
    connection, message_id = asked
    answer = messages.MessageInterval(unknown=False)  # kept, it would take more of the heap than it is worth
    interval_us = min(connection.streams.interval_us(message_id), _LARGEST_US)
    pack_into("<i", answer.wire, _MESSAGE_INTERVAL_INTERVAL_US_AT, interval_us)
    pack_into("<H", answer.wire, _MESSAGE_INTERVAL_MESSAGE_ID_AT, message_id)
    return connection.send(answer)


def _store(vehicle, action):
    """Give all parameters their defaults; those that are in force are written at any rate, as soon as that may be."""
    if action is None:
        return _MAV_RESULT_DENIED
    if action == _WRITE:
        return _MAV_RESULT_ACCEPTED
    if action != _DEFAULTS:
        return _MAV_RESULT_UNSUPPORTED
    if vehicle.restart_ms is not None:
        return _MAV_RESULT_TEMPORARILY_REJECTED
    if getattr(vehicle, "is_armed", False):  # not every vehicle can be armed
        vehicle.texts.say(_MAV_SEVERITY_ERROR, "Defaults: disarm first")
        return _MAV_RESULT_FAILED
    own, fresh = vehicle.parameters, parameters.Parameters()
    for name in own.names():
        own.set(name, fresh.get(name))
    vehicle.texts("notice: all parameters have their defaults")
    return _MAV_RESULT_ACCEPTED


def _check(vehicle):
    """Let what speaks against arming be said within a second, and what else stands."""
    if vehicle.is_armed:
        return _MAV_RESULT_TEMPORARILY_REJECTED
    vehicle.remind()
    return _MAV_RESULT_ACCEPTED
